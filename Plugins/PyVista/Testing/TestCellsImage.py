# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of nephoscope.add_cells in a plotter against closed forms: transparency exp(-extinction * length)."""
import os
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])


def cube(n=4, origin=(0, 0, 0), size=1.0):
    step = size / (n - 1)
    grid = pyvista.ImageData(dimensions=(n, n, n), spacing=(step,) * 3, origin=origin)
    grid.point_data["one"] = np.ones(grid.n_points)
    grid.point_data["z"] = grid.points[:, 2]
    return grid


class Picture(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
        self.plotter.background_color = "black"
        self.addCleanup(self.plotter.close)

    def add(self, grid, scalars="one", **options):
        options = {"cmap": ["white", "white"], "opacity": 1.0, "opacity_unit_distance": 0.5, "show_scalar_bar": False, **options}
        return nephoscope.add_cells(self.plotter, grid, scalars, **options)

    def screenshot(self):
        """The picture along z in parallel projection, float, shape (120, 160, 3), in 0 to 1."""
        self.plotter.enable_parallel_projection()
        self.plotter.view_xy()
        image = self.plotter.screenshot(str(OUTPUT / f"TestCellsImage-{self._testMethodName}.png"))
        return image.astype(float)[..., :3] / 255

    def middle(self):
        return self.screenshot()[55:65, 75:85].reshape(-1, 3)

    def expect(self, value):
        middle = self.middle()
        np.testing.assert_allclose(middle, np.broadcast_to(value, middle.shape), atol=1.5 / 255)

    def test_opacity_1_over_2_unit_distances(self):
        self.add(cube())
        self.expect(1 - np.exp(-2))
        self.assertEqual(self.screenshot()[2, 2].max(), 0)  # the corner is beside the cube

    def test_opacity_scale(self):
        self.add(cube(), opacity_scale=0.25)
        self.expect(1 - np.exp(-0.5))

    def test_any_greater_opacity_scale_is_opaque(self):
        for scale in (1e9, 1e19, 1e30, 1e300):
            self.plotter.clear()
            self.add(cube(), opacity_scale=scale)
            self.expect(1)

    def test_linear_opacity_has_the_mean(self):
        self.add(cube(), "z", opacity="linear", clim=(0, 1))
        self.expect(1 - np.exp(-1))

    def test_logarithmic_opacity(self):
        grid = cube()
        grid.point_data["decades"] = np.full(grid.n_points, 1e-2)
        self.add(grid, "decades", opacity="linear", clim=(1e-4, 1), log_scale=True)
        self.expect(1 - np.exp(-1))  # half way in the logarithm: opacity 0.5

    def test_cell_scalars(self):
        grid = cube()
        grid.cell_data["slab"] = (grid.cell_centers().points[:, 2] > 1 / 3).astype(float)
        self.add(grid, "slab", opacity="linear", clim=(0, 1))
        self.expect(1 - np.exp(-4 / 3))

    def test_opacity_of_another_array(self):
        grid = cube()
        grid.cell_data["slab"] = (grid.cell_centers().points[:, 2] > 1 / 3).astype(float)
        self.add(grid, "z", opacity_scalars="slab", opacity="linear")
        self.expect(1 - np.exp(-4 / 3))

    def test_colour_in_front_of_colour(self):
        # blue over red, each of optical depth 1, seen from +z
        grid = cube(3)
        grid.cell_data["half"] = (grid.cell_centers().points[:, 2] > 0.5).astype(float)
        for order in ("exact", "centroid"):
            self.add(grid, "half", cmap=["red", "blue"], clim=(0, 1), order=order, name="halves")
            front = 1 - np.exp(-1)
            self.expect((front * np.exp(-1), 0, front))

    def test_blocks_are_one_volume(self):
        blocks = pyvista.MultiBlock([cube(3, size=0.5, origin=(x, y, z)) for x in (0, 0.5) for y in (0, 0.5) for z in (0, 0.5)])
        self.add(blocks)
        self.expect(1 - np.exp(-2))

    def test_blocks_are_ordered_among_each_other(self):
        blocks = pyvista.MultiBlock()
        for level in (0.5, 0.0, 0.75, 0.25):  # layers, not in their order
            layer = pyvista.ImageData(dimensions=(5, 5, 2), spacing=(0.25,) * 3, origin=(0, 0, level))
            layer.cell_data["upper"] = np.full(layer.n_cells, float(level >= 0.5))
            blocks.append(layer)
        volume = self.add(blocks, "upper", cmap=["red", "blue"], clim=(0, 1))
        front = 1 - np.exp(-1)
        self.expect((front * np.exp(-1), 0, front))
        self.assertEqual(volume.mapper.GetNumberOfVisibilityCycles(), 0)

    def test_user_matrix_scales_the_length(self):
        self.add(cube(), user_matrix=np.diag([1, 1, 2, 1]))
        self.expect(1 - np.exp(-4))

    def test_opaque_mesh_ends_the_ray(self):
        self.add(cube())
        self.plotter.add_mesh(pyvista.Plane(center=(0.5, 0.5, 0.75)), color="black", lighting=False)
        self.expect(1 - np.exp(-0.5))

    def test_values_changed_in_place_are_drawn(self):
        grid = cube()
        self.add(grid, opacity="linear", clim=(0, 1))
        self.expect(1 - np.exp(-2))
        grid.point_data["one"][:] = 0.5
        self.expect(1 - np.exp(-1))

    def test_second_view(self):
        self.plotter.close()
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120), shape=(1, 2))
        self.plotter.background_color = "black"
        self.plotter.subplot(0, 1)
        self.add(cube())
        image = self.screenshot()
        np.testing.assert_allclose(image[60, 120], 1 - np.exp(-2), atol=1.5 / 255)
        self.assertEqual(image[60, 40].max(), 0)


