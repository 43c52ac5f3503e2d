# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex cells as half-spaces with one linear field each: what a ray is clipped against."""
from collections import Counter
from itertools import combinations

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_EMPTY_CELL, VTK_HEXAHEDRON, VTK_VOXEL

from .crossings import dot

HIDDEN_CELL, DUPLICATE_CELL, REFINED_CELL, HIDDEN_POINT = 32, 1, 8, 2


class Polyhedra:
    """corners: list of (k,3) arrays; faces: list of lists of index loops into them; gradient, offset: the field."""

    def __init__(self, corners, faces, scalars, face_keys=None):
        self.corners = corners
        self.faces = faces
        self.field = [_linear_field(c, s) for c, s in zip(corners, scalars)]
        self.gradients, self.offsets = np.array([f[0] for f in self.field]).reshape(-1, 3), np.array([f[1] for f in self.field])
        self.planes = _planes(corners, faces)
        self.face_keys = face_keys

    def __len__(self):
        return len(self.corners)

    def transformed(self, matrix):
        """The same cells with their points moved by a 4x4 matrix; the field goes along with the points."""
        m = np.asarray(matrix, float)
        moved = [c @ m[:3, :3].T + m[:3, 3] for c in self.corners]
        values = [c @ g + o for c, (g, o) in zip(self.corners, self.field)]
        return Polyhedra(moved, self.faces, values, self.face_keys)

    def boundary_edges(self):
        """(n,2,3): edges of the faces that only one cell has."""
        count = Counter(key for keys in self.face_keys for key in keys)
        edges = []
        for corners, faces, keys in zip(self.corners, self.faces, self.face_keys):
            for face, key in zip(faces, keys):
                if count[key] == 1:
                    edges += [(corners[a], corners[b]) for a, b in zip(face, face[1:] + face[:1])]
        return np.array(edges).reshape(-1, 2, 3)


    def drawn_edges(self):
        """(n,2,3): edges of the tetrahedra that the cells are divided into, each once."""
        edges = set()
        for corners, faces in zip(self.corners, self.faces):
            places = [tuple(c) for c in corners]
            parts = [range(4)] if len(corners) == 4 else cone(corners, faces)
            for part in parts:
                edges |= {tuple(sorted((places[a], places[b]))) for a, b in combinations(part, 2)}
        return np.array(sorted(edges)).reshape(-1, 2, 3)


def _planes(corners, faces):
    """For each cell, rows (n, c) with n.x <= c inside, whatever way its faces were wound. Faces without area are left out."""
    cells = np.repeat(np.arange(len(faces)), [len(loops) for loops in faces])
    loops = [corners[i][loop] for i, loop in zip(cells, (loop for of_cell in faces for loop in of_cell))]
    inside = np.array([c.mean(axis=0) for c in corners]).reshape(-1, 3)[cells]
    rows, kept = np.zeros((len(loops), 4)), np.zeros(len(loops), bool)
    sizes = np.array([len(loop) for loop in loops], int)
    for size in np.unique(sizes):
        alike = np.nonzero(sizes == size)[0]
        points = np.array([loops[k] for k in alike])
        p = points - points[:, :1]
        normal = np.cross(p, np.roll(p, -1, axis=1)).sum(axis=1)  # Newell
        length = np.linalg.norm(normal, axis=1)
        kept[alike] = length > 1e-14 * np.abs(p).max(axis=(1, 2)) ** 2
        normal /= np.where(length > 0, length, 1)[:, None]
        c = dot(normal, points.mean(axis=1))
        outward = np.where(dot(normal, inside[alike]) <= c, 1.0, -1.0)
        rows[alike] = np.column_stack([normal, c]) * outward[:, None]
    ends = np.searchsorted(cells, np.arange(len(faces) + 1))
    return [rows[a:b][kept[a:b]] for a, b in zip(ends, ends[1:])]


def _linear_field(corners, values):
    """Gradient and offset; refuses a field that is not linear over the cell."""
    values = np.asarray(values, float)
    if np.ptp(values) == 0:
        return np.zeros(3), values[0]
    middle = corners.mean(axis=0)
    system = np.column_stack([corners - middle, np.ones(len(corners))])
    solution = np.linalg.lstsq(system, values, rcond=None)[0]
    residual = np.abs(system @ solution - values).max()
    if residual > 1e-6 * np.ptp(values):
        raise ValueError(f"the field is not linear in this cell (residual {residual:g})")
    return solution[:3], solution[3] - solution[:3] @ middle


def _scalars(dataset, name, association):
    attributes = dataset.GetPointData() if association == "point" else dataset.GetCellData()
    return vtk_to_numpy(attributes.GetArray(name)).astype(float)


