# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clipping planes of the mapper cut every ray: against the reference, which ends its rays there, for rays and projected cells."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, reference
from nephoscope_testing.checks import SHIFTS, ImageTestCase, cells_of, forgive_shift, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant, random_transfer
from vtkmodules.vtkCommonDataModel import vtkPlane

TOLERANCE = 1e-4
EYE = np.array((1.9, 1.3, 4.1))
METHODS = ("Rays", "Projection")


def vtk_plane(origin, normal):
    plane = vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    return plane


def grid():
    data = meshes.image((3, 3, 3), (2 / 3,) * 3, (-1, -1, -1))
    return meshes.with_field(data, lambda p: 0.5 + 0.3 * p[:, 0] + 0.1 * p[:, 1] + 0.07 * p[:, 2])


def random_mesh(seed):
    rng = np.random.default_rng(seed)
    data = meshes.delaunay(rng, 30)
    return meshes.with_field(data, meshes.linear_field(rng, data))


def look(scene, eye=EYE, parallel=None, **options):
    scene.look(eye, (0, 0, 0), parallel_scale=parallel, near=0.01, far=20, **options)


class Clipping(ImageTestCase):
    def draw(self, data, transfer, planes, method="Rays", view=look, configure=None, surface=None, prepare=None, size=(48, 44)):
        window = Window(size)
        scene = window.add_scene()
        ours = mapper()
        getattr(ours, "SetMethodTo" + method)()
        for plane in planes:
            ours.AddClippingPlane(vtk_plane(*plane))
        if configure:
            configure(ours)
        scene.add_volume(ours, data, transfer)
        if surface:
            polydata, color, opacity = surface
            scene.add_opaque(polydata, color).GetProperty().SetOpacity(opacity)
            scene.renderer.UseDepthPeelingOn()
            scene.renderer.UseDepthPeelingForVolumesOn()
            scene.renderer.SetOcclusionRatio(0)
        if prepare:
            prepare(scene.renderer)
        view(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return scene, scene.rgb() if surface else float_image(ours)

    def check(self, data, planes, label, view=look, transfer=None):
        transfer = transfer or random_transfer(np.random.default_rng(4), 5, max_extinction=2.0)
        cells = cells_of(data)
        for method in METHODS:
            scene, image = self.draw(data, transfer, planes, method, view)

            def expected(seen):
                begin, end = reference.between_planes(seen, planes)
                return reference.render(cells, seen, transfer, np.maximum(begin, end), begin=begin)
            wanted = expected(scene.view())
            mask = edge_mask(cells.drawn_edges(), scene.view())
            if np.abs(image - wanted)[~mask].max(initial=0) > TOLERANCE:
                image = forgive_shift(image, wanted, [expected(scene.view().shifted(*s)) for s in SHIFTS], label)
            self.check_float(image, wanted, f"{label}, {method}", TOLERANCE, mask)
        return image

    def test_planes_anywhere(self):
        rng = np.random.default_rng(11)
        for i, count in enumerate((1, 1, 3, 6)):
            planes = [(rng.normal(size=3) * 0.3, rng.normal(size=3) * 10.0**rng.integers(-3, 4)) for _ in range(count)]
            view = (lambda s: look(s, parallel=1.6)) if i % 2 else look
            self.check((grid(), random_mesh(3))[i // 2], planes, f"{count} planes", view)

    def test_special_positions(self):
        data, side = grid(), np.cross(EYE, (0.3, 1, -0.2))
        for label, plane in {"through the eye": (EYE, side), "along cell faces": ((1 / 3, 0, 0), (1, 0, 0)),
                             "through vertices of the grid": ((1 / 3, 1 / 3, 1 / 3), (1, 1, 1)), "eye behind": ((0, 0, 0), -EYE),
                             "along the boundary": ((0, 1, 0), (0, -1, 0))}.items():
            self.assertGreater(self.check(data, [plane], label)[..., 3].max(), 0.3, label)
        for label, planes in {"all behind": [(10 * EYE, EYE)], "along the boundary, beyond": [((0, 1, 0), (0, 1, 0))],
                              "nothing between": [((0.1, 0, 0), (1, 0, 0)), ((0.1, 0, 0), (-1, 0, 0))]}.items():
            self.assertLess(self.check(data, planes, label)[..., 3].max(), 1e-5, label)

    def test_eye_inside(self):
        view = lambda s: s.look((0.13, 0.21, 0.08), (-1, 0.2, -0.4), angle=60, near=1e-3, far=10)
        for label, plane in (("eye in front", ((-0.4, 0, 0), (1, 0.2, 0.1))), ("eye behind", ((-0.4, 0, 0), (-1, -0.2, -0.1))),
                             ("through the eye", ((0.13, 0.21, 0.08), (0.3, 1, 0.2)))):
            self.check(grid(), [plane], "inside, " + label, view)

    def test_slab_in_closed_form(self):
        """A slab of a constant medium is left, seen along an axis: alpha = 1 - exp(-extinction thickness), exactly."""
        data = meshes.with_field(grid(), lambda p: 0 * p[:, 0])
        planes = [((0, 0, -0.35), (0, 0, 1)), ((0, 0, 0.3), (0, 0, -1))]
        for method in METHODS:
            _, image = self.draw(data, constant(1.5), planes, method, lambda s: s.look((0.01, 0.02, 5), (0.01, 0.02, 0), parallel_scale=0.9))
            np.testing.assert_allclose(image[..., 3], -np.expm1(-1.5 * 0.65), atol=2e-6)

    def test_contour_surfaces_are_clipped(self):
        """A plane between two contour surfaces leaves one; both sides let through, multiplied, what all lets through."""
        data = meshes.with_field(grid(), lambda p: p[:, 0])
        view = lambda s: s.look((5, 0.03, 0.07), (0, 0.03, 0.07), parallel_scale=0.9)

        def contours(*values):
            def configure(ours):
                for i, value in enumerate(values):
                    ours.SetContourValue(i, value)
                    ours.SetContourOpacity(i, 0.4)
                ours.SetContourLighting(False)
            return configure
        clear = Transfer([(-1, 1, 0.5, 0.2), (1, 0.2, 0.5, 1)], [(-1, 0), (1, 0)])
        plane = ((0.1, 0, 0), (1, 0, 0))
        _, clipped = self.draw(data, clear, [plane], "Automatic", view, contours(-0.31, 0.47))
        _, alone = self.draw(data, clear, [], "Automatic", view, contours(0.47))
        self.assertAlmostEqual(alone[20, 20, 3], 0.4, 5)
        self.check_float(clipped, alone, "one of two surfaces", 1e-5)
        oblique, medium = random_mesh(9), random_transfer(np.random.default_rng(2), 4, max_extinction=1.5)
        sides = [self.draw(oblique, medium, p, "Automatic", look, contours(0.3, 0.5, 0.7))[1][..., 3:]
                 for p in ([], [((0, 0, 0.1), (0.4, 0.2, 1))], [((0, 0, 0.1), (-0.4, -0.2, -1))])]
        difference = np.abs((1 - sides[1]) * (1 - sides[2]) - (1 - sides[0]))
        self.assertLess(np.quantile(difference, 0.995), 1e-4)

    def test_with_peels_and_haze(self):
        """Beside a surface that is hardly there, in haze, the clipped picture is the one without it."""
        plane = ((0.1, 0, 0.2), (0.5, 0.2, -1))
        points = np.array([(-5, -5, 0.3), (5, -5, 0.1), (5, 5, -0.2), (-5, 5, 0)], float)
        sheet = (meshes.surface(points, [(0, 1, 2), (0, 2, 3)]), (0, 0, 0), 1 / 255)

        def hazy(renderer):
            haze = nephoscope.vtkHaze()
            haze.SetProjectionToMap()
            haze.SetBaseLevel(-1)
            haze.SetScaleHeight(1.0)
            haze.SetExtinction(0.15)
            haze.SetColor(0.8, 0.4, 0.2)
            nephoscope.vtkHaze.SetHaze(renderer, haze)
        transfer = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.4), (1, 1.5)])
        for method in METHODS:
            pictures = []
            for surface in (None, sheet):
                scene, image = self.draw(grid(), transfer, [plane], method, surface=surface, prepare=hazy)
                pictures.append(scene.rgb())
            error = np.abs(pictures[0] - pictures[1])
            print(f"  {method}: {255 * error.max():.1f}/255")
            self.assertGreater(pictures[0].max(), 0.2)
            self.assertLess(error.max(), 4.5 / 255, method)

    def test_earlier_methods_say_that_they_do_not_clip(self):
        for method in ("TrianglesTable", "Faces"):
            window = Window((24, 24))
            scene = window.add_scene()
            ours = mapper()
            getattr(ours, "SetMethodTo" + method)()
            ours.AddClippingPlane(vtk_plane((0, 0, 0), (1, 0, 0)))
            scene.add_volume(ours, grid(), random_transfer(np.random.default_rng(4), 5))
            look(scene)
            window.render()
            window.render()
            self.assertEqual(len(window.messages.all), 1, window.messages.all)
            self.assertIn("without the clipping planes: choose another method", window.messages.warnings[0])


if __name__ == "__main__":
    unittest.main()
