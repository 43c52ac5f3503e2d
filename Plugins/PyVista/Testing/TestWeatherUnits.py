# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Units as files have them: signs that are not ASCII, oktas and tenths, levels of an ocean that are counted downwards, and pressures of sea water."""
import os
import unittest
import warnings
from pathlib import Path

import numpy as np
import pyvista
import xarray as xr
from nephoscope.light import lit_surface
from nephoscope.reader import _axes_in_order
from nephoscope.weather.units import UnitsError, converted, plain, simple
from nephoscope.weather.vertical import depth_of_sea_pressure
from vtkmodules.vtkCommonCore import vtkStringArray

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
LONGITUDE = ("longitude", np.arange(0, 41, 5.0), {"units": "degrees_east"})
LATITUDE = ("latitude", np.arange(60, 29, -5.0), {"units": "degrees_north"})
PRESSURES = ("level", np.array([1000.0, 850, 500]), {"units": "hPa"})
RANDOM = np.random.default_rng(0).random((3, 7, 9))


def weather(name, values=RANDOM, level=PRESSURES, **attributes):
    dim = level[0]
    return xr.Dataset({name: ((dim, "latitude", "longitude"), values, attributes)}, {dim: level, "latitude": LATITUDE, "longitude": LONGITUDE})


def flat(name, z=("z", np.arange(0, 3000, 1000.0), {"units": "m"}), **attributes):
    metres = {"units": "m"}
    dim = z[0]
    return xr.Dataset({name: ((dim, "y", "x"), RANDOM, attributes)}, {dim: z, "y": ("y", 100 * np.arange(7.0), metres), "x": ("x", 100 * np.arange(9.0), metres)})


def sea(name, values, **attributes):
    """Water that is the warmer the higher it is, or as deep as its values say."""
    water = np.broadcast_to(np.arange(len(values), 0, -1.0)[:, None, None], (len(values), 7, 9))
    standard = attributes.pop("field", "sea_water_potential_temperature")
    return weather("thetao", water, (name, np.array(values, float), attributes), units="degC", **({"standard_name": standard} if standard else {}))


class Signs(unittest.TestCase):
    def test_in_ascii(self):
        for text, expected in (("°C", "degC"), ("µg m-3", "ug m-3"), ("\u03bcg m\u207b\u00b3", "ug m-3"), ("W/m²", "W/m2"), ("\u2103", "degC"), ("m·s⁻¹", "m.s-1"), ("kg m\u2212\u00b2", "kg m-2"),
                               ("Å", "A"), ("K", "K"), ("雨", "?")):
            self.assertEqual(simple(text), expected)

    def test_conversions_know_them(self):
        for units, quantity, value in (("°C", "temperature", 274.15), ("\u2103", "temperature", 274.15), ("m s⁻¹", "speed", 1), ("m²/s²", "geopotential", 1), ("kg\u00b7kg\u207b\u00b9", "mass fraction", 1)):
            self.assertAlmostEqual(float(converted(np.array([1.0]), units, quantity, "a")[0][0]), value)
        self.assertEqual(plain("W m⁻²"), "wm-2")

    def test_drawn_and_told(self):
        for made in (weather, flat):
            for name, attributes in (("t", {"units": "°C", "standard_name": "air_temperature"}), ("pm2p5", {"units": "µg m-3", "long_name": "Particules d'été"}), ("Température", {"units": "W/m²"})):
                data = made(name, **attributes)
                plotter = data.nephoscope.plot(name, screenshot=OUTPUT / "TestWeatherUnits.png", window_size=(200, 200))
                bar = next(iter(plotter.scalar_bars.values()))
                self.assertIn(f"[{attributes['units']}]", bar.GetTitle().replace("\n", " "))
                self.assertIn(f"({attributes['units']})" if made is flat or name == "t" else "grid", data.nephoscope.describe())
                self.assertTrue(str(data.nephoscope.mesh().field_data[f"{name}_units"][0]).isascii())
                plotter.close()

    def test_profiles_of_a_flat_grid(self):
        data = flat("qc", units="kg/kg").assign({"Température": ("z", np.array([290.0, 280, 270]), {"units": "°C", "standard_name": "air_temperature"})})
        self.assertIn("Température", data.nephoscope.mesh().array_names)

    def test_field_data_of_other_readers(self):
        """VTK's reader passes units as they are."""
        units = vtkStringArray()
        units.SetName("a_units")
        units.InsertNextValue("µg m⁻³")
        surface, turned = pyvista.Plane(), pyvista.RectilinearGrid([0.0, 1, 2], [0.0, 1], [0.0, 5])
        for mesh in (surface, turned):
            mesh.GetFieldData().AddArray(units)
        self.assertEqual(lit_surface(surface, (0, 0, 1))[0].field_data["a_units"][0], "µg m⁻³")
        self.assertEqual(_axes_in_order(turned, "(lev, lon, lat)").field_data["a_units"][0], "µg m⁻³")


