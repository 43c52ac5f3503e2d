#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cloud Optics: extinction and optical depth by hand, units, pressure, exaggeration, cells, what is wrong."""
import itertools
import os
import unittest

import numpy as np
from nephoscope import vtkCloudOptics, vtkGlobeGrid
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

ARRAYS = ("Extinction", "SingleScatteringAlbedo", "AsymmetryParameter", "LiquidEffectiveRadius", "IceEffectiveRadius")


def add(attributes, **arrays):
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=1)
        array.SetName(name)
        attributes.AddArray(array)


def column(on_cells=False, **arrays):
    """Points 0, 500 and 1000 m above each other, four columns; or two cells above each other."""
    image = vtkImageData()
    image.SetDimensions(2, 2, 3)
    image.SetSpacing(1000, 1000, 500)
    size = 2 if on_cells else 12
    per = 1 if on_cells else 4
    values = {name: np.repeat(value, per)[:size] if np.ndim(value) else np.full(size, float(value)) for name, value in arrays.items()}
    add(image.GetCellData() if on_cells else image.GetPointData(), **values)
    return image


def optics_of(data, **options):
    optics = vtkCloudOptics()
    optics.SetInputData(data)
    for name, value in options.items():
        getattr(optics, "Set" + name)(value)
    with Messages() as messages:
        optics.Update()
    return optics.GetOutput(), messages


def values(output, name="Extinction", on_cells=False):
    return vtk_to_numpy((output.GetCellData() if on_cells else output.GetPointData()).GetArray(name)).astype(float)


