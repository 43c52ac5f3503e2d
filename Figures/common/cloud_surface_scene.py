# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What figures 6, 7 and 8 share: one view, low over the ocean, and the surface of 15 % cloud cover of one analysis in it. The figures
differ in the smoothing and in how the surface is drawn, in nothing else."""
from paraview import simple as pvs

import globe_scene

EXAGGERATION = 20
COVER = 0.15
TOP = 15000  # metres, between the two highest levels
SIZE = (1920, 1080)
VISIBILITY = 4e6  # metres of level air at the ground that leave 2 % of the contrast


def make_view(name):
    """From the south over the eastern Pacific, two hurricanes in the middle and North America behind, the sun in the west."""
    return globe_scene.make_view(
        name, position=globe_scene.on_globe(-118, -12, 2.6), focus=globe_scene.on_globe(-110, 6, 0.9),
        up=globe_scene.on_globe(-110, 15), angle=31, sun=globe_scene.on_globe(-150, 34, 10), size=SIZE)


def cloud_surface(grid, iterations):
    """Closed above: the smoothed clouds end below the highest level, 100 hPa."""
    smooth = pvs.StructuredSmoothing(Input=grid, SmoothArray=["POINTS", "cloud_fraction"], NumberOfIterations=iterations)
    closed = pvs.Calculator(Input=smooth, ResultArrayName="cloud_fraction", Function=f"cloud_fraction*(Height < {TOP})")
    surface = pvs.CloudSurface(Input=closed, NumberOfSmoothingIterations=0)
    surface.ContourBy = ["POINTS", "cloud_fraction"]
    surface.ContourValues = [COVER]
    return surface


def show_surface(surface, view):
    shown = pvs.Show(surface, view)
    shown.SetRepresentationType("Surface")
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = shown.AmbientColor = [0.96, 0.97, 1.0]
    shown.Ambient, shown.Diffuse, shown.Specular = 0.2, 0.78, 0.0
    return shown


def show_caption(view, text):
    caption = pvs.Text(Text="%s\nGFS forecast for 2011-10-11 00 UTC. Heights exaggerated %d times" % (text, EXAGGERATION))
    shown = pvs.Show(caption, view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Upper Left Corner", 18, "Left"
    shown.Color = [0.85, 0.89, 0.95]
    return caption


def show_haze(view):
    haze = pvs.Haze()
    shown = pvs.Show(haze, view)
    shown.VerticalExaggeration, shown.VisualRange = EXAGGERATION, VISIBILITY
    return shown


def picture(name, title, caption, iterations, show=show_surface):
    pvs._DisableFirstRenderCameraReset()
    view = make_view(title)
    globe_scene.show_terrain(view, ambient=0.5, diffuse=1.0)
    show(cloud_surface(globe_scene.read_forecast(EXAGGERATION), iterations), view)
    show_caption(view, caption)
    show_haze(view)
    globe_scene.save(name, view, SIZE)
