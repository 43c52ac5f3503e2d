# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The drawn texture: its cover is the one asked for, and close up it is the sum of modulated cosines above its threshold."""
import itertools
import math
import unittest

import numpy as np
from cloud_sheets import TextureTestCase, coordinates_of_pixels, sheet
from nephoscope_testing import meshes
from vtkmodules.util.numpy_support import vtk_to_numpy

COVERS = (0.05, 0.15, 0.5, 0.85)
# m, n and d / 2 pi of the waves; the first has the amplitude 1.013393, each next one 0.7 times that.
WAVES = ((3, 1, 2.1), (-5, 2, -3.3), (8, -3, 5.2), (11, 6, -7.9), (-19, 8, 11.3), (27, -13, 15.1), (41, 21, -22.7))


def gardner(p):
    total = 0
    for i, (m, n, d) in enumerate(WAVES):
        b, c, turn = 2 * math.pi * m, 4 * math.pi * n, 2 * math.pi * d
        modulation = 2 * np.sin((c * p[..., 0] - b * p[..., 1]) / 2)
        total = total + 1.013393 * 0.7**i * np.cos(b * p[..., 0] + c * p[..., 1] + turn * p[..., 2] + modulation)
    return total


def second(p):
    return np.stack([p[..., 0] + 0.37, 0.61 - p[..., 1], p[..., 2] + 0.29], axis=-1)


def blended(p, q, weights):
    return (weights[0] * gardner(p) + weights[1] * gardner(second(q))) / np.hypot(*weights)


class Cover(TextureTestCase):
    def test_cover_over_a_cycle_of_weights(self):
        """24 h in steps of 3 h: the second set is at its birth, in between and in full."""
        corners = ((0, 0, 0), (8, 16, 5))
        worst = 0
        for first in (0, 0.25, 0.5, 0.75, 1):
            data = sheet(corners, [((0.3, 0.1, 0.7), 1.0), ((0, 0, 0), 1.0)], weights=(first, 1 - first))
            window, mapper, _ = self.scene(data, (512, 512))
            for cover in COVERS:
                mapper.SetCoverage(cover)
                drawn = self.draw(window).mean()
                worst = max(worst, abs(drawn - cover))
                self.assertAlmostEqual(drawn, cover, delta=0.01, msg=f"weights {first}, {1 - first}")
        print(f"  cover differs by at most {100 * worst:.2f} %")

    def test_cover_at_every_distance(self):
        for pixels in (32, 128, 512):
            window, mapper, _ = self.scene(sheet(((0, 0, 0), (8, 16, 5)), [((0, 0, 0), 1.0)]), (pixels, pixels))
            for cover in COVERS:
                mapper.SetCoverage(cover)
                self.assertAlmostEqual(self.draw(window).mean(), cover, delta=0.01, msg=f"{pixels} pixels")

    def test_cover_of_points(self):
        """From 0 on the left to 1 on the right: each strip has its own."""
        data = sheet(((0, 0, 0), (16, 16, 5)), [((0, 0, 0), 1.0)])
        meshes.add_array(data.GetPointData(), (meshes.points_of(data)[:, 0] + 1) / 2, "cover")
        window, mapper, _ = self.scene(data, (512, 512))
        mapper.SetCoverageArrayName("cover")
        drawn = self.draw(window)
        for i, strip in enumerate(np.array_split(drawn, 4, axis=1)):
            self.assertAlmostEqual(strip.mean(), (i + 0.5) / 4, delta=0.015)
        self.assertEqual(drawn[:, 0].max(), 0)

    def test_nothing_and_everything(self):
        window, mapper, _ = self.scene(sheet(((0, 0, 0), (1, 2, 1)), [((0, 0, 0), 1.0)]), (64, 64))
        for cover in (0.0, 1.0):
            mapper.SetCoverage(cover)
            np.testing.assert_array_equal(self.draw(window), cover)


