# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays along thousands of cells, against the closed form. Mesa's software OpenGL ends the loops of a shader after 65,535 rounds in all, without an error."""
import math
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import constant
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

ACROSS = np.array([-0.5, 0.5])


def even(cells):
    return meshes.with_field(meshes.image((1, 1, cells), (1, 1, 1 / cells), (-0.5, -0.5, 0)), lambda p: p[:, 2])


def stretched(cells):
    return meshes.with_field(meshes.rectilinear([ACROSS, ACROSS, np.linspace(0, 1, cells + 1)**1.3]), lambda p: p[:, 2])


def filtered(data, algorithm):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def unstructured(data):
    return filtered(data, vtkAppendFilter())


def tetrahedra(data):
    return filtered(unstructured(data), vtkDataSetTriangleFilter())


def scene_of(data, divided):
    window = Window((8, 8))
    scene = window.add_scene()
    ours = mapper()
    if divided:
        ours.SetCellInterpolationToTetrahedra()
    scene.add_volume(ours, data, constant(1.0, (1, 1, 1)))
    return window, scene, ours


class LongRays(unittest.TestCase):
    def check(self, name, data, divided=False):
        window, scene, ours = scene_of(data, divided)
        for height, focus in ((5, 0), (-4, 1)):
            scene.look((0.02, 0.03, height), (0.02, 0.03, focus), (0, 1, 0), 5, None, near=1, far=9)
            window.render()
            np.testing.assert_allclose(float_image(ours)[4, 4, 3], -math.expm1(-1), atol=1e-4, err_msg=f"{name} from {height}")
        self.assertEqual(window.messages.all, [])

    def test_evenly_spaced(self):
        self.check("image", even(20000))

    def test_other_cells(self):
        grid = stretched(3500)
        for name, data in (("grid", grid), ("hexahedra", unstructured(grid))):
            self.check(name, data)
            self.check(name + " as tetrahedra", data, divided=True)
        self.check("tetrahedra", tetrahedra(grid))


class TestTooLong(unittest.TestCase):
    """Rays that software OpenGL would end are warned of, once."""

    def warnings(self, data, divided=False):
        window, scene, _ = scene_of(data, divided)
        scene.look_at(data)
        for _ in range(2):
            window.render()
        return window.messages.warnings

    def test_long_grids(self):
        for cells, data, divided in ((12000, stretched(12000), False), (7000, stretched(7000), True), (30000, even(30000), False)):
            warnings = self.warnings(data, divided)
            self.assertEqual(len(warnings), 1)
            self.assertRegex(warnings[0], f"{cells} cells of the grid's longest axis")

    def test_others(self):
        self.assertEqual(self.warnings(stretched(7000)), [])
        self.assertEqual(self.warnings(even(12000)), [])


if __name__ == "__main__":
    unittest.main()
