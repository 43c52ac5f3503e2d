# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface that is empty, and cells that stay whole, say why: once, with the range of the values."""
import unittest

import numpy as np
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet

import nephoscope


def image(low=0.0, high=0.8, hidden=False):
    grid = vtkImageData()
    grid.SetDimensions(5, 6, 7)
    values = numpy_to_vtk(np.linspace(low, high, 210), deep=True)
    values.SetName("cloud")
    grid.GetPointData().SetScalars(values)
    if hidden:
        ghosts = numpy_to_vtk(np.full(210, 2, np.uint8), deep=True)
        ghosts.SetName("vtkGhostType")
        grid.GetPointData().AddArray(ghosts)
    return grid


def told(made, data, values, pieces=(1,)):
    made.SetInputDataObject(data)
    made.SetInputArrayToProcess(0, 0, 0, 0, "cloud")
    made.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        made.SetValue(i, value)
    with Messages() as messages:
        for piece in range(pieces[0]):
            made.UpdatePiece(piece, pieces[0], 0)
    return messages.all


class Surface(unittest.TestCase):
    def test_values_outside(self):
        for values, text in (([0.9], "contour value is 0.9"), ([-3.0, -1.0], "contour values are -3 to -1")):
            messages = told(nephoscope.vtkCloudSurface(), image(), values)
            self.assertEqual(len(messages), 1, messages)
            self.assertIn("array 'cloud' after smoothing are 0.03", messages[0])
            self.assertIn(text, messages[0])

    def test_smoothed_away(self):
        data = image(0, 0)
        data.GetPointData().GetScalars().SetValue(100, 1.0)
        messages = told(nephoscope.vtkCloudSurface(), data, [0.9])
        self.assertIn("after smoothing", messages[0])
        unsmoothed = nephoscope.vtkCloudSurface()
        unsmoothed.SetNumberOfSmoothingIterations(0)
        self.assertEqual(told(unsmoothed, data, [0.9]), [])

    def test_nothing_to_contour(self):
        self.assertIn("no contour values", told(nephoscope.vtkCloudSurface(), image(), [])[0])
        self.assertIn("210 values", " ".join(told(nephoscope.vtkCloudSurface(), image(np.nan, np.nan), [0.5])))
        self.assertTrue(any("There is no surface" in m for m in told(nephoscope.vtkCloudSurface(), image(hidden=True), [0.5])))

    def test_once_for_all_pieces(self):
        self.assertEqual(len(told(nephoscope.vtkCloudSurface(), image(), [0.9], pieces=(4,))), 1)

    def test_blocks_and_full_results_are_silent(self):
        self.assertEqual(told(nephoscope.vtkCloudSurface(), image(), [0.4]), [])
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, image())
        blocks.SetBlock(1, image(0, 0.1))
        self.assertEqual(told(nephoscope.vtkCloudSurface(), blocks, [0.4]), [])


class Cells(unittest.TestCase):
    def test_told(self):
        for values, text in (([0.9], "0 to 0.8"), ([-1.0, 7.0], "0 to 0.8")):
            messages = told(nephoscope.vtkContourCellSplitter(), image(), values)
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(text, messages[0])

    def test_silent(self):
        self.assertEqual(told(nephoscope.vtkContourCellSplitter(), image(), [0.4, 7.0]), [])
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, image())
        blocks.SetBlock(1, image(0, 0.1))
        self.assertEqual(told(nephoscope.vtkContourCellSplitter(), blocks, [0.4]), [])


if __name__ == "__main__":
    unittest.main()
