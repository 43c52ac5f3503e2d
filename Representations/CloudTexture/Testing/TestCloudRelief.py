# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bumps of cloud in the light: the brightness of a flat sheet is that of a surface that the texture has raised, by differences."""
import unittest

import numpy as np
from cloud_sheets import TextureTestCase, add_field, coordinates, sheet
from TestCloudTexturePicture import WAVES, second
from vtkmodules.vtkRenderingCore import vtkLight

CORNERS = ((0.2, 0.3, 0.4), (0.34, 0.44, 0.47))
SHIFT = np.array((0.3, 0.1, 0.7))
PIXELS = 96
RELIEF = 0.05
UNIT = 2 / 0.14  # of texture, in lengths of the sheet, which is 2 wide
SUN = np.array((-0.6, 0.35, 0.72)) / np.linalg.norm((-0.6, 0.35, 0.72))


def height(p):
    """1 is that of the first wave; the others have the squares of their amplitudes."""
    total = 0
    for i, (m, n, d) in enumerate(WAVES):
        b, c, turn = 2 * np.pi * m, 4 * np.pi * n, 2 * np.pi * d
        modulation = 2 * np.sin((c * p[..., 0] - b * p[..., 1]) / 2)
        total = total + 0.49**i * np.cos(b * p[..., 0] + c * p[..., 1] + turn * p[..., 2] + modulation)
    return total


def lambert(weights):
    """Lambert's cosine on the raised sheet: slopes by central differences over a thousandth of a pixel."""
    middle = (np.arange(PIXELS) + 0.5) / PIXELS
    s, t = np.meshgrid(middle, middle)
    step = 1e-3 / PIXELS

    def raised(s, t):
        p = coordinates(CORNERS, s, t)
        return RELIEF * UNIT / 3 * (weights[0] * height(p) + weights[1] * height(second(p + SHIFT))) / np.hypot(*weights)

    slope = np.stack([raised(s + step, t) - raised(s - step, t), raised(s, t + step) - raised(s, t - step)], -1) / (4 * step)
    slope /= 1 + 0.6 * np.linalg.norm(slope, axis=-1, keepdims=True)
    normal = np.concatenate([-slope, np.ones_like(s)[..., None]], -1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.clip(normal @ SUN, 0, 1)


class Relief(TextureTestCase):
    def lit(self, data, relief, size=PIXELS):
        window, mapper, scene = self.scene(data, (size, size))
        mapper.SetCoverage(1)
        mapper.SetRelief(relief)
        add_field(data, "TextureLength", [UNIT])
        actor = scene.renderer.GetActors().GetLastActor()
        actor.GetProperty().LightingOn()
        sun = vtkLight()
        sun.SetLightTypeToSceneLight()
        sun.SetPosition(*SUN)
        scene.renderer.AddLight(sun)
        return self.draw(window)

    def sheet(self, weights, **options):
        return sheet(CORNERS, [((0, 0, 0), 1.0), (SHIFT, 1.0)], weights=weights, **options)

    def test_brightness_of_bumps(self):
        for weights in ((1, 0), (0.7, 0.3), (0, 1)):
            for with_normals in (False, True):
                difference = np.abs(self.lit(self.sheet(weights, with_normals=with_normals), RELIEF) - lambert(weights))
                print(f"  weights {weights}: mean difference {difference.mean():.4f}, largest {difference.max():.4f}")
                self.assertGreater(np.ptp(lambert(weights)), 0.5)
                self.assertLess(difference.mean(), 0.003)
                self.assertLess(difference.max(), 0.02)  # the pixel's filter takes some of the steepest

    def test_none_is_flat(self):
        self.assertAlmostEqual(self.lit(self.sheet((0.5, 0.5)), 0).mean(), SUN[2], delta=1.5 / 255)
        self.assertLess(np.ptp(self.lit(self.sheet((0.5, 0.5)), 0)), 1e-6)

    def test_without_lights_or_far_away(self):
        """Bumps smaller than pixels are no noise; without lights they are not there."""
        window, mapper, _ = self.scene(self.sheet((1, 0)), (64, 64))
        mapper.SetCoverage(1)
        mapper.SetRelief(RELIEF)
        np.testing.assert_array_equal(self.draw(window), 1)
        far = sheet(((0, 0, 0), (60, 60, 0)), [((0, 0, 0), 1.0)])
        self.assertLess(np.std(self.lit(far, RELIEF, 24)), 0.05)


if __name__ == "__main__":
    unittest.main()
