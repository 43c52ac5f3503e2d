# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex cells as half-spaces with one linear field each: what a ray is clipped against."""
from collections import Counter
from itertools import combinations

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

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
    """The 3-D cells of any vtkDataSet. decompose: cone every cell into tetrahedra first (non-planar faces)."""
    values, hidden = _scalars(dataset, name, association), _hidden(dataset)
    corners, faces, scalars, keys = [], [], [], []
    for i in range(dataset.GetNumberOfCells()):
        cell = dataset.GetCell(i)
        if cell.GetCellDimension() != 3 or hidden[i]:
            continue
        ids, loops = _cell_faces(cell)
        points = np.array([dataset.GetPoint(p) for p in ids])
        s = values[ids] if association == "point" else np.full(len(ids), values[i])
        for part in (cone(points, loops) if decompose else [None]):
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
