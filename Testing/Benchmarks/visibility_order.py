# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the exact visibility order costs: growth with the mesh, meshes that are not convex, cycles, and the longest silence.

    ./nephoscope bench

The opacity function is zero, so that a frame is the making of the order and nothing else. Seconds are processor time of the
process; "silence" is the longest wall time between two progress events, beginning and end included, of the first frame.
"""
import time

import nephoscope
import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkPiecewiseFunction, vtkStructuredGrid, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderWindow, vtkRenderer, vtkVolume

MOVES = 3


def structured(shape, place):
    axes = [np.linspace(0, 1, n + 1) for n in shape]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack(place(x.ravel(), y.ravel(), z.ravel())), deep=True))
    grid = vtkStructuredGrid()
    grid.SetDimensions(*(n + 1 for n in shape))
    grid.SetPoints(points)
    return with_scalars(grid)


def with_scalars(grid):
    scalars = numpy_to_vtk(np.linspace(0, 1, grid.GetNumberOfPoints()), deep=True)
    scalars.SetName("s")
    grid.GetPointData().SetScalars(scalars)
    return grid


def lattice(n):
    """A cube, moved a little inside: convex."""
    rng = np.random.default_rng(1)

    def place(*x):
        inside = np.all([(c > 0) & (c < 1) for c in x], axis=0)
        return [c + inside * rng.uniform(-0.1, 0.1, len(c)) / n for c in x]
    return structured((n, n, n), place)


def globe(longitudes, latitudes, levels):
    """A shell around a planet: rays leave it and enter it again."""
    def place(x, y, z):
        lon, lat, r = 2 * np.pi * (x % 1), np.pi * (y - 0.5), 1 + 0.1 * z
        return r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)
    return structured((longitudes, latitudes, levels), place)


def perforated(n):
    """The cube with every second column of cells missing."""
    grid = lattice(n)
    for i in range(0, n, 2):
        for j in range(0, n, 2):
            for k in range(n):
                grid.BlankCell(i + n * (j + n * k))
    return grid


def interlaced_rods(n):
    """n x n rods along each axis, all in one cycle: as bad as it gets."""
    points, grid = vtkPoints(), vtkUnstructuredGrid()
    for axis in range(3):
        for i in range(n):
            for j in range(n):
                low = np.roll([0, i + 0.05, j + 0.55], axis)
                high = np.roll([n, i + 0.45, j + 0.95], axis)
                for corner in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
                    points.InsertNextPoint(*np.where(corner, high, low))
                last = points.GetNumberOfPoints()
                grid.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(last - 8, last)))
    grid.SetPoints(points)
    return with_scalars(grid)


def window_of(grid, size, direction):
    mapper, volume, opacity = nephoscope.vtkCellCompositingMapper(), vtkVolume(), vtkPiecewiseFunction()
    mapper.SetInputData(grid)
    mapper.SetMethodToProjection()
    volume.SetMapper(mapper)
    opacity.AddPoint(0, 0)
    opacity.AddPoint(1, 0)
    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(0, 1, 1, 1)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetColor(colour)
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddVolume(volume)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    renderer.GetActiveCamera().SetPosition(*direction)
    renderer.ResetCamera()
    return mapper, renderer, window


def seconds(window):
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def measure(label, grid, size=1024, direction=(3, 1, 0.7)):
    mapper, renderer, window = window_of(grid, size, direction)
    mapper.Update()
    renderer.GetVolumes().GetLastProp().VisibilityOff()
    window.Render()  # makes the window
    renderer.GetVolumes().GetLastProp().VisibilityOn()
    heard = []
    tag = mapper.AddObserver("ProgressEvent", lambda *_: heard.append(time.monotonic()))
    heard.append(time.monotonic())
    first = seconds(window)
    heard.append(time.monotonic())
    mapper.RemoveObserver(tag)
    moves = []
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(3)
        moves.append(seconds(window))
    count = mapper.GetNumberOfTetrahedra()
    moving = sorted(moves)[MOVES // 2]
    print(f"| {label} | {size} | {count} | {first:.2f} | {moving:.2f} | {mapper.GetNumberOfCyclicTetrahedra()} | "
          f"{max(np.diff(heard)):.2f} |", flush=True)


def main():
    print("| mesh | pixels | tetrahedra | first frame s | moved camera s | in cycles | silence s |")
    print("|---|---|---|---|---|---|---|")
    for n in (12, 26, 55, 94):
        measure("cube, convex", lattice(n))
    for n in (26, 55):
        measure("cube, perforated", perforated(n))
    for size in (512, 1024, 2048):
        measure("globe", globe(144, 73, 20), size)
    for n in (4, 8):
        measure("interlaced rods", interlaced_rods(n), direction=(1, 1.1, 0.9))


main()
