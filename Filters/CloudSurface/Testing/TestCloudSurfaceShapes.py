# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of known fields: radius and normals of a sphere at their orders, on every kind of grid; peers; which side is out."""
import unittest

import cloud_grids as cg
import numpy as np
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkFlyingEdges3D

CENTRE = np.array([0.03, -0.02, 0.01])


def lattice(n, uneven=0.0):
    """Positions [k, j, i, 3] in a cube of side 2; `uneven` changes the steps from one to the next by that share."""
    axes = []
    for axis in range(3):
        steps = 1 + uneven * np.where(np.arange(n) % (2 + axis) == 0, 1, -0.5)
        axes.append(-1 + 2 * np.concatenate([[0], np.cumsum(steps)]) / steps.sum())
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).transpose(2, 1, 0, 3), axes


def bent(p):
    """A curvilinear grid: the cube, sheared and bulged."""
    x, y, z = np.moveaxis(p, -1, 0)
    return np.stack([x + 0.15 * np.sin(2 * y) + 0.1 * z, y + 0.1 * np.cos(2 * z), z + 0.12 * np.sin(1.5 * x)], -1)


def ball(p):
    """High inside, as a cloud is; not quadratic, so that nothing is exact by accident."""
    return np.exp(-np.sum((p - CENTRE) ** 2, -1))


RADIUS = 0.6
VALUE = np.exp(-RADIUS ** 2)


def errors(out):
    """Largest error of the radius, of the normals as a length; the least cosine of triangle and normal."""
    away = cg.points(out) - CENTRE
    distance = np.linalg.norm(away, axis=1)
    normals = cg.values(out, "Normals").astype(float)
    p, t = cg.points(out), cg.triangles(out)
    facets = np.cross(p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]])
    sizes = np.linalg.norm(facets, axis=1)
    cosines = np.einsum("ij,ij->i", facets, normals[t[:, 0]])[sizes > 1e-12] / sizes[sizes > 1e-12]
    assert np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-6
    return np.abs(distance - RADIUS).max(), np.linalg.norm(normals - away / distance[:, None], axis=1).max(), cosines.min()


