# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What pickers find, as the table in Documentation/cell-compositing.md says."""
import unittest
import warnings

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


class Picked(unittest.TestCase):
    """`Pick` of the mapper, before and after a picture."""

    def volume(self, **options):
        grid = pyvista.ImageData(dimensions=(5, 5, 5))
        grid["a"] = np.ones(grid.n_points)
        self.plotter = pyvista.Plotter(window_size=(60, 60), **options)
        self.addCleanup(self.plotter.close)
        return nephoscope.add_cells(self.plotter, grid)

    def test_off_screen_plotters_draw_first(self):
        mapper = self.volume(off_screen=True).mapper
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertTrue(mapper.Pick(self.plotter.renderer, 30, 30))
        first = mapper.GetPickPosition()
        self.plotter.screenshot(return_img=False)
        self.assertTrue(mapper.Pick(self.plotter.renderer, 30, 30))
        self.assertEqual(mapper.GetPickPosition(), first)

    def test_windows_and_closed_plotters_say_what_to_call(self):
        mapper = self.volume(off_screen=False).mapper
        words = r"plotter.show\(auto_close=False\)"
        with self.assertWarnsRegex(RuntimeWarning, words):
            self.assertFalse(mapper.Pick(self.plotter.renderer, 30, 30))
        mapper = self.volume(off_screen=True).mapper
        renderer = self.plotter.renderer
        self.plotter.show()
        with self.assertWarnsRegex(RuntimeWarning, words):
            self.assertFalse(mapper.Pick(renderer, 30, 30))


if __name__ == "__main__":
    unittest.main()
