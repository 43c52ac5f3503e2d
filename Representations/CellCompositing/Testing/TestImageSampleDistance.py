# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fewer rays while the camera moves: each is the ray of a pixel of a smaller window, the image between them is interpolated."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import random_transfer
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

SIZE = (120, 96)


def tetrahedra():
    rng = np.random.default_rng(3)
    data = meshes.delaunay(rng, 60)
    meshes.with_field(data, meshes.linear_field(rng, data))
    return data


def image():
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-5, 5, -4, 4, -6, 6)
    source.Update()
    data = source.GetOutput()
    data.GetPointData().GetArray("RTData").SetName("s")
    data.SetSpacing(0.2, 0.2, 0.2)
    return data


def ball():
    source = vtkSphereSource()
    source.SetCenter(0.2, 0, 0.3)
    source.SetRadius(0.4)
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    source.Update()
    return source.GetOutput()


class Moving(ImageTestCase):
    def scene(self, data, size=SIZE, look=None, viewport=(0, 0, 1, 1), opaque=False):
        window = Window(size)
        scene = window.add_scene(viewport=viewport, background=(0.2, 0.4, 0.8))
        ours = mapper()
        transfer = random_transfer(np.random.default_rng(5), 4, *data.GetPointData().GetArray("s").GetRange())
        volume = scene.add_volume(ours, data, transfer)
        if look:
            scene.look(*look)
        else:
            scene.look_at(volume)
        if opaque:
            scene.add_opaque(ball(), (0.8, 0.2, 0))
        return window, scene, ours

    def spread(self, ours, distance):
        ours.AutoAdjustSampleDistancesOff()
        ours.SetImageSampleDistance(distance)

    def test_rays_are_those_of_a_smaller_window(self):
        inside = ((0.1, 0.05, 0.1), (0.1, 0.05, -1), (0, 1, 0), 60)
        for label, data in (("tetrahedra", tetrahedra()), ("image", image())):
            for look in (None, inside):
                for opaque in (False, True):
                    for distance in (2, 3, 4):
                        if opaque and distance != 3:
                            continue  # the middle of a larger pixel is that of a pixel, at odd distances only
                        window, _, ours = self.scene(data, look=look, opaque=opaque)
                        self.spread(ours, distance)
                        window.render()
                        self.fail_on_messages(window)
                        self.assertEqual(ours.GetLastImageSampleDistance(), distance)
                        small, _, exact = self.scene(data, (SIZE[0] // distance, SIZE[1] // distance), look, opaque=opaque)
                        small.render()
                        drawn, expected = float_image(ours), float_image(exact)
                        self.assertEqual(drawn.shape, expected.shape)
                        self.assertGreater(np.abs(expected).max(), 0.01)
                        error = np.abs(drawn - expected).max(axis=2)
                        name = f"{label}, opaque {opaque}, eye {'inside' if look else 'outside'}, distance {distance}"
                        print(f"  {name}: at most {error.max():.1e}, above 1e-4 at {(error > 1e-4).mean():.4f} of the pixels")
                        # A rasterizer may give a face of the boundary, or the ball, to a pixel at its very edge or not.
                        self.assertLess((error > 1e-4).mean(), 0.004, name)

    def test_the_picture_is_nearly_that_at_rest(self):
        for viewport in ((0, 0, 1, 1), (0.35, 0.4, 0.95, 1)):
            for data in (tetrahedra(), image()):
                window, scene, ours = self.scene(data, (240, 192), viewport=viewport)
                window.render()
                still, exact = scene.rgb(), float_image(ours)
                self.assertEqual(ours.GetLastImageSampleDistance(), 1)
                for distance in (1.5, 2, 4, 7):
                    self.spread(ours, distance)
                    window.render()
                    moving = scene.rgb()
                    error = np.abs(moving - still).mean()
                    shift = [np.abs(np.roll(still, distance, axis)[8:-8, 8:-8] - still[8:-8, 8:-8]).mean()
                             for axis in (0, 1) if distance >= 2]
                    print(f"  distance {distance}: mean error {255 * error:.2f}/255; of the picture moved so far: "
                          f"{[round(255 * s, 2) for s in shift]}")
                    self.assertGreater(error, 0)
                    self.assertLess(error, 0.5 * min(shift, default=1), "no more than a blur")
                    clear = exact[..., 3] == 0
                    far = clear & ~_near(~clear, 16)
                    np.testing.assert_array_equal(moving[far], still[far], "away from the data nothing changes")
                self.spread(ours, 1)
                window.render()
                np.testing.assert_array_equal(scene.rgb(), still)

    def test_interactors_spread_the_rays_and_let_them_rest(self):
        window, scene, ours = self.scene(tetrahedra(), (300, 300))
        interactor = vtkGenericRenderWindowInteractor()
        interactor.SetRenderWindow(window.window)
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        interactor.SetDesiredUpdateRate(1e6)  # so fast is no driver
        interactor.Initialize()
        distances = []

        def act(event, x):
            interactor.SetEventInformation(x, 150)
            getattr(interactor, event)()
            distances.append(ours.GetLastImageSampleDistance())

        for _ in range(2):
            window.render()
        act("LeftButtonPressEvent", 150)
        for x in (155, 160, 165, 170):
            act("MouseMoveEvent", x)
        act("LeftButtonReleaseEvent", 170)
        print(f"  distances {distances}")
        self.assertEqual(distances[0], 1)
        self.assertGreater(distances[3], 1)
        self.assertEqual(distances[-1], 1)
        turned = scene.rgb()
        ours.AutoAdjustSampleDistancesOff()
        window.render()
        np.testing.assert_array_equal(scene.rgb(), turned)
        window.window.SetDesiredUpdateRate(1e6)
        window.render()
        np.testing.assert_array_equal(scene.rgb(), turned, "off: a ray for each pixel")

    def test_windows_of_a_pixel(self):
        for size in ((1, 1), (2, 3), (17, 5)):
            window, _, ours = self.scene(tetrahedra(), size)
            self.spread(ours, 16)
            window.render()
            self.fail_on_messages(window, str(size))
            self.assertEqual(window.gl_errors(), [])

    def test_settings(self):
        ours = mapper()
        ours.SetImageSampleDistance(0.1)
        ours.SetMaximumImageSampleDistance(1000)
        self.assertEqual((ours.GetImageSampleDistance(), ours.GetMaximumImageSampleDistance()), (1, 16))
        self.assertTrue(ours.GetAutoAdjustSampleDistances())
        other = mapper()
        ours.AutoAdjustSampleDistancesOff()
        ours.SetImageSampleDistance(3)
        other.ShallowCopy(ours)
        self.assertEqual((other.GetAutoAdjustSampleDistances(), other.GetImageSampleDistance(), other.GetMaximumImageSampleDistance()),
                         (False, 3, 16))


def _near(mask, pixels):
    grown = mask.copy()
    for axis in (0, 1):
        grown = np.max([np.roll(grown, step, axis) for step in range(-pixels, pixels + 1)], axis=0)
    return grown


if __name__ == "__main__":
    unittest.main()
