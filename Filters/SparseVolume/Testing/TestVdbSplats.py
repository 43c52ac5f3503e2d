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


def without_border(values, dimensions):
    """Points at the end of an image have half a cell, voxels a whole one: in the empty space around a cloud that makes no difference."""
    box = np.zeros(dimensions[::-1], "f4")
    box[1:-1, 1:-1, 1:-1] = values.reshape(dimensions[::-1])[1:-1, 1:-1, 1:-1]
    return box.ravel()


@unittest.skipUnless(vf.HAS_OPENVDB, "this build has no OpenVDB")
class Splats(VdbTestCase, ImageTestCase):
    def draw(self, data, tolerance=0.0):
        window = Window((80, 64))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetErrorTolerance(tolerance)
        scene.add_volume(mapper, data, COLORS)
        scene.look((9, 7, 16), (0.5, 0.2, 0.6), angle=30)
        window.render()
        self.fail_on_messages(window)
        return float_image(mapper), mapper

    def test_points_look_like_the_image(self):
        random = np.random.default_rng(3)
        values = random.random(24 ** 3).astype("f4")
        values[random.random(24 ** 3) < 0.97] = 0
        values = without_border(values, (24, 24, 24))
        data = vf.image({"s": values}, (24, 24, 24), first=(-12, -12, -12), spacing=(0.2, 0.3, 0.4), direction=ROTATION)
        self.write(data)
        points, dense = self.read(), self.read(as_image=True)
        sparse, mapper = self.draw(points)
        expected, _ = self.draw(data)  # the reader's image ends where the cloud does
        self.assertGreater(expected[..., 3].max(), 0.3)
        self.assertEqual(points.GetNumberOfPoints(), (values != 0).sum())
        self.assertEqual(mapper.GetNumberOfDrawnSplats(), points.GetNumberOfPoints())
        print(f"  memory: {points.GetActualMemorySize()} KiB as points, {dense.GetActualMemorySize()} KiB as an image")
        self.check_float(sparse, expected, "sparse and dense", 1e-5)

    def test_the_hierarchy_of_points_is_that_of_the_image(self):
        """Blocks are those of voxel indices, wherever the voxels are in space: the trees, and so the pictures, are the same."""
        random = np.random.default_rng(5)
        grid = np.mgrid[0:24, 0:20, 0:28].reshape(3, -1)
        values = np.clip(1.2 - 0.012 * ((grid.T - (12, 9, 13))**2).sum(axis=1), 0, 1).astype("f4")
        values[random.random(values.size) < 0.1] = 0
        values = without_border(values, (28, 20, 24))
        data = vf.image({"s": values}, (28, 20, 24), first=(4096, 0, -4096), spacing=(0.2, 0.24, 0.28), direction=ROTATION,
                        origin=-ROTATION @ np.multiply((4096 + 14, 10, -4096 + 12), (0.2, 0.24, 0.28)))
        self.write(data)
        points = self.read()
        for tolerance in (0.5, 3.0):
            sparse, mapper = self.draw(points, tolerance)
            dense, dense_mapper = self.draw(data, tolerance)
            self.assertEqual(mapper.GetNumberOfDrawnSplats(), dense_mapper.GetNumberOfDrawnSplats())
            self.assertLess(mapper.GetNumberOfDrawnSplats(), 0.8 * points.GetNumberOfPoints())
            self.assertGreater(dense[..., 3].max(), 0.5)
            self.check_float(sparse, dense, "sparse and dense", 2e-4)

    def test_a_tile_is_one_large_splat(self):
        """It has the mass of its voxels, and blocks of the hierarchy contain it."""
        values = np.zeros((24, 24, 24), "f4")
        values[:16, 8:16, 8:16] = 1
        values[20:, 3, 3] = 0.5
        self.write(vf.image({"s": values.ravel()}, (24, 24, 24), spacing=(0.05, 0.05, 0.05)))
        depths = []
        for split, tolerance, splats in ((True, 0, 1028), (False, 0, 6), (False, 1000, 1)):
            points = self.read(lambda r: r.SetSplitTiles(split))
            picture, mapper = self.draw(points, tolerance)
            self.assertEqual(mapper.GetNumberOfDrawnSplats(), splats)
            depths.append(-np.log1p(-picture[..., 3]).sum())
        np.testing.assert_allclose(depths[1:], depths[0], rtol=0.02)


if __name__ == "__main__":
    unittest.main()
