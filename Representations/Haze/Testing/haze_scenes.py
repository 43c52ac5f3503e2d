# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flat squares at known places behind haze, and the pictures that quadrature along every ray gives of them."""
import unittest
from dataclasses import dataclass

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.compare import Difference
from nephoscope_testing.offscreen import Window
from vtkmodules.vtkRenderingOpenGL2 import (vtkCameraPass, vtkLightsPass, vtkOpaquePass, vtkRenderPassCollection, vtkSequencePass,
                                            vtkTranslucentPass)

SIZE = (80, 60)
STEP = 1 / 255
BLENDED = 1.51 * STEP  # over what is in the 8-bit picture already: half a step of it, of the colour and of their sum


@dataclass
class Square:
    """A parallelogram corner + s a + t b, s and t in 0 ... 1, in one colour that no light changes."""
    corner: tuple
    a: tuple
    b: tuple
    color: tuple
    opacity: float = 1.0

    def __post_init__(self):
        self.corner, self.a, self.b = (np.array(v, float) for v in (self.corner, self.a, self.b))

    def surface(self):
        points = self.corner + np.array([0 * self.a, self.a, self.a + self.b, self.b])
        return meshes.surface(points, np.array([[0, 1, 2, 3]]))

    def distances(self, origins, directions):
        """Along each ray to the square; inf where it passes by."""
        normal = np.cross(self.a, self.b)
        with np.errstate(divide="ignore", invalid="ignore"):
            t = ((self.corner - origins) @ normal) / (directions @ normal)
        q = origins + t[:, None] * directions - self.corner
        s, r = np.linalg.solve([[self.a @ self.a, self.a @ self.b], [self.a @ self.b, self.b @ self.b]],
                               np.stack([q @ self.a, q @ self.b]))
        return np.where((s >= 0) & (s <= 1) & (r >= 0) & (r <= 1) & (t > 0), t, np.inf)


def blend_in_order(renderer):
    passes = vtkRenderPassCollection()
    for one in (vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass()):
        passes.AddItem(one)
    sequence, camera = vtkSequencePass(), vtkCameraPass()
    sequence.SetPasses(passes)
    camera.SetDelegatePass(sequence)
    renderer.SetPass(camera)


class HazeTestCase(unittest.TestCase):
    def window(self, squares, haze=None, look=None, background=(0, 0, 0), size=SIZE, sky=False, viewport=(0, 0, 1, 1), peel=False,
               blend=False):
        """blend: translucent squares over each other as they come, in place of VTK's weighted mean of them."""
        window = Window(size)
        scene = window.add_scene(viewport=viewport, background=background)
        for square in squares:
            actor = scene.add_opaque(square.surface(), square.color)
            actor.GetProperty().SetOpacity(square.opacity)
        if haze:
            made = haze.make(nephoscope.vtkHaze)
            made.SetBackground(sky)
            nephoscope.vtkHaze.SetHaze(scene.renderer, made)
        if peel:
            scene.renderer.UseDepthPeelingOn()
            scene.renderer.SetMaximumNumberOfPeels(20)
            scene.renderer.SetOcclusionRatio(0)
        if blend:
            blend_in_order(scene.renderer)
        scene.look(**(look or {}))
        return window, scene

    def expected(self, scene, squares, haze, background=(0, 0, 0), sky=0.0):
        """Air between all layers of every ray, one after another from the back. `sky` is how far rays go where nothing is; 0: light from
        the background is dimmed by no air."""
        view = scene.view()
        origins, directions, *_ = view.rays()
        rays = np.arange(len(origins))
        colors, alphas = (np.array([getattr(s, name) for s in squares]) for name in ("color", "opacity"))
        distances = np.stack([s.distances(origins, directions) for s in squares])
        order = np.argsort(-np.where(np.isfinite(distances), distances, -1), axis=0)
        layers = [(d, np.isfinite(d), colors[k], alphas[k][:, None]) for k in order for d in [distances[k, rays]]]
        through = lambda length: haze.transparency(origins, directions, length)
        light = np.zeros((len(rays), 3))
        clear = np.ones((len(rays), 1))  # share of the background that is seen
        behind = np.ones(len(rays))      # transparency up to the layer behind
        for d, hit, color, alpha in layers:
            here = through(np.where(hit, d, 0))
            air = np.where(hit & (clear[:, 0] < 1), behind / np.maximum(here, 1e-30), 1)
            light = air[:, None] * light + (1 - air)[:, None] * (1 - clear) * haze.color
            light = np.where(hit[:, None], alpha * color + (1 - alpha) * light, light)
            clear = np.where(hit[:, None], (1 - alpha) * clear, clear)
            behind = np.where(hit, here, behind)
        light = behind[:, None] * light + (1 - behind)[:, None] * (1 - clear) * haze.color
        back = np.tile(np.asarray(background, float), (len(rays), 1))
        if sky:
            back = haze.over(back, through(np.full(len(rays), float(sky))))
        return (light + clear * back).reshape(view.height, view.width, 3)

    def check(self, squares, haze, label, tolerance=1.01 * STEP, background=(0, 0, 0), sky=0.0, **options):
        window, scene = self.window(squares, haze, background=background, sky=sky > 0, **options)
        window.render()
        self.assertEqual(window.messages.all, [], label)
        self.assertEqual(window.gl_errors(), [], label)
        difference = Difference(scene.rgb(), np.clip(self.expected(scene, squares, haze, background, sky), 0, 1))
        print(f"  {label}: {difference}", flush=True)
        self.assertLessEqual(difference.maximum, tolerance, label)
        return scene.rgb()
