# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells that cannot be divided are passed, with one message that names the first of them and the remedy."""
import unittest

import nephoscope
import numpy as np
from division import HAS_TETGEN, DivisionTestCase, divide
from nephoscope_testing import meshes, nonconvex
from nephoscope_testing.messages import Messages
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid


class BadInput(DivisionTestCase):
    def complaint(self, shapes, bad, *words, **settings):
        """shapes: (points, faces); those whose numbers are in bad are named and passed, the others are divided."""
        points, cells, shift = [], [], 0
        for corners, faces in shapes:
            points.append(corners)
            cells.append([[v + shift for v in face] for face in faces])
            shift += len(corners)
        data = nonconvex.grid_of(np.vstack(points), cells)
        divider, messages = divide(data, **settings)
        self.assertEqual(messages.errors, [])
        self.assertEqual(len(messages.warnings), 1, messages.warnings)
        text = messages.warnings[0]
        print("  " + text.strip().splitlines()[-1])
        for word in (f"cell {bad[0]}", f"{len(bad)} polyhedr", *words):
            self.assertIn(word, text)
        self.assertEqual(divider.GetNumberOfUndividedCells(), len(bad))
        self.assertEqual(divider.GetNumberOfDividedCells(), len(shapes) - len(bad))
        out = divider.GetOutput()
        kept = [i for i in range(out.GetNumberOfCells()) if out.GetCellType(i) == VTK_POLYHEDRON]
        self.assertEqual(len(kept), len(bad))
        return divider

    def setUp(self):
        self.L = nonconvex.prism(nonconvex.L_POLYGON)[:2]
        self.U = nonconvex.prism(nonconvex.U_POLYGON)[:2]

    def test_without_tetgen(self):
        word = "UseTetGen" if HAS_TETGEN else "libtet1.5-dev"
        self.complaint([self.L, self.U, self.L, self.U], [1, 3], "star-shaped", word, UseTetGen=False)

    @unittest.skipIf(HAS_TETGEN, "this build has TetGen")
    def test_a_build_without_tetgen_says_so(self):
        self.complaint([self.U], [0], "star-shaped", "NEPHOSCOPE_USE_TETGEN=ON", "libtet1.5-dev")

    def test_a_face_is_missing(self):
        points, faces = self.L
        self.complaint([self.L, (points, faces[:-1])], [1], "not closed", "Repair")

    def test_a_point_in_the_middle_of_an_edge_that_the_neighbouring_face_does_not_have(self):
        points, faces = self.L
        split = [faces[0], faces[1][:1] + [len(points)] + faces[1][1:], *faces[2:]]
        middle = points[faces[1][:2]].mean(axis=0)
        self.complaint([(np.vstack([points, middle]), split)], [0], "not closed", "middle of an edge")

    def test_coordinates_that_are_not_finite(self):
        for value in (np.nan, np.inf):
            points = self.L[0].copy()
            points[2, 1] = value
            self.complaint([(points, self.L[1]), self.L], [0], "not finite")

    def test_a_face_that_crosses_itself(self):
        points, faces, _ = nonconvex.prism(((0, 0), (2, 2), (2, 0), (0, 1)))
        self.complaint([(points, faces)], [0], "crosses itself")

    def test_a_cell_without_volume(self):
        """Pressed flat, its points coincide in pairs: nothing to divide and nothing to draw."""
        points, faces = self.U
        divider, messages = divide(nonconvex.grid_of(points * (1, 1, 0), [faces]))
        self.no_messages(messages)
        self.assertEqual(divider.GetNumberOfDividedCells(), 0)

    def test_no_faces(self):
        divider, messages = divide(nonconvex.grid_of(self.L[0], [[]]))
        self.assertEqual(divider.GetNumberOfDividedCells(), 0)
        self.assertEqual(messages.errors, [])

    @unittest.skipUnless(HAS_TETGEN, "this build has no TetGen")
    def test_tetgen_fails_and_the_process_goes_on(self):
        """A tower with one corner pulled through its ceiling: TetGen 1.5 crashes on faces that cross each other."""
        points, faces, _ = nonconvex.tower(2)
        points[3, 2] += 3
        divider = self.complaint([(points, faces), self.U], [0], "TetGen", "cross each other")
        self.assertGreater(divider.GetNumberOfDividedCells(), 0)

    def test_no_input(self):
        divider = nephoscope.vtkPolyhedronToTetrahedra()
        with Messages() as messages:
            divider.Update()
        self.assertTrue(messages.errors)

    def test_no_points(self):
        divider, messages = divide(vtkUnstructuredGrid())
        self.assertEqual(len(messages.all), 1)
        self.assertIn("The input is empty", messages.all[0])
        self.assertEqual(divider.GetOutput().GetNumberOfCells(), 0)

    def test_values_that_are_not_finite_spread_to_the_new_point_only(self):
        points, faces, _ = nonconvex.schonhardt()
        data = nonconvex.grid_of(points, [faces])
        values = np.arange(6.0)
        values[2] = np.nan
        meshes.add_array(data.GetPointData(), values)
        out = divide(data)[0].GetOutput()
        found = nonconvex.point_values(out)
        np.testing.assert_array_equal(found[:6], values)
        self.assertTrue(np.isnan(found[6]))

    def test_huge_coordinates(self):
        points, faces, volume = nonconvex.prism(nonconvex.L_POLYGON)
        divider, messages = divide(nonconvex.grid_of(1e150 * points, [faces]))
        self.assertEqual(messages.errors, [])
        divider, messages = divide(nonconvex.grid_of(1e6 + points, [faces]))
        self.no_messages(messages)
        out = divider.GetOutput()
        sums = nonconvex.volumes(meshes.points_of(out) - 1e6, nonconvex.tetrahedra_of(out)[1])
        self.assertAlmostEqual(sums.sum(), volume, delta=1e-10 * volume)

    def test_abort(self):
        mesh = nonconvex.grid_of(*[self.U[0], [self.U[1]]])
        divider = nephoscope.vtkPolyhedronToTetrahedra()
        divider.SetInputData(mesh)
        divider.AddObserver("ProgressEvent", lambda *_: divider.SetAbortExecute(1))
        divider.Update()
        self.assertEqual(divider.GetOutput().GetNumberOfCells(), 0, "nothing rather than a part")


if __name__ == "__main__":
    unittest.main(verbosity=2)
