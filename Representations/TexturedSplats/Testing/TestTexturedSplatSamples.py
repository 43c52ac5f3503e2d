# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fewer pixels while the camera moves: the image is that of a smaller window, and all pixels are back at rest."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersSources import vtkSphereSource

CLOUD = Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (1, 6)])
SIZE = (180, 144)


def cloud(points):
    radius = np.linalg.norm(2 * points - 1, axis=1)
    return np.clip(1.2 - radius + 0.2 * np.sin(9 * points[:, 0]), 0, 1)


def grid():
    cells = (9, 8, 10)
    data = meshes.with_field(meshes.image(cells, tuple(1 / c for c in cells)), cloud)
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    wind = numpy_to_vtk(np.stack([1 - points[:, 1], points[:, 0], 0.3 * points[:, 2]], 1), deep=True)
    wind.SetName("wind")
    data.GetPointData().AddArray(wind)
    return data


def ball():
    source = vtkSphereSource()
    source.SetCenter(0.5, 0.5, 0.7)
    source.SetRadius(0.25)
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    source.Update()
    return source.GetOutput()


class Samples(ImageTestCase):
    def scene(self, size=SIZE, vectors="", width=1.5, eye=(1.3, 1.1, 3.4), opaque=False):
        window = Window(size)
        scene = window.add_scene(background=(0.2, 0.4, 0.8))
        mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(mapper, grid(), CLOUD)
        if vectors:
            mapper.SetVectorArrayName("wind")
            getattr(mapper, "SetVectorStyleTo" + vectors)()
            mapper.SetSegmentWidth(width)
        inside = max(np.abs(np.subtract(eye, 0.5))) < 0.5
        scene.look(eye, (0.5, 0.5, 0.5), near=0.01 if inside else 1, far=10)
        if opaque:
            scene.add_opaque(ball(), (0.8, 0.2, 0))
        return window, scene, mapper

    def test_the_image_is_that_of_a_smaller_window(self):
        for distance in (2, 3):
            for options in ({}, {"vectors": "Streaks"}, {"vectors": "Segments"}, {"eye": (0.45, 0.52, 0.6)}, {"opaque": True}):
                if distance == 2 and "opaque" in options:
                    continue  # the middle of a larger pixel is that of a pixel, at odd distances only
                window, _, mapper = self.scene(**options)
                mapper.AutoAdjustSampleDistancesOff()
                mapper.SetImageSampleDistance(distance)
                window.render()
                self.fail_on_messages(window)
                self.assertEqual(mapper.GetLastImageSampleDistance(), distance)
                small, _, exact = self.scene((SIZE[0] // distance, SIZE[1] // distance), width=1.5 / distance, **options)
                small.render()
                drawn, expected = float_image(mapper), float_image(exact)
                self.assertEqual(drawn.shape, expected.shape)
                self.assertGreater(expected[..., 3].max(), 0.5)
                error = np.abs(drawn - expected).max(axis=2)
                print(f"  distance {distance}, {options}: at most {error.max():.1e}, above 1e-4 at {(error > 1e-4).mean():.4f} of the pixels")
                self.assertLess((error > 1e-4).mean(), 0.004, options)

    def test_moving_and_at_rest(self):
        window, scene, mapper = self.scene((360, 288))
        window.render()
        window.render()
        still = scene.rgb()
        self.assertEqual(mapper.GetLastImageSampleDistance(), 1)
        window.window.SetDesiredUpdateRate(1e6)  # so fast is no driver
        mapper.SetMaximumImageSampleDistance(4)
        for _ in range(3):
            window.render()
        self.assertEqual(mapper.GetLastImageSampleDistance(), 4)
        moving = scene.rgb()
        error = np.abs(moving - still).mean()
        shifted = np.abs(np.roll(still, 4, 0) - still).mean()
        print(f"  mean error while moving {255 * error:.2f}/255, of the picture moved by 4 pixels {255 * shifted:.2f}/255")
        self.assertGreater(error, 0)
        self.assertLess(error, 0.5 * shifted)
        window.window.SetDesiredUpdateRate(1e-4)
        window.render()
        np.testing.assert_array_equal(scene.rgb(), still)
        mapper.AutoAdjustSampleDistancesOff()
        window.window.SetDesiredUpdateRate(1e6)
        window.render()
        np.testing.assert_array_equal(scene.rgb(), still)


if __name__ == "__main__":
    unittest.main()
