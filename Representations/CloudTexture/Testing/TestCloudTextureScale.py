# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""With nothing set, the texture has the size that suits the surface, whatever its unit and place; and it is broken, soft and lit."""
import unittest

import nephoscope
import numpy as np
from cloud_bodies import box, sphere
from nephoscope_testing.offscreen import Window
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkRenderingCore import vtkActor

SIZE = (160, 120)
LAYER = ((0, 0, 0), (1, 1, 0.01))


def picture(low, high, unit=1.0, place=(0, 0, 0), direction=(0.4, -0.6, 0.7)):
    """Nothing is set."""
    low, high = unit * np.array(low) + place, unit * np.array(high) + place
    window = Window(SIZE)
    scene = window.add_scene(background=(0, 0, 0.5))
    mapper, actor = nephoscope.vtkCloudTextureMapper(), vtkActor()
    mapper.SetInputDataObject(box(low, high))
    actor.SetMapper(mapper)
    scene.renderer.AddActor(actor)
    scene.renderer.UseDepthPeelingOn()
    scene.look_at(tuple(np.stack([low, high], -1).ravel()), direction=direction, up=(0, 0, 1))
    window.render()
    assert window.messages.all == [], window.messages.all
    return window.rgba()[..., :3], mapper


class Scale(unittest.TestCase):
    def test_units_and_places(self):
        for corners in (LAYER, ((-1, -0.7, -0.5), (1, 0.7, 0.5))):
            expected, first = picture(*corners)
            for unit, place in ((1e-3, (0, 0, 0)), (1e6, (0, 0, 0)), (50, (0, 0, 0))):
                drawn, mapper = picture(*corners, unit, place)
                self.assertAlmostEqual(mapper.GetTextureScaleUsed(), first.GetTextureScaleUsed(), delta=1e-6)
                self.assertLess(np.abs(drawn - expected).mean(), 0.004, f"unit {unit}")

    def test_more_in_layers(self):
        self.assertAlmostEqual(picture((0, 0, 0), (1, 1, 1))[1].GetTextureScaleUsed(), 2.5)
        self.assertAlmostEqual(picture((0, 0, 0), (1, 0, 1))[1].GetTextureScaleUsed(), 4)
        between = picture(*LAYER)[1].GetTextureScaleUsed()
        self.assertTrue(3.9 < between < 4, between)

    def test_on_globes(self):
        window = Window((32, 32))
        scene = window.add_scene()
        mapper, actor = nephoscope.vtkCloudTextureMapper(), vtkActor()
        mapper.SetInputDataObject(sphere(6.4e6, 32))
        actor.SetMapper(mapper)
        scene.renderer.AddActor(actor)
        window.render()
        self.assertEqual(mapper.GetTextureScaleUsed(), 8)
        mapper.SetTextureScale(2.5)
        window.render()
        self.assertEqual(mapper.GetTextureScaleUsed(), 2.5)

    def test_of_blocks(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, box(*LAYER))
        window = Window((32, 32))
        scene = window.add_scene()
        mapper, actor = nephoscope.vtkCloudTextureMapper(), vtkActor()
        mapper.SetInputDataObject(blocks)
        actor.SetMapper(mapper)
        scene.renderer.AddActor(actor)
        window.render()
        self.assertAlmostEqual(mapper.GetTextureScaleUsed(), picture(*LAYER)[1].GetTextureScaleUsed())

    def test_looks(self):
        """Neither closed nor empty, with many tones; it has parts of many sizes: halving the picture takes little of its contrast."""
        for corners in (LAYER, ((-1, -0.7, -0.5), (1, 0.7, 0.5))):
            drawn = picture(*corners, direction=(0.05, -0.1, 1))[0][..., 0]
            inside = drawn[40:80, 55:105]
            self.assertTrue(0.15 < inside.mean() < 0.85, inside.mean())
            self.assertLess(np.histogram(inside, 10, (0, 1))[0].max(), 0.5 * inside.size)
            halved = inside.reshape(20, 2, 25, 2).mean(axis=(1, 3))
            self.assertGreater(halved.std(), 0.6 * inside.std())


class NothingStandsOut(unittest.TestCase):
    def test_no_stripes(self):
        """The spectrum of a slice goes all round: no sector of 22.5 degrees has three times the mean, in any plane. (Waves of the paper: four times.)"""
        mapper = nephoscope.vtkCloudTextureMapper()
        mapper.GetCoverageUsed()
        values, waves = [0.0] * 9, []
        for i in range(mapper.GetNumberOfWavesUsed()):
            mapper.GetWaveUsed(i, values)
            waves.append(np.array(values))
        n = 96
        s, t = np.meshgrid(*2 * [np.linspace(0, 5, n)])
        window = np.outer(np.hanning(n), np.hanning(n))
        k = np.fft.fftfreq(n)
        sector = np.floor(np.arctan2(k[:, None], k[None]) % np.pi / np.pi * 8).astype(int) % 8
        for first, second in (((1, 0, 0), (0, 1, 0)), ((1, 0, 0), (0, 0, 1)), ((0, 1, 0), (0, 0, 1)), ((0.6, 0.8, 0), (-0.48, 0.36, 0.8))):
            p = s[..., None] * np.array(first) + t[..., None] * np.array(second)
            f = sum(a * np.cos(2 * np.pi * (p @ w[:3] + w[7]) + w[3] * np.sin(2 * np.pi * (p @ w[4:7]))) for a, *w in waves)
            power = np.abs(np.fft.fft2(f * window)) ** 2
            shares = np.array([power[sector == i].sum() for i in range(8)]) / power.sum()
            print("  shares of sectors:", " ".join(f"{share:.2f}" for share in shares))
            self.assertLess(shares.max(), 3 / 8)


if __name__ == "__main__":
    unittest.main()
