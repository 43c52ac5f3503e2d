# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 17: the clouds of a weather forecast over North America, without haze and with it.

Clouds are drawn cell by cell, the ground is a surface, the background is the sky: one vtkHaze is before all of them. Heights, and with them the
scale height of the haze, are exaggerated 20 times. Writes the picture (1920 x 960).
"""
import os
import sys

import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import nephoscope  # noqa: E402
import pictures  # noqa: E402
import vtk_globe  # noqa: E402
from globe_scene import NIGHT, on_globe  # noqa: E402

EXAGGERATION = 20
SIZE = (1920, 960)
VISIBILITY = 4e6      # metres of level air at the ground that leave 2 % of the contrast
UNIT_DISTANCE = 7e4  # metres over which a cloud of opacity 1 has an optical depth of 1


def clouds(grid):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputConnection(grid.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    volume = vtkVolume()
    volume.SetMapper(mapper)
    colour, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for cover, white in ((0.0, 0.80), (1.0, 1.0)):
        colour.AddRGBPoint(cover, white, white, white)
    for cover, share in ((0.0, 0.0), (0.15, 0.0), (0.5, 0.25), (0.85, 1.0), (1.0, 1.0)):
        opacity.AddPoint(cover, share)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(UNIT_DISTANCE)
    return volume


def panel(window, grid, left, caption):
    renderer = vtkRenderer()
    renderer.SetViewport(left, 0, left + 0.5, 1)
    renderer.SetBackground(NIGHT[0])
    renderer.SetBackground2(NIGHT[1])
    renderer.GradientBackgroundOn()
    window.AddRenderer(renderer)
    renderer.AddActor(vtk_globe.terrain(ambient=0.45, diffuse=1.0))
    renderer.AddVolume(clouds(grid))
    renderer.AddActor(vtk_globe.text(caption, (24, SIZE[1] - 48), 24))
    renderer.AutomaticLightCreationOff()
    vtk_globe.add_sun(renderer, on_globe(-135, 15, 10))
    vtk_globe.look(renderer, eye=on_globe(-126, 22, height=2.6e6), focus=on_globe(-107, 33), up=on_globe(-126, 22), angle=42)
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    window = vtk_globe.make_window(SIZE, samples=8)
    grid = vtk_globe.analysis_grid(EXAGGERATION)
    panel(window, grid, 0.0, "Without haze")
    hazed = panel(window, grid, 0.5, "With haze, visibility %g km, scale height 8 km" % (VISIBILITY / 1000))
    haze = nephoscope.vtkHaze()
    haze.SetVisibility(VISIBILITY)
    haze.SetVerticalExaggeration(EXAGGERATION)
    nephoscope.vtkHaze.SetHaze(hazed, haze)
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "17_haze.png"))


main()
