# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times sorted splats in the shape of their cells against unsorted discs of vtkPointGaussianMapper, and how splats grow with their number.

    ./nephoscope bench

Both draw the same points with the same widths in one run: random points in a cube, each with the share of the cube that falls to it; the
peer's gaussian has the standard deviation of the splats' kernel. Seconds are processor time of the whole process, software OpenGL
included; the ratio is what to quote. A moving frame sorts anew. The second table gives each splat a cell of its own (a bent grid)
or shares one (points), and says what a splat needs in memory: what the process grows by, software OpenGL's buffers included.
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
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPointGaussianMapper, vtkRenderer, vtkRenderWindow, vtkVolume

SIZE = 1024
MOVES = 4
DEVIATION = 0.199406**0.5  # of the cubic kernel, in cells


def named(values):
    array = numpy_to_vtk(np.ascontiguousarray(values, np.float32), deep=1)
    array.SetName("s")
    return array


def points_in_a_cube(count):
    places = np.random.default_rng(1).uniform(-1, 1, (count, 3))
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(places.astype(np.float32), deep=1))
    data.SetPoints(points)
    data.GetPointData().SetScalars(named(places[:, 2] * 0.5 + 0.5))
    return data


def bent_grid(count):
    side = round(count ** (1 / 3))
    axis = np.linspace(-1, 1, side)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    places = np.stack([x + 0.2 * y * z, y + 0.2 * z * z - 0.1, z - 0.15 * x * x], axis=-1).reshape(-1, 3)
    data, points = vtkStructuredGrid(), vtkPoints()
    data.SetDimensions(side, side, side)
    points.SetData(numpy_to_vtk(places.astype(np.float32), deep=1))
    data.SetPoints(points)
    data.GetPointData().SetScalars(named(z.ravel() * 0.5 + 0.5))
    return data


def color_map():
    color = vtkColorTransferFunction()
    color.AddRGBPoint(0, 1, 0.3, 0.1)
    color.AddRGBPoint(1, 0.1, 0.4, 1)
    return color


def view(prop):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddViewProp(prop)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    renderer.ResetCamera(-1, 1, -1, 1, -1, 1)
    renderer.GetActiveCamera().Elevation(20)
    renderer.ResetCameraClippingRange(-1.5, 1.5, -1.5, 1.5, -1.5, 1.5)
    return renderer, window


def splats(data):
    volume, mapper, opacity = vtkVolume(), nephoscope.vtkTexturedSplatMapper(), vtkPiecewiseFunction()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("s")
    opacity.AddPoint(0, 1)
    opacity.AddPoint(1, 1)
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(color_map())
    volume.GetProperty().SetScalarOpacity(opacity)
    return volume


def discs(data):
    actor, mapper = vtkActor(), vtkPointGaussianMapper()
    mapper.SetInputData(data)
    mapper.SetLookupTable(color_map())
    mapper.SetScaleFactor(DEVIATION * 2 / data.GetNumberOfPoints() ** (1 / 3))
    mapper.EmissiveOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.05)
    return actor


def seconds(window):
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def frames(prop):
    """First frame, median moving frame, and a frame that changes nothing."""
    renderer, window = view(prop)
    first = seconds(window)
    moving = []
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(7)
        moving.append(seconds(window))
    return first, sorted(moving)[MOVES // 2], seconds(window)


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def compare(count):
    data = points_in_a_cube(count)
    for label in ("warm", "measured"):  # shaders are compiled in the first round
        peer, own = frames(discs(data)), frames(splats(data))
        if label == "warm":
            data = points_in_a_cube(count)
    print("| 10^6 points, 1024 x 1024 | first s | moving s | still s | moving, times the peer's |\n|---|---|---|---|---|")
    for name, (first, moving, still) in (("vtkPointGaussianMapper, unsorted", peer), ("vtkTexturedSplatMapper", own)):
        print(f"| {name} | {first:.2f} | {moving:.2f} | {still:.2f} | {moving / peer[1]:.2f} |", flush=True)


def grow(kind, count):
    view(splats(bent_grid(8)))[1].Render()  # what OpenGL and the images need once
    data = points_in_a_cube(count) if kind == "points" else bent_grid(count)
    before = resident()
    first, moving, still = frames(splats(data))
    memory = (resident() - before) / data.GetNumberOfPoints()
    print(f"| {data.GetNumberOfPoints()} | {kind} | {first:.2f} | {moving:.2f} | {still:.2f} | {memory:.0f} |", flush=True)


def main():
    if len(sys.argv) > 1:
        compare(10**6) if sys.argv[1] == "compare" else grow(sys.argv[1], int(sys.argv[2]))
        return
    subprocess.run([sys.executable, __file__, "compare"], check=True)
    print("| splats | shape | first s | moving s | still s | bytes per splat |\n|---|---|---|---|---|---|", flush=True)
    for kind in ("points", "cells"):
        for power in (4, 5, 6, 7):
            subprocess.run([sys.executable, __file__, kind, str(10**power)], check=True)


main()
