# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times sorted splats in the shape of their cells against unsorted discs of vtkPointGaussianMapper, and how splats grow with their number.

    ./nephoscope bench

Both draw the same points with the same widths in one run: random points in a cube, each with the share of the cube that falls to it; the
peer's gaussian has the standard deviation of the splats' kernel. Seconds are processor time of the whole process, software OpenGL
included; the ratio is what to quote. A moving frame sorts anew. The second table gives each splat a cell of its own (a bent grid)
or shares one (points), in a smaller picture, so that the number of splats counts; seconds are for a million splats. It says what a splat
needs in memory: what the process grows by, software OpenGL's buffers included, after the first frames and at most during them, and the share of buffers that a
GPU would hold. Memory is measured in a process of its own with one thread of software OpenGL, because with more it keeps several frames that wait.

    ./nephoscope python Testing/Benchmarks/splats_against_points.py growth
"""
import ctypes
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
GROWTH_SIZE = 256
BUFFERS = {"points": 36, "cells": 68}  # bytes: place or cell and place, colour and extinction, order
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


def view(prop, size=SIZE):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddViewProp(prop)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
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


def frames(prop, size=SIZE):
    return times(*view(prop, size))


def times(renderer, window):
    """First frame, median moving frame, and a frame that changes nothing."""
    first = seconds(window)
    moving = []
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(7)
        moving.append(seconds(window))
    return first, sorted(moving)[MOVES // 2], seconds(window)


def resident():
    ctypes.CDLL(None).malloc_trim(0)  # what is free does not count
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
    data = warmed(kind, count)
    millions = data.GetNumberOfPoints() / 1e6
    first, moving, still = (t / millions for t in frames(splats(data), GROWTH_SIZE))
    command = [sys.executable, __file__, "memory", kind, str(count)]
    memory = subprocess.run(command, check=True, env=dict(os.environ, LP_NUM_THREADS="0"), stdout=subprocess.PIPE, text=True).stdout.strip()
    print(f"| {data.GetNumberOfPoints()} | {kind} | {first:.2f} | {moving:.2f} | {still:.2f} | {memory} | {BUFFERS[kind]} |", flush=True)


def print_memory(kind, count):
    """Bytes of a splat after the first frames, and at most until then."""
    data = warmed(kind, count)
    before = resident()
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")  # the greatest size begins anew
    renderer, window = view(splats(data), GROWTH_SIZE)
    times(renderer, window)
    with open("/proc/self/status") as file:
        peak = next(1024 * int(line.split()[1]) for line in file if line.startswith("VmHWM"))
    print(" | ".join(f"{(size - before) / data.GetNumberOfPoints():.0f}" for size in (resident(), peak)))


def warmed(kind, count):
    """The data, after a first picture of others, for which OpenGL and the images need what they need once."""
    view(splats(bent_grid(1000) if kind == "cells" else points_in_a_cube(1000)), GROWTH_SIZE)[1].Render()
    return points_in_a_cube(count) if kind == "points" else bent_grid(count)


def growth():
    print("| splats | shape | first | moving | still | bytes | at most | buffers |\n|---|---|---|---|---|---|---|---|", flush=True)
    for kind in ("points", "cells"):
        for power in (4, 5, 6, 7):
            subprocess.run([sys.executable, __file__, kind, str(10**power)], check=True)


def main():
    if sys.argv[1:] == ["compare"]:
        compare(10**6)
    elif sys.argv[1:] == ["growth"]:
        growth()
    elif sys.argv[1:2] == ["memory"]:
        print_memory(sys.argv[2], int(sys.argv[3]))
    elif sys.argv[1:]:
        grow(sys.argv[1], int(sys.argv[2]))
    else:
        subprocess.run([sys.executable, __file__, "compare"], check=True)
        growth()


main()
