# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reference renderer itself, against closed forms and VTK's own camera: a judge must be right first."""
import math
import unittest

import numpy as np
from nephoscope_testing import meshes, polyhedra, reference
from nephoscope_testing.transfer import Transfer, constant
from nephoscope_testing.view import View
from vtkmodules.vtkRenderingCore import vtkCamera


def axis_view(position, focus, size=(5, 4), scale=1.0):
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focus)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)
    camera.SetClippingRange(0.1, 100)
    return View(camera, size)


def cube(function):
    return polyhedra.from_dataset(meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), function))


RAMP = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 1), (1, 2)])


class ClosedForms(unittest.TestCase):
    def picture(self, cells, transfer, view, pixel=(2, 1), **options):
        return reference.render(cells, view, transfer, **options)[pixel[1], pixel[0]]

    def test_unit_cube(self):
        rgba = self.picture(cube(lambda p: p[:, 2]), constant(), axis_view((0.5, 0.45, 5), (0.5, 0.45, 0)))
        np.testing.assert_allclose(rgba, 0.6321205588285577, rtol=1e-13)

    def test_ramp_from_both_sides(self):
        cells = cube(lambda p: p[:, 2])
        low = self.picture(cells, RAMP, axis_view((0.5, 0.45, -5), (0.5, 0.45, 0)))
        high = self.picture(cells, RAMP, axis_view((0.5, 0.45, 5), (0.5, 0.45, 0)))
        np.testing.assert_allclose(low, [0.338529198658] * 3 + [1 - math.exp(-1.5)], rtol=1e-11)
        np.testing.assert_allclose(high, [0.521731859065] * 3 + [1 - math.exp(-1.5)], rtol=1e-11)

    def test_average_rule(self):
        flat = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 1), (1, 1)])
        rgba = self.picture(cube(lambda p: p[:, 2]), flat, axis_view((0.5, 0.45, -5), (0.5, 0.45, 0)), integration="average")
        np.testing.assert_allclose(rgba[:3], 0.316060279, rtol=1e-8)

    def test_splitting_into_more_cells_changes_nothing(self):
        view = axis_view((0.3, 0.2, 5), (0.5, 0.45, 0))
        one = reference.render(cube(lambda p: p[:, 2]), view, RAMP)
        many = meshes.with_field(meshes.Lattice(3).mesh("tetra"), lambda p: p[:, 2])
        np.testing.assert_allclose(reference.render(polyhedra.from_dataset(many), view, RAMP), one, atol=1e-12)

    def test_opaque_thin_and_deep(self):
        view = axis_view((0.5, 0.45, 5), (0.5, 0.45, 0))
        for extinction in (1e-7, 1e5):
            rgba = self.picture(cube(lambda p: p[:, 2]), constant(extinction, (0.25, 0.5, 1)), view)
            alpha = -math.expm1(-extinction)
            np.testing.assert_allclose(rgba, [0.25 * alpha, 0.5 * alpha, alpha, alpha], rtol=1e-9)

    def test_opaque_distance_and_near_plane(self):
        view = axis_view((0.5, 0.45, 5), (0.5, 0.45, 0))
        half = np.full((view.height, view.width), 4.25)
        rgba = self.picture(cube(lambda p: p[:, 2]), constant(), view, opaque=half)
        self.assertAlmostEqual(rgba[3], -math.expm1(-0.25), places=12)
        view.near = 4.75
        self.assertAlmostEqual(self.picture(cube(lambda p: p[:, 2]), constant(), view)[3], -math.expm1(-0.25), places=12)

    def test_control_points(self):
        tent = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (0.5, 3), (1, 0)])
        rgba = self.picture(cube(lambda p: p[:, 2]), tent, axis_view((0.5, 0.45, 5), (0.5, 0.45, 0)))
        np.testing.assert_allclose(rgba, -math.expm1(-1.5), rtol=1e-12)


class Cells(unittest.TestCase):
    def test_cone_fills_the_cell(self):
        rng = np.random.default_rng(3)
        data = meshes.with_field(meshes.Lattice(2).mesh("hexahedron", meshes.projective(rng)), lambda p: p[:, 0])
        view = axis_view((0.2, 0.1, 5), (0, 0, 0), (12, 12), 0.8)
        whole = reference.render(polyhedra.from_dataset(data), view, RAMP)
        coned = reference.render(polyhedra.from_dataset(data, decompose=True), view, RAMP)
        self.assertGreater(whole.max(), 0.2)
        np.testing.assert_allclose(coned, whole, atol=1e-12)

    def test_a_field_that_is_not_linear_is_refused(self):
        with self.assertRaises(ValueError):
            cube(lambda p: p[:, 0] * p[:, 1])


class Camera(unittest.TestCase):
    def test_rays_agree_with_the_projection_of_vtk(self):
        rng = np.random.default_rng(11)
        for parallel in (False, True):
            camera = vtkCamera()
            camera.SetPosition(*rng.normal(size=3) * 3)
            camera.SetViewUp(0.2, 0.9, 0.1)
            camera.SetWindowCenter(0.3, -0.2)
            camera.SetViewAngle(40)
            camera.SetClippingRange(0.5, 9)
            camera.SetParallelProjection(parallel)
            view = View(camera, (7, 5))
            origins, directions, start, end = view.rays()
            matrix = camera.GetCompositeProjectionTransformMatrix(7 / 5, -1, 1)
            m = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
            for t, depth in ((start, -1), (end, 1)):
                points = origins + directions * t[:, None]
                clip = np.column_stack([points, np.ones(len(points))]) @ m.T
                ndc = clip[:, :3] / clip[:, 3:]
                i, j = np.meshgrid(np.arange(7), np.arange(5))
                np.testing.assert_allclose(ndc[:, 0], 2 * (i.ravel() + 0.5) / 7 - 1, atol=1e-12)
                np.testing.assert_allclose(ndc[:, 1], 2 * (j.ravel() + 0.5) / 5 - 1, atol=1e-12)
                np.testing.assert_allclose(ndc[:, 2], depth, atol=1e-11)
                np.testing.assert_allclose(view.pixels(points)[:, 0], i.ravel() + 0.5, atol=1e-11)


if __name__ == "__main__":
    unittest.main(verbosity=2)
