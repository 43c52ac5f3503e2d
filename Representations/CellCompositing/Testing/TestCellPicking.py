# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Pick() finds at a pixel: place, cell, point and scalar, against closed forms, the drawn opacity and VTK's own cells."""
import math
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkCommonCore import reference as vtk_reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkPlane
from vtkmodules.vtkFiltersSources import vtkSphereSource

SIZE = (40, 36)
X = lambda p: 0.5 + 0.1 * p[:, 2] + 0.2 * p[:, 0]  # noqa: E731


def polyhedral():
    """One convex polyhedron: a box around the origin."""
    corners = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return meshes.polyhedron(corners, faces)


DATA = {**meshes.BOXES, "polyhedra": polyhedral}


class Picking(ImageTestCase):
    def scene(self, data, transfer=None, look=None, configure=None, matrix=None, before=None):
        self.window = Window(SIZE)
        scene = self.window.add_scene()
        ours = mapper()
        if configure:
            configure(ours)
        scene.add_volume(ours, data, transfer or constant(2.0), matrix=matrix)
        if before:
            before(scene)
        (look or (lambda s: s.look((0.03, 0.02, 5), (0.03, 0.02, 0), parallel_scale=0.8, near=0.1, far=20)))(scene)
        self.window.render()
        self.fail_on_messages(self.window)
        return scene, ours

    def pick(self, scene, ours, x=20, y=18, opacity=0.1):
        ours.SetPickOpacity(opacity)
        self.assertTrue(ours.Pick(scene.renderer, x, y))
        return np.array(ours.GetPickPosition())

    def check_in_cell(self, data, ours, place):
        """VTK's own cell of that number contains the place, has the point, and interpolates the scalar."""
        cell, weights = vtkGenericCell(), [0.0] * 32
        data.GetCell(ours.GetPickedCell(), cell)
        closest, pcoords, part, distance = [0.0] * 3, [0.0] * 3, vtk_reference(0), vtk_reference(0.0)
        if cell.GetNumberOfFaces() == 6 and cell.GetCellType() == 42:
            self.assertTrue(np.all(np.abs(place) < 1 + 1e-5))
        else:
            self.assertGreaterEqual(cell.EvaluatePosition(place, closest, part, pcoords, distance, weights), 0)
            self.assertLess(float(distance.get()), 1e-8)
        ids = [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]
        self.assertIn(ours.GetPickedPoint(), ids)

    def test_every_kind_of_cell_in_closed_form(self):
        """A constant medium seen along z from 1 down: opacity a lies at z = 1 + ln(1 - a) / extinction."""
        for kind, make in DATA.items():
            for trilinear in (False, True):
                data = meshes.with_field(make(), X)
                scene, ours = self.scene(data, constant(2.0), configure=lambda m: m.SetCellInterpolation(int(trilinear)))
                for opacity in (0.1, 0.5, 0.9):
                    with self.subTest(kind=kind, trilinear=trilinear, opacity=opacity):
                        place = self.pick(scene, ours, 23, 15, opacity)
                        self.assertAlmostEqual(place[2], 1 + math.log1p(-opacity) / 2, 5)
                        np.testing.assert_allclose(place[:2], (0.03 + 1.6 * 3.5 / 36, 0.02 - 1.6 * 2.5 / 36), atol=1e-6)
                        self.check_in_cell(data, ours, place)
                        self.assertAlmostEqual(ours.GetPickedScalar(), X(place[None])[0], 4)

    def test_what_is_drawn_is_picked(self):
        """The most opaque threshold that is found is the drawn opacity, at pixels of a perspective view into a tilted, moved mesh."""
        transfer = Transfer([(0, 1, 1, 1), (1, 0, 0, 1)], [(0.2, 0), (0.45, 1.5), (0.6, 0.1), (0.9, 2)])
        turn = np.array([[0, -2, 0, 3], [2, 0, 0, -1], [0, 0, 2, 0.5], [0, 0, 0, 1.0]])
        look = lambda s: s.look((8, 3, 7), (3, -1, 0.5), angle=30, near=0.5, far=40)  # noqa: E731
        inside = lambda s: s.look((3.1, -0.8, 0.6), (0, -1, 0.2), angle=50, near=1e-3, far=40)  # noqa: E731
        for kind, make in DATA.items():
            for view in (look, inside):
                with self.subTest(kind=kind, inside=view is inside):
                    data = meshes.with_field(make(), X)
                    scene, ours = self.scene(data, transfer, view, matrix=turn)
                    alpha = float_image(ours)[..., 3]
                    self.assertGreater(alpha[18, 20], 0.05)
                    for x, y in ((20, 18), (13, 21), (27, 11)):
                        drawn = alpha[y, x]
                        ours.SetPickOpacity(drawn + 0.002)
                        self.assertFalse(ours.Pick(scene.renderer, x, y))
                        self.assertEqual((ours.GetPickedCell(), ours.GetPickedPoint()), (-1, -1))
                        if drawn > 0.01:
                            place = self.pick(scene, ours, x, y, drawn - 0.002)
                            np.testing.assert_allclose(scene.view().pixels(place[None])[0], (x + 0.5, y + 0.5), atol=1e-3)

    def test_contour_surfaces(self):
        """Without a medium: the first surface that makes the ray as opaque as asked. In a medium: what comes first."""
        def surfaces(ours):
            for i, (value, opacity) in enumerate(((0.45, 0.5), (0.55, 0.25))):
                ours.SetContourValue(i, value)
                ours.SetContourOpacity(i, opacity)
            ours.SetCellInterpolation(self.interpolation)
        clear, thin = constant(0.0), constant(0.05)
        for kind, make in DATA.items():
            for self.interpolation in (0, 1):
                data = meshes.with_field(make(), X)
                for transfer, opacity, value in ((clear, 0.1, 0.55), (clear, 0.5, 0.45), (thin, 0.1, 0.55), (thin, 0.65, 0.45)):
                    with self.subTest(kind=kind, interpolation=self.interpolation, opacity=opacity):
                        scene, ours = self.scene(data, transfer, configure=surfaces)
                        place = self.pick(scene, ours, 23, 15, opacity)
                        self.assertAlmostEqual(place[2], (value - 0.5 - 0.2 * place[0]) / 0.1, 4)
                        self.assertAlmostEqual(ours.GetPickedScalar(), value, 5)
                        self.check_in_cell(data, ours, place)
                scene, ours = self.scene(data, clear, configure=surfaces)
                ours.SetPickOpacity(0.63)
                self.assertFalse(ours.Pick(scene.renderer, 23, 15))

    def test_contour_surfaces_of_another_array(self):
        data = meshes.with_field(meshes.with_field(DATA["grid"](), X), lambda c: 0 * c[:, 2] + 0.25, "cell")
        window = Window(SIZE)
        scene, ours = window.add_scene(), mapper()
        data.GetPointData().GetArray("s").SetName("t")
        ours.SetContourArrayName("t")
        ours.SetContourValue(0, 0.55)
        ours.SetContourOpacity(0, 1)
        scene.add_volume(ours, data, constant(0.0), association="cell")
        scene.look((0.03, 0.02, 5), (0.03, 0.02, 0), parallel_scale=0.8, near=0.1, far=20)
        window.render()
        place = self.pick(scene, ours, 23, 15)
        self.assertAlmostEqual(place[2], (0.05 - 0.2 * place[0]) / 0.1, 4)
        self.assertAlmostEqual(ours.GetPickedScalar(), 0.25, 5)

    def test_a_veil_is_looked_through(self):
        """Opacity 0.095 in front of what is dense: at the default the dense part is picked, at 0.05 the veil."""
        data = meshes.image((2, 2, 4), (1, 1, 0.5), (-1, -1, -1))
        meshes.with_field(data, lambda c: np.where(c[:, 2] > 0.5, 0.1, np.where(c[:, 2] > -0.5, 0.0, 1.0)), "cell")
        transfer = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (0.1, 0.2), (1, 5)])

        window = Window(SIZE)
        scene, ours = window.add_scene(), mapper()
        scene.add_volume(ours, data, transfer, association="cell")
        scene.look((0.03, 0.02, 5), (0.03, 0.02, 0), parallel_scale=0.8, near=0.1, far=20)
        window.render()
        self.assertEqual(ours.GetPickOpacity(), 0.1)
        self.assertTrue(ours.Pick(scene.renderer, 20, 18))
        self.assertLess(ours.GetPickPosition()[2], -0.5)
        self.assertAlmostEqual(ours.GetPickedScalar(), 1, 6)
        self.assertEqual(ours.GetPickedCell(), 3)
        place = self.pick(scene, ours, opacity=0.05)
        self.assertAlmostEqual(place[2], 1 + math.log1p(-0.05) / 0.2, 5)
        self.assertEqual(ours.GetPickedCell(), 3 * 4 + 3)

    def test_clipped_and_opaque(self):
        def clip(ours):
            plane = vtkPlane()
            plane.SetOrigin(0, 0, 0.25)
            plane.SetNormal(0, 0, -1)
            ours.AddClippingPlane(plane)
        data = meshes.with_field(DATA["grid"](), X)
        scene, ours = self.scene(data, configure=clip)
        self.assertAlmostEqual(self.pick(scene, ours, opacity=0.5)[2], 0.25 + math.log(0.5) / 2, 5)

        def ball(scene):
            source = vtkSphereSource()
            source.SetCenter(0, 0, 0.5)
            source.SetRadius(0.4)
            source.SetThetaResolution(60)
            source.SetPhiResolution(60)
            source.Update()
            scene.add_opaque(source.GetOutput(), (1, 0, 0))
        scene, ours = self.scene(data, before=ball)
        ours.SetPickOpacity(0.5)
        self.assertFalse(ours.Pick(scene.renderer, 20, 18), "the ball ends the ray")
        self.assertTrue(ours.Pick(scene.renderer, 5, 5), "beside the ball")

    def test_missing_values_are_holes(self):
        data = meshes.with_field(DATA["image"](), lambda p: np.where(p[:, 2] > 0.9, np.nan, X(p)))
        window = Window(SIZE)
        scene, ours = window.add_scene(), mapper()
        scene.add_volume(ours, data, constant(2.0))
        scene.look((0.03, 0.02, 5), (0.03, 0.02, 0), parallel_scale=0.8, near=0.1, far=20)
        window.render()
        self.assertAlmostEqual(self.pick(scene, ours, opacity=0.5)[2], 0.5 + math.log(0.5) / 2, 5)

    def test_trilinear_field(self):
        """The product x y is the field of VTK's cell, not that of any tetrahedra."""
        data = meshes.with_field(meshes.image((1, 1, 1), (2, 2, 2), (-1, -1, -1)), lambda p: p[:, 0] * p[:, 1])
        scene, ours = self.scene(data, configure=lambda m: m.SetCellInterpolationToTrilinear())
        place = self.pick(scene, ours, 30, 30)
        self.assertAlmostEqual(ours.GetPickedScalar(), place[0] * place[1], 5)
        self.assertGreater(ours.GetPickedScalar(), 0.1)

    def test_trilinear_field_of_the_opacity(self):
        """The same array for colour and for opacity gives the same pick as one array."""
        transfer = Transfer([(-1, 1, 1, 1), (1, 0, 0, 1)], [(-1, 0), (1, 3)])
        data = meshes.with_field(meshes.image((1, 1, 1), (2, 2, 2), (-1, -1, -1)), lambda p: p[:, 0] * p[:, 1])
        meshes.add_array(data.GetPointData(), meshes.vtk_to_numpy(data.GetPointData().GetArray("s")).copy(), "o")
        look = lambda s: s.look((2, 3, 4), (0, 0, 0), angle=30, near=0.1, far=20)  # noqa: E731
        places = []
        for opacity in ("", "o"):
            def configure(made, name=opacity):
                made.SetCellInterpolationToTrilinear()
                made.SetOpacityArrayName(name)
            scene, ours = self.scene(data, transfer, look, configure=configure)
            places.append(np.append(self.pick(scene, ours, 24, 20), ours.GetPickedScalar()))
        np.testing.assert_allclose(places[0], places[1], atol=1e-5)

    def test_nothing_there(self):
        data = meshes.with_field(DATA["image"](), X)
        scene, ours = self.scene(data, look=lambda s: s.look((0, 0, 5), parallel_scale=3, near=0.1, far=20))
        self.assertFalse(ours.Pick(scene.renderer, 2, 2))
        self.assertFalse(ours.Pick(scene.renderer, -5, 400))
        for wrong, clamped in ((0, 0.001), (1, 0.999), (-3, 0.001)):
            ours.SetPickOpacity(wrong)
            self.assertEqual(ours.GetPickOpacity(), clamped)

    def test_before_a_render(self):
        window, ours = Window(SIZE), mapper()
        scene = window.add_scene()
        with window.messages:
            self.assertFalse(ours.Pick(scene.renderer, 1, 1))
        self.assertIn("render first", " ".join(window.messages.errors))


if __name__ == "__main__":
    unittest.main(verbosity=2)
