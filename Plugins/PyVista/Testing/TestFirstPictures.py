# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""First pictures with nothing set: seen whatever the size, thickness and resolution of the data, and whatever a field is called."""
import unittest

import nephoscope
import numpy as np
import pyvista

BOTH = (nephoscope.add_cells, nephoscope.add_splats)


def field(places):
    x, y, z = places.T
    return np.exp(-8 * ((x - 0.5) ** 2 + (y - 0.4) ** 2 + (z - 0.6) ** 2)) + 0.3 * np.sin(6 * x)


def box(shape, size=(1.0, 1.0, 1.0), name="values", values=field):
    """An image of as many cells, with a cell array."""
    grid = pyvista.ImageData(dimensions=[n + 1 for n in shape], spacing=[s / n for s, n in zip(size, shape)])
    grid.cell_data[name] = values(grid.cell_centers().points / size)
    return grid


def picture(add, grid, **options):
    """On black, from where a box of size 1 fills the picture."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(120, 120), theme=pyvista.themes.DarkTheme())
    try:
        plotter.set_background("black")
        add(plotter, grid, show_scalar_bar=False, **options)
        middle = np.array(grid.center)
        plotter.camera_position = [middle + grid.length * np.array((0.9, 1.1, 0.9)), middle, (0, 0, 1)]
        plotter.renderer.ResetCameraClippingRange()
        return plotter.screenshot(return_img=True).astype(float)
    finally:
        plotter.close()


def light(image):
    """Mean of the brightest channel where anything is seen."""
    brightest = image.max(axis=2)
    return brightest[brightest > 4].mean() if (brightest > 4).mean() > 0.02 else 0.0


class SameForAll(unittest.TestCase):
    def test_resolution(self):
        for add in BOTH:
            for name in ("values", "cloud_fraction"):
                coarse, fine = (picture(add, box((n, n, n), name=name)) for n in (20, 48))
                inside = (slice(40, 80), slice(40, 80))  # splats end half a cell outside the grid
                difference = np.abs(coarse - fine)[inside if add is nephoscope.add_splats else slice(None)]
                self.assertLess(difference.max(), 6, (add.__name__, name))
                self.assertGreater(light(fine), 50, (add.__name__, name))

    def test_unit_of_length(self):
        for add in BOTH:
            pictures = [picture(add, box((8, 8, 8), (scale,) * 3)) for scale in (1e-3, 1.0, 1e6)]
            for other in pictures[1:]:
                self.assertLess(np.abs(other - pictures[0]).max(), 6, add.__name__)

    def test_kinds_of_grids(self):
        grid = box((8, 8, 8))
        first = picture(nephoscope.add_cells, grid)
        for other in (grid.cast_to_structured_grid(), grid.cast_to_unstructured_grid(), grid.cast_to_rectilinear_grid()):
            self.assertLess(np.abs(picture(nephoscope.add_cells, other) - first).max(), 4)


class Thin(unittest.TestCase):
    def test_one_and_three_layers(self):
        for add in BOTH:
            for layers in (1, 3):
                for name in ("values", "cloud_fraction"):
                    grid = box((60, 60, layers), (60.0, 60.0, float(layers)), name=name)
                    self.assertGreater(light(picture(add, grid)), 50, (add.__name__, layers, name))

    def test_thickness_does_not_change_a_layer(self):
        """Seen along its short axis, a layer of half the thickness looks the same."""
        pictures = []
        for depth in (0.02, 0.01):
            plotter = pyvista.Plotter(off_screen=True, window_size=(80, 80))
            nephoscope.add_cells(plotter, box((20, 20, 2), (1.0, 1.0, depth), values=lambda p: field(p * (1, 1, 0))), show_scalar_bar=False)
            plotter.view_xy()
            plotter.enable_parallel_projection()
            pictures.append(plotter.screenshot(return_img=True).astype(float))
            plotter.close()
        self.assertLess(np.abs(pictures[0] - pictures[1]).max(), 6)


class OneValue(unittest.TestCase):
    def test_uniform_medium(self):
        for add in BOTH:
            for value in (0.0, -5.0, 101325.0, 1e300, True):
                grid = box((4, 4, 4), values=lambda places: np.full(len(places), value))
                self.assertGreater(light(picture(add, grid)), 40, (add.__name__, value))


class Streaks(unittest.TestCase):
    """In a medium both can be read."""

    def whirl(self, n):
        grid = pyvista.ImageData(dimensions=(n, n, n), spacing=(2 / (n - 1),) * 3, origin=(-1, -1, -1))
        x, y, z = grid.points.T
        grid["v"] = np.c_[-y, x, 0.3 * np.cos(3 * z)]
        grid["s"] = np.exp(-3 * (x ** 2 + y ** 2 + z ** 2))
        grid.set_active_scalars("s")
        return grid

    def mapper(self, n, theme=None, **options):
        plotter = pyvista.Plotter(off_screen=True, theme=theme)
        self.addCleanup(plotter.close)
        return nephoscope.add_splats(plotter, self.whirl(n), "s", **{"vectors": "v", "show_scalar_bar": False, **options}).mapper

    def test_medium_is_seen(self):
        for n in (12, 28):
            grid = self.whirl(n)
            bare, with_streaks = picture(nephoscope.add_splats, grid), picture(nephoscope.add_splats, grid, vectors="v")
            change = np.abs(with_streaks - bare).max(axis=2)
            self.assertGreater((change > 30).mean(), 0.01, f"{n}: no streaks")
            middle = change[45:75, 45:75]
            self.assertLess((middle > 100).mean(), 0.4, f"{n}: the medium is buried")

    def test_fewer_where_there_are_many_samples(self):
        self.assertGreater(self.mapper(8).GetVectorShare(), 0.9)
        self.assertLess(self.mapper(32).GetVectorShare(), 0.2)
        self.assertEqual(self.mapper(32, vectors=dict(array="v", fraction=1, opacity=3)).GetVectorShare(), 1)
        self.assertEqual(self.mapper(32, vectors=dict(array="v", fraction=1, opacity=3)).GetVectorOpacity(), 3)
        alone = self.mapper(32, opacity=0)
        self.assertEqual((alone.GetVectorShare(), alone.GetVectorOpacity(), alone.GetUseVectorColor()), (self.mapper(32).GetVectorShare(), 2, False))
        self.assertEqual(self.mapper(32, opacity=0, vectors=dict(array="v", style="segments")).GetVectorShare(), 1)

    def test_colour_stands_out(self):
        for theme, cmap in ((None, "viridis"), (pyvista.themes.DarkTheme(), ["white", "white"]), (None, ["black", "black"])):
            mapper = self.mapper(8, theme, cmap=cmap)
            background = np.array((theme or pyvista.themes.Theme()).background.float_rgb)
            colours = [background, np.asarray(mapper.lookup_table.values)[:, :3].mean(axis=0) / 255]
            self.assertGreater(np.linalg.norm(np.array(mapper.GetVectorColor()) - colours, axis=1).min(), 0.6)
        self.assertEqual(self.mapper(8, vectors=dict(array="v", color="blue")).GetVectorColor(), (0, 0, 1))


class Tuned(unittest.TestCase):
    def test_opacity_still_counts(self):
        """Half the opacity is half as thick, also where the length follows the data."""
        for add in BOTH:
            volumes = [add(pyvista.Plotter(off_screen=True), box((4, 4, 4)), opacity=[0, top], show_scalar_bar=False) for top in (1.0, 0.5)]
            distances = [volume.prop.opacity_unit_distance for volume in volumes]
            self.assertAlmostEqual(distances[0], distances[1], 6)

    def test_round_bodies(self):
        """A ball in its box: its silhouette is not the box's."""
        ball = pyvista.SolidSphere(outer_radius=1.0, radius_resolution=6, theta_resolution=24, phi_resolution=16)
        ball.point_data["values"] = np.ones(ball.n_points)
        volume = nephoscope.add_cells(pyvista.Plotter(off_screen=True), ball, "values", opacity=1.0, show_scalar_bar=False)
        self.assertAlmostEqual(volume.prop.opacity_unit_distance, 4 / 3 / 2, delta=0.05)


if __name__ == "__main__":
    unittest.main()
