# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What every split grid must satisfy, from its points and cells alone: volume, orientation, faces, layers, surfaces."""
from collections import defaultdict

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (VTK_HEXAGONAL_PRISM, VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_PYRAMID, VTK_QUAD, VTK_TETRA, VTK_TRIANGLE,
                                           VTK_VOXEL, VTK_WEDGE, vtkDataObject)

# Faces as VTK documents them, seen from outside counter-clockwise.
FACES = {
    VTK_TETRA: [(0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1)],
    VTK_HEXAHEDRON: [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)],
    VTK_VOXEL: [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)],
    VTK_WEDGE: meshes.wedge_faces(),
    VTK_HEXAGONAL_PRISM: [(0, 5, 4, 3, 2, 1), (6, 7, 8, 9, 10, 11), (0, 1, 7, 6), (1, 2, 8, 7), (2, 3, 9, 8), (3, 4, 10, 9),
                          (4, 5, 11, 10), (5, 0, 6, 11)],
    VTK_PYRAMID: [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
}


def split(data, values, array="s", expect=(), setup=None, **settings):
    """The filter, run; its messages must be those expected (parts of the texts, in order)."""
    made = nephoscope.vtkContourCellSplitter()
    made.SetInputDataObject(data)
    made.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        made.SetValue(i, value)
    if array:
        made.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, array)
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    if setup:
        setup(made)
    with Messages() as messages:
        made.Update()
    texts = messages.all
    if len(texts) != len(expect) or any(part not in text for part, text in zip(expect, texts)):
        raise AssertionError(f"expected messages {expect}, got {texts}")
    return made.GetOutputDataObject(0)


def cross(a, b):
    """numpy.cross of rows, without its cost for few of them."""
    return a[:, [1, 2, 0]] * b[:, [2, 0, 1]] - a[:, [2, 0, 1]] * b[:, [1, 2, 0]]


class Cells:
    """The cells of a dataset as numpy: types, lists of points, coordinates."""

    def __init__(self, data):
        self.data = data
        self.points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())]).reshape(-1, 3)
        self.places = np.unique(self.points, axis=0, return_inverse=True)[1].ravel()  # where points coincide, one number
        self.types = np.array([data.GetCellType(i) for i in range(data.GetNumberOfCells())], int)
        self.ids, self.faces = [], []
        for i, kind in enumerate(self.types):
            cell = data.GetCell(i)
            ids = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
            self.ids.append(ids)
            if kind == VTK_POLYHEDRON:
                loops = [[f.GetPointId(k) for k in range(f.GetNumberOfPoints())]
                         for f in (cell.GetFace(j) for j in range(cell.GetNumberOfFaces()))]
            elif kind in FACES:
                loops = [[ids[k] for k in face] for face in FACES[kind]]
            else:
                loops = [ids]
            self.faces.append([self.without_repeats(loop) for loop in loops])
        self.fans = {}  # of faces
        self.solid = np.array([k not in (VTK_TRIANGLE, VTK_QUAD) for k in self.types], bool)

    def array(self, name, points=False):
        attributes = self.data.GetPointData() if points else self.data.GetCellData()
        return vtk_to_numpy(attributes.GetArray(name))

    def without_repeats(self, loop):
        return [p for k, p in enumerate(loop) if self.places[p] not in self.places[loop[:k]]]

    def fan(self, face):
        """Triangles of a face from its least vertex by x, then y, then z, that has no flat one: the filter's documented rule."""
        known = self.fans.get(tuple(face))
        if known is None:
            known = self.fans[tuple(face)] = self.new_fan(face)
        return known

    def new_fan(self, face):
        if len(face) < 4:
            return [tuple(face)] if len(face) == 3 else []
        fans = []
        for start in sorted(range(len(face)), key=lambda k: tuple(self.points[face[k]])):
            loop = face[start:] + face[:start]
            fans.append([(loop[0], b, c) for b, c in zip(loop[1:], loop[2:])])
            a, b, c = self.points[np.array(fans[-1]).reshape(-1, 3).T]
            areas, *sides = (np.einsum("ij,ij->i", n, n) for n in (cross(b - a, c - a), b - a, c - a))
            if (areas > 1e-16 * sides[0] * sides[1]).all():
                return fans[-1]
        return fans[0]

    def volumes(self):
        """Signed volume of each 3-D cell with faces cut by the rule (divergence theorem, from the cell's first point)."""
        parts = [(i, self.ids[i][0], *triangle) for i in np.flatnonzero(self.solid) for face in self.faces[i] for triangle in self.fan(face)]
        cell, *corners = np.array(parts, int).reshape(-1, 5).T
        origin, a, b, c = (self.points[corner] for corner in corners)
        return np.bincount(cell, np.einsum("ij,ij->i", a - origin, cross(b - origin, c - origin)) / 6, len(self.types))

    def key(self, face):
        return tuple(sorted(self.places[list(face)]))

    def face_map(self, triangles):
        """{sorted places: [cell]} over the faces of all 3-D cells; triangles: each face cut by the rule."""
        found = defaultdict(list)
        for i in np.flatnonzero(self.solid):
            for face in self.faces[i]:
                for part in (self.fan(face) if triangles else [face]):
                    if len(set(self.key(part))) > 2:
                        found[self.key(part)].append(i)
        return found