class Parts(unittest.TestCase):
    def test_cloud_amounts_are_fractions(self):
        for units, most in (("okta", 8), ("oktas", 8), ("1/8", 8), ("tenths", 10)):
            for made in (lambda **kind: weather("cc", np.full((3, 7, 9), float(most)), **kind), lambda **kind: flat("cc", **kind) * 0 + most):
                data = made(units=units, standard_name="cloud_area_fraction_in_atmosphere_layer")
                data["cc"].attrs.update(units=units, standard_name="cloud_area_fraction_in_atmosphere_layer")
                mesh = data.nephoscope.mesh()
                np.testing.assert_allclose(mesh["cc"], 1)
                self.assertEqual(mesh.field_data["cc_units"][0], "1")
                self.assertIn(f"'cc': {units} converted to fractions of 1", data.nephoscope.describe())
        plotter = weather("cc", 8 * RANDOM, units="okta", standard_name="cloud_area_fraction_in_atmosphere_layer").nephoscope.plot(screenshot=OUTPUT / "TestWeatherUnits.png", window_size=(200, 200))
        self.assertEqual(next(iter(plotter.scalar_bars.values())).GetTitle().count("okta"), 0)
        plotter.close()

    def test_percent_under_other_units(self):
        """A cloud fraction with units of 1 that reaches 100 is percent; others and those slightly above 1 stay."""
        told = r"'cc' has the units '1', but values up to 100: they are taken as percent. Set its units: ds\['cc'\].attrs\['units'\] = '%'"
        dataset = weather("cc", 100 * RANDOM / RANDOM.max(), units="1")
        with self.assertWarnsRegex(UserWarning, told):
            grid = dataset.nephoscope.globe()
        self.assertAlmostEqual(grid["cc"].max(), 1, places=6)
        with self.assertWarnsRegex(UserWarning, told):
            np.testing.assert_allclose(dataset.nephoscope.globe(derive="cloud_fraction")["cloud_fraction"].max(), 1, rtol=1e-6)
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            self.assertRegex(dataset.nephoscope.describe(), "note: " + told)
            for name, factor, units in (("cc", 1.02, "1"), ("cc", 100, "%"), ("mixed", 100, "1")):
                self.assertAlmostEqual(weather(name, factor * RANDOM / RANDOM.max(), units=units).nephoscope.globe()[name].max(), factor, places=4)

    def test_units_that_the_values_contradict(self):
        """A warning tells the units that they seem to have, once; the units are used as they are. Differences, other planets and the upper atmosphere cause no warning."""
        shape = np.linspace(0, 1, RANDOM.size).reshape(RANDOM.shape)
        cases = (("t", 190 + 120 * shape, "C", "K"), ("t", 90 * shape - 70, "K", "degC"), ("r", 100 * shape, "1", "%"), ("q", 20 * shape, "kg/kg", "g kg-1"), ("theta", 400 - 700 * shape, "K", None),
                 ("t", 190 + 120 * shape, "K", None), ("t", 90 * shape - 70, "degC", None), ("t", 200 + 1500 * shape, "K", None), ("t", 40 * shape - 20, "K", None), ("theta", 280 + 2000 * shape, "K", None), ("r", 1.3 * shape, "1", None),
                 ("r", 120 * shape, "%", None), ("q", 0.02 * shape, "1", None), ("q", 1e-5 * shape, "g/kg", None))
        for name, values, units, better in cases:
            with self.subTest(name=name, units=units, better=better), warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                data = weather(name, values, units=units)
                data[name][0, 0, 0] = -9999
                data.nephoscope.globe(derive="temperature" if name == "t" else ())
                text = [str(one.message) for one in told if "seem to be in" in str(one.message)]
                self.assertEqual(len(text), better is not None, text)
                if better:
                    self.assertRegex(text[0], rf"^'{name}' has the units '{units}', but values from .* which are not plausible for .* in these units: they seem to be in {better}. Set its units: ds\['{name}'\].attrs\['units'\] = '{better}'.$")
                    self.assertIn("seem to be in", data.nephoscope.describe())
                    data[name].attrs["units"] = better
                    self.assertNotIn("seem to be in", data.nephoscope.describe())
        ground = weather("t", 250 + shape, units="K").assign(sp=(("latitude", "longitude"), 95000 + 6000 * shape[0], {"units": "hPa"}))
        for units, better in (("hPa", "Pa"), ("Pa", None)):
            ground.sp.attrs["units"] = units
            self.assertEqual("they seem to be in Pa" in ground.nephoscope.describe(), better is not None)
        mars = ground.assign(sp=(ground.sp / 160).assign_attrs(units="Pa"))
        self.assertNotIn("seem to be in", mars.nephoscope.describe())

    def test_series(self):
        data = xr.concat([weather("cc", np.full((3, 7, 9), value), units="okta") for value in (8.0, 4.0)], "time").assign_coords(time=[0, 1])
        series = data.nephoscope.series()
        self.assertEqual(series.range("cc"), (0.5, 1.0))
        series.close()

    def test_decametres_and_miles(self):
        heights = np.array([10.0, 150, 550])[:, None, None] * np.ones((3, 7, 9))
        for name, units in (("z", "dam"), ("z", "gpdm"), ("gh", "dam")):
            mesh = weather(name, heights, units=units).nephoscope.globe()
            self.assertAlmostEqual(float(mesh["Height"].max()), 5505, delta=2)
        winds = weather("u", np.full((3, 7, 9), 10.0), units="mph", standard_name="eastward_wind")
        winds["v"] = winds["u"] * 0
        winds["v"].attrs.update(units="mph", standard_name="northward_wind")
        np.testing.assert_allclose(np.linalg.norm(winds.nephoscope.globe()["Wind"], axis=1), 4.4704, rtol=1e-5)


