# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the hierarchy of splats: exact without a tolerance, better with a smaller one, coarse while the camera moves."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

CLOUD = Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (0.05, 0), (1, 12)])


def cloud(points):
    x, y, z = (2 * points - 1).T
    radius = np.sqrt(x * x + y * y + z * z)
    return np.clip(1.3 - 2 * radius + 0.35 * np.sin(5 * x + 1) * np.cos(6 * y) * np.sin(4 * z + 0.5), 0, 1)


def grid(cells=(22, 18, 25)):
    return meshes.with_field(meshes.image(cells, tuple(1 / c for c in cells)), cloud)


class Hierarchy(ImageTestCase):
    def scene(self, data, configure=None):
        window = Window((128, 128))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(mapper, data, CLOUD)
        scene.look((1.3, 1.1, 3.4), (0.5, 0.5, 0.5))
        if configure:
            configure(mapper)
        return window, mapper

    def draw(self, window, mapper):
        window.render()
        self.fail_on_messages(window)
        return float_image(mapper)

    def error(self, image, exact):
        return np.sqrt(((image - exact)**2).mean())

    def test_smaller_tolerances_are_better(self):
        for data in (grid(), self.particles()):
            window, mapper = self.scene(data)
            exact = self.draw(window, mapper)
            leaves = mapper.GetNumberOfDrawnSplats()
            for unit in ("Image", "Data"):
                getattr(mapper, "SetErrorToleranceUnitTo" + unit)()
                found = []
                for tolerance in (1e-4, 0.1, 1.0):
                    mapper.SetErrorTolerance(tolerance)
                    image = self.draw(window, mapper)
                    found.append((mapper.GetNumberOfDrawnSplats(), self.error(image, exact)))
                counts, errors = zip(*found)
                self.assertEqual(sorted(counts, reverse=True), list(counts))
                self.assertEqual(sorted(errors), list(errors))
                self.assertLess(errors[0], 1e-3)
                self.assertLess(counts[2], leaves)
            mapper.SetErrorTolerance(0)
            np.testing.assert_array_equal(self.draw(window, mapper), exact)

    def particles(self, order=None):
        points = np.random.default_rng(3).uniform(0, 1, (4000, 3))
        points = points if order is None else points[order]
        return meshes.with_field(meshes.particles(points), cloud)

    def test_40_decibels_with_a_fifth_of_the_splats(self):
        window, mapper = self.scene(grid((95, 95, 95)))
        exact = self.draw(window, mapper)
        leaves = mapper.GetNumberOfDrawnSplats()
        mapper.SetErrorTolerance(0.3)
        error = self.error(self.draw(window, mapper), exact)
        self.assertLess(error, 0.01)
        self.assertLess(mapper.GetNumberOfDrawnSplats(), leaves / 5)

    def test_constant_data_do_not_become_a_ball(self):
        """Samples do not differ from the mean of a block at all, but splats that stand for blocks must also be at the faces where it ends."""
        data = meshes.with_field(meshes.image((31, 31, 31), (1 / 31,) * 3), lambda p: 0.5 + 0 * p[:, 0])
        window, mapper = self.scene(data)
        exact = self.draw(window, mapper)
        for measure in ("Picture", "RootMeanSquare", "Greatest"):
            getattr(mapper, "SetErrorMeasureTo" + measure)()
            mapper.SetErrorTolerance(0.1)
            image = self.draw(window, mapper)
            self.assertLess(np.abs(image - exact).max(), 0.1, measure)
            mapper.SetErrorTolerance(1.0)
            self.draw(window, mapper)
            self.assertLess(mapper.GetNumberOfDrawnSplats(), mapper.GetNumberOfSamples() / 6)

    def test_nothing_pops(self):
        """As the tolerance moves in small steps, the picture does too; without blending it does not."""
        largest = {}
        for blend in (0.0, 0.5):
            window, mapper = self.scene(grid((15, 15, 15)), lambda m: m.SetLevelBlending(blend))
            pictures = []
            for tolerance in np.geomspace(1.5, 1.8, 40):
                mapper.SetErrorTolerance(tolerance)
                pictures.append(self.draw(window, mapper))
            largest[blend] = np.abs(np.diff(pictures, axis=0)).max()
        print(f"  largest step without blending {largest[0.0]:.4f}, with it {largest[0.5]:.4f}")
        self.assertGreater(largest[0.0], 0.01)
        self.assertLess(largest[0.5], 0.1 * largest[0.0])

    def test_nothing_pops_as_the_camera_moves(self):
        """Against the picture of every sample, so that only the hierarchy counts."""
        largest = {}
        for blend in (0.0, 0.5):
            window, mapper = self.scene(grid((15, 15, 15)), lambda m: m.SetLevelBlending(blend))
            renderer = window.window.GetRenderers().GetFirstRenderer()
            errors = []
            for _ in range(40):
                renderer.GetActiveCamera().Dolly(1.004)
                difference = []
                for tolerance in (1.6, 0):
                    mapper.SetErrorTolerance(tolerance)
                    difference.append(self.draw(window, mapper))
                errors.append(difference[0] - difference[1])
            largest[blend] = np.abs(np.diff(errors, axis=0)).max()
        print(f"  largest step without blending {largest[0.0]:.4f}, with it {largest[0.5]:.4f}")
        self.assertGreater(largest[0.0], 0.01)
        self.assertLess(largest[0.5], 0.2 * largest[0.0])

    def test_order_of_the_input_does_not_matter(self):
        pictures = []
        for order in (None, np.random.default_rng(4).permutation(4000)):
            window, mapper = self.scene(self.particles(order), lambda m: m.SetErrorTolerance(0.3))
            pictures.append(self.draw(window, mapper))
        np.testing.assert_array_equal(*pictures)

    def test_coarse_while_the_camera_moves(self):
        window, mapper = self.scene(grid(), lambda m: m.SetInteractiveMaximumNumberOfSplats(300))
        mapper.AutoAdjustSampleDistancesOff()  # images of one size are compared
        still = self.draw(window, mapper)
        leaves = mapper.GetNumberOfDrawnSplats()
        window.window.SetDesiredUpdateRate(15)
        moving = self.draw(window, mapper)
        self.assertLessEqual(mapper.GetNumberOfDrawnSplats(), 300)
        self.assertGreater(mapper.GetDrawnErrorTolerance(), 0)
        self.assertLess(self.error(moving, still), 0.1)
        window.window.SetDesiredUpdateRate(0.0001)
        np.testing.assert_array_equal(self.draw(window, mapper), still)
        self.assertEqual(mapper.GetNumberOfDrawnSplats(), leaves)

    def test_coarse_while_an_interactor_turns_the_camera(self):
        window, mapper = self.scene(grid(), lambda m: m.SetInteractiveMaximumNumberOfSplats(300))
        interactor = vtkGenericRenderWindowInteractor()
        interactor.SetRenderWindow(window.window)
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        interactor.Initialize()
        counts = []

        def act(event, place):
            interactor.SetEventInformation(*place)
            getattr(interactor, event)()
            counts.append(mapper.GetNumberOfDrawnSplats())

        act("LeftButtonPressEvent", (60, 60))
        act("MouseMoveEvent", (70, 64))
        act("MouseMoveEvent", (80, 70))
        act("LeftButtonReleaseEvent", (80, 70))
        self.assertTrue(0 < counts[1] <= 300 and 0 < counts[2] <= 300, counts)
        self.assertEqual(counts[3], mapper.GetNumberOfSamples())
        refined = float_image(mapper)
        np.testing.assert_array_equal(self.draw(window, mapper), refined)

    def test_values_that_are_not_numbers_and_blanked_points(self):
        data = grid()
        for i in range(0, data.GetNumberOfPoints(), 7):
            data.GetPointData().GetArray("s").SetValue(i, np.nan)
        blanked = np.zeros(data.GetNumberOfPoints(), np.uint8)
        blanked[::5] = 2  # hidden
        meshes.add_array(data.GetPointData(), blanked, "vtkGhostType")
        window, mapper = self.scene(data)
        window.render()
        exact = float_image(mapper)
        self.assertEqual(len(window.messages.all), 1)
        self.assertIn("points are not drawn because array 's'", window.messages.warnings[0])
        window.messages.clear()
        mapper.SetErrorTolerance(0.1)
        image = self.draw(window, mapper)
        self.assertTrue(np.isfinite(image).all())
        self.assertLess(self.error(image, exact), 0.05)

    def test_vectors_of_nodes(self):
        data = grid()
        wind = np.zeros((data.GetNumberOfPoints(), 3)) + (1, 0.5, 0)
        meshes.add_array(data.GetPointData(), wind, "wind")
        window, mapper = self.scene(data, lambda m: m.SetVectorArrayName("wind"))
        self.draw(window, mapper)
        leaves = mapper.GetNumberOfDrawnSplats()
        mapper.SetErrorTolerance(0.3)
        image = self.draw(window, mapper)
        self.assertTrue(np.isfinite(image).all())
        self.assertGreater(image[..., 3].max(), 0.3)
        self.assertLess(mapper.GetNumberOfDrawnSplats(), leaves)

    def test_vectors_fade_with_their_splats(self):
        data = grid((15, 15, 15))
        meshes.add_array(data.GetPointData(), np.zeros((data.GetNumberOfPoints(), 3)) + (1, 0.5, 0), "wind")
        for style in ("Streaks", "Segments"):
            window, mapper = self.scene(data, lambda m: (m.SetVectorArrayName("wind"), m.SetLevelBlending(0.5)))
            getattr(mapper, "SetVectorStyleTo" + style)()
            mapper.SetErrorTolerance(2)
            pictures = []
            for tolerance in np.geomspace(1.5, 1.8, 40):
                mapper.SetErrorTolerance(tolerance)
                pictures.append(self.draw(window, mapper))
            self.assertLess(np.abs(np.diff(pictures, axis=0)).max(), 0.05, style)
            self.assertGreater(np.abs(pictures[0] - pictures[-1]).max(), 0.01, style)


if __name__ == "__main__":
    unittest.main()
