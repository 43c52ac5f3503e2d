# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sparse voxels are drawn as splats like the dense image is, without being made dense."""
import unittest

import nephoscope
import numpy as np
import vdb_files as vf
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vdb_files import VdbTestCase

COLORS = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0), (1, 1.6)])
ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


@unittest.skipUnless(vf.HAS_OPENVDB, "this build has no OpenVDB")
class Splats(VdbTestCase, ImageTestCase):
    def draw(self, data):
        window = Window((80, 64))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(mapper, data, COLORS)
        scene.look((9, 7, 16), (0.5, 0.2, 0.6), angle=30)
        window.render()
        self.fail_on_messages(window)
        return float_image(mapper), mapper

    def test_points_look_like_the_image(self):
        random = np.random.default_rng(3)
        values = random.random(24 ** 3).astype("f4")
        values[random.random(24 ** 3) < 0.97] = 0
        data = vf.image({"s": values}, (24, 24, 24), first=(-12, -12, -12), spacing=(0.2, 0.3, 0.4), direction=ROTATION)
        self.write(data)
        points, dense = self.read(), self.read(as_image=True)
        sparse, mapper = self.draw(points)
        expected, dense_mapper = self.draw(dense)
        self.assertGreater(expected[..., 3].max(), 0.3)
        self.assertEqual(points.GetNumberOfPoints(), (values != 0).sum())
        self.assertEqual(mapper.GetNumberOfDrawnSplats(), points.GetNumberOfPoints())
        print(f"  memory: {points.GetActualMemorySize()} KiB as points, {dense.GetActualMemorySize()} KiB as an image")
        self.check_float(sparse, expected, "sparse and dense", 1e-5)


if __name__ == "__main__":
    unittest.main()