class Sea(unittest.TestCase):
    def ends(self, data):
        """Heights of the first and the last level of the file."""
        mesh = data.nephoscope.mesh(vertical_exaggeration=1)
        heights = mesh["Height"] if "Height" in mesh.point_data else mesh.points[:, 2]
        return tuple(float(heights[np.argmax(order)]) for order in (mesh["thetao"], -mesh["thetao"]))

    def test_depths_without_a_direction(self):
        for name, values, attributes in (
                ("depth", (5, 100, 4000), {"units": "m"}), ("depth", (5, 100, 4000), {}), ("deptht", (5, 100, 4000), {"units": "m"}), ("z_t", (500, 10000, 400000), {"units": "centimeters"}),
                ("st_ocean", (5, 100, 4000), {"units": "meters"}), ("lev", (5, 100, 4000), {"units": "m", "standard_name": "depth"}), ("lev", (5, 100, 4000), {"units": "m"}),
                ("z", (5, 100, 4000), {"units": "m", "long_name": "depth of the level", "field": None}), ("level", (5, 100, 4000), {"units": "m", "field": "northward_sea_water_velocity"}),
                ("depth", (5, 100, 4000), {"units": "m", "positive": "down", "field": None}), ("depth", (-5, -100, -4000), {"units": "m", "positive": "up"}), ("depth", (-5, -100, -4000), {"units": "m"})):
            with self.subTest(name, **attributes):
                first, last = self.ends(sea(name, values, **attributes))
                self.assertAlmostEqual(first, -5, places=3)
                self.assertAlmostEqual(last, -4000, places=1)
        self.assertIn("'depth' has no units and is used as m", sea("depth", (5, 100, 4000)).nephoscope.describe())

    def test_lengths_without_a_direction_are_told(self):
        told = "'{}' has no attribute 'positive': its values are taken as heights. For depths set ds['{}'].attrs['positive'] = 'down'"
        for name, attributes, ambiguous in (("z", {}, True), ("lev", {}, True), ("z", {"positive": "up"}, False), ("height", {}, False), ("lev", {"long_name": "altitude of the level"}, False)):
            with self.subTest(name, **attributes):
                described = sea(name, (5, 100, 4000), **{"units": "m", "field": None, **attributes}).nephoscope.describe()
                self.assertEqual(told.format(name, name) in described, ambiguous)

    def test_heights_stay(self):
        for name, attributes in (("z", {}), ("height", {}), ("z_t", {}), ("depth", {"positive": "up"}), ("lev", {"positive": "up", "field": "sea_water_salinity"})):
            self.assertGreater(self.ends(sea(name, (5, 100, 4000), **{"units": "m", "field": None, **attributes}))[1], 3999)

    def test_pressure_of_sea_water(self):
        self.assertAlmostEqual(float(depth_of_sea_pressure(np.array(10000.0))), 9712.653, delta=14)  # UNESCO's check value, at 30 degrees
        self.assertAlmostEqual(float(depth_of_sea_pressure(np.array(10.0))), 9.92, delta=0.01)
        for name, units, scale, attributes in (("PRES", "dbar", 1, {"standard_name": "sea_water_pressure"}), ("pressure", "decibar", 1, {"field": None}),
                                               ("lev", "Pa", 1e4, {"standard_name": "sea_water_pressure"}), ("PRES", "dbar", 1, {"standard_name": "sea_water_pressure", "axis": "Z", "positive": "down"})):
            data = sea(name, scale * np.array([5.0, 100, 2000]), units=units, **attributes)
            first, last = self.ends(data)
            self.assertAlmostEqual(first, -4.96, delta=0.01)
            self.assertAlmostEqual(last, -1974, delta=1)
            self.assertIn("depths from the pressure of sea water", data.nephoscope.describe())

    def test_flat(self):
        for attributes in ({"units": "m"}, {"units": "m", "positive": "down"}, {}):
            data = flat("a", ("depth", np.array([5.0, 100, 4000]), attributes))
            self.assertEqual(data.nephoscope.mesh().bounds[4:], (-4000, -5))
        self.assertEqual(flat("a").nephoscope.mesh().bounds[4:], (0, 2000))


