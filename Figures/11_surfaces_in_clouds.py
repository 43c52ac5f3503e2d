# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 11: the jet streams among the clouds of a weather forecast.

Two translucent surfaces, one inside the other, stand in the volume: surfaces of equal wind speed. Clouds in front of a surface
veil it, clouds inside and behind it are tinted, at every pixel in the right order. Heights are exaggerated 45 times. Writes the
picture (1920 x 1080) and the ParaView state that shows it again.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import globe_scene  # noqa: E402

EXAGGERATION = 45
# Wind speed (m/s), colour, opacity
JETS = ((30.0, [1.0, 0.72, 0.20], 0.30), (50.0, [1.0, 0.27, 0.18], 0.65))
# Cloud fraction: little below a quarter, everything above four fifths. Value, opacity, and ParaView's midpoint and sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.15, 0.0, 0.5, 0.0, 0.5, 0.3, 0.5, 0.0, 0.85, 1.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
CLOUD_COLOURS = [0.0, 0.80, 0.83, 0.88, 1.0, 1.0, 1.0, 1.0]
UNIT_DISTANCE = 3.5e5  # metres over which opacity 1 gives optical depth 1


def show_jets(forecast, view):
    """Translucent contour surfaces, lit."""
    wind = pvs.Calculator(Input=forecast, ResultArrayName="Wind speed", Function="mag(Wind)")
    for speed, colour, opacity in JETS:
        surface = pvs.Contour(Input=wind, ContourBy=["POINTS", "Wind speed"], Isosurfaces=[speed], ComputeNormals=1)
        pvs.RenameSource("Wind of %.0f metres per second" % speed, surface)
        shown = pvs.Show(surface, view)
        shown.Representation = "Surface"
        shown.ColorArrayName = ["POINTS", ""]
        shown.DiffuseColor = shown.AmbientColor = colour
        shown.Opacity = opacity
        shown.Ambient, shown.Diffuse, shown.Specular, shown.SpecularPower = 0.3, 0.75, 0.25, 25


def show_caption(view):
    lines = [("GFS forecast for 2011-10-11 00 UTC, clouds in white\nHeights exaggerated %d times" % EXAGGERATION,
              [0.012, 0.915], [0.75, 0.80, 0.88])]
    lines += [("Wind of %.0f m/s and more inside" % speed, [0.012, 0.87 - 0.035 * i], colour)
              for i, (speed, colour, _) in enumerate(JETS)]
    for text, place, colour in lines:
        shown = pvs.Show(pvs.Text(Text=text), view)
        shown.WindowLocation, shown.Position = "Any Location", place
        shown.FontSize, shown.Justification, shown.Color = 18, "Left", colour


pvs._DisableFirstRenderCameraReset()
view = globe_scene.make_view(
    "Surfaces in clouds", position=globe_scene.on_globe(-24, 28, 2.3),  # over the Atlantic; the strongest jet blows past Scotland
    focus=globe_scene.on_globe(-14, 47, 0.86), up=globe_scene.on_globe(-12, 89), angle=36, sun=globe_scene.on_globe(-60, 32, 10))
globe_scene.show_terrain(view, ambient=0.45, diffuse=0.8)
forecast = globe_scene.read_forecast(EXAGGERATION)
globe_scene.show_clouds(forecast, view, CLOUD_OPACITY, UNIT_DISTANCE, "cloud_fraction", CLOUD_COLOURS)
show_jets(forecast, view)
show_caption(view)
globe_scene.save("11_surfaces_in_clouds", view)
