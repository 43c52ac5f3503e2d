# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regions that fill space, each drawn by a mapper with the splats that reach into it, make the picture of one mapper."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import vtk_to_numpy

STEEP = Transfer([(0, 1, 0, 0), (0.5, 0, 1, 0), (1, 0, 0, 1)], [(0, 0.4), (1, 2.5)])
DUPLICATE = 1
FAR = np.inf
CELL = 0.4
CASES = {"middle streaks": (0, 0), "middle segments": (0, 1), "layers of streaks": (1, 0), "layers of segments": (1, 1)}


def cloud(number=500, seed=3):
    rng = np.random.default_rng(seed)
    points = rng.uniform(-1, 1, (number, 3))
    shapes = CELL * (np.eye(3) * rng.uniform(0.5, 1, (number, 1, 1)) + rng.uniform(-0.3, 0.3, (number, 3, 3)))
    return points, shapes.reshape(number, 9), rng.uniform(0, 1, number), rng.normal(size=(number, 3))


def data_of(points, shapes, values, winds, region=None, reach=0.0):
    """Particles; of a region those within reach of it, its own ones marked apart from those of its neighbours."""
    chosen, ghosts = np.ones(len(points), bool), np.zeros(len(points))
    if region is not None:
        low, high = np.array(region).reshape(3, 2).T
        chosen = np.linalg.norm(np.maximum(0, np.maximum(low - points, points - high)), axis=1) <= reach
        ghosts = np.where(((points >= low) & (points < high)).all(axis=1), 0, DUPLICATE)
    data = meshes.particles(points[chosen])
    for name, array in (("s", values), ("shape", shapes), ("v", winds)):
        meshes.add_array(data.GetPointData(), array[chosen], name)
    marks = data.AllocatePointGhostArray()
    vtk_to_numpy(marks)[:] = ghosts[chosen]
    return data


# Regions of a k-d tree with three leaves, from back to front for an eye at low x and y.
REGIONS = [(0.13, FAR, -FAR, FAR, -FAR, FAR), (-FAR, 0.13, 0.2, FAR, -FAR, FAR), (-FAR, 0.13, -FAR, 0.2, -FAR, FAR)]


class Regions(ImageTestCase):
    def draw(self, data, look, region=None, vectors=None, configure=None):
        window = Window((160, 120))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetShapeArrayName("shape")
        # The one picture, too, in the frame of all: a region that is all of space.
        mapper.SetRegion(*(region or (-FAR, FAR) * 3))
        mapper.SetCommonFrame((0, 0, 0), 1.5 * CELL, 0)
        if vectors is not None:
            mapper.SetVectorArrayName("v")
            mapper.SetVectorPlacement(vectors[0])
            mapper.SetVectorStyle(vectors[1])
            mapper.SetMaximumSpeed(2)
            mapper.SetVectorUnit(CELL)
            mapper.SetStreakPeriod(3)
            mapper.UseVectorColorOn()
        if configure:
            configure(mapper)
        scene.add_volume(mapper, data, STEEP)
        look(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return float_image(mapper)

    def check(self, label, look, vectors=None, tolerance=2e-6, radius=1.556 * 1.5 * CELL):
        samples = cloud()
        one = self.draw(data_of(*samples), look, None, vectors)
        self.assertGreater(one[..., 3].max(), 0.8)
        sum_ = np.zeros_like(one)
        for region in REGIONS:
            image = self.draw(data_of(*samples, region, 2 * radius), look, region, vectors)
            self.assertGreater(image[..., 3].max(), 0.1)
            sum_ = image + (1 - image[..., 3:]) * sum_
        self.check_float(sum_[..., 3:], one[..., 3:], label + ", alpha", min(tolerance, 1e-4))
        self.check_float(sum_, one, label, tolerance)

    def test_media(self):
        self.check("perspective", lambda s: s.look((-2, -1.5, 3), (0, 0, 0), angle=50))
        self.check("parallel", lambda s: s.look((-2, -1.5, 3), (0, 0, 0), parallel_scale=1.7))

    def test_along_the_border(self):
        """Seen along a border, the splats of both sides take turns along a ray."""
        self.check("along x", lambda s: s.look((0.12, -4, 0.5), (0.12, 0, 0.1), up=(0, 0, 1), angle=40))

    def test_eye_among_the_splats(self):
        self.check("eye inside", lambda s: s.look((-0.1, -0.1, 0), (1, 0.8, 0.2), angle=90, near=1e-3, far=20))

    def test_smaller_than_pixels(self):
        """Spread over a pixel, splats count where their centres are: no light is lost."""
        self.check("far away", lambda s: s.look((-300, -225, 450), (0, 0, 0), angle=2), tolerance=1e-3)

    def test_vectors(self):
        reach = 1.556 * np.hypot(1.5 * CELL, 1.5 * CELL) + CELL
        for label, vectors in CASES.items():
            self.check(label, lambda s: s.look((-2, -1.5, 3), (0, 0, 0), angle=50), vectors, radius=reach)
            self.check(label + ", parallel", lambda s: s.look((-2, -1.5, 3), (0, 0, 0), parallel_scale=1.7), vectors, radius=reach)

    def test_hierarchy_is_drawn_whole(self):
        """Nodes are drawn by the process that has their samples; duplicates are not drawn then."""
        samples = cloud()
        look = lambda s: s.look((-2, -1.5, 3), (0, 0, 0), angle=50)  # noqa: E731
        tolerate = lambda m: m.SetErrorTolerance(1e-9)  # noqa: E731
        one = self.draw(data_of(*samples), look, configure=tolerate)
        through = 1.0
        for region in REGIONS:
            image = self.draw(data_of(*samples, region, 3), look, region, configure=tolerate)
            through = through * (1 - image[..., 3])
        self.check_float(1 - through[..., None], one[..., 3:], "transparency of the hierarchy", 1e-4)


if __name__ == "__main__":
    unittest.main()
