# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.open and dataset.nephoscope on xarray datasets: places, heights, winds, units and what is refused."""
import importlib
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import xarray as xr
from nephoscope.weather import extras
from weather_data import GAS, GRAVITY, RADIUS, frames, isothermal, rotation

LON, LAT = np.arange(0, 360, 15.0), np.arange(-80, 81, 10.0)


def columns(grid, sizes):
    """Point arrays as (level, row, column)."""
    return {name: np.asarray(values).reshape(*sizes[::-1], *values.shape[1:]) for name, values in grid.point_data.items()}


def geometric(z):
    return RADIUS * z / (RADIUS - z)


class Heights(unittest.TestCase):
    def test_hypsometric_equation_of_one_temperature(self):
        dataset = isothermal(LON, LAT, ground=300.0)
        grid = dataset.nephoscope.globe(close_seam=False, close_poles=False)
        heights = columns(grid, grid.dimensions)["Height"][:, 3, 5]
        ground = RADIUS * 300 / (RADIUS + 300)
        expected = geometric(ground + GAS * 250 / GRAVITY * np.log(1.02e5 / dataset.plev.values))
        np.testing.assert_allclose(heights, expected, atol=0.5)
        self.assertIn("hypsometric equation from the ground", dataset.nephoscope.describe())

    def test_virtual_temperature(self):
        dataset = isothermal(LON, LAT)
        dataset["hus"] = dataset.ta * 0 + 0.01
        dataset["hus"].attrs = {"standard_name": "specific_humidity", "units": "1"}
        grid = dataset.nephoscope.globe(close_seam=False, close_poles=False)
        expected = geometric(GAS * 250 * (1 + (1 / 0.622 - 1) * 0.01) / GRAVITY * np.log(1.02e5 / dataset.plev.values))
        np.testing.assert_allclose(columns(grid, grid.dimensions)["Height"][:, 3, 5], expected, atol=0.5)

    def test_geopotential_and_geopotential_height_give_geometric_height(self):
        dataset = isothermal(LON, LAT)
        z = np.array([100.0, 1500, 5500, 12000]).reshape(4, 1, 1) + 0 * dataset.ta.values
        for name, units, scale in (("zg", "m", 1.0), ("gh", "gpm", 1.0), ("z", "m**2 s**-2", GRAVITY), ("z", "m2 s-2", GRAVITY), ("zg", "km", 1e-3)):
            with self.subTest(name=name, units=units):
                grid = dataset.assign({name: (("plev", "lat", "lon"), z * scale, {"units": units})}).nephoscope.globe(close_seam=False, close_poles=False)
                np.testing.assert_allclose(columns(grid, grid.dimensions)["Height"][:, 2, 2], geometric(z[:, 2, 2]), rtol=1e-5)

    def test_standard_atmosphere_where_nothing_else_is_known(self):
        dataset = isothermal(LON, LAT)[["ta"]]
        grid = dataset.nephoscope.globe(close_seam=False, close_poles=False)
        # U.S. Standard Atmosphere 1976, table I: geopotential heights of 850, 500 and 200 hPa
        np.testing.assert_allclose(columns(grid, grid.dimensions)["Height"][1:, 2, 2], geometric(np.array([1457.3, 5574.4, 11784.1])), atol=1.0)

    def test_height_levels_above_sea_and_above_ground(self):
        for standard, ground in (("altitude", 0.0), ("height", 500.0)):
            dataset = isothermal(LON, LAT, ground=500.0).rename(plev="height")
            dataset["height"] = ("height", [1.0, 2, 4, 8], {"standard_name": standard, "units": "km", "positive": "up"})
            grid = dataset.nephoscope.globe(close_seam=False, close_poles=False)
            np.testing.assert_allclose(columns(grid, grid.dimensions)["Height"][:, 2, 2], np.array([1000, 2000, 4000, 8000]) + ground, rtol=1e-6)

    def test_the_ground_hides(self):
        dataset = isothermal(LON, LAT, surface_pressure=9e4)
        grid = dataset.nephoscope.globe(close_seam=False, close_poles=False, mask_below_ground=True)
        below = columns(grid, grid.dimensions)["BelowGround"]
        self.assertTrue((below[0] == 1).all() and (below[1:] == 0).all())

    def test_one_level_is_hidden_by_its_pressure_alone(self):
        """Fields without a vertical axis are drawn at the height 0, below every mountain."""
        mountains = isothermal(LON, LAT, ground=1500.0, surface_pressure=8e4)
        heights = mountains.rename(plev="height").assign_coords(height=("height", [10.0, 2000, 4000, 8000], {"standard_name": "height", "units": "m", "positive": "up"}))
        unknown = mountains.assign_coords(plev=("plev", [1.0, 2, 3, 4], {"axis": "Z"}))
        for dataset, hidden in ((mountains.sel(plev=50000), False), (mountains.sel(plev=85000), True), (mountains.drop_vars("ps").sel(plev=85000), False),
                                (mountains.isel(plev=0, drop=True), False), (heights.isel(height=0), False), (unknown.isel(plev=0), False)):
            for options in ({}, {"projection": "map"}):
                grid = dataset.nephoscope.globe(close_seam=False, close_poles=False, **options)
                self.assertEqual(set(grid["BelowGround"]), {int(hidden)})
                self.assertTrue((grid["Height"] == 0).all())
        level = mountains.sel(plev=50000).nephoscope.globe(derive="potential_temperature")
        np.testing.assert_allclose(level["potential_temperature"], 250 * 2**0.2857, rtol=1e-5)

    def test_levels_in_any_order_give_one_mesh(self):
        dataset = isothermal(LON, LAT)
        dataset["cc"] = (("plev", "lat", "lon"), np.random.default_rng(1).random(dataset.ta.shape), {"units": "1"})
        up, down = (d.nephoscope.globe() for d in (dataset, dataset.isel(plev=slice(None, None, -1))))
        np.testing.assert_allclose(up.points, down.points)
        np.testing.assert_array_equal(up["cc"], down["cc"])


