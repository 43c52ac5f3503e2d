# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed across seam and poles; nothing where cells are hidden or values missing."""
import functools
import unittest

import cloud_grids as cg
import numpy as np
from nephoscope_testing.weather import forecast_globe
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkContourGrid

import nephoscope

COVER = 0.15


@functools.lru_cache
def forecast(hidden=True):
    """The forecast on the globe, with the index of the level as an array: 0 and 20 are the lowest and highest."""
    globe = forecast_globe()
    size = [e + 1 for e in globe.GetExtent()[1::2]]
    level = np.repeat(np.arange(float(size[2])), size[0] * size[1])
    globe.GetPointData().AddArray(cg.array("level", level))
    if not hidden:
        globe.GetPointData().RemoveArray("vtkGhostType")
        globe.GetCellData().RemoveArray("vtkGhostType")
    globe.GetPointData().SetActiveScalars("cloud_fraction")
    return globe


def blob_globe(repeat=True, turn=0):
    """Clouds on the seam and over both poles; columns turned by `turn`."""
    positions = np.roll(cg.globe_positions(72, 37, np.linspace(0.8, 1.7, 13), False), turn, 2)
    if repeat:
        positions = np.concatenate([positions, positions[:, :, :1]], 2)
    centres = np.array([[1.25, 0, 0.05], [0.02, 0.03, 1.25], [0, 0, -1.25], [0.3, 1.2, 0]])
    away = np.linalg.norm(positions[..., None, :] - centres, axis=-1)
    return cg.structured(positions, {"f": np.exp(-(away / 0.3) ** 2).sum(-1), "x": positions})


