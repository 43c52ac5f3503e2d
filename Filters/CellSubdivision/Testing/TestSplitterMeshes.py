# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volume, orientation, sides, cuts, faces and surfaces on every kind of mesh, with values between and on the vertices."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.meshes import Lattice
from split_checks import Cells, check_split, split
from split_meshes import centred, grid_of, hexahedra_as_polyhedra, honeycomb, pole, refined, wavy, with_sources
from vtkmodules.vtkCommonDataModel import VTK_CONVEX_POINT_SET, VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_QUADRATIC_HEXAHEDRON, VTK_TETRA

VALUES = [0.2, -0.3, 0.7, 0.0]  # not sorted


def warped(p):
    rng = np.random.default_rng(11)
    return 2 * (p - 0.5) + rng.uniform(-0.12, 0.12, p.shape)


def datasets():
    rng = np.random.default_rng(5)
    for kind in ("tetra", "hexahedron", "wedge", "pyramid", "mixed"):
        yield kind, Lattice(3).mesh(kind, centred)
        yield kind + ", warped", Lattice(3).mesh(kind, warped)
    yield "wedges in the other order", meshes.turned_wedges(Lattice(3).mesh("wedge", warped))
    yield "voxels", Lattice(3).mesh("voxel", centred)
    yield "Delaunay", meshes.delaunay(rng, 50)
    yield "image", meshes.image((4, 3, 3), (0.5, 0.6, 0.7), (-1, -1, -1))
    yield "rectilinear", meshes.rectilinear([[-1, -0.6, 0.1, 1], [-1, 0.5, 1], [-1, 0, 1]])
    yield "structured, warped", meshes.structured((3, 3, 3), warped)
    yield "pole", pole()
    yield "polyhedra", hexahedra_as_polyhedra(3, centred)
    yield "polyhedra, warped", hexahedra_as_polyhedra(3, warped)
    yield "polyhedra and hexahedra", hexahedra_as_polyhedra(3, centred, every=2)
    yield "polyhedra turned wrongly", hexahedra_as_polyhedra(2, centred, flip=True)
    yield "refined", refined()
    yield "hexagonal prisms", honeycomb(False)
    yield "hexagonal polyhedra", honeycomb(True)