def _hidden(dataset):
    ghosts = dataset.GetCellData().GetArray("vtkGhostType")
    hidden = np.zeros(dataset.GetNumberOfCells(), bool)
    if ghosts:
        hidden |= (vtk_to_numpy(ghosts) & (HIDDEN_CELL | DUPLICATE_CELL | REFINED_CELL)) != 0
    return hidden


def from_dataset(dataset, name="s", association="point", decompose=False):
    """The 3-D cells of any vtkDataSet. decompose: divide every cell into tetrahedra first (non-planar faces): hexahedra as the squares of
    a chessboard where all cells are hexahedra that can be coloured so, others as cones. "cones": all of them as cones."""
    values, hidden = _scalars(dataset, name, association), _hidden(dataset)
    odd = chessboard(dataset) if decompose is True else None
    corners, faces, scalars, keys = [], [], [], []
    for i in range(dataset.GetNumberOfCells()):
        cell = dataset.GetCell(i)
        if cell.GetCellDimension() != 3 or hidden[i]:
            continue
        ids, loops = _cell_faces(cell)
        points = np.array([dataset.GetPoint(p) for p in ids])
        s = values[ids] if association == "point" else np.full(len(ids), values[i])
        parts = [None] if not decompose else cone(points, loops) if odd is None else by_colors([odd[k] for k in ids], loops)
        for part in parts:
            take = list(range(len(ids))) if part is None else list(part)
            local = loops if part is None else [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]
            corners.append(points[take])
            faces.append(local)
            scalars.append(s[take])
            keys.append([tuple(sorted(ids[take[v]] for v in loop)) for loop in local])
    return Polyhedra(corners, faces, scalars, keys)


def _cell_faces(cell):
    ids = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
    where = {p: k for k, p in enumerate(ids)}
    loops = []
    for f in range(cell.GetNumberOfFaces()):
        face = cell.GetFace(f)
        loop = [where[face.GetPointId(k)] for k in range(face.GetNumberOfPoints())]
        if face.GetClassName() == "vtkPixel":  # a pixel's points go row by row, not around
            loop = [loop[0], loop[1], loop[3], loop[2]]
        loops.append(loop)
    return ids, loops


def _edges(cell):
    for e in range(cell.GetNumberOfEdges()):
        ids = cell.GetEdge(e).GetPointIds()
        yield ids.GetId(0), ids.GetId(1)


def _spread(color, neighbors, start):
    """Colours what is connected to `start`, whose colour is known. False where one point would need both colours."""
    waiting, fits = [start], True
    while waiting:
        point = waiting.pop()
        for other, change in neighbors.get(point, ()):
            if other not in color:
                color[other] = color[point] ^ change
                waiting.append(other)
            fits &= color[other] == color[point] ^ change
    return fits


def chessboard(dataset):
    """For each point of a mesh of hexahedra and voxels 0 or 1, another at the other end of each edge, 0 at the first of each part; where
    parts repeat their points, equal colours at equal places. None: other cells, or there are no such colours."""
    cells = [dataset.GetCell(i).GetCellType() for i in range(dataset.GetNumberOfCells())]
    if any(kind not in (VTK_EMPTY_CELL, VTK_HEXAHEDRON, VTK_VOXEL) for kind in cells):
        return None
    neighbors = {}
    for i, kind in enumerate(cells):
        for a, b in _edges(dataset.GetCell(i)) if kind != VTK_EMPTY_CELL else ():
            neighbors.setdefault(a, set()).add((b, 1))
            neighbors.setdefault(b, set()).add((a, 1))
    color, parts = {}, 0
    for point in sorted(neighbors):
        if point not in color:
            color[point] = 0
            parts += 1
            if not _spread(color, neighbors, point):
                return None
    if parts > 1:
        where = {}
        for point in sorted(neighbors):
            first = where.setdefault(dataset.GetPoint(point), point)
            neighbors[point].add((first, 0))
            neighbors[first].add((point, 0))
        color = {}
        for point in sorted(neighbors):
            if point not in color:
                color[point] = 0
                _spread(color, neighbors, point)
    return color


def by_colors(odd, loops):
    """The tetrahedron of a hexahedron's four even vertices, and one at each odd vertex with the three next to it."""
    yield tuple(k for k in range(8) if not odd[k])
    for k in range(8):
        if odd[k]:
            yield (k, *sorted({n for loop in loops if k in loop for n in (loop[loop.index(k) - 1], loop[(loop.index(k) + 1) % len(loop)])}))


def cone(points, loops):
    """Tetrahedra (indices) of a cell coned from its lexicographically smallest corner, each face fanned from its own."""
    first = lambda ids: min(ids, key=lambda k: tuple(points[k]))
    apex = first(range(len(points)))
    for loop in loops:
        if apex in loop:
            continue
        start = loop.index(first(loop))
        fan = loop[start:] + loop[:start]
        for a, b in zip(fan[1:], fan[2:]):
            yield apex, fan[0], a, b
