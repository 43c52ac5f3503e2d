# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8: the smoothed surface of 15 % cloud cover with a texture of broken cloud, which the wind has moved.

After figure 8 of Max, Crawfis and Becker (1993). Uses the time series of `./nephoscope forecast` (NEPHOSCOPE_FORECAST). Writes the
picture (1920 x 1080).
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import moving_clouds  # noqa: E402
import pictures  # noqa: E402

HOUR = 12

window, renderer, clouds = moving_clouds.scene((1920, 1080), os.environ["NEPHOSCOPE_FORECAST"])
clouds.update(HOUR)
moving_clouds.add_caption(renderer, "Textured clouds after %d hours in the wind" % HOUR)
window.Render()
pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "08_textured_clouds.png"))
