# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces add up to the whole, threads change nothing, time passes through, blocks are taken one by one."""
import hashlib  # noqa: F401  (the processes of other threads)
import os
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader, vtkXMLRectilinearGridWriter

import globe_fields as gf
import nephoscope
from nephoscope_testing import threads

LON, LAT = np.arange(36) * 10.0, np.linspace(90.0, -90.0, 19)


def weather():
    x, y, z = gf.mesh(LON, LAT, gf.PRESSURES)
    rng = np.random.default_rng(1)
    u, v, w = rng.normal(0, 10, (3, len(x)))
    return gf.rectilinear(LON, LAT, gf.PRESSURES, {"u": u, "v": v, "w": 0.01 * w, "t": 0 * x + 260.0, "id": np.arange(len(x))})


def state(output):
    """Everything the filter wrote, one row a point."""
    names = ("id", "Height", "Wind", "DisplayVelocity", "BelowGround")
    return np.column_stack([gf.points(output)] + [gf.values(output, n) for n in names])


class Pieces(unittest.TestCase):
    def test_pieces_make_the_whole(self):
        grid = weather()
        whole = gf.globe(grid).GetOutput()
        self.assertEqual(whole.GetExtent(), (0, 36, 0, 18, 0, 3))
        expected = gf.cube(whole, state(whole))
        for count in (2, 3, 7):
            seen = np.zeros(expected.shape[:3], int)
            cells = 0
            for piece in range(count):
                made = nephoscope.vtkGlobeGrid()
                made.SetInputData(grid)
                made.UpdatePiece(piece, count, 0)
                part = made.GetOutput()
                e = part.GetExtent()
                box = (slice(e[4], e[5] + 1), slice(e[2], e[3] + 1), slice(e[0], e[1] + 1))
                np.testing.assert_array_equal(gf.cube(part, state(part)), expected[box])
                seen[box] += 1
                cells += part.GetNumberOfCells()
            self.assertTrue((seen > 0).all())
            self.assertEqual(cells, whole.GetNumberOfCells())

    def test_from_a_file_the_whole_extent_is_known_before_the_data(self):
        path = os.path.join(os.environ.get("NEPHOSCOPE_TEST_OUTPUT", "."), "globe_grid_pieces.vtr")
        writer = vtkXMLRectilinearGridWriter()
        writer.SetInputData(weather())
        writer.SetFileName(path)
        writer.Write()
        reader = vtkXMLRectilinearGridReader()
        reader.SetFileName(path)
        made = nephoscope.vtkGlobeGrid()
        made.SetInputConnection(reader.GetOutputPort())
        made.UpdateInformation()
        self.assertEqual(made.GetOutputInformation(0).Get(SDDP.WHOLE_EXTENT()), (0, 36, 0, 18, 0, 3))
        made.Update()
        np.testing.assert_array_equal(state(made.GetOutput()), state(gf.globe(weather()).GetOutput()))
        runs = []
        made.AddObserver("StartEvent", lambda *_: runs.append(1))
        made.Update()
        self.assertEqual(runs, [])  # up to date: no second run

    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, weather())
        blocks.SetBlock(1, gf.rectilinear([0.0, 1, 2], [0.0, 1], [0.0, 5.0]))
        made = nephoscope.vtkGlobeGrid()
        made.SetInputDataObject(blocks)
        made.Update()
        out = made.GetOutputDataObject(0)
        np.testing.assert_array_equal(state(out.GetBlock(0)), state(gf.globe(weather()).GetOutput()))
        self.assertEqual(out.GetBlock(1).GetNumberOfPoints(), 12)

    def test_abort_gives_nothing(self):
        made = nephoscope.vtkGlobeGrid()
        made.SetInputData(weather())
        made.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
        made.Update()
        self.assertEqual(made.GetOutput().GetNumberOfPoints(), 0)


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        made = threads.results(
            __file__, "hashlib.sha256(state(gf.globe(weather()).GetOutput()).tobytes()).hexdigest()")
        self.assertEqual(len(made), 1)


if __name__ == "__main__":
    unittest.main()