class Sphere(unittest.TestCase):
    def check_orders(self, make, least=1.8):
        results = [errors(cg.surface(make(n), [VALUE])) for n in (12, 24, 48)]
        for which, name in enumerate(("radius", "normal")):
            orders = [np.log2(results[i][which] / results[i + 1][which]) for i in range(2)]
            print(f"  {name}: {[f'{r[which]:.2e}' for r in results]} orders {np.round(orders, 2)}")
            self.assertGreater(min(orders), least, name)
        self.assertGreater(results[-1][2], 0.5)  # triangles face outwards too
        return results

    def test_image(self):
        results = self.check_orders(lambda n: cg.image(ball(lattice(n)[0]), (2 / n,) * 3, (-1,) * 3))
        self.assertLess(results[2][0], 4e-4)  # h^2/8 times the second derivative of the field over its slope: 3.6e-4
        self.assertLess(results[2][1], 2e-3)

    def test_rectilinear_uneven(self):
        def make(n):
            positions, axes = lattice(n, 0.3)
            return cg.rectilinear(*axes, {"f": ball(positions)})
        self.check_orders(make)

    def test_curvilinear(self):
        self.check_orders(lambda n: cg.structured(bent(lattice(n)[0]), {"f": ball(bent(lattice(n)[0]))}))

    def test_left_handed_grids_face_outwards_too(self):
        positions = bent(lattice(24)[0])[:, :, ::-1]
        self.assertGreater(errors(cg.surface(cg.structured(positions, {"f": ball(positions)}), [VALUE]))[2], 0.5)

    def test_a_hole_faces_into_itself(self):
        positions = lattice(24)[0]
        out = cg.surface(cg.structured(positions, {"f": -ball(positions)}), [-VALUE])
        away = cg.points(out) - CENTRE
        self.assertLess(np.einsum("ij,ij->i", away, cg.values(out, "Normals")).max(), 0)

    def test_closed(self):
        out = cg.surface(cg.image(ball(lattice(16)[0]), (2 / 16,) * 3, (-1,) * 3), [VALUE])
        self.assertEqual(set(cg.edge_counts(out)), {2})
        v, f = len(cg.points(out)), len(cg.triangles(out))
        self.assertEqual(v - f // 2, 2)  # Euler: E = 3 F/2

    def test_smoothing_shrinks_the_ball(self):
        """A Gaussian of variance s^2 becomes one of s^2 + n h^2/2, lower: its contour is known."""
        n, iterations = 32, 4
        h, s = 2 / n, 0.35
        positions = lattice(n)[0]
        field = np.exp(-np.sum(positions ** 2, -1) / (2 * s * s))
        out = cg.surface(cg.image(field, (h,) * 3, (-1,) * 3), [0.5], iterations)
        wide = s * s + iterations * h * h / 2
        radius = np.sqrt(-2 * wide * np.log(0.5 * (wide / (s * s)) ** 1.5))
        np.testing.assert_allclose(np.linalg.norm(cg.points(out), axis=1), radius, atol=2e-3)
        self.assertGreater(s * np.sqrt(2 * np.log(2)) - radius, 0.015)  # so much it has shrunk


class Ends(unittest.TestCase):
    def test_normals_at_the_end_of_the_grid(self):
        """A ball cut by the grid: on the cut, derivatives look to one side only, and are of order 2 all the same."""
        worst = []
        for n in (12, 24, 48):
            positions = lattice(n)[0][:, :, n // 2:]
            data = cg.image(ball(positions), (2 / n,) * 3, (0, -1, -1))
            out = cg.surface(data, [VALUE])
            away = cg.points(out) - CENTRE
            cut = cg.points(out)[:, 0] == 0
            self.assertGreater(cut.sum(), 10)
            true = away / np.linalg.norm(away, axis=1)[:, None]
            worst.append(np.linalg.norm(cg.values(out, "Normals") - true, axis=1)[cut].max())
        print(f"  at the end: {[f'{w:.2e}' for w in worst]}")
        self.assertGreater(np.log2(worst[0] / worst[1]), 1.7)
        self.assertGreater(np.log2(worst[1] / worst[2]), 1.7)


class Peers(unittest.TestCase):
    def same_surface(self, data, name="f", value=VALUE):
        ours = cg.surface(data, [value], ComputeNormals=False)
        peer = vtkContourFilter()
        peer.SetInputData(data)
        peer.SetInputArrayToProcess(0, 0, 0, 0, name)
        peer.SetValue(0, value)
        peer.ComputeNormalsOff()
        peer.Update()
        theirs = peer.GetOutput()
        rows = lambda p: np.array(sorted(map(tuple, np.round(p, 5) + 0.0)))
        np.testing.assert_allclose(np.unique(rows(cg.points(ours)), axis=0), np.unique(rows(cg.points(theirs)), axis=0), atol=2e-5)
        self.assertIsNone(ours.GetPointData().GetNormals())

    def test_points_are_those_of_the_contour_filter(self):
        positions = bent(lattice(16)[0])
        self.same_surface(cg.structured(positions, {"f": ball(positions)}))
        positions, axes = lattice(16, 0.3)
        self.same_surface(cg.rectilinear(*axes, {"f": ball(positions)}))

    def test_an_image_gives_flying_edges(self):
        data = cg.image(ball(lattice(16)[0]), (2 / 16,) * 3, (-1,) * 3)
        peer = vtkFlyingEdges3D()
        peer.SetInputData(data)
        peer.SetValue(0, VALUE)
        peer.Update()
        ours = cg.surface(data, [VALUE])
        np.testing.assert_allclose(cg.points(ours), cg.points(peer.GetOutput()), atol=1e-6)
        np.testing.assert_array_equal(np.sort(cg.triangles(ours)), np.sort(cg.triangles(peer.GetOutput())))


class Degenerate(unittest.TestCase):
    def test_values_on_grid_points(self):
        """A plane through grid points: in place, facing down the slope, without holes."""
        data = cg.image(np.broadcast_to(np.arange(6.0), (5, 4, 6)).copy())
        out = cg.surface(data, [2.0])
        self.assertTrue((cg.points(out)[:, 0] == 2).all())
        np.testing.assert_allclose(cg.values(out, "Normals"), [[-1, 0, 0]] * out.GetNumberOfPoints(), atol=1e-6)
        p, t = cg.points(out), cg.triangles(out)
        self.assertAlmostEqual(np.linalg.norm(np.cross(p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]]), axis=1).sum() / 2, 12)

    def test_a_field_of_zeros_and_ones(self):
        """Central differences vanish on a chessboard; normals are those of the edges then."""
        field = (np.indices((7, 7, 7)).sum(0) % 2).astype(float)
        out = cg.surface(cg.image(field), [0.5])
        p, normals = cg.points(out), cg.values(out, "Normals")
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
        inner = ((p >= 1) & (p <= 5)).all(axis=1)
        axis = np.argmax(p % 1, axis=1)
        low = np.floor(p).astype(int)
        upwards = field[low[:, 2], low[:, 1], low[:, 0]] == 0  # along the axis
        expected = np.eye(3)[axis] * np.where(upwards, -1, 1)[:, None]
        self.assertGreater(inner.sum(), 100)
        np.testing.assert_allclose(normals[inner], expected[inner], atol=1e-6)

    def test_rough_fields_face_down_the_edge_that_they_cross(self):
        """One point high among low ones, beside a higher one: central differences at it point the wrong way."""
        line = np.array([0.0, 0.0, 5.0, 0.0, 1.0, 0.0, 5.0, 0.0, 0.0])
        out = cg.surface(cg.image(np.broadcast_to(line, (3, 3, 9)).copy()), [0.5])
        x, normals = cg.points(out)[:, 0], cg.values(out, "Normals")
        up = np.interp(x + 1e-3, np.arange(9), line) > np.interp(x - 1e-3, np.arange(9), line)
        np.testing.assert_array_equal(normals[:, 0] > 0, ~up)

    def test_a_peak_at_the_value(self):
        """No gradient at the peak itself: its normals go down the steepest way."""
        field = np.zeros((5, 5, 5))
        field[2, 2, 2], field[2, 1, 2], field[2, 3, 2] = 1, -3, -3
        out = cg.surface(cg.image(field), [1.0])
        self.assertGreater(out.GetNumberOfPoints(), 0)
        np.testing.assert_allclose(np.abs(cg.values(out, "Normals")), [[0, 1, 0]] * out.GetNumberOfPoints(), atol=1e-6)

    def test_one_cell(self):
        field = np.zeros((2, 2, 2))
        field[0, 0, 0] = 1
        out = cg.surface(cg.image(field), [0.5])
        self.assertEqual(out.GetNumberOfCells(), 1)
        self.assertTrue((cg.values(out, "Normals") @ np.ones(3) > 0).all())

    def test_no_surface(self):
        for values, why in (([7.0], "the contour value is 7"), ([], "no contour values")):
            out = cg.surface(cg.image(ball(lattice(4)[0])), values, expect=(why,))
            self.assertEqual((out.GetNumberOfPoints(), out.GetNumberOfCells()), (0, 0))


if __name__ == "__main__":
    unittest.main()
