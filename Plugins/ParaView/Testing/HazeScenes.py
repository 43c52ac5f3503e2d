# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A view of opaque and translucent surfaces and of cells, from near to far, and its haze."""
from PluginTesting import new_view, pvs, set_background, solid

REACH = 40.0  # visual range


def show(source, view, color, representation="Surface", opacity=1.0):
    display = pvs.Show(source, view)
    display.SetRepresentationType(representation)
    if representation == "Surface":
        solid(display, color)
        display.Opacity = opacity
        display.Ambient, display.Diffuse = 1.0, 0.0
    return display


def make_view(medium=True):
    """Ground and balls (opaque), a sheet (translucent), and a medium of cells among them; heights are y."""
    view = new_view((120, 90))
    ground = pvs.Plane(Origin=[-30, 0, 10], Point1=[30, 0, 10], Point2=[-30, 0, -60], XResolution=20, YResolution=20)
    show(ground, view, [0.2, 0.5, 0.1])
    for k in range(4):
        show(pvs.Sphere(Center=[6 * k - 9, 2, 2 - 10 * k], Radius=2, ThetaResolution=40, PhiResolution=40), view, [0.8, 0.2, 0.1])
    sheet = pvs.Plane(Origin=[-4, 0.5, -5], Point1=[4, 0.5, -5], Point2=[-4, 5, -5], XResolution=10, YResolution=10)
    show(sheet, view, [0.9, 0.9, 0.2], opacity=0.5)
    if medium:
        wavelet = pvs.Wavelet(WholeExtent=[-4, 4, -3, 3, -4, 4])
        place = pvs.Transform(Input=wavelet)
        place.Transform.Translate = [8.0, 4.0, -14.0]
        pvs.UpdatePipeline(proxy=place)
        display = pvs.Show(place, view)
        pvs.ColorBy(display, ("POINTS", "RTData"))
        display.SetRepresentationType("Cell Compositing")
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, 6, 18], [0, 3, -10], [0, 1, 0]
    view.CameraViewAngle = 50
    set_background(view, (0.05, 0.1, 0.3))
    return view


def add_haze(view, background=True):
    haze = pvs.Haze()
    display = pvs.Show(haze, view)
    display.Projection = "Map"
    display.UpDirection = [0, 1, 0]
    display.VisualRange, display.ScaleHeight = REACH, 4.0
    display.HazeBackground = int(background)
    return haze, display
