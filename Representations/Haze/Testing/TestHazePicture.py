# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opaque surfaces behind haze against quadrature along every ray, on a globe and over flat ground."""
import unittest

import nephoscope
import numpy as np
from haze_scenes import BLENDED, STEP, HazeTestCase, Square
from nephoscope_testing.haze import Haze
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkSelectionNode
from vtkmodules.vtkRenderingCore import vtkHardwareSelector, vtkWindowToImageFilter

EARTH = 6.371e6


def wall(distance, color=(0, 0, 0), half=1e9, at=(0, 0, 0)):
    """Across the view along -y, at a distance from a place."""
    x, y, z = at
    return Square((x - half, y - distance, z - half), (2 * half, 0, 0), (0, 0, 2 * half), color)


def towards_walls(at, angle=30.0, near=1.0, far=1e7, **more):
    """From a place towards -y, z up."""
    return {"position": at, "focus": np.add(at, (0, -1, 0)), "up": (0, 0, 1), "angle": angle, "near": near, "far": far, **more}


class Flat(HazeTestCase):
    def test_walls_at_known_distances(self):
        """Level rays: exp(-k L) at once, without quadrature."""
        for distance in (100.0, 1000.0, 5000.0, 20000.0):
            haze = Haze(1 / 4000, 1e7, color=(1, 1, 1))
            window, scene = self.window([wall(distance, half=distance)], haze, towards_walls((0, 0, 0), angle=1e-2))
            window.render()
            self.assertAlmostEqual(scene.rgb()[30, 40, 0], 1 - np.exp(-distance / 4000), delta=0.51 * STEP)

    def test_eye_below_within_and_above(self):
        for height in (-200.0, 0.0, 1500.0, 9000.0):
            self.check([wall(30000, (0.9, 0.3, 0.1))], Haze(1e-4, 1500), f"eye at {height} m", look=towards_walls((0, 0, height), 60))

    def test_level_ground(self):
        ground = Square((-4e4, -8e4, 0), (8e4, 0, 0), (0, 8e4, 0), (0.2, 0.5, 0.1))
        self.check([ground], Haze(2e-4, 800), "ground", look=towards_walls((0, 0, 300), 50, near=10, far=1e5))

    def test_up_and_base(self):
        ground = Square((-4e4, 50, -8e4), (8e4, 0, 0), (0, 0, 8e4), (0.2, 0.5, 0.1))
        self.check([ground], Haze(2e-4, 800, up=(0, 3, 0), base=50), "y up", look={
            "position": (0, 350, 0), "focus": (0, 350, -1), "up": (0, 1, 0), "angle": 50, "near": 10, "far": 1e5})

    def test_parallel_rays(self):
        ground = Square((-4e4, -8e4, 0), (8e4, 0, 0), (0, 8e4, 0), (0.2, 0.5, 0.1))
        self.check([ground], Haze(2e-4, 800), "parallel", look={
            "position": (0, 1e4, 8e3), "focus": (0, -2e4, 0), "up": (0, 0, 1), "parallel_scale": 9e3, "near": 10, "far": 1e5})

    def test_viewport_beside_another(self):
        self.check([wall(30000, (0.9, 0.3, 0.1))], Haze(1e-4, 1500), "viewport", look=towards_walls((0, 0, 500), 60),
                   viewport=(0.5, 0.25, 1, 1))

    def test_background(self):
        self.check([wall(30000, (0.9, 0.3, 0.1), half=4000)], Haze(2e-5, 1500), "sky", background=(0.1, 0.2, 0.5), sky=4e5,
                   tolerance=BLENDED, look={
                       "position": (0, 0, 500), "focus": (0, -1, 500.5), "up": (0, 0, 1), "angle": 20, "near": 1, "far": 1e6})


class Globe(HazeTestCase):
    def test_from_low_to_high(self):
        """From z = R + h towards -y: walls far beyond the horizon, whose feet are under the ground."""
        for height, angle in ((2.0, 20), (2e3, 20), (3e4, 40), (1e6, 60)):
            at = (0, 0, EARTH + height)
            self.check([wall(4e5, (0.9, 0.3, 0.1), at=at)], Haze(1e-5, 8000, EARTH), f"eye at {height} m", look=towards_walls(at, angle))

    def test_grazing_rays(self):
        """Through the lowest air past the limb, to a wall behind the planet's edge."""
        for lowest in (500.0, 4e3, 2e4):
            at = (0, 3e6, EARTH + lowest)
            self.check([wall(6e6, (0.9, 0.3, 0.1), at=at)], Haze(2e-6, 8000, EARTH), f"past the limb at {lowest} m",
                       look=towards_walls(at, 0.5, near=1e4))

    def test_from_space(self):
        """A square that touches the globe, seen from four radii away."""
        half = 2e6
        ground = Square((-half, -half, EARTH + 2000), (2 * half, 0, 0), (0, 2 * half, 0), (0.1, 0.3, 0.6))
        for direction in ((0, 0, 1), (0, 1, 1), (0, 3, 1)):
            eye = 2.6e7 * np.array(direction) / np.linalg.norm(direction)
            self.check([ground], Haze(2e-5, 8000, EARTH), f"from {direction}", look={
                "position": eye, "focus": (0, 0, EARTH), "up": (1, 0, 0), "angle": 8, "near": 1e5, "far": 1e8})

    def test_center_elsewhere(self):
        center = (1.2e7, -3.4e6, 5.6e6)
        at = np.add(center, (0, 0, EARTH + 2000))
        self.check([wall(2e5, (0.9, 0.3, 0.1), at=at)], Haze(1e-5, 8000, EARTH, center), "centre elsewhere", look=towards_walls(at, 20))

    def test_near_things_of_a_thin_fog(self):
        """Metres and hundreds of metres on a globe of 6371 km in float."""
        at = (0, 0, EARTH + 30)
        self.check([wall(1500, (0.9, 0.3, 0.1), 1e4, at)], Haze(2e-3, 50, EARTH), "fog", look=towards_walls(at, 8))

    def test_parallel_rays(self):
        at = (0, 1e6, EARTH + 2e5)
        self.check([wall(2e6, (0.9, 0.3, 0.1), at=at)], Haze(4e-6, 3e4, EARTH), "parallel", look={
            "position": at, "focus": np.add(at, (0, -1, 0)), "up": (0, 0, 1), "parallel_scale": 2e5, "near": 10, "far": 1e7})

    def test_limb_before_the_background(self):
        eye = (0, 1.2e7, EARTH + 6e4)
        self.check([wall(1e5, half=1, at=(0, 0, 0))], Haze(2e-6, 3e4, EARTH), "limb", background=(0.1, 0.2, 0.5), sky=3e7,
                   tolerance=BLENDED, look={
            "position": eye, "focus": np.add(eye, (0, -1, 0.02)), "up": (0, 0, 1), "angle": 2, "near": 1e5, "far": 1e8})


