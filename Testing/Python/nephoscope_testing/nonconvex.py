# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polyhedra that are not convex, with the volumes that closed forms give; and what any division into tetrahedra must fulfil."""
from collections import Counter

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, VTK_TETRA, vtkUnstructuredGrid

from .meshes import points_of, vtk_points

L_POLYGON = ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
U_POLYGON = ((0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2))
C_POLYGON = ((0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (0, 3))
PLUS_POLYGON = ((1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1))
STAR_POLYGON = tuple((r * np.cos(a), r * np.sin(a)) for r, a in zip((1, 0.4) * 5, np.pi / 5 * np.arange(10)))
SPIRAL_POLYGON = ((0, 0), (5, 0), (5, 5), (1, 5), (1, 2), (3, 2), (3, 3), (2, 3), (2, 4), (4, 4), (4, 1), (0, 1))


def polygon_area(polygon):
    x, y = np.transpose(polygon)
    return 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))


def prism(polygon, height=1.0):
    """(points, faces, volume) of the right prism over a polygon."""
    n = len(polygon)
    points = np.array([(x, y, z) for z in (0, height) for x, y in polygon], float)
    faces = [list(range(n))[::-1], list(range(n, 2 * n))]
    faces += [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    return points, faces, polygon_area(polygon) * height


def schonhardt(twist=30.0, height=1.5):
    """A triangular prism whose top is turned so that the diagonals of its sides are reflex: no diagonal lies inside, so
    that no tetrahedra without a new point fill it (Schonhardt1928)."""
    angles = np.radians(np.array([0, 120, 240]))
    lower = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(3)])
    turned = angles + np.radians(twist)
    upper = np.column_stack([np.cos(turned), np.sin(turned), np.full(3, height)])
    faces = [[2, 1, 0], [3, 4, 5]]
    for k in range(3):
        a, b, c, d = k, (k + 1) % 3, 3 + (k + 1) % 3, 3 + k
        faces += [[a, b, d], [b, c, d]]
    # The side's diagonal must be the one that the twist bends inwards.
    points = np.vstack([lower, upper])
    if volume_of(points, faces) > volume_of(points, _other_diagonals(faces)):
        faces = _other_diagonals(faces)
    return points, faces, volume_of(points, faces)


def _other_diagonals(faces):
    sides = []
    for first, second in zip(faces[2::2], faces[3::2]):
        a, b, d = first
        c = second[1]
        sides += [[a, b, c], [a, c, d]]
    return faces[:2] + sides


def tower(floors=2):
    """Schonhardt's polyhedron on its mirror image, and so on: no point sees the whole inside, and every floor needs a new point."""
    points, faces, volume = schonhardt()
    height = points[:, 2].max()
    all_points, all_faces = [points[:3]], [faces[0]]
    for floor in range(floors):
        flip = floor % 2 == 1
        ring = points[:3] if flip else points[3:]
        all_points.append(np.column_stack([ring[:, :2], np.full(3, height * (floor + 1))]))
        for face in faces[2:]:
            # Even floors have the ring `lower` below, odd ones `upper` below.
            moved = [(v + 3 * floor if not flip else (v + 3 if v < 3 else v - 3) + 3 * floor) for v in face]
            all_faces.append(moved[::-1] if flip else moved)
    all_faces.append([v + 3 * floors for v in (0, 1, 2)])
    return np.vstack(all_points), all_faces, volume * floors


def frame(outer=3.0, hole=1.0, height=1.0, keyhole=False):
    """A square ring: a solid with a tunnel. keyhole: top and bottom are one polygon each, with a bridge to the hole."""
    o, h = outer / 2, hole / 2
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    points = np.array([(x, y, z) for z in (0, height) for s in (o, h) for x, y in square * s])
    ring = lambda z, inner: [8 * z + 4 * inner + k for k in range(4)]
    faces = []
    for z in (0, 1):
        a, b = ring(z, 0), ring(z, 1)
        if keyhole:
            loops = [[*a, a[0], b[0], b[3], b[2], b[1], b[0]]]
        else:
            loops = [[a[k], a[(k + 1) % 4], b[(k + 1) % 4], b[k]] for k in range(4)]
        faces += loops if z else [loop[::-1] for loop in loops]
    for inner in (0, 1):
        low, high = ring(0, inner), ring(1, inner)
        sides = [[low[k], low[(k + 1) % 4], high[(k + 1) % 4], high[k]] for k in range(4)]
        faces += [side[::-1] for side in sides] if inner else sides
    return points, faces, (outer ** 2 - hole ** 2) * height


def hollow(outer=3.0, inner=1.0):
    """A cube with a cubic cavity: two surfaces."""
    cube = np.array([(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
    sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    points = np.vstack([cube * outer / 2, cube * inner / 2])
    return points, sides + [[v + 8 for v in side] for side in sides], outer ** 3 - inner ** 3


def volume_of(points, faces):
    """By the divergence theorem, faces cut as fans from their first vertex and wound outward."""
    six = 0.0
    for face in faces:
        for a, b in zip(face[1:], face[2:]):
            six += np.linalg.det(points[[face[0], a, b]])
    return six / 6


def grid_of(points, cells):
    """cells: lists of faces, each a polyhedron."""
    result = vtkUnstructuredGrid()
    result.SetPoints(vtk_points(points))
    for faces in cells:
        stream = vtkIdList()
        stream.InsertNextId(len(faces))
        for face in faces:
            stream.InsertNextId(len(face))
            for i in face:
                stream.InsertNextId(int(i))
        result.InsertNextCell(VTK_POLYHEDRON, stream)
    return result


def tetrahedra_of(data):
    """(cell numbers, (n,4) point ids) of the tetrahedra."""
    cells = [i for i in range(data.GetNumberOfCells()) if data.GetCellType(i) == VTK_TETRA]
    ids = [[data.GetCell(i).GetPointId(k) for k in range(4)] for i in cells]
    return cells, np.array(ids, int).reshape(-1, 4)


def volumes(points, ids):
    """Signed, positive in VTK's order."""
    p = points[ids]
    return np.einsum("ij,ij->i", np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p[:, 3] - p[:, 0]) / 6


def open_faces(ids):
    """The triangles that only one tetrahedron has, and the number of those that more than two have."""
    count = Counter(tuple(sorted(t[list(f)])) for t in ids for f in ((1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2)))
    return [f for f, n in count.items() if n == 1], sum(n > 2 for n in count.values())


def winding_number(points, faces, where):
    """1 inside a closed surface, 0 outside: the solid angle of its triangles over 4 pi. faces wound outward."""
    total = np.zeros(len(where))
    for face in faces:
        for i, j in zip(face[1:], face[2:]):
            a, b, c = (points[k] - where for k in (face[0], i, j))
            la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
            dot = lambda x, y: np.einsum("ij,ij->i", x, y)
            total += 2 * np.arctan2(dot(np.cross(a, b), c), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)
    return total / (4 * np.pi)


def point_values(data, name="s"):
    return vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float)


def all_points(data):
    return points_of(data)