class CloudOptics(unittest.TestCase):
    def test_profile_by_hand(self):
        # rho = 85000 / (287.0529 * 280) = 1.05755; 0.3 g/kg of 10 micrometres: 1.5 * 3e-4 * 1.05755 / (1000 * 1e-5) = 0.0475896 1/m
        output, messages = optics_of(column(qc=[0, 3e-4, 0], t=280, p=85000), LiquidRadiusType=1)
        beta = values(output)
        self.assertEqual(messages.all, [])
        np.testing.assert_allclose(beta[4:8], 0.0475896, rtol=1e-5)
        self.assertEqual(beta[:4].max(), 0)
        np.testing.assert_allclose(values(output, "ColumnOpticalDepth"), 500 * 0.0475896, rtol=1e-5)
        np.testing.assert_allclose(values(output, "OpticalDepthAbove")[::4], np.array([500, 250, 0]) * 0.0475896, rtol=1e-5)
        np.testing.assert_allclose(values(output, "AsymmetryParameter")[4], 0.85382, rtol=1e-5)

    def test_temperature_in_degrees_celsius(self):
        """By the units in the field data, as a reader leaves them, for water and for the pressure by height."""
        for options in ({"p": 85000}, {"Height": [0, 500, 1000]}):
            kelvin, celsius = (column(qc=3e-4, qi=1e-4, t=np.array([280.0, 270, 250]) - less, **options) for less in (0, 273.15))
            units = vtkStringArray()
            units.SetName("t_units")
            units.InsertNextValue("degC")
            celsius.GetFieldData().AddArray(units)
            (expected, _), (found, messages) = optics_of(kelvin), optics_of(celsius)
            self.assertEqual(messages.all, [])
            for name in ARRAYS:
                np.testing.assert_allclose(values(found, name), values(expected, name), rtol=1e-5)

    def test_what_needs_a_temperature(self):
        for arrays, words in (({"qc": 1e-4, "p": 85000}, "needed to compute the density"), ({"clwmr": 1e-4, "p": 85000}, "needed to separate ice from liquid and to compute"),
                              ({"qi": 1e-4}, "needed to find the size of ice crystals: set")):
            _, messages = optics_of(column(**arrays), WaterUnits=3 if "qi" in arrays else 0)
            self.assertIn(words, " ".join(map(str, messages.all)))
        _, messages = optics_of(column(qc=1e-4), WaterUnits=3)
        self.assertEqual(messages.all, [])

    def test_units_by_name(self):
        optics = vtkCloudOptics()
        for value, name in enumerate(("Automatic", "MixingRatio", "MixingRatioGrams", "Content", "ContentGrams")):
            getattr(optics, "SetWaterUnitsTo" + name)()
            self.assertEqual(optics.GetWaterUnits(), value, name)

    def test_units_are_the_same_water(self):
        ratio = values(optics_of(column(qc=[0, 3e-4, 0], t=280, p=85000))[0])
        for water, options in ((0.3, {"WaterUnits": 2}), (3e-4 * 1.057553, {"WaterUnits": 3}), (0.3 * 1.057553, {"WaterUnits": 4})):
            other = values(optics_of(column(qc=[0, water, 0], t=280, p=850), **options)[0])
            np.testing.assert_allclose(other, ratio, rtol=1e-5)

    def test_total_is_divided_by_temperature(self):
        cold = values(optics_of(column(clwmr=1e-4, t=263.16, p=50000))[0])
        parts = values(optics_of(column(qc=5e-5, qi=5e-5, t=263.16, p=50000))[0])
        np.testing.assert_allclose(cold, parts, rtol=1e-6)
        both = values(optics_of(column(clwmr=1e-4, qc=5e-5, qi=5e-5, t=263.16, p=50000))[0])
        np.testing.assert_allclose(both, parts, rtol=1e-6)  # the sum beside its parts does not count twice

    def test_cover_makes_droplets_larger(self):
        whole = values(optics_of(column(qc=1e-4, t=280, p=85000))[0], "LiquidEffectiveRadius")
        part = values(optics_of(column(qc=1e-4, cc=0.125, t=280, p=85000))[0], "LiquidEffectiveRadius")
        np.testing.assert_allclose(part, 2 * whole, rtol=1e-6)
        land = values(optics_of(column(qc=1e-4, lsm=1, t=280, p=85000))[0], "LiquidEffectiveRadius")
        np.testing.assert_allclose(land, whole * (80 / (67 * 3)) ** (1 / 3), rtol=1e-6)

    def test_percent_and_kilopascals(self):
        """By the units, or by values that no fraction and no hPa of clouds have."""
        expected = {cover: values(optics_of(column(qc=1e-4, cc=cover, lsm=cover, t=280, p=85000))[0]) for cover in (0.125, 0.75)}
        for cover, beta in expected.items():
            for options in ({"cc": 100 * cover, "lsm": 100 * cover, "p": 85000}, {"cc": cover, "lsm": cover, "p": 850}, {"cc": cover, "lsm": cover, "p": 85}):
                np.testing.assert_allclose(values(optics_of(column(qc=1e-4, t=280, **options))[0]), beta, rtol=1e-5)
        small = column(qc=1e-4, cc=1.0, lsm=1.0, t=280, p=85)  # one percent; a high cloud in hPa
        for name, text in (("cc", "%"), ("lsm", "%"), ("p", "hPa")):
            units = vtkStringArray()
            units.SetName(f"{name}_units")
            units.InsertNextValue(text)
            small.GetFieldData().AddArray(units)
        np.testing.assert_allclose(values(optics_of(small)[0]), values(optics_of(column(qc=1e-4, cc=0.01, lsm=0.01, t=280, p=8500))[0]), rtol=1e-5)

    def test_rain_and_snow_add(self):
        output = values(optics_of(column(qr=1e-3, qs=1e-3, t=280), WaterUnits=3)[0])
        rain, snow = 1.5e-3 / (1000 * 0.66992e-3), 1.5e-3 / (100 * 1.5 * (1e-3 / (np.pi * 100 * 3e6)) ** 0.25)
        np.testing.assert_allclose(output, rain + snow, rtol=1e-4)

    def test_cells(self):
        output, messages = optics_of(column(on_cells=True, qc=[1e-4, 0], t=280, p=85000))
        self.assertEqual(messages.all, [])
        self.assertTrue((values(output, on_cells=True) > 0).tolist() == [True, False])

    def test_bad_values(self):
        output, messages = optics_of(column(qc=[-1e-4, np.nan, 1e-4], t=280, p=85000))
        self.assertEqual(len(messages.all), 2)
        self.assertIn("4 values of water below 0", messages.all[0])
        self.assertIn("4 values of water, or its pressure, missing", messages.all[1])
        self.assertTrue(np.isfinite(values(output)).all())

    def test_what_is_missing_is_named(self):
        for data, options, word in ((column(t=280), {}, "no array of cloud water"), (column(qc=1e-4, t=280), {}, "PressureArrayName"),
                                    (column(qc=1e-4, p=85000), {}, "TemperatureArrayName"),
                                    (column(qc=1e-4, t=280), {}, "HeightArrayName"),
                                    (column(qc=0.3, t=280, p=85000), {}, "g/kg"), (column(qc=0.1, t=280, p=85000), {}, "g/kg"),
                                    (column(qc=1e-4, t=[7, 8, 9], p=85000), {}, "'t' has values up to 9.0"), (column(qc=1e-4, t=10, p=85000), {}, "'t' has values up to 10.0"),
                                    (column(qc=1e-4, t=280, p=85000), {"IceArrayName": "cheese"}, "'cheese'")):
            output, messages = optics_of(data, **options)
            self.assertEqual(len(messages.all), 1, word)
            self.assertIn(word, messages.all[0])
            self.assertEqual(output.GetNumberOfPoints(), 0)

    def test_names_of_large_eddy_models(self):
        expected = values(optics_of(column(qc=1e-4, t=285, p=85000))[0])
        for water in ("QC", "q_l", "cloud_liquid", "QN"):
            output, messages = optics_of(column(**{water: 1e-4, "TABS": 285, "p": 85000}))
            self.assertEqual(messages.all, [], water)
            np.testing.assert_allclose(values(output), expected, rtol=1e-6)

    def test_no_temperature_is_needed_for_liquid_content(self):
        output, messages = optics_of(column(LWC=3e-4), LiquidRadiusType=1)
        self.assertEqual(messages.all, [])
        np.testing.assert_allclose(values(output), 0.045, rtol=1e-6)


