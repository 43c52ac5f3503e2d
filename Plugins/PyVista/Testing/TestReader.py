# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.read_cf against what is known of the Earth and of the file."""
import itertools
import os
import re
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
from nephoscope.reader import _missing_of

DATA = Path(os.environ["NEPHOSCOPE_DATA"])
PATH = DATA / "gfs_2p5deg_2011101100.nc"
sys.path.insert(0, str(DATA / "forecast"))
from forecast.netcdf_classic import Variable, Writer  # noqa: E402


def series(path, times, units="hours since 2011-10-11 00:00:00", calendar=None):
    """A file of some times: t is the index of the time everywhere, as is the cloud fraction."""
    lat, lon = np.linspace(-60, 60, 5), np.arange(8) * 45.0
    attributes = {"units": units, **({"calendar": calendar} if calendar else {})}
    file = Writer(path, {"time": None, "lev": 3, "lat": 5, "lon": 8}, [
        Variable("time", ("time",), "f8", attributes), Variable("lev", ("lev",), "f8", {"units": "hPa", "positive": "down"}),
        Variable("lat", ("lat",), "f8", {"units": "degrees_north"}), Variable("lon", ("lon",), "f8", {"units": "degrees_east"}),
        Variable("t", ("time", "lev", "lat", "lon"), "f4", {"units": "K"}),
        Variable("cc", ("time", "lev", "lat", "lon"), "f4", {"units": "1"})], {"Conventions": "CF-1.6"})
    for name, values in (("lev", [1000.0, 500, 200]), ("lat", lat), ("lon", lon)):
        file.write(name, values)
    for i, time in enumerate(times):
        file.write("time", [time], i)
        for name in ("t", "cc"):
            file.write(name, np.full((3, 5, 8), float(i)), i)
        file.finish_record(i)
    file.close()
    return path


class Reader(unittest.TestCase):
    def test_shape_axes_and_arrays(self):
        weather = nephoscope.read_cf(PATH)
        self.assertEqual(tuple(weather.dimensions), (144, 73, 21))
        np.testing.assert_allclose([weather.x[1], weather.y[0], weather.y[-1]], [2.5, -90, 90])
        self.assertLessEqual({"cloud_fraction", "gh", "u", "v", "w"}, set(weather.point_data))

    def test_variables_can_be_chosen(self):
        self.assertEqual(nephoscope.read_cf(PATH, variables="u").point_data.keys(), ["u"])

    def test_surface_fields(self):
        surface = nephoscope.read_cf(PATH, dimensions="(lat, lon)", variables=["sp", "orog"])
        self.assertEqual(surface, nephoscope.read_cf(PATH, dimensions=("lat", "lon"), variables=["sp", "orog"]))
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
        with self.assertRaisesRegex(ValueError, "TestReader.py is neither GRIB nor NetCDF, but a text file"):
            nephoscope.read_cf(__file__)
        files = {"smoke.vtu": (b"<VTKFile>", r"smoke.vtu is a mesh. Read it by pyvista.read\('.*smoke.vtu'\).* `read_cf` reads NetCDF."),
                 "a.grib2": (b"GRIB\0\0\0\2" + bytes(99), r"a.grib2 is GRIB. Open it by nephoscope.open\('.*a.grib2'\)"),
                 "cut.nc": (b"CDF\1", "cut.nc cannot be read, probably because it is incomplete or damaged"), "b.png": (b"\x89PNG\r\n\x1a\n\0\0", "b.png is neither GRIB nor NetCDF: it begins")}
        with tempfile.TemporaryDirectory() as folder:
            for name, (content, words) in files.items():
                path = os.path.join(folder, name)
                with open(path, "wb") as file:
                    file.write(content)
                for read in (nephoscope.read_cf, nephoscope.cf_times):
                    with self.subTest(name, read=read.__name__), self.assertRaisesRegex(ValueError, words):
                        read(path)
            with self.assertRaisesRegex(FileNotFoundError, "which is a folder"):
                nephoscope.read_cf(folder)


