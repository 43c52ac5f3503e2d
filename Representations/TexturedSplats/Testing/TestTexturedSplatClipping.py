# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clipping planes cut the kernel of every splat along every ray: against quadrature, closed forms and laws."""
import math
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, reference, splats
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection, vtkPlanes

# The footprint's polynomial is 1.5e-5 off; a splat may be several cells thick along a ray, and many overlap.
TOLERANCE = 2e-4
COLORS = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.6), (1, 2.0)])
EYE = (3.1, 2.2, 6)


def vtk_plane(origin, normal):
    plane = vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    return plane


def bent(points):
    x, y, z = (points - 0.5).T
    return np.stack([3 * x + 0.5 * z * y, 2 * y + 0.4 * x * x, 1.5 * z + 0.3 * x], axis=1)


def block(warp=None):
    data = meshes.image((3, 2, 2), (0.7, 0.9, 0.8), (-1, -0.9, -0.8)) if warp is None else meshes.structured((3, 2, 2), warp)
    return meshes.with_field(data, lambda p: (np.sin(3 * p[:, 0]) * np.cos(2 * p[:, 1] + p[:, 2]) + 1) / 2)


class Clipping(ImageTestCase):
    def draw(self, data, planes, look, transfer=COLORS, configure=None, wall=None, size=(36, 32), matrix=None):
        window = Window(size)
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        for plane in planes:
            mapper.AddClippingPlane(vtk_plane(*plane))
        if configure:
            configure(mapper)
        scene.add_volume(mapper, data, transfer, matrix=matrix)
        if wall is not None:
            scene.add_opaque(wall, (0, 0.5, 0))
        look(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return scene, float_image(mapper)

    def check(self, data, planes, look, label):
        scene, image = self.draw(data, planes, look)
        points = meshes.points_of(data)
        dimensions = [0, 0, 0]
        data.GetDimensions(dimensions) if data.IsA("vtkStructuredGrid") else dimensions.__setitem__(slice(None), data.GetDimensions())
        jacobians = splats.lattice_jacobians(points, tuple(dimensions))
        values = np.array([data.GetPointData().GetArray("s").GetValue(i) for i in range(len(points))])
        view = scene.view()
        begin, end = reference.between_planes(view, planes)
        shares = splats.lattice_shares(dimensions, jacobians if data.IsA("vtkStructuredGrid") else None)
        extinctions = COLORS.extinction(values) * shares
        expected = splats.render(view, points, jacobians, COLORS.color(values), extinctions, np.maximum(begin, end), begin)
        self.check_float(image, expected, label, TOLERANCE)
        return image

    def test_planes_anywhere(self):
        rng = np.random.default_rng(5)
        looks = (("perspective", lambda s: s.look(EYE, (0, 0, 0), angle=35)), ("parallel", lambda s: s.look(EYE, (0, 0, 0), parallel_scale=2.2)),
                 ("close", lambda s: s.look((1.2, 1.0, 2.4), (0, 0, 0), angle=70)))
        for i, count in enumerate((1, 1, 2, 6)):
            planes = [(rng.normal(size=3) * 0.4, rng.normal(size=3) * 10.0**rng.integers(-3, 4)) for _ in range(count)]
            self.check(block(bent if i % 2 else None), planes, looks[i % 3][1], f"{count} planes, {looks[i % 3][0]}")
        self.check(block(), [((0, 0, 0.2), (0.2, 0.3, -1))], lambda s: s.look((0.1, 0.2, 0.35), (-1, 0.2, -0.4), angle=70, near=1e-3, far=50),
                   "eye among the splats")

    def test_special_positions(self):
        look = lambda s: s.look(EYE, (0, 0, 0), angle=35)
        data = block()
        eye, side = np.array(EYE), np.cross(EYE, (0.3, 1, -0.2))
        for label, plane in {"through the eye": (eye, side), "through the eye, backwards": (eye, -side), "through centres": ((0.4, 0, 0), (1, 0, 0)),
                             "through the middle": ((0, 0, 0), (0, 1, 0)), "eye behind": ((0, 0, 0), -eye), "eye in front": ((0, 0, 0), eye)}.items():
            image = self.check(data, [plane], look, label)
            self.assertGreater(image[..., 3].max(), 0.3, label)
        for label, planes in {"all behind": [(10 * eye, eye)], "beside": [((0, 30, 0), (0, 1, 0))],
                              "nothing between": [((0, 0, 0), (1, 0, 0)), ((-1e-3, 0, 0), (-1, 0, 0))]}.items():
            self.assertLess(self.check(data, planes, look, label)[..., 3].max(), 1e-6, label)
        self.assertGreater(self.check(data, [(-10 * eye, eye)], look, "nothing behind")[..., 3].max(), 0.5)

    def test_gaussian_is_an_error_function(self):
        """One splat seen in parallel: optical depth = footprint * (1 + erf(z / sqrt(2 variance))) / 2, z from the centre to the plane."""
        data = meshes.particles(np.zeros((1, 3)))
        meshes.add_array(data.GetPointData(), np.ones(1))
        variance = 0.199406
        for height, tilt in ((0.0, 0.0), (0.5, 0.0), (-0.3, 0.4), (0.2, -1.1)):
            def gaussian(mapper):
                mapper.SetKernelToGaussian()
                mapper.SetCellSize(1)
            scene, image = self.draw(data, [((0, 0, height), (-tilt, 0, 1))], lambda s: s.look((0, 0, 9), (0, 0, 0), parallel_scale=2),
                                     constant(2.0), gaussian)
            origins = scene.view().rays()[0].reshape(*image.shape[:2], 3)
            x, y = origins[..., 0], origins[..., 1]
            footprint = np.exp(-0.5 * (x * x + y * y) / variance) / (2 * np.pi * variance)
            cut = height + tilt * x  # in front of it lies what is seen
            part = 0.5 * (1 - np.vectorize(math.erf)(cut / math.sqrt(2 * variance)))
            expected = -np.expm1(-2 * np.where(np.hypot(x, y) < 1.916, footprint, 0) * part)
            self.check_float(image[..., 3:], expected[..., None], f"gaussian, plane at {height} + {tilt} x", 1e-5)

    def test_half_of_a_ball(self):
        """The middle plane leaves half of the optical depth, whatever the kernel and the side."""
        data = meshes.particles(np.zeros((1, 3)))
        meshes.add_array(data.GetPointData(), np.ones(1))
        for kernel in range(3):
            def configure(mapper):
                mapper.SetKernel(kernel)
                mapper.SetCellSize(1)
            look = lambda s: s.look((0, 0, 9), (0, 0, 0), parallel_scale=2)
            depth = [-np.log1p(-self.draw(data, planes, look, constant(1.0), configure)[1][..., 3])
                     for planes in ([], [((0, 0, 0), (0, 0, 1))], [((0, 0, 0), (0, 0, -1))])]
            self.assertGreater(depth[0].max(), 0.2)
            np.testing.assert_allclose(depth[1], depth[0] / 2, atol=2e-6)
            np.testing.assert_allclose(depth[2], depth[0] / 2, atol=2e-6)

    def test_two_sides_make_the_whole(self):
        """What both sides of a plane let through is, multiplied, what all lets through: vectors and hierarchy as well."""
        data = block()
        rng = np.random.default_rng(8)
        meshes.add_array(data.GetPointData(), rng.normal(size=(data.GetNumberOfPoints(), 3)), "v")
        look = lambda s: s.look(EYE, (0, 0, 0), angle=35)
        wall = meshes.surface(np.array([(-3, -3, -0.2), (3, -3, -0.2), (3, 3, 0.2), (-3, 3, 0.2)], float), [(0, 1, 2), (0, 2, 3)])
        for label, configure, behind in (("splats", None, None), ("wall", None, wall), ("hierarchy", lambda m: m.SetErrorTolerance(0.4), None),
                                         ("streaks", splats.with_vectors(0, 0), None), ("segments", splats.with_vectors(1, 0), wall),
                                         ("layers", splats.with_vectors(0, 1), None)):
            beyond = [((0, 0, -50), (0, 0, 1))]  # cuts nothing, but makes the share before the wall exact
            planes = [beyond if behind else [], [((0.1, 0, 0), (1, 0.3, 0.7))], [((0.1, 0, 0), (-1, -0.3, -0.7))]]
            light = [1 - self.draw(data, p, look, configure=configure, wall=behind)[1][..., 3:] for p in planes]
            self.assertLess(light[1].min(), 0.8)
            self.check_float(light[1] * light[2], light[0], label, 3e-5)

    def test_moved_actor_and_planes_of_the_world(self):
        """Planes are in world coordinates and stay while the actor turns; SetClippingPlanes takes collections and vtkPlanes."""
        turn = np.array([[0, -1, 0, 0.3], [1, 0, 0, -0.2], [0, 0, 1, 0.1], [0, 0, 0, 1.0]])
        look = lambda s: s.look(EYE, (0, 0, 0), angle=35)
        plane = ((0.1, 0.2, 0), (0.5, 1, 0.3))
        _, by_actor = self.draw(block(bent), [plane], look, matrix=turn)
        turned = meshes.structured((3, 2, 2), lambda p: bent(p) @ turn[:3, :3].T + turn[:3, 3])
        turned.GetPointData().AddArray(block(bent).GetPointData().GetArray("s"))
        _, by_data = self.draw(turned, [plane], look)
        self.check_float(by_actor, by_data, "moved actor", 2e-5)
        collection = vtkPlaneCollection()
        collection.AddItem(vtk_plane(*plane))
        box = vtkPlanes()
        box.SetBounds(-0.5, 0.6, -0.4, 0.5, -0.6, 0.3)
        _, one = self.draw(turned, [], look, configure=lambda m: m.SetClippingPlanes(collection))
        np.testing.assert_array_equal(one, by_data)
        _, inside = self.draw(turned, [], look, configure=lambda m: m.SetClippingPlanes(box))
        _, whole = self.draw(turned, [], look)
        self.assertLess(inside[..., 3].sum(), 0.7 * whole[..., 3].sum())

    def test_planes_that_are_none(self):
        for plane in (((0, 0, 0), (0, 0, 0)), ((np.nan, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, np.inf, 1))):
            window = Window((16, 16))
            scene = window.add_scene()
            mapper = nephoscope.vtkTexturedSplatMapper()
            mapper.AddClippingPlane(vtk_plane(*plane))
            scene.add_volume(mapper, block(), COLORS)
            scene.look(EYE)
            window.render()
            window.render()
            self.assertEqual(len(window.messages.errors), 1)
            self.assertIn("Clipping plane 0 needs a finite origin", window.messages.errors[0])


if __name__ == "__main__":
    unittest.main()
