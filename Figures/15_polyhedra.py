# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 15: one polyhedral cell that is not convex. Left: drawn as if it were convex. Middle: divided first. Right: its
tetrahedra, drawn apart.

A spiral of one VTK_POLYHEDRON with a field that is linear along it. The division needs TetGen; a build without it draws the left
picture twice, and warns.
"""
import os
import sys

import nephoscope
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkShrinkFilter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkDataSetMapper, vtkRenderer, vtkRenderWindow,
                                         vtkVolume, vtkVolumeProperty)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import pictures  # noqa: E402

GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
SIZE = (1200, 400)
SPIRAL = ((0, 0), (5, 0), (5, 5), (1, 5), (1, 2), (3, 2), (3, 3), (2, 3), (2, 4), (4, 4), (4, 1), (0, 1))


def spiral_cell():
    """A prism over the spiral: two faces of twelve points, and twelve sides."""
    n, points, height = len(SPIRAL), vtkPoints(), vtkDoubleArray()
    height.SetName("height")
    for z in (0.0, 1.2):
        for x, y in SPIRAL:
            points.InsertNextPoint(x, y, z)
            height.InsertNextValue(y)
    faces = [list(range(n))[::-1], list(range(n, 2 * n))]
    faces += [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    stream = vtkIdList()
    for value in [len(faces)] + [v for face in faces for v in [len(face)] + face]:
        stream.InsertNextId(value)
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_POLYHEDRON, stream)
    grid.GetPointData().SetScalars(height)
    return grid


def colours():
    result = vtkColorTransferFunction()
    for value, colour in ((0, (0.13, 0.35, 0.75)), (2.5, (0.93, 0.93, 0.9)), (5, (0.96, 0.55, 0.2))):
        result.AddRGBPoint(value, *colour)
    return result


def add_volume(renderer, data):
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 1.1)
    opacity.AddPoint(5, 1.1)
    appearance = vtkVolumeProperty()
    appearance.SetColor(colours())
    appearance.SetScalarOpacity(opacity)
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(data)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(appearance)
    renderer.AddVolume(volume)


def add_tetrahedra(renderer, data):
    shrink = vtkShrinkFilter()
    shrink.SetInputData(data)
    shrink.SetShrinkFactor(0.8)
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(shrink.GetOutputPort())
    mapper.SetLookupTable(colours())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)


def add_renderer(window, column):
    renderer = vtkRenderer()
    renderer.SetViewport(column / 3, 0, (column + 1) / 3, 1)
    renderer.SetBackground(0.05, 0.06, 0.09)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(2.5, 2.5, 0.4)
    camera.SetPosition(4.5, -1.5, 13)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(30)
    camera.SetClippingRange(5, 30)
    return renderer


def main():
    whole = spiral_cell()
    divider = nephoscope.vtkPolyhedronToTetrahedra()
    divider.SetInputData(whole)
    divider.Update()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*SIZE)
    add_volume(add_renderer(window, 0), whole)
    add_volume(add_renderer(window, 1), divider.GetOutput())
    add_tetrahedra(add_renderer(window, 2), divider.GetOutput())
    window.Render()
    pictures.write(window, os.path.join(GALLERY, "15_polyhedra.png"))


main()
