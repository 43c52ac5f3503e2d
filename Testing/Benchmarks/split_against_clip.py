# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times vtkContourCellSplitter against a chain of VTK's clip filters that gives the same layers, in one run.

    ./nephoscope bench

n values make n + 1 layers: each layer is clipped below and above. Seconds are processor time of all threads together, so that other work on
the machine counts little; the ratio is what to quote. "open faces" are triangles of faces inside the domain that only one
cell has, after points at one place have been made one and polygons have been cut from their least vertex: 0 where the cells fit.
Volumes are vtkCellSizeFilter's, which divides hexahedra with warped faces (the globe's) in its own way.
"""
import os
import time

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_PYRAMID, VTK_TETRA, VTK_VOXEL, VTK_WEDGE)
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet, vtkDataSetTriangleFilter, vtkTableBasedClipDataSet
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

FACES = {
    VTK_TETRA: [(0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1)],
    VTK_HEXAHEDRON: [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)],
    VTK_VOXEL: [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)],
    VTK_WEDGE: meshes.wedge_faces(),
    VTK_PYRAMID: [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
}
SPLITTER = "vtkContourCellSplitter"


def split(data, array, values):
    made = nephoscope.vtkContourCellSplitter()
    made.SetInputData(data)
    made.SetInputArrayToProcess(0, 0, 0, 0, array)
    made.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        made.SetValue(i, value)
    made.GenerateSurfacesOff()  # the clip filters make none
    made.Update()
    return [made.GetOutput()]


def clip_chain(make):
    """A function that returns the layers as the clip filter makes them."""
    def layers(data, array, values):
        parts = []
        for bounds in zip([None, *values], [*values, None]):
            part = data
            for value, inside_out in zip(bounds, (False, True)):
                if value is not None:
                    clip = make()
                    clip.SetInputData(part)
                    clip.SetInputArrayToProcess(0, 0, 0, 0, array)
                    clip.SetValue(value)
                    clip.SetInsideOut(inside_out)
                    clip.Update()
                    part = clip.GetOutput()
            parts.append(part)
        return parts
    return layers


METHODS = {SPLITTER: split, "vtkTableBasedClipDataSet": clip_chain(vtkTableBasedClipDataSet),
           "vtkClipDataSet": clip_chain(vtkClipDataSet)}


def globe():
    reader = vtkNetCDFCFReader()
    reader.SetFileName(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))
    reader.SphericalCoordinatesOff()
    reader.UpdateInformation()
    reader.SetDimensions("(lev, lat, lon)")
    grid = nephoscope.vtkGlobeGrid()
    grid.SetInputConnection(reader.GetOutputPort())
    grid.SetVerticalExaggeration(45)
    grid.MaskBelowGroundOff()  # the clip filters do not all leave hidden cells out
    grid.Update()
    return grid.GetOutput()


def waves(p):
    return np.sin(9 * p[:, 0]) + np.cos(7 * p[:, 1] + p[:, 2]) * np.sin(5 * p[:, 2])


def block(n):
    return meshes.with_field(meshes.image((n,) * 3, (1 / n,) * 3), waves)


def tetrahedra(data):
    made = vtkDataSetTriangleFilter()
    made.SetInputData(data)
    made.Update()
    return made.GetOutput()


def triangles(parts):
    """Triangles of all faces as places (numbers of distinct points), and the coordinates of the places."""
    points, rows, shift = [], [], 0
    for part in parts:
        places = meshes.points_of(part)
        points.append(places)
        rows.append((part, shift))
        shift += len(places)
    places, number = np.unique(np.round(np.vstack(points), 7), axis=0, return_inverse=True)
    result = []
    for part, first in rows:
        types = np.array([part.GetCellType(i) for i in range(part.GetNumberOfCells())])
        connectivity, offsets = cells_of(part)
        for kind, faces in FACES.items():
            starts = offsets[:-1][types == kind]
            for face in faces:
                ids = number.ravel()[first + connectivity[starts[:, None] + np.array(face)]]
                result.append(fan(ids))
    return np.vstack(result), places


def cells_of(part):
    if hasattr(part, "GetCells"):
        cells = part.GetCells()
        return vtk_to_numpy(cells.GetConnectivityArray()), vtk_to_numpy(cells.GetOffsetsArray())
    ids = [[part.GetCell(i).GetPointId(k) for k in range(8)] for i in range(part.GetNumberOfCells())]
    return np.ravel(ids), np.arange(0, 8 * len(ids) + 1, 8)


def fan(ids):
    """Polygons (n, 3 or 4) of places, which are numbered by x, then y, then z: triangles from the least corner."""
    least = ids.argmin(axis=1)
    turned = np.take_along_axis(ids, (least[:, None] + np.arange(ids.shape[1])) % ids.shape[1], axis=1)
    return np.vstack([turned[:, [0, k, k + 1]] for k in range(1, ids.shape[1] - 1)])


def open_faces(parts):
    """Triangles inside the unit cube that only one cell has."""
    faces, places = triangles(parts)
    faces = np.sort(faces, axis=1)
    faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2])]
    unique, count = np.unique(faces, axis=0, return_counts=True)
    corners = places[unique[count % 2 == 1]]
    on_side = [(np.abs(corners[:, :, axis] - side) < 1e-6).all(axis=1) for axis in range(3) for side in (0, 1)]
    return int((~np.any(on_side, axis=0)).sum())


def volume(parts):
    total = 0
    for part in parts:
        sizes = vtkCellSizeFilter()
        sizes.SetInputData(part)
        sizes.Update()
        total += np.abs(vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))).sum()
    return total


def run(name, data, array, values, small=False):
    """small: the slowest peer too, and whether the cells fit."""
    reference, exact = None, volume([data])
    for method, function in METHODS.items():
        if method == "vtkClipDataSet" and not small:
            continue
        start = time.process_time(), time.time()
        parts = function(data, array, values)
        seconds, wall = time.process_time() - start[0], time.time() - start[1]
        reference = reference or seconds
        cells = sum(p.GetNumberOfCells() for p in parts)
        error = f"{abs(volume(parts) / exact - 1):.0e}"
        faces = str(open_faces(parts)) if small else ""
        print(f"| {name} | {method} | {seconds:.2f} | {wall:.2f} | {seconds / reference:.1f} | {cells} | {error} | {faces} |", flush=True)


def main():
    print("| data | filter | processor s | wall s | ratio | cells | error of the volume | open faces |")
    print("|---|---|---|---|---|---|---|---|")
    run("image 16³, 3 values", block(16), "s", [-0.6, 0.1, 0.7], small=True)
    run("its tetrahedra", tetrahedra(block(16)), "s", [-0.6, 0.1, 0.7], small=True)
    run("image 64³, 4 values", block(64), "s", [-0.9, -0.3, 0.2, 0.8])
    run("GFS globe, 3 values", globe(), "cloud_fraction", [0.25, 0.5, 0.75])


main()
