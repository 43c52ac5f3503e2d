# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A dense block of skewed cells in many views, against quadrature along every ray; and in a mirror."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, reference, splats
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer

TOLERANCE = 2e-4  # the footprint's polynomial, some twenty splats deep
NEAR_TOLERANCE = 2e-3  # the share of a kernel in front of the eye is a polynomial, up to 8e-4 of a splat
COLORS = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.4), (1, 1.6)])
BLOCKS = (3, 2, 2)
RNG = np.random.default_rng(3)
SKEW = np.eye(3) * 3 + RNG.uniform(-1, 1, (3, 3))
TURN = np.linalg.qr(RNG.normal(size=(3, 3)))[0]
EYE = np.array((5.0, 4.0, 9.0))


def bent(points):
    p = points - 0.5
    return p @ SKEW.T + 0.4 * np.sin(3 * p[:, [1, 2, 0]])


def block(scale=1.0, offset=0.0, mirror=(1, 1, 1)):
    data = meshes.structured(BLOCKS, lambda p: scale * bent(p) * mirror + offset)
    meshes.add_array(data.GetPointData(), (np.sin(3 * np.arange(data.GetNumberOfPoints())) + 1) / 2)
    return data


class Views(ImageTestCase):
    def draw(self, data, look, transfer=COLORS, matrix=None):
        window = Window((48, 42))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(mapper, data, transfer, matrix=matrix)
        look(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return scene, float_image(mapper)

    def check(self, label, look, tolerance=TOLERANCE, matrix=None, scale=1.0, offset=0.0, planes=None):
        data = block(scale, offset)
        transfer = Transfer(COLORS.colors, COLORS.opacities * (1, 1 / scale))
        scene, image = self.draw(data, look, transfer, matrix)
        points = meshes.points_of(data)
        dimensions = tuple(n + 1 for n in BLOCKS)
        jacobians = splats.lattice_jacobians(points, dimensions)
        if matrix is not None:
            points = points @ matrix[:3, :3].T + matrix[:3, 3]
            jacobians = matrix[:3, :3] @ jacobians
        values = np.array([data.GetPointData().GetArray("s").GetValue(i) for i in range(len(points))])
        extinctions = transfer.extinction(values) * splats.lattice_shares(dimensions)
        begin, end = reference.between_planes(scene.view(), planes) if planes else (None, None)
        expected = splats.render(scene.view(), points, jacobians, transfer.color(values), extinctions, stop=end, begin=begin)
        self.assertGreater(expected[..., 3].max(), 0.25, label)
        self.check_float(image, expected, label, tolerance)

    def test_planes_of_the_camera(self):
        """They end the rays, as those of cells."""
        along = -EYE / np.linalg.norm(EYE)
        near, far = np.linalg.norm(EYE) - 0.5, np.linalg.norm(EYE) + 0.3
        planes = [(EYE + near * along, along), (EYE + far * along, -along)]
        self.check("near and far plane inside", lambda s: s.look(EYE, (0, 0, 0), angle=35, near=near, far=far), planes=planes)
        self.check("the same, parallel", lambda s: s.look(EYE, (0, 0, 0), parallel_scale=2.5, near=near, far=far), planes=planes)
        inside = 0.2 * along
        self.check("parallel, the eye inside", lambda s: s.look(inside, inside + along, parallel_scale=2.5, near=0.01, far=50),
                   planes=[(inside + 0.01 * along, along)])

    def test_wide_angles(self):
        self.check("wide angle beside", lambda s: s.look((3.6, 1.9, 2.5), (0.3, 0, 0), angle=115, near=1e-2, far=50), NEAR_TOLERANCE)

    def test_far(self):
        """Drawn to first order in the size of splats over their distance, from about the nearest place where they are."""
        self.check("far", lambda s: s.look(45 * EYE, (0, 0, 0), angle=0.78), tolerance=1.5e-4)

    def test_eye_anywhere_inside(self):
        rng = np.random.default_rng(8)
        for i in range(3):
            eye, ahead, angle = rng.uniform(-1.6, 1.6, 3), rng.uniform(-1, 1, 3), rng.uniform(40, 100)
            self.check(f"inside {i}", lambda s: s.look(eye, eye + ahead, angle=angle, near=1e-3, far=50), NEAR_TOLERANCE)

    def test_middle_of_the_view_elsewhere(self):
        def look(scene):
            scene.look(EYE, (0, 0, 0), angle=35)
            scene.camera.SetWindowCenter(0.4, -0.3)
        self.check("window centre", look)

    def test_matrices_of_the_volume(self):
        shear = np.array([[1, 0.6, 0], [0, 1, 0.2], [0, 0, 1.0]])
        for label, linear in (("mirrored", TURN @ np.diag([-1, 1, 1])), ("stretched", TURN @ np.diag([1, 0.4, 1.7])), ("sheared", shear)):
            matrix = np.eye(4)
            matrix[:3, :3], matrix[:3, 3] = linear, (0.3, -0.2, 0.1)
            self.check(label, lambda s: s.look(EYE, (0, 0, 0), angle=35), matrix=matrix)
        self.check("sheared, parallel", lambda s: s.look(EYE, (0, 0, 0), parallel_scale=2.5), matrix=matrix)

    def test_far_from_the_origin_and_huge(self):
        self.check("offset", lambda s: s.look(EYE + 1e6, (1e6,) * 3, angle=35), offset=1e6)
        self.check("huge", lambda s: s.look(EYE * 1e9, (0, 0, 0), angle=35), scale=1e9)

    def test_mirrored_camera_sees_the_mirrored_picture(self):
        for options in ({"angle": 35}, {"parallel_scale": 2.5}):
            _, image = self.draw(block(), lambda s: s.look(EYE, (0, 0, 0), **options))
            _, mirrored = self.draw(block(mirror=(-1, 1, 1)), lambda s: s.look(EYE * (-1, 1, 1), (0, 0, 0), **options))
            self.assertGreater(image[..., 3].max(), 0.9)
            np.testing.assert_allclose(mirrored[:, ::-1], image, atol=1e-5)


if __name__ == "__main__":
    unittest.main()
