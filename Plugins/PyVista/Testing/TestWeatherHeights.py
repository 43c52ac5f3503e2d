# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights of the vertical axes of models: hybrid sigma-pressure, sigma, hybrid height, WRF and ICON, against closed forms."""
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import xarray as xr
from weather_data import GAS, GRAVITY, RADIUS, REGULAR, isothermal, rotation, write_grib

LON, LAT = np.arange(0, 40, 10.0), np.arange(20, 60, 10.0)
NORTHWARD = np.meshgrid(LON, LAT)[1]
OROG = 500 + 10 * NORTHWARD  # m
PS = 1e5 - 100 * NORTHWARD  # Pa


def geometric(z):
    return RADIUS * z / (RADIUS - z)


def geopotential(h):
    return RADIUS * h / (RADIUS + h)


def heights(dataset, **options):
    """(level, row, column), from the bottom to the top."""
    grid = dataset.nephoscope.globe(close_seam=False, close_poles=False, **options)
    return np.asarray(grid["Height"]).reshape(grid.dimensions[::-1])


class Hybrid(unittest.TestCase):
    A, B = np.array([2000.0, 10000, 12000, 0]), np.array([0.0, 0.2, 0.6, 0.98])

    def dataset(self):
        dataset = isothermal(LON, LAT, pressures=range(4)).rename(plev="lev")
        dataset["orog"].values[:], dataset["ps"].values[:] = OROG, PS
        return dataset

    def expected(self, pressures):
        return geometric(geopotential(OROG) + GAS * 250 / GRAVITY * np.log(PS / pressures))[::-1]

    def test_cf_formula_terms(self):
        pressures = self.A.reshape(4, 1, 1) + self.B.reshape(4, 1, 1) * PS
        for terms, a in (("ap: a b: b ps: ps", self.A), ("a: a b: b ps: ps p0: p0", self.A / 1e5)):
            dataset = self.dataset().assign(a=("lev", a, {"units": "Pa" if "ap" in terms else "1"}), b=("lev", self.B), p0=((), 1e5, {"units": "Pa"}))
            dataset["lev"] = ("lev", np.arange(4.0), {"standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_terms": terms, "units": "1"})
            np.testing.assert_allclose(heights(dataset), self.expected(pressures), atol=0.5)

    def test_coefficients_of_the_community_model(self):
        dataset = self.dataset().assign(hyam=("lev", self.A / 1e5), hybm=("lev", self.B), P0=((), 1e5, {"units": "Pa"}))
        dataset["lev"] = ("lev", np.arange(4.0), {"positive": "down"})
        np.testing.assert_allclose(heights(dataset), self.expected(self.A.reshape(4, 1, 1) + self.B.reshape(4, 1, 1) * PS), atol=0.5)

    def test_sigma(self):
        dataset = self.dataset()
        dataset["lev"] = ("lev", [0.1, 0.3, 0.6, 0.95], {"standard_name": "atmosphere_sigma_coordinate", "formula_terms": "sigma: lev ps: ps ptop: ptop", "positive": "down"})
        for top, units in ((1000.0, "Pa"), (10.0, "hPa")):
            dataset["ptop"] = (), top, {"units": units}
            self.check_sigma(dataset)

    def test_sigma_by_name(self):
        """As NCEP writes it: no standard name, and the pressure at the ground is pres."""
        dataset = self.dataset().rename(lev="sigma_level", ps="pres")
        dataset["pres"].attrs = {"units": "Pa", "long_name": "Surface pressure"}
        sigma = np.array([0.1, 0.3, 0.6, 0.995])
        dataset["sigma_level"] = ("sigma_level", sigma, {"units": "sigma_level", "positive": "down"})
        np.testing.assert_allclose(heights(dataset), self.expected(sigma.reshape(4, 1, 1) * PS), atol=0.5)

    def test_sleve(self):
        a, b1, b2 = (np.array(values) for values in ([0.0, 0.1, 0.5, 1.0], [1.0, 0.8, 0.2, 0], [1.0, 0.6, 0.1, 0]))
        dataset = self.dataset().drop_vars(("ps", "orog")).assign(a=("lev", a), b1=("lev", b1), b2=("lev", b2), ztop=((), 15.0, {"units": "km"}))
        dataset = dataset.assign(large=(("lat", "lon"), 0.7 * OROG, {"units": "m"}), small=(("lat", "lon"), 0.3 * OROG, {"units": "m"}))
        dataset["lev"] = ("lev", a, {"standard_name": "atmosphere_sleve_coordinate", "formula_terms": "a: a b1: b1 b2: b2 ztop: ztop zsurf1: large zsurf2: small"})
        expected = a.reshape(4, 1, 1) * 15000 + (0.7 * b1 + 0.3 * b2).reshape(4, 1, 1) * OROG
        np.testing.assert_allclose(heights(dataset), expected, atol=0.05)
        with self.assertRaisesRegex(ValueError, "atmosphere_sleve_coordinate, but of their formula_terms.*are not in the dataset: b2"):
            heights(dataset.drop_vars("b2"))

    def check_sigma(self, dataset):
        pressures = 1000 + dataset.lev.values.reshape(4, 1, 1) * (PS - 1000)
        np.testing.assert_allclose(heights(dataset), self.expected(pressures), atol=0.5)

    def test_a_level_at_the_ground_is_not_below_it(self):
        levels = np.array([0.0, 500, 2000, 6000])
        for projection in ("globe", "map"):
            dataset = self.dataset().drop_vars("ps")
            dataset["orog"].values[:] += np.float32(0.123)
            dataset["lev"] = ("lev", levels, {"standard_name": "height", "units": "m", "positive": "up"})
            found = dataset.nephoscope.globe(projection=projection)
            self.assertEqual(int(found["BelowGround"].sum()), 0)
            dataset["lev"] = ("lev", levels + 1200, {"standard_name": "altitude", "units": "m", "positive": "up"})
            dataset["orog"].values[:] += 300
            below = np.asarray(dataset.nephoscope.globe(projection=projection)["BelowGround"]).reshape(4, -1)[0]
            np.testing.assert_array_equal(below, (dataset.orog.values > 1201).ravel())

    def test_no_surface_pressure_is_refused(self):
        dataset = self.dataset().assign(hyam=("lev", self.A / 1e5), hybm=("lev", self.B)).drop_vars(["ps", "lev"])
        with self.assertRaisesRegex(ValueError, r"need the pressure at the ground.*globe\(surface_pressure="):
            heights(dataset)

    def test_model_levels_without_coefficients_have_a_remedy(self):
        """As in NetCDF files of ECMWF."""
        levels = isothermal(LON, LAT, pressures=range(4)).rename(plev="model_level")[["ta"]]
        with self.assertRaisesRegex(ValueError, r"heights of the levels 'model_level' .*model levels, such as ECMWF's, .*coefficients a and b, .*lnsp as GRIB, and open that file\."):
            levels.assign_coords(model_level=np.arange(74.0, 78)).nephoscope.globe()
        with self.assertRaisesRegex(ValueError, r"globe\(pressure='...'\)\. Or draw one level: ds.isel\(model_level=0\)\.$"):
            levels.assign_coords(model_level=np.arange(4) + 0.3).nephoscope.globe()

    def test_hybrid_levels_of_grib(self):
        """As ERA5's model levels: a and b of half levels in the header, lnsp and the geopotential of the ground on level 1."""
        half_a, half_b = np.array([0.0, 2000, 10000, 4000, 0]), np.array([0.0, 0.0, 0.2, 0.7, 1.0])
        keys = {**REGULAR, "PVPresent": 1, "pv": np.concatenate([half_a, half_b])}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "model_levels.grib")
            write_grib(path, [("t", "hybrid", level, 250.0) for level in (1, 2, 3, 4)] + [("lnsp", "hybrid", 1, np.log(9e4)), ("z", "hybrid", 1, 800 * GRAVITY)], keys)
            found = heights(nephoscope.open(path))[:, 3, 3]
        p = half_a + half_b * 9e4
        thickness = GAS * 250 / GRAVITY * np.log(p[2:] / p[1:-1])
        base = 800 + np.concatenate([np.cumsum(thickness[::-1])[::-1], [0]])  # of the half levels 1 to 4
        alpha = np.append(np.log(2), 1 - p[1:-1] / (p[2:] - p[1:-1]) * np.log(p[2:] / p[1:-1]))  # IFS documentation, part III, equation 2.23
        expected = geometric(base + GAS * 250 / GRAVITY * alpha)
        np.testing.assert_allclose(found, expected[::-1], atol=1.0)


