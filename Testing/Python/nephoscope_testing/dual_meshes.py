# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polyhedral meshes as two codes have them: the dual of a tetrahedral mesh (OpenFOAM's polyDualMesh), and columns over the
Voronoi cells of a sphere (MPAS). Each is a list of cells, a cell a list of faces, a face a list of point numbers."""
import itertools
from collections import Counter, defaultdict

import numpy as np

from . import meshes, nonconvex

TRIANGLES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


class PolyhedralMesh:
    def __init__(self, points, cells, boundary):
        """boundary: the set of frozensets of points of the faces that only one cell has."""
        self.points, self.cells, self.boundary = np.asarray(points, float), cells, boundary

    def grid(self):
        return nonconvex.grid_of(self.points, self.cells)


def _is_boundary(cells):
    count = Counter(frozenset(face) for faces in cells for face in faces)
    return {face for face, n in count.items() if n == 1}


class _Numbering:
    """Points of the dual by what they are the middle of."""

    def __init__(self, points):
        self.primal, self.points, self.numbers = points, [], {}

    def middle(self, vertices):
        key = frozenset(vertices)
        if key not in self.numbers:
            self.numbers[key] = len(self.points)
            self.points.append(self.primal[list(vertices)].mean(axis=0))
        return self.numbers[key]


def _chain(links):
    """Segments (tetrahedron, c, d) around an edge, in order: (tetrahedra, first c, last d); the ends are equal inside."""
    at = defaultdict(list)
    for tetrahedron, c, d in links:
        at[c].append((tetrahedron, d))
        at[d].append((tetrahedron, c))
    ends = [v for v, l in at.items() if len(l) == 1]
    start = vertex = min(ends) if ends else min(at)
    order, used = [], set()
    while len(order) < len(links):
        tetrahedron, following = next((t, v) for t, v in at[vertex] if t not in used)
        used.add(tetrahedron)
        order.append(tetrahedron)
        vertex = following
    return order, start, vertex


def dual_of_tetrahedra(points, tetrahedra):
    """A cell per vertex, between the centroids of the tetrahedra; all boundary edges and vertices are kept, so that the
    domain stays the same. Centroids around an edge lie in no plane: the faces are warped."""
    dual = _Numbering(points)
    middles = [dual.middle(t) for t in tetrahedra]
    around = defaultdict(list)
    sides = Counter()
    for number, t in enumerate(tetrahedra):
        for i, j in itertools.combinations(range(4), 2):
            c, d = (t[k] for k in range(4) if k not in (i, j))
            around[frozenset((t[i], t[j]))].append((number, c, d))
        sides.update(frozenset(t[list(f)]) for f in TRIANGLES)
    cells = defaultdict(list)
    for edge, links in around.items():
        order, first, last = _chain(links)
        face = [middles[t] for t in order]
        if first != last:
            face = [dual.middle(edge), dual.middle(edge | {first}), *face, dual.middle(edge | {last})]
        for vertex in edge:
            cells[vertex].append(face)
    for side in (s for s, n in sides.items() if n == 1):
        for v in side:
            a, b = side - {v}
            cells[v].append([dual.middle({v}), dual.middle({v, a}), dual.middle(side), dual.middle({v, b})])
    cells = [cells[v] for v in sorted(cells)]
    return PolyhedralMesh(dual.points, cells, _is_boundary(cells))


def spread_points(rng, spacing, jitter):
    """Points of a unit ball: a body-centred lattice, moved by jitter * spacing, and points spread evenly over the sphere."""
    axis = np.arange(-np.ceil(1 / spacing), np.ceil(1 / spacing) + 1) * spacing
    lattice = np.stack(np.meshgrid(axis, axis, axis), -1).reshape(-1, 3)
    lattice = np.vstack([lattice, lattice + spacing / 2]) + rng.uniform(-jitter, jitter, (2 * len(lattice), 3)) * spacing
    inner = lattice[np.linalg.norm(lattice, axis=1) < 1 - 0.6 * spacing]
    count = int(4 * np.pi / (0.7 * spacing ** 2))
    z = 1 - (2 * np.arange(count) + 1) / count  # a golden spiral
    angle = np.pi * (1 + 5 ** 0.5) * np.arange(count)
    outer = np.column_stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z])
    return np.vstack([outer, inner])


def openfoam_like(rng, spacing=0.5, jitter=0.2):
    """The dual of a Delaunay mesh in a ball, and that mesh."""
    primal = meshes.delaunay(rng, 0, spread_points(rng, spacing, jitter))
    points = meshes.points_of(primal)
    _, tetrahedra = nonconvex.tetrahedra_of(primal)
    return dual_of_tetrahedra(points, tetrahedra), primal


def _icosphere(levels):
    g = (1 + 5 ** 0.5) / 2
    points = [np.array(p) / np.hypot(1, g) for a, b in itertools.product((-1, 1), (-g, g)) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    near = lambda a, b: np.linalg.norm(points[a] - points[b]) < 1.1
    triangles = [t for t in itertools.combinations(range(12), 3) if near(t[0], t[1]) and near(t[1], t[2]) and near(t[0], t[2])]
    for _ in range(levels):
        numbers, finer = {}, []

        def middle(a, b):
            key = frozenset((a, b))
            if key not in numbers:
                numbers[key] = len(points)
                m = points[a] + points[b]
                points.append(m / np.linalg.norm(m))
            return numbers[key]
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return np.array(points), triangles


def mpas_like(levels=2, layers=3, terrain=0.1, top=1.3, keep=lambda center: True):
    """Columns of prisms over the Voronoi cells (12 pentagons, else hexagons) of an icosahedral mesh of the unit sphere. The
    layers follow a terrain of so high mountains, so that floors and ceilings are curved. keep(centre): which columns."""
    centers, triangles = _icosphere(levels)
    corners = np.array([np.cross(centers[b] - centers[a], centers[c] - centers[a]) for a, b, c in triangles])
    corners *= np.sign(np.einsum("ij,ij->i", corners, centers[[t[0] for t in triangles]]))[:, None]
    corners /= np.linalg.norm(corners, axis=1)[:, None]
    ground = 1 + terrain * 0.5 * (1 + np.sin(5 * corners[:, 0] + 1) * np.cos(4 * corners[:, 1] - 7 * corners[:, 2]))
    radii = ground + np.linspace(0, 1, layers + 1)[:, None] * (top - ground)
    points = (radii[..., None] * corners).reshape(-1, 3)
    at = defaultdict(list)
    for number, triangle in enumerate(triangles):
        for v in triangle:
            at[v].append(number)
    cells = []
    for v in (v for v in range(len(centers)) if keep(centers[v])):
        u = np.cross(centers[v], (0.3, 0.5, 0.8))
        w = np.cross(centers[v], u)
        loop = sorted(at[v], key=lambda t: np.arctan2(corners[t] @ w, corners[t] @ u))
        for layer in range(layers):
            low, high = ([t + len(corners) * k for t in loop] for k in (layer, layer + 1))
            n = len(loop)
            cells.append([low[::-1], high] + [[low[k], low[(k + 1) % n], high[(k + 1) % n], high[k]] for k in range(n)])
    used = sorted({p for faces in cells for face in faces for p in face})
    number = {p: i for i, p in enumerate(used)}
    cells = [[[number[p] for p in face] for face in faces] for faces in cells]
    return PolyhedralMesh(points[used], cells, _is_boundary(cells))


def volume_between(mesh, is_outer):
    """The volume inside the boundary, every face of it cut as a fan from its least corner (by x, y, z) and wound so that
    is_outer(corners, normal) holds."""
    six = 0.0
    for faces in mesh.cells:
        for face in faces:
            if frozenset(face) not in mesh.boundary:
                continue
            corners = mesh.points[face]
            start = min(range(len(face)), key=lambda k: tuple(corners[k]))
            corners = np.roll(corners, -start, axis=0)
            normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
            sign = 1 if is_outer(corners, normal) else -1
            six += sign * sum(np.linalg.det([corners[0], a, b]) for a, b in zip(corners[1:], corners[2:]))
    return six / 6
