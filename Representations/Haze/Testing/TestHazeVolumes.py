# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells and splats behind haze: every piece of the medium is hazed where it is, by quadrature along every ray."""
import time
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, splats
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.haze import Haze
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant

COLOR = (0.9, 0.4, 0.1)
HAZES = {
    "flat": Haze(0.12, 0.8, up=(0, 1, 0), base=-1.0),
    "globe": Haze(0.12, 0.8, 60.0, (0, -61, 0)),
}
LOOKS = {
    "perspective": lambda s: s.look((2.0, 1.5, 6.0), (0, 0, 0), angle=30),
    "parallel": lambda s: s.look((2.0, 1.5, 6.0), (0, 0, 0), parallel_scale=1.6),
}
SIZE = (48, 40)


def box_ends(origins, directions):
    """Where rays enter and leave the cube from -1 to 1; both 0 where they pass by."""
    with np.errstate(divide="ignore"):
        a, b = (-1 - origins) / directions, (1 - origins) / directions
    near, far = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
    return np.where(far > near, near, 0), np.where(far > near, far, 0)


def expected_cube(view, extinction, haze):
    near, far = box_ends(*view.rays()[:2])
    return expected_medium(view, extinction, haze, near, far)


def expected_medium(view, extinction, haze, near, far):
    """Emission of one colour from near to far, each piece dimmed by the medium in front and hazed where it is."""
    origins, directions, *_ = view.rays()
    nodes, weights = np.polynomial.legendre.leggauss(48)
    light = np.zeros((len(near), 3))
    for node, weight in zip(nodes, weights):
        s = 0.5 * (1 + node) * (far - near)
        share = 0.5 * weight * (far - near) * extinction * np.exp(-extinction * s)
        light += share[:, None] * haze.over(np.asarray(COLOR), haze.transparency(origins, directions, near + s, 60))
    alpha = -np.expm1(-extinction * (far - near))
    return np.concatenate([light, alpha[:, None]], axis=1).reshape(view.height, view.width, 4)


def hazed_scene(mapper, data, transfer, look, haze, association="point"):
    window = Window(SIZE)
    scene = window.add_scene()
    volume = scene.add_volume(mapper, data, transfer, association=association)
    look(scene)
    if haze:
        made = haze.make(nephoscope.vtkHaze)
        made.BackgroundOff()
        nephoscope.vtkHaze.SetHaze(scene.renderer, made)
    return window, scene, volume


