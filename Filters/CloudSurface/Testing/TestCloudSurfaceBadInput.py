# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each bad input gets its own message, which names the array or the axis and the remedy; nothing crashes."""
import unittest

import cloud_grids as cg
import nephoscope
import numpy as np
from nephoscope_testing.messages import Messages
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkResampleToImage

FIELD = np.random.default_rng(1).normal(size=(3, 4, 5))


class BadInput(unittest.TestCase):
    def nothing(self, data, text, values=(0.1,), **settings):
        out = cg.surface(data, list(values), expect=[text], **settings)
        self.assertEqual((out.GetNumberOfPoints(), out.GetNumberOfCells()), (0, 0))

    def test_empty(self):
        self.nothing(vtkImageData(), "The input is empty")

    def test_not_structured(self):
        with Messages() as messages:
            made = nephoscope.vtkCloudSurface()
            made.SetInputDataObject(vtkPolyData())
            made.Update()
        self.assertIn("The input is a surface or points. It must be a grid with rows", " ".join(messages.all))

    def test_unstructured(self):
        """The message names a filter, and with it there is a surface."""
        cells = vtkAppendFilter()
        cells.AddInputData(cg.image(FIELD))
        cells.Update()
        with Messages() as messages:
            made = nephoscope.vtkCloudSurface()
            made.SetInputDataObject(cells.GetOutput())
            made.Update()
        self.assertEqual(len(messages.all), 1)
        self.assertIn("The input is an unstructured grid. It must be a grid with rows: an image, a rectilinear or a structured grid. Apply vtkResampleToImage first.", messages.all[0])
        image = vtkResampleToImage()
        image.SetInputDataObject(cells.GetOutput())
        image.SetSamplingDimensions(9, 9, 9)
        image.Update()
        surface = cg.surface(image.GetOutput(), [float(FIELD.mean())], setup=lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, "f"))
        self.assertGreater(surface.GetNumberOfCells(), 0)

    def test_flat(self):
        self.nothing(cg.image(FIELD[:1]), "one point along axis 2")
        self.nothing(cg.image(FIELD[:, :, :1]), "one point along axis 0")

    def test_arrays(self):
        named = lambda name: {"setup": lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, name)}
        data = cg.image(FIELD)
        self.nothing(data, "There is no point array 'g'. Choose another one. Point arrays: 'f'.", **named("g"))
        data.GetCellData().AddArray(cg.array("c", np.zeros(24)))
        self.nothing(data, "It is on cells: apply Cell Data to Point Data first", **named("c"))
        cg.add(data, {"v": np.zeros((60, 3))})
        cg.add(data, {"short": np.zeros(7)})
        data.GetPointData().SetActiveScalars("f")
        self.nothing(data, "'v' has 3 components; one number at each point is needed", **named("v"))
        self.nothing(data, "'short' has 7 values for 60 points", **named("short"))
        text = vtkStringArray()
        text.SetName("text")
        text.SetNumberOfValues(60)
        data.GetPointData().AddArray(text)
        self.nothing(data, "'text' of type string", **named("text"))
        out = cg.surface(data, [0.1])  # the short array is left out, the others do no harm
        self.assertGreater(out.GetNumberOfCells(), 10)
        self.assertFalse(out.GetPointData().HasArray("short"))

    def test_values(self):
        self.nothing(cg.image(FIELD), "Contour value 1 is nan; it must be a finite number", values=(0.1, np.nan))
        self.nothing(cg.image(FIELD), "Contour value 0 is inf", values=(np.inf,))

    def test_missing_everywhere(self):
        self.nothing(cg.image(FIELD * np.nan), "60 values of the array 'f' are not finite")

    def test_huge_coordinates_and_values(self):
        out = cg.surface(cg.image(FIELD, (1e20,) * 3), [0.1], 1)
        self.assertTrue(np.isfinite(cg.points(out)).all())
        np.testing.assert_allclose(np.linalg.norm(cg.values(out, "Normals"), axis=1), 1, atol=1e-6)
        np.testing.assert_allclose(cg.points(out) / 1e20, cg.points(cg.surface(cg.image(FIELD), [0.1], 1)), atol=1e-6)
        out = cg.surface(cg.image(FIELD * 1e25), [1e24], 1)
        np.testing.assert_allclose(np.linalg.norm(cg.values(out, "Normals"), axis=1), 1, atol=1e-6)

    def test_a_grid_without_volume(self):
        grid = np.zeros(FIELD.shape + (3,))
        out = cg.surface(cg.structured(grid, {"f": FIELD}), [0.1])
        self.assertTrue(np.isfinite(cg.values(out, "Normals")).all() if out.GetNumberOfPoints() else True)

    def test_bad_axis(self):
        with Messages() as messages:
            nephoscope.vtkCloudSurface().SetPeriodic(-1, True)
        self.assertIn("it must be 0, 1 or 2", messages.errors[0])


if __name__ == "__main__":
    unittest.main()
