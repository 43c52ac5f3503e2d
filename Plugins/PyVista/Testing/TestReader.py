# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.read_cf against what is known of the Earth and of the file."""
import os
import unittest
from pathlib import Path

import nephoscope
import numpy as np

PATH = Path(os.environ["NEPHOSCOPE_DATA"]) / "gfs_2p5deg_2011101100.nc"


class Reader(unittest.TestCase):
    def test_shape_axes_and_arrays(self):
        weather = nephoscope.read_cf(PATH)
        self.assertEqual(tuple(weather.dimensions), (144, 73, 21))
        np.testing.assert_allclose([weather.x[1], weather.y[0], weather.y[-1]], [2.5, -90, 90])
        self.assertLessEqual({"cloud_fraction", "gh", "u", "v", "w"}, set(weather.point_data))

    def test_variables_can_be_chosen(self):
        self.assertEqual(nephoscope.read_cf(PATH, variables="u").point_data.keys(), ["u"])

    def test_surface_fields(self):
        surface = nephoscope.read_cf(PATH, dimensions=("lat", "lon"), variables=["sp", "orog"])
        self.assertEqual(set(surface.point_data), {"sp", "orog"})
        self.assertEqual(surface.n_points, 144 * 73)
        longitude, latitude, _ = surface.points[np.argmax(surface.point_data["orog"])]
        self.assertTrue(75 < longitude < 100 and 27 < latitude < 40, f"Tibet read at {longitude} E, {latitude} N")

    def test_errors_list_what_is_there(self):
        with self.assertRaises(FileNotFoundError):
            nephoscope.read_cf("no_such_file.nc")
        with self.assertRaisesRegex(ValueError, r"no variable of .* has \(time, x\). There are: .*\(lev, lat, lon\)"):
            nephoscope.read_cf(PATH, dimensions=("time", "x"))
        with self.assertRaisesRegex(ValueError, "'rain' not in .* There are: .*'cloud_fraction'"):
            nephoscope.read_cf(PATH, variables=["u", "rain"])

    def test_not_a_netcdf_file(self):
        with self.assertRaisesRegex((RuntimeError, ValueError), "vtkNetCDFCFReader|no variable"):
            nephoscope.read_cf(__file__)


if __name__ == "__main__":
    unittest.main()
