# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What pickers find, as the table in Documentation/cell-compositing.md says."""
import unittest

import nephoscope
import numpy as np
import pyvista
from vtkmodules.vtkRenderingCore import vtkCellPicker, vtkHardwarePicker, vtkPicker, vtkPropPicker


class Pickers(unittest.TestCase):
    def picked(self, add, picker):
        """Whether the middle of the picture is what `add` has added, or the wall behind it."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        wall = plotter.add_mesh(pyvista.Plane(center=(0, 0, -3), i_size=20, j_size=20))
        added = add(plotter)
        plotter.view_xy()
        plotter.show(auto_close=False)
        self.assertEqual(picker.Pick(30, 30, 0, plotter.renderer), 1)
        return {id(wall): "wall", id(added): "added"}[id(picker.GetViewProp())]

    def test_pickers(self):
        grid = pyvista.ImageData(dimensions=(5, 5, 5), spacing=(0.5,) * 3, origin=(-1,) * 3)
        grid["a"] = np.ones(grid.n_points)
        volumes = {"cells": lambda p: nephoscope.add_cells(p, grid), "splats": lambda p: nephoscope.add_splats(p, grid)}
        clouds = lambda p: nephoscope.add_cloud_texture(p, pyvista.Sphere(), coverage=1)  # noqa: E731
        for name, add in volumes.items():
            with self.subTest(name):
                self.assertEqual([self.picked(add, picker()) for picker in (vtkCellPicker, vtkPropPicker, vtkHardwarePicker)], ["added", "wall", "wall"])
        for grid in (grid.cast_to_unstructured_grid(), grid.cast_to_structured_grid()):
            for name, add in {"cells": lambda p: nephoscope.add_cells(p, grid), "splats": lambda p: nephoscope.add_splats(p, grid)}.items():
                with self.subTest(f"{name} of {type(grid).__name__}"):
                    self.assertEqual([self.picked(add, picker()) for picker in (vtkPicker, vtkCellPicker, vtkPropPicker, vtkHardwarePicker)], ["added", "wall", "wall", "wall"])
        self.assertEqual([self.picked(clouds, picker()) for picker in (vtkCellPicker, vtkPropPicker, vtkHardwarePicker)], ["added"] * 3)


if __name__ == "__main__":
    unittest.main()
