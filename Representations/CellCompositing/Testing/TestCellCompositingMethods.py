# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The earlier methods err as theory says, and no more: linear opacity, the table, the mean colour, faces in any order.

Each law is evaluated here from the rays of the reference, not from the methods' own code.
"""
import unittest

import numpy as np
from nephoscope_testing import laws, meshes, reference
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.messages import Messages
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from nephoscope_testing.weather import forecast_globe
from vtkmodules.vtkFiltersSources import vtkSphereSource

TABLE_ERROR = 3.1e-5  # (16 / 1023)^2 / 8, of one tetrahedron
RED_TO_BLUE = [(0, 1, 0, 0), (1, 0, 0, 1)]
VIEWS = {"perspective": dict(), "parallel": dict(parallel=True)}


def random_mesh(seed, count=60):
    rng = np.random.default_rng(seed)
    data = meshes.delaunay(rng, count)
    return meshes.with_field(data, meshes.linear_field(rng, data))


class MethodsTestCase(ImageTestCase):
    def scene(self, data, transfer, look=None, size=(96, 96), association="point", matrix=None):
        """Scene, mapper, and the reference of what it shows with the pixels on edges of tetrahedra."""
        window = Window(size)
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer, association=association, matrix=matrix)
        look(scene) if callable(look) else scene.look_at(volume, **(look or {}))
        cells, view = cells_of(data, association, matrix=matrix), scene.view()
        return scene, ours, cells, reference.render(cells, view, transfer), edge_mask(cells.drawn_edges(), view)

    def draw(self, scene, ours, method):
        getattr(ours, "SetMethodTo" + method)()
        scene.window.render()
        self.fail_on_messages(scene.window, method)
        return float_image(ours)


class Triangles(MethodsTestCase):
    def single(self, depth):
        """The regular tetrahedron seen along z: thickness 2 in the middle, 0 on the silhouette."""
        data = meshes.tetrahedra([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2, 3)])
        meshes.with_field(data, lambda p: 0 * p[:, 0])
        look = lambda s: s.look((0, 0, 6), parallel_scale=1.05, near=1, far=12)
        return self.scene(data, constant(depth / 2), look, (129, 129))

    def test_linear_opacity_of_one_tetrahedron(self):
        for depth, law in ((0.1, 0.00119), (0.5, 0.02451), (1, 0.0779414), (2, 0.20513), (4, 0.40982)):
            scene, ours, _, expected, mask = self.single(depth)
            error = np.where(mask, 0, expected[..., 3] - self.draw(scene, ours, "TrianglesLinear")[..., 3])
            print(f"  linear opacity, optical depth {depth}: {error.max():.6f}, law {law}")
            self.assertAlmostEqual(error.max(), law, delta=1e-3 * law + 6e-6)
            self.assertGreater(error.min(), -1e-6, "always too transparent")

    def test_linear_opacity_is_predicted(self):
        """Many tetrahedra, varying extinction and colour: the law of each, composited along the rays, is the picture."""
        for seed, transfer in ((1, constant(2.0)), (2, Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0.3), (1, 4)])),
                               (3, Transfer(RED_TO_BLUE, [(0, 0.3), (1, 4)]))):
            data = random_mesh(seed)
            scene, ours, cells, expected, mask = self.scene(data, transfer, dict(parallel=True))
            image = self.draw(scene, ours, "TrianglesLinear")
            predicted = laws.linear_opacity(cells, scene.view(), transfer)
            self.check_float(image, predicted, f"linear opacity, seed {seed}, against its law", 1e-4, mask)
            self.assertGreater(Difference(image, expected, mask).maximum, 0.05, "the artefact must be seen")

    def test_table_of_one_tetrahedron(self):
        for depth in (0.1, 1, 4, 12, 30):
            scene, ours, _, expected, mask = self.single(depth)
            self.check_float(self.draw(scene, ours, "TrianglesTable"), expected, f"table, optical depth {depth}",
                             TABLE_ERROR + 2e-6, mask)

    def test_table_of_one_colour(self):
        """One colour, varying extinction, either projection: the table's error, once per tetrahedron crossed."""
        transfer = Transfer([(0, 1, 0.5, 0.2), (1, 1, 0.5, 0.2)], [(0, 0.3), (1, 4)])
        for label, look in VIEWS.items():
            scene, ours, cells, expected, mask = self.scene(random_mesh(4), transfer, look)
            error = np.abs(self.draw(scene, ours, "TrianglesTable") - expected).max(axis=2)
            crossed = np.bincount(reference.ray_segments(cells, scene.view())[0], minlength=error.size).reshape(error.shape)
            bound = crossed * TABLE_ERROR * (1 - expected[..., 3]) + 2e-5
            print(f"  table, one colour, {label}: {np.where(mask, 0, error).max():.3g}, up to {crossed.max()} tetrahedra")
            self.assertTrue((mask | (error <= bound)).all(), label)
            self.assertGreater(error.max(), 2e-5, "the table must be seen")

    def test_table_has_the_mean_colour(self):
        """The paper's rule errs by E (C_back - C_front) in each tetrahedron; the reference draws that rule, too."""
        transfer = Transfer(RED_TO_BLUE, [(0, 0.5), (1, 6)])
        for label, look in VIEWS.items():
            scene, ours, cells, expected, mask = self.scene(random_mesh(5), transfer, look)
            image = self.draw(scene, ours, "TrianglesTable")
            rule = reference.render(cells, scene.view(), transfer, integration="average")
            self.check_float(image, rule, f"table against the average rule, {label}", 6e-4, mask)
            self.assertGreater(Difference(image, expected, mask).maximum, 0.005, "the rule's error must be seen")

    def test_error_of_the_mean_colour(self):
        """Through the tip of a tetrahedron along z, L = 1, colour 0 to 1: I_average - I = E."""
        data = meshes.tetrahedra([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0.5, 0.5, 1)], [(0, 1, 2, 3)])
        meshes.with_field(data, lambda p: p[:, 2])
        look = lambda s: s.look((0.5, 0.5, -5), (0.5, 0.5, 0), parallel_scale=1, near=0.5, far=20)
        for tm, r, law in ((1, 0, 0.05182), (2, 0.5, 0.06060), (4, -1, 0.35849), (0.5, 1, -0.05236)):
            ends = [(0, tm * (1 - r)), (1, tm * (1 + r))]  # z = 0 is in front
            scene, ours, *_ = self.scene(data, Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], ends), look, (33, 33))
            average = self.draw(scene, ours, "TrianglesTable")[16, 16, 0]
            exact = self.draw(scene, ours, "Cells")[16, 16, 0]
            print(f"  tm {tm}, r {r}: {average - exact:+.5f}, law {law:+.5f}")
            self.assertAlmostEqual(average - exact, law, delta=4e-5)

    def test_what_cannot_be_projected_is_said(self):
        data = random_mesh(6)
        inside = lambda s: s.look((0.2, 0.1, 0), (0, 0, -1), near=0.01, far=5)
        for method in ("TrianglesLinear", "TrianglesTable"):
            scene, ours, *_ = self.scene(data, constant(), inside)
            getattr(ours, "SetMethodTo" + method)()
            scene.window.render()
            scene.window.render()
            warnings = [m for m in scene.window.messages.all if "tetrahedra are not drawn" in m and "SetMethodToCells" in m]
            self.assertEqual(len(warnings), 1, "one warning, not one per frame")
            self.assertEqual(len(scene.window.messages.all), 1)


