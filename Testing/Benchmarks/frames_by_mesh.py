# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames of meshes that rays find hard: the GFS globe without its structure, thin shells, stacks of slabs, meshes with holes.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included: the median of frames of a moving camera. The peer is
vtkProjectedTetrahedraMapper, on the same cells as tetrahedra. `passes` is the number of times that rays entered the mesh anew.
The transfer function is clear below 0.05.
"""
import sys
import time

import numpy as np

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkStructuredGrid, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper

from nephoscope_testing.weather import cloud_scene, forecast_globe

SIZE = int(sys.argv[1]) if len(sys.argv) > 1 else 1024
MOVES = 4


def structured(points, values, shape):
    """A grid of shape (x, y, z) points, x fastest."""
    grid = vtkStructuredGrid()
    grid.SetDimensions(*shape)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points.reshape(-1, 3)), deep=1))
    grid.SetPoints(places)
    array = numpy_to_vtk(np.ascontiguousarray(values.ravel().astype(np.float32)), deep=1)
    array.SetName("cloud_fraction")
    grid.GetPointData().SetScalars(array)
    return grid


def filtered(data, name):
    chosen = vtkAppendFilter() if name == "hexahedra" else vtkDataSetTriangleFilter()
    chosen.AddInputData(data) if name == "hexahedra" else chosen.SetInputData(data)
    chosen.Update()
    return chosen.GetOutput()


def in_float(globe):
    """The globe with poles and seam as sines and cosines of 32 bits have them."""
    nx, ny, nz = (globe.GetExtent()[2 * k + 1] - globe.GetExtent()[2 * k] + 1 for k in range(3))
    kind = np.float32
    longitude, latitude = np.radians(np.linspace(0, 360, nx, dtype=kind)), np.radians(np.linspace(-90, 90, ny, dtype=kind))
    r, lat, lon = np.meshgrid(np.linspace(6371000, 7130000, nz, dtype=kind), latitude, longitude, indexing="ij")
    points = np.stack([r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)], axis=-1)
    return structured(points, vtk_to_numpy(globe.GetPointData().GetArray("cloud_fraction")), (nx, ny, nz))


def field(p):
    return 0.3 + 0.3 * np.sin(6 * p[..., 0]) * np.cos(5 * p[..., 1] + 4 * p[..., 2])


def thin_shells(count=10, longitudes=96, latitudes=48, thickness=1e-3):
    """One inside the other, each a single layer of cells, apart."""
    append = vtkAppendFilter()
    for shell in range(count):
        radius = 1 + 0.02 * shell + np.array([0, thickness])
        r, lat, lon = np.meshgrid(radius, np.radians(np.linspace(-90, 90, latitudes + 1)),
                                  np.radians(np.linspace(0, 360, longitudes + 1)), indexing="ij")
        p = np.stack([r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)], axis=-1)
        append.AddInputData(structured(p, field(p), (longitudes + 1, latitudes + 1, 2)))
    append.Update()
    return append.GetOutput()


def slabs(count=100, cells=16):
    append = vtkAppendFilter()
    for slab in range(count):
        axis = np.linspace(0, 1, cells + 1)
        z, y, x = np.meshgrid((slab + np.array([0, 0.6])) / count, axis, axis, indexing="ij")
        p = np.stack([x, y, z], axis=-1)
        append.AddInputData(structured(p, field(p), (cells + 1, cells + 1, 2)))
    append.Update()
    return append.GetOutput()


def holes(cells=32, fraction=0.5):
    """A block of which so many cells are left."""
    axis = np.linspace(0, 1, cells + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    p = np.stack([x, y, z], axis=-1)
    block = structured(p, field(p), (cells + 1,) * 3)
    result, ids = vtkUnstructuredGrid(), vtkIdList()
    result.SetPoints(block.GetPoints())
    result.GetPointData().ShallowCopy(block.GetPointData())
    for i in np.flatnonzero(np.random.default_rng(1).uniform(size=block.GetNumberOfCells()) < fraction):
        block.GetCellPoints(int(i), ids)
        result.InsertNextCell(VTK_HEXAHEDRON, ids)
    return result


def seconds(window):
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def frames(mapper, unit):
    """(first frame, median of moving frames)."""
    renderer, window = cloud_scene(mapper, unit, SIZE)
    first, moving = seconds(window), []
    renderer.GetActiveCamera().Elevation(35)
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(7)
        renderer.ResetCameraClippingRange()
        moving.append(seconds(window))
    return first, sorted(moving)[MOVES // 2]


def ours(data):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(data)
    mapper.SetMethodToRays()
    return mapper


def main():
    globe = forecast_globe()
    globe.GetPointData().SetActiveScalars("cloud_fraction")
    rough = in_float(globe)
    meshes = [("globe, structured", globe, 2e5), ("globe, hexahedra", filtered(globe, "hexahedra"), 2e5),
              ("globe, tetrahedra", filtered(globe, "tetrahedra"), 2e5), ("globe in float, structured", rough, 2e5),
              ("globe in float, hexahedra", filtered(rough, "hexahedra"), 2e5),
              ("globe in float, tetrahedra", filtered(rough, "tetrahedra"), 2e5), ("10 thin shells", thin_shells(), 1e-3),
              ("100 slabs", slabs(), 0.3), ("block with holes", holes(), 0.3)]
    print(f"| mesh ({SIZE} x {SIZE}) | cells | passes | first s | moving s | times structured | peer, moving s | times the peer |")
    print("|---|---|---|---|---|---|---|---|", flush=True)
    reference = 0
    for name, data, unit in meshes:
        mapper = ours(data)
        first, moving = frames(mapper, unit)
        reference = moving if name.endswith("structured") else reference
        ratio = f"{moving / reference:.2f}" if name.startswith("globe") else ""
        peer = vtkProjectedTetrahedraMapper()
        peer.SetInputData(filtered(data, "tetrahedra"))
        theirs = frames(peer, unit)[1]
        print(f"| {name} | {data.GetNumberOfCells()} | {mapper.GetNumberOfRayLayers()} | {first:.2f} | {moving:.2f} | {ratio} | {theirs:.2f} | "
              f"{moving / theirs:.2f} |", flush=True)


main()
