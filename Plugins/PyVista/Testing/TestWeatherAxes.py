# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Axes in any order, times of any kind, and fields by any of their names."""
import unittest
import warnings
from unittest import mock

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from weather_data import isothermal, rotation

LAT = np.arange(20, 60, 5.0)


def places(grid):
    """Longitude, latitude and the field q of the points that are shown."""
    x, y, z = np.asarray(grid.points).T
    return np.degrees(np.arctan2(y, x)), np.degrees(np.arctan2(z, np.hypot(x, y))), np.asarray(grid["q"])


def marked(longitude, latitude, pressures=(100000.0, 50000.0)):
    """q tells where a point is: its sine of longitude plus its latitude; seam and poles can be closed without changing that rule."""
    dataset = isothermal(longitude, latitude, pressures)
    field = np.sin(np.radians(dataset.lon)) + dataset.lat * (1 + 0 * dataset.plev)
    return dataset.assign(q=field.transpose("plev", "lat", "lon").assign_attrs(units="1"))


class Axes(unittest.TestCase):
    def check(self, longitude, latitude, columns, rows, **options):
        grid = marked(longitude, latitude).nephoscope.globe(close_poles=False, **options)
        self.assertEqual(grid.dimensions[:2], (columns, rows))
        lon, lat, q = places(grid)
        np.testing.assert_allclose(q, np.sin(np.radians(lon)) + lat, atol=1e-4)
        sides = np.linalg.norm(np.diff(np.asarray(grid.points).reshape(*grid.dimensions[::-1], 3), axis=2), axis=-1)
        self.assertLess(sides.max() / sides.min(), 4)  # no cell across the whole data
        return grid

    def test_longitudes_out_of_order(self):
        for longitude, columns in (([358, 359, 0, 1], 4), ([0, 1, 358, 359], 4), ([1, 0, 359, 358], 4), ([3, 1, 2, 0], 4), ([0, 0, 1, 2], 3), ([-1, 0, 1, 359], 3), ([0, 1, np.nan, 2], 3)):
            with self.subTest(longitude):
                self.check(np.array(longitude, float), LAT, columns, len(LAT))

    def test_round_the_globe(self):
        whole = np.arange(0, 360, 10.0)
        for longitude in (whole, np.append(whole, 360.0), np.roll(whole, 7), whole[::-1], np.append(whole - 180, 180.0), np.concatenate([[-10.0], whole, [360.0, 370.0]]), whole[np.r_[0:36:2, 1:36:2]]):
            with self.subTest(longitude[:3]):
                self.check(longitude, LAT, 37, len(LAT))

    def test_latitudes_in_any_order(self):
        for latitude, rows in ((LAT[::-1], 8), (np.append(LAT, LAT[-1]), 8), (np.append(LAT, np.nan), 8), (LAT[[3, 0, 1, 2, 4, 6, 5, 7]], 8)):
            with self.subTest(latitude):
                self.check(np.arange(0, 40, 5.0), latitude, 8, rows)

    def test_levels_in_any_order(self):
        for pressures in ((100000, 50000, 85000), (50000, 100000, 85000, 85000), (100000, np.nan, 85000, 50000)):
            with self.subTest(pressures):
                grid = marked(np.arange(0, 40, 5.0), LAT, pressures).nephoscope.globe()
                self.assertEqual(grid.dimensions[2], 3)
                height = np.asarray(grid["Height"]).reshape(grid.dimensions[::-1])
                self.assertGreater(np.diff(height, axis=0).min(), 1000)

    def test_heights_by_their_units(self):
        """Under any name that is not one of another axis."""
        for name, units, factor in (("alt", "km", 1000), ("alt_km", "km", 1000), ("msl", "ft", 0.3048), ("agl", "m", 1), ("platform_levels", "m", 1)):
            dataset = marked(np.arange(0, 40, 5.0), LAT, (100000.0, 50000.0, 20000.0))[["q"]].rename(plev=name).assign_coords({name: (name, [10.0, 20, 50], {"units": units})})
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertIn(f"levels: height{' above ground' * (name == 'agl')}, {name} 3", dataset.nephoscope.describe())
                grid = dataset.nephoscope.globe()
                radii = np.unique(np.round(np.linalg.norm(grid.points, axis=1) - 6371000, 1))
                np.testing.assert_allclose(radii, np.array([10.0, 20, 50]) * factor, atol=0.06)

    def test_lengths_of_another_meaning(self):
        for name in ("wavelength", "diameter", "x"):
            dataset = marked(np.arange(0, 40, 5.0), LAT)[["q"]].rename(plev=name).assign_coords({name: (name, [10.0, 20], {"units": "m"})})
            with self.subTest(name), self.assertRaisesRegex(ValueError, "No vertical axis.*units of pressure or length"):
                dataset.nephoscope.globe()

    def test_heights_of_the_thermosphere(self):
        """The advice works: it names the unit of the dataset, not an argument that datasets do not have."""
        dataset = marked(np.arange(0, 40, 5.0), LAT)[["q"]].rename(plev="alt").assign_coords(alt=("alt", [100.0, 800], {"units": "km"}))
        with self.assertWarnsRegex(RuntimeWarning, r"implausible on Earth. If they are in another unit, name it: ds\['NAME'\].attrs\['units'\] = 'km'"):
            dataset.nephoscope.globe()

    def test_missing_lines_are_holes(self):
        whole, lat = np.arange(0, 360, 10.0), np.arange(-85, 90, 10.0)
        for longitude, latitude, text in ((np.r_[whole[:25], whole[30:]], lat, "'lon' jumps from 240 to 300"), (np.delete(whole, 20), lat, "'lon' jumps from 190 to 210"),
                                          (whole, np.delete(lat, [4, 5]), "'lat' jumps from -55 to -25"), (np.delete(whole[::-1], 20), np.delete(lat, 3)[::-1], "'lon' jumps from 160 to 140.*'lat' jumps from -45 to -65")):
            for level in (slice(None), 0):
                with self.subTest(text, level=level), warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    dataset = marked(longitude, latitude).rename(q="mark").isel(plev=level)
                    self.assertRegex(dataset.nephoscope.describe(), f"note: {text[:20]}")
                    grid = dataset.nephoscope.globe(projection="map", close_poles=False)
                    self.assertEqual(grid.dimensions[:2], (37, 18))  # those of the whole globe
                    self.assertEqual(len(caught), 1)
                    self.assertRegex(str(caught[0].message), text)
                    shown = (np.asarray(grid.point_data["vtkGhostType"]) == 0).reshape(grid.dimensions[::-1])[0]
                    x, y = np.degrees(np.asarray(grid.points).reshape(*grid.dimensions[::-1], 3)[0, ..., :2].T / 6371000)
                    np.testing.assert_array_equal(shown, (np.isin(x.T.round() % 360, longitude) & np.isin(y.T.round(), latitude)))
                    self.assertEqual(np.isnan(np.asarray(grid["mark"])).sum(), (~shown).sum() * grid.dimensions[2])

    def test_irregular_axes_have_no_gaps(self):
        gaussian = np.degrees(np.arcsin(np.polynomial.legendre.leggauss(32)[0]))
        mercator = np.degrees(np.arctan(np.sinh(np.linspace(-3, 3, 31))))
        for latitude in (gaussian, np.r_[-90, gaussian, 90], mercator, 5 * 1.2 ** np.arange(12), np.r_[0:10:1.0, 10:50:2.0], np.array([-85, -60, -45, -30, -20, -10, 0, 10, 20.0]), np.array([0, 5, 20, 25.0])):
            with self.subTest(latitude), warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertEqual(isothermal(np.arange(0, 40, 5.0), latitude).nephoscope.globe().dimensions[1], len(latitude))

    def test_what_was_done_is_told(self):
        self.assertIn("'lon' is not in order and was sorted, 1 repeated or missing of 4 left out", marked(np.array([0, 0, 1, 2.0]), LAT).nephoscope.describe())
        with self.assertRaisesRegex(ValueError, "'lon' or 'lat' has only missing values"):
            marked(np.full(4, np.nan), LAT).nephoscope.globe()

    def test_a_list_that_is_no_axis_is_told_in_plain_words(self):
        flat = pyvista.RectilinearGrid([0.0, 2.0, 1.0], [0.0, 1.0], [0.0, 1.0])
        with self.assertRaisesRegex(RuntimeError, "longitude axis must increase or decrease throughout, but does not at index 2. Sort the longitudes"):
            nephoscope.to_globe(flat)