class Places(unittest.TestCase):
    def test_positions(self):
        grid = isothermal(LON, LAT).nephoscope.globe(close_seam=False, close_poles=False, radius=1e6, vertical_exaggeration=10.0)
        lon, lat = np.meshgrid(LON, LAT)
        points = grid.points.reshape(4, *lon.shape, 3)[1]
        radius = 1e6 + 10 * columns(grid, grid.dimensions)["Height"][1]
        np.testing.assert_allclose(points, radius[..., None] * frames(lon, lat)[2], rtol=1e-5, atol=1)

    def test_transposed_dimensions_and_other_names(self):
        first = isothermal(LON, LAT)
        second = first.transpose("lon", "plev", "lat").rename(lon="i", lat="j", plev="k")
        np.testing.assert_allclose(first.nephoscope.globe().points, second.nephoscope.globe().points)

    def test_regular_region_across_the_meridian(self):
        dataset = isothermal([350, 355, 0, 5, 10], [40, 45, 50])
        grid = dataset.nephoscope.globe(projection="map")
        self.assertEqual(tuple(grid.dimensions), (5, 3, 4))
        self.assertAlmostEqual(np.ptp(grid.points[:, 0]) / 6371000, np.radians(20), places=4)

    def test_two_dimensional_places_and_rotated_winds(self):
        turn = np.radians(25)
        i, j = np.meshgrid(np.linspace(-8, 8, 33), np.linspace(-8, 8, 33))
        lat = 45 + i * np.sin(turn) + j * np.cos(turn)
        lon = 10 + (i * np.cos(turn) - j * np.sin(turn)) / np.cos(np.radians(45))
        from weather_data import along_rows
        wind, east, north = rotation(lon, lat)
        u, v = along_rows(lon, lat, east, north)
        dims = ("z", "y", "x")
        dataset = xr.Dataset({"wx": (dims, np.stack([u] * 2), {"standard_name": "x_wind", "units": "m/s"}), "wy": (dims, np.stack([v] * 2), {"standard_name": "y_wind", "units": "m/s"})},
                             {"lon2": (("y", "x"), lon, {"standard_name": "longitude", "units": "degrees_east"}), "lat2": (("y", "x"), lat, {"standard_name": "latitude"}),
                              "z": ("z", [0.0, 1000], {"units": "m", "axis": "Z"})})
        got = columns(grid := dataset.nephoscope.globe(), grid.dimensions)["Wind"][0]
        inside = np.s_[3:-3, 3:-3]
        np.testing.assert_allclose(got[inside], wind[inside], atol=0.1)

    def test_masked_values_stay_missing(self):
        dataset = isothermal(LON, LAT)
        dataset["ta"][1, 3, 4] = np.nan
        grid = dataset.nephoscope.globe(close_seam=False, close_poles=False, altitude=False)
        self.assertTrue(np.isnan(columns(grid, grid.dimensions)["ta"][1, 3, 4]))


