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
                found = "added" if name == "cells" else "wall"
                self.assertEqual([self.picked(add, picker()) for picker in (vtkCellPicker, vtkPropPicker, vtkHardwarePicker)], ["added", found, found])
        for grid in (grid.cast_to_unstructured_grid(), grid.cast_to_structured_grid()):
            for name, add in {"cells": lambda p: nephoscope.add_cells(p, grid), "splats": lambda p: nephoscope.add_splats(p, grid)}.items():
                with self.subTest(f"{name} of {type(grid).__name__}"):
                    found = "added" if name == "cells" else "wall"
                    self.assertEqual([self.picked(add, picker()) for picker in (vtkPicker, vtkCellPicker, vtkPropPicker, vtkHardwarePicker)], ["added", "wall", found, found])
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


class Clicks(unittest.TestCase):
    """`enable_picking`: two slabs of different scalars, one behind the other, and a wall between them in one half of the picture."""

    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(self.plotter.close)
        slab = pyvista.ImageData(dimensions=(5, 5, 3), origin=(-2, -2, 0))
        for z, value in ((-4, 1.0), (0, 3.0)):
            part = slab.translate((0, 0, z), inplace=False)
            part["a"] = np.full(part.n_points, value)
            actor = nephoscope.add_cells(self.plotter, part, clim=(0, 4), show_scalar_bar=False)
            self.actors = [*getattr(self, "actors", []), actor]
        self.plotter.set_background("black")
        self.plotter.view_xy()
        self.plotter.show(auto_close=False)

    def click(self, x, y):
        self.plotter.iren._mouse_left_button_click(x, y)

    def test_nearest_of_what_is_seen(self):
        seen = []
        nephoscope.enable_picking(self.plotter, seen.append)
        self.click(30, 30)
        self.assertEqual(len(seen), 1)
        self.assertIs(seen[0].actor, self.actors[1])
        self.assertEqual(seen[0].scalar, 3.0)
        self.assertTrue(0 < seen[0].position[2] < 2)
        self.assertIn(seen[0].point, self.actors[1].mapper.dataset.get_cell(seen[0].cell).point_ids)
        self.actors[1].SetVisibility(False)
        self.plotter.render()
        self.click(30, 30)
        self.assertIs(seen[1].actor, self.actors[0])
        self.click(1, 1)  # beside
        self.plotter.add_mesh(pyvista.Plane(center=(0, 0, 5), i_size=9, j_size=9))
        self.plotter.render()
        self.click(30, 30)  # on an opaque surface
        self.assertEqual(len(seen), 2)

    def test_the_window_shows_the_values_by_default(self):
        nephoscope.enable_picking(self.plotter)
        self.click(30, 30)
        self.assertRegex(self.plotter.actors["picked"].GetText(2), r"^3 at \(.*\), cell \d+$")
        self.assertEqual(self.plotter.actors["picked"].GetTextProperty().GetColor(), (1, 1, 1))  # on black

    def test_the_text_is_that_of_the_last_click(self):
        nephoscope.enable_picking(self.plotter)
        self.click(1, 1)  # beside, with no text yet
        self.click(30, 30)
        self.assertIn("picked", self.plotter.actors)
        shown = self.plotter.screenshot().astype(int)
        self.click(1, 1)
        self.assertNotIn("picked", self.plotter.actors)
        self.assertGreater(np.abs(self.plotter.screenshot().astype(int) - shown).max(), 50)

    def test_ends_and_replaces(self):
        first, second = [], []
        nephoscope.disable_picking(self.plotter)  # not enabled
        nephoscope.enable_picking(self.plotter, first.append)
        nephoscope.enable_picking(self.plotter, second.append)
        self.actors[1].SetPickable(False)
        self.click(30, 30)
        self.assertEqual([len(first), len(second)], [0, 1])
        self.assertIs(second[0].actor, self.actors[0])
        nephoscope.disable_picking(self.plotter)
        self.click(30, 30)
        self.assertEqual(len(second), 1)
        nephoscope.enable_picking(self.plotter, second.append)
        self.plotter.close()
        nephoscope.disable_picking(self.plotter)

    def test_a_view_with_splats_only(self):
        """It says what can be picked: once as a warning, and in the window if this shows what is picked."""
        for actor in self.actors:
            nephoscope.add_splats(self.plotter, actor.mapper.dataset, show_scalar_bar=False)
            actor.SetVisibility(False)
        for callback, shown in ((print, False), (None, True)):
            nephoscope.enable_picking(self.plotter, callback)
            with self.assertWarnsRegex(UserWarning, "nothing to pick in this view: a click picks in the visible volumes of add_cells") as told:
                self.click(30, 30)
                self.click(20, 30)
            self.assertEqual([one.filename for one in told.warnings], [__file__])
            self.assertEqual("picked" in self.plotter.actors, shown)
        self.assertIn("volumes of add_cells", " ".join(self.plotter.actors["picked"].GetText(2).split()))
        self.actors[0].SetVisibility(True)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.click(30, 30)
        self.assertRegex(self.plotter.actors["picked"].GetText(2), "^1 at ")

    def test_wrong_arguments(self):
        with self.assertRaisesRegex(TypeError, "plotter is a int"):
            nephoscope.enable_picking(3)
        with self.assertRaisesRegex(TypeError, "callback is a str; it must be a function"):
            nephoscope.enable_picking(self.plotter, "print")
        with self.assertRaisesRegex(ValueError, "side is 'top'"):
            nephoscope.enable_picking(self.plotter, side="top")


if __name__ == "__main__":
    unittest.main()
