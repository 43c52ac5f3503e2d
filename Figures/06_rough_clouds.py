# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6: the surface of 15 % cloud cover of a forecast as the model has it, before it is smoothed and textured.

After figure 6 of Max, Crawfis and Becker (1993). Writes the picture and the ParaView state that shows it again.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import cloud_surface_scene  # noqa: E402

cloud_surface_scene.picture("06_rough_clouds", "Rough clouds", "15 % cloud cover as the model has it", iterations=0)
