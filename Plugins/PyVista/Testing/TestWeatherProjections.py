# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Projections by pyproj against the forward formulas of the sphere (Snyder 1987) and, for a satellite's view, against a ray and the sphere."""
import unittest
from unittest import mock

import nephoscope  # noqa: F401
import numpy as np
import xarray as xr

R = 6371229.0
SPHERE = {"earth_radius": R, "false_easting": 0.0, "false_northing": 0.0}


def transverse_mercator(a, b, lon0=0.1, **_):
    return R * np.arctanh(np.cos(b) * np.sin(a - lon0)), R * np.arctan2(np.tan(b), np.cos(a - lon0))


def azimuthal(factor):
    def forward(a, b, lon0=0.2, lat0=0.9):
        c = np.sin(lat0) * np.sin(b) + np.cos(lat0) * np.cos(b) * np.cos(a - lon0)
        k = R * factor(c)
        return k * np.cos(b) * np.sin(a - lon0), k * (np.cos(lat0) * np.sin(b) - np.sin(lat0) * np.cos(b) * np.cos(a - lon0))
    return forward


def albers(a, b, lon0=0.2, lat0=0.9, first=0.8, last=1.0):
    n = (np.sin(first) + np.sin(last)) / 2
    c = np.cos(first) ** 2 + 2 * n * np.sin(first)
    radius = lambda latitude: R * np.sqrt(c - 2 * n * np.sin(latitude)) / n
    return radius(b) * np.sin(n * (a - lon0)), radius(lat0) - radius(b) * np.cos(n * (a - lon0))


FAR = {"longitude_of_projection_origin": np.degrees(0.2), "latitude_of_projection_origin": np.degrees(0.9)}
CASES = {"transverse_mercator": (transverse_mercator, {"longitude_of_central_meridian": np.degrees(0.1), "latitude_of_projection_origin": 0.0, "scale_factor_at_central_meridian": 1.0}, (0, 6e6)),
         "lambert_azimuthal_equal_area": (azimuthal(lambda c: np.sqrt(2 / (1 + c))), FAR, (0, 0)),
         "stereographic": (azimuthal(lambda c: 2 / (1 + c)), {**FAR, "scale_factor_at_projection_origin": 1.0}, (0, 0)),
         "orthographic": (azimuthal(lambda c: np.ones_like(c)), FAR, (0, 0)),
         "albers_conical_equal_area": (albers, {"longitude_of_central_meridian": np.degrees(0.2), "latitude_of_projection_origin": np.degrees(0.9), "standard_parallel": np.degrees([0.8, 1.0])}, (0, 0))}


def dataset(name, keys, x, y, units="m", wind=()):
    fields = {"tas": (("y", "x"), np.arange(len(y) * len(x), dtype=float).reshape(len(y), -1), {"grid_mapping": "crs", "units": "K"})}
    fields |= {f"{key}_wind": (("y", "x"), np.full((len(y), len(x)), value), {"grid_mapping": "crs", "units": "m/s", "standard_name": f"{key}_wind"}) for key, value in wind}
    return xr.Dataset({**fields, "crs": ((), 0, {"grid_mapping_name": name, **SPHERE, **keys})},
                      {"x": ("x", x, {"units": units, "standard_name": "projection_x_coordinate"}), "y": ("y", y, {"units": units, "standard_name": "projection_y_coordinate"})})


def angles(grid):
    x, y, z = np.asarray(grid.points, float).T
    return np.arctan2(y, x), np.arctan2(z, np.hypot(x, y))


