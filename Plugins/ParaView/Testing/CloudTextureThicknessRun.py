# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that CloudTextureThicknessRanks.py compares.

Usage: CloudTextureThicknessRun.py PREFIX [PORT NAMES [MEGABYTES]]; with a port it draws on a pvserver there, and all there, however small the data are;
data of fewer MEGABYTES are drawn here.
"""
import sys

import numpy as np
from CloudTextureScenes import CLOUDS
from PluginTesting import clear, empty_view, image, load_plugin, look, new_view, passed, pvs, render, solid, wanted

SIZE = (120, 120)
FAR = (30, 20, 35)


def show(view, source, **settings):
    display = pvs.Show(source, view)
    solid(display, [1, 1, 1])
    display.SetRepresentationType(CLOUDS)
    display.CloudTextureUseThickness = 1
    for name, value in settings.items():
        setattr(display, name if hasattr(display, name) else "CloudTexture" + name, value)
    return display


def keep(name, picture):
    np.save(f"{sys.argv[1]}-{name}.npy", picture)


def draw(name, source, position=(9, 4, 12), **settings):
    if not wanted(name):
        return
    view = empty_view(SIZE)
    show(view, source, **settings)
    look(view, position)
    keep(name, image(view))
    clear(view)


def ball(x=0.0, y=0.0, z=0.0, radius=1.0):
    return pvs.Sphere(Center=[x, y, z], Radius=radius, ThetaResolution=40, PhiResolution=40)


def row():
    """Balls behind one another, in blocks, some of which meet."""
    return pvs.GroupDatasets(Input=[ball(1.5 * x, 0.3 * x, 0.7 * z) for x in range(-2, 3) for z in (-1.2, 1.2)])


def wavelet():
    return pvs.Wavelet(WholeExtent=[-8, 8] * 3)


def surface_of(grid, value=150.0):
    return pvs.Contour(Input=grid, ContourBy=["POINTS", "RTData"], Isosurfaces=[value])


def water(grid):
    return pvs.Calculator(Input=grid, ResultArrayName="Water", Function="0.02 + 0.02*cos(coordsX)^2 + 0.004*coordsY^2")


def draw_volumes():
    """Grids of several kinds as the density in space."""
    image_of_water = water(wavelet())
    turned = pvs.Transform(Input=wavelet())
    turned.Transform.Rotate = [0, 0, 20]  # without a turn it would remain an image
    grid = water(turned)
    surface = surface_of(image_of_water)
    draw("cell density", surface, FAR, DensityVolume=pvs.PointDatatoCellData(Input=image_of_water), DensityArrayName="Water", Extinction=3)
    for name, volume in (("image", image_of_water), ("structured", grid), ("unstructured", pvs.AppendDatasets(Input=[grid])),
                         ("blocks volume", pvs.GroupDatasets(Input=[grid]))):
        draw(name, surface_of(volume), FAR, DensityVolume=volume, DensityArrayName="Water", Extinction=3)


def draw_in_air():
    """In haze that lies before the background too, and in the light of a sun."""
    for name, source in (("haze", pvs.Haze), ("sun", lambda: pvs.Sun(SunDirection=[1, 2, 0.5]))):
        if wanted(name):
            view = new_view(SIZE)
            show(view, row(), Extinction=0.5)
            display = pvs.Show(source(), view)
            if name == "haze":
                display.Projection, display.UpDirection, display.VisualRange, display.ScaleHeight, display.HazeBackground = "Map", [0, 1, 0], 30, 20, 1
            look(view, (9, 4, 12))
            keep(name, image(view))
            pvs.Delete(view)


def draw_moving():
    """After a frame as while the mouse moves the camera, and that frame."""
    for name, in_motion in (("moving", 0), ("in motion", 1)):
        if wanted(name):
            view = new_view(SIZE)
            show(view, row(), Extinction=0.5)
            look(view, (-9, 4, 12))
            view.LODThreshold = 0
            render(view)
            look(view, (9, 4, 12))
            view.SMProxy.InteractiveRender()
            view.ImageReductionFactor = 1  # else every second pixel on several ranks
            view.UseInteractiveRenderingForScreenshots = in_motion
            keep(name, image(view))
            pvs.Delete(view)


def draw_turned():
    """Turned by its display: ranks draw in regions of space, not of the data."""
    if wanted("turned"):
        view = new_view(SIZE)
        show(view, row(), Extinction=0.5, Orientation=[30, 50, 10], Position=[0, 1, 0], Scale=[1, 2, 1])
        for x in (-14, 14):  # the clipping range of the view, which ParaView takes from data that are not turned, has room
            pvs.Show(pvs.Box(Center=[x, -x, x], XLength=0.1, YLength=0.1, ZLength=0.1), view)
        look(view, (15, 10, 17))
        keep("turned", image(view))
        pvs.Delete(view)


if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
    pvs.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = float(sys.argv[4]) if len(sys.argv) > 4 else 0
load_plugin()
pvs._DisableFirstRenderCameraReset()  # whichever picture is the first
draw("ball", ball(radius=3))
draw("thin ball", ball(radius=3), Extinction=0.3, Coverage=1)
draw("row", row(), Extinction=0.5)
draw("row from behind", row(), (-9, 4, -12), Extinction=0.5)
draw("row without thickness", row(), UseThickness=0)
draw("added", row(), ThicknessEffect="Is Added To Texture", Coverage=0.1)
draw("rough", row(), Extinction=0.5, Relief=0.3)
draw("clipped", pvs.ExtractSurface(Input=pvs.Clip(Input=row(), ClipType="Plane")), Extinction=0.5)
draw("cut cells", pvs.Clip(Input=pvs.CleantoGrid(Input=wavelet()), ClipType="Plane"), FAR, Extinction=0.1)
draw("linear density", pvs.Calculator(Input=row(), ResultArrayName="Water", Function="2 + coordsX^2"), DensityArrayName="Water", Extinction=0.1)
draw("contour", surface_of(wavelet()), FAR)
draw("hexahedra", pvs.CleantoGrid(Input=wavelet()), FAR, Extinction=0.1)
top = pvs.Threshold(Input=pvs.Elevation(Input=pvs.RedistributeDataSet(Input=pvs.CleantoGrid(Input=wavelet())), LowPoint=[0, 0, -8], HighPoint=[0, 0, 8]),
                    Scalars=["POINTS", "Elevation"], LowerThreshold=0.8, UpperThreshold=1.0)
draw("on few ranks", top, FAR, Extinction=0.3)
draw_volumes()
draw_in_air()
draw_moving()
draw_turned()
passed()
