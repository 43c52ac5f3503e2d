# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_smoke_widget: the polygon faces the flow where the ball is dragged, and the smoke flows from there."""
import random
import unittest
from unittest import mock

import nephoscope
import numpy as np
import pyvista
from nephoscope._drag_pace import DragPace


def whirl():
    """About the z axis, one radian a second."""
    mesh = pyvista.ImageData(dimensions=(21, 21, 11), origin=(-10, -10, -5))
    x, y, _ = mesh.points.T
    mesh["v"] = np.column_stack((-y, x, 0 * x))
    return mesh


class Widget(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(self.plotter.close)

    def add(self, **options):
        made = nephoscope.add_smoke_widget(self.plotter, whirl(), center=(5, 0, 0), radius=0.6, duration=1, **options)
        self.plotter.camera_position = "xy"
        self.plotter.show(auto_close=False, interactive=False)
        self.made, self.widget, self.volume = made, made.ball, made.volume
        return made.polygon

    def drag(self, *place, end=True):
        self.widget.SetCenter(place)
        self.widget.InvokeEvent("InteractionEvent")
        if end:
            self.widget.InvokeEvent("EndInteractionEvent")

    def check(self, line, center, angle):
        """The polygon is around the centre and across the flow there; the smoke goes round by a radian."""
        points = np.array(line.mapper.dataset.points)
        np.testing.assert_allclose(points.mean(axis=0), center, atol=1e-6)
        flow = np.array((-center[1], center[0], 0)) / np.hypot(*center[:2])
        np.testing.assert_allclose((points - center) @ flow, 0, atol=1e-6)
        np.testing.assert_allclose(np.linalg.norm(points - center, axis=1), 0.6, atol=1e-6)
        smoke = self.volume.mapper.dataset
        age = smoke.point_data["Age"]
        youngest, oldest = (np.array(smoke.points[age == wanted]).mean(axis=0) for wanted in (0, age.max()))
        np.testing.assert_allclose(youngest, center, atol=0.05)
        turned = np.arctan2(oldest[1], oldest[0]) - angle
        self.assertAlmostEqual(np.angle(np.exp(1j * turned)), 1, delta=0.02)

    def test_polygon_and_smoke_follow_the_ball(self):
        line = self.add()
        self.check(line, (5, 0, 0), 0)
        before = self.plotter.screenshot(return_img=True)
        self.drag(0, 4, 1, end=False)
        self.check(line, (0, 4, 1), np.pi / 2)
        self.plotter.render()
        self.assertGreater(np.abs(self.plotter.screenshot(return_img=True).astype(int) - before).max(), 50)

    def test_smoke_is_coarser_while_it_is_dragged_too_slowly(self):
        """And complete when the ball is released; where updates are fast enough, it is never coarser."""
        counts = {}
        for rate in (1e-6, 1e6):
            with mock.patch.multiple("nephoscope._drag_pace", UPDATES_PER_SECOND=rate, COARSEST=100, EXTRA=0, MOST_GROWTH=1e9):
                self.add()
                counts[rate] = []
                for step in range(4):
                    self.drag(0, 4, 0.1 * step, end=step == 3)
                    self.plotter.render()
                    counts[rate].append(self.volume.mapper.dataset.n_cells)
        self.assertGreater(min(counts[1e-6]), 300)
        self.assertTrue(all(0 < count <= 100 for count in counts[1e6][1:3]), counts)
        self.assertEqual(counts[1e6][3], counts[1e-6][3])

    def test_pace_of_a_drag(self):
        """Seconds of an update: a fixed part and a part per tetrahedron, up to 10 % more or less. Volumes have fewer tetrahedra than they may."""
        for fixed, each, low, high in ((0.03, 3e-6, 0.08, 0.11), (0.09, 2e-6, 0.09, 0.12), (0.5, 3e-6, 0.52, 0.64), (0.005, 3e-5, 0.06, 0.11), (0.001, 1e-7, 0, 0.012)):
            chance, pace, seconds = random.Random(1), DragPace(70_000), []
            pace.note(70_000, 1 + fixed + 70_000 * each)  # compiles shaders
            pace.note(pace.number, 0.3 + fixed + pace.number * each)  # and more of them
            for _ in range(60):
                cells = int(pace.number * chance.uniform(0.7, 1))
                pace.note(cells, (fixed + cells * each) * chance.uniform(0.9, 1.1))
                seconds.append(fixed + pace.number * each)
                self.assertTrue(2000 <= pace.number <= 70_000)
            self.assertTrue(low <= np.median(seconds[20:]) <= high, (fixed, each, np.median(seconds[20:])))

    def test_smoke_waits_for_the_end_of_the_drag(self):
        line = self.add(while_dragging=False)
        self.drag(0, 4, 1, end=False)
        np.testing.assert_allclose(np.array(line.mapper.dataset.points).mean(axis=0), (0, 4, 1), atol=1e-6)
        self.assertGreater(self.volume.mapper.dataset.bounds[1], 4)  # still where it was
        self.drag(0, 4, 1)
        self.check(line, (0, 4, 1), np.pi / 2)

    def test_ball_moves_along(self):
        self.add()
        made = self.made
        made.move((0, 4, 1))
        np.testing.assert_allclose(made.ball.GetCenter(), (0, 4, 1), atol=1e-6)
        np.testing.assert_allclose(np.array(made.polygon.mapper.dataset.points).mean(axis=0), (0, 4, 1), atol=1e-6)
        for center in ((np.nan, 0, 0), (1, 2), None):
            with self.assertRaisesRegex(ValueError, "center"):
                made.move(center)

    def test_outside_nothing_is_drawn_and_back_it_is(self):
        line = self.add()
        self.drag(40, 0, 0)
        self.assertFalse(self.volume.GetVisibility() or line.GetVisibility())
        self.drag(0, 4, 1)
        self.assertTrue(self.volume.GetVisibility() and line.GetVisibility())
        self.check(line, (0, 4, 1), np.pi / 2)

    def test_wrong_arguments(self):
        series = [whirl(), whirl()]
        for mesh, options, error, text in ((whirl(), {"times": [0, 1]}, ValueError, "one mesh, of a steady flow. Leave 'times' out. For"),
                                           (series, {"times": [0, 1]}, ValueError, r"Leave 'times' out, and pass one of the meshes, such as series\[0\]. For"),
                                           (series, {}, TypeError, r"mesh is a list; the widget needs one mesh, of a steady flow: pass one .* series\[0\]"),
                                           (lambda time: whirl(), {"times": [0, 1]}, ValueError, "and pass its result for one time"),
                                           (whirl(), {"vectors": "w"}, ValueError, "'w'")):
            with self.assertRaisesRegex(error, text):
                nephoscope.add_smoke_widget(self.plotter, mesh, **options)
        with self.assertRaisesRegex(TypeError, "plotter"):
            nephoscope.add_smoke_widget(None, whirl())


if __name__ == "__main__":
    unittest.main()
