# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 19: the two projections of a tetrahedron that are not degenerate, divided into triangles: figure 9 of Max, Crawfis and Becker (1993).

Left a vertex lies inside the outline, right two edges cross. All triangles meet where the tetrahedron is thickest, and opacity falls from there to
the outline. Grey is what vtkCellCompositingMapper draws with the method TrianglesLinear; the thickest point is taken from that picture.
"""
import os
import sys

import nephoscope
import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkImageData, vtkPiecewiseFunction, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import (vtkActor2D, vtkColorTransferFunction, vtkPolyDataMapper2D, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkVolume)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import pictures  # noqa: E402

SIDE = 520  # pixels of each half
INK = (0.1, 0.1, 0.15)
RED = (0.75, 0.1, 0.1)
# The eye is on the z axis. Vertices A to D, and the order of those on the outline.
TETRAHEDRA = (
    (((-0.9, -0.75, 0), (0.95, -0.6, 0.1), (-0.1, 0.9, 0), (-0.05, -0.1, 0.9)), (0, 1, 2), "3 triangles: a vertex, D, inside the outline"),
    (((-0.95, -0.35, 0.6), (0.85, 0.45, 0.6), (-0.5, 0.8, -0.4), (0.6, -0.85, -0.4)), (0, 3, 1, 2), "4 triangles: two edges, AB and CD, cross"),
)


def tetrahedron(vertices):
    points, values, grid = vtkPoints(), vtkDoubleArray(), vtkUnstructuredGrid()
    for vertex in vertices:
        points.InsertNextPoint(vertex)
        values.InsertNextValue(0.5)
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_TETRA, 4, range(4))
    grid.GetPointData().SetScalars(values)
    return grid


def volume_of(grid):
    volume, colour, opacity = vtkVolume(), vtkColorTransferFunction(), vtkPiecewiseFunction()
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(grid)
    mapper.SetMethodToTrianglesLinear()
    colour.AddRGBPoint(0, 0.3, 0.36, 0.5)
    opacity.AddPoint(0, 1)
    opacity.AddPoint(1, 1)
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    return volume


def thickest(mapper):
    """Pixels from the lower left, where the picture is most opaque."""
    image = vtkImageData()
    mapper.CopyFloatImage(image)
    width, height, _ = image.GetDimensions()
    alpha = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 4)[..., 3]
    y, x = numpy.unravel_index(numpy.argmax(alpha), alpha.shape)
    return x + 0.5, y + 0.5


def add_lines(renderer, pairs, colour, width):
    points, cells, lines = vtkPoints(), vtkCellArray(), vtkPolyData()
    for pair in pairs:
        cells.InsertNextCell(2)
        for x, y in pair:
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    lines.SetPoints(points)
    lines.SetLines(cells)
    mapper, actor = vtkPolyDataMapper2D(), vtkActor2D()
    mapper.SetInputData(lines)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetLineWidth(width)
    renderer.AddViewProp(actor)


def add_text(renderer, words, place, size):
    shown = vtkTextActor()
    shown.SetInput(words)
    shown.SetPosition(*place)
    shown.GetTextProperty().SetFontSize(size)
    shown.GetTextProperty().SetColor(*INK)
    shown.GetTextProperty().SetJustificationToCentered()
    shown.GetTextProperty().SetVerticalJustificationToCentered()
    renderer.AddViewProp(shown)


def add_drawing(renderer, vertices, outline, words, thick):
    seen = [(SIDE / 2 * (1 + x / 1.3), SIDE / 2 * (1 + y / 1.3)) for x, y, _ in vertices]
    add_lines(renderer, [(seen[i], thick) for i in outline], RED, 2)
    add_lines(renderer, [(seen[i], seen[outline[n - 1]]) for n, i in enumerate(outline)], INK, 3)
    middle = numpy.array([SIDE / 2, SIDE / 2])
    for i, letter in enumerate("ABCD"):
        away = numpy.array(seen[i]) - (middle if i in outline else numpy.array(seen[i]) - (26, 14))
        add_text(renderer, letter, numpy.array(seen[i]) + 24 * away / numpy.linalg.norm(away), 26)
    add_text(renderer, words, (SIDE / 2, 24), 22)


def main():
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(2 * SIDE, SIDE)
    drawn = []
    for column, (vertices, outline, words) in enumerate(TETRAHEDRA):
        renderer = vtkRenderer()
        renderer.SetViewport(column / 2, 0, (column + 1) / 2, 1)
        renderer.SetBackground(1, 1, 1)
        window.AddRenderer(renderer)
        volume = volume_of(tetrahedron(vertices))
        renderer.AddVolume(volume)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(0, 0, 5)
        camera.SetParallelScale(1.3)
        camera.SetClippingRange(1, 10)
        drawn.append((renderer, volume.GetMapper(), vertices, outline, words))
    window.Render()
    for renderer, mapper, *drawing in drawn:
        add_drawing(renderer, *drawing, thickest(mapper))
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "19_projected_tetrahedra.png"))


main()
