# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Integrals over columns against the mass path (dp/g) and the closed form of the isothermal atmosphere, from the ground to the uppermost level."""
import unittest

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import xarray as xr
from weather_data import GAS, GRAVITY, isothermal

LON, LAT = np.arange(0, 40, 10.0), np.arange(20, 60, 10.0)
OROG = np.array([0.0, 300, 1200, 2500])[:, None] + 0 * LON
KELVIN, SHARE = 250.0, 2e-4  # temperature; kg/kg of cloud water
SCALE = GAS * KELVIN / GRAVITY
PS = 1.01e5 * np.exp(-OROG / SCALE)


def dataset(pressures, water=SHARE):
    """Cloud water of one share, or a function of the pressure, over a hill."""
    found = isothermal(LON, LAT, pressures, KELVIN)
    found["orog"].values[:], found["ps"].values[:] = OROG, PS
    share = np.asarray(pressures, float)[:, None, None] * 0 + (water(np.asarray(pressures, float))[:, None, None] if callable(water) else water)
    found["clw"] = ("plev", "lat", "lon"), np.broadcast_to(share, found.ta.shape).copy(), {"units": "kg kg-1", "standard_name": "mass_fraction_of_cloud_liquid_water_in_air"}
    return found


def column(data, name="clw", **options):
    grid = data.nephoscope.column(name, close_seam=False, close_poles=False, **options)
    assert grid.field_data["column_units"][0] == "kg m-2"
    return np.asarray(grid["column"]).reshape(4, 4)


