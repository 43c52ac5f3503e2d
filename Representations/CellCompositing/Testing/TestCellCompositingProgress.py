# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress events of the mapper while it makes geometry and order, and what is left when it is told to stop."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer


class Progress(ImageTestCase):
    def setUp(self):
        rng = np.random.default_rng(21)
        self.data = meshes.shell()
        meshes.add_array(self.data.GetCellData(), rng.uniform(0, 1, self.data.GetNumberOfCells()))
        self.transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 3), (1, 1)])
        self.window, self.mapper, self.events = Window(), mapper(), []
        self.mapper.SetMethodToProjection()
        self.scene = self.window.add_scene()
        self.scene.look_at(self.scene.add_volume(self.mapper, self.data, self.transfer, association="cell"))
        self.mapper.AddObserver("ProgressEvent", lambda *_: self.events.append(self.mapper.GetProgress()))

    def picture(self):
        other, ours = Window(), mapper()
        ours.SetMethodToProjection()
        scene = other.add_scene()
        scene.look_at(scene.add_volume(ours, self.data, self.transfer, association="cell"))
        scene.camera.DeepCopy(self.scene.camera)
        other.render()
        return float_image(ours)

    def test_events_grow(self):
        self.window.render()
        self.assertGreater(len(self.events), 10)
        self.assertEqual(self.events, sorted(self.events))
        self.assertAlmostEqual(self.events[-1], 1)
        first = len(self.events)
        self.window.render()
        self.assertEqual(len(self.events), first, "nothing is made, nothing is told")
        self.scene.camera.Azimuth(10)
        self.window.render()
        moved = self.events[first:]
        self.assertGreater(len(moved), 2)
        self.assertGreaterEqual(min(moved), 0.5)
        self.fail_on_messages(self.window)

    def stop_at(self, fraction, stop):
        def listen(*_):
            if self.mapper.GetProgress() >= fraction:
                stop()
        return self.mapper.AddObserver("ProgressEvent", listen)

    def test_stopped_and_rendered_again(self):
        expected = self.picture()
        stops = {"AbortExecute of the mapper": self.mapper.AbortExecuteOn,
                 "AbortRender of the window": lambda: self.window.window.SetAbortRender(1)}
        for label, stop in stops.items():
            for fraction in (0.0, 0.3, 0.49, 0.55, 0.7, 0.9):
                self.data.GetPoints().InsertNextPoint(0, 0, 0)  # which no cell uses: everything is made again
                self.data.GetPoints().Modified()
                self.mapper.Update()  # whose events, 0 and 1, are the pipeline's
                tag = self.stop_at(fraction, stop)
                self.events.clear()
                self.window.render()
                self.assertLess(max(self.events), 1, f"{label} at {fraction}")
                self.assertEqual(sum(e >= fraction for e in self.events), 1, f"{label} at {fraction}: went on after the stop")
                self.mapper.RemoveObserver(tag)
                self.window.render()
                np.testing.assert_array_equal(float_image(self.mapper), expected, f"{label} at {fraction}")
                self.assertEqual(self.mapper.GetNumberOfTetrahedra(), self.data.GetNumberOfCells())
        self.fail_on_messages(self.window)

    def test_calls_in_between_do_no_harm(self):
        expected, counts = self.picture(), set()

        def meddle(*_):
            counts.add(self.mapper.GetNumberOfVisibilityCycles())
            self.window.window.Render()
            str(self.mapper)
        self.mapper.AddObserver("ProgressEvent", meddle)
        self.window.render()
        self.assertEqual(counts, {0}, "while the order is made, none is known")
        np.testing.assert_array_equal(float_image(self.mapper), expected)
        self.fail_on_messages(self.window)

    def test_a_moved_camera_and_a_stop(self):
        self.window.render()
        self.scene.camera.Azimuth(70)
        tag = self.stop_at(0.5, self.mapper.AbortExecuteOn)
        self.window.render()
        self.mapper.RemoveObserver(tag)
        self.window.render()
        np.testing.assert_array_equal(float_image(self.mapper), self.picture())
        self.scene.camera.Azimuth(-70)
        tag = self.stop_at(0.5, self.mapper.AbortExecuteOn)
        self.window.render()
        self.mapper.RemoveObserver(tag)
        self.assertEqual(self.mapper.GetNumberOfVisibilityCycles(), 0, "asked in between")
        self.window.render()
        np.testing.assert_array_equal(float_image(self.mapper), self.picture())


if __name__ == "__main__":
    unittest.main(verbosity=2)
