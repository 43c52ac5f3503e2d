# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the cost of vtkCellCompositingMapper grows with cells and pixels, and what it needs in memory, on a shell of smooth clouds.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included. Memory is what the process has grown by from before the
mapper was made until after the first frame, without the images, which do not grow with the cells; each size in a process of its own.
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
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

from nephoscope_testing.weather import cloud_scene

PAPER = (320, 160, 19)
CASES = [(PAPER, 1024, "grid"), ((48, 24, 10), 1024, "grid"), ((104, 52, 20), 1024, "grid"), ((320, 160, 100), 1024, "grid"),
         (PAPER, 512, "grid"), (PAPER, 2048, "grid"), ((104, 52, 20), 1024, "hexahedra")]


def shell(shape):
    """Longitude, latitude, level between the radii 1 and 1.12, with a cloud-like field that is zero in two thirds of the cells."""
    longitude = np.linspace(0, 2 * np.pi, shape[0] + 1)
    latitude = np.radians(np.linspace(-90, 90, shape[1] + 1))
    radius = np.linspace(1, 1.12, shape[2] + 1)
    r, lat, lon = np.meshgrid(radius, latitude, longitude, indexing="ij")
    points = np.stack([r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)], axis=-1)
    field = np.sin(6 * lon + 3 * np.sin(5 * lat)) * np.cos(9 * lat) * np.sin(40 * (r - 1)) + 0.1 * np.sin(31 * lon) - 0.35
    points[..., -1, :] = points[..., 0, :]
    field[..., -1] = field[..., 0]
    grid = vtkStructuredGrid()
    grid.SetDimensions(shape[0] + 1, shape[1] + 1, shape[2] + 1)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points.reshape(-1, 3).astype(np.float32), deep=1))
    grid.SetPoints(places)
    values = numpy_to_vtk(np.clip(field, 0, 1).ravel().astype(np.float32), deep=1)
    values.SetName("cloud")
    grid.GetPointData().SetScalars(values)
    return grid


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def seconds(window):
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def measure(shape, size, kind):
    small = nephoscope.vtkCellCompositingMapper()  # what OpenGL and the images need once
    small.SetInputData(shell((8, 4, 2)))
    window = cloud_scene(small, 0.03, size)[1]
    window.Render()
    grid = shell(shape)
    if kind == "hexahedra":
        append = vtkAppendFilter()
        append.AddInputData(grid)
        append.Update()
        grid = append.GetOutput()
    cells = grid.GetNumberOfCells()
    window.Finalize()
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(grid)
    renderer, window = cloud_scene(mapper, 0.03, size)
    before = resident()
    first = seconds(window)
    memory = (resident() - before) / cells
    moving = []
    for _ in range(4):
        renderer.GetActiveCamera().Azimuth(7)
        renderer.ResetCameraClippingRange()
        moving.append(seconds(window))
    images = size * size * (16 + 16 + 8 + 4 + 4) / cells  # float image, entries, depths
    print(f"| {' x '.join(map(str, shape))} {kind} | {cells / 1e6:.2f} M | {size} | {first:.2f} | {sorted(moving)[2]:.2f} | "
          f"{seconds(window):.2f} | {max(memory - images, 0):.0f} |", flush=True)


def main():
    if len(sys.argv) > 1:
        shape, size, kind = CASES[int(sys.argv[1])]
        measure(shape, size, kind)
        return
    print("| cells | | pixels across | first s | moving s | still s | bytes per cell |\n|---|---|---|---|---|---|---|", flush=True)
    for case in range(len(CASES)):
        subprocess.run([sys.executable, __file__, str(case)], check=True)


main()
