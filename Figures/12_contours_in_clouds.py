# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 12: the jet streams as nested translucent surfaces of equal wind speed, in the clouds of the same forecast.

After section 2 of Max, Crawfis and Becker (1993): contour surfaces composited with the cells in one order. No surface is made as
geometry. A map in plate carree, heights exaggerated 130 times; clouds are coloured by altitude. Writes the picture (1920 x 1080) and
the ParaView state that shows it again.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import globe_scene  # noqa: E402

DEGREE = globe_scene.PLANET_RADIUS * 3.14159265358979 / 180
EXAGGERATION = 130
SPEEDS = [30.0, 42.0, 54.0]  # m/s
SPEED_COLOURS = [1.00, 0.93, 0.70, 1.00, 0.58, 0.16, 0.92, 0.10, 0.26]
SPEED_OPACITIES = [0.2, 0.45, 0.9]
CLOUD_COLOURS = [0, 0.72, 0.80, 0.92, 16000, 1.0, 1.0, 1.0]
# Cloud fraction: value, opacity, midpoint, sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.2, 0.0, 0.5, 0.0, 0.6, 0.3, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
UNIT_DISTANCE = 5.0e5  # metres over which opacity 1 gives optical depth 1


def show_terrain(view):
    half = [180 * DEGREE, 90 * DEGREE]
    plane = pvs.Plane(Origin=[-half[0], -half[1], 0], Point1=[half[0], -half[1], 0], Point2=[-half[0], half[1], 0])
    pvs.RenameSource("Terrain", plane)
    shown = pvs.Show(plane, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.Texture = globe_scene.load_texture(os.path.join(globe_scene.DATA, "blue_marble_2048.jpg"))
    shown.Ambient, shown.Diffuse = 0.4, 0.45


def show_jets(clouds):
    """Contour surfaces inside the cells of what is shown."""
    clouds.CellCompositingContourArray = "Wind"  # the magnitude of a vector
    clouds.CellCompositingContourValues = SPEEDS
    clouds.CellCompositingContourColors = SPEED_COLOURS
    clouds.CellCompositingContourOpacities = SPEED_OPACITIES
    clouds.Ambient, clouds.Diffuse, clouds.Specular, clouds.SpecularPower = 0.1, 0.7, 0.2, 10


def show_caption(view):
    text = "GFS forecast for 2011-10-11 00 UTC, heights exaggerated %d times\nWind speed %s m/s" % (
        EXAGGERATION, ", ".join("%g" % s for s in SPEEDS))
    shown = pvs.Show(pvs.Text(Text=text), view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Upper Left Corner", 18, "Left"
    shown.Color = [0.75, 0.80, 0.88]


pvs._DisableFirstRenderCameraReset()
view = globe_scene.make_view(
    "Contours in clouds", position=[4 * DEGREE, -140 * DEGREE, 92 * DEGREE], focus=[42 * DEGREE, -24 * DEGREE, 0], up=[0, 0, 1],
    angle=42, sun=[-60 * DEGREE, -150 * DEGREE, 190 * DEGREE], background=([0.008, 0.012, 0.03], [0.05, 0.09, 0.17]),
    sunshine=1.15)
show_terrain(view)
forecast = globe_scene.read_forecast(EXAGGERATION, "Clouds and winds", Projection="Map", UseCentralMeridian=1)  # Greenwich
show_jets(globe_scene.show_clouds(forecast, view, CLOUD_OPACITY, UNIT_DISTANCE, "Height", CLOUD_COLOURS)[0])
show_caption(view)
globe_scene.save("12_contours_in_clouds", view)