class Projections(unittest.TestCase):
    def test_places(self):
        for name, (forward, keys, (x0, y0)) in CASES.items():
            for units, length in (("m", 1.0), ("km", 1000.0)):
                with self.subTest(name, units=units):
                    x, y = x0 + np.linspace(-1.5e6, 1.5e6, 11), y0 + np.linspace(-1e6, 1e6, 9)
                    grid = dataset(name, keys, x / length, y / length, units).nephoscope.globe(radius=1.0)
                    found = forward(*angles(grid))
                    np.testing.assert_allclose(found, [part.ravel() for part in np.meshgrid(x, y)], atol=30)  # points in single precision

    def test_winds_along_the_grid(self):
        """A wind along x points on the globe where x grows."""
        for name, (forward, keys, (x0, y0)) in CASES.items():
            with self.subTest(name):
                x, y = x0 + np.linspace(-5e5, 5e5, 21), y0 + np.linspace(-5e5, 5e5, 21)
                grid = dataset(name, keys, x, y, wind=(("x", 10.0), ("y", 0.0))).nephoscope.globe(radius=1.0)
                a, b = angles(grid)
                step = 1e-5
                along = (np.asarray(forward(a + step, b)) - forward(a - step, b)) / np.cos(b), np.asarray(forward(a, b + step)) - forward(a, b - step)
                # the direction (east, north) whose image has no part along y
                east, north = along[1][1], -along[0][1]
                sign = np.sign(east * along[0][0] + north * along[1][0])
                up = np.stack([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)], -1)
                eastward = np.stack([-np.sin(a), np.cos(a), 0 * a], -1)
                wanted = (east[:, None] * eastward + north[:, None] * np.cross(up, eastward)) * (sign / np.hypot(east, north))[:, None]
                np.testing.assert_allclose(np.asarray(grid["Wind"]) / 10, wanted, atol=4e-3)

    def test_a_satellite(self):
        """Angles of the scan (sweep x): the ray from the satellite meets the sphere at the place; beside the Earth points are hidden."""
        height, lon0 = 35786023.0, -75.0
        scan = np.linspace(-0.16, 0.16, 17)
        keys = {"perspective_point_height": height, "longitude_of_projection_origin": lon0, "latitude_of_projection_origin": 0.0, "sweep_angle_axis": "x"}
        data = dataset("geostationary", keys, scan, scan, "rad")
        grid = data.nephoscope.globe(radius=R)
        x, y = (part.ravel() for part in np.meshgrid(scan, scan))
        ray = np.stack([-np.cos(x) * np.cos(y), np.sin(x), np.cos(x) * np.sin(y)], -1)  # seen from over longitude 0, sweep x: the scan turns about the axis of x first
        eye = np.array([R + height, 0.0, 0.0])
        middle = ray @ eye
        root = middle ** 2 - (eye @ eye - R * R)
        seen = root > 0
        places = eye + ray * (-middle - np.sqrt(np.maximum(root, 0)))[:, None]
        turn = np.radians(lon0)
        places = places @ np.array([[np.cos(turn), np.sin(turn), 0], [-np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
        index = np.asarray(grid["tas"]).astype(int)  # the grid may be turned
        shown = seen[index]
        np.testing.assert_allclose(np.asarray(grid.points)[shown], places[index][shown], atol=1e-4 * R)
        self.assertIn(f"{(~seen).sum()} of 289 points are not on the Earth", data.nephoscope.describe())
        self.assertGreater(np.count_nonzero(grid["vtkGhostType"]), 0)

    def test_a_lost_grid_mapping(self):
        """Arithmetic drops the attributes of a variable; the dataset still has those of the projection."""
        whole = dataset("rotated_latitude_longitude", {"grid_north_pole_latitude": 40.0, "grid_north_pole_longitude": -170.0}, np.arange(-5, 6.0), np.arange(-4, 5.0), "degrees")
        lost = whole.assign(tas=xr.Variable(whole.tas.dims, whole.tas.values))
        self.assertIn("'tas' has no attribute grid_mapping: 'crs' was taken", lost.nephoscope.describe())
        np.testing.assert_array_equal(lost.nephoscope.globe().points, whole.nephoscope.globe().points)
        for given, why in ((lost[["tas"]], "has no attribute grid_mapping"), (whole[["tas"]], "its grid_mapping 'crs' is not in the dataset")):
            with self.assertRaisesRegex(ValueError, f"'y', 'x' belong to a projection.*{why}"):
                given.nephoscope.globe()

    def test_missing_rows_and_columns_are_holes(self):
        keys = {"grid_north_pole_latitude": 40.0, "grid_north_pole_longitude": -170.0}
        with self.assertWarnsRegex(UserWarning, "'x' jumps from -1 to 1: values are missing there"):
            grid = dataset("rotated_latitude_longitude", keys, np.delete(np.arange(-5, 6.0), 5), np.arange(-4, 5.0), "degrees").nephoscope.globe()
        np.testing.assert_array_equal(np.asarray(grid.point_data["vtkGhostType"]).reshape(9, 11) != 0, np.tile(np.arange(11) == 5, (9, 1)))

    def test_without_pyproj(self):
        with mock.patch("importlib.util.find_spec", return_value=None), self.assertRaisesRegex(
                ModuleNotFoundError, "projection albers_conical_equal_area needs the Python package 'pyproj'.*(nephoscope.data|requirements-data).*-m pip install pyproj"):
            dataset("albers_conical_equal_area", CASES["albers_conical_equal_area"][1], np.arange(3.0), np.arange(3.0)).nephoscope.globe()

    def test_what_pyproj_refuses(self):
        with self.assertRaisesRegex(ValueError, "projection oblique_mercator cannot be used: .*Its attributes are"):
            dataset("oblique_mercator", {}, np.arange(3.0), np.arange(3.0)).nephoscope.globe()


if __name__ == "__main__":
    unittest.main()
