# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that vary little within a level, such as the geopotential height: a first picture shows their departures from the mean."""
import tempfile
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from TestWeatherMeshes import LowestLevel as Meshes

LEVELS = np.array([925.0, 850, 500, 200])


def heights(lon, lat, names=("lat", "lon")):
    """Geopotential height: a wave of 100 m on heights that increase upwards and towards the equator. Also returns the wave."""
    east, north = np.meshgrid(lon, lat)
    wave = 100 * np.cos(np.radians(3 * east)) * np.cos(np.radians(north))
    level = 7000 * np.log(1013 / LEVELS)[:, None, None] * (1 - 0.1 * np.sin(np.radians(north)) ** 2)
    height = {"standard_name": "geopotential_height", "units": "gpm", "long_name": "Geopotential height"}
    return xr.Dataset({"gh": (("level", *names), level + wave, height)},
                      {"level": ("level", LEVELS, {"units": "hPa"}), names[0]: (names[0], lat, {"units": "degrees_north"}), names[1]: (names[1], lon, {"units": "degrees_east"})}), wave


class Departures(unittest.TestCase):
    def drawn(self, dataset, name="gh", **options):
        """The plotter, and the mesh whose volume it draws."""
        with tempfile.TemporaryDirectory() as folder:
            plotter = dataset.nephoscope.plot(name, screenshot=str(Path(folder, "a.png")), window_size=(200, 200), **options)
        self.addCleanup(plotter.close)
        return plotter, next(actor.mapper.dataset for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Volume))

    def title(self, plotter):
        return next(iter(plotter.scalar_bars.values())).GetTitle().replace("\n", " ")

    def test_waves_round_the_globe(self):
        """The zonal mean is subtracted, on a globe and on a map, at whatever longitude the data begin."""
        for lon in (np.arange(0, 360, 10.0), np.arange(-180, 180, 10.0)):
            dataset, wave = heights(lon, np.arange(90, -91, -5.0))
            for options in ({}, {"projection": "map"}):
                plotter, mesh = self.drawn(dataset, **options)
                found = np.asarray(mesh["gh"]).reshape(4, len(wave), -1)  # the wave is the same in both hemispheres
                self.assertAlmostEqual(np.abs(found).max(), 100, delta=3)
                self.assertLess(np.abs(np.sort(found[..., :36], axis=-1) - np.sort(wave, axis=-1)).max(), 8)  # means of bands of 5 degrees
                self.assertIn("minus zonal mean", self.title(plotter))
                self.assertIn("Geopotential height [", self.title(plotter).replace("(", "["))
                low, high = next(iter(plotter.scalar_bars.values())).GetLookupTable().GetRange()
                self.assertAlmostEqual(low, -high)

    def test_a_region(self):
        dataset, _ = heights(np.arange(20, 61, 5.0), np.arange(20, 61, 5.0))
        plotter, mesh = self.drawn(dataset)
        np.testing.assert_allclose(np.asarray(mesh["gh"]).reshape(4, -1).mean(axis=1), 0, atol=1e-2)
        self.assertIn("minus level mean", self.title(plotter))

    def test_missing_values(self):
        """They stay missing, and a level without any value is left out."""
        dataset, _ = heights(np.arange(20, 61, 5.0), np.arange(20, 61, 5.0))
        dataset["gh"][1], dataset["gh"][2, :3] = np.nan, np.nan
        _, mesh = self.drawn(dataset)
        values = np.asarray(mesh["gh"]).reshape(3, 9, 9)
        self.assertEqual(list(np.isnan(values).sum(axis=(1, 2))), [0, 27, 0])
        self.assertAlmostEqual(float(np.nanmean(values[1])), 0, delta=1e-2)

    def test_unstructured(self):
        for name, dataset in Meshes().datasets().items():
            with self.subTest(name):
                (level,) = [dim for dim in dataset["where"].dims if dataset.sizes[dim] == 3]
                up = xr.DataArray([100.0, 5000, 9000], dims=level)
                plotter, mesh = self.drawn(dataset.assign(gh=(dataset["where"] * 0 + up).assign_attrs(units="m", standard_name="geopotential_height")), clim=(0, 9000))
                self.assertEqual(float(np.nanmax(mesh["gh"])), 9000)  # a range asks for the values
                noise = xr.DataArray(np.cos(np.arange(dataset["where"].size)).reshape(dataset["where"].shape), dims=dataset["where"].dims)
                plotter, mesh = self.drawn(dataset.assign(gh=(noise + up).assign_attrs(units="m", standard_name="geopotential_height")))
                self.assertLess(np.nanmax(np.abs(mesh["gh"])), 2.1)
                self.assertIn("minus zonal mean", self.title(plotter))

    def test_pressure_on_a_flat_grid(self):
        z, y, x = np.meshgrid(np.arange(0, 3000, 300.0), np.arange(0, 4000, 400.0), np.arange(0, 4000, 400.0), indexing="ij")
        data = xr.Dataset({"p": (("z", "y", "x"), 1e5 * np.exp(-z / 8000) + np.sin(x / 500), {"units": "Pa", "standard_name": "air_pressure"})},
                          {name: (name, np.unique(values), {"units": "m"}) for name, values in zip("zyx", (z, y, x))})
        plotter, mesh = self.drawn(data, "p")
        self.assertLess(np.abs(mesh["p"]).max(), 2)
        self.assertIn("minus level mean", self.title(plotter))

    def test_sections(self):
        """The zonal mean is subtracted along a latitude, and the mean of each level along a longitude; in films too."""
        dataset, _ = heights(np.arange(0, 360, 10.0), np.arange(90, -91, -5.0))
        for section, words in ((dataset.sel(lat=40), "minus zonal mean"), (dataset.sel(lon=40), "minus level mean")):
            with tempfile.TemporaryDirectory() as folder:
                plotter = section.nephoscope.plot("gh", screenshot=str(Path(folder, "a.png")), window_size=(200, 200))
            self.addCleanup(plotter.close)
            self.assertIn(words, self.title(plotter))
            low, high = next(iter(plotter.scalar_bars.values())).GetLookupTable().GetRange()
            self.assertAlmostEqual(-low, high)
            self.assertLess(high, 1000)
            film = pyvista.Plotter(off_screen=True, window_size=(60, 60))
            self.addCleanup(film.close)
            with nephoscope.animate(film, xr.concat([section, section], "time").assign_coords(time=np.array(["2020-01-01", "2020-01-02"], "M8[ns]")), "gh") as series:
                self.assertIn(words, self.title(film))
                self.assertAlmostEqual(np.abs(series.range("gh")).max(), high, delta=1)

    def test_where_the_values_are_asked_for(self):
        dataset, _ = heights(np.arange(0, 360, 10.0), np.arange(90, -91, -5.0))
        for options in ({"opacity": "linear"}, {"contours": 3}, {"clim": (0, 12000)}, {"cmap": "viridis"}):
            plotter, mesh = self.drawn(dataset, **options)
            np.testing.assert_allclose(np.nanmax(mesh["gh"]), float(dataset.gh.max()), rtol=1e-6)
            self.assertNotIn("mean", self.title(plotter))

    def test_films(self):
        """Each step has its own mean subtracted; the range is that of all steps."""
        first, wave = heights(np.arange(0, 360, 10.0), np.arange(90, -91, -5.0))
        data = xr.concat([first, first.assign(gh=(first.gh + 50 + wave).assign_attrs(first.gh.attrs))], "time").assign_coords(time=np.array(["2020-01-01", "2020-01-02"], "M8[ns]"))
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        series = nephoscope.animate(plotter, data, "gh")
        self.addCleanup(series.close)
        self.assertAlmostEqual(np.abs(series.mesh["gh"]).max(), 100, delta=3)
        series.show(1)
        self.assertAlmostEqual(np.abs(series.mesh["gh"]).max(), 200, delta=6)
        self.assertIn("minus zonal mean", self.title(plotter))


if __name__ == "__main__":
    unittest.main()