class Times(unittest.TestCase):
    def steps(self, dim, **coordinates):
        one = isothermal(np.arange(0, 40, 5.0), LAT)
        return xr.concat([one.ta + i for i in range(3)], dim).to_dataset(name="ta").assign(ps=one.ps, orog=one.orog).assign_coords(coordinates)

    def test_without_a_coordinate(self):
        dataset = self.steps("time")
        self.assertIn("time: time without a coordinate, step 0 (of 3, to 2)", dataset.nephoscope.describe())
        self.assertIn("step 2", dataset.nephoscope.describe(time=2))
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            dataset.nephoscope.globe()
        self.assertIn("3 times ('time'), without a coordinate", str(caught[0].message))
        self.assertEqual(dataset.nephoscope.series().times, ["0", "1", "2"])

    def test_a_number_that_is_no_index(self):
        """The message tells the indices, and that of the month which was meant."""
        one = isothermal(np.arange(0, 40, 5.0), LAT)
        months = xr.concat([one, one], xr.DataArray([1, 7], dims="month", name="month"))
        with self.assertRaisesRegex(ValueError, r"time is 7, but the dataset has 2 times \('month'\): it must be an index, 0 to 1, or a date. For month 7 pass time=1."):
            months.nephoscope.globe(time=7)
        with self.assertRaisesRegex(ValueError, "an index, 0 to 1, or a date.$"):
            months.nephoscope.globe(time=12)

    def test_lead_times(self):
        hours = np.arange(3) * np.timedelta64(6, "h").astype("timedelta64[ns]")
        lead, start = {"step": ("step", hours)}, {"time": np.datetime64("2020-01-01T12", "ns")}
        for name, dataset, time, seen in (
                ("alone", self.steps("step", **lead), 1, "step 6 h"),
                ("from a start", self.steps("step", **lead, **start), "2020-01-01T18", "step 2020-01-01 18:00 (6 h from the start)"),
                ("cfgrib", self.steps("step", **lead, **start, valid_time=("step", start["time"] + hours)), "2020-01-01T18", "step 2020-01-01 18:00 (6 h from the start)"),
                ("forecast_period", self.steps("forecast_period", forecast_period=("forecast_period", hours), forecast_reference_time=start["time"]), "2020-01-01T18", "forecast_period 2020-01-01 18:00")):
            with self.subTest(name):
                self.assertIn(seen, dataset.nephoscope.describe(time=time))
                np.testing.assert_allclose(dataset.nephoscope.globe(time=time)["ta"], 251)
                series = dataset.nephoscope.series()
                np.testing.assert_allclose(series.seconds, [0, 21600, 43200])
                self.assertEqual(series.times[2], "12 h" if name == "alone" else "2020-01-02 00:00")

    def test_dates_that_xarray_does_not_decode(self):
        """Those of WRF without XTIME, as texts and as letters, and those of ICON."""
        written = ["2020-06-21_18:00:00", "2020-06-22_00:00:00"]
        base = isothermal(np.arange(0, 40, 5.0), LAT)
        both = xr.concat([base, base], "Time", data_vars="all", coords="minimal")
        days = both.rename(Time="time").assign_coords(time=("time", [20200621.75, 20200622.0], {"units": "day as %Y%m%d.%f", "calendar": "proleptic_gregorian", "standard_name": "time", "axis": "T"}))
        letters = np.array([list(text) for text in written], "S1")
        for dataset in (both.assign(Times=("Time", np.array(written, "S19"))), both.assign(Times=(("Time", "DateStrLen"), letters)), days):
            with self.subTest(dataset.sizes):
                text = dataset.nephoscope.describe()
                self.assertIn("2020-06-21 18:00 (of 2, to 2020-06-22 00:00)", text)
                self.assertIn("2020-06-22 00:00", dataset.nephoscope.describe(time="2020-06-22"))
                np.testing.assert_array_equal(dataset.nephoscope.series().seconds, [0, 6 * 3600])
        odd = days.assign_coords(time=("time", [20200230.0, 20200230.5], days.time.attrs))
        self.assertIn("20200230.0", odd.nephoscope.describe())

    def test_dates_of_model_years(self):
        """Year 21 of HYCOM, also for one step beside another coordinate of times, and year 1 of ideal runs of WRF; without cftime there are no dates."""
        base = isothermal(np.arange(0, 40, 5.0), LAT)
        both = xr.concat([base, base], "Time", data_vars="all", coords="minimal")
        about = {"long_name": "date", "units": "day as %Y%m%d.%f"}
        wrf = both.assign(Times=("Time", np.array(["0001-06-21_18:00:00", "0001-06-22_00:00:00"], "S19")))
        days = both.rename(Time="MT").assign_coords(MT=("MT", [7215.25, 7216.0], {"axis": "T"}), Date=("MT", [210116.25, 210117.0], about))
        for dataset, year in ((wrf, "0001-06-21 18"), (days.assign_coords(MT=("MT", [210116.25, 210117.0], about)), "0021-01-16 06")):
            with self.subTest(year):
                text = dataset.nephoscope.describe()
                self.assertIn(year, text)
                self.assertEqual(np.diff(dataset.nephoscope.series().seconds)[0], 3600 * (6 if year[:4] == "0001" else 18))
        for dataset in (days, days.isel(MT=0)):
            self.assertIn("heights:", dataset.nephoscope.describe())
        with mock.patch.dict("sys.modules", cftime=None):
            for dataset in (wrf, days):
                self.assertIn("heights:", dataset.nephoscope.describe())

    def test_members(self):
        for dim in ("number", "realization"):
            with self.subTest(dim), warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                text = self.steps(dim, **{dim: [0, 1, 2]}).nephoscope.describe()
                self.assertIn(f"{dim!r} has 3 entries; the first was taken. Choose one: ds.isel({dim}=0).", str(caught[0].message))
                self.assertIn(f"note: {dim!r} has 3 entries", text)