class Winds(unittest.TestCase):
    def test_eastward_wind_and_omega(self):
        dataset = isothermal(LON, LAT)
        lon, lat = np.meshgrid(LON, LAT)
        wind, east, north = rotation(lon, lat)
        ones = np.ones((4, 1, 1))
        omega = np.full(dataset.ta.shape, -2.0)
        dataset = dataset.assign(ua=(dataset.ta.dims, ones * east / 0.514444, {"standard_name": "eastward_wind", "units": "knots"}),
                                 va=(dataset.ta.dims, ones * north, {"standard_name": "northward_wind", "units": "m s-1"}),
                                 wap=(dataset.ta.dims, omega, {"standard_name": "lagrangian_tendency_of_air_pressure", "units": "Pa s-1"}))
        grid = dataset.nephoscope.globe(close_seam=False, close_poles=False)
        got = columns(grid, grid.dimensions)["Wind"]
        upward = 2.0 * GAS * 250 / (50000 * GRAVITY)
        np.testing.assert_allclose(got[2], wind + upward * frames(lon, lat)[2], atol=1e-3)


class Refusals(unittest.TestCase):
    def raises(self, pattern, action, kind=ValueError):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertRaisesRegex(kind, pattern, action)

    def test_unknown_units_name_the_variable_and_the_known_ones(self):
        dataset = isothermal(LON, LAT)
        dataset["ta"].attrs["units"] = "furlong"
        self.raises("'ta' are 'furlong'.*kelvin", dataset.nephoscope.globe)

    def test_no_units_and_impossible_values(self):
        dataset = isothermal(LON, LAT)
        del dataset["ta"].attrs["units"]
        self.assertIn("'ta' has no units and is used as K", dataset.nephoscope.describe())
        self.raises("'ta' has no units.*not plausible for temperature in K", (dataset.assign(ta=(dataset.ta - 250).assign_attrs(standard_name="air_temperature"))).nephoscope.globe)

    def test_names_that_are_not_there(self):
        dataset = isothermal(LON, LAT)
        self.raises("temperature: no variable 'T'.*'ta'", lambda: dataset.nephoscope.globe(temperature="T"))
        self.raises("variables: 'cc' not on the grid.*'ta'", lambda: dataset.nephoscope.globe(variables=["cc"]))
        self.raises("vertical: no dimension 'z'.*'plev'", lambda: dataset.nephoscope.globe(vertical="z"))

    def test_no_places(self):
        dataset = isothermal(LON, LAT).rename(lon="a", lat="b")
        del dataset["a"].attrs["units"]
        self.raises("No longitudes.*There are: .*'a'", dataset.nephoscope.globe)

    def test_sections_and_empty_selections(self):
        dataset = isothermal(LON, LAT)
        for plot, words in ((dataset.sel(lon=45).nephoscope.globe, r"section at one longitude, 45.*at least two longitudes, .*ds.sel\(lon=slice"), (dataset.sel(lat=20).nephoscope.globe, "section at one latitude, 20"),
                            (dataset.sel(lon=[45]).isel(plev=[0]).nephoscope.plot, "a line or a single point, 1 x 17 x 1 .*two levels"), (dataset.sel(lat=[20]).isel(plev=0).nephoscope.plot, "a line or a single point, 24 x 1 x 1"),
                            (dataset.isel(lon=slice(0, 0)).nephoscope.plot, "selection is empty: 'lon' has no entry"), (dataset.sel(lat=slice(50, 20)).nephoscope.globe, "selection is empty: 'lat'.*direction of its axis"),
                            (dataset.isel(plev=slice(0, 0)).ta.nephoscope.globe, "selection is empty: 'plev'")):
            with self.subTest(words):
                self.raises(words, plot)
        self.assertRegex(dataset.sel(lat=slice(50, 20)).nephoscope.describe(), "^not recognized: The selection is empty: 'lat'")
        self.assertEqual(dataset.sel(lon=[45]).nephoscope.globe().dimensions, (1, 17, 4))  # a mesh for other pictures

    def test_an_array_alone(self):
        self.assertIn("temperature: 'ta'", isothermal(LON, LAT).ta.nephoscope.describe())
        self.assertIn("field", isothermal(LON, LAT).ta.rename(None).nephoscope.globe().array_names)

    def test_levels_that_say_nothing(self):
        dataset = isothermal(LON, LAT).drop_vars("plev")[["ta"]].rename(plev="level")
        self.raises("heights of the levels 'level'.*'ta'", dataset.nephoscope.globe)

    def test_times(self):
        dataset = xr.concat([isothermal(LON, LAT)] * 2, xr.IndexVariable("time", np.array(["2020-01-01T00", "2020-01-01T06"], "M8[ns]")))
        with self.assertWarnsRegex(UserWarning, "2 times.*2020-01-01 00:00 to 2020-01-01 06:00"):
            dataset.nephoscope.globe()
        dataset["ta"][1] += 10
        self.assertEqual(dataset.nephoscope.globe(time="2020-01-01T06")["ta"].max(), 260)
        self.assertEqual(dataset.nephoscope.globe(time=-1)["ta"].max(), 260)
        self.raises("none of the 2 times.*06:00", lambda: dataset.nephoscope.globe(time="2021-01-01"))
        self.raises("time is 2, but the dataset has 2 times", lambda: dataset.nephoscope.globe(time=2))
        self.raises("'time' has no dates", lambda: dataset.assign_coords(time=[0.0, 6.0]).nephoscope.globe(time="2020"))

    def test_more_dimensions(self):
        dataset = xr.concat([isothermal(LON, LAT)] * 2, "scenario")
        self.raises(r"'scenario'.*ds.isel\(scenario=0\)", dataset.nephoscope.globe)


