# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is kept between updates, progress, abort, threads, and what is printed."""
import re
import time
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, threads
from nephoscope_testing.flow import flow_volume, update
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

SETTINGS = dict(Radius=0.15, Duration=1.0, TimeStep=0.05, PolygonEdgeLength=0.03, MaximumEdgeLength=0.06)


def swirl(points):
    x, y, z = points.T
    return np.column_stack([-2 * y + 0.2 * np.sin(3 * z), 2 * x + 0.5 * y, 1 + 0.3 * x])


def with_swirl(data):
    meshes.add_array(data.GetPointData(), swirl(meshes.points_of(data)), "Flow")
    return data


def image(blocks=12):
    return with_swirl(meshes.image((blocks,) * 3, (2 / blocks,) * 3, (-1,) * 3))


def digest(**settings):
    return update(flow_volume(image(), **{**SETTINGS, **settings}))[0].digest()


class Kept(unittest.TestCase):
    def test_a_moved_polygon_gives_what_a_new_filter_gives(self):
        made = flow_volume(image(), **SETTINGS)
        update(made)
        made.SetCenter(0.1, 0.2, -0.3)
        self.assertEqual(update(made)[0].digest(), digest(Center=(0.1, 0.2, -0.3)))

    def test_search_structure_is_not_made_again(self):
        """A fine unstructured grid, a coarse volume: the second update costs a fraction of the first."""
        divide = vtkDataSetTriangleFilter()
        divide.SetInputData(image(40))
        divide.Update()
        data = divide.GetOutput()
        made = flow_volume(data, Radius=0.02, Duration=0.02, TimeStep=0.01)
        seconds = []
        for shift in (0, 0.1, 0.2):
            made.SetCenter(shift, 0, 0)
            start = time.process_time()
            update(made)
            seconds.append(time.process_time() - start)
        self.assertLess(min(seconds[1:]), 0.2 * seconds[0], seconds)

    def test_changed_data_are_seen(self):
        data = image()
        made = flow_volume(data, **SETTINGS)
        first = update(made)[0]
        values = data.GetPointData().GetArray("Flow")
        vtk_to_numpy(values)[:] = (0, 0, 1)
        values.Modified()
        data.Modified()
        second = update(made)[0]
        self.assertNotEqual(first.digest(), second.digest())
        np.testing.assert_allclose(made.GetNormalUsed(), (0, 0, 1), atol=1e-12)

    def test_changed_choice_is_seen(self):
        data = image()
        meshes.add_array(data.GetPointData(), np.tile([1.0, 0.0, 0.0], (data.GetNumberOfPoints(), 1)), "Other")
        made = flow_volume(data, **SETTINGS, Velocity="Flow")
        update(made)
        made.SetInputArrayToProcess(0, 0, 0, 0, "Other")
        update(made)
        np.testing.assert_allclose(made.GetNormalUsed(), (1, 0, 0), atol=1e-12)

    def test_input_may_go_away(self):
        made = flow_volume(image(), **SETTINGS)
        update(made)
        made.SetInputData(image(4))
        self.assertGreater(len(update(made)[0].cells), 0)
        made.SetInputData(None)


class Progress(unittest.TestCase):
    def test_rises_to_one(self):
        made, seen = flow_volume(image(), **SETTINGS), []
        made.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress()))
        update(made)
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1)
        self.assertGreater(len(seen), 10)

    def test_abort_gives_nothing(self):
        for share in (0, 0.5, 0.85, 1):
            made = flow_volume(image(), **SETTINGS)
            made.AddObserver("ProgressEvent", lambda caller, _, share=share: caller.SetAbortExecute(caller.GetProgress() >= share))
            smoke, messages = update(made)
            self.assertEqual((len(smoke.cells), len(smoke.points), messages, made.GetEmittedMass()), (0, 0, [], 0))
            made.RemoveAllObservers()
            made.SetAbortExecute(0)
            self.assertEqual(update(made)[0].digest(), digest())


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        self.assertEqual(len(threads.results(__file__, "digest()")), 1)


class Printed(unittest.TestCase):
    def test_every_property(self):
        made = nephoscope.vtkFlowVolume()
        text, base = str(made), set(dir(nephoscope.vtkFlowVolume.__mro__[1]))
        names = {name[3:] for name in dir(made) if name.startswith("Get") and name not in base and not re.search("M..Value$", name)}
        names -= {"Controller"} if "Controller" not in text else set()
        self.assertEqual({name for name in names if f"  {name}: " not in text}, set())
        self.assertGreater(len(names), 20)


if __name__ == "__main__":
    unittest.main()
