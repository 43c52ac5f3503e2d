# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids that go around the globe have no hole: their cells fill the shell, and only the bottom and the top are open."""
import unittest

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import xarray as xr
from nephoscope.weather.projections import RotatedPole
from weather_data import AXIS, rotation

HEIGHTS = np.array([0.0, 5000, 10000])
POLE = (-162.0, 39.25)  # longitude and latitude, of the CORDEX domain of Europe
EARTH = 6371000.0


def fields(dims, lon, lat, u, v, standard=("eastward_wind", "northward_wind"), **attrs):
    wide = lambda values: np.repeat(np.broadcast_to(values, lon.shape)[None], len(HEIGHTS), axis=0)
    return {"north": (("z", *dims), wide(lat), {"units": "degree", **attrs}), "u": (("z", *dims), wide(u), {"standard_name": standard[0], "units": "m s-1", **attrs}),
            "v": (("z", *dims), wide(v), {"standard_name": standard[1], "units": "m s-1", **attrs})}


def rotated(places=False, halo=False, rows=18, columns=36):
    """A grid global in its own coordinates; `places`: with 2-D longitudes and latitudes instead of the grid mapping."""
    x, y = np.arange(columns + halo) * 360 / columns - 180, (np.arange(rows) + 0.5) * 180 / rows - 90
    pole = RotatedPole(*POLE)
    lon, lat = pole.to_degrees(*np.meshgrid(x, y))
    _, east, north = rotation(lon, lat)
    angle = pole.angles(lon, lat)
    u, v = east * np.cos(angle) + north * np.sin(angle), north * np.cos(angle) - east * np.sin(angle)
    dataset = xr.Dataset(fields(("rlat", "rlon"), lon, lat, u, v, ("grid_eastward_wind", "grid_northward_wind"), **({} if places else {"grid_mapping": "pole"})),
                         {"z": ("z", HEIGHTS, {"units": "m", "standard_name": "altitude"})})
    if places:
        return dataset.assign_coords(lon=(("rlat", "rlon"), lon), lat=(("rlat", "rlon"), lat))
    dataset["pole"] = ((), 0, {"grid_mapping_name": "rotated_latitude_longitude", "grid_north_pole_longitude": POLE[0], "grid_north_pole_latitude": POLE[1]})
    return dataset.assign_coords(rlon=("rlon", x, {"standard_name": "grid_longitude", "units": "degrees"}), rlat=("rlat", y, {"standard_name": "grid_latitude", "units": "degrees"}))


def straight(lat, columns=48):
    lon = np.arange(columns) * 360.0 / columns
    x, y = np.meshgrid(lon, lat)
    return xr.Dataset(fields(("lat", "lon"), x, y, *rotation(x, y)[1:]), {"z": ("z", HEIGHTS, {"units": "m"}), "lat": lat, "lon": lon})


def reduced(lat):
    counts = np.array([20 + 8 * min(i, len(lat) - 1 - i) for i in range(len(lat))])
    lon = np.concatenate([np.arange(count) * 360 / count for count in counts])
    y = np.repeat(lat, counts)
    return xr.Dataset(fields(("values",), lon, y, *rotation(lon, y)[1:]), {"z": ("z", HEIGHTS, {"units": "m"}), "longitude": ("values", lon, {"units": "degrees_east"}),
                                                                           "latitude": ("values", y, {"units": "degrees_north"})})


def gaussian(count):
    return np.degrees(np.arcsin(np.polynomial.legendre.leggauss(count)[0]))[::-1]


def holes(grid):
    """Number of faces of one cell alone that are neither at the bottom nor at the top; points at one place are one."""
    columns, rows, levels = grid.dimensions
    points = np.asarray(grid.points, float)
    ids = np.unique(np.round(points / 10).astype(np.int64), axis=0, return_inverse=True)[1].reshape(levels, rows, columns)
    corners = lambda k, j, i: ids[k:levels - 1 + k, j:rows - 1 + j, i:columns - 1 + i].ravel()
    squares = ((0, 0), (0, 1), (1, 1), (1, 0))
    sides = [[corners(k, a, at) for k, a in squares] for at in (0, 1)] + [[corners(k, at, a) for k, a in squares] for at in (0, 1)]
    sides = np.sort(np.concatenate([np.stack(side, axis=1) for side in sides]), axis=1)
    sides = sides[(np.diff(sides, axis=1) > 0).sum(axis=1) >= 2]  # those of no width are at a pole
    return int((np.unique(sides, axis=0, return_counts=True)[1] == 1).sum())


class TestWeatherClosed(unittest.TestCase):
    def check(self, dataset, share, tolerance=0.12, north=0.2):
        grid = dataset.nephoscope.globe(derive=("vorticity",))
        self.assertEqual(holes(grid), 0)
        volume = np.abs(grid.compute_cell_sizes()["Volume"]).sum() / (4 / 3 * np.pi * ((EARTH + HEIGHTS[-1]) ** 3 - EARTH ** 3))
        self.assertGreater(volume, share)
        self.assertLess(volume, 1)
        up = np.asarray(grid.points) / np.linalg.norm(grid.points, axis=1)[:, None]
        np.testing.assert_allclose(grid["Wind"], 30 * np.cross(AXIS, up), atol=tolerance)
        np.testing.assert_allclose(grid["north"], np.degrees(np.arcsin(up[:, 2])), atol=north)
        np.testing.assert_allclose(grid["vorticity"] * 6371229 / 60, up @ AXIS, atol=0.07)
        return grid

    def test_rotated_grids_are_closed_at_their_own_poles_and_seam(self):
        for dataset in (rotated(), rotated(halo=True)):
            with self.subTest(halo=dataset.sizes["rlon"]):
                self.assertEqual(self.check(dataset, 0.985).dimensions, (37, 20, 3))
                self.assertIn("closed at its poles", dataset.nephoscope.describe())

    def test_so_are_those_with_longitudes_and_latitudes_of_each_point(self):
        dataset = rotated(places=True)
        grid = dataset.drop_vars(("u", "v")).nephoscope.globe()
        self.assertEqual((holes(grid), grid.dimensions), (0, (37, 20, 3)))

    def test_a_missing_value_stays_in_the_rings(self):
        dataset = rotated()
        dataset["north"][:, -1, 3] = np.nan
        grid = dataset.nephoscope.globe()
        last = np.asarray(grid["north"]).reshape(3, 20, 37)[0, -1]
        self.assertTrue(np.isfinite(last).all() and np.ptp(last) == 0)
        dataset["north"][:, -1] = np.nan
        self.assertTrue(np.isnan(np.asarray(dataset.nephoscope.globe()["north"]).reshape(3, 20, 37)[0, -1]).all())

    def test_regions_of_rotated_grids_stay_open(self):
        for region in (dict(rlon=slice(0, 20)), dict(rlat=slice(3, 15))):
            with self.subTest(region):
                part = rotated().isel(region)
                self.assertGreater(holes(part.nephoscope.globe()), 0)
                self.assertNotIn("closed at", part.nephoscope.describe())

    def test_gaussian_grids_are_closed(self):
        self.check(straight(gaussian(24)), 0.985, north=5.7)  # the poles have the latitude of the last row
        self.check(straight(np.linspace(-90, 90, 25)), 0.985)
        grid = reduced(gaussian(24)).nephoscope.globe()
        self.assertEqual(holes(grid), 0)


if __name__ == "__main__":
    unittest.main()
