# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""GRIB files whose fields are on some of the levels or times of the others, and whose headers contradict themselves: what is drawn, and what is told."""
import tempfile
import unittest
import warnings
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from nephoscope.weather.flat import is_flat
from nephoscope.weather.grib import GribError
from weather_data import REGULAR, write_grib

LEVELS = (850, 700, 500, 400, 300)
HEIGHTS = {850: 1460.0, 700: 3010.0, 500: 5570.0, 400: 7180.0, 300: 9160.0}


class Gaps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name, "forecast.grib2")

    def drawn(self, name=None, **options):
        """The mesh that the plotter draws, and the warnings."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            plotter = nephoscope.open(self.path).nephoscope.plot(name, screenshot=str(self.path.with_suffix(".png")), window_size=(100, 100), **options)
        self.addCleanup(plotter.close)
        mesh = next(actor.mapper.dataset for actor in plotter.renderer.actors.values() if hasattr(actor, "mapper") and {"absv", "t2m", "msl"} & set(actor.mapper.dataset.array_names))
        return mesh, [str(one.message) for one in caught]

    def test_a_field_on_every_second_level(self):
        """No cell between neighbouring levels has values at all of its points: the cells between those levels that have are drawn."""
        fields = [("gh", "isobaricInhPa", level, height) for level, height in HEIGHTS.items()] + [("absv", "isobaricInhPa", level, 1e-4 * level) for level in LEVELS[::2]]
        write_grib(self.path, fields, REGULAR)
        for name in (None, "absv"):
            mesh, told = self.drawn(name)
            self.assertEqual(mesh.dimensions[2], 3)
            self.assertTrue(np.isfinite(np.asarray(mesh["absv"])).all())
            np.testing.assert_allclose(np.unique(np.rint(np.asarray(mesh["Height"]) / 10)), [146, 557, 917], atol=1)
            self.assertFalse([text for text in told if "Nothing is drawn" in text])

    def test_a_film_of_a_field_on_every_second_level(self):
        """It has the levels that `plot` draws, also if the field begins later or the plotter has other contents."""
        for first in (0, 1):
            steps = [{"dataDate": 20200101 + step} for step in range(3)]
            fields = [("gh", "isobaricInhPa", level, height, step) for step in steps for level, height in HEIGHTS.items()]
            write_grib(self.path, fields + [("absv", "isobaricInhPa", level, 1e-4 * level, step) for step in steps[first:] for level in LEVELS[::2]], REGULAR)
            for contents in (False, True):
                plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100))
                self.addCleanup(plotter.close)
                if contents:
                    plotter.add_mesh(pyvista.Sphere(radius=6e6))
                series = nephoscope.animate(plotter, nephoscope.open(self.path), "absv")
                self.addCleanup(series.close)
                self.assertEqual(series.mesh.dimensions[2], 3)
                series.show(1)
                self.assertTrue(np.isfinite(np.asarray(series.mesh["absv"])).all())

    def test_a_field_on_one_level_between_others(self):
        write_grib(self.path, [("gh", "isobaricInhPa", level, height) for level, height in HEIGHTS.items()] + [("absv", "isobaricInhPa", level, 1e-4) for level in (500,)], REGULAR)
        self.assertIsInstance(self.drawn("absv")[0], pyvista.DataSet)

    def test_a_field_that_begins_later(self):
        fields = [("msl", "surface", 0, 1e5, {"dataDate": 20200101})] + [("2t", "heightAboveGround", 2, 280.0 + step, {"dataDate": 20200101 + step}) for step in (1, 2)]
        write_grib(self.path, fields, REGULAR)
        mesh, told = self.drawn("t2m")
        np.testing.assert_allclose(np.asarray(mesh["t2m"]), 281, atol=1e-3)
        self.assertTrue([text for text in told if "'t2m' has no values at the first time: step 1 is drawn" in text])
        with self.assertRaisesRegex(ValueError, "no finite value"):
            self.drawn("t2m", time=0)

    def test_an_increment_that_contradicts_the_rows(self):
        write_grib(self.path, [("2t", "heightAboveGround", 2, 280.0)], {**REGULAR, "jDirectionIncrementInDegrees": 2})
        with self.assertWarnsRegex(UserWarning, "increment of latitudes in the header is not that of 17 rows from 80 to -80"):
            data = nephoscope.open(self.path)
        np.testing.assert_allclose(data.latitude, np.arange(80, -81, -10.0))

    def test_longitudes_of_a_region_across_greenwich(self):
        for longitudes, told in ((np.arange(-20, 21, 10) % 360, "-20 to 20"), (np.arange(170, 211, 10), "170 to 210"), ((np.arange(170, 211, 10) + 180) % 360 - 180, "170 to 210"),
                                 (np.arange(0, 360, 40), "0 to 320"), (np.arange(-180, 180, 10), "-180 to 170")):
            lon, lat = np.meshgrid(longitudes, np.arange(0, 41, 10.0))
            data = xr.Dataset({"q": (("y", "x"), 0.0 * lon)}, {"lon": (("y", "x"), lon, {"units": "degrees_east"}), "lat": (("y", "x"), lat + 0.1 * lon / 360, {"units": "degrees_north"})})
            self.assertIn(f"longitude {told} (", data.nephoscope.describe())

    def test_many_variables(self):
        """Whether x and y are lengths is found without looking at every variable for every other one."""
        axes = {"latitude": ("latitude", np.arange(3.0), {"units": "degrees_north"}), "longitude": ("longitude", np.arange(4.0), {"units": "degrees_east"})}
        data = xr.Dataset({f"v{number}": (("latitude", "longitude"), np.zeros((3, 4))) for number in range(100)}, axes)
        with mock.patch.object(xr.Dataset, "__getitem__", autospec=True, side_effect=xr.Dataset.__getitem__) as look:
            self.assertFalse(is_flat(data))
        self.assertLess(look.call_count, 1000)

    def test_grids_without_places(self):
        write_grib(self.path, [("2t", "heightAboveGround", 2, 280.0)], REGULAR)
        data = bytearray(self.path.read_bytes())
        section = data.index(b"\x00\x00\x00\x48\x03")  # the grid, 72 bytes
        data[section + 12:section + 14] = (32769).to_bytes(2, "big")
        self.path.write_bytes(data)
        with self.assertRaisesRegex(GribError, r"finds no longitudes and latitudes of this grid \(gridType .*wgrib2 forecast\.grib2 -new_grid"):
            nephoscope.open(self.path)


if __name__ == "__main__":
    unittest.main()