class Meshes(unittest.TestCase):
    def test_every_kind(self):
        for name, data in datasets():
            with self.subTest(name):
                meshes.with_field(with_sources(data), wavy)
                check_split(self, data, VALUES)

    def test_values_at_vertices(self):
        """Whole numbers at the vertices, and the values among them and between."""
        for seed in range(4):
            for kind in ("tetra", "hexahedron", "wedge", "pyramid"):
                with self.subTest(kind, seed=seed):
                    rng = np.random.default_rng(seed)
                    data = with_sources(Lattice(2).mesh(kind, centred))
                    meshes.add_array(data.GetPointData(), rng.integers(0, 4, data.GetNumberOfPoints()).astype(float))
                    check_split(self, data, [1, 2, 1.5])

    def test_many_values(self):
        data = meshes.with_field(with_sources(Lattice(2).mesh("hexahedron", warped)), wavy)
        check_split(self, data, list(np.linspace(-1.5, 1.5, 41)))

    def test_huge_and_tiny_coordinates(self):
        for scale, shift in ((1e-20, 0), (1e20, 0), (1, 1e6)):
            data = Lattice(2).mesh("tetra", lambda p: scale * centred(p) + shift)
            meshes.with_field(with_sources(data), lambda p: wavy((p - shift) / scale))
            out, before = Cells(split(data, VALUES)), Cells(data)
            volumes = out.volumes()
            self.assertGreater(volumes[out.solid].min(), 0)
            rounding = 1e-12 if shift == 0 else 1e-8  # of coordinates that are a million times the cell
            self.assertLess(abs(volumes.sum() / before.volumes().sum() - 1), rounding)

    def test_one_piece_of_each_shape(self):
        """A tetrahedron cut at two values: the two ends and what is between."""
        data = with_sources(meshes.tetrahedra([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)]))
        meshes.add_array(data.GetPointData(), np.array([0.0, 1, 2, 3]))
        out = check_split(self, data, [0.5, 2.5])
        self.assertEqual(sorted(out.types), sorted([VTK_TETRA] * 2 + [14, 14, VTK_TETRA] + [5, 5]))

    def test_all_equal(self):
        for value, layer in ((2.0, 0), (1.0, 1), (3.0, 0)):  # on the value, above it, below it
            data = meshes.with_field(Lattice(2).mesh("hexahedron"), lambda p: 0 * p[:, 0] + 2.0)
            out = Cells(split(data, [value], expect=() if value == 2.0 else ("'s' are 2 to 2",)))
            np.testing.assert_array_equal(out.types, [VTK_HEXAHEDRON] * 8)
            np.testing.assert_array_equal(out.array("Layer"), [layer] * 8)

    def test_values_twice_and_none(self):
        data = meshes.with_field(Lattice(2).mesh("hexahedron", centred), wavy)
        once, twice = Cells(split(data, [0.0, 0.5])), Cells(split(data, [0.5, 0.0, 0.5, 0.0, 0.5 + 1e-14]))
        np.testing.assert_array_equal(once.array("Layer"), twice.array("Layer"))
        self.assertEqual(set(twice.array("ContourIndex")), {-1, 0, 1})
        none = Cells(split(data, []))
        self.assertEqual(len(none.types), 8)
        self.assertFalse(none.array("Layer").any())

    def test_surfaces_can_be_left_out(self):
        data = meshes.with_field(Lattice(2).mesh("hexahedron", centred), wavy)
        everything, solid = Cells(split(data, VALUES)), Cells(split(data, VALUES, GenerateSurfaces=False))
        self.assertEqual(list(solid.types), list(everything.types[everything.solid]))
        self.assertTrue(solid.solid.all())

    def test_rounding_beside_a_value(self):
        """A vertex that misses the value by rounding is on it: no piece that is nothing but rounding."""
        data = with_sources(Lattice(4).mesh("hexahedron", centred))
        meshes.with_field(data, lambda p: np.round(4 * p[:, 0]) + np.where(np.arange(len(p)) % 2, 1e-15, -1e-15))
        out = Cells(split(data, [0.0, 2.0]))
        self.assertEqual(len(out.points), data.GetNumberOfPoints())
        self.assertEqual(set(out.types), {VTK_HEXAHEDRON, 5})
        on_value = out.points[:, 0] == 0.5
        np.testing.assert_array_equal(out.array("s", points=True)[on_value], 2.0)
        far = Lattice(2).mesh("tetra", lambda p: p + 1e9)  # coordinates with steps of 1e-7
        meshes.with_field(far, lambda p: np.round(2 * (p[:, 0] - 1e9)) + 1e-9)
        self.assertEqual(split(far, [1.0]).GetNumberOfPoints(), far.GetNumberOfPoints())

    def test_centre_where_the_least_vertex_does_not_see_all_faces(self):
        data = meshes.with_field(with_sources(refined()), wavy)
        self.assertEqual(check_split(self, data, VALUES).centres, 1)

    def test_polyhedral_transitions(self):
        """Every face is that of two cells or of the boundary; whole cells stay whole, with their points."""
        for name, data in datasets():
            with self.subTest(name):
                meshes.with_field(with_sources(data), wavy)
                plain, out = Cells(split(data, [0.2])), Cells(split(data, [0.2], PolyhedralTransitions=True))
                self.assertEqual(len(out.types), len(plain.types))
                np.testing.assert_array_equal(out.points, plain.points)
                same = out.types == plain.types
                self.assertTrue((out.types[~same] == VTK_POLYHEDRON).all())
                for a, b in zip(out.ids, plain.ids):
                    self.assertEqual({tuple(p) for p in out.points[a]}, {tuple(p) for p in out.points[b]})
                if name.startswith("mixed") or name == "pole":
                    continue  # faces of the input do not match: two wedges beside a hexahedron, one place with several points
                faces = out.face_map(False)
                single = {f for f, cells in faces.items() if len(cells) == 1}
                boundary = {f for f, cells in out.face_map(True).items() if len(cells) == 1}
                found = {out.key(part) for f in single for part in self.parts(out, f, faces[f][0])}
                self.assertEqual(found, boundary)

    @staticmethod
    def parts(out, key, cell):
        return out.fan(next(f for f in out.faces[cell] if out.key(f) == key))

    def test_quadratic_cells(self):
        """Crossed ones become tetrahedra, as VTK divides them; the others stay."""
        corners = np.array(meshes.HEXAHEDRON, float)
        edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
        points = np.vstack([corners, [(corners[a] + corners[b]) / 2 for a, b in edges]])
        data = grid_of(np.vstack([points, points + [5, 0, 0]]),
                       [(VTK_QUADRATIC_HEXAHEDRON, range(20)), (VTK_QUADRATIC_HEXAHEDRON, range(20, 40))])
        meshes.with_field(data, lambda p: p[:, 0] + 0.1 * p[:, 1])
        out = Cells(split(data, [0.55], expect=["1 cell (the first one is cell 0) crossed by a value is not linear"]))
        self.assertEqual(np.sum(out.types == VTK_QUADRATIC_HEXAHEDRON), 1)
        solid = out.solid & (out.types != VTK_QUADRATIC_HEXAHEDRON)
        self.assertAlmostEqual(out.volumes()[solid].sum(), 1, places=12)

    def test_convex_point_set(self):
        points = np.array(meshes.HEXAHEDRON, float)
        data = meshes.with_field(grid_of(np.vstack([points + [9, 0, 0], points]), [(VTK_CONVEX_POINT_SET, range(8, 16))]), lambda p: p[:, 2])
        out = Cells(split(data, [0.25], expect=["is not linear"]))
        layers = np.bincount(out.array("Layer")[out.solid], out.volumes()[out.solid])
        np.testing.assert_allclose(layers, [0.25, 0.75], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
