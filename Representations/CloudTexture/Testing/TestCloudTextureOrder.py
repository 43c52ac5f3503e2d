# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds behind one another, among opaque things and volumes: who is in front counts, not who is drawn first. And their lights."""
import itertools
import math
import unittest

import numpy as np
from cloud_bodies import BodyTestCase, box, opacity, stay_in_box, together, wall
from cloud_sheets import TextureTestCase, sheet
from nephoscope_testing import meshes, smoke
from nephoscope_testing.checks import mapper as cell_mapper
from nephoscope_testing.transfer import constant
from vtkmodules.vtkRenderingCore import vtkLight

SLABS = [((-1, -1, 0.2), (1, 1, 0.9)), ((-0.9, -0.8, -1), (1.1, 0.9, -0.2)), ((-1, -1.1, -2), (0.9, 1, -1.5))]
COLORS = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
EXTINCTIONS = (0.7, 1.1, 2.0)
LOOK = {"position": (0.9, 0.7, 6), "far": 20}


def composite(parts):
    """parts: (distance, opacity, colour) of every pixel, in any order."""
    distances = np.stack([np.broadcast_to(d, parts[0][0].shape) for d, _, _ in parts])
    alphas, colors = np.stack([a for _, a, _ in parts]), np.stack([c for _, _, c in parts])
    result, clear = np.zeros((distances.shape[1], 3)), np.ones(distances.shape[1])
    for index in np.argsort(distances, axis=0):
        alpha = np.take_along_axis(alphas, index[None], 0)[0]
        result += (clear * alpha)[:, None] * colors[index]
        clear *= 1 - alpha
    return result


class Order(BodyTestCase):
    def parts(self, scene, stop=np.inf):
        origins, directions, _ = self.rays(scene)
        stop = np.broadcast_to(stop if np.isscalar(stop) else stop(origins, directions), len(origins))
        for slab, color, extinction in zip(SLABS, COLORS, EXTINCTIONS):
            near, far = stay_in_box(origins, directions, *slab)
            yield near, opacity(extinction * np.maximum(0, np.minimum(far, stop) - near)), color

    def check(self, window, scene, expected, allowed=3 / 255, share=0.998):
        window.render()
        self.assertEqual(window.messages.all, [])
        self.assertEqual(window.gl_errors(), [])
        difference = np.abs(scene.rgb().reshape(-1, 3) - expected).max(axis=1)
        self.assertGreaterEqual((difference <= allowed).mean(), share, f"largest difference {difference.max():.4f}")

    def slabs(self, order, **look):
        window, scene, _, first = self.bodies(box(*SLABS[order[0]]), extinction=EXTINCTIONS[order[0]], color=COLORS[order[0]],
                                              **LOOK, **look)
        for i in order[1:]:
            mapper, _ = self.add_sheet(scene, box(*SLABS[i]), COLORS[i])
            mapper.SetCoverage(1)
            mapper.UseThicknessOn()
            mapper.SetExtinction(EXTINCTIONS[i])
        scene.renderer.UseDepthPeelingOn()
        scene.renderer.SetMaximumNumberOfPeels(20)
        return window, scene

    def test_actors(self):
        for order in itertools.permutations(range(3)):
            window, scene = self.slabs(order)
            with self.subTest(order=order):
                self.check(window, scene, composite(list(self.parts(scene))))

    def test_something_opaque_among_them(self):
        for z in (-0.6, -1.2):
            window, scene = self.slabs((2, 0, 1))
            scene.add_opaque(wall(z), (0, 0, 0))
            stop = lambda o, d, z=z: (z - o[:, 2]) / d[:, 2]
            with self.subTest(z=z):
                self.check(window, scene, composite(list(self.parts(scene, stop))))

    def test_within_one_actor(self):
        """Colours of points, bodies in any order."""
        for order in itertools.permutations(range(3)):
            bodies = []
            for i in order:
                data = box(*SLABS[i], density=lambda p, i=i: np.full(len(p), EXTINCTIONS[i]))
                meshes.add_array(data.GetPointData(), np.tile((255 * COLORS[i]).astype(np.uint8), (8, 1)), "colors")
                bodies.append(data)
            data = together(*bodies)
            data.GetPointData().SetActiveScalars("colors")
            window, scene, mapper, _ = self.bodies(data, **LOOK)
            mapper.ScalarVisibilityOn()
            mapper.SetDensityArrayName("density")
            scene.renderer.UseDepthPeelingOn()
            scene.renderer.SetMaximumNumberOfPeels(20)
            with self.subTest(order=order):
                self.check(window, scene, composite(list(self.parts(scene))))

    def test_without_peeling(self):
        """The opacity of all together is right; colours are a mean, by opacity, as VTK mixes them."""
        window, scene = self.slabs((0, 1, 2))
        scene.renderer.UseDepthPeelingOff()
        parts = list(self.parts(scene))
        alphas = np.stack([a for _, a, _ in parts])
        total = 1 - np.prod(1 - alphas, axis=0)
        mean = alphas.T @ COLORS / np.maximum(alphas.sum(axis=0), 1e-9)[:, None]
        self.check(window, scene, total[:, None] * mean)

    def test_volume_between(self):
        """A volume of this project between two clouds, and around one."""
        for low, high in (((-1, -1, -0.1), (1, 1, 0.1)), ((-1.5, -1.5, 1.0), (1.5, 1.5, 1.4))):
            window, scene = self.slabs((1, 0, 2))
            volume = cell_mapper()
            data = meshes.with_field(smoke.boxes([(low, high)]), lambda p: 0 * p[:, 0])
            scene.add_volume(volume, data, constant(1.5, (1, 1, 1)))
            scene.renderer.UseDepthPeelingForVolumesOn()
            origins, directions, _ = self.rays(scene)
            near, far = stay_in_box(origins, directions, low, high)
            parts = list(self.parts(scene)) + [(near, opacity(1.5 * (far - near)), np.ones(3))]
            with self.subTest(low=low):
                self.check(window, scene, composite(parts), allowed=5 / 255)