def level_file(path, dimensions, attributes=None, levels=(1000.0, 500, 200), missing=None, times=()):
    """cc = lon + 1000 lat + 0.01 lev + 100 time, on the dimensions in their order; the first value is `missing`."""
    axes = {"lev": np.array(levels), "lat": np.linspace(-60, 60, 5), "lon": np.arange(8) * 45.0, **({"time": np.array(times)} if times else {})}
    time = [Variable("time", ("time",), "f8", {"units": "hours since 2011-10-11 00:00:00"})] if times else []
    file = Writer(path, {"record": None, **{name: len(values) for name, values in axes.items()}}, [
        *time, Variable("number", ("record",), "f8", {}), Variable("lev", ("lev",), "f8", {"units": "hPa", "positive": "down"}), Variable("lat", ("lat",), "f8", {"units": "degrees_north"}),
        Variable("lon", ("lon",), "f8", {"units": "degrees_east"}), Variable("cc", dimensions, "f8", attributes or {"units": "1"})],
        {"Conventions": "CF-1.6"})
    for name, values in axes.items():
        file.write(name, values)
    lev, lat, lon = (axes[name].reshape([-1 if name == its else 1 for its in dimensions]) for name in ("lev", "lat", "lon"))
    values = lon + 1000 * lat + 0.01 * lev
    if times:
        values = values + 100 * axes["time"].reshape([-1 if its == "time" else 1 for its in dimensions])
    if missing is not None:
        values = np.abs(values) / 1e5
        values.ravel()[::7] = missing
    file.write("cc", values)
    file.write("number", [0.0], 0)
    file.finish_record(0)
    file.close()
    return path


class Axes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "levels.nc"

    def test_any_order_of_dimensions(self):
        for dimensions in itertools.permutations(("lev", "lat", "lon")):
            mesh = nephoscope.read_cf(level_file(self.path, dimensions))
            self.assertEqual(tuple(mesh.dimensions), (8, 5, 3), dimensions)
            x, y, z = mesh.points.T
            np.testing.assert_allclose(mesh["cc"], x + 1000 * y - 0.01 * z, err_msg=str(dimensions))
            self.assertEqual(mesh.nephoscope.globe().dimensions, (9, 5, 3))

    def test_time_before_any_order_of_dimensions(self):
        for dimensions in itertools.permutations(("lev", "lat", "lon")):
            path = level_file(self.path, ("time", *dimensions), times=(0.0, 6.0))
            for step in (0, 1):
                mesh = nephoscope.read_cf(path, time_step=step)
                self.assertEqual(tuple(mesh.dimensions), (8, 5, 3), dimensions)
                x, y, z = mesh.points.T
                np.testing.assert_allclose(mesh["cc"], x + 1000 * y - 0.01 * z + 600 * step, err_msg=str(dimensions))

    def test_time_that_is_not_first(self):
        for dimensions in (("lev", "time", "lat", "lon"), ("lev", "lat", "lon", "time")):
            with self.assertRaisesRegex(RuntimeError, "ncpdq -a time,lev,lat,lon.* The variable is cc"):
                nephoscope.read_cf(level_file(self.path, dimensions, times=(0.0, 6.0)))

    def test_more_dimensions_than_the_reader_takes(self):
        """As of an ensemble, and of models without a coordinate of time."""
        file = Writer(self.path, {"record": None, "number": 2, "lev": 3, "lat": 5, "lon": 8}, [
            Variable("r", ("record",), "f8", {}), Variable("q", ("number", "lev", "lat", "lon"), "f8", {})], {"Conventions": "CF-1.6"})
        file.write("q", np.zeros((2, 3, 5, 8)))
        file.write("r", [0.0], 0)
        file.finish_record(0)
        file.close()
        with self.assertRaisesRegex(RuntimeError, "three dimensions.*ncks -d.* The variable is q"):
            nephoscope.read_cf(self.path)

    def test_one_level(self):
        mesh = nephoscope.read_cf(level_file(self.path, ("lev", "lat", "lon"), levels=(500.0,)))
        self.assertTrue(np.isfinite(mesh.bounds).all() and np.isfinite(mesh.points).all())
        self.assertEqual(mesh.nephoscope.globe().dimensions, (9, 5, 1))

    def test_missing_values_that_the_file_does_not_declare(self):
        for missing in (-999.0, -9999.0, 1e20, 9999.0):
            path = level_file(self.path, ("lev", "lat", "lon"), missing=missing)
            with self.assertWarnsRegex(UserWarning, re.escape(f"18 of 'cc' are {missing:g}") + ".*missing_values"):
                mesh = nephoscope.read_cf(path)
            self.assertEqual(np.isnan(mesh["cc"]).sum(), 18)
            self.assertLess(np.nanmax(np.abs(mesh["cc"])), 1)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertEqual(np.isnan(nephoscope.read_cf(path, missing_values=[missing])["cc"]).sum(), 18)
                self.assertEqual(np.isnan(nephoscope.read_cf(path, missing_values=())["cc"]).sum(), 0)

    def test_values_that_only_look_missing(self):
        """999 among pressures near it, and -999 among -1500 to 200."""
        self.assertEqual(_missing_of(np.array([999.0, 998, 990, 1000, 1013])), [])
        self.assertEqual(_missing_of(np.array([-999.0, -980, -500, 200])), [])
        self.assertEqual(_missing_of(np.array([-999.0, 190, 310])), [-999])
        self.assertEqual(_missing_of(np.array([np.nan, 5.0])), [])


