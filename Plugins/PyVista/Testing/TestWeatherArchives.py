# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files in the layouts of archives and tools, with nothing set: ECHAM by CDO, NCEP, UFS, wgrib2, NCL, ERA5 in the cloud, MITgcm; heights in closed form."""
import unittest
import warnings

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import pyvista
import xarray as xr
from weather_data import GAS, GRAVITY, RADIUS, rotation

LON, LAT = np.arange(0, 360, 20.0), np.arange(-80, 81, 20.0)
EAST, NORTH = np.meshgrid(LON, LAT)
KELVIN, SEA = 255.0, 101325.0
HILLS = 1000 * np.cos(np.radians(NORTH)) ** 2  # m
PLACES = {"lat": ("lat", LAT, {"units": "degrees_north"}), "lon": ("lon", LON, {"units": "degrees_east"})}


def geopotential_height(pressure):
    return GAS * KELVIN / GRAVITY * np.log(SEA / pressure)


def geometric(height):
    return RADIUS * height / (RADIUS - height)


PS = SEA * np.exp(-HILLS * RADIUS / (RADIUS + HILLS) * GRAVITY / (GAS * KELVIN))


def levels(values, count, **attrs):
    return ("lev", "lat", "lon"), np.broadcast_to(values, (count, *EAST.shape)).copy(), attrs


def on_pressures(units, *omitted, name="lev", **names):
    """Temperature, heights and winds of a solid rotation on 1000, 850 and 500 hPa."""
    hectopascals = np.array([1000.0, 850, 500])
    z = geopotential_height(100 * hectopascals)[:, None, None]
    _, east, north = rotation(EAST, NORTH)
    fields = {"t": levels(KELVIN, 3, units="K"), "gh": levels(z, 3, units="gpm"), "u": levels(east, 3, units="m/s"), "v": levels(north, 3, units="m/s")}
    data = xr.Dataset({names.get(key, key): field for key, field in fields.items() if key not in omitted}, {"lev": ("lev", hectopascals, units), **PLACES})
    return data.rename(lev=name) if name != "lev" else data