class Lights(TextureTestCase):
    def test_phong(self):
        """Ambient + diffuse N.L + specular (R.V)^n, on cloud that hides all behind it."""
        ambient, diffuse, specular, power = 0.15, 0.5, 0.3, 7
        towards = np.array((0.3, 0.4, 1.0)) / np.linalg.norm((0.3, 0.4, 1.0))
        for tilt, thickness in itertools.product((0, 20, -35), (False, True)):
            window, mapper, scene = self.scene(sheet(((0, 0, 0), (1, 2, 1)), [], tilt=tilt, with_normals=True), (33, 33))
            mapper.SetCoverage(1)
            mapper.SetUseThickness(thickness)
            prop = scene.renderer.GetActors().GetLastActor().GetProperty()
            prop.LightingOn()
            prop.SetInterpolationToPhong()
            for set_value, value in ((prop.SetAmbient, ambient), (prop.SetDiffuse, diffuse), (prop.SetSpecular, specular),
                                     (prop.SetSpecularPower, power)):
                set_value(value)
            light = vtkLight()
            light.SetLightTypeToSceneLight()
            light.SetFocalPoint(0, 0, 0)
            light.SetPosition(*towards)
            scene.renderer.AddLight(light)
            angle = math.radians(tilt)
            normal = np.array((-math.sin(angle), 0, math.cos(angle)))
            cosine = normal @ towards
            mirrored = 2 * cosine * normal - towards
            expected = ambient + diffuse * cosine + specular * max(0, mirrored[2]) ** power
            with self.subTest(tilt=tilt, thickness=thickness):
                self.assertAlmostEqual(self.draw(window)[16, 16], expected, delta=2 / 255)


if __name__ == "__main__":
    unittest.main()
