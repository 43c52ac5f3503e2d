# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""opacity="extinction": the transmittance is exp(-extinction times length), for every kind of cells, arrays and splats; wrong arrays are named."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

LENGTH, HALF = 200.0, 50.0  # along the line of sight, and across


def box(points=(9, 9, 21)):
    return pyvista.ImageData(dimensions=points, spacing=np.divide((2 * HALF, 2 * HALF, LENGTH), np.subtract(points, 1)), origin=(-HALF, -HALF, 0))


class Extinction(unittest.TestCase):
    def transmittance(self, mesh, *names, add=nephoscope.add_cells, expected_warning=None, **options):
        """That of a black medium before a white background, in the middle of the picture."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(31, 31))
        self.addCleanup(plotter.close)
        plotter.set_background("white")
        plotter.enable_parallel_projection()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            self.volume = add(plotter, mesh, *names, **{"cmap": ["black", "black"], "opacity": "extinction", "show_scalar_bar": False, **options})
            plotter.camera_position = [(0.3, 0.2, 3 * LENGTH), (0.3, 0.2, 0), (0, 1, 0)]
            plotter.camera.parallel_scale = 5
            picture = plotter.screenshot(return_img=True)
        told = [str(one.message) for one in caught]
        self.assertEqual(len(told), 0 if expected_warning is None else 1, told)
        if expected_warning is not None:
            self.assertRegex(told[0], expected_warning)
        return picture[15, 15, 0] / 255

    def test_cells(self):
        """Arrays of points and of cells, grids and unstructured cells."""
        image = box()
        for depth in (0.1, 0.7, 3.0):
            image["k"] = np.full(image.n_points, depth / LENGTH)
            for mesh in (image, image.cast_to_rectilinear_grid(), image.cast_to_unstructured_grid(), image.point_data_to_cell_data()):
                with self.subTest(type(mesh).__name__, depth=depth):
                    self.assertAlmostEqual(self.transmittance(mesh, "k"), np.exp(-depth), delta=0.006)

    def test_varying(self):
        """An extinction that is linear in height, scaled, with colours on a range or on a scale of their own, and coloured by another array."""
        image = box()
        image["Extinction"] = 0.02 * image.points[:, 2] / LENGTH
        image["other"] = image.points[:, 0]
        for names, options in ((("Extinction",), {}), ((), {}), (("Extinction",), {"clim": (0.005, 0.007)}), (("Extinction",), {"log_scale": True}),
                               (("other",), {"opacity_scalars": "Extinction"}), ((), {"color": "black", "cmap": None}), ((np.asarray(image["Extinction"]),), {})):
            with self.subTest(names=names, **options):
                self.assertAlmostEqual(self.transmittance(image, *names, **options), np.exp(-0.01 * LENGTH), delta=0.006)
        self.assertAlmostEqual(self.transmittance(image, "Extinction", opacity_scale=0.3), np.exp(-0.3 * 0.01 * LENGTH), delta=0.006)
        image.rename_array("Extinction", "k")
        image.set_active_scalars("k")
        self.assertAlmostEqual(self.transmittance(image, color="black", cmap=None), np.exp(-0.01 * LENGTH), delta=0.006)

    def test_contours_of_one_colour(self):
        """The values are extinctions: a surface lies across the line of sight, and hides as much as it is opaque."""
        image = box()
        image["Extinction"] = 0.02 * image.points[:, 2] / LENGTH
        surface = {"values": [0.01], "opacity": 0.5, "color": "black", "lighting": False}
        self.assertAlmostEqual(self.transmittance(image, color="black", cmap=None, contours=surface), 0.5 * np.exp(-0.01 * LENGTH), delta=0.006)

    def test_splats(self):
        image = box((21, 21, 41))
        for depth in (0.3, 2.0):
            image["k"] = np.full(image.n_points, depth / LENGTH)
            self.assertAlmostEqual(self.transmittance(image, "k", add=nephoscope.add_splats), np.exp(-depth), delta=0.015)

    def test_name_of_an_array(self):
        """An array called as the option is drawn by its name."""
        image = box()
        image["extinction"] = np.full(image.n_points, 1 / LENGTH)
        self.assertAlmostEqual(self.transmittance(image, "extinction"), np.exp(-1), delta=0.006)

    def test_wrong_arrays(self):
        """The array is named, and what is no extinction is clear air."""
        image = box((9, 9, 3))
        below = image.points[:, 2] < LENGTH / 4
        for value, told in ((-0.01, "'k' is negative in 81 of 243 values"), (np.nan, "'k'.* is not finite"), (np.inf, "'k'.* is not finite")):
            image["k"] = np.where(below, value, 0.01)
            with self.subTest(value=value):
                self.transmittance(image, "k", expected_warning=told)
        image["k"] = np.full(image.n_points, 1e-8)
        self.transmittance(image, "k", expected_warning="hardly visible.*'k' must be per unit of length of the mesh: set opacity_scale, such as 4e\\+06")
        image["k"] = np.full(image.n_points, 1e6)
        self.transmittance(image, "k", expected_warning="outer faces.*'k'")
        image["k"] = np.zeros(image.n_points)
        self.assertEqual(self.transmittance(image, "k", expected_warning="Nothing will be visible: the array 'k'"), 1)

    def test_wrong_arguments(self):
        image = box((3, 3, 3))
        image["k"], image["wind"] = np.ones(27), np.ones((27, 3))
        for options, word in (({"opacity_unit_distance": 3.0}, "opacity_unit_distance"), ({"opacity_scalars": "k", "opacity_clim": (0, 1)}, "opacity_clim"),
                              ({"opacity_scalars": "wind"}, "'wind' has 3 components")):
            for add in (nephoscope.add_cells, nephoscope.add_splats):
                with self.subTest(word, add=add.__name__), self.assertRaisesRegex(ValueError, word):
                    self.transmittance(image, "k", add=add, **options)
        with self.assertRaisesRegex(MissingDataError, "no array 'b'"):
            self.transmittance(image, "k", opacity_scalars="b")
        with self.assertRaisesRegex(MissingDataError, "no point or cell array"):
            self.transmittance(box((3, 3, 3)), color="red")


if __name__ == "__main__":
    unittest.main()
