# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Derived quantities against closed forms and published values."""
import tempfile
import unittest
import warnings

import nephoscope  # noqa: F401
import numpy as np
import xarray as xr
from weather_data import AXIS, GAS, GRAVITY, RADIUS, frames, isothermal, rotation

LON, LAT = np.arange(0, 360, 2.0), np.arange(-84, 85, 2.0)


def moist(temperature=300.0, **more):
    dataset = isothermal(LON, LAT, pressures=(100000.0, 85000, 70000), temperature=temperature)
    for name, (value, standard) in more.items():
        dataset[name] = (dataset.ta.dims, np.full(dataset.ta.shape, value), {"standard_name": standard, "units": "1"})
    return dataset


def derived(dataset, name, **options):
    grid = dataset.nephoscope.globe(derive=name, close_seam=False, close_poles=False, **options)
    return np.asarray(grid.point_data[name]).reshape(grid.dimensions[::-1])


class Derived(unittest.TestCase):
    def test_temperatures(self):
        dataset = moist(hus=(0.012, "specific_humidity"))
        np.testing.assert_allclose(derived(dataset, "potential_temperature")[:, 5, 5], 300 * (1e5 / dataset.plev.values) ** 0.2857, rtol=1e-4)
        # Bolton 1980, equations 24 and 39, from his own steps at 850 hPa: r = 12.146 g/kg, e = 16.28 hPa, TL by his equation 21.
        ratio = 12 / 0.988
        vapour = 850 * ratio / (622 + ratio)
        condensation = 2840 / (3.5 * np.log(300) - np.log(vapour) - 4.805) + 55
        expected = 300 * (1000 / (850 - vapour)) ** 0.2857 * (300 / condensation) ** (0.28e-3 * ratio) * np.exp((3.036 / condensation - 0.00178) * ratio * (1 + 0.448e-3 * ratio))
        np.testing.assert_allclose(derived(dataset, "equivalent_potential_temperature")[1, 5, 5], expected, rtol=1e-3)

    def test_equivalent_potential_temperature_of_dry_air(self):
        """It meets the potential temperature as the vapour vanishes, and is never below it."""
        for humidity in (0.0, 1e-8, 1e-6, 1e-5, 1e-4, 0.01):
            dataset = moist(hus=(humidity, "specific_humidity"))
            above = derived(dataset, "equivalent_potential_temperature") - derived(dataset, "potential_temperature")
            self.assertGreaterEqual(above.min(), -1e-4, humidity)
            self.assertLess(above.max(), 1e-4 + 5e3 * humidity)

    def test_temperature_of_a_potential_temperature(self):
        """As that of WRF, on pressure levels and with a pressure array; also for light in clouds."""
        dataset = moist(temperature=260.0, clw=(1e-4, "mass_fraction_of_cloud_liquid_water_in_air"))
        theta = (dataset.ta * (1e5 / dataset.plev) ** 0.2857).assign_attrs(standard_name="air_potential_temperature", units="K").transpose(*dataset.ta.dims)
        dataset = dataset.drop_vars("ta").assign(th=theta).isel(lon=slice(0, 20), lat=slice(40, 60))
        np.testing.assert_allclose(derived(dataset, "temperature"), 260, rtol=1e-4)
        with tempfile.TemporaryDirectory() as folder:
            plotter = dataset.nephoscope.plot("clw", sun=(0, 0, 1), screenshot=f"{folder}/sun.png", window_size=(60, 60))
            plotter.close()
        self.assertIn("Extinction", nephoscope.cloud_optics(dataset).point_data)

    def test_humidity_and_cloud_fraction(self):
        dataset = moist(hur=(0.95, "relative_humidity"))
        np.testing.assert_allclose(derived(dataset, "relative_humidity"), 0.95, rtol=1e-6)
        np.testing.assert_allclose(derived(dataset, "cloud_fraction"), 1 - np.sqrt(0.05 / 0.2), rtol=1e-5)
        specific = moist(hus=(0.010, "specific_humidity"))
        # Saturation at 300 K is 35.3 hPa (tables of the World Meteorological Organization, 35.36).
        vapour = 1000 * 10 / 990 / (0.622 + 10 / 990)
        np.testing.assert_allclose(derived(specific, "relative_humidity")[0, 3, 3], vapour / 35.36, rtol=3e-3)
        own = moist(hur=(0.95, "relative_humidity"), cl=(0.3, "cloud_area_fraction_in_atmosphere_layer"))
        np.testing.assert_allclose(derived(own, "cloud_fraction"), 0.3, rtol=1e-6)

    def test_vorticity_and_speed_of_a_solid_rotation(self):
        lon, lat = np.meshgrid(LON, LAT)
        wind, east, north = rotation(lon, lat)
        dims = ("plev", "lat", "lon")
        dataset = moist().assign(ua=(dims, np.stack([east] * 3), {"units": "m/s"}), va=(dims, np.stack([north] * 3), {"units": "m/s"}))
        up = frames(lon, lat)[2]
        expected = 2 * 30.0 / RADIUS * up @ AXIS
        np.testing.assert_allclose(derived(dataset, "vorticity")[0][1:-1], expected[1:-1], atol=0.005 * 60 / RADIUS)
        np.testing.assert_allclose(derived(dataset, "wind_speed")[0], np.linalg.norm(wind, axis=-1), rtol=1e-5)

    def test_cloud_content_and_columns(self):
        dataset = moist(temperature=260.0, clw=(1e-4, "mass_fraction_of_cloud_liquid_water_in_air"), cli=(2e-4, "mass_fraction_of_cloud_ice_in_air"))
        expected = 3e-4 * dataset.plev.values / (GAS * 260)
        np.testing.assert_allclose(derived(dataset, "cloud_content")[:, 4, 4], expected, rtol=1e-4)
        column = dataset.nephoscope.column(projection="map")
        self.assertEqual(column.dimensions[2], 1)
        np.testing.assert_allclose(np.asarray(column["column"]), 3e-4 * (102000 - 70000) / GRAVITY, rtol=1e-5)  # from the ground to the uppermost level

    def test_the_usual_water_of_a_cloud_fraction(self):
        """Without cloud water, it is 0.21 g/m3 at sea level, less by a factor e every 2281 m, times the fraction (Hack 1998), as for lit clouds. A warning says so."""
        dataset = moist(temperature=260.0, cl=(0.5, "cloud_area_fraction_in_atmosphere_layer"))
        with self.assertWarnsRegex(UserWarning, "There is no cloud water, but a cloud fraction, 'cl'.*Hack 1998"):
            mesh = dataset.nephoscope.globe(derive="cloud_content")
        np.testing.assert_allclose(np.asarray(mesh["cloud_content"]), 0.5 * 0.21e-3 * np.exp(-np.asarray(mesh["Height"]).clip(0) / (700 * np.log(26))), rtol=1e-4)
        self.assertEqual(str(mesh.field_data["cloud_content_units"][0]), "kg m-3")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            lit, other = nephoscope.cloud_optics(mesh, water="cloud_content"), nephoscope.cloud_optics(dataset.nephoscope.globe())
        np.testing.assert_allclose(np.asarray(lit["Extinction"]), np.asarray(other["Extinction"]), rtol=1e-3)

    def test_what_is_missing_is_named(self):
        with self.assertRaisesRegex(ValueError, r"relative_humidity needs specific humidity.*globe\(specific_humidity="):
            derived(moist(), "relative_humidity")
        with self.assertRaisesRegex(ValueError, "derive: 'thetae' not known.*'equivalent_potential_temperature'"):
            derived(moist(), "thetae")
        with self.assertRaisesRegex(ValueError, "cloud_content needs one of"):
            moist().nephoscope.column()
        with self.assertRaisesRegex(ValueError, r"wind_speed needs both.*globe\(u="):
            derived(xr.Dataset(moist()), "wind_speed")


if __name__ == "__main__":
    unittest.main()
