# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings that haze cannot have are told and not taken; it may be tied to anything at any time."""
import gc
import unittest

import nephoscope
import numpy as np
from haze_scenes import HazeTestCase, Square
from nephoscope_testing.haze import Haze
from nephoscope_testing.messages import Messages
from vtkmodules.vtkRenderingCore import vtkRenderer

BAD_LENGTHS = (-1.0, np.nan, np.inf)


class BadInput(HazeTestCase):
    def refused(self, name, *values):
        haze = nephoscope.vtkHaze()
        before = str(haze).split("Debug:")[1].split("Enabled:")[1]
        with Messages() as messages:
            getattr(haze, "Set" + name)(*values)
        self.assertEqual(len(messages.errors), 1, (name, values, messages.all))
        self.assertIn(name + " must be", messages.errors[0])
        self.assertEqual(str(haze).split("Enabled:")[1], before)

    def test_lengths(self):
        for name in ("ScaleHeight", "PlanetRadius", "Visibility", "VerticalExaggeration"):
            for value in BAD_LENGTHS:
                self.refused(name, value)

    def test_extinction(self):
        for value in BAD_LENGTHS:
            self.refused("Extinction", value)

    def test_vectors(self):
        self.refused("Color", 0.5, 0.5, 1.5)
        self.refused("Color", 0.5, np.nan, 0.5)
        self.refused("Center", 0, np.inf, 0)
        self.refused("UpDirection", 0, 0, 0)
        self.refused("UpDirection", 0, np.nan, 1)
        self.refused("BaseLevel", np.nan)

    def test_visibility_is_extinction(self):
        haze = nephoscope.vtkHaze()
        haze.SetVisibility(20000)
        self.assertAlmostEqual(np.exp(-haze.GetExtinction() * 20000), 0.02, places=4)
        haze.SetExtinction(1e-3)
        self.assertAlmostEqual(haze.GetVisibility(), 3912, places=6)

    def test_no_renderer(self):
        with Messages() as messages:
            nephoscope.vtkHaze.SetHaze(None, nephoscope.vtkHaze())
        self.assertEqual(len(messages.warnings), 1)
        self.assertIsNone(nephoscope.vtkHaze.GetHaze(None))

    def test_lives_of_their_own(self):
        """Neither keeps a renderer alive, nor is the haze lost that only the renderer keeps."""
        renderer = vtkRenderer()
        nephoscope.vtkHaze.SetHaze(renderer, nephoscope.vtkHaze())
        gc.collect()
        haze = nephoscope.vtkHaze.GetHaze(renderer)
        self.assertTrue(haze.GetEnabled())
        del renderer
        gc.collect()
        self.assertEqual(haze.GetReferenceCount(), 1)

    def test_all_kinds_of_scenes_draw(self):
        far = 1e7
        kinds = ((6.371e6, (0, 0, 0)), (6.371e6, (0, 0, 6.371e6)), (1.0, (0, 0, 3)), (1e12, (0, 0, 1e12)), (None, (0, 0, -1e6)),
                 (None, (0, 0, 1e9)))
        for radius, at in kinds:
            for parallel in (None, 10.0):
                haze = Haze(1e-3, 10.0, radius)
                square = Square(np.add(at, (-5, -20, -5)), (10, 0, 0), (0, 0, 10), (0, 0, 0))
                window, scene = self.window([square], haze, sky=True, background=(0.1, 0.2, 0.3), look={
                    "position": at, "focus": np.add(at, (0, -0.1 * max(1, np.linalg.norm(at) * 1e-6), 0)), "up": (0, 0, 1), "angle": 40,
                    "parallel_scale": parallel, "near": 1, "far": far})
                window.render()
                underground = radius is None and at[2] < 0 or radius == 6.371e6 and at[2] == 0
                self.assertEqual(["hides everything" in text for text in window.messages.all], [True] * underground)
                self.assertEqual(window.gl_errors(), [])

    def test_empty_renderer(self):
        window, scene = self.window([], Haze(1e-3, 10), sky=True, look={"position": (0, 0, 5), "focus": (0, 1, 5), "up": (0, 0, 1)})
        window.render()
        self.assertEqual(window.messages.all, [])
        np.testing.assert_allclose(scene.rgb()[0, 0], (0.0, 0.0, 0.0), atol=0.1)


if __name__ == "__main__":
    unittest.main()