class Switch(HazeTestCase):
    def picture(self, prepare):
        squares = [wall(30000, (0.9, 0.3, 0.1), half=4000), wall(20000, (0.2, 0.9, 0.4), half=1000)]
        squares[1].opacity = 0.5
        window, scene = self.window(squares, look=towards_walls((0, 0, 500), 30), background=(0.1, 0.2, 0.3))
        prepare(scene)
        window.render()
        self.assertEqual(window.messages.all, [])
        self.prop_count = scene.renderer.GetViewProps().GetNumberOfItems()
        return window.rgba()

    def hazed(self, change):
        def prepare(scene):
            haze = Haze(1e-4, 1500).make(nephoscope.vtkHaze)
            nephoscope.vtkHaze.SetHaze(scene.renderer, haze)
            change(scene, haze)
        return self.picture(prepare)

    def test_off_is_identical(self):
        plain = self.picture(lambda scene: None)
        off = {
            "switched off": lambda scene, haze: haze.EnabledOff(),
            "no extinction": lambda scene, haze: haze.SetExtinction(0),
            "taken away": lambda scene, haze: nephoscope.vtkHaze.SetHaze(scene.renderer, None),
            "taken away after a picture": self.taken_away_later,
        }
        for label, change in off.items():
            np.testing.assert_array_equal(self.hazed(change), plain, label)
            self.assertEqual(self.prop_count, 2, label)
        self.assertGreater(np.abs(self.hazed(lambda scene, haze: None) - plain).max(), 0.3)

    def taken_away_later(self, scene, haze):
        scene.window.render()
        nephoscope.vtkHaze.SetHaze(scene.renderer, None)

    def test_settings_change_the_next_picture(self):
        def later(change):
            def prepare(scene, haze):
                scene.window.render()
                change(haze)
            return prepare
        for change in (lambda h: h.SetVisibility(2e4), lambda h: h.SetColor(1, 0, 0), lambda h: (h.SetProjectionToGlobe(), h.SetPlanetRadius(1e3)),
                       lambda h: h.BackgroundOff(), lambda h: h.SetVerticalExaggeration(5)):
            np.testing.assert_array_equal(self.hazed(later(change)), self.hazed(lambda scene, haze: change(haze)))

    def test_one_haze_of_two_renderers(self):
        """An actor in a hazed renderer and in a clear one at once."""
        window, scene = self.window([wall(30000, (0.9, 0.3, 0.1))], look=towards_walls((0, 0, 500)), viewport=(0, 0, 0.5, 1))
        other = window.add_scene(viewport=(0.5, 0, 1, 1))
        other.look(**towards_walls((0, 0, 500)))
        other.renderer.AddActor(scene.renderer.GetActors().GetLastActor())
        nephoscope.vtkHaze.SetHaze(scene.renderer, Haze(1e-4, 1e6, color=(0, 0, 1)).make(nephoscope.vtkHaze))
        for _ in range(2):
            window.render()
        self.assertEqual(window.messages.all, [])
        self.assertGreater(scene.rgb()[30, 20, 2], 0.9)
        np.testing.assert_allclose(other.rgb()[30, 20], (0.9, 0.3, 0.1), atol=0.51 * STEP)

    def test_picked_through_thick_haze(self):
        window, scene = self.window([wall(30000, (0.9, 0.3, 0.1))], Haze(1, 1500), towards_walls((0, 0, 500)), sky=True)
        window.render()
        selector = vtkHardwareSelector()
        selector.SetRenderer(scene.renderer)
        selector.SetArea(20, 20, 60, 40)
        selection = selector.Select()
        self.assertEqual(selection.GetNumberOfNodes(), 1)
        prop = selection.GetNode(0).GetProperties().Get(vtkSelectionNode.PROP())
        self.assertIs(prop, scene.renderer.GetActors().GetLastActor())

    def test_drawn_in_tiles(self):
        """A picture of twice the size, four tiles one after another, is that of a window of twice the size."""
        def draw(size):
            squares = [wall(30000, (0.9, 0.3, 0.1), half=4000)]
            window, _ = self.window(squares, Haze(1e-4, 1500), towards_walls((0, 0, 500), 30), size=size, sky=True)
            window.render()
            return window
        grab = vtkWindowToImageFilter()
        grab.SetInput(draw((80, 60)).window)
        grab.SetScale(2)
        grab.ReadFrontBufferOff()
        grab.Update()
        tiles = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(120, 160, -1) / 255.0
        np.testing.assert_allclose(tiles[..., :3], draw((160, 120)).rgba()[..., :3], atol=1.01 * STEP)


if __name__ == "__main__":
    unittest.main()