class WithoutUnits(unittest.TestCase):
    """A variable whose units cannot be converted hinders only the pictures and quantities that need it."""

    def setUp(self):
        self.wind, self.cold = np.full((3, 7, 9), 8.0), np.full((3, 7, 9), -20.0)
        sizes, metres = ("level", "latitude", "longitude"), {"units": "m s-1"}
        self.dataset = weather("cc", units="1").assign(t=(sizes, self.cold), u=(sizes, self.wind, metres), v=(sizes, 0 * self.wind, metres), qc=(sizes, 7 + RANDOM))

    def test_others_are_drawn(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            grid = self.dataset.nephoscope.globe(variables=["cc"], derive="wind_speed")
        np.testing.assert_allclose(grid["wind_speed"], 8, rtol=1e-6)
        np.testing.assert_array_equal(grid["cc"], np.float32(self.dataset.cc.values[:, ::-1]).ravel())
        picture = self.dataset.nephoscope.plot("cc", screenshot=str(OUTPUT / "without_units.png"), window_size=(200, 200))
        self.assertGreater(np.ptp(picture.screenshot(return_img=True)), 100)

    def test_it_is_told(self):
        told = self.dataset.nephoscope.describe()
        self.assertIn("temperature: 't', left out", told)
        self.assertRegex(told, "note: 't' is left out. 't' has no units, and its values, -20 to -20, are not plausible for temperature in K")
        self.assertIn("heights: ", told)
        with self.assertWarnsRegex(UserWarning, "'t' is left out. 't' has no units"):
            self.assertNotIn("t", self.dataset.nephoscope.globe().point_data)

    def test_it_is_an_error_where_it_is_needed(self):
        draw = self.dataset.nephoscope
        for what in (lambda: draw.globe(variables=["t"]), lambda: draw.globe(temperature="t"), lambda: draw.plot("t"), lambda: draw.globe(derive="potential_temperature"),
                     lambda: self.dataset[["t"]].nephoscope.globe()):
            self.assertRaisesRegex(UnitsError, "'t' has no units.*not plausible for temperature in K", what)
        whole = self.dataset.assign(t=weather("t", 250 + 0 * RANDOM, units="K").t, ql=weather("ql", RANDOM, units="kg kg-1").ql)
        whole = whole.rename(qc="ciwc")
        self.assertRaisesRegex(UnitsError, "'ciwc' has no units", lambda: whole.nephoscope.globe(derive="cloud_content"))  # no sum of a part

    def test_wind(self):
        dataset = self.dataset.drop_vars("t").assign(u=self.dataset.u.drop_attrs() + 1e4)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertNotIn("Wind", dataset.nephoscope.globe(variables=["cc"]).point_data)
        self.assertRaisesRegex(UnitsError, "'u' has no units", lambda: dataset.nephoscope.globe(derive="wind_speed"))

    def test_wind_of_a_flat_grid(self):
        dataset = flat("q", units="1")
        dataset = dataset.assign(u=dataset.q.drop_attrs() + 1e4, v=dataset.q.drop_attrs())
        with self.assertWarnsRegex(UserWarning, "The array Wind is left out. 'u' has no units"):
            self.assertEqual(set(dataset.nephoscope.grid().point_data), {"q", "u", "v"})
        self.assertRaisesRegex(UnitsError, "'u' has no units", lambda: dataset.nephoscope.grid(derive="wind_speed"))


if __name__ == "__main__":
    unittest.main()