class Opening(unittest.TestCase):
    def test_netcdf_and_zarr(self):
        dataset = isothermal(LON, LAT)
        expected = dataset.nephoscope.globe()
        with tempfile.TemporaryDirectory() as folder:
            dataset.to_netcdf(Path(folder, "a.nc"))
            dataset.to_zarr(Path(folder, "a.zarr"))
            for name in ("a.nc", "a.zarr"):
                opened = nephoscope.open(Path(folder, name))
                np.testing.assert_allclose(opened.nephoscope.globe().points, expected.points)
                opened.close()
            Path(folder, "b.grb").write_bytes(b"nothing of the kind")
            with self.assertRaisesRegex(ValueError, "neither GRIB nor NetCDF.*it is damaged"):
                nephoscope.open(Path(folder, "b.grb"))
            with self.assertRaisesRegex(ValueError, "not a Zarr store"):
                nephoscope.open(folder)
        with self.assertRaisesRegex(FileNotFoundError, r"http://a.b/c.nc is an address, not a file.*xarray.open_dataset\('http://a.b/c.nc'\)"):
            nephoscope.open("http://a.b/c.nc")
        with self.assertRaisesRegex(FileNotFoundError, "No such file: nowhere.nc"):
            nephoscope.open("nowhere.nc")

    def test_dask_is_left_lazy(self):
        asked = []

        def block(block_info=None):
            asked.append(block_info[None]["chunk-location"])
            return np.full((1, 4, LAT.size, LON.size), 250.0)

        import dask.array as da
        dataset = isothermal(LON, LAT)
        dataset["ta"] = (("time", *dataset.ta.dims), da.map_blocks(block, chunks=((1,) * 5, (4,), (LAT.size,), (LON.size,)), dtype=float, meta=np.empty((0, 0, 0, 0))), dataset.ta.attrs)
        dataset.nephoscope.globe(time=3)
        self.assertEqual({place[0] for place in asked}, {3})

    def test_the_accessor_is_there_whatever_is_imported_first(self):
        for lines in ("import nephoscope, xarray", "import xarray, nephoscope"):
            told = subprocess.run([sys.executable, "-c", f"{lines}; print(xarray.Dataset().nephoscope)"], capture_output=True, text=True)
            self.assertIn("WeatherAccessor", told.stdout, told.stderr)
        told = subprocess.run([sys.executable, "-c", "import sys, nephoscope; print('xarray' in sys.modules, 'eccodes' in sys.modules)"], capture_output=True, text=True)
        self.assertEqual(told.stdout.split(), ["False", "False"], told.stderr)

    def test_proj_before_eccodes(self):
        """Beside VTK of the package index, `open` loads pyproj before xarray imports eccodes, whose PROJ would end the process; beside Debian's VTK, which has a PROJ too, it does not."""
        real, seen = importlib.import_module, []
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "data.nc")
            isothermal(LON, LAT).to_netcdf(path)
            for from_pypi in (True, False):
                with mock.patch.object(extras, "FROM_PYPI", from_pypi), mock.patch.object(importlib, "import_module", lambda name, *more: seen.append((name, from_pypi)) if name == "pyproj" else real(name, *more)):
                    nephoscope.open(path).close()
        self.assertEqual(seen, [("pyproj", True)])

    def test_eccodes_before_and_after(self):
        """Its libraries hide symbols of VTK's and of the system: no order ends in a crash, neither at a scalar bar nor when Python ends."""
        draw = ("import pyvista; mesh = nephoscope.read_cf(nephoscope.sample_data('gfs_2p5deg_2011101100.nc')); plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60)); "
                "nephoscope.add_splats(plotter, pyvista.Wavelet()); plotter.show(); print('drawn')")
        for lines in ("import cfgrib, nephoscope", "import nephoscope, cfgrib", "import eccodes, nephoscope, xarray"):
            with self.subTest(lines):
                told = subprocess.run([sys.executable, "-c", f"{lines}; {draw}"], capture_output=True, text=True)
                self.assertEqual((told.returncode, told.stdout.strip()), (0, "drawn"), told.stderr)


if __name__ == "__main__":
    unittest.main()