class Cells(ImageTestCase):
    def draw(self, blocks, extinction, look, haze, method):
        data = meshes.with_field(meshes.image((blocks,) * 3, (2 / blocks,) * 3, (-1, -1, -1)), lambda p: np.full(len(p), 0.5))
        mapper = nephoscope.vtkCellCompositingMapper()
        getattr(mapper, "SetMethodTo" + method)()
        window, scene, _ = hazed_scene(mapper, data, constant(extinction, COLOR), look, haze)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return scene, float_image(mapper)

    def inside(self, view):
        near, far = box_ends(*view.rays()[:2])
        return (far - near > 0.5).reshape(view.height, view.width)

    def test_medium_on_globe_and_over_ground(self):
        for method in ("Rays", "Cells"):
            for (where, haze), (rays, look) in zip(HAZES.items(), LOOKS.items()):
                scene, image = self.draw(8, 0.7, look, haze, method)
                expected = expected_cube(scene.view(), 0.7, haze)
                mask = ~self.inside(scene.view())
                self.check_float(image, expected, f"{method}, {where}, {rays}", 2e-4, mask)

    def test_dense_medium(self):
        """Light comes from the front of thick cells, not from their middle."""
        scene, image = self.draw(2, 6.0, LOOKS["perspective"], HAZES["flat"], "Rays")
        mask = ~self.inside(scene.view())
        self.check_float(image, expected_cube(scene.view(), 6.0, HAZES["flat"]), "dense", 3e-3, mask)

    def test_error_falls_with_the_square_of_the_cell(self):
        errors = []
        for blocks in (1, 2, 4):
            scene, image = self.draw(blocks, 0.7, LOOKS["parallel"], HAZES["flat"], "Rays")
            difference = np.abs(image - expected_cube(scene.view(), 0.7, HAZES["flat"]))[self.inside(scene.view())]
            errors.append(difference.max())
        print("  cells of 2, 1, 0.5:", errors)
        self.assertLess(errors[1], errors[0] / 2.5)
        self.assertLess(errors[2], errors[1] / 2.5)

    def test_cells_of_several_scale_heights(self):
        """Haze changes within a cell by far more than along it elsewhere: it is fitted in several parts of the cell."""
        for where, haze in {"flat": Haze(2.0, 0.2, up=(0, 1, 0), base=-1.0), "globe": Haze(2.0, 0.2, 60.0, (0, -61, 0))}.items():
            for blocks in (1, 2):
                scene, image = self.draw(blocks, 0.3, LOOKS["parallel"], haze, "Rays")
                mask = ~self.inside(scene.view())
                self.check_float(image, expected_cube(scene.view(), 0.3, haze), f"{where}, {blocks} cells", 5e-3, mask)

    def test_cost(self):
        """Processor time of a frame with haze, by that of one without: 20 where every segment has the closed form, 1.3 where a polynomial has it."""
        data = meshes.with_field(meshes.image((24,) * 3, (1 / 12,) * 3, (-1, -1, -1)), lambda p: 0.5 + 0.3 * np.sin(9 * p[:, 0] + 5 * p[:, 1]))
        windows = []
        for haze in (None, HAZES["flat"]):
            window, _, _ = hazed_scene(nephoscope.vtkCellCompositingMapper(), data, constant(0.3, COLOR), LOOKS["perspective"], haze)
            window.window.SetSize(200, 200)
            window.render()
            windows.append(window)
        times = np.empty((5, 2))
        for pair in times:
            for i, window in enumerate(windows):
                start = time.process_time()
                window.render()
                pair[i] = time.process_time() - start
        ratio = np.divide(*times.min(axis=0)[::-1])
        print(f"  ratio {ratio:.2f}")
        self.assertLess(ratio, 3)

    def test_alpha_is_not_changed(self):
        for method in ("Rays", "Cells"):
            plain, hazed = (self.draw(3, 0.7, LOOKS["perspective"], haze, method)[1] for haze in (None, HAZES["globe"]))
            np.testing.assert_allclose(hazed[..., 3], plain[..., 3], atol=1e-6)
            self.assertGreater(np.abs(hazed - plain).max(), 0.05)

    def test_no_haze_is_identical(self):
        for method in ("Rays", "Cells"):
            plain, off = (self.draw(3, 0.7, LOOKS["perspective"], haze, method)[1] for haze in (None, Haze(0.0, 1.0)))
            np.testing.assert_array_equal(plain, off)


    def test_around_a_peeled_surface(self):
        """As ParaView draws: the medium in front of a translucent surface, the surface, and the medium behind it."""
        haze, color, opacity = HAZES["flat"], np.array((0.1, 0.8, 0.3)), 0.5
        for method in ("Rays", "Cells"):
            data = meshes.with_field(meshes.image((8,) * 3, (0.25,) * 3, (-1, -1, -1)), lambda p: np.full(len(p), 0.5))
            mapper = nephoscope.vtkCellCompositingMapper()
            getattr(mapper, "SetMethodTo" + method)()
            window, scene, _ = hazed_scene(mapper, data, constant(0.7, COLOR), LOOKS["perspective"], haze)
            corners = np.array([(-5, -5, 0.1), (5, -5, 0.1), (5, 5, 0.1), (-5, 5, 0.1)])
            scene.add_opaque(meshes.surface(corners, np.array([[0, 1, 2, 3]])), color).GetProperty().SetOpacity(opacity)
            scene.renderer.UseDepthPeelingOn()
            scene.renderer.UseDepthPeelingForVolumesOn()
            scene.renderer.SetMaximumNumberOfPeels(20)
            scene.renderer.SetOcclusionRatio(0)
            window.render()
            self.fail_on_messages(window)
            view = scene.view()
            origins, directions, *_ = view.rays()
            near, far = box_ends(origins, directions)
            at = (0.1 - origins[:, 2]) / directions[:, 2]
            front = expected_medium(view, 0.7, haze, near, np.clip(at, near, far))
            back = expected_medium(view, 0.7, haze, np.clip(at, near, far), far)
            surface = opacity * haze.over(color, haze.transparency(origins, directions, at)).reshape(view.height, view.width, 3)
            expected = front[..., :3] + (1 - front[..., 3:]) * (surface + (1 - opacity) * back[..., :3])
            self.check_bytes(scene.rgb(), expected, f"peeled, {method}", ~self.inside(view), 2.5 / 255)

    def test_contour_surfaces_where_they_are(self):
        """A plane in cells of a quarter of the cube; what is drawn without haze is hazed at their distances."""
        haze = HAZES["globe"]

        def draw(hazed):
            data = meshes.with_field(meshes.image((4,) * 3, (0.5,) * 3, (-1, -1, -1)), lambda p: 0.5 + 0.5 * p[:, 2])
            mapper = nephoscope.vtkCellCompositingMapper()
            mapper.SetContourValue(0, 0.55)
            mapper.SetContourOpacity(0, 0.6)
            mapper.SetContourColor(0, *COLOR)
            mapper.ContourLightingOff()
            window, scene, _ = hazed_scene(mapper, data, constant(0.0, COLOR), LOOKS["perspective"], haze if hazed else None)
            window.render()
            self.fail_on_messages(window)
            return scene.view(), float_image(mapper)

        view, plain = draw(False)
        _, hazed = draw(True)
        origins, directions, *_ = view.rays()
        distance = (0.1 - origins[:, 2]) / directions[:, 2]
        transparency = haze.transparency(origins, directions, distance).reshape(view.height, view.width)
        alpha = plain[..., 3]
        self.assertGreater((alpha > 0.5).sum(), 200)
        expected = np.concatenate([alpha[..., None] * haze.over(plain[..., :3] / np.maximum(alpha, 1e-9)[..., None], transparency),
                                   alpha[..., None]], axis=2)
        self.check_float(hazed, expected, "contour", 2e-4)

    def test_earlier_methods_say_that_they_have_none(self):
        for method in ("Faces", "TrianglesTable", "TrianglesLinear"):
            data = meshes.with_field(meshes.image((2, 2, 2)), lambda p: np.full(len(p), 0.5))
            mapper = nephoscope.vtkCellCompositingMapper()
            getattr(mapper, "SetMethodTo" + method)()
            window, _, _ = hazed_scene(mapper, data, constant(1.0, COLOR), LOOKS["perspective"], HAZES["flat"])
            for _ in range(2):
                window.render()
            self.assertEqual(len(window.messages.all), 1, window.messages.all)
            self.assertIn("without the haze", window.messages.all[0])


