# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that do not mean what they seem to: geopotential, kilometres, indices, radians, winds along the grid."""
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray

import globe_fields as gf

G = 9.80665
LON, LAT = np.arange(24) * 15.0, np.linspace(-90, 90, 13)
PRESSURES = np.array([1000.0, 850.0, 500.0, 300.0, 100.0])
STANDARD = np.array([110.9, 1457.3, 5574.4, 9164.0, 16179.6])  # m, of the 1976 atmosphere at these pressures


def heights(seed=3):
    """Heights of a plausible troposphere: the standard one and up to 8 % of weather."""
    field = STANDARD[:, None, None] * (1 + np.random.default_rng(seed).uniform(-0.08, 0.08, (5, 13, 24)))
    return field.ravel()


def units(grid, **names):
    for name, text in names.items():
        said = vtkStringArray()
        said.SetName(name + "_units")
        said.InsertNextValue(text)
        grid.GetFieldData().AddArray(said)
    return grid


def levels(lev, **arrays):
    return gf.rectilinear(LON, LAT, lev, arrays)


def texts(made):
    return [m for m in made.messages if "wind arrays" not in m]


class HeightUnits(unittest.TestCase):
    def heights_of(self, values, said=None, lev=PRESSURES, **settings):
        grid = levels(lev, z=values)
        made = gf.globe(units(grid, z=said) if said else grid, quiet=False, HeightArrayName="z", **settings)
        return gf.values(made.GetOutput(), "Height"), texts(made)

    def test_without_a_word_of_units(self):
        for factor, name in ((G, "geopotential"), (1e-3, "kilometres"), (0.1, "decametres"), (1.0, None)):
            for lev in (PRESSURES, 100 * PRESSURES, -PRESSURES):  # hPa, Pa, negated by the reader
                with self.subTest(name=name, lev=lev[0]):
                    got, messages = self.heights_of(factor * heights(), lev=lev)
                    np.testing.assert_allclose(np.sort(got), np.sort(self.closed(heights())), rtol=1e-6)
                    self.assertEqual(len(messages), 1 if name else 0, messages)
                    if name:
                        self.assertIn(name, messages[0])
                        self.assertIn("HeightUnits", messages[0])

    @staticmethod
    def closed(values):
        cube = values.reshape(5, 13, 24)
        return np.concatenate([cube, cube[:, :, :1]], axis=2).ravel()

    def test_the_word_of_the_file_is_taken(self):
        for said, factor in (("m**2 s**-2", G), ("m2/s2", G), ("J kg-1", G), ("m^2 s^-2", G), ("gpm", 1), ("metres", 1),
                             ("km", 1e-3), ("dam", 0.1)):
            got, messages = self.heights_of(factor * heights(), said)
            self.assertEqual(messages, [], said)
            self.assertLess(got.max(), 18000)
            self.assertGreater(got.max(), 15000)

    def test_a_wrong_word_is_taken_and_told(self):
        got, messages = self.heights_of(G * heights(), "m")
        self.assertGreater(got.max(), 1.5e5)
        self.assertTrue(any("whose units are 'm'" in m and "implausible" in m for m in messages), messages)
        got, messages = self.heights_of(G * heights(), "m", HeightUnits=3)
        self.assertEqual((got.max() < 18000, messages), (True, []))

    def test_without_pressures(self):
        """Nothing to compare with, but what goes up to space is told."""
        z = np.repeat(np.array([0.0, 5000.0, 12000.0, 18000.0, 25000.0]) * G, 13 * 24)
        _, messages = self.heights_of(z, lev=np.array([0.0, 5000.0, 12000.0, 18000.0, 25000.0]))
        self.assertTrue(any("geopotential" in m and "245166" in m for m in messages), messages)
        _, messages = self.heights_of(z, lev=np.array([0.0, 5000.0, 12000.0, 18000.0, 25000.0]), HeightUnits=3)
        self.assertEqual(messages, [])

    def test_another_planet_is_not_judged(self):
        _, messages = self.heights_of(np.repeat(STANDARD * 4, 13 * 24), PlanetRadius=2.575e6, HeightUnits=1)
        self.assertEqual(messages, [])

    def test_hidden_and_missing_heights_do_not_count(self):
        z = G * heights()
        z[::3] = np.nan
        _, messages = self.heights_of(z)
        self.assertTrue(any("geopotential" in m for m in messages), messages)


class LevelUnits(unittest.TestCase):
    def told(self, lev, text, **arrays):
        arrays = arrays or {"q": np.zeros(len(lev) * 13 * 24)}
        messages = texts(gf.globe(levels(np.asarray(lev, float), **arrays), quiet=False))
        if text is None:
            self.assertEqual(messages, [], lev)
        else:
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(text, messages[0])

    def test_indices(self):
        for lev in (np.arange(20), np.arange(1, 138), np.arange(137, 0, -1), -np.arange(1, 138)):
            self.told(lev, "numbers of levels")

    def test_indices_beside_heights(self):
        z = np.repeat(np.linspace(0, 15000, 12), 13 * 24)
        self.told(np.arange(12), None, gh=z)
        self.told(-np.arange(1, 13), None, gh=z[::-1].copy())

    def test_kilometres(self):
        self.told([0.0, 0.5, 1, 2, 4, 8, 16], "kilometres")

    def test_depths(self):
        self.told([-5500.0, -3000, -1000, -100], "depth")

    def test_plausible_axes_say_nothing(self):
        for lev in (PRESSURES, 100 * PRESSURES, -PRESSURES, -100 * PRESSURES, [0, 500, 1500, 12000], [10, 100, 500]):
            self.told(lev, None)

    def test_pressures_taken_as_heights(self):
        messages = texts(gf.globe(levels(np.array([1e5, 8.5e4, 5e4]) * 3, q=np.zeros(3 * 13 * 24)), quiet=False))
        self.assertTrue(any("LevelUnits" in m for m in messages), messages)