class Models(unittest.TestCase):
    def test_hybrid_height(self):
        """z = a + b orog, as in the Unified Model."""
        a, b = np.array([10.0, 500, 2000, 8000]), np.array([0.99, 0.8, 0.3, 0.0])
        dataset = isothermal(LON, LAT).rename(plev="level_height")
        dataset["orog"].values[:] = OROG
        dataset["level_height"] = ("level_height", a, {"standard_name": "atmosphere_hybrid_height_coordinate", "formula_terms": "a: level_height b: sigma orog: orog", "units": "m"})
        dataset["sigma"] = "level_height", b
        np.testing.assert_allclose(heights(dataset), a.reshape(4, 1, 1) + b.reshape(4, 1, 1) * OROG, rtol=1e-5)

    def wrf(self):
        """A run of one time: winds staggered, heights from PH + PHB, rows turned by 20 degrees."""
        full = np.array([0.0, 400, 1200, 3000, 7000])
        half = OROG + full.reshape(-1, 1, 1)
        lon, lat = np.meshgrid(LON, LAT)
        _, east, north = rotation(lon, lat)
        turn = np.radians(20)
        u, v = east * np.cos(turn) + north * np.sin(turn), north * np.cos(turn) - east * np.sin(turn)
        wide = lambda field, axis: np.concatenate([np.take(field, [0], axis), 0.5 * (np.take(field, range(3), axis) + np.take(field, range(1, 4), axis)), np.take(field, [-1], axis)], axis)
        mass, shape = ("Time", "bottom_top", "south_north", "west_east"), (1, 4, 4, 4)
        ones = lambda field: np.broadcast_to(field, (1, 4, *field.shape[-2:])).astype("f4")
        return xr.Dataset({
            "PH": (("Time", "bottom_top_stag", *mass[2:]), 0.1 * 9.81 * half[None], {"units": "m2 s-2"}), "PHB": (("Time", "bottom_top_stag", *mass[2:]), 0.9 * 9.81 * half[None], {"units": "m2 s-2"}),
            "P": (mass, np.full(shape, 500.0), {"units": "Pa"}), "PB": (mass, np.full(shape, 79500.0), {"units": "Pa"}), "T": (mass, np.full(shape, 10.0), {"units": "K"}),
            "QCLOUD": (mass, np.full(shape, 1e-4), {"units": "kg kg-1"}),
            "U": (("Time", "bottom_top", "south_north", "west_east_stag"), ones(wide(u, 1)), {"units": "m s-1"}), "V": (("Time", "bottom_top", "south_north_stag", "west_east"), ones(wide(v, 0)), {"units": "m s-1"}),
            "W": (("Time", "bottom_top_stag", *mass[2:]), np.zeros((1, 5, 4, 4)), {"units": "m s-1"}), "HGT": (("Time", *mass[2:]), OROG[None], {"units": "m"}),
            "COSALPHA": (("Time", *mass[2:]), np.full((1, 4, 4), np.cos(turn))), "SINALPHA": (("Time", *mass[2:]), np.full((1, 4, 4), np.sin(turn)))},
            {"XLAT": (("Time", *mass[2:]), lat[None], {"units": "degree_north"}), "XLONG": (("Time", *mass[2:]), lon[None], {"units": "degree_east"})}), full

    def test_wrf(self):
        dataset, full = self.wrf()
        np.testing.assert_allclose(heights(dataset), OROG + 0.5 * (full[1:] + full[:-1]).reshape(-1, 1, 1), rtol=1e-5)
        told = dataset.nephoscope.describe()
        for words in ("averaged from bottom_top_stag to bottom_top", "averaged from west_east_stag to west_east", "COSALPHA"):
            self.assertIn(words, told)
        wind = np.asarray(dataset.nephoscope.globe()["Wind"]).reshape(4, 4, 4, 3)
        lon, lat = np.meshgrid(LON, LAT)
        expected = rotation(lon, lat)[0]
        # Winds between two places are their mean and the border's its own: exact where they change evenly.
        np.testing.assert_allclose(wind[0][1:-1, 1:-1], expected[1:-1, 1:-1], atol=0.6)

    def test_heights_on_half_levels(self):
        """As ICON's z_ifc: one more than the levels of the fields."""
        half = np.array([0.0, 100, 500, 2000, 9000])
        dataset = isothermal(LON, LAT).drop_vars("plev").rename(plev="height")
        dataset["z_ifc"] = ("height_2", "lat", "lon"), half.reshape(-1, 1, 1) + OROG, {"units": "m", "standard_name": "geometric_height_at_half_level_center"}
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            np.testing.assert_allclose(heights(dataset), OROG + 0.5 * (half[1:] + half[:-1]).reshape(-1, 1, 1), rtol=1e-5)


if __name__ == "__main__":
    unittest.main()
