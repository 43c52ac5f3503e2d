# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Threads and pieces change nothing, blocks are contoured one by one, abort gives nothing, progress rises."""
import hashlib
import unittest

import cloud_grids as cg
import nephoscope
import numpy as np
from nephoscope_testing import threads
from nephoscope_testing.filters import some_values_given
from TestCloudSurfaceSeams import blob_globe
from TestSmoothingPipeline import rectilinear
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet


def digest():
    made = hashlib.sha256()
    for data in (blob_globe(), rectilinear()):
        out = cg.surface(data, [0.5, 0.1], 2)
        made.update(cg.triangles(out).tobytes())
        for array in ("f", "Normals"):
            made.update(cg.values(out, array).tobytes())
        made.update(cg.points(out).tobytes())
    return made.hexdigest()


def corners(out):
    """Triangles as rows of coordinates and normals, sorted; exact."""
    t = cg.triangles(out)
    rows = np.concatenate([cg.points(out), cg.values(out, "Normals")], axis=1)[t]
    return sorted(tuple(sorted(map(tuple, row))) for row in rows)


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        self.assertEqual(len(threads.results(__file__, "digest()")), 1)


class Pieces(unittest.TestCase):
    def test_pieces_make_the_whole(self):
        """Every triangle in one piece, the same place and the same normals bit by bit, on an open ring too."""
        for data, value, settings in ((blob_globe(), 0.5, {}), (blob_globe(repeat=False), 0.5, {"Periodic": 0}), (rectilinear(), 0.1, {})):
            whole = corners(cg.surface(data, [value], 2, **settings))
            self.assertGreater(len(whole), 100)
            for count in (2, 5):
                parts = []
                for piece in range(count):
                    made = nephoscope.vtkCloudSurface()
                    made.SetInputData(data)
                    made.SetValue(0, value)
                    made.SetNumberOfSmoothingIterations(2)
                    cg.set_up(made, settings)
                    made.UpdatePiece(piece, count, 0)
                    self.assertLess(made.GetOutput().GetNumberOfCells(), len(whole))
                    parts += corners(made.GetOutput())
                self.assertEqual(sorted(parts), whole)

    def test_the_pole_has_the_values_of_the_first_column(self):
        """An array that jumps there, as a longitude does, whichever columns a piece has."""
        data = blob_globe()
        columns, rows, levels = (e + 1 for e in data.GetExtent()[1::2])
        data.GetPointData().AddArray(cg.array("column", 1000.0 + np.tile(np.arange(columns), rows * levels)))
        for count in (1, 2, 5):
            poles = 0
            for piece in range(count):
                made = nephoscope.vtkCloudSurface()
                made.SetInputData(data)
                made.SetValue(0, 0.5)
                made.UpdatePiece(piece, count, 0)
                on_axis = np.linalg.norm(cg.points(made.GetOutput())[:, :2], axis=1) < 1e-9
                self.assertEqual(set(cg.values(made.GetOutput(), "column")[on_axis]) | {1000.0}, {1000.0})
                poles += on_axis.sum()
            self.assertGreater(poles, 1)

    def test_more_pieces_than_cells(self):
        data = cg.image(np.random.default_rng(1).random((3, 2, 2)))
        total = 0
        for piece in range(9):
            made = nephoscope.vtkCloudSurface()
            made.SetInputData(data)
            made.SetValue(0, 0.5)
            made.UpdatePiece(piece, 9, 0)
            total += made.GetOutput().GetNumberOfCells()
        self.assertEqual(total, cg.surface(data, [0.5], 1).GetNumberOfCells())


class Running(unittest.TestCase):
    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        for i, data in enumerate((blob_globe(), cg.image(np.ones((3, 3, 3)), name="other"), rectilinear())):
            blocks.SetBlock(i, data)
        out = cg.surface(blocks, [0.5], 1, setup=lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, "f"))
        self.assertEqual(corners(out.GetBlock(0)), corners(cg.surface(blob_globe(), [0.5], 1)))
        self.assertEqual(corners(out.GetBlock(2)), corners(cg.surface(rectilinear(), [0.5], 1)))

    def test_values_that_were_not_given_are_zero(self):
        self.assertEqual(some_values_given(nephoscope.vtkCloudSurface()), [5, 0, 0, 0, 0, 2])

    def test_abort_gives_nothing(self):
        """At the first event, and at a late one."""
        for event in (1, 5):
            seen = []

            def stop(caller, _):
                seen.append(1)
                if len(seen) == event:
                    caller.SetAbortExecute(1)
            out = cg.surface(blob_globe(), [0.5], 1, setup=lambda made: made.AddObserver("ProgressEvent", stop))
            self.assertEqual((out.GetNumberOfPoints(), out.GetNumberOfCells()), (0, 0))

    def test_progress_rises_to_one(self):
        seen = []
        watch = lambda made: made.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress()))
        cg.surface(blob_globe(), [0.5], 4, setup=watch)
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1.0)

    def test_settings_run_it_again_and_nothing_else_does(self):
        runs, made = [], nephoscope.vtkCloudSurface()
        made.SetInputData(rectilinear())
        made.AddObserver("StartEvent", lambda *_: runs.append(1))
        made.GenerateValues(3, -0.5, 0.5)
        self.assertEqual([made.GetValue(i) for i in range(made.GetNumberOfContours())], [-0.5, 0, 0.5])
        for change in (lambda: None, lambda: None, lambda: made.SetValue(1, 0.2), lambda: made.SetNumberOfSmoothingIterations(2),
                       lambda: made.SetPeriodic(0, True), lambda: made.SetConservative(True), lambda: made.SetConservative(True)):
            change()
            made.Update()
        self.assertEqual(len(runs), 5)


if __name__ == "__main__":
    unittest.main()