class Faces(MethodsTestCase):
    def test_one_medium_in_any_order(self):
        for label, look in dict(VIEWS, inside=lambda s: s.look((0.2, 0.1, 0), (0, 0, -1), near=0.01, far=5),
                                cut=lambda s: s.look((0, 0.2, 3), near=2.6, far=5)).items():
            for integration in ("Exact", "Average"):
                scene, ours, _, expected, mask = self.scene(random_mesh(7), constant(3.0, (1, 0.5, 0.2)), look)
                getattr(ours, "SetIntegrationTo" + integration)()
                for order in ("Centroid", "None"):
                    getattr(ours, "SetVisibilityOrderTo" + order)()
                    self.check_float(self.draw(scene, ours, "Faces"), expected,
                                     f"faces, one medium, {label}, {integration}, order {order}", 2e-5, mask)

    def test_one_tetrahedron(self):
        """Two faces at each pixel: right in either order, since what is nearer is known."""
        transfer = Transfer(RED_TO_BLUE, [(0, 0.5), (1, 4)])
        data = meshes.tetrahedra(np.random.default_rng(3).normal(size=(4, 3)), [(0, 1, 2, 3)])
        meshes.with_field(data, meshes.linear_field(np.random.default_rng(4), data))
        for integration in ("Exact", "Average"):
            scene, ours, cells, _, mask = self.scene(data, transfer)
            getattr(ours, "SetIntegrationTo" + integration)()
            expected = reference.render(cells, scene.view(), transfer, integration=integration.lower())
            for order in ("Centroid", "None"):
                getattr(ours, "SetVisibilityOrderTo" + order)()
                self.check_float(self.draw(scene, ours, "Faces"), expected, f"one tetrahedron, {integration}, {order}", 2e-6, mask)

    def test_linear_medium(self):
        """Going back and forth in a medium that is linear along the ray is the same integral."""
        data = meshes.with_field(meshes.Lattice((1, 1, 6)).mesh("hexahedron"), lambda p: p[:, 2])
        look = lambda s: s.look((0.4, 0.3, -5), (0.5, 0.5, 0.5), angle=14, near=1, far=10)
        scene, ours, _, expected, mask = self.scene(data, Transfer(RED_TO_BLUE, [(0, 1), (1, 4)]), look)
        self.check_float(self.draw(scene, ours, "Faces"), expected, "column of cells", 2e-6, mask)

    def test_wrong_order_shows_where_the_medium_varies(self):
        transfer = Transfer(RED_TO_BLUE, [(0, 0.5), (1, 6)])
        scene, ours, _, expected, mask = self.scene(random_mesh(8, 150), transfer)
        ours.SetVisibilityOrderToNone()
        error = Difference(self.draw(scene, ours, "Faces"), expected, mask)
        print(f"  input order: {error}")
        self.assertGreater(error.maximum, 0.05)

    def test_mistakes_stay_a_picture(self):
        """A narrow peak in the wrong order takes back more than there was; what is left is not negative."""
        peaks = Transfer(RED_TO_BLUE, [(0, 0), (0.4, 0), (0.42, 40), (0.44, 0), (1, 0)])
        for order in ("Centroid", "None"):
            scene, ours, *_ = self.scene(random_mesh(8, 150), peaks)
            getattr(ours, "SetVisibilityOrderTo" + order)()
            image = self.draw(scene, ours, "Faces")
            self.assertTrue((image >= 0).all() and (image[..., 3] <= 1).all(), order)
            self.assertGreater(image.max(), 0.1, order)

    def test_cell_scalars_and_holes(self):
        """Values that jump from cell to cell; transparent cells leave gaps in the volume. One layer deep: no order to mistake."""
        data = meshes.Lattice((4, 4, 1)).mesh("voxel")
        rng = np.random.default_rng(9)
        meshes.add_array(data.GetCellData(), rng.permutation(np.linspace(0, 1, 16)))
        transfer = Transfer(RED_TO_BLUE, [(0, 0), (0.4, 0), (1, 5)])
        for label, look in (("parallel", dict(direction=(0.05, 0.02, 1), parallel=True)),
                            ("perspective", dict(direction=(0.05, 0.02, 1), angle=3))):
            scene, ours, cells, expected, mask = self.scene(data, transfer, look, association="cell")
            self.check_float(self.draw(scene, ours, "Faces"), expected, f"cell scalars, {label}", 2e-5, mask)

    def test_opacity_from_another_array(self):
        data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
        meshes.add_array(data.GetPointData(), 10 + 10 * meshes.points_of(data)[:, 2], "o")
        transfer = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 0), (20, 2)])
        for method in ("Cells", "Faces"):
            window = Window((64, 64))
            scene = window.add_scene()
            ours = mapper()
            ours.SetOpacityArrayName("o")
            scene.add_volume(ours, data, transfer)
            scene.look((0.5, 0.5, -5), (0.5, 0.5, 0.5), parallel_scale=1, near=0.5, far=20)
            image = self.draw(scene, ours, method)[17:47, 17:47]
            error = np.abs(image - np.array([0.338529198658] * 3 + [1 - 0.223130160148])).max()
            self.assertLess(error, 2e-6, method)


