# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each bad input gets its own message, which names the array or the point and the remedy; nothing crashes."""
import unittest

import cloud_grids as cg
import nephoscope
import numpy as np
from nephoscope_testing.messages import Messages
from vtkmodules.vtkCommonCore import vtkBitArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStructuredGrid, vtkUnstructuredGrid

FIELD = np.random.default_rng(1).normal(size=(3, 4, 5))


class BadInput(unittest.TestCase):
    def nothing(self, data, text, **settings):
        out = cg.smooth(data, expect=[text], **settings)
        self.assertEqual(out.GetNumberOfPoints(), 0)

    def test_empty(self):
        for data in (vtkImageData(), vtkStructuredGrid()):
            self.nothing(data, "The input is empty")

    def test_not_structured(self):
        with Messages() as messages:
            made = nephoscope.vtkStructuredSmoothing()
            made.SetInputDataObject(vtkUnstructuredGrid())
            made.Update()
        self.assertNotIn("Apply", " ".join(messages.all))  # nothing can be made of no cells
        self.assertIn("The input is an unstructured grid. It must be a grid with rows", " ".join(messages.all))

    def test_missing_arrays(self):
        named = lambda name: {"setup": lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, name)}
        data = cg.image(FIELD)
        self.nothing(data, "There is no point array 'g'. Choose another one. Point arrays: 'f'.", **named("g"))
        self.nothing(data, "no point array 'q'", setup=lambda m: m.AddArrayName("q"))
        data.GetCellData().AddArray(cg.array("c", np.zeros(24)))
        self.nothing(data, "It is on cells: apply Cell Data to Point Data first", **named("c"))
        self.nothing(data, "no point array 'c'", setup=lambda m: m.SetInputArrayToProcess(0, 0, 0, 1, "c"))
        data.GetPointData().SetActiveScalars(None)
        self.nothing(data, "no point array of the active scalars")

    def test_arrays_that_are_not_numbers(self):
        data = cg.image(FIELD)
        text, bits = vtkStringArray(), vtkBitArray()
        for array, name in ((text, "text"), (bits, "bits")):
            array.SetName(name)
            array.SetNumberOfValues(60)
            data.GetPointData().AddArray(array)
        for name in ("text", "bits"):
            self.nothing(data, f"'{name}' of type ", setup=lambda m: m.AddArrayName(name))

    def test_short_arrays(self):
        data = cg.image(FIELD)
        cg.add(data, {"s": np.zeros(7)})
        self.nothing(data, "'s' has 7 values for 60 points")

    def test_masses(self):
        data = cg.image(FIELD)
        self.nothing(data, "no point array 'm' of one component to take masses", Conservative=True, MassArrayName="m")
        mass = np.ones(60)
        mass[[3, 9, 11]] = 0, -2, np.nan
        cg.add(data, {"m": mass})
        data.GetPointData().SetActiveScalars("f")
        out = cg.smooth(data, Conservative=True, MassArrayName="m", expect=["3 points have no mass"])
        np.testing.assert_array_equal(cg.values(out)[[3, 9, 11]], FIELD.ravel()[[3, 9, 11]])
        self.assertTrue(np.isfinite(cg.values(out)).all())

    def test_coordinates(self):
        grid = np.stack(np.meshgrid(np.arange(5.0), np.arange(4.0), np.arange(3.0), indexing="ij"), -1).transpose(2, 1, 0, 3)
        bad = grid.copy()
        bad[1, 2, 3, 0] = np.nan
        self.nothing(cg.structured(bad, {"f": FIELD}), "Point 33 of the grid has a coordinate that is not a finite number")
        self.nothing(cg.rectilinear([0, 1, np.inf, 3, 4], range(4), range(3), {"f": FIELD}), "Axis 0 of the grid")
        flat = cg.structured(0 * grid, {"f": FIELD})
        cg.smooth(flat)
        cg.smooth(flat, Conservative=True, expect=["points have no mass (cells without volume"])
        huge = cg.smooth(cg.structured(1e150 * grid, {"f": FIELD}))
        np.testing.assert_array_equal(cg.values(huge), cg.values(cg.smooth(cg.image(FIELD))))

    def test_huge_values(self):
        out = cg.values(cg.smooth(cg.image(FIELD * 1e29)))
        self.assertTrue(np.isfinite(out).all())

    def test_settings(self):
        made = nephoscope.vtkStructuredSmoothing()
        with Messages() as messages:
            made.SetPeriodic(3, True)
        self.assertIn("the axis is 3; it must be 0, 1 or 2", messages.errors[0])
        self.assertFalse(made.GetPeriodic(3))
        made.SetNumberOfIterations(-4)
        self.assertEqual(made.GetNumberOfIterations(), 0)
        self.assertIn("NumberOfIterations: 0", str(made))

    def test_a_mass_array_that_is_there(self):
        data = cg.image(FIELD)
        cg.add(data, {"Mass": np.ones(60)})
        data.GetPointData().SetActiveScalars("f")
        cg.smooth(data, GenerateMassArray=True, expect=["'Mass' of the input has been replaced"])


if __name__ == "__main__":
    unittest.main()
