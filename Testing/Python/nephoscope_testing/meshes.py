# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of every cell type, with the point array or cell array "s"."""
import itertools

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_PYRAMID, VTK_TETRA, VTK_VOXEL, VTK_WEDGE,
                                           vtkCellArray, vtkImageData, vtkPointSet, vtkPolyData, vtkRectilinearGrid, vtkStructuredGrid,
                                           vtkUnstructuredGrid, vtkWedge)
from vtkmodules.vtkFiltersCore import vtkDelaunay3D


def vtk_points(points):
    result = vtkPoints()
    result.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    return result


def add_array(attributes, values, name="s"):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def grid(points, cells):
    """cells: (cell type, point ids) pairs."""
    result = vtkUnstructuredGrid()
    result.SetPoints(vtk_points(points))
    for kind, ids in cells:
        result.InsertNextCell(kind, len(ids), [int(i) for i in ids])
    return result


def particles(points):
    """Points without cells."""
    result = vtkPolyData()
    result.SetPoints(vtk_points(points))
    return result


def surface(points, polygons):
    result = particles(points)
    cells = vtkCellArray()
    for ids in polygons:
        cells.InsertNextCell(len(ids), [int(i) for i in ids])
    result.SetPolys(cells)
    return result


def points_of(data):
    if isinstance(data, vtkPointSet):
        return vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def with_field(data, function, association="point"):
    """Adds "s" = function(points or cell centres); returns the data set."""
    points = points_of(data)
    if association == "point":
        add_array(data.GetPointData(), np.asarray(function(points), float))
        return data
    centers = [points[[c.GetPointId(k) for k in range(c.GetNumberOfPoints())]].mean(axis=0)
               for c in (data.GetCell(i) for i in range(data.GetNumberOfCells()))]
    add_array(data.GetCellData(), np.asarray(function(np.array(centers)), float))
    return data


def linear_field(rng, data):
    """A linear function of place with values 0 to 1 over the data set's points."""
    gradient = rng.normal(size=3)
    values = points_of(data) @ gradient
    low, high = values.min(), values.max()
    return lambda p: (p @ gradient - low) / (high - low)


def tetrahedra(points, cells):
    return grid(points, [(VTK_TETRA, c) for c in cells])


def delaunay(rng, count, points=None):
    """Tetrahedra of random points in a ball: a convex mesh. Slivers of no volume are left out."""
    if points is None:
        points = rng.normal(size=(count, 3))
        points *= (rng.uniform(0.05, 1, count) ** (1 / 3) / np.linalg.norm(points, axis=1))[:, None]
    cloud = grid(points, [])
    mesher = vtkDelaunay3D()
    mesher.SetInputData(cloud)
    mesher.SetTolerance(1e-6)
    mesher.Update()
    mesh = mesher.GetOutput()
    cells = []
    for i in range(mesh.GetNumberOfCells()):
        if mesh.GetCellType(i) == VTK_TETRA:
            cells.append([mesh.GetCell(i).GetPointId(k) for k in range(4)])
    return tetrahedra(points_of(mesh), cells)


HEXAHEDRON = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


def wedge_faces():
    """The faces of a wedge from outside, counter-clockwise, as this VTK has them: 9.7 turned the order of the points."""
    wedge = vtkWedge()
    for i in range(6):
        wedge.GetPointIds().SetId(i, i)
    return [tuple(wedge.GetFace(i).GetPointId(k) for k in range(wedge.GetFace(i).GetNumberOfPoints())) for i in range(5)]


def turned_wedges(data):
    """The same wedges with their points in the other order: that of files written before VTK 9.7, or after."""
    turned = grid(points_of(data), [(VTK_WEDGE, [data.GetCell(i).GetPointId(k) for k in (0, 2, 1, 3, 5, 4)])
                                    for i in range(data.GetNumberOfCells())])
    turned.GetPointData().ShallowCopy(data.GetPointData())
    turned.GetCellData().ShallowCopy(data.GetCellData())
    return turned


class Lattice:
    """n x n x n (or three numbers) blocks of [0,1]^3, with the cells of a chosen kind."""

    def __init__(self, blocks):
        self.blocks = tuple(blocks) if np.ndim(blocks) else (blocks,) * 3
        axes = [np.arange(n + 1) / n for n in self.blocks]
        z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
        self.points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])

    def ids(self, block):
        nx, ny = self.blocks[0] + 1, self.blocks[1] + 1
        return [(block[0] + i) + nx * ((block[1] + j) + ny * (block[2] + k)) for i, j, k in HEXAHEDRON]

    def all_blocks(self):
        return [b[::-1] for b in itertools.product(*(range(n) for n in self.blocks[::-1]))]

    def mesh(self, kind, warp=None):
        """kind: a cell type's name, or "mixed" (by turns hexahedra, wedges and pyramids)."""
        points, cells, extra = self.points, [], []
        for number, block in enumerate(self.all_blocks()):
            ids = self.ids(block)
            chosen = ("hexahedron", "wedge")[number % 2] if kind == "mixed" else kind
            if chosen == "pyramid":
                extra.append(points[ids].mean(axis=0))
                center = len(points) + len(extra) - 1
                cells += [(VTK_PYRAMID, [ids[k] for k in face] + [center]) for face in HEX_FACES]
            else:
                cells += SPLITS[chosen](ids)
        if extra:
            points = np.vstack([points, extra])
        return grid(warp(points) if warp else points, cells)