class Scenes(MethodsTestCase):
    METHODS = ("Cells", "TrianglesTable", "Faces")

    def test_opaque_geometry_ends_rays(self):
        """One colour, so that every method is right."""
        transfer, color = constant(2.0, (1, 0.5, 0.2)), (0.1, 0.6, 0.3)
        for label, look in VIEWS.items():
            data = random_mesh(10)
            ball = vtkSphereSource()
            ball.SetRadius(0.4)
            ball.SetCenter(0.2, -0.1, 0.1)
            ball.Update()
            scene, ours, cells, _, mask = self.scene(data, transfer, look)
            scene.add_opaque(ball.GetOutput(), color)
            triangles = meshes.triangles_of(ball.GetOutput())
            view = scene.view()
            expected = reference.render(cells, view, transfer, reference.opaque_distance(triangles, view))
            mask |= edge_mask(np.stack([triangles, np.roll(triangles, 1, 1)], 2).reshape(-1, 2, 3), view)
            for method in self.METHODS:
                self.check_float(self.draw(scene, ours, method), expected, f"opaque ball, {method}, {label}", 6e-4, mask)

    def test_prop_transforms(self):
        """Stretched, mirrored, turned and moved."""
        matrix = np.array([[0, -1.5, 0, 3], [1, 0, 0.2, -1], [0, 0, -0.7, 2], [0, 0, 0, 1]])
        for label, flip in (("turned", 1), ("mirrored", -1)):
            m = matrix @ np.diag([flip, 1, 1, 1])
            scene, ours, _, expected, mask = self.scene(random_mesh(11), constant(1.0, (1, 0.5, 0.2)), matrix=m)
            for method in self.METHODS:
                self.check_float(self.draw(scene, ours, method), expected, f"{label}, {method}", 6e-4, mask)

    def test_methods_by_turns(self):
        """Nothing of one method is left in the picture of another."""
        scene, ours, *_ = self.scene(random_mesh(12), Transfer(RED_TO_BLUE, [(0, 0.5), (1, 3)]))
        methods = ("Cells", "TrianglesLinear", "TrianglesTable", "Faces")
        first = {m: self.draw(scene, ours, m) for m in methods}
        for method in reversed(methods):
            np.testing.assert_array_equal(self.draw(scene, ours, method), first[method], method)
        self.assertEqual(scene.window.gl_errors(), [])

    def test_every_pixel_is_a_number(self):
        """A globe seen along its axis: thousands of faces edge-on, some too narrow to interpolate over."""
        window = Window((600, 600))
        scene = window.add_scene()
        ours = mapper()
        data = forecast_globe()
        scene.add_volume(ours, data, Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (0.05, 0), (1, 1)], unit_distance=2e5),
                         "cloud_fraction")
        scene.renderer.ResetCamera()
        for method in ("Cells", "TrianglesLinear", "TrianglesTable", "Faces"):
            image = self.draw(scene, ours, method)
            self.assertTrue(np.isfinite(image).all(), f"{method}: {np.argwhere(~np.isfinite(image))[:5]}")
            self.assertTrue((image >= 0).all() and (image[..., 3] <= 1 + 1e-5).all(), method)
            self.assertGreater(image[..., 3].max(), 0.5, method)

    def test_viewport_resize_and_release(self):
        window = Window((120, 80))
        scene = window.add_scene(viewport=(0.25, 0, 1, 1))
        ours, data, transfer = mapper(), random_mesh(13), constant(1.0)
        scene.look_at(scene.add_volume(ours, data, transfer))
        for size in ((120, 80), (61, 97)):
            window.window.SetSize(*size)
            for method in self.METHODS:
                image = self.draw(scene, ours, method)
                expected = reference.render(cells_of(data), scene.view(), transfer)
                self.check_float(image, expected, f"{size}, {method}", 6e-4, edge_mask(cells_of(data).drawn_edges(), scene.view()))
                self.check_bytes(scene.rgb(), expected[..., :3], f"{size}, {method}", edge_mask(cells_of(data).drawn_edges(), scene.view()))
        ours.ReleaseGraphicsResources(window.window)
        self.draw(scene, ours, "Faces")
        self.assertEqual(window.gl_errors(), [])

    def test_pictures_of_any_size_can_be_read(self):
        """Rows of bytes without alpha are no whole words: what a method leaves in OpenGL's pixel store must be what VTK takes it for."""
        transfer = constant(1.0, (1, 0.5, 0.2))
        for size in ((301, 203), (302, 201), (303, 202)):
            scene, ours, cells, expected, mask = self.scene(random_mesh(14), transfer, dict(parallel=True), size)
            for method in ("Rays", "TrianglesLinear") + self.METHODS:
                getattr(ours, "SetMethodTo" + method)()
                scene.window.render()
                self.fail_on_messages(scene.window, method)
                picture = laws.linear_opacity(cells, scene.view(), transfer) if method == "TrianglesLinear" else expected
                self.check_bytes(scene.window.rgba(alpha=False), picture[..., :3], f"{size}, {method}", mask)

    def test_no_such_method(self):
        ours = mapper()
        before = ours.GetMethod()
        with Messages() as messages:
            ours.SetMethod(77)
        self.assertEqual(ours.GetMethod(), before)
        self.assertTrue(any("no method 77" in m for m in messages.all), messages.all)


if __name__ == "__main__":
    unittest.main(verbosity=2)
