# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Haze without a setting: seen in every scene and hiding none, whatever its size, place and units; a sentence where it would hide all."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window

EARTH = 6371000.0
RNG = np.random.default_rng(5)


def box(scale=1.0, offset=(0, 0, 0), shape=(1, 1, 1)):
    """Sides of a box, in many pieces of their own brightness."""
    n = 6
    points, quads = [], []
    for axis in range(3):
        for end in (0, 1):
            for i in range(n):
                for j in range(n):
                    first = len(points)
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        p = np.insert(np.array((a, b)) / n, axis, end)
                        points.append(scale * p * shape + offset)
                    quads.append(range(first, first + 4))
    return meshes.surface(np.array(points), quads)


def sphere(radius, count=24):
    lon, lat = np.meshgrid(np.linspace(0, 2 * np.pi, 2 * count + 1), np.linspace(-np.pi / 2, np.pi / 2, count + 1))
    points = radius * np.stack([np.cos(lon) * np.cos(lat), np.sin(lon) * np.cos(lat), np.sin(lat)], axis=-1).reshape(-1, 3)
    row = 2 * count + 1
    return meshes.surface(points, [(i * row + j, i * row + j + 1, (i + 1) * row + j + 1, (i + 1) * row + j)
                                   for i in range(count) for j in range(2 * count)])


def told(data, projection, exaggeration, radius=EARTH):
    for name, value in (("GlobeGridProjection", projection), ("PlanetRadius", radius), ("VerticalExaggeration", exaggeration)):
        meshes.add_array(data.GetFieldData(), np.array([float(value)]), name)
    return data


class Placement(unittest.TestCase):
    def draw(self, data, haze, direction=(1, 1, 0.8)):
        window = Window((60, 50))
        scene = window.add_scene(background=(0.05, 0.05, 0.2))
        actor = scene.add_opaque(data, (0.7, 0.3, 0.1))
        actor.GetProperty().LightingOn()
        nephoscope.vtkHaze.SetHaze(scene.renderer, haze)
        scene.look_at(data, direction, (0, 0, 1))
        window.render()
        self.assertEqual(window.gl_errors(), [])
        return scene.rgb(), window.messages.all

    def check(self, data, label, direction=(1, 1, 0.8), least=0.02):
        plain, _ = self.draw(data, None, direction)
        hazed, messages = self.draw(data, nephoscope.vtkHaze(), direction)
        self.assertEqual(messages, [], label)
        inside = np.abs(plain - plain[0, 0]).max(axis=2) > 0.02
        change = np.abs(hazed - plain).max(axis=2)[inside]
        left = np.abs(hazed - (0.72, 0.8, 0.9)).max(axis=2)[inside]
        print(f"  {label}: changed {np.mean(change > 2 / 255):.3f} of the pixels, by {change.mean():.3f}; contrast to haze {np.median(left):.3f}")
        self.assertGreater(np.mean(change > 2 / 255), least, label)
        self.assertGreater(np.median(left), 0.2, label)
        return hazed

    def test_any_size_and_place(self):
        first = self.check(box(), "unit box")
        for scale in (1e-6, 1e-3, 37.0, 1e9):
            for offset in ((0, 0, 0), tuple(scale * RNG.uniform(-30, 30, 3))):
                np.testing.assert_allclose(self.check(box(scale, offset), f"box of {scale} at {offset}"), first, atol=0.03)

    def test_shapes(self):
        for shape in ((1, 1, 1e-3), (1, 1e-3, 1), (1, 1, 0), (360, 180, 20), (2e5, 3e5, 3e3), (0.02, 0.02, 0.3)):
            self.check(box(1, (5, 7, -3), shape), f"box of {shape}")

    def test_thin_scenes_from_the_side(self):
        for shape in ((1, 1, 0.04), (2e6, 2e6, 8e4), (3e3, 1e3, 1e2)):
            for direction in ((1, 0, 0), (0, -1, 0), (1, 1, 0.02), (1, 0, 0.2)):
                self.check(box(1, (0, 0, 0), shape), f"box of {shape} from {direction}", direction)

    def test_every_direction(self):
        for direction in ((0, 0.001, 1), (1, 0, 0.01), (0.5, 1, -0.3), (0, 0.001, -1), *RNG.normal(size=(4, 3))):
            self.check(box(), f"from {np.round(direction, 2)}", direction)

    def test_globes_by_size(self):
        for unit in (1.0, 1e-3):
            self.check(sphere(EARTH * unit), f"globe of {EARTH * unit}")

    def test_globe_grid(self):
        """As with all that it tells set by hand."""
        for projection, exaggeration in ((0, 1), (0, 50), (1, 30)):
            plain = sphere(EARTH + 5000 * exaggeration) if projection == 0 else box(1e6, (0, 0, 0), (20, 10, 0.012 * exaggeration))
            automatic = self.draw(told(plain, projection, exaggeration), nephoscope.vtkHaze())[0]
            haze = nephoscope.vtkHaze()
            haze.SetProjection(projection)
            haze.SetPlanetRadius(EARTH)
            haze.SetScaleHeight(8000)
            haze.SetVerticalExaggeration(exaggeration)
            haze.SetVisibility(24.5 * 8000 * exaggeration)
            np.testing.assert_array_equal(automatic, self.draw(plain, haze)[0])

    def test_scene_deep_under_the_ground(self):
        """What is set by hand stays, and is told once."""
        haze = nephoscope.vtkHaze()
        haze.SetPlanetRadius(EARTH)
        messages = self.draw(box(0.1), haze)[1]
        self.assertEqual(len(messages), 1)
        self.assertIn("Set Projection to Map or Automatic", messages[0])
        haze.SetProjectionToMap()
        haze.SetBaseLevel(1e4)
        self.assertIn("Set Base Level", self.draw(box(0.1), haze)[1][0])

    def test_follows_the_scene(self):
        window = Window((60, 50))
        scene = window.add_scene()
        haze = nephoscope.vtkHaze()
        nephoscope.vtkHaze.SetHaze(scene.renderer, haze)
        window.render()  # of nothing
        self.assertEqual(window.messages.all, [])
        scene.add_opaque(box(1e-3), (0.7, 0.3, 0.1))
        scene.look_at(box(1e-3), (1, 1, 0.8), (0, 0, 1))
        window.render()
        last = scene.renderer.GetActors().GetLastActor()
        self.assertEqual(window.messages.all, [])
        hazed = scene.rgb()
        scene.renderer.RemoveActor(last)
        scene.add_opaque(box(1e-3), (0.7, 0.3, 0.1))
        window.render()
        np.testing.assert_array_equal(scene.rgb(), hazed)


if __name__ == "__main__":
    unittest.main()