def globe(exaggeration):
    reader = vtkNetCDFCFReader()
    reader.SetFileName(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))
    reader.UpdateMetaData()
    reader.SetSphericalCoordinates(0)
    reader.SetDimensions("(lev, lat, lon)")
    grid = vtkGlobeGrid()
    grid.SetInputConnection(reader.GetOutputPort())
    grid.SetVerticalExaggeration(exaggeration)
    grid.Update()
    return grid.GetOutput()


class Orders(unittest.TestCase):
    """Columns are those of the places, whichever index counts upwards, and from whichever end."""

    def test_points_and_cells(self):
        size = np.array([4, 5, 7])  # along z, y and x
        z, y, x = np.meshgrid(*(1000.0 * np.arange(n) for n in size), indexing="ij")
        fields = {"qc": 1e-3 * np.exp(-((x - 2000) ** 2 + (y - 1000) ** 2 + (z - 1500) ** 2) / 1e6), "t": 280 + x / 1000 - 0.005 * z, "z": z}
        for on_cells in (False, True):
            cut = (slice(None, -1),) * 3 if on_cells else ()
            expected = {}
            for order in itertools.permutations(range(3)):
                for backwards in (slice(None), slice(None, None, -1)):
                    def there(a, order=order, backwards=backwards):
                        return np.ascontiguousarray(a.transpose(order)[backwards])
                    grid = vtkStructuredGrid()
                    grid.SetDimensions([int(n) for n in size[list(order)][::-1]])
                    grid.SetPoints(vtkPoints())
                    grid.GetPoints().SetData(numpy_to_vtk(np.stack([there(a).ravel() for a in (x, y, z)], axis=1), deep=1))
                    add(grid.GetCellData() if on_cells else grid.GetPointData(), **{name: there(a[cut]).ravel() for name, a in fields.items()})
                    output, messages = optics_of(grid, HeightArrayName="z")
                    self.assertEqual(messages.all, [])
                    for name in ("Extinction",) if on_cells else ("Extinction", "OpticalDepthAbove", "ColumnOpticalDepth"):
                        found = values(output, name, on_cells).reshape(there(z[cut]).shape)[backwards].transpose(np.argsort(order))
                        with self.subTest(name, order=order, backwards=backwards, on_cells=on_cells):
                            np.testing.assert_allclose(found, expected.setdefault(name, found), rtol=1e-5)
            self.assertGreater(expected["Extinction"].max(), 0)