def mesh(data, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return data.nephoscope.globe(close_seam=False, close_poles=False, **options)


class TestWeatherArchives(unittest.TestCase):
    def check_heights(self, grid, expected):
        np.testing.assert_allclose(np.asarray(grid["Height"]).reshape(-1, *EAST.shape), np.broadcast_to(expected, (len(expected), *EAST.shape)), atol=0.5)

    def check_pressures(self, grid):
        self.check_heights(grid, geometric(geopotential_height(np.array([1e5, 8.5e4, 5e4])))[:, None, None])
        self.assertIn("Wind", grid.point_data)

    def test_hybrid_levels_of_echam(self):
        """CDO writes the coefficients on nhym; a selection of levels takes its own."""
        a, b = np.array([5000.0, 5000, 2000, 0]), np.array([0, 0.4, 0.8, 0.99])
        data = xr.Dataset({"st": levels(KELVIN, 4, units="K", long_name="temperature"), "xl": levels(1e-5, 4, units="kg/kg", long_name="cloud water"),
                           "aps": (("lat", "lon"), PS, {"units": "Pa"}), "geosp": (("lat", "lon"), GRAVITY * HILLS * RADIUS / (RADIUS + HILLS), {"units": "m**2/s**2"}),
                           "hyam": ("nhym", a, {"units": "Pa"}), "hybm": ("nhym", b, {"units": "1"})},
                          {"lev": ("lev", np.arange(1.0, 5), {"standard_name": "hybrid_sigma_pressure", "units": "level", "positive": "down", "formula": "hyam hybm (mlev=hyam+hybm*aps)"}), **PLACES})
        for part in (slice(None), slice(2, None)):
            pressure = (a[:, None, None] + b[:, None, None] * PS)[part]
            self.check_heights(mesh(data.isel(lev=part)), geometric(geopotential_height(pressure))[::-1])

    def test_omega_of_ncep(self):
        data = on_pressures({"units": "millibar", "axis": "Z", "positive": "down"}, gh="hgt", t="air", u="uwnd", v="vwnd")
        data["omega"] = levels(0.5, 3, units="Pascal/s")
        grid = mesh(data)
        self.check_pressures(grid)
        up = np.asarray(grid.points) / np.linalg.norm(grid.points, axis=1)[:, None]
        pressure = np.repeat([1e5, 8.5e4, 5e4], EAST.size)
        np.testing.assert_allclose((grid["Wind"] * up).sum(axis=1), -0.5 * GAS * KELVIN / (pressure * GRAVITY), atol=1e-4)
        data["omega"].attrs["units"] = "furlong/fortnight"
        with self.assertWarnsRegex(UserWarning, "The vertical wind is left out. The units of 'omega' are 'furlong/fortnight'"):
            calm = data.nephoscope.globe()
        self.assertIn("Wind", calm.point_data)

    def test_the_ground_of_the_unified_forecast_system(self):
        thickness = np.array([4000.0, 2000, 500])
        data = xr.Dataset({"tmp": levels(KELVIN, 3, units="K"), "delz": levels(-thickness[:, None, None], 3, units="m"), "hgtsfc": (("lat", "lon"), HILLS, {"units": "gpm"})},
                          {"lev": ("lev", [100.0, 500, 900], {"units": "mb", "long_name": "ref full pressure level", "positive": "down"}), **PLACES})
        self.check_heights(mesh(data), np.array([250.0, 1500, 4500])[:, None, None] + HILLS)

    def test_levels_in_the_names_of_variables(self):
        """As wgrib2 -netcdf writes them."""
        whole = on_pressures({"units": "hPa"}, t="TMP", gh="HGT", u="UGRD", v="VGRD")
        split = xr.Dataset({f"{name}_{level:.0f}mb": whole[name].sel(lev=level, drop=True) for level in (500.0, 1000, 850) for name in whole.data_vars})
        grid = mesh(split)
        self.check_pressures(grid)
        self.assertEqual({"TMP", "HGT", "UGRD", "VGRD"} - set(grid.point_data), set())
        np.testing.assert_allclose(grid["HGT"].reshape(3, -1)[:, 0], whole.HGT[:, 0, 0], rtol=1e-6)
        alone = split[["TMP_850mb", "TMP_500mb"]].drop_vars("TMP_500mb").nephoscope.globe()
        self.assertEqual(alone.dimensions[2], 1)

    def test_names_of_ncl(self):
        self.check_pressures(mesh(on_pressures({"units": "hPa"}, name="lv_ISBL0", t="TMP_P0_L100_GLL0", gh="HGT_P0_L100_GLL0", u="UGRD_P0_L100_GLL0", v="VGRD_P0_L100_GLL0")))

    def test_surface_pressure_in_full(self):
        """The name ends like that of a field on pressure levels."""
        data = on_pressures({}, t="temperature", gh="geopotential_height", u="u_component_of_wind", v="v_component_of_wind", name="level")
        data["surface_pressure"] = ("lat", "lon"), PS, {"units": "Pa"}
        self.assertIn("pressure at the ground: 'surface_pressure'", data.nephoscope.describe())
        below = np.asarray(mesh(data)["BelowGround"]).reshape(3, *EAST.shape)
        np.testing.assert_array_equal(below[1], PS < 85000)
        self.assertGreater(below[0].sum(), 0)

    def test_negative_heights_of_an_ocean(self):
        data = xr.Dataset({"THETA": levels(10.0, 3, units="degC")}, {"lev": ("lev", [-5.0, -50, -500], {"units": "m", "positive": "up", "axis": "Z"}), **PLACES}).rename(lev="Z")
        grid = data.nephoscope.globe(close_seam=False, close_poles=False)
        self.check_heights(grid, np.array([-500.0, -50, -5])[:, None, None])
        self.assertEqual(int(np.sum(grid.point_data.get("vtkGhostType", 0))), 0)

    def test_humidity_on_fewer_levels(self):
        """It is used at the levels that both axes have; its own column and its own picture are on its levels."""
        data = on_pressures({"units": "hPa"}, t="T", gh="Z3", u="U", v="V")
        several = xr.DataArray(np.array([0.01, 0.004])[:, None, None] * np.ones(EAST.shape), dims=("lev2", "lat", "lon"), attrs={"units": "kg/kg"})
        data = data.assign(SHUM=several).assign_coords(lev2=("lev2", [850.0, 700.0], {"units": "hPa"}))
        grid = data.nephoscope.globe(derive=("relative_humidity", "water_vapour"))
        vapour = np.asarray(grid["water_vapour"]).reshape(3, -1)
        density = 85000 / (GAS * KELVIN * (1 + (1 / 0.622 - 1) * 0.01))
        np.testing.assert_allclose(vapour[1], 0.01 * density, rtol=1e-4)
        self.assertTrue(np.isnan(vapour[[0, 2]]).all())
        self.assertNotIn("SHUM on lev", grid.point_data)
        np.testing.assert_allclose(data.nephoscope.column("SHUM")["column"], 0.007 * 15000 / GRAVITY, rtol=1e-5)
        self.assertGreater(data.nephoscope.column("water_vapour")["column"].min(), 0)
        told = data.nephoscope.describe()
        self.assertIn("note: 'SHUM' is on 'lev2', and most variables are on 'lev': it is used at the levels that both have, 1 of 3", told)
        for name in ("SHUM", "specific_humidity"):
            self.assertEqual(data.nephoscope._of_field(name, None, {}), ("SHUM", {"vertical": "lev2", "variables": ["SHUM"]}))
        apart = data.assign_coords(lev2=("lev2", [840.0, 700.0], {"units": "hPa"}))
        with self.assertRaisesRegex(ValueError, r"relative_humidity needs specific humidity, which was not found on 'lev': 'SHUM' is on 'lev2'. Interpolate it first, ds.assign\(SHUM=ds\['SHUM'\].interp\(lev2=ds\['lev'\]\)\)"):
            apart.nephoscope.globe(derive="relative_humidity")
        mended = apart.assign(SHUM=apart["SHUM"].interp(lev2=apart["lev"]))
        self.assertIn("relative_humidity", mended.nephoscope.globe(derive="relative_humidity").point_data)
        flat = data.assign(rain=(("lat", "lon"), np.ones(EAST.shape), {"units": "kg/kg"}))
        with self.assertRaisesRegex(ValueError, "column: 'rain' is on 'lat', 'lon', and has no integral over the levels. These have: 'T', 'Z3', 'U', 'V'"):
            flat.nephoscope.column("rain")

    def test_levels_of_a_model_without_heights(self):
        """As LFRic writes them: what the message proposes can be done."""
        data = xr.Dataset({"theta": levels(300.0, 3, units="K")}, PLACES).rename(lev="half_levels").assign_coords(half_levels=[0.0, 1, 2])
        with self.assertRaisesRegex(ValueError, r"heights of the levels 'half_levels' .* Or draw one level: ds.isel\(half_levels=0\)"):
            data.nephoscope.globe()
        self.assertEqual(data.isel(half_levels=0).nephoscope.globe().dimensions[2], 1)

    def test_names_of_netcdf_java(self):
        """As THREDDS servers and MetPy's data give the variables of GRIB files: the words of GRIB's tables, and the kind of level."""
        data = on_pressures({"units": "hPa"}, name="isobaric", t="Temperature_isobaric", gh="Geopotential_height_isobaric", u="u-component_of_wind_isobaric", v="v-component_of_wind_isobaric")
        data = data.assign({name: (data["Temperature_isobaric"].dims, np.full(data["Temperature_isobaric"].shape, value), {"units": units})
                            for name, value, units in (("Cloud_mixing_ratio_isobaric", 1e-4, "kg/kg"), ("Ice_water_mixing_ratio_isobaric", 2e-4, "kg/kg"), ("Rain_mixing_ratio_isobaric", 3e-4, "kg/kg"),
                                                       ("Snow_mixing_ratio_isobaric", 4e-4, "kg/kg"), ("Graupel_snow_pellets_isobaric", 5e-4, "kg/kg"), ("Relative_humidity_isobaric", 50.0, "%"),
                                                       ("Specific_humidity_isobaric", 1e-3, "kg/kg"), ("Vertical_velocity_geometric_isobaric", 0.1, "m/s"))})
        data["Land_cover_0__sea_1__land_surface"] = ("lat", "lon"), np.ones(EAST.shape), {"units": ""}
        roles = {"temperature": "Temperature", "geopotential_height": "Geopotential_height", "u": "u-component_of_wind", "v": "v-component_of_wind", "w": "Vertical_velocity_geometric",
                 "cloud_water": "Cloud_mixing_ratio", "cloud_ice": "Ice_water_mixing_ratio", "rain": "Rain_mixing_ratio", "snow": "Snow_mixing_ratio", "graupel": "Graupel_snow_pellets",
                 "relative_humidity": "Relative_humidity", "specific_humidity": "Specific_humidity"}
        for cover in ("Total_cloud_cover", "Cloud_cover", "Fraction_of_cloud_cover"):
            with_cover = data.assign({f"{cover}_isobaric": (data["Temperature_isobaric"].dims, np.full(data["Temperature_isobaric"].shape, 40.0), {"units": "%"})})
            found = with_cover.nephoscope._reading(None, {}).roles
            for role, name in {**roles, "cloud_fraction": cover}.items():
                self.assertEqual(found.get(role), f"{name}_isobaric", role)
            self.assertEqual(found.get("land"), "Land_cover_0__sea_1__land_surface")
            self.assertEqual(with_cover.nephoscope._of_field("cc", None, {})[0], f"{cover}_isobaric")

    def test_a_variable_on_other_levels(self):
        """Cloud water on fewer pressure levels than the temperature is drawn on its own."""
        data = on_pressures({"units": "hPa"})
        data["clwmr"] = ("isobaric1", "lat", "lon"), np.random.default_rng(1).random((1 + 1, *EAST.shape)), {"units": "kg/kg"}
        data = data.isel(lev=[0, 1, 2]).assign_coords(isobaric1=("isobaric1", [70000.0, 40000], {"units": "Pa", "positive": "down"}))
        data["more"] = ("lev4", "lat", "lon"), np.random.default_rng(1).random((5, *EAST.shape)), {"units": "1"}
        data = data.assign_coords(lev4=("lev4", [90000.0, 70000, 50000, 40000, 30000], {"units": "Pa", "positive": "down"}))
        found, options = data.nephoscope._of_field("more", None, {})
        self.assertEqual((found, options["vertical"], data.nephoscope.globe(**options).dimensions[2]), ("more", "lev4", 5))
        plotter = data.nephoscope.plot("more", screenshot=True, window_size=(100, 100))
        self.addCleanup(plotter.close)
        with self.assertRaisesRegex(ValueError, "There is no field 'less'"):
            data.nephoscope.plot("less")

    def test_the_first_picture_shows_no_coordinate(self):
        data = on_pressures({"units": "hPa"}, "u", "v")
        data = xr.Dataset({"p": levels(data.lev.values[:, None, None], 3, units="hPa"), "gh": data.gh, "t": data.t}, data.coords)
        self.assertEqual(data.nephoscope.globe().active_scalars_name, "t")
        self.assertEqual(on_pressures({"units": "hPa"}).nephoscope.globe().active_scalars_name, "t")

    def test_an_ocean_below_the_globe_needs_no_advice(self):
        data = xr.Dataset({"thetao": levels(np.random.default_rng(1).random((3, *EAST.shape)), 3, units="degC")}, {"lev": ("lev", [5.0, 50, 500], {"units": "m", "positive": "down"}), **PLACES})
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            plotter = data.nephoscope.plot(screenshot=True, window_size=(100, 100))
        self.addCleanup(plotter.close)
        self.assertEqual([str(one.message) for one in told if "planet with a radius" in str(one.message)], [])
        self.assertIsInstance(plotter, pyvista.Plotter)


if __name__ == "__main__":
    unittest.main()
