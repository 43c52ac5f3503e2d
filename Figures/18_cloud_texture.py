# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 18: a cloud as vtkCloudTextureMapper draws it. Above, from the left: nothing set; colours of an evening; thickness that multiplies the opacity;
thickness that is added to the texture. Below, on a layer from above: the waves Clouds, Paper, Printed and Gardner.

Writes the picture (1600 x 800).
"""
import os
import sys

import nephoscope
import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkRenderer, vtkRenderWindow

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import pictures  # noqa: E402

SIZE = (1600, 800)
SKY = (0.27, 0.45, 0.68)
PUFFS = ((0, 0, 0, 1.0), (1.3, 0.2, -0.2, 0.75), (-1.2, -0.1, -0.25, 0.8), (0.4, 0, 0.75, 0.65), (-0.5, 0.3, 0.5, 0.6), (2.2, 0, -0.45, 0.45),
         (-2.1, 0.1, -0.5, 0.45))


def heap():
    """A cumulus of round parts, flat below."""
    low, high, count = numpy.array((-3.2, -1.6, -1.0)), numpy.array((3.2, 1.6, 1.8)), (128, 64, 56)
    x, y, z = numpy.meshgrid(*(numpy.linspace(a, b, n) for a, b, n in zip(low, high, count)), indexing="ij")
    field = sum(numpy.exp(-1.5 * ((x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2) / r ** 2) for a, b, c, r in PUFFS)
    field = numpy.minimum(field, 0.3 + 0.5 * (z + 0.75))
    image = vtkImageData()
    image.SetDimensions(*count)
    image.SetOrigin(*low)
    image.SetSpacing(*((high - low) / (numpy.array(count) - 1)))
    image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(order="F"), deep=True))
    surface = vtkFlyingEdges3D()
    surface.SetInputData(image)
    surface.SetValue(0, 0.3)
    return surface


def layer():
    plane = vtkPlaneSource()
    plane.SetOrigin(-1, -1, 0)
    plane.SetPoint1(1, -1, 0)
    plane.SetPoint2(-1, 1, 0)
    return plane


def add(window, place, source, configure=None):
    column, row = place
    renderer = vtkRenderer()
    renderer.SetViewport(column / 4, row / 2, (column + 1) / 4, (row + 1) / 2)
    renderer.SetBackground(*SKY)
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(12)
    mapper, actor = nephoscope.vtkCloudTextureMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    if configure:
        configure(mapper)
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.75)
    renderer.AddActor(actor)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(-2, -3, 4)
    renderer.AddLight(sun)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    if row == 1:
        camera.SetPosition(0.5, -9, 1.5)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCamera()
        camera.Zoom(1.55)
    else:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.96)
        camera.SetPosition(0, 0, 5)
    renderer.ResetCameraClippingRange()


def evening(mapper):
    mapper.SetThinColor(0.85, 0.45, 0.4)
    mapper.SetThickColor(1, 0.9, 0.7)


def opaque_by_thickness(mapper):
    mapper.UseThicknessOn()
    mapper.SetCoverage(0.7)


def added_thickness(mapper):
    mapper.UseThicknessOn()
    mapper.SetThicknessEffectToAddToTexture()
    mapper.SetCoverage(0.1)


def main():
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    for column, configure in enumerate((None, evening, opaque_by_thickness, added_thickness)):
        add(window, (column, 1), heap(), configure)
    for waves in range(4):
        add(window, (waves, 0), layer(), lambda mapper, waves=waves: mapper.SetWaves(waves))
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "18_cloud_texture.png"))


main()
