# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 1: clouds of a weather forecast wrapped around the globe, coloured by altitude, over Blue Marble, and over terrain.

After figure 1 of Max, Crawfis and Becker (1993). Heights are exaggerated 45 times. Opacity comes from the cloud fraction,
colour from the height; the terrain of the second picture is as high as in the forecast model, exaggerated alike, and has colours of its own.
Writes the pictures (1920 x 1080) and the ParaView states that show them again.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import globe_scene  # noqa: E402
import pictures  # noqa: E402

EXAGGERATION = 45
# Height in metres: warm below, white in the middle, cold above.
ALTITUDE_COLOURS = [
    0, 0.96, 0.46, 0.16,
    2000, 1.00, 0.72, 0.38,
    4500, 1.00, 0.93, 0.80,
    7500, 0.98, 0.98, 0.98,
    11000, 0.80, 0.89, 1.00,
    15000, 0.45, 0.64, 1.00,
]
# Cloud fraction: little below a quarter, everything above four fifths. Value, opacity, and ParaView's midpoint and sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.12, 0.0, 0.5, 0.0, 0.45, 0.35, 0.5, 0.0, 0.8, 1.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
TEXT_COLOUR = [0.75, 0.80, 0.88]
UNIT_DISTANCE = 2.2e5  # metres over which opacity 1 gives optical depth 1


def show_legend(view, colours, title, height, labels):
    bar = pvs.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.Visibility = 1
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = [0.9, height], 0.36, 14
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.UseCustomLabels, bar.CustomLabels = 1, labels
    bar.AddRangeLabels, bar.AutomaticLabelFormat, bar.LabelFormat = 0, 0, pictures.whole_number_format(bar.LabelFormat)
    bar.TitleColor = bar.LabelColor = TEXT_COLOUR


def show_caption(view):
    caption = pvs.Text(Text="GFS forecast for 2011-10-11 00 UTC\nHeights exaggerated %d times" % EXAGGERATION)
    shown = pvs.Show(caption, view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Lower Left Corner", 18, "Left"
    shown.Color = TEXT_COLOUR


pvs._DisableFirstRenderCameraReset()
view = globe_scene.make_view(
    "Clouds over the globe", position=globe_scene.on_globe(-108, 16, 3.3),  # over the eastern Pacific, where two hurricanes are
    focus=[0, 0, 0], up=[0, 0, 1], angle=40, sun=globe_scene.on_globe(-92, 32, 10))
photograph = globe_scene.show_terrain(view, ambient=0.35, diffuse=0.9)
forecast = globe_scene.read_forecast(EXAGGERATION, "Clouds")
clouds = globe_scene.show_clouds(forecast, view, CLOUD_OPACITY, UNIT_DISTANCE, "Height", ALTITUDE_COLOURS)[1]
show_legend(view, clouds, "Clouds (m)", 0.52, [0, 5000, 10000, 15000])
show_caption(view)
globe_scene.save("01_clouds_over_globe", view)
photograph.Visibility = 0
ground = globe_scene.show_ground(view, EXAGGERATION, ambient=0.35, diffuse=0.9)
show_legend(view, ground.LookupTable, "Ground (m)", 0.12, [0, 2000, 4000, 6000])
globe_scene.save("01_terrain_under_clouds", view)
