# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 4: clouds over North America, drawn as textured splats.

After figure 4 of Max, Crawfis and Becker (1993). Every sample of the forecast's cloud fraction is one splat in the shape of its
grid cell. Colour is the altitude. Heights are exaggerated 30 times. Writes the picture (1920 x 1080) and the ParaView state that
shows it again.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import globe_scene  # noqa: E402
import splat_clouds  # noqa: E402

pvs._DisableFirstRenderCameraReset()
view = splat_clouds.view_of_north_america("Splatted clouds")
forecast = globe_scene.read_forecast(splat_clouds.EXAGGERATION)
shown = splat_clouds.show_clouds(forecast, view, "height")
splat_clouds.altitude_bar(view, shown.LookupTable)
splat_clouds.caption(view, "GFS forecast for 2011-10-11 00 UTC\nClouds coloured by altitude")
globe_scene.save("04_splatted_clouds", view)
