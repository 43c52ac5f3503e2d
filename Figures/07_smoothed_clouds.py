# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7: the surface of figure 6 smoothed once by the 3 x 3 x 3 filter.

After figure 7 of Max, Crawfis and Becker (1993). Writes the picture and the ParaView state that shows it again.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import cloud_surface_scene  # noqa: E402

cloud_surface_scene.picture("07_smoothed_clouds", "Smoothed clouds", "15 % cloud cover, smoothed once", iterations=1)
