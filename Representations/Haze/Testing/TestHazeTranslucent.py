# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent surfaces behind haze: what is blended is what air in front of, between and behind all layers gives, ray by ray."""
import unittest

import nephoscope
import numpy as np
from haze_scenes import BLENDED, STEP, HazeTestCase, Square
from nephoscope_testing.haze import Haze
from vtkmodules.vtkRenderingCore import vtkActor

AT = (0, 0, 400)
LOOK = {"position": AT, "focus": (0, -1, 400), "up": (0, 0, 1), "angle": 40, "near": 10, "far": 1e5}
HAZE = Haze(1e-4, 1500)


def wall(distance, color, opacity=1.0, half=1e5, x=0.0):
    return Square((x - half, -distance, -half), (2 * half, 0, 0), (0, 0, 2 * half), color, opacity)


def layers(count, half=4000):
    """From the back to the front, so that they are blended in the right order without peeling too."""
    colors = ((0.9, 0.2, 0.1), (0.1, 0.8, 0.2), (0.9, 0.9, 0.1), (0.2, 0.2, 0.9))
    return [wall(18000 - 5000 * k, colors[k], (0.3, 0.5, 0.7, 0.4)[k], x=3000.0 * k - 4000, half=half) for k in range(count)]


class Translucent(HazeTestCase):
    def test_one_over_opaque(self):
        self.check([wall(20000, (0.1, 0.1, 0.6))] + layers(1), HAZE, "one", BLENDED, look=LOOK)

    def test_many_over_opaque(self):
        self.check([wall(20000, (0.1, 0.1, 0.6))] + layers(4), HAZE, "blended", BLENDED + 1.5 * STEP, look=LOOK, blend=True)

    def test_before_the_background(self):
        color = (0.3, 0.1, 0.2)
        self.check(layers(2), HAZE, "before nothing", BLENDED + 0.5 * STEP, look=LOOK, background=color, blend=True)
        upwards = {**LOOK, "focus": (0, -1, 400.5)}
        self.check(layers(2, 9000), HAZE, "before the sky", BLENDED + 1.5 * STEP, look=upwards, background=color, sky=4e5, blend=True)

    def test_peeled_in_any_order(self):
        """The opaque wall is small: where none of the background is seen, VTK 9.2 stops peeling after one layer, with and without haze."""
        behind = [wall(20000, (0.1, 0.1, 0.6), half=3000)]
        there, back = (self.check(behind + squares, HAZE, "peeled", BLENDED + 1.5 * STEP, look=LOOK, peel=True)
                       for squares in (layers(4), layers(4)[::-1]))
        np.testing.assert_array_equal(there, back)

    def test_invisible_layer(self):
        """A layer in the colour of the haze, of any opacity, hides what is behind as thick haze does, and adds none of its own."""
        haze = Haze(1e-4, 1500, color=(0.5, 0.5, 0.5))
        picture = self.check([wall(20000, (0.5, 0.5, 0.5)), wall(5000, (0.5, 0.5, 0.5), 0.6, half=1000)], haze, "all one colour", BLENDED, look=LOOK)
        np.testing.assert_allclose(picture, 0.5, atol=BLENDED)

    def test_cloud_texture(self):
        """vtkCloudTextureMapper: covered everywhere it is a layer as any other."""
        square = wall(8000, (0.9, 0.9, 0.9), 1 - np.exp(-0.7), half=2000)
        window, scene = self.window([wall(20000, (0.1, 0.1, 0.6))], HAZE, LOOK)
        mapper = nephoscope.vtkCloudTextureMapper()
        mapper.SetInputData(square.surface())
        mapper.SetCoverage(1)
        mapper.SetOpticalDepth(0.7)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*square.color)
        actor.GetProperty().LightingOff()
        scene.renderer.AddActor(actor)
        window.render()
        self.assertEqual(window.messages.all, [])
        view = scene.view()
        origins, directions, *_ = view.rays()
        square.opacity = 1 - np.exp(-0.7 / np.abs(directions[:, 1])[:, None])  # longer ways through the layer
        expected = self.expected_of_one(scene, square, origins, directions)
        np.testing.assert_allclose(scene.rgb(), expected, atol=BLENDED)

    def expected_of_one(self, scene, square, origins, directions):
        back = self.expected(scene, [wall(20000, (0.1, 0.1, 0.6))], HAZE).reshape(-1, 3)
        d = square.distances(origins, directions)
        front = HAZE.over(np.asarray(square.color), HAZE.transparency(origins, directions, d))
        mixed = square.opacity * front + (1 - square.opacity) * back
        view = scene.view()
        return np.where(np.isfinite(d)[:, None], mixed, back).reshape(view.height, view.width, 3)


if __name__ == "__main__":
    unittest.main()
