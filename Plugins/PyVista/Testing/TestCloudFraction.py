# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds of which only the fraction is known, in the sun: their extinction in closed form, and pictures with bright clouds and their shadows on the Earth."""
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from TestWeatherMeshes import icon

HEIGHTS = np.array([500.0, 1500, 3000, 6000, 9000])
SIZES = (5, 21, 21)


def forecast(unit="1", whole=1.0, step=0.5, warm=True):
    """Overcast between 1.5 and 3 km in the middle, 0.4 beside it."""
    fraction = np.full(SIZES, 0.0)
    fraction[1:3, 6:15, 6:15] = 1.0
    fraction[1:3, 6:15, 16] = 0.4
    temperature = np.full(SIZES, 285.0)
    places = ("z", "lat", "lon")
    data = xr.Dataset({"cc": (places, whole * fraction, {"units": unit, "standard_name": "cloud_area_fraction_in_atmosphere_layer"}), "t": (places, temperature, {"units": "K", "standard_name": "air_temperature"})},
                      {"z": ("z", HEIGHTS, {"units": "m", "positive": "up", "standard_name": "altitude"}), "lat": ("lat", 20 + step * np.arange(21), {"units": "degrees_north"}),
                       "lon": ("lon", 10 + step * np.arange(21), {"units": "degrees_east"})})
    return data if warm else data.drop_vars("t")


class CloudFraction(unittest.TestCase):
    def test_extinction(self):
        """The content of Hack (1998) in clouds of droplets of 10 micrometres, times the fraction; in exaggerated space the optical depth stays."""
        expected = 1.5 * 0.21e-3 * np.exp(-HEIGHTS / (700 * np.log(26)))[:, None, None] / (1000 * 10e-6) * forecast().cc.values
        for unit, whole in (("1", 1.0), ("%", 100.0), ("tenths", 10.0)):
            for factor in (1, 25):
                mesh = forecast(unit, whole).nephoscope.globe(vertical_exaggeration=factor)
                with self.assertWarnsRegex(UserWarning, r"no cloud water, but a cloud fraction, 'cc'.*2\.3 km \(Hack 1998\)"):
                    found = nephoscope.cloud_optics(mesh, liquid_radius=10)
                np.testing.assert_allclose(np.reshape(found["Extinction"], SIZES) * factor, expected, rtol=0.01, atol=1e-9)
                self.assertFalse([name for name in found.array_names if name.startswith("Nephoscope")])

    def test_without_temperature(self):
        """Then it is that of the standard atmosphere: 5 °C at 1.5 km, without ice."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            cold, warm = (np.reshape(nephoscope.cloud_optics(data.nephoscope.globe(), liquid_radius=10)["Extinction"], SIZES) for data in (forecast(warm=False), forecast()))
        np.testing.assert_allclose(cold[1], warm[1], rtol=1e-3)

    def test_water_comes_first(self):
        data = forecast()
        data["clwc"] = data.cc.dims, 1e-4 * data.cc.values, {"units": "kg kg-1", "standard_name": "mass_fraction_of_cloud_liquid_water_in_air"}
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            found = nephoscope.cloud_optics(data.nephoscope.globe(), liquid_radius=10)
        self.assertLess(found["Extinction"].max(), 0.02)

    def test_ice_alone(self):
        data = forecast()
        data["ciwc"] = data.cc.dims, 1e-6 * data.cc.values, {"units": "kg kg-1", "standard_name": "mass_fraction_of_cloud_ice_in_air"}
        with tempfile.TemporaryDirectory() as folder:
            for sun, told in ((True, False), ({"ice": "none"}, True)):
                with warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    self.addCleanup(data.nephoscope.plot(sun=sun, screenshot=str(Path(folder, "picture.png")), window_size=(50, 50)).close)
                self.assertEqual(any("Hack" in str(one.message) for one in caught), told)

    def test_unstructured(self):
        """ICON's fraction on cells, which has this role by its name."""
        data = icon()
        data["clc"] = data["where"].dims, np.broadcast_to(np.array([0, 100.0, 0])[:, None], data["where"].shape), {"units": "%"}
        with tempfile.TemporaryDirectory() as folder, self.assertWarnsRegex(UserWarning, "Hack"):
            plotter = data.nephoscope.plot(sun=True, screenshot=str(Path(folder, "picture.png")), window_size=(50, 50))
        self.addCleanup(plotter.close)
        volume = next(actor for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Volume))
        self.assertGreater(np.max(volume.mapper.dataset["ScaledExtinction"]), 0)

    def test_from_the_humidity(self):
        data = forecast()
        data["r"] = data.cc.dims, 100 * data.cc.values, {"units": "%", "standard_name": "relative_humidity"}
        with tempfile.TemporaryDirectory() as folder, self.assertWarnsRegex(UserWarning, "Hack"):
            data.drop_vars("cc").nephoscope.plot("cloud_fraction", sun=True, screenshot=str(Path(folder, "picture.png")), window_size=(50, 50)).close()

    def test_flat_grids(self):
        axes = {letter: (letter, 100.0 * np.arange(count), {"units": "m"}) for letter, count in zip("zyx", (6, 5, 5))}
        data = xr.Dataset({"cloud_fraction": (("z", "y", "x"), np.ones((6, 5, 5)), {"units": "1"})}, axes)
        with self.assertWarnsRegex(UserWarning, "Hack 1998"):
            found = nephoscope.cloud_optics(data, liquid_radius=10)
        np.testing.assert_allclose(np.reshape(found["Extinction"], (6, 25))[:, 0], 1.5 * 0.21e-3 * np.exp(-100 * np.arange(6) / (700 * np.log(26))) / 1e-2, rtol=0.01)

    def test_pictures(self):
        """The overcast is bright, and its shadow lies on the Earth, away from the sun."""
        for options in ({}, {"projection": "map"}, {"background": "white"}):
            with self.subTest(options), tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
                warnings.simplefilter("ignore", UserWarning)
                path = Path(folder, "picture.png")
                plotter = forecast().nephoscope.plot("cc", sun=True, screenshot=str(path), window_size=(200, 200), **options)
                self.addCleanup(plotter.close)
                picture = pyvista.read(path)["PNGImage"].reshape(200, 200, -1)[..., :3].astype(float)
                (earth,) = [actor.mapper.dataset for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Actor) and "Shade" in actor.mapper.dataset.array_names]
                self.assertGreater(picture[80:120, 80:120].min(axis=-1).mean(), 150)
                shade = np.asarray(earth["Shade"], float)[:, 0]
                texture = np.asarray(earth.active_texture_coordinates)
                longitude, latitude = 360 * texture[:, 0] - 180, 180 * texture[:, 1] - 90
                below = (abs(longitude - 15) < 1.5) & (abs(latitude - 25) < 1.5)
                clear = (abs(longitude - 11) < 0.5) & (abs(latitude - 25) < 1.5)
                self.assertGreater(below.sum(), 20)
                self.assertLess(shade[below].mean(), 0.5 * shade[clear].mean())


if __name__ == "__main__":
    unittest.main()
