# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.open on GRIB files that eccodes writes: its own places and values are the reference."""
import tempfile
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
from nephoscope.weather import grib
from weather_data import GRAVITY, LAMBERT, RADIUS, REGULAR, along_rows, frames, rotation, write_grib

WAVES = np.cos(np.arange(36 * 17) / 7)


class Grib(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name, "forecast.grib2")

    def forecast(self, keys=REGULAR, **more):
        """Two levels, two times."""
        fields = [(name, "isobaricInhPa", level, values + level / 100, {"dataDate": date}) for date in (20200101, 20200102) for level in (500, 850)
                  for name, values in (("gh", WAVES + (5500 if level == 500 else 1400)), ("t", 250 + WAVES), ("cc", 0.5 + 0.4 * WAVES - level / 100))]
        fields += [("orog", "surface", 0, 100 * WAVES, {"dataDate": 20200101}), ("2t", "heightAboveGround", 2, 280 + WAVES, {"dataDate": 20200101})]
        return write_grib(self.path, fields, keys, **more)

    def test_variables_levels_times_and_places(self):
        for sample in ("GRIB1", "GRIB2"):
            with self.subTest(sample=sample):
                self.forecast(sample=sample)
                dataset = nephoscope.open(self.path)
                self.assertEqual(dict(dataset.t.sizes), {"time": 2, "isobaricInhPa": 2, "latitude": 17, "longitude": 36})
                np.testing.assert_allclose(dataset.latitude, np.arange(80, -81, -10))
                np.testing.assert_allclose(dataset.t.sel(isobaricInhPa=850).isel(time=1).values.ravel(), 258.5 + WAVES, atol=1e-3)
                self.assertEqual(dataset.t2m.dims, ("time", "latitude", "longitude"))
                grid = dataset.nephoscope.globe(time="2020-01-02")
                self.assertEqual(set(grid.point_data) - {"vtkGhostType"}, {"gh", "t", "cc", "Height", "BelowGround"})

    def test_single_points_and_fields(self):
        """Any selection, down to one value, equals that part of the whole field."""
        self.forecast()
        dataset = nephoscope.open(self.path)
        for field in (dataset.t, dataset.t2m.isel(time=0), dataset.orog):
            whole = field.values
            for index in ({"latitude": 3, "longitude": 5}, {"latitude": 3}, {"latitude": slice(0, 0)}, {"latitude": slice(2, 3), "longitude": 5}):
                key = tuple(index.get(dim, slice(None)) for dim in field.dims)
                np.testing.assert_array_equal(field.isel(index).values, whole[key])
            np.testing.assert_array_equal(field.isel({dim: 1 for dim in field.dims}).values, whole[(1,) * field.ndim])

    def test_nothing_is_decoded_that_is_not_drawn(self):
        self.forecast()
        with mock.patch.object(grib, "decode", wraps=grib.decode) as decode:
            dataset = nephoscope.open(self.path)
            self.assertEqual(decode.call_count, 0)
            dataset.nephoscope.globe(time=0, variables=["t"], terrain=False)
            self.assertEqual(sorted((call.args[1].variable[0], call.args[1].level) for call in decode.call_args_list), [("gh", 500), ("gh", 850), ("t", 500), ("t", 850)])

    def test_winds_along_a_lambert_grid(self):
        levels, pressures = (850, 500), (1500.0, 5500.0)
        lat, lon = (a.reshape(40, 60) for a in write_grib(self.path, [("gh", "isobaricInhPa", 500, 1.0)], LAMBERT))
        wind, east, north = rotation(lon, lat)
        u, v = along_rows(lon, lat, east, north)
        write_grib(self.path, [f for level, z in zip(levels, pressures) for f in (("u", "isobaricInhPa", level, u), ("v", "isobaricInhPa", level, v), ("gh", "isobaricInhPa", level, z))],
                   LAMBERT)
        dataset = nephoscope.open(self.path)
        self.assertIn("lambert", dataset.nephoscope.describe())
        grid = dataset.nephoscope.globe()
        got = np.asarray(grid["Wind"]).reshape(2, 40, 60, 3)
        # The places are eccodes' own; their rows give the direction but for the differences' error, some 1e-5.
        np.testing.assert_allclose(got[0][:, 2:-2], wind[:, 2:-2], atol=0.005)
        points = grid.points.reshape(2, 40, 60, 3)[1]
        height = RADIUS * 5500 / (RADIUS - 5500)
        np.testing.assert_allclose(points, (6371000 + height) * frames(lon, lat)[2], atol=2.0)

    def test_geopotential_in_metres(self):
        write_grib(self.path, [("z", "isobaricInhPa", level, z * GRAVITY) for level, z in ((500, 5500.0), (850, 1500.0))], REGULAR)
        heights = nephoscope.open(self.path).nephoscope.globe(close_seam=False, close_poles=False)["Height"].reshape(2, -1)
        np.testing.assert_allclose(heights[:, 5], RADIUS * np.array([1500, 5500]) / (RADIUS - np.array([1500, 5500])), rtol=1e-6)

    def test_missing_values_and_missing_levels_stay_missing(self):
        holes = np.where(np.arange(WAVES.size) % 5, WAVES, np.nan)
        write_grib(self.path, [("gh", "isobaricInhPa", level, z) for level, z in ((500, 5500), (700, 3000), (850, 1400))] + [
            ("cc", "isobaricInhPa", 500, holes), ("cc", "isobaricInhPa", 850, 0.5)], REGULAR)
        cover = nephoscope.open(self.path).cc.values
        self.assertEqual(np.isnan(cover[0]).sum(), np.isnan(holes).sum())
        self.assertTrue(np.isnan(cover[1]).all() and (cover[2] == 0.5).all())

    def test_as_cfgrib_reads_it(self):
        import xarray
        self.forecast()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            theirs = xarray.open_dataset(self.path, engine="cfgrib", backend_kwargs={"indexpath": "", "filter_by_keys": {"typeOfLevel": "isobaricInhPa"}})
        ours = nephoscope.open(self.path)
        np.testing.assert_array_equal(theirs.gh.sortby("isobaricInhPa"), ours.gh)
        np.testing.assert_allclose(theirs.nephoscope.globe(time=1).points, ours.nephoscope.globe(time=1).points)

    def winds_in_one_message(self):
        """u and v of a level share a message, as in NCEP's files; the next message is a height."""
        import eccodes as ec
        single = Path(self.folder.name, "single.grib2")
        fields = {"u": 10 + WAVES, "v": -20 + WAVES}
        with self.path.open("wb") as out:
            for level in (500, 850):
                write_grib(single, [(name, "isobaricInhPa", level, values + level / 100) for name, values in fields.items()], REGULAR)
                both = ec.codes_grib_multi_new()
                with single.open("rb") as file:
                    while (handle := ec.codes_grib_new_from_file(file)) is not None:
                        ec.codes_grib_multi_append(handle, 4, both)
                        ec.codes_release(handle)
                ec.codes_grib_multi_write(both, out)
                ec.codes_grib_multi_release(both)
                write_grib(single, [("gh", "isobaricInhPa", level, 5500 + WAVES)], REGULAR)
                out.write(single.read_bytes())
        return fields

    def test_several_fields_in_one_message(self):
        """Each is read, also after cfgrib, which xarray asks about every file, has switched that off; from several threads at once too."""
        import eccodes as ec
        fields = self.winds_in_one_message()
        dataset = nephoscope.open(self.path)
        ec.codes_grib_multi_support_off()
        cases = [(name, level) for name in fields for level in (500, 850)] * 10
        with ThreadPoolExecutor(4) as threads:
            for (name, level), read in zip(cases, threads.map(lambda case: dataset[case[0]].sel(isobaricInhPa=case[1]).values, cases)):
                np.testing.assert_allclose(read.ravel(), fields[name] + level / 100, atol=1e-3)

    def test_a_level_beside_layers_of_unknown_kinds(self):
        """One level of a field is drawn, whatever levels other fields of the file have."""
        layers = [(name, "heightAboveGroundLayer", level, 50.0 + WAVES) for name, level in (("hlcy", 1000), ("hlcy", 3000))]
        write_grib(self.path, [("gh", "isobaricInhPa", level, WAVES + 11 * level) for level in (500, 850)] + layers, REGULAR)
        dataset = nephoscope.open(self.path).sel(isobaricInhPa=500)
        self.assertIn("heightAboveGroundLayer", dataset.dims)
        plotter = dataset.nephoscope.plot("gh", screenshot=str(self.path.with_suffix(".png")), window_size=(100, 100))
        self.addCleanup(plotter.close)
        self.assertEqual({range_ for actor in plotter.renderer.actors.values() if getattr(getattr(actor, "mapper", None), "array_name", None) == "gh"
                          for range_ in [tuple(np.round(actor.mapper.scalar_range))]}, {(5499, 5501)})

    def test_one_level_beside_layers(self):
        """As NCEP's models write them, with layers above the ground that have no place in the vertical; of these the first with values is drawn."""
        layers = [("t", "pressureFromGroundLayer", level, 280.0 + WAVES) for level in (3000, 6000)] + [("r", "pressureFromGroundLayer", level, 50 + 30 * WAVES) for level in (6000, 9000)]
        layers += [("hlcy", "heightAboveGroundLayer", level, 50.0 + WAVES) for level in (1000, 3000)]
        fields = [("gh", "isobaricInhPa", level, WAVES + 11 * level) for level in (500, 850, 1000)]
        write_grib(self.path, [*fields, *layers, ("2t", "heightAboveGround", 2, 280 + WAVES), ("prmsl", "meanSea", 0, 1e5 + 1000 * WAVES)], LAMBERT | {"Nx": 36, "Ny": 17})
        dataset = nephoscope.open(self.path)
        ranges = {"t2m": (279, 281), "prmsl": (99000, 101000), "r": (0, 80)}
        for name, wanted in ranges.items():
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                plotter = dataset.nephoscope.plot(name, screenshot=str(self.path.with_suffix(".png")), window_size=(100, 100))
            self.addCleanup(plotter.close)
            np.testing.assert_allclose(plotter.scalar_bars[name].GetLookupTable().GetRange(), wanted, rtol=2e-3)
            told = [str(one.message) for one in told if "layers" in str(one.message)]
            self.assertEqual(bool(told), name == "r", told)
        self.assertIn("'pressureFromGroundLayer' has 3 layers, which may overlap. The first with values is used, number 1 (6000). Choose one: ds.isel(pressureFromGroundLayer=1).", told)

    def test_a_file_that_has_changed(self):
        self.winds_in_one_message()
        dataset = nephoscope.open(self.path)
        self.path.write_bytes(b"\n" * 10 + self.path.read_bytes())
        with self.assertRaisesRegex(grib.GribError, "has changed since it was opened: open it again"):
            dataset.v.values

    def test_truncated_file(self):
        self.forecast()
        whole = self.path.read_bytes()
        self.path.write_bytes(whole[:len(whole) - 700])
        with self.assertRaisesRegex(ValueError, "after 13 complete fields, the file ends early.*grib_copy"):
            nephoscope.open(self.path)

    def test_several_grids(self):
        self.forecast()
        write_grib(self.path, [("sp", "surface", 0, 1.0)], LAMBERT, mode="ab")
        with self.assertRaisesRegex(ValueError, r"2 grids.*0: regular_ll, 14 fields \(gh, t, cc, orog, 2t\); 1: lambert"):
            nephoscope.open(self.path)
        self.assertEqual(nephoscope.open(self.path, grid=1).sizes["x"], 60)

    def test_scanning_modes(self):
        lat, lon = self.forecast()
        for keys in ({"jScansPositively": 1, "latitudeOfFirstGridPointInDegrees": -80, "latitudeOfLastGridPointInDegrees": 80},
                     {"iScansNegatively": 1, "longitudeOfFirstGridPointInDegrees": 350, "longitudeOfLastGridPointInDegrees": 0}, {"jPointsAreConsecutive": 1}):
            lat, lon = write_grib(self.path, [("gh", "isobaricInhPa", 500, 0.0)], {**REGULAR, **keys})
            values = lat + lon / 1000
            write_grib(self.path, [("gh", "isobaricInhPa", level, values) for level in (500, 850)], {**REGULAR, **keys})
            dataset = nephoscope.open(self.path)
            np.testing.assert_allclose(dataset.gh[0], dataset.latitude + dataset.longitude / 1000, atol=1e-3)


if __name__ == "__main__":
    unittest.main()