class Axes(unittest.TestCase):
    def test_radians(self):
        for lon, lat in ((LON, LAT), (LON - 180, np.linspace(-87.5, 87.5, 36)), (np.linspace(0, 360, 25), LAT[::-1])):
            grid = gf.rectilinear(np.radians(lon), np.radians(lat), [0.0, 1000.0])
            self.assertTrue(any("radians" in m for m in texts(gf.globe(grid, quiet=False))))

    def test_a_small_patch_in_degrees(self):
        grid = gf.rectilinear(np.linspace(0, 5, 24), np.linspace(-1.5, 1.5, 13), [0.0, 1000.0])
        self.assertEqual(texts(gf.globe(grid, quiet=False)), [])


class WindComponents(unittest.TestCase):
    def turned_patch(self, angle, names=("u", "v"), flip=False):
        """A patch about (0, 0) whose rows are turned by `angle`, with a wind of 10 m/s along them and 3 m/s across."""
        a, b = np.meshgrid(np.linspace(-2, 2, 9), np.linspace(-2, 2, 7))
        if flip:
            a, b = a[::-1], b[::-1]
        c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        x, y = (c * a - s * b).ravel(), (s * a + c * b).ravel()
        lon = np.tile(x / np.cos(np.radians(y)), 2)
        z = np.repeat([0.0, 1000.0], x.size)
        ones = np.ones(2 * x.size)
        return gf.structured(lon, np.tile(y, 2), z, (9, 7, 2), {names[0]: 10 * ones, names[1]: 3 * ones, "w": 0 * ones})

    def wind(self, grid, **settings):
        made = gf.globe(grid, quiet=False, Projection=1, VerticalWindIsOmega=False, **settings)
        return gf.values(made.GetOutput(), "Wind").mean(axis=0)[:2], texts(made)

    def test_told_and_turned(self):
        for angle in (-35.0, 8.0, 40.0):
            for flip in (False, True):
                c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
                along = np.array([10 * c - 3 * s, 10 * s + 3 * c])
                with self.subTest(angle=angle, flip=flip):
                    plain, messages = self.wind(self.turned_patch(angle, flip=flip))
                    np.testing.assert_allclose(plain, [10, 3], atol=1e-5)
                    self.assertTrue(any("WindComponents" in m for m in messages), messages)
                    plain, messages = self.wind(self.turned_patch(angle, flip=flip), WindComponents=1)
                    self.assertEqual(messages, [])
                    turned, messages = self.wind(self.turned_patch(angle, flip=flip), WindComponents=2)
                    np.testing.assert_allclose(turned, along, atol=0.05)
                    self.assertEqual(messages, [])
                    named, messages = self.wind(self.turned_patch(angle, ("x_wind", "y_wind"), flip),
                                                EastwardWindArrayName="x_wind", NorthwardWindArrayName="y_wind")
                    np.testing.assert_allclose(named, along, atol=0.05)

    def test_rows_along_parallels_say_nothing(self):
        x, y, z = gf.mesh(np.arange(0, 30, 3.0), np.arange(0, 40, 4.0), [0.0, 1000.0])
        grid = gf.structured(x, y, z, (10, 10, 2), {"u": 0 * x + 5, "v": 0 * x, "w": 0 * x})
        self.assertEqual(self.wind(grid)[1], [])


class ActiveScalars(unittest.TestCase):
    def active(self, names, chosen=None):
        grid = levels(np.array([0.0, 1000.0]), **{name: np.zeros(2 * 13 * 24) for name in names})
        if chosen:
            grid.GetPointData().SetActiveScalars(chosen)
        scalars = gf.globe(grid).GetOutput().GetPointData().GetScalars()
        return scalars and scalars.GetName()

    def test_choice(self):
        self.assertEqual(self.active(["t", "clwmr", "cloud_fraction"]), "cloud_fraction")
        self.assertEqual(self.active(["t", "cc", "clwc"]), "cc")
        self.assertEqual(self.active(["t", "QCLOUD"]), "QCLOUD")
        self.assertEqual(self.active(["latitude", "time_bnds", "t", "r"]), "t")
        self.assertEqual(self.active(["cloud_area_fraction_in_atmosphere_layer", "clw"]), "cloud_area_fraction_in_atmosphere_layer")
        self.assertEqual(self.active(["BelowGround", "vtkOriginalPointIds"]), None)

    def test_what_the_user_chose_stays(self):
        self.assertEqual(self.active(["t", "cloud_fraction"], "t"), "t")
        self.assertEqual(self.active(["BelowGround", "cloud_fraction"], "BelowGround"), "cloud_fraction")


if __name__ == "__main__":
    unittest.main()