HEX_FACES = ((0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))
KUHN = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
SPLITS = {
    "hexahedron": lambda i: [(VTK_HEXAHEDRON, i)],
    "voxel": lambda i: [(VTK_VOXEL, [i[0], i[1], i[3], i[2], i[4], i[5], i[7], i[6]])],
    "wedge": lambda i: [(VTK_WEDGE, [i[0], i[1], i[2], i[4], i[5], i[6]]), (VTK_WEDGE, [i[0], i[2], i[3], i[4], i[6], i[7]])],
    "tetra": lambda i: [(VTK_TETRA, [i[k] for k in t]) for t in KUHN],
}


def projective(rng, strength=0.3):
    """A map that keeps planes plane: affine, then a mild perspective."""
    matrix = np.eye(3) + rng.uniform(-strength, strength, (3, 3))
    tilt = rng.uniform(-strength, strength, 3)

    def warp(p):
        p = (p - 0.5) @ matrix.T
        return p / (1 + p @ tilt)[:, None]
    return warp


def wobble(rng, amount):
    """Inner and outer points moved at random: the faces of hexahedra become non-planar."""
    return lambda p: p - 0.5 + rng.uniform(-amount, amount, p.shape)


def shell(longitudes=24, latitudes=12, layers=3, radii=(1.0, 1.3), top=80.0):
    """Tetrahedra of a longitude-latitude shell between +-top degrees, closed in longitude."""
    points, index = [], {}
    for k, j, i in itertools.product(range(layers + 1), range(latitudes + 1), range(longitudes)):
        lat = np.radians(-top + 2 * top * j / latitudes)
        lon, r = 2 * np.pi * i / longitudes, radii[0] + (radii[1] - radii[0]) * k / layers
        index[i, j, k] = len(points)
        points.append(r * np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)]))
    cells = []
    for k, j, i in itertools.product(range(layers), range(latitudes), range(longitudes)):
        ids = [index[(i + a) % longitudes, j + b, k + c] for a, b, c in HEXAHEDRON]
        cells += SPLITS["tetra"](ids)
    return grid(np.array(points), cells)


def polyhedron(points, faces):
    """One VTK_POLYHEDRON from corner points and face loops."""
    result = vtkUnstructuredGrid()
    result.SetPoints(vtk_points(points))
    stream = vtkIdList()
    stream.InsertNextId(len(faces))
    for face in faces:
        stream.InsertNextId(len(face))
        for i in face:
            stream.InsertNextId(int(i))
    result.InsertNextCell(VTK_POLYHEDRON, stream)
    return result


def image(blocks, spacing=(1, 1, 1), origin=(0, 0, 0)):
    result = vtkImageData()
    result.SetDimensions(*(n + 1 for n in blocks))
    result.SetSpacing(*spacing)
    result.SetOrigin(*origin)
    return result


def rectilinear(axes):
    result = vtkRectilinearGrid()
    result.SetDimensions(*(len(a) for a in axes))
    for a, name in zip(axes, "XYZ"):
        getattr(result, f"Set{name}Coordinates")(numpy_to_vtk(np.asarray(a, float), deep=True))
    return result


def structured(blocks, warp):
    lattice = Lattice(blocks)
    result = vtkStructuredGrid()
    result.SetDimensions(*(n + 1 for n in lattice.blocks))
    result.SetPoints(vtk_points(warp(lattice.points)))
    return result


BOX = lambda p: 2 * p - 1  # noqa: E731
BOXES = {  # the box from -1 to 1 in cells of each kind
    "image": lambda: image((4, 4, 4), (0.5,) * 3, (-1, -1, -1)),
    "grid": lambda: structured(3, BOX),
    "hexahedra": lambda: Lattice(3).mesh("hexahedron", BOX),
    "wedges": lambda: Lattice(3).mesh("wedge", BOX),
    "tetrahedra": lambda: Lattice(3).mesh("tetra", BOX),
}


def renumbered(mesh, rng):
    """The same mesh with cells, points and the corners within each tetrahedron in another order."""
    points = points_of(mesh)
    order = rng.permutation(len(points))
    place = np.argsort(order)
    cells = []
    for i in rng.permutation(mesh.GetNumberOfCells()):
        ids = [mesh.GetCell(i).GetPointId(k) for k in range(mesh.GetCell(i).GetNumberOfPoints())]
        cells.append((mesh.GetCellType(i), place[rng.permutation(ids) if len(ids) == 4 else ids]))
    result = grid(points[order], cells)
    if mesh.GetPointData().GetArray("s"):
        add_array(result.GetPointData(), vtk_to_numpy(mesh.GetPointData().GetArray("s"))[order])
    return result


def triangles_of(polydata):
    """(n,3,3) corner points."""
    points = points_of(polydata)
    return np.array([points[[polydata.GetCell(i).GetPointId(k) for k in range(3)]]
                     for i in range(polydata.GetNumberOfCells())])