class Texture(TextureTestCase):
    def share(self, values, sample, cover, softness):
        """With the threshold of a large sample of the texture."""
        noise = np.random.default_rng(4).normal(0, softness, sample.size)
        threshold = np.quantile(sample + noise, 1 - cover)
        erf = np.vectorize(math.erf)
        return (1 + erf((values - threshold) / (softness * math.sqrt(2)))) / 2

    def test_close_up(self):
        corners = ((0.2, 0.3, 0.4), (0.26, 0.36, 0.43))
        shift, cover, softness = np.array((0.3, 0.1, 0.7)), 0.3, 0.5
        p = coordinates_of_pixels(corners, 128)
        sample = np.random.default_rng(3).uniform(0, 10, (2, 400000, 3))
        for weights in ((1, 0), (0.7, 0.3), (0, 1)):
            window, mapper, _ = self.scene(sheet(corners, [((0, 0, 0), 1.0), (shift, 1.0)], weights=weights), (128, 128))
            mapper.SetCoverage(cover)
            mapper.SetSoftness(softness)
            expected = self.share(blended(p, p + shift, weights), blended(*sample, weights), cover, softness)
            difference = np.abs(self.draw(window) - expected)
            print(f"  weights {weights}: largest difference {difference.max():.4f}, mean {difference.mean():.4f}")
            self.assertGreater(expected.max() - expected.min(), 0.3)
            self.assertLess(difference.mean(), 0.005)
            self.assertLess(difference.max(), 0.03)  # the sample's threshold is good to 0.005, the filter takes a little

    def test_weights_of_points(self):
        """Each half as if its weights held everywhere; they go over into each other in the middle column of cells."""
        corners, sets = ((0, 0, 0), (2, 2, 1)), [((0, 0, 0), 1.0), ((0.3, 0.1, 0.7), 1.0)]
        left, right = (self.draw(self.scene(sheet(corners, sets, weights=w), (160, 160))[0]) for w in ((0.8, 0.2), (0.1, 0.9)))
        data = sheet(corners, sets, weights=(0.5, 0.5))
        first = np.where(meshes.points_of(data)[:, 0] < 0, 0.8, 0.1)
        meshes.add_array(data.GetPointData(), np.stack([first, 1 - first], -1), "TextureWeights")
        drawn = self.draw(self.scene(data, (160, 160))[0])
        np.testing.assert_allclose(drawn[:, :70], left[:, :70], atol=1.5 / 255)
        np.testing.assert_allclose(drawn[:, 80:], right[:, 80:], atol=1.5 / 255)
        self.assertGreater(np.abs(left - right)[:, :70].max(), 0.3)

    def test_both_sets_are_filtered_alike(self):
        """The second set reads the texture mirrored and shifted; at the place that this leads to it looks as the first one, from afar too."""
        corners = ((0, 0, 0), (1.2, 1.5, 0.4))
        first, other = (sheet(corners, 2 * [((0, 0, 0), 1.0)], weights=weights) for weights in ((1, 0), (0, 1)))
        p = vtk_to_numpy(other.GetPointData().GetArray("TextureCoordinates2"))
        p[:] = np.stack([p[:, 0] - 0.37, 0.61 - p[:, 1], p[:, 2] - 0.29], -1)
        for pixels in (256, 48):
            pictures = [self.draw(self.scene(data, (pixels, pixels))[0]) for data in (first, other)]
            self.assertLess(np.abs(pictures[1] - pictures[0]).max(), 0.02, msg=f"{pixels} pixels")

    def test_positions_where_there_are_no_coordinates(self):
        """The longest side, 2, is TextureScale units; far away the same in float."""
        pictures = []
        for far in (0, 40000):
            data = sheet(((0, 0, 0), (1, 1, 1)), [], center=(far, 0, 0))
            window, mapper, _ = self.scene(data, (128, 128), center=(far, 0, 0))
            mapper.SetTextureScale(0.5)
            mapper.SetSoftness(0.5)
            pictures.append(self.draw(window))
        p = coordinates_of_pixels(((-0.25, -0.25, 0), (0.25, 0.25, 0)), 128)
        sample = gardner(np.random.default_rng(3).uniform(0, 10, (400000, 3)))
        self.assertLess(np.abs(pictures[0] - self.share(gardner(p), sample, 0.5, 0.5)).mean(), 0.03)
        self.assertLess(np.abs(pictures[1] - pictures[0]).max(), 0.03)

    def test_longitudes_close(self):
        """Corners of a cell whose u differ by a whole turn are the same place: both halves look alike."""
        wrapped = sheet(((0.9, 0, 0), (1.1, 0.2, 0)), [((0, 0, 0), 1.0)], wrap=True)
        whole = sheet(((0.9, 0, 0), (1.1, 0.2, 0)), [((0, 0, 0), 1.0)], frame=0)
        pictures = [self.draw(self.scene(data, (128, 128))[0]) for data in (wrapped, whole)]
        self.assertLess(np.abs(pictures[0] - pictures[1]).max(), 0.02)


class Opacity(TextureTestCase):
    def test_along_the_ray(self):
        """1 - exp(-depth / cosine), tilted by itself or by its actor."""
        for tilt, with_normals, parallel, by_actor in itertools.product((0, 40, 70), *3 * [(False, True)]):
            center = (0, 0, 0) if by_actor else (3, 1, 0)
            data = sheet(((0, 0, 0), (1, 2, 1)), [((0, 0, 0), 1.0)], center=center, tilt=0 if by_actor else tilt,
                         with_normals=with_normals)
            window, mapper, scene = self.scene(data, (65, 65), center=center, parallel=parallel)
            scene.renderer.GetActors().GetLastActor().RotateY(tilt if by_actor else 0)
            mapper.SetCoverage(1)
            mapper.SetOpticalDepth(0.4)
            expected = 1 - math.exp(-0.4 / math.cos(math.radians(tilt)))
            self.assertAlmostEqual(self.draw(window)[32, 32], expected, delta=1.5 / 255, msg=f"{tilt} {parallel} {by_actor}")

    def test_in_order_by_peeling(self):
        """Two sheets, half transparent: the near one over the far one, whatever the order of the actors."""
        depth = math.log(2)
        for far_first in (False, True):
            window, mapper, scene = self.scene(sheet(((0, 0, 0), (1, 2, 1)), [((0, 0, 0), 1.0)]), (32, 32), color=(1, 0, 0))
            other, _ = self.add_sheet(scene, sheet(((0, 0, 0), (1, 2, 1)), [], center=(0, 0, 1 - 2 * far_first)), color=(0, 1, 0))
            for m in (mapper, other):
                m.SetCoverage(1)
                m.SetOpticalDepth(depth)
            scene.renderer.UseDepthPeelingOn()
            self.draw(window)
            red, green, _ = scene.rgb()[16, 16]
            self.assertAlmostEqual(red, 0.5 if far_first else 0.25, delta=2 / 255)
            self.assertAlmostEqual(green, 0.25 if far_first else 0.5, delta=2 / 255)


if __name__ == "__main__":
    unittest.main()
