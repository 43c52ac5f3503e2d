# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Structured grids of which a side shrinks to a line or a point, as around the axis of a cylinder and the poles of a ball.

Reference: the same cells in an unstructured mesh that has each point once. The cameras look along the plane in which the grid closes, and across it.
"""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkFiltersCore import vtkAppendFilter

UNIFORM = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 1), (1, 1)], unit_distance=1)
VIEWS = {"at the plane": (0, -4, 0), "through the plane": (0, 4, 0), "along the axis": (0, 0, 4), "across": (1.2, -3.2, 2)}
TURN = 2 * np.pi


def cylinder(r, t, z):
    return np.stack([r * np.cos(TURN * t), r * np.sin(TURN * t), z - 0.5], axis=-1)


def ball(r, t, p):
    return np.stack([r * np.sin(np.pi * p) * np.cos(TURN * t), r * np.sin(np.pi * p) * np.sin(TURN * t), r * np.cos(np.pi * p)], axis=-1)


def grid(shape, order, offset):
    """`order`: which of the grid's axes are radius, angle, and height or latitude."""
    cells = [0, 0, 0]
    for axis, number in zip(order, (4, 24, 6)):
        cells[axis] = number
    data = meshes.structured(tuple(cells), lambda points: shape(*(points[:, axis] for axis in order)) + offset)
    places = meshes.points_of(data) - offset
    meshes.add_array(data.GetPointData(), (0.5 + 0.4 * places[:, 2]).astype(np.float32))
    return data


def merged(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.MergePointsOn()
    append.SetTolerance(1e-6)
    append.Update()
    return append.GetOutput()


def picture(data, position, offset, trilinear):
    window = Window((60, 60))
    scene = window.add_scene()
    ours = mapper()
    if trilinear:
        ours.SetCellInterpolationToTrilinear()
    else:
        ours.SetCellInterpolationToTetrahedra()
    scene.add_volume(ours, data, UNIFORM)
    scene.camera.SetParallelProjection(True)
    up = (0, 1, 0) if position[2] == 4 else (0, 0, 1)
    scene.look(np.add(position, offset), (offset,) * 3, up, 30, 1.17, near=1, far=8)
    window.render()
    return float_image(ours)


class TestCollapsedAxes(unittest.TestCase):
    def check(self, shape, offset=0.0, trilinear=False):
        for order in ((0, 1, 2), (1, 0, 2), (2, 1, 0), (1, 2, 0)):
            data = grid(shape, order, offset)
            expected = merged(data)
            for name, position in VIEWS.items():
                with self.subTest(shape=shape.__name__, order=order, view=name):
                    drawn, reference = (picture(cells, position, offset, trilinear)[..., 3] for cells in (data, expected))
                    self.assertGreater(reference.mean(), 0.1)
                    self.assertLess(np.abs(drawn - reference).max(), 2 / 255)

    def test_cylinder(self):
        self.check(cylinder)

    def test_ball(self):
        self.check(ball)

    def test_away_from_the_origin(self):
        self.check(cylinder, offset=1e4)

    def test_trilinear_cells(self):
        self.check(cylinder, trilinear=True)


if __name__ == "__main__":
    unittest.main()