class Names(unittest.TestCase):
    def setUp(self):
        self.dataset = isothermal(np.arange(0, 40, 5.0), LAT)
        wind = rotation(*np.meshgrid(self.dataset.lon, self.dataset.lat))
        dims = self.dataset.ta.dims
        self.dataset = self.dataset.assign(
            wind_x=(dims, np.tile(wind[1], (4, 1, 1)), {"standard_name": "eastward_wind", "units": "m/s"}), wind_y=(dims, np.tile(wind[2], (4, 1, 1)), {"standard_name": "northward_wind", "units": "m/s"}),
            liquid=(dims, np.full(self.dataset.ta.shape, 1e-4), {"standard_name": "mass_fraction_of_cloud_liquid_water_in_air", "units": "1", "long_name": "Liquid water"}),
            icing=(dims, self.dataset.ta.values > 0), kind=(dims, np.ones(self.dataset.ta.shape, np.int8), {"flag_values": [0, 1], "flag_meanings": "clear cloudy"}),
            period=(dims, np.full(self.dataset.ta.shape, 9 * 10**9, "timedelta64[ns]")), remark=("lat", np.array(list("abcdefgh"))))

    def drawn(self, name):
        found, options = self.dataset.nephoscope._of_field(name, None, {})
        return found, np.asarray(self.dataset.nephoscope.globe(**options)[found])

    def test_by_name_role_standard_name_and_quantity(self):
        for name, array in (("liquid", "liquid"), ("cloud_water", "liquid"), ("mass_fraction_of_cloud_liquid_water_in_air", "liquid"), ("Liquid water", "liquid"), ("LIQUID", "liquid"),
                            ("vorticity", "vorticity"), ("wind_speed", "wind_speed"), ("potential_temperature", "potential_temperature"), ("temperature", "ta"), ("u", "wind_x"), ("clwc", "liquid"), ("T", "ta"), ("UGRD", "wind_x")):
            with self.subTest(name):
                found, values = self.drawn(name)
                self.assertEqual(found, array)
                self.assertTrue(np.isfinite(values).any())

    def test_marks_flags_and_durations(self):
        for name, value in (("icing", 1), ("kind", 1), ("period", 9)):
            with self.subTest(name):
                np.testing.assert_allclose(self.drawn(name)[1], value)

    def test_what_cannot_be_drawn(self):
        for name, message in (("vortcity", "no field 'vortcity'. Did you mean 'vorticity'.*There are: 'ta', 'wind_x'.*computed quantities: 'potential_temperature'"),
                              ("remark", "'remark' is of type .U1, but a field must have numbers.*'ta'"), ("plev", "'plev' is on 'plev'")):
            with self.subTest(name), self.assertRaisesRegex(ValueError, message):
                self.dataset.nephoscope.plot(name, screenshot="none.png")

    def test_quantities_that_lack_their_input_are_not_proposed(self):
        bare = self.dataset[["liquid"]]
        with self.assertRaisesRegex(ValueError, "^There is no field 'temperature'. There are: 'liquid'.$"):
            bare.nephoscope.plot("temperature", screenshot="none.png")
        with self.assertRaisesRegex(ValueError, "computed quantities: 'wind_speed', 'vorticity'.$"):
            self.dataset[["wind_x", "wind_y"]].nephoscope.plot("temperature", screenshot="none.png")

    def test_every_quantity_that_is_proposed_can_be_drawn(self):
        from nephoscope.weather.derived import computable
        names = computable(self.dataset.nephoscope._reading(0, {}))
        self.assertEqual(names, ["potential_temperature", "wind_speed", "vorticity", "cloud_content"])
        for name in names:
            with self.subTest(name):
                self.assertTrue(np.isfinite(self.drawn(name)[1]).any())

    def test_an_animation_of_a_quantity(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(plotter.close)
        two = xr.concat([self.dataset[["ta", "wind_x", "wind_y"]]] * 2, xr.DataArray(np.array(["2020-01-01", "2020-01-02"], "datetime64[ns]"), dims="time", name="time"))
        series = nephoscope.animate(plotter, two.merge(self.dataset[["ps", "orog"]]), "wind_speed")
        self.assertIn("wind_speed", series.mesh.array_names)


class Units(unittest.TestCase):
    def test_unusual_spellings(self):
        from nephoscope.weather.units import converted
        for quantity, value, spellings in (("temperature", 283.15, {"Kelvins": 283.15, "degrees Kelvin": 283.15, "degree_Celsius": 10, "Degrees C": 10, "deg Celsius": 10, "degrees_C": 10}),
                                           ("pressure", 85000, {"hPa (mbar)": 850, "Millibars": 850, "N m-2": 85000, "N/m^2": 85000, "mbars": 850}),
                                           ("height", 1500, {"m AMSL": 1500, "meters above sea level": 1500, "m above ground": 1500, "gpm": 1500, "geopotential meter": 1500, "km": 1.5}),
                                           ("speed", 5, {"m/sec": 5, "meters per second": 5, "m sec^-1": 5, "meter second-1": 5, "M S-1": 5, "m s^{-1}": 5}),
                                           ("mass fraction", 0.004, {"Kg/Kg": 0.004, "g kg**-1": 4, "kg (kg)-1": 0.004, "10^-3 kg kg^-1": 4})):
            for spelling, number in spellings.items():
                with self.subTest(spelling):
                    np.testing.assert_allclose(converted(np.array([number], float), spelling, quantity, "x")[0], value)


if __name__ == "__main__":
    unittest.main()
