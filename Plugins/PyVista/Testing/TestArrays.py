# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays as arguments: masked values are missing, whatever lies below the mask, and numbers may have 16 bits."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from nephoscope._checks import as_array

FILL = 1e20


def cube(size=10):
    return pyvista.ImageData(dimensions=(size, size, size))


def values(count=1000):
    found = np.linspace(0, 1, count)
    found[:100] = FILL
    return np.ma.masked_greater(found, 1e10)


class Arrays(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(self.plotter.close)

    def test_scalars(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for scalars in (values(), values().astype("f4"), values().filled(np.nan), values().filled(np.nan).astype("f2")):
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    mapper = add(self.plotter, cube(), scalars, show_scalar_bar=False).mapper
                np.testing.assert_allclose(mapper.scalar_range, (0.1, 1), rtol=2e-3)
                self.assertEqual(np.isnan(mapper.dataset["Data"]).sum(), 100)
            mapper = add(self.plotter, cube(), np.ma.masked_less(np.arange(1000), 500), show_scalar_bar=False).mapper
            self.assertEqual(tuple(mapper.scalar_range), (500, 999))
            self.assertEqual(add(self.plotter, cube(), np.ma.arange(729), show_scalar_bar=False).mapper.dataset.cell_data["Data"].dtype.kind, "i")
            for precision in ("f2", np.longdouble):
                self.assertAlmostEqual(add(self.plotter, cube(), np.linspace(0, 1, 1000).astype(precision), show_scalar_bar=False).mapper.scalar_range[1], 1)
            with self.assertRaisesRegex(ValueError, "no finite value"):
                add(self.plotter, cube(), np.ma.masked_all(1000))

    def test_what_is_masked_is_not_drawn(self):
        def picture(scalars):
            plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
            nephoscope.add_cells(plotter, cube(), scalars, opacity=1.0, clim=(0, 1), show_scalar_bar=False)
            found = plotter.screenshot(return_img=True)
            plotter.close()
            return found
        half = np.ones(1000)
        half[500:] = FILL
        np.testing.assert_array_equal(picture(np.ma.masked_greater(half, 2)), picture(np.where(half > 2, np.nan, half)))
        self.assertGreater(np.abs(picture(np.ma.masked_greater(half, 2)).astype(int) - picture(half)).max(), 50)

    def test_arrays_of_three_dimensions_are_images(self):
        for array in (values().reshape(10, 10, 10), values().reshape(10, 10, 10).astype("f4")):
            mapper = nephoscope.add_cells(self.plotter, array).mapper
            np.testing.assert_allclose(mapper.scalar_range, (0.1, 1), rtol=2e-3)
        nephoscope.add_cells(self.plotter, np.random.default_rng(0).random((5, 5, 5)).astype("f2"))

    def test_cloud_texture(self):
        sphere = pyvista.Sphere()
        heights = np.ma.masked_less(sphere.points[:, 2].astype("f8"), 0)
        heights.data[heights.mask] = FILL
        actor = nephoscope.add_cloud_texture(self.plotter, sphere, heights)
        self.assertLess(actor.mapper.scalar_range[1], 1)
        nephoscope.add_cloud_texture(self.plotter, sphere, sphere.points[:, 2].astype("f2"))

    def test_masked_numbers_are_refused(self):
        masked = np.ma.masked_equal([0.2, 0.5, FILL], FILL)
        grid = cube()
        grid["T"] = np.linspace(0, 1, 1000)
        for call in (lambda: nephoscope.add_cells(self.plotter, grid, "T", contours=masked), lambda: nephoscope.split_cells(grid, masked, "T"),
                     lambda: nephoscope.add_cells(self.plotter, grid, "T", opacity=np.ma.masked_equal([0.2, 0.5, 0.7], 0.5))):
            with self.assertRaises(ValueError):
                call()

    def test_conversion(self):
        self.assertIs(type(as_array(values())), np.ndarray)
        self.assertEqual(as_array(np.arange(3)).dtype.kind, "i")
        self.assertEqual(as_array(np.ma.array([1, 2], mask=False)).dtype.kind, "i")
        self.assertEqual(as_array(["a"]).dtype.kind, "U")


if __name__ == "__main__":
    unittest.main()
