# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures of splatted clouds over North America share."""
from paraview import simple as pvs

import globe_scene
import pictures

EXAGGERATION = 30
# Cloud fraction: little below 40 %, everything above 85 %. Value, opacity, ParaView's midpoint and sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.25, 0.0, 0.5, 0.0, 0.45, 0.12, 0.5, 0.0, 0.85, 1.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
WHITE = [0.0, 0.86, 0.88, 0.92, 1.0, 1.0, 1.0, 1.0]
ALTITUDE_COLOURS = [0, 1.0, 0.62, 0.30, 2500, 1.0, 0.83, 0.60, 5500, 1.0, 0.97, 0.93, 9000, 0.97, 0.98, 1.0, 14000, 0.72, 0.84, 1.0]
UNIT_DISTANCE = 1.0e5  # metres over which opacity 1 gives optical depth 1


def view_of_north_america(name):
    return globe_scene.make_view(
        name, position=globe_scene.on_globe(-97, 26, 2.6), focus=globe_scene.on_globe(-98, 40, 0.95),
        up=globe_scene.on_globe(-98, 89), angle=30, sun=globe_scene.on_globe(-130, 25, 10))


def show_clouds(forecast, view, colour):
    """`colour`: "height", or "white"."""
    globe_scene.show_terrain(view, ambient=0.5, diffuse=0.75)
    array, colours = ("Height", ALTITUDE_COLOURS) if colour == "height" else ("cloud_fraction", WHITE)
    return globe_scene.show_clouds(forecast, view, CLOUD_OPACITY, UNIT_DISTANCE, array, colours, "Textured Splats")[0]


def caption(view, text, place=(0.012, 0.935), colour=(0.78, 0.83, 0.90)):
    shown = pvs.Show(pvs.Text(Text=text + "\nHeights exaggerated %d times" % EXAGGERATION), view)
    shown.WindowLocation, shown.Position = "Any Location", list(place)
    shown.FontSize, shown.Justification, shown.Color = 18, "Left", list(colour)


def altitude_bar(view, table):
    bar = pvs.GetScalarBar(table, view)
    bar.Visibility = 1
    bar.Title, bar.ComponentTitle = "Altitude (m)", ""
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.925, 0.70], 0.22
    bar.TitleFontSize = bar.LabelFontSize = 16
    bar.TitleColor = bar.LabelColor = [0.78, 0.83, 0.90]
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = pictures.whole_number_format(bar.LabelFormat)
