# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames and memory of a graphics card with 10⁶ cells or those that CELLS names, at 1920 x 1080, beside VTK's own mappers on the same cells.

    ./nephoscope python Testing/Benchmarks/gpu_scale.py [CELLS...]

A smooth cloud field on an image, on a bent grid as unstructured hexahedra, and on its tetrahedra. Each case runs in a process of its own.
Milliseconds are elapsed until the device has finished, the median of frames of a moving camera. Device memory is what `nvidia-smi` reports
more than before the mapper was made, with the images of the window that it needs; without `nvidia-smi` it is left out. For graphics cards:
with software OpenGL it takes long.
"""
import os
import subprocess
import sys
import time

import numpy as np

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

SIZE = (1920, 1080)
FRAMES = 15
SLOWEST_PEER = 10**6  # cells: the projected tetrahedra of ten times as many take minutes


def lattice(side):
    axis = np.linspace(-1, 1, side + 1)
    return np.meshgrid(axis, axis, axis, indexing="ij")


def field(z, y, x):
    return np.clip(np.sin(7 * x + 2 * np.sin(5 * y)) * np.cos(6 * y + z) * np.cos(3 * z) - 0.15, 0, 1)


def with_field(data, values):
    array = numpy_to_vtk(values.ravel().astype(np.float32), deep=1)
    array.SetName("cloud")
    data.GetPointData().SetScalars(array)
    return data


def image(cells):
    side = round(cells ** (1 / 3))
    data = vtkImageData()
    data.SetDimensions(3 * (side + 1,))
    data.SetOrigin(-1, -1, -1)
    data.SetSpacing(3 * (2 / side,))
    return with_field(data, field(*lattice(side)))


def hexahedra(cells):
    side = round(cells ** (1 / 3))
    z, y, x = lattice(side)
    places = np.stack([x + 0.2 * y * z, y + 0.2 * z * z - 0.1, z - 0.15 * x * x], axis=-1).reshape(-1, 3)
    grid, points = vtkStructuredGrid(), vtkPoints()
    grid.SetDimensions(3 * (side + 1,))
    points.SetData(numpy_to_vtk(places.astype(np.float32), deep=1))
    grid.SetPoints(points)
    append = vtkAppendFilter()
    append.AddInputData(with_field(grid, field(z, y, x)))
    append.Update()
    return append.GetOutput()


def tetrahedra(cells):
    triangles = vtkDataSetTriangleFilter()
    triangles.SetInputData(hexahedra(cells / 6))
    triangles.Update()
    return triangles.GetOutput()


def trilinear():
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetCellInterpolationToTrilinear()
    return mapper


DATA = {"image": image, "hexahedra": hexahedra, "tetrahedra": tetrahedra}
MAPPERS = {"cells": nephoscope.vtkCellCompositingMapper, "cells, trilinear": trilinear, "splats": nephoscope.vtkTexturedSplatMapper,
           "vtkGPUVolumeRayCastMapper": vtkOpenGLGPUVolumeRayCastMapper, "vtkProjectedTetrahedraMapper": vtkProjectedTetrahedraMapper}
CASES = [("image", "cells"), ("image", "vtkGPUVolumeRayCastMapper"), ("hexahedra", "cells"), ("hexahedra", "cells, trilinear"), ("hexahedra", "splats"),
         ("tetrahedra", "cells"), ("tetrahedra", "vtkProjectedTetrahedraMapper")]


def volume(mapper):
    prop, opacity, color = vtkVolume(), vtkPiecewiseFunction(), vtkColorTransferFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(0.05, 0)
    opacity.AddPoint(1, 1)
    color.AddRGBPoint(0, 0.5, 0.6, 0.8)
    color.AddRGBPoint(1, 1, 1, 1)
    prop.SetMapper(mapper)
    prop.GetProperty().SetScalarOpacity(opacity)
    prop.GetProperty().SetColor(color)
    prop.GetProperty().SetScalarOpacityUnitDistance(0.1)
    prop.GetProperty().SetInterpolationTypeToLinear()
    return prop


def view():
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    renderer.ResetCamera(-1, 1, -1, 1, -1, 1)
    renderer.GetActiveCamera().Elevation(20)
    renderer.GetActiveCamera().Zoom(1.4)
    return renderer, window


def device_memory():
    """Bytes in use on the first card, or None."""
    try:
        command = ["nvidia-smi", "--query-gpu=memory.used", "--format=csv,noheader,nounits"]
        return int(subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()[0]) << 20
    except (OSError, subprocess.CalledProcessError):
        return None


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def milliseconds(renderer, window):
    start = time.perf_counter()
    renderer.ResetCameraClippingRange(-1.3, 1.3, -1.3, 1.3, -1.3, 1.3)
    window.Render()
    window.WaitForCompletion()
    return 1000 * (time.perf_counter() - start)


def grown(before, after, cells):
    return "" if before is None else f"{(after - before) / cells:.0f}"


def measure(kind, mapper, cells):
    renderer, window = view()
    window.Render()
    data = DATA[kind](cells)
    count = data.GetNumberOfCells()
    before = device_memory(), resident()
    drawing = MAPPERS[mapper]()
    drawing.SetInputData(data)
    renderer.AddVolume(volume(drawing))
    first = milliseconds(renderer, window)
    moving = []
    for _ in range(FRAMES):
        renderer.GetActiveCamera().Azimuth(7)
        moving.append(milliseconds(renderer, window))
    after = device_memory(), resident()
    print(f"| {kind} | {count / 1e6:.2f} M | {mapper} | {first / 1000:.2f} | {sorted(moving)[FRAMES // 2]:.1f} | {max(moving):.1f} | "
          f"{grown(before[0], after[0], count)} | {grown(before[1], after[1], count)} |", flush=True)


def main():
    if len(sys.argv) > 3:
        measure(sys.argv[1], sys.argv[2], int(sys.argv[3]))
        return
    print("| data | cells | mapper | first frame, s | median, ms | longest, ms | device, bytes per cell | process, bytes per cell |\n"
          "|---|---|---|---|---|---|---|---|", flush=True)
    for cells in map(int, sys.argv[1:] or (10**6,)):
        for kind, mapper in CASES:
            if mapper != "vtkProjectedTetrahedraMapper" or cells <= SLOWEST_PEER:
                subprocess.run([sys.executable, __file__, kind, mapper, str(cells)], check=True)


main()
