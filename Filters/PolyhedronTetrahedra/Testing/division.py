# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filter, and checks what holds for every division into tetrahedra."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, nonconvex, polyhedra
from nephoscope_testing.messages import Messages
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

HAS_TETGEN = nephoscope.vtkPolyhedronToTetrahedra.HasTetGen()


def divide(data, **settings):
    """(filter, its messages)."""
    divider = nephoscope.vtkPolyhedronToTetrahedra()
    divider.SetInputData(data)
    for name, value in settings.items():
        getattr(divider, "Set" + name)(value)
    with Messages() as messages:
        divider.Update()
    return divider, messages


def tetrahedra_as_drawn(data):
    """All cells as the mapper divides them: tetrahedra as they are, polyhedra coned. (points, ids)."""
    points = meshes.points_of(data)
    parts = [nonconvex.tetrahedra_of(data)[1]]
    for i in range(data.GetNumberOfCells()):
        if data.GetCellType(i) == VTK_POLYHEDRON:
            ids, loops = polyhedra._cell_faces(data.GetCell(i))
            parts.append(np.array([[ids[k] for k in t] for t in polyhedra.cone(points[ids], loops)], int))
    return points, np.concatenate(parts)


class DivisionTestCase(unittest.TestCase):
    def no_messages(self, messages):
        self.assertEqual(messages.all, [])

    def filled(self, divider, volume, cells=1, label=""):
        """Positive tetrahedra whose volumes add up, every inner face shared by two. Returns (points, ids)."""
        output = divider.GetOutput()
        points, (_, ids) = meshes.points_of(output), nonconvex.tetrahedra_of(output)
        self.assertEqual(divider.GetNumberOfDividedCells(), cells, label)
        self.assertEqual(divider.GetNumberOfUndividedCells(), 0, label)
        self.assertEqual(len(ids), output.GetNumberOfCells(), label)
        parts = nonconvex.volumes(points, ids)
        self.assertGreater(parts.min(), 0, label)
        self.assertAlmostEqual(parts.sum() / volume, 1, delta=1e-10, msg=label)
        return points, ids

    def inside(self, points, ids, corners, faces, label, rng):
        """Random points of every tetrahedron lie inside the cell, by its winding number."""
        weights = rng.dirichlet(np.ones(4), (len(ids), 5))
        where = np.einsum("tkv,tvx->tkx", weights, points[ids]).reshape(-1, 3)
        around = nonconvex.winding_number(corners, faces, where)
        self.assertLess(np.abs(around - 1).max(), 1e-6, label)

    def conforming(self, ids, is_boundary, label):
        """No face has more than two tetrahedra, and those with one are on the boundary."""
        open_faces, crowded = nonconvex.open_faces(ids)
        self.assertEqual(crowded, 0, label)
        self.assertEqual([f for f in open_faces if not is_boundary(f)], [], label)
        return open_faces
