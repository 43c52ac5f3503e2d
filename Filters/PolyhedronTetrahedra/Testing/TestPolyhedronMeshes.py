# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of warped polyhedra, as OpenFOAM and MPAS have them: volume conserved and neighbours conforming, also between
cells that are divided and cells that are passed and coned by the mapper."""
import unittest

import numpy as np
from division import HAS_TETGEN, DivisionTestCase, divide, tetrahedra_as_drawn
from nephoscope_testing import dual_meshes, meshes, nonconvex


def is_radially_outer(corners, normal):
    """For a shell around the origin, its top a sphere of radius 1.3."""
    is_top = np.linalg.norm(corners, axis=1).min() > 1.299
    return (corners.mean(axis=0) @ normal > 0) == is_top


class Meshes(DivisionTestCase):
    def check(self, mesh, volume, label, **settings):
        divider, messages = divide(mesh.grid(), **settings)
        self.no_messages(messages)
        self.assertEqual(divider.GetNumberOfUndividedCells(), 0)
        points, ids = tetrahedra_as_drawn(divider.GetOutput())
        parts = nonconvex.volumes(points, ids)
        outer = {p for face in mesh.boundary for p in face}
        self.conforming(ids, lambda f: set(f) <= outer, label)
        total = np.abs(parts).sum()
        print(f"  {label}: {len(mesh.cells)} cells, {divider.GetNumberOfDividedCells()} divided, "
              f"{divider.GetNumberOfNewPoints()} new points, volume off by {total / volume - 1:.1e}")
        self.assertAlmostEqual(total / volume, 1, delta=1e-10, msg=label)
        return divider

    def check_openfoam(self, seed, spacing, jitter, **settings):
        mesh, primal = dual_meshes.openfoam_like(np.random.default_rng(seed), spacing, jitter)
        volume = np.abs(nonconvex.volumes(meshes.points_of(primal), nonconvex.tetrahedra_of(primal)[1])).sum()
        label = f"OpenFOAM-like, seed {seed}, spacing {spacing}, jitter {jitter} {settings or ''}"
        return self.check(mesh, volume, label, **settings), len(mesh.cells)

    def check_mpas(self, terrain, **settings):
        mesh = dual_meshes.mpas_like(2, 3, terrain)
        self.assertEqual(len(mesh.cells), 162 * 3)
        volume = dual_meshes.volume_between(mesh, is_radially_outer)
        return self.check(mesh, volume, f"MPAS-like, terrain {terrain} {settings}", **settings)

    def test_duals_of_delaunay_meshes(self):
        """Most cells pass; those with a strong warp are star-shaped and need no TetGen."""
        for seed, spacing, jitter in ((1, 0.7, 0.1), (2, 0.5, 0.02), (3, 0.5, 0.2), (4, 0.4, 0.1)):
            divider, cells = self.check_openfoam(seed, spacing, jitter, UseTetGen=False)
            self.assertGreater(divider.GetNumberOfDividedCells(), 0)
            self.assertLess(divider.GetNumberOfDividedCells(), 0.4 * cells)

    @unittest.skipUnless(HAS_TETGEN, "this build has no TetGen")
    def test_duals_that_need_tetgen(self):
        divider, _ = self.check_openfoam(1, 0.35, 0.4)
        without, messages = divide(divider.GetInput(), UseTetGen=False)
        self.assertGreater(without.GetNumberOfUndividedCells(), 0, "this mesh must need TetGen")
        self.assertIn("star-shaped", messages.warnings[0])

    def test_dual_with_all_cells_divided(self):
        divider, cells = self.check_openfoam(3, 0.5, 0.1, DivideConvexPolyhedra=True)
        self.assertEqual(divider.GetNumberOfDividedCells(), cells)
        points, ids = meshes.points_of(divider.GetOutput()), nonconvex.tetrahedra_of(divider.GetOutput())[1]
        self.assertGreater(nonconvex.volumes(points, ids).min(), 0)

    def test_what_the_mapper_would_draw_without_the_filter(self):
        """The cones of cells that are not convex leave them and overlap: the error that the filter takes away."""
        mesh, primal = dual_meshes.openfoam_like(np.random.default_rng(3), 0.5, 0.2)
        volume = np.abs(nonconvex.volumes(meshes.points_of(primal), nonconvex.tetrahedra_of(primal)[1])).sum()
        points, ids = tetrahedra_as_drawn(mesh.grid())
        error = np.abs(nonconvex.volumes(points, ids)).sum() / volume - 1
        print(f"  volume drawn without the filter: off by {error:.1e}")
        self.assertGreater(error, 1e-5)

    def test_cells_that_cross_themselves_are_reported_and_the_rest_is_right(self):
        """The dual of random points: long tetrahedra, and some cells whose warped faces run through each other."""
        primal = meshes.delaunay(np.random.default_rng(1), 60)
        mesh = dual_meshes.dual_of_tetrahedra(meshes.points_of(primal), nonconvex.tetrahedra_of(primal)[1])
        divider, messages = divide(mesh.grid())
        self.assertGreater(divider.GetNumberOfDividedCells(), 30)
        self.assertGreater(divider.GetNumberOfUndividedCells(), 0)
        self.assertEqual(len(messages.all), 1)
        self.assertRegex(messages.warnings[0], "cell [0-9]+.*star-shaped")
        points, ids = meshes.points_of(divider.GetOutput()), nonconvex.tetrahedra_of(divider.GetOutput())[1]
        self.assertGreater(nonconvex.volumes(points, ids).min(), -1e-15)
        self.assertEqual(nonconvex.open_faces(ids)[1], 0)

    def test_layers_over_a_sphere(self):
        """Gently curved layers pass whole; mountains as high as the layers are thick need some cells divided."""
        self.assertEqual(self.check_mpas(0.0).GetNumberOfDividedCells(), 0)
        self.check_mpas(0.1)
        self.check_mpas(0.25)

    def test_layers_with_all_cells_divided(self):
        self.assertEqual(self.check_mpas(0.1, DivideConvexPolyhedra=True).GetNumberOfDividedCells(), 162 * 3)

    def test_no_warp_tolerated(self):
        self.assertGreater(self.check_mpas(0.1, FaceWarpTolerance=0.0).GetNumberOfDividedCells(), 162)

    def test_neighbours_that_are_not_convex(self):
        """Two U-shaped prisms face to face, the one divided by TetGen as a whole with its mirror image on top."""
        points, faces, volume = nonconvex.prism(nonconvex.U_POLYGON if HAS_TETGEN else nonconvex.L_POLYGON)
        n = len(points) // 2
        upper = points[n:] + (0, 0, 1)
        below = faces
        above = [[v + n for v in face] for face in faces]
        divider, messages = divide(nonconvex.grid_of(np.vstack([points, upper]), [below, above]))
        self.no_messages(messages)
        _, ids = self.filled(divider, 2 * volume, cells=2)
        shared = set(range(n, 2 * n))
        open_faces, crowded = nonconvex.open_faces(ids)
        self.assertEqual(crowded, 0)
        self.assertEqual([f for f in open_faces if set(f) <= shared], [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