def area_of(cells, triangles):
    """Area of triangles given by places."""
    place = np.zeros((cells.places.max() + 1, 3))
    place[cells.places] = cells.points
    a, b, c = np.moveaxis(place[np.array(triangles)], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def check_split(test, data, values, array="s", whole=None, **options):
    """Splits and checks all invariants; returns the Cells of the output."""
    out = Cells(split(data, values, array, **options))
    before = Cells(data)
    check_volumes(test, before, out)
    check_sides(test, before, out, values, array)
    check_cuts(test, before, out, values, array)
    check_faces(test, before, out)
    check_surfaces(test, out, values, array)
    return out


def check_volumes(test, before, out):
    expected = np.abs(before.volumes())
    got = out.volumes()
    scale = np.abs(got[out.solid]).max()
    changed = np.flatnonzero(out.solid & (np.bincount(out.array("Source"), out.solid)[out.array("Source")] > 1))
    test.assertGreater(len(changed), 0, "no cell has been divided")
    test.assertGreater(got[changed].min(), 0, f"an inverted or flat piece; the largest is {scale}")
    pieces = np.bincount(out.array("Source"), np.abs(got), minlength=len(expected))
    np.testing.assert_allclose(pieces, expected, rtol=1e-12, atol=1e-12 * expected.max())
    test.assertLess(abs(pieces.sum() - expected.sum()), 1e-12 * expected.sum())


def check_sides(test, before, out, values, array):
    distinct = np.array(sorted(set(values)))
    s, layers = out.array(array, points=True), out.array("Layer")
    bounds = np.concatenate([[-np.inf], distinct, [np.inf]])
    s_in = before.array(array, points=True)
    for i in np.flatnonzero(out.solid):
        low, high = s[out.ids[i]].min(), s[out.ids[i]].max()
        test.assertTrue(bounds[layers[i]] <= low and high <= bounds[layers[i] + 1], (i, layers[i], low, high))
        test.assertEqual(layers[i], np.sum(distinct < high))
        source = out.array("Source")[i]
        crossed = [v for v in distinct if s_in[before.ids[source]].min() < v < s_in[before.ids[source]].max()]
        if not crossed:
            test.assertEqual(out.types[i], before.types[source])
            if out.types[i] != VTK_POLYHEDRON:
                test.assertEqual(out.ids[i], before.ids[source])


def check_cuts(test, before, out, values, array):
    """Points of the input stay; all others lie on a value, each in a place of its own."""
    n = len(before.points)
    np.testing.assert_array_equal(out.points[:n], before.points)
    s = out.array(array, points=True)
    np.testing.assert_array_equal(s[:n], before.array(array, points=True))
    used = np.unique(np.concatenate([out.ids[i] for i in range(len(out.ids))]))
    new = used[used >= n]
    on_value = np.isin(s[new], values)
    centres = len(out.points) - n - on_value.sum()
    test.assertEqual(len(new), len(out.points) - n, "points that no cell uses")
    if len(np.unique(before.places)) == n:
        test.assertEqual(len(np.unique(out.points[n:], axis=0)), len(out.points) - n, "a cut comes twice")
    out.centres = centres


def check_faces(test, before, out):
    """Each triangle of a face belongs to two cells or to the boundary; the boundary is that of the input, split."""
    faces, faces_before = out.face_map(True), before.face_map(True)
    count = np.array([len(c) for c in faces.values()])
    test.assertTrue(np.isin(count, (1, 2)).all(), np.bincount(count))
    boundary = [f for f, cells in faces.items() if len(cells) == 1]
    boundary_before = [f for f, cells in faces_before.items() if len(cells) == 1]
    total, expected = area_of(out, boundary), area_of(before, boundary_before)
    test.assertLess(abs(total - expected), 1e-12 * expected, "cracks: the boundary has another area")
    # Between divided cells even the faces themselves are the same, quadrilaterals too.
    divided = np.bincount(out.array("Source"), out.solid)[out.array("Source")] > 1
    for face, cells in out.face_map(False).items():
        if len(cells) == 1 and divided[cells[0]] and len(face) == 4:
            loop = next(f for f in out.faces[cells[0]] if out.key(f) == face)
            across = {c for part in out.fan(loop) for c in faces[out.key(part)]} - {cells[0]}
            test.assertFalse(any(divided[c] for c in across), "a quadrilateral lies beside two triangles of divided cells")


def check_surfaces(test, out, values, array):
    """Polygons lie on their value, between a piece below and one above, and face the latter."""
    s, contour, layers = out.array(array, points=True), out.array("ContourIndex"), out.array("Layer")
    distinct = sorted(set(values))
    faces = {**out.face_map(False), **out.face_map(True)}  # a triangle may be half of a whole cell's quadrilateral
    test.assertTrue((contour[out.solid] == -1).all())
    for i in np.flatnonzero(~out.solid):
        value = values[contour[i]]
        test.assertTrue((s[out.ids[i]] == value).all(), "not on the value")
        test.assertEqual(layers[i], distinct.index(value))
        cells = faces[out.key(out.ids[i])]
        normal = np.cross(*(out.points[out.ids[i]][1:3] - out.points[out.ids[i]][0]))
        sides = [(layers[c] > layers[i], np.sign((out.points[out.ids[c]].mean(axis=0) - out.points[out.ids[i]].mean(axis=0)) @ normal))
                 for c in cells]
        test.assertIn((True, 1), sides, "a polygon does not face the higher scalars")
        if not all(higher for higher, _ in sides):  # a sheet on which the scalar is least has higher ones on both sides
            test.assertTrue(all(side == (1 if higher else -1) for higher, side in sides), sides)