class Closed(unittest.TestCase):
    def test_the_forecast_has_edges_at_top_and_bottom_only(self):
        globe = forecast(hidden=False)
        for smoothing in (0, 1, 4):
            out = cg.surface(globe, [COVER], smoothing)
            t, level = cg.triangles(out), cg.values(out, "level")
            edges = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
            unique, uses = np.unique(edges, axis=0, return_counts=True)
            self.assertLessEqual(set(uses), {1, 2})
            at = level[unique[uses == 1]]
            self.assertTrue(((at == 0).all(1) | (at == 20).all(1)).all())
            apart = cg.surface(globe, [COVER], smoothing, JoinSeams=False)
            self.assertGreater(len(cg.boundary_edges(apart)), len(at) + 500)

    def test_the_forecast_above_the_ground(self):
        """Where cells are hidden the surface ends; at the seam it does not, but where the cells beside it are hidden."""
        out = cg.surface(forecast(), [COVER], 1)
        in_seam = lambda e: (np.abs(e[..., 1]) < 1.0).all(1) & (e[..., 0] > 0).all(1)
        self.assertLess(in_seam(cg.boundary_edges(out)).sum(), 8)
        apart = cg.surface(forecast(), [COVER], 1, JoinSeams=False)
        self.assertGreater(in_seam(cg.boundary_edges(apart)).sum(), 200)

    def test_blobs_are_spheres(self):
        """Four closed surfaces, each of Euler characteristic 2, two over the poles and one on the seam."""
        out = cg.surface(blob_globe(), [0.5])
        self.assertEqual(set(cg.edge_counts(out)), {2})
        self.assertEqual(out.GetNumberOfPoints() - out.GetNumberOfCells() // 2, 8)
        apart = cg.surface(blob_globe(), [0.5], JoinSeams=False)
        self.assertIn(1, cg.edge_counts(apart))

    def test_it_does_not_matter_where_the_seam_is(self):
        places = lambda out: np.array(sorted(map(tuple, np.round(cg.points(out), 9) + 0.0)))
        here, there = (cg.surface(blob_globe(turn=turn), [0.5], 2) for turn in (0, 11))
        np.testing.assert_allclose(places(here), places(there), atol=1e-8)
        order = lambda out: np.lexsort(np.round(cg.points(out), 9).T)
        np.testing.assert_allclose(cg.values(here, "Normals")[order(here)], cg.values(there, "Normals")[order(there)], atol=1e-5)

    def test_an_open_ring_is_closed_if_it_is_said_to_be_periodic(self):
        closed = cg.surface(blob_globe(), [0.5], 2)
        ring = cg.surface(blob_globe(repeat=False), [0.5], 2, Periodic=0)
        self.assertEqual(set(cg.edge_counts(ring)), {2})
        np.testing.assert_allclose(cg.points(ring), cg.points(closed), atol=1e-14)
        np.testing.assert_allclose(cg.values(ring, "x"), cg.points(ring), atol=1e-14)
        np.testing.assert_allclose(cg.values(ring, "Normals"), cg.values(closed, "Normals"), atol=1e-6)
        self.assertIn(1, cg.edge_counts(cg.surface(blob_globe(repeat=False), [0.5], 2)))

    def test_a_map_is_smoothed_across_its_edge_and_not_contoured_across_it(self):
        field = np.random.default_rng(3).random((4, 9, 24))
        grid = np.stack(np.meshgrid(np.arange(24.0), np.arange(9.0), np.arange(4.0), indexing="ij"), -1).transpose(2, 1, 0, 3)
        out = cg.surface(cg.structured(grid, {"f": field}), [0.5], 1, Periodic=0)
        p, t = cg.points(out), cg.triangles(out)
        self.assertLessEqual(np.ptp(p[t][..., 0], axis=1).max(), 1.0)
        plain = cg.surface(cg.structured(grid, {"f": field}), [0.5], 1)
        self.assertFalse(np.array_equal(cg.points(plain)[:20], p[:20]))

    def test_normals_at_the_pole(self):
        """The blob over the north pole is a ball about its centre: normals there too."""
        out = cg.surface(blob_globe(), [0.5])
        p, n = cg.points(out), cg.values(out, "Normals")
        away = p - [0.02, 0.03, 1.25]
        near = np.linalg.norm(away, axis=1) < 0.4
        cosines = np.einsum("ij,ij->i", away, n)[near] / np.linalg.norm(away, axis=1)[near]
        on_axis = np.linalg.norm(p[near][:, :2], axis=1) < 1e-9
        self.assertEqual(on_axis.sum(), 2)
        self.assertGreater(cosines.min(), 0.95)
        self.assertGreater(cosines[on_axis].min(), 0.99)


class Hidden(unittest.TestCase):
    def test_the_forecast_as_another_filter_contours_it(self):
        """vtkContourGrid goes cell by cell and joins points by place."""
        globe = forecast()
        cells = vtkAppendFilter()
        cells.SetInputData(globe)
        peer = vtkContourGrid()
        peer.SetInputConnection(cells.GetOutputPort())
        peer.SetValue(0, COVER)
        peer.ComputeNormalsOff()
        peer.Update()
        out = cg.surface(globe, [COVER])
        self.assertEqual(out.GetNumberOfCells(), peer.GetOutput().GetNumberOfCells())
        self.assertEqual(out.GetNumberOfPoints(), peer.GetOutput().GetNumberOfPoints())

    def setUp(self):
        self.field = np.random.default_rng(4).random((7, 8, 9))
        self.whole = cg.surface(cg.image(self.field), [0.5])
        self.cells = np.floor(cg.points(self.whole)[cg.triangles(self.whole)].mean(1)).astype(int)[:, ::-1]  # k, j, i

    def test_hidden_cells(self):
        hidden = np.random.default_rng(5).random((6, 7, 8)) < 0.3
        data = cg.image(self.field)
        data.GetCellData().AddArray(cg.array("vtkGhostType", np.where(hidden, cg.HIDDEN_CELL, 0).astype(np.uint8).ravel()))
        out = cg.surface(data, [0.5])
        kept = ~hidden[tuple(self.cells.T)]
        self.assertEqual(out.GetNumberOfCells(), kept.sum())
        centres = cg.points(self.whole)[cg.triangles(self.whole)].mean(1)[kept]
        np.testing.assert_allclose(cg.points(out)[cg.triangles(out)].mean(1), centres, atol=1e-6)
        self.assertEqual(len(np.unique(cg.triangles(out))), out.GetNumberOfPoints())  # no point is left over

    def test_a_surface_in_a_face_needs_one_cell_that_is_seen(self):
        for hidden, area in (((2,), 12), ((1,), 12), ((1, 2), 0), ((0, 3), 12)):
            data = cg.image(np.broadcast_to(np.arange(6.0), (5, 4, 6)).copy())
            flags = np.zeros((4, 3, 5), np.uint8)
            flags[:, :, list(hidden)] = cg.HIDDEN_CELL
            data.GetCellData().AddArray(cg.array("vtkGhostType", flags.ravel()))
            out = cg.surface(data, [2.0])
            p, t = (cg.points(out), cg.triangles(out)) if out.GetNumberOfCells() else (np.zeros((1, 3)), np.zeros((0, 3), int))
            sides = np.cross(p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]])
            self.assertAlmostEqual(np.linalg.norm(sides, axis=1).sum() / 2, area)

    def corners_missing(self, gaps):
        touched = np.zeros((6, 7, 8), bool)
        for k, j, i in np.ndindex(2, 2, 2):
            touched |= gaps[k:k + 6, j:j + 7, i:i + 8]
        return (~touched[tuple(self.cells.T)]).sum()

    def test_hidden_points_and_missing_values(self):
        gaps = np.random.default_rng(6).random(self.field.shape) < 0.08
        data = cg.image(self.field)
        data.GetPointData().AddArray(cg.array("vtkGhostType", np.where(gaps, cg.HIDDEN_POINT, 0).astype(np.uint8).ravel()))
        self.assertEqual(cg.surface(data, [0.5]).GetNumberOfCells(), self.corners_missing(gaps))
        for value in (np.nan, np.inf, -9.97e36):
            out = cg.surface(cg.image(np.where(gaps, value, self.field)), [0.5], expect=[f"{gaps.sum()} values of the array 'f'"])
            self.assertEqual(out.GetNumberOfCells(), self.corners_missing(gaps))
            self.assertTrue(np.isfinite(cg.points(out)).all() and np.isfinite(cg.values(out, "Normals")).all())

    def test_smoothing_does_not_pull_in_what_is_hidden(self):
        gaps = np.zeros(self.field.shape, bool)
        gaps[:2] = True
        data = cg.image(np.where(gaps, 1e6, self.field))
        data.GetPointData().AddArray(cg.array("vtkGhostType", np.where(gaps, cg.HIDDEN_POINT, 0).astype(np.uint8).ravel()))
        alone = cg.surface(cg.image(self.field[2:], origin=(0, 0, 2)), [0.5], 2)
        np.testing.assert_allclose(cg.points(cg.surface(data, [0.5], 2)), cg.points(alone), atol=1e-6)


class WithGlobeGrid(unittest.TestCase):
    def test_the_pipeline(self):
        """vtkGlobeGrid to vtkCloudSurface, connected, with all of the forecast's arrays."""
        made = nephoscope.vtkCloudSurface()
        made.SetInputData(forecast())
        made.SetValue(0, COVER)
        made.Update()
        data = made.GetOutput().GetPointData()
        names = {data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}
        self.assertLessEqual({"cloud_fraction", "t", "u", "v", "gh", "Wind", "DisplayVelocity", "Height", "Normals"}, names)
        self.assertNotIn("vtkGhostType", names)


if __name__ == "__main__":
    unittest.main()
