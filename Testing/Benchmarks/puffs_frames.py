# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a frame costs in which only the opacity array of the cells has changed, as puffs of smoke do, on a tube of tetrahedra.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included, in a picture of 64 x 64 pixels, so that the mapper's own
work counts; of use as ratios. Per row: the first frame, that of changed opacities (median of five), that of a moved camera
(median of five), and an unchanged one; then the changed frame as a part of the first, and how much it adds to an unchanged one,
as a part of what the first adds.
"""
import time

import numpy as np

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderWindow, vtkRenderer, vtkVolume

SIZES = (50_000, 500_000)
TETRAHEDRA = np.array([(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)])
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


def tube(count):
    """About `count` tetrahedra of a bent tube, as a flow volume is: 12 x 12 across, long; and its steps along, per cell."""
    across, along = 12, max(count // (6 * 12 * 12), 1)
    u, v, w = (np.linspace(0, 1, n + 1) for n in (across, across, along))
    w, v, u = np.meshgrid(w, v, u, indexing="ij")
    radius = 1 + 0.3 * (u - 0.5)
    points = np.stack([radius * np.cos(5 * w), radius * np.sin(5 * w), 2 * w + 0.3 * (v - 0.5)], axis=-1).reshape(-1, 3)
    number = np.arange(len(points)).reshape(along + 1, across + 1, across + 1)
    corner = [number[k:k + along, j:j + across, i:i + across].ravel() for i, j, k in CORNERS]
    cells = np.stack(corner, axis=1)[:, TETRAHEDRA].reshape(-1, 4)
    grid, places, list_of_cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=1))
    grid.SetPoints(places)
    list_of_cells.SetData(4, numpy_to_vtkIdTypeArray(cells.ravel().astype(np.int64), deep=1))
    grid.SetCells(VTK_TETRA, list_of_cells)
    steps = np.repeat(np.arange(along) / along, across * across * 6)
    height = numpy_to_vtk(points[:, 2].astype(np.float32), deep=1)
    height.SetName("Height")
    grid.GetPointData().AddArray(height)
    return grid, steps


def set_density(grid, steps, phase):
    """A new array, as a filter makes it."""
    density = numpy_to_vtk(np.maximum(np.cos(2 * np.pi * (4 * steps - phase)), 0), deep=1)
    density.SetName("Density")
    grid.GetCellData().AddArray(density)


def scene(grid, colors):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(grid)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("Height")
    mapper.SetOpacityArrayName("Density")
    volume, color, opacity = vtkVolume(), vtkColorTransferFunction(), vtkPiecewiseFunction()
    for place, rgb in colors:
        color.AddRGBPoint(place, *rgb)
    opacity.AddPoint(0, 0)
    opacity.AddPoint(1, 5)
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(color)
    volume.GetProperty().SetScalarOpacity(opacity)
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddVolume(volume)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(64, 64)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    return mapper, renderer, window


def seconds(window):
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def median(values):
    return sorted(values)[len(values) // 2]


def measure(count, label, colors, method):
    small = scene(prepared(100)[0], colors)  # shaders are compiled once
    getattr(small[0], "SetMethodTo" + method)()
    small[2].Render()
    grid, steps = prepared(count)
    mapper, renderer, window = scene(grid, colors)
    getattr(mapper, "SetMethodTo" + method)()
    window.SetSharedRenderWindow(small[2])
    first = seconds(window)
    changed, moved = [], []
    for frame in range(5):
        set_density(grid, steps, 0.1 + 0.17 * frame)
        changed.append(seconds(window))
    for _ in range(5):
        renderer.GetActiveCamera().Azimuth(7)
        renderer.ResetCameraClippingRange()
        moved.append(seconds(window))
    still = median([seconds(window) for _ in range(5)])
    changed = median(changed)
    print(f"| {grid.GetNumberOfCells()} | {label} | {method} | {first:.3f} | {changed:.3f} | {median(moved):.3f} | {still:.3f} | "
          f"{changed / first:.3f} | {(changed - still) / (first - still):.3f} |", flush=True)


def prepared(count):
    grid, steps = tube(count)
    set_density(grid, steps, 0)
    return grid, steps


def main():
    print("| tetrahedra | colours | method | first s | changed s | moved s | unchanged s | changed / first | of what the first adds |\n"
          "|---|---|---|---|---|---|---|---|---|", flush=True)
    for count in SIZES:
        measure(count, "one", [(0, (1, 0.9, 0.8))], "Automatic")
        for method in ("Rays", "Projection"):
            measure(count, "two", [(0, (1, 0, 0)), (2, (0, 0, 1))], method)


main()
