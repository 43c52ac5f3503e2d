# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory that cells take to be drawn, above the input, all buffers counted.

    ./nephoscope bench                                              all benchmarks
    ./nephoscope python Testing/Benchmarks/memory_of_cells.py       this one; --large: 10 million hexahedra

With software OpenGL the buffers of the graphics card are part of the process. What shaders, tables and images take does not depend on the number
of cells: bytes per cell are the growth of the process from a block of cells to a larger one, each drawn in a process of its own.
"""
import ctypes
import os
import subprocess
import sys

import numpy as np
import nephoscope
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_PYRAMID, VTK_TETRA, VTK_WEDGE, vtkCellArray, vtkStructuredGrid,
                                           vtkUnstructuredGrid)

from nephoscope_testing.weather import cloud_scene

# Vertices of a block by bits (x = 1, y = 2, z = 4), as VTK orders them; those of the block's middle are 8.
PARTS = {"hexahedra": (VTK_HEXAHEDRON, [[0, 1, 3, 2, 4, 5, 7, 6]]), "wedges": (VTK_WEDGE, [[0, 1, 3, 4, 5, 7], [0, 3, 2, 4, 7, 6]]),
         "tetrahedra": (VTK_TETRA, [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]]),
         "pyramids": (VTK_PYRAMID, [[0, 4, 6, 2, 8], [1, 3, 7, 5, 8], [0, 1, 5, 4, 8], [2, 6, 7, 3, 8], [0, 2, 3, 1, 8], [4, 5, 7, 6, 8]])}
# Storage, whether trilinear, and blocks along an edge: small, large, and with --large.
CASES = (("grid", False, (100, 140, 215)), ("hexahedra", False, (100, 140, 215)), ("hexahedra", True, (100, 140, 215)),
         ("wedges", False, (60, 80, 110)), ("pyramids", False, (40, 55, 80)), ("tetrahedra", False, (50, 70, 110)))


def places(n):
    z, y, x = np.meshgrid(*(np.linspace(-1, 1, n + 1),) * 3, indexing="ij")
    return np.stack([x * (1 + 0.2 * z), y, z + 0.1 * y * y], axis=-1).reshape(-1, 3).astype(np.float32)


def with_field(data, points):
    stored = vtkPoints()
    stored.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(stored)
    values = numpy_to_vtk((0.5 + 0.5 * np.sin(9 * points[:, 0]) * np.cos(7 * points[:, 1])).astype(np.float32), deep=True)
    values.SetName("cloud_fraction")
    data.GetPointData().SetScalars(values)
    return data


def block(storage, n):
    points = places(n)
    if storage == "grid":
        data = vtkStructuredGrid()
        data.SetDimensions(n + 1, n + 1, n + 1)
        return with_field(data, points)
    kind, parts = PARTS[storage]
    corner = np.arange((n + 1) ** 3).reshape((n + 1,) * 3)
    of_block = np.stack([corner[c >> 2:n + (c >> 2), c >> 1 & 1:n + (c >> 1 & 1), c & 1:n + (c & 1)].ravel() for c in range(8)], axis=-1)
    if storage == "pyramids":
        of_block = np.column_stack([of_block, len(points) + np.arange(n ** 3)])
        points = np.vstack([points, points[of_block[:, :8]].mean(axis=1)])
    ids = of_block[:, np.array(parts)].reshape(-1, len(parts[0]))
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, ids.size + 1, ids.shape[1]), deep=True), numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    data = vtkUnstructuredGrid()
    data.SetCells(kind, cells)
    return with_field(data, points)


def resident():
    ctypes.CDLL("libc.so.6").malloc_trim(0)
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def measure(storage, trilinear, n):
    data = block(storage, n)
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(data)
    mapper.SetMethodToRays()
    mapper.SetCellInterpolation(int(trilinear))
    renderer, window = cloud_scene(mapper, 0.2, 512)
    renderer.ResetCamera()
    before = resident()
    window.Render()
    print(data.GetNumberOfCells(), resident() - before)


def grown(storage, trilinear, n):
    out = subprocess.run([sys.executable, __file__, storage, str(int(trilinear)), str(n)], check=True, capture_output=True, text=True).stdout
    return [int(number) for number in out.split()[-2:]]


def main():
    if len(sys.argv) == 4:
        measure(sys.argv[1], sys.argv[2] == "1", int(sys.argv[3]))
        return
    print("| cells | drawn as | from | to | bytes per cell |\n|---|---|---|---|---|", flush=True)
    for storage, trilinear, (small, large, largest) in CASES:
        (few, less), (many, more) = (grown(storage, trilinear, n) for n in (small, largest if "--large" in sys.argv else large))
        drawn = "trilinear cells" if trilinear else "tetrahedra"
        print(f"| {storage} | {drawn} | {few:,} | {many:,} | {(more - less) / (many - few):.0f} |", flush=True)


main()
