# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes without arrays, and `color` in place of scalars: media of one colour through which one sees, whatever the mesh is."""
import unittest

import nephoscope
import numpy as np
import pyvista
from nephoscope._uniform import concentration
from pyvista import examples

RANDOM = np.random.default_rng(1)
CUBE, BALL = RANDOM.random((2000, 3)), RANDOM.normal(size=(2000, 3))
HELPERS = pyvista.Sphere()  # has normals only


class UniformMedia(unittest.TestCase):
    def picture(self, add, mesh, background="white", **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 200))
        self.addCleanup(plotter.close)
        plotter.set_background(background)
        self.volume = add(plotter, mesh, **options)
        self.assertFalse(plotter.scalar_bars)
        picture = plotter.screenshot(return_img=True).astype(float)[..., :3]
        return picture / 255

    def check_visible(self, picture, color, background):
        """Colours between the background and `color`: neither faint nor an opaque blob."""
        there, empty = np.array(pyvista.Color(color).float_rgb), np.array(pyvista.Color(background).float_rgb)
        way = there - empty
        share = (picture - empty) @ way / (way @ way)
        np.testing.assert_allclose(picture, empty + share[..., None] * way, atol=0.02)
        seen = share[share > 0.03]
        self.assertGreater(len(seen), 1000)
        self.assertGreater(np.percentile(seen, 98), 0.4)
        self.assertLess((seen > 0.95).mean(), 0.1)
        self.assertGreater(np.std(seen), 0.08)

    def test_points(self):
        for points in (CUBE, BALL, pyvista.PolyData(CUBE), 1e6 * CUBE + 3e7):
            self.check_visible(self.picture(nephoscope.add_splats, points), "steelblue", "white")
            self.check_visible(self.picture(nephoscope.add_splats, points, color="tomato", background="black"), "tomato", "black")

    def test_cells(self):
        for grid in (examples.load_tetbeam(), examples.load_hexbeam(), pyvista.ImageData(dimensions=(9, 9, 9)), pyvista.ImageData(dimensions=(30, 30, 30), spacing=(1e5,) * 3)):
            grid.clear_data()
            self.check_visible(self.picture(nephoscope.add_cells, grid), "steelblue", "white")
            self.check_visible(self.picture(nephoscope.add_cells, grid, color="red"), "red", "white")

    def test_blocks(self):
        left, right = pyvista.ImageData(dimensions=(5, 5, 5)), pyvista.ImageData(dimensions=(5, 5, 5), origin=(4, 0, 0))
        self.check_visible(self.picture(nephoscope.add_cells, pyvista.MultiBlock([left, right]), color="red"), "red", "white")
        right["only here"] = np.arange(125.0)
        self.check_visible(self.picture(nephoscope.add_cells, pyvista.MultiBlock([left, right]), color="red"), "red", "white")

    def test_color_with_scalars_sets_the_opacity_only(self):
        grid = pyvista.ImageData(dimensions=(9, 9, 9))
        grid["x"] = grid.points[:, 0]
        self.picture(nephoscope.add_cells, grid, scalars="x", color="red")
        self.assertEqual(self.volume.mapper.scalar_range, (0, 8))
        np.testing.assert_array_equal(np.unique(self.volume.mapper.lookup_table.values[:, :3], axis=0), [[255, 0, 0]])
        self.picture(nephoscope.add_cells, grid, color="red")  # uniform, as of splats
        self.assertEqual(self.volume.mapper.scalar_range, (0, 1))

    def test_helpers_are_no_scalars(self):
        self.check_visible(self.picture(nephoscope.add_splats, HELPERS, color="red"), "red", "white")
        self.picture(nephoscope.add_splats, HELPERS)
        self.assertNotIn("Data", HELPERS.array_names)
        grid = pyvista.ImageData(dimensions=(9, 9, 9)).cast_to_unstructured_grid().extract_cells(range(400))  # has VTK's ids
        self.check_visible(self.picture(nephoscope.add_cells, grid, color="red"), "red", "white")
        self.picture(nephoscope.add_cells, grid)
        self.assertEqual(self.volume.mapper.dataset.cell_data.keys(), [*grid.cell_data.keys(), "Data"])

    def test_coordinates_alone_are_scalars(self):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        grid = pyvista.ImageData(dimensions=(5, 5, 5))
        grid["level"] = grid.points[:, 2]
        self.assertEqual(nephoscope.add_cells(plotter, grid).mapper.scalar_range, (0, 4))

    def test_vectors_alone_are_drawn_by_their_magnitude(self):
        grid = pyvista.ImageData(dimensions=(3, 3, 3))
        grid["v"] = grid.points
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        self.assertAlmostEqual(nephoscope.add_cells(plotter, grid).mapper.scalar_range[1], 12 ** 0.5, 5)
        self.assertEqual(list(plotter.scalar_bars.keys()), ["v magnitude"])

    def test_unit_distance_is_taken(self):
        self.picture(nephoscope.add_cells, examples.load_tetbeam(), color="red", opacity_unit_distance=0.7)
        self.assertEqual(self.volume.prop.opacity_unit_distance, 0.7)

    def test_opacities_of_an_array_are_as_without_color(self):
        grid = pyvista.ImageData(dimensions=(9, 9, 9))
        grid["x"] = grid.points[:, 0]
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            self.picture(add, grid, color="red", opacity_scalars="x")
            distance = self.volume.prop.opacity_unit_distance
            self.picture(add, grid, scalars="x", color="red")
            self.assertAlmostEqual(self.volume.prop.opacity_unit_distance, distance)

    def test_color_and_sun(self):
        with self.assertRaisesRegex(ValueError, "color and sun"):
            nephoscope.add_cells(pyvista.Plotter(off_screen=True), examples.load_tetbeam(), color="red", sun=(0, 0, 1))

    def test_theme(self):
        plotter = pyvista.Plotter(off_screen=True, theme=pyvista.themes.DarkTheme())
        self.addCleanup(plotter.close)
        volume = nephoscope.add_splats(plotter, CUBE)
        self.assertEqual(tuple(volume.mapper.lookup_table.values[0, :3]), plotter.theme.color.int_rgb)

    def test_concentration(self):
        self.assertAlmostEqual(concentration(CUBE), 1, delta=0.1)
        self.assertAlmostEqual(concentration(BALL), np.prod(np.ptp(BALL, axis=0)[:2]) / (4 * np.pi), delta=1)
        for few in (CUBE[:5], np.full((200, 3), np.nan), np.zeros((200, 3)), CUBE * (1, 0, 0)):
            self.assertEqual(concentration(few), 1)


if __name__ == "__main__":
    unittest.main()