class Translucent(unittest.TestCase):
    """A red sheet of opacity 1/2 in the middle of a white cube of optical depth 2, with nothing set: the closed form, in the default theme."""

    def setUp(self):
        half = 1 - np.exp(-1)
        self.sheet_in_the_middle = half + (1 - half) * (0.5 * np.array([1, 0, 0]) + 0.5 * half)
        self.cube_over_the_sheet = 1 - np.exp(-2) + np.exp(-2) * 0.5 * np.array([1, 0, 0])

    def plotter_with(self, *parts, shape=(1, 1)):
        plotter = pyvista.Plotter(off_screen=True, window_size=(80 * shape[1], 80), shape=shape)
        self.addCleanup(plotter.close)
        plotter.background_color = "black"
        for part in parts:
            part(plotter)
        return plotter

    @staticmethod
    def cells(plotter, add=nephoscope.add_cells):
        add(plotter, cube(9), "one", cmap=["white", "white"], opacity=1.0, opacity_unit_distance=0.5, show_scalar_bar=False)

    @staticmethod
    def sheet(plotter):
        return plotter.add_mesh(pyvista.Plane(center=(0.5, 0.5, 0.5), i_size=3, j_size=3), color="red", opacity=0.5, lighting=False)

    @staticmethod
    def splats(plotter):
        Translucent.cells(plotter, nephoscope.add_splats)

    def middle(self, plotter, column=40):
        plotter.enable_parallel_projection()
        plotter.view_xy()
        return plotter.screenshot()[36:44, column - 4:column + 4, :3].mean(axis=(0, 1)) / 255

    def test_orders_of_adding(self):
        for medium, tolerance in ((self.cells, 0.02), (self.splats, 0.06)):
            for parts in ((medium, self.sheet), (self.sheet, medium)):
                with self.subTest(parts), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    np.testing.assert_allclose(self.middle(self.plotter_with(*parts)), self.sheet_in_the_middle, atol=tolerance)

    def test_meshes_that_become_translucent(self):
        plotter = self.plotter_with(self.cells)
        actor = self.sheet(plotter)
        actor.prop.opacity = 1
        plotter.view_xy()
        plotter.screenshot()
        self.assertFalse(plotter.renderer.GetUseDepthPeeling())
        actor.prop.opacity = 0.5
        np.testing.assert_allclose(self.middle(plotter), self.sheet_in_the_middle, atol=0.02)

    def test_views_beside_each_other(self):
        plotter = self.plotter_with(shape=(1, 2))
        for column in (0, 1):
            plotter.subplot(0, column)
            self.cells(plotter)
        self.sheet(plotter)
        np.testing.assert_allclose(self.middle(plotter, 120), self.sheet_in_the_middle, atol=0.02)
        self.assertEqual([renderer.GetUseDepthPeeling() for renderer in plotter.renderers], [0, 1])

    def test_what_was_turned_off_stays_off(self):
        plotter = self.plotter_with(self.cells, self.sheet)
        self.middle(plotter)
        plotter.renderer.UseDepthPeelingForVolumesOff()
        with self.assertWarnsRegex(RuntimeWarning, "UseDepthPeelingForVolumesOn"):
            np.testing.assert_allclose(self.middle(plotter), self.cube_over_the_sheet, atol=0.02)

    def test_without_volumes_nothing_changes(self):
        plotter = self.plotter_with(self.sheet)
        plotter.screenshot()
        self.assertFalse(plotter.renderer.GetUseDepthPeeling())


class Media(unittest.TestCase):
    """Two media whose rays pass beside their pixels by different ways: each where it needs to."""

    def meshes(self):
        clear = pyvista.ImageData(dimensions=(48, 48, 24), spacing=(4 / 47, 4 / 47, 1.2 / 23), origin=(-2, -2, 0.6))
        x, y, z = clear.points.T
        clear["cloud"] = np.exp(-4 * ((x - 0.6)**2 + (y + 0.3)**2) - 12 * (z - 1.2)**2).clip(0.05) - 0.05
        along = np.linspace(-2, 2, 40)
        x, y, level = np.meshgrid(along, along, np.linspace(0, 1, 20), indexing="ij")
        hill = 0.9 * np.exp(-2.2 * (x**2 + y**2))
        curved = pyvista.StructuredGrid(x, y, hill + level * (2.2 - hill))
        x, y, z = curved.points.T
        curved["gas"] = np.exp(-3 * ((y - 0.15 * x)**2 + (z - 1.1 - 0.12 * x)**2)) * (x > -0.2) * np.exp(-0.4 * np.abs(x))
        return clear, curved

    def picture(self, *meshes):
        plotter = pyvista.Plotter(off_screen=True, window_size=(240, 180))
        self.addCleanup(plotter.close)
        plotter.set_background("#3a5f96")
        for mesh in meshes:
            nephoscope.add_cells(plotter, mesh, cmap="plasma", show_scalar_bar=False)
        plotter.camera_position = [(-5, -6, 3.5), (0, 0, 1), (0, 0, 1)]
        return plotter.screenshot(return_img=True).astype(int)

    def test_no_holes(self):
        clear, curved = self.meshes()
        alone, together = self.picture(curved), self.picture(clear, curved)
        background = np.array([58, 95, 150])
        holes = (np.abs(together - background).max(axis=2) <= 1) & (np.abs(alone - background).max(axis=2) > 25)
        self.assertEqual(holes.sum(), 0)


if __name__ == "__main__":
    unittest.main()