class Times(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "series.nc"

    def test_no_times(self):
        """VTK's reader ends the process."""
        for read in (nephoscope.read_cf, nephoscope.cf_times):
            with self.assertRaisesRegex(ValueError, "series.nc: the unlimited dimension 'time' has length 0.*Write at least one record"):
                read(series(self.path, []))

    def test_told_unless_chosen(self):
        series(self.path, [0, 6, 12])
        with self.assertWarnsRegex(UserWarning, r"3 times, 2011-10-11 00:00 to 2011-10-11 12:00; the first was read.*time_step, 0 to 2"):
            first = nephoscope.read_cf(self.path)
        self.assertEqual((first["t"][0], first.field_data["TimeValue"][0]), (0, 0))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for step, index in ((0, 0), (1, 1), (-1, 2), (-3, 0)):
                mesh = nephoscope.read_cf(self.path, time_step=step)
                self.assertEqual((mesh["t"][0], mesh.field_data["TimeValue"][0]), (index, 6 * index))
            nephoscope.read_cf(PATH)  # one time
        for step in (3, -4):
            with self.assertRaisesRegex(ValueError, f"time_step is {step}; .* has 3 time steps"):
                nephoscope.read_cf(self.path, time_step=step)

    def test_list(self):
        for units, expected in (("hours since 2011-10-11 00:00:00", ["2011-10-11 00:00", "2011-10-11 18:00"]),
                                ("days since 2011-1-1", ["2011-01-01 00:00", "2011-01-19 00:00"]),
                                ("minutes since 2011-10-11T06:00:00Z", ["2011-10-11 06:00", "2011-10-11 06:18"]),
                                ("seconds since 2011-10-11 00:00:00.0 UTC", ["2011-10-11 00:00", "2011-10-11 00:00"])):
            self.assertEqual(nephoscope.cf_times(series(self.path, [0, 18], units)), expected)

    def test_calendars_of_models_are_not_dates(self):
        times = nephoscope.cf_times(series(self.path, [0, 59], "days since 2011-01-01", "360_day"))
        self.assertEqual(times[1][:4], "59 d", times)

    def test_active_scalars(self):
        self.assertEqual(nephoscope.read_cf(series(self.path, [0])).active_scalars_name, "cc")
        self.assertEqual(nephoscope.read_cf(self.path, variables="t").active_scalars_name, "t")


if __name__ == "__main__":
    unittest.main()