class OfGfs(unittest.TestCase):
    def test_exaggeration_keeps_the_optical_depth(self):
        (flat, messages), (tall, _) = optics_of(globe(1)), optics_of(globe(50))
        self.assertEqual(messages.all, [])
        depth = values(flat, "ColumnOpticalDepth")
        np.testing.assert_allclose(values(tall, "ColumnOpticalDepth"), depth, rtol=2e-3, atol=1e-3)
        np.testing.assert_allclose(50 * values(tall), values(flat), rtol=1e-5)
        self.assertTrue(1 < depth.mean() < 20, depth.mean())
        self.assertTrue(20 < depth.max() < 500, depth.max())

    def test_pressures_in_balance_are_those_of_the_levels(self):
        """Extinction is proportional to the pressure: it differs by that of the sea level alone from the one with the pressures of the levels."""
        grid = globe(1)
        balanced = values(optics_of(grid, LiquidRadiusType=1, IceRadiusType=1)[0])
        levels = [1000, 975, 950, 925, 900, 850, 800, 750, 700, 650, 600, 550, 500, 450, 400, 350, 300, 250, 200, 150, 100]
        add(grid.GetPointData(), p=np.repeat(levels, grid.GetNumberOfPoints() // len(levels)))
        told = values(optics_of(grid, LiquidRadiusType=1, IceRadiusType=1)[0])
        inside = told > 1e-6
        ratio = balanced[inside] / told[inside]
        self.assertLess(np.abs(ratio - 1).mean(), 0.02)
        self.assertLess(np.abs(ratio - 1).max(), 0.12)

    def test_standard_pressures_without_columns(self):
        """An unstructured copy: pressures differ from those in balance by 3.3 % on average, and by 25 % high above cold air."""
        grid = globe(1)
        append = vtkAppendFilter()
        append.AddInputData(grid)
        append.Update()
        expected = values(optics_of(grid, LiquidRadiusType=1, IceRadiusType=1)[0])
        output, messages = optics_of(append.GetOutput(), LiquidRadiusType=1, IceRadiusType=1)
        self.assertEqual(messages.all, [])
        inside = expected > 1e-6
        ratio = values(output)[inside] / expected[inside]
        print(f"  standard atmosphere: mean {np.abs(ratio - 1).mean():.3f}, largest {np.abs(ratio - 1).max():.3f}")
        self.assertLess(np.abs(ratio - 1).mean(), 0.04)
        self.assertLess(np.abs(ratio - 1).max(), 0.26)

    def test_coordinates_in_degrees(self):
        """Once, where a reader has left them; not in metres, or without heights."""
        for size, height, told in ((1, True, True), (1, False, False), (1000, True, False)):
            image = column(qc=1e-4, t=280, p=85000, **({"gh": [0, 500, 1000]} if height else {}))
            image.SetSpacing(size, size, 500)
            with self.subTest(size=size, height=height):
                self.assertEqual(any("Globe Grid first" in one for one in optics_of(image)[1].all), told)


if __name__ == "__main__":
    unittest.main(verbosity=2)