class Splats(ImageTestCase):
    def draw(self, look, haze, vectors=False, extinctions=(0.4, 1.6)):
        data = meshes.with_field(meshes.image((4, 3, 3), (0.5, 0.66, 0.66), (-1, -1, -1)), lambda p: 0.5 + 0.4 * np.sin(4 * p[:, 0] + p[:, 1]))
        transfer = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, extinctions[0]), (1, extinctions[1])])
        mapper = nephoscope.vtkTexturedSplatMapper()
        if vectors:
            meshes.add_array(data.GetPointData(), np.tile((0.3, 0.1, -0.2), (data.GetNumberOfPoints(), 1)), "v")
            mapper.SetVectorArrayName("v")
        window, scene, _ = hazed_scene(mapper, data, transfer, look, haze)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return data, scene.view(), transfer, float_image(mapper)

    def test_each_where_it_is(self):
        for (where, haze), (rays, look) in zip(HAZES.items(), LOOKS.items()):
            data, view, transfer, image = self.draw(look, haze)
            points = meshes.points_of(data)
            values = np.array([data.GetPointData().GetArray("s").GetValue(i) for i in range(len(points))])
            offsets = points - view.eye
            if view.parallel:
                lengths = offsets @ view.forward
                starts, directions = points - lengths[:, None] * view.forward, np.tile(view.forward, (len(points), 1))
            else:
                lengths = np.linalg.norm(offsets, axis=1)
                starts, directions = np.tile(view.eye, (len(points), 1)), offsets / lengths[:, None]
            colors = haze.over(transfer.color(values), haze.transparency(starts, directions, lengths))
            dimensions = tuple(data.GetDimensions())
            expected = splats.render(view, points, splats.lattice_jacobians(points, dimensions), colors,
                                     transfer.extinction(values) * splats.lattice_shares(dimensions))
            self.check_float(image, expected, f"splats, {where}, {rays}", 4e-4)

    def test_vectors(self):
        """Thick haze leaves its own colour, in their share, of splats and vectors."""
        _, _, _, plain = self.draw(LOOKS["perspective"], None, True, (0, 0))
        _, _, _, hazed = self.draw(LOOKS["perspective"], Haze(1e3, 1e3, up=(0, 1, 0)), True, (0, 0))
        self.assertGreater(plain[..., 3].max(), 0.2)
        np.testing.assert_allclose(hazed[..., 3], plain[..., 3], atol=1e-6)
        np.testing.assert_allclose(hazed[..., :3], plain[..., 3:] * (0.72, 0.8, 0.9), atol=1e-5)


if __name__ == "__main__":
    unittest.main()
