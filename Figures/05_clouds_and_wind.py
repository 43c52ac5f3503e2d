# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5: clouds and wind together over North America, in the same splats.

After figure 5 of Max, Crawfis and Becker (1993). Clouds are white; the wind is drawn in the middle of every splat, in the colour of
its altitude, as comets that fly with it, so that clouds and wind partly hide each other. Four of the 21
levels are drawn. Writes the picture (1920 x 1080) and the ParaView state that shows it again.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import globe_scene  # noqa: E402
import splat_clouds  # noqa: E402

# Metres, colour: warm below, cold above, all of them strong enough for white clouds and dark seas.
WIND_COLOURS = [0, 1.0, 0.45, 0.10, 3000, 1.0, 0.80, 0.15, 6500, 0.45, 0.90, 0.35, 10000, 0.15, 0.75, 1.0, 15000, 0.75, 0.45, 1.0]

pvs._DisableFirstRenderCameraReset()
view = splat_clouds.view_of_north_america("Clouds and wind")
forecast = globe_scene.read_forecast(splat_clouds.EXAGGERATION)
levels = pvs.ExtractSubset(Input=forecast, VOI=[0, 144, 0, 72, 2, 17], SampleRateI=1, SampleRateJ=1, SampleRateK=5)
pvs.RenameSource("Four levels", levels)
shown = splat_clouds.show_clouds(levels, view, "white")
shown.TexturedSplatsVectorArray = "Wind"
shown.TexturedSplatsVectorColorArray = "Height"
altitudes = globe_scene.colour_table("Height", WIND_COLOURS)
shown.TexturedSplatsVectorLookupTable = altitudes
shown.TexturedSplatsVectorOpacity = 4
shown.TexturedSplatsVectorShare = 1  # the view shows a small part of the globe
shown.TexturedSplatsGreatestSpeed = 40
shown.TexturedSplatsStreakWidth = 0.08
splat_clouds.altitude_bar(view, altitudes)
splat_clouds.caption(view, "GFS forecast for 2011-10-11 00 UTC\nClouds, and wind coloured by altitude")
globe_scene.save("05_clouds_and_wind", view)