class TestWeatherColumns(unittest.TestCase):
    LEVELS = np.array([100000.0, 92500, 85000, 70000, 50000, 30000])

    def test_pressure_levels_reach_the_ground(self):
        np.testing.assert_allclose(column(dataset(self.LEVELS)), SHARE * (PS - 30000) / GRAVITY, rtol=1e-5)
        for name in ("cloud_content", "clw"):
            np.testing.assert_allclose(column(dataset(self.LEVELS), name), SHARE * (PS - 30000) / GRAVITY, rtol=1e-5)

    def test_no_temperature_is_needed_there(self):
        np.testing.assert_allclose(column(dataset(self.LEVELS).drop_vars("ta")), SHARE * (PS - 30000) / GRAVITY, rtol=1e-5)

    def test_a_share_linear_in_the_pressure(self):
        linear = dataset(np.arange(100000, 29000, -2500.0), lambda p: 1e-9 * (p - 30000))
        np.testing.assert_allclose(column(linear), 0.5e-9 * (PS - 30000) ** 2 / GRAVITY, rtol=1e-2)

    def test_values_missing_below_the_ground(self):
        data = dataset(self.LEVELS)
        data["clw"] = data.clw.where(data.plev <= data.ps)
        np.testing.assert_allclose(column(data), SHARE * (PS - 30000) / GRAVITY, rtol=1e-5)
        data["clw"].values[:, 1, 1] = np.nan
        self.assertEqual(int(np.isnan(column(data)).sum()), 1)

    def test_the_pressure_at_the_ground_follows_from_heights(self):
        data = dataset(self.LEVELS)
        data["zg"] = ("plev", "lat", "lon"), np.broadcast_to(SCALE * np.log(1.01e5 / data.plev.values)[:, None, None], data.ta.shape), {"units": "m", "standard_name": "geopotential_height"}
        np.testing.assert_allclose(column(data.drop_vars("ps")), SHARE * (PS - 30000) / GRAVITY, rtol=2e-3)

    def test_without_a_ground_only_the_levels_count(self):
        np.testing.assert_allclose(column(dataset(self.LEVELS).drop_vars(("ps", "orog"))), SHARE * 70000 / GRAVITY, rtol=1e-5)

    def test_layers_of_a_hybrid_model(self):
        half = np.array([0.0, 0.1, 0.3, 0.6, 0.85, 1.0])
        full = 0.5 * (half[1:] + half[:-1])
        data = dataset(np.arange(5)).rename(plev="lev").assign(ap=("lev", 0 * full, {"units": "Pa"}), b=("lev", full))
        data["lev"] = ("lev", np.arange(5.0), {"standard_name": "atmosphere_hybrid_sigma_pressure_coordinate", "formula_terms": "ap: ap b: b ps: ps", "units": "1"})
        np.testing.assert_allclose(column(data), SHARE * PS / GRAVITY, rtol=1e-5)

    def test_layers_of_known_mass(self):
        data = dataset(np.arange(4)).rename(plev="pfull").drop_vars("ps")
        data["pfull"] = ("pfull", np.arange(4.0), {"positive": "down"})
        data["dpres"] = ("pfull", "lat", "lon"), np.broadcast_to(np.array([1000.0, 20000, 30000, 40000])[:, None, None], data.ta.shape), {"units": "Pa"}
        np.testing.assert_allclose(column(data), SHARE * 91000 / GRAVITY, rtol=1e-5)

    def heights(self, levels, kind):
        """On heights above the ground or above sea level, with the pressure of the isothermal atmosphere."""
        z = np.asarray(levels, float)[:, None, None] + (OROG if kind == "height" else 0 * OROG)
        air = {"pres": 1.01e5 * np.exp(-z / SCALE), "ta": 0 * z + KELVIN, "clw": 0 * z + SHARE}
        units = {"pres": "Pa", "ta": "K", "clw": "kg kg-1"}
        return xr.Dataset({**{name: (("z", "lat", "lon"), values, {"units": units[name]}) for name, values in air.items()}, "orog": (("lat", "lon"), OROG, {"units": "m", "standard_name": "surface_altitude"})},
                          {"z": ("z", np.asarray(levels, float), {"units": "m", "standard_name": kind, "positive": "up"}), "lat": ("lat", LAT, {"units": "degrees_north"}), "lon": ("lon", LON, {"units": "degrees_east"})})

    def test_heights(self):
        levels = [0, 250, 600, 1000, 1500, 2100, 3000, 4000, 5500, 7000]
        top = lambda z: SHARE * 1.01e5 / GRAVITY * (np.exp(-OROG / SCALE) - np.exp(-z / SCALE))
        np.testing.assert_allclose(column(self.heights(levels, "altitude")), top(7000), rtol=1e-2)
        np.testing.assert_allclose(column(self.heights(levels, "height")), top(7000 + OROG), rtol=1e-2)
        np.testing.assert_allclose(column(self.heights(levels[1:], "height")), top(7000 + OROG), rtol=1e-2)  # the lowest level is above the ground

    def test_units(self):
        data = self.heights([0, 500, 1000], "height")
        expected = column(data)
        data["clw"] = (1000 * data.clw).assign_attrs(units="g kg-1")
        np.testing.assert_allclose(column(data), expected, rtol=1e-5)
        data["lwc"] = (0 * data.clw + 0.3).assign_attrs(units="g m-3")
        np.testing.assert_allclose(column(data, "lwc"), 0.3, rtol=1e-5)

    def test_half_levels_of_a_model(self):
        """WRF: the layers are those between PH + PHB, so that one that differs from layer to layer is exact."""
        faces = np.array([0.0, 100, 400, 1000, 3000])[:, None, None] * (1 - OROG / 2e4) + OROG
        middle = 0.5 * (faces[1:] + faces[:-1])
        share = np.array([0.0, 3e-4, 1e-4, 0])[:, None, None] + 0 * middle
        pressure = 1.01e5 * np.exp(-middle / SCALE)
        dims = lambda level: ("Time", level, "south_north", "west_east")
        data = xr.Dataset({"PH": (dims("bottom_top_stag"), 0 * faces[None], {"units": "m2 s-2"}), "PHB": (dims("bottom_top_stag"), 9.81 * faces[None], {"units": "m2 s-2"}),
                           "P": (dims("bottom_top"), pressure[None], {"units": "Pa"}), "PB": (dims("bottom_top"), 0 * pressure[None], {"units": "Pa"}),
                           "T": (dims("bottom_top"), (KELVIN * (1e5 / pressure) ** 0.2857 - 300)[None], {"units": "K"}), "QCLOUD": (dims("bottom_top"), share[None], {"units": "kg kg-1"}),
                           "HGT": (dims("x")[:1] + dims("x")[2:], OROG[None], {"units": "m"}), "XLAT": (("south_north", "west_east"), LAT[:, None] + 0 * LON, {"units": "degree_north"}),
                           "XLONG": (("south_north", "west_east"), LON + 0 * LAT[:, None], {"units": "degree_east"})})
        np.testing.assert_allclose(column(data, "QCLOUD"), (share * pressure / (GAS * KELVIN) * np.diff(faces, axis=0)).sum(axis=0), rtol=1e-4)


if __name__ == "__main__":
    unittest.main()
