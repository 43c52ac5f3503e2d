# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Threads and pieces change nothing, blocks are smoothed one by one, abort gives nothing, progress rises."""
import hashlib
import os
import unittest

import cloud_grids as cg
import nephoscope
import numpy as np
from nephoscope_testing import threads
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader, vtkXMLRectilinearGridWriter


def globe():
    positions = cg.globe_positions(48, 25)
    field = np.random.default_rng(1).normal(size=(4, 25, 48))
    return cg.structured(positions, {"f": cg.closed(field), "id": np.arange(positions[..., 0].size).reshape(positions.shape[:3])})


def rectilinear():
    rng = np.random.default_rng(2)
    axes = [np.cumsum(rng.uniform(0.5, 2, n)) for n in (12, 11, 10)]
    return cg.rectilinear(*axes, {"f": rng.normal(size=(10, 11, 12))})


def digest():
    made = hashlib.sha256()
    for data in (globe(), rectilinear()):
        for settings in ({}, {"Conservative": True, "Isotropic": True}):
            made.update(cg.values(cg.smooth(data, 3, **settings)).tobytes())
    return made.hexdigest()


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        self.assertEqual(len(threads.results(__file__, "digest()")), 1)


class Pieces(unittest.TestCase):
    def check(self, data):
        whole = cg.smooth(data, 2)
        expected, seen = cg.cube(whole), np.zeros(cg.cube(whole).shape, int)
        for count in (2, 3):
            for piece in range(count):
                made = nephoscope.vtkStructuredSmoothing()
                made.SetInputData(data)
                made.SetNumberOfIterations(2)
                made.UpdatePiece(piece, count, 0)
                part = made.GetOutput()
                e = part.GetExtent()
                box = (slice(e[4], e[5] + 1), slice(e[2], e[3] + 1), slice(e[0], e[1] + 1))
                self.assertLess(cg.cube(part).size, expected.size)
                np.testing.assert_array_equal(cg.cube(part), expected[box])
                seen[box] += 1
            self.assertTrue((seen > 0).all())

    def test_pieces_make_the_whole(self):
        self.check(globe())
        self.check(rectilinear())
        self.check(cg.image(np.random.default_rng(3).normal(size=(9, 8, 7))))

    def test_a_reader_is_asked_for_all(self):
        path = os.path.join(os.environ.get("NEPHOSCOPE_TEST_OUTPUT", "."), "smoothing_pieces.vtr")
        writer = vtkXMLRectilinearGridWriter()
        writer.SetInputData(rectilinear())
        writer.SetFileName(path)
        writer.Write()
        reader = vtkXMLRectilinearGridReader()
        reader.SetFileName(path)
        made = nephoscope.vtkStructuredSmoothing()
        made.SetInputConnection(reader.GetOutputPort())
        made.SetInputArrayToProcess(0, 0, 0, 0, "f")
        made.UpdatePiece(1, 2, 0)
        part, whole = made.GetOutput(), cg.cube(cg.smooth(rectilinear()))
        e = part.GetExtent()
        np.testing.assert_array_equal(cg.cube(part), whole[e[4]:e[5] + 1, e[2]:e[3] + 1, e[0]:e[1] + 1])


class Running(unittest.TestCase):
    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        for i, data in enumerate((globe(), rectilinear(), cg.image(np.ones((3, 3, 3)), name="other"))):
            blocks.SetBlock(i, data)
        made = cg.smooth(blocks, 2, setup=lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, "f"))
        np.testing.assert_array_equal(cg.values(made.GetBlock(0)), cg.values(cg.smooth(globe(), 2)))
        np.testing.assert_array_equal(cg.values(made.GetBlock(1)), cg.values(cg.smooth(rectilinear(), 2)))

    def test_abort_gives_nothing(self):
        stop = lambda made: made.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
        self.assertEqual(cg.smooth(globe(), 5, setup=stop).GetNumberOfPoints(), 0)

    def test_progress_rises_to_one(self):
        seen = []
        watch = lambda made: made.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress()))
        cg.smooth(globe(), 4, setup=watch, AllFloatArrays=True)
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1.0)
        self.assertGreaterEqual(len(seen), 12)

    def test_settings_run_it_again_and_nothing_else_does(self):
        runs, made = [], nephoscope.vtkStructuredSmoothing()
        made.SetInputData(rectilinear())
        made.AddObserver("StartEvent", lambda *_: runs.append(1))
        for change in (lambda: None, lambda: None, lambda: made.SetPeriodic(1, True), lambda: made.SetPeriodic(1, True),
                       lambda: made.AddArrayName("f"), lambda: made.SetConservative(True)):
            change()
            made.Update()
        self.assertEqual(len(runs), 4)

    def test_all_else_is_passed(self):
        data = globe()
        data.GetCellData().AddArray(cg.array("cell", np.arange(data.GetNumberOfCells())))
        data.GetFieldData().AddArray(cg.array("units", np.arange(3)))
        out = cg.smooth(data)
        np.testing.assert_array_equal(cg.cell_values(out, "cell"), np.arange(data.GetNumberOfCells()))
        np.testing.assert_array_equal(cg.values(out, "id"), cg.values(data, "id"))
        self.assertEqual(out.GetFieldData().GetNumberOfArrays(), 1)
        self.assertEqual(out.GetPoints(), data.GetPoints())


if __name__ == "__main__":
    unittest.main()
