# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats against a picture made by quadrature along every ray."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, reference, splats
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer

# The footprint's polynomial is 1.5e-5 off; a splat may be several cells thick along a ray, and many overlap.
TOLERANCE = 2e-4
COLORS = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.4), (1, 1.6)])


def bent(points):
    x, y, z = (points - 0.5).T
    return np.stack([3 * x + 0.5 * z * y, 2 * y + 0.4 * x * x, 1.5 * z + 0.3 * x], axis=1)


def scene_data(kind):
    if kind == "image":
        data = meshes.image((4, 3, 2), (0.6, 0.9, 1.3), (-1, -1, -1))
    elif kind == "rectilinear":
        data = meshes.rectilinear([(-1, -0.6, 0.3, 1), (-1, 0, 0.5, 1.2), (-0.5, 0.5, 0.8)])
    else:
        data = meshes.structured((4, 3, 2), bent)
    return meshes.with_field(data, lambda p: (np.sin(3 * p[:, 0]) * np.cos(2 * p[:, 1] + p[:, 2]) + 1) / 2)


def expected(data, view, transfer, stop=None):
    points = meshes.points_of(data)
    jacobians = splats.lattice_jacobians(points, dimensions(data))
    values = np.array([data.GetPointData().GetArray("s").GetValue(i) for i in range(len(points))])
    return splats.render(view, points, jacobians, transfer.color(values), transfer.extinction(values) * splats.lattice_shares(dimensions(data), jacobians), stop)


def dimensions(data):
    if not data.IsA("vtkStructuredGrid"):
        return tuple(data.GetDimensions())
    result = [0, 0, 0]
    data.GetDimensions(result)
    return tuple(result)


class Rays(ImageTestCase):
    def draw(self, data, transfer, look, wall=None):
        window = Window((72, 60))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(mapper, data, transfer)
        if wall is not None:
            scene.add_opaque(wall, (0, 0.5, 0))
        look(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return scene, mapper, float_image(mapper)

    def check(self, kind, label, look):
        data = scene_data(kind)
        scene, _, image = self.draw(data, COLORS, look)
        self.check_float(image, expected(data, scene.view(), COLORS), f"{kind}, {label}", TOLERANCE)

    def test_every_grid_from_every_side(self):
        for kind in ("image", "rectilinear", "structured"):
            self.check(kind, "perspective", lambda s: s.look((3, 2.5, 6), (0, 0, 0), angle=35))
            self.check(kind, "parallel", lambda s: s.look((-4, 1.37, 2.9), (0, 0, 0), parallel_scale=2.5))

    def test_close_and_wide(self):
        """Close to the splats, where the eye sees each cell from another side."""
        self.check("structured", "close", lambda s: s.look((2.2, 1.6, 3.2), (0, 0, 0), angle=80))

    def test_eye_among_the_splats(self):
        """Part of each kernel lies behind the eye; the share that is seen is a polynomial, up to 8e-4 of a splat."""
        data = scene_data("structured")
        scene, _, image = self.draw(data, COLORS, lambda s: s.look((0.2, 0.1, 0.15), (-1, 0.2, -0.4), angle=70, near=1e-3, far=50))
        self.assertGreater(image[..., 3].max(), 0.3)
        self.check_float(image, expected(data, scene.view(), COLORS), "eye inside", 2e-3)

    def test_opaque_wall_cuts_splats(self):
        data = scene_data("image")
        quad = np.array([(-3, -3, 0.1), (3, -3, 0.1), (3, 3, -0.3), (-3, 3, -0.3)], float)
        triangles = np.array([quad[[0, 1, 2]], quad[[0, 2, 3]]])
        wall = meshes.surface(quad, [(0, 1, 2), (0, 2, 3)])
        scene, _, image = self.draw(data, COLORS, lambda s: s.look((1, 1, 7), (0, 0, 0), angle=35), wall)
        view = scene.view()
        stop = reference.opaque_distance(triangles, view)
        # The share of a cut kernel is a polynomial: up to 8e-4 of a splat.
        self.check_float(image, expected(data, view, COLORS, stop), "wall", 2e-3)


if __name__ == "__main__":
    unittest.main()
