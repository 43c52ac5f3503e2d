#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""add_cells(sun=...): exposure and contrast with nothing set, names and units of water, messages."""
import unittest

import nephoscope
import numpy as np
import pyvista
from nephoscope.light import automatic_white, lit
from nephoscope.weather.roles import ROLES

pyvista.OFF_SCREEN = True


def slab(**water):
    """Water of 0.3 g/kg between 1 and 2 km, over 6 x 6 km."""
    mesh = pyvista.ImageData(dimensions=(7, 7, 13), spacing=(1000, 1000, 250))
    height = mesh.points[:, 2]
    mesh["t"], mesh["p"] = 288 - 0.0065 * height, 1e5 * np.exp(-height / 8000)
    for name, scale in water.items():
        mesh[name] = np.where((height >= 1000) & (height <= 2000), 3e-4 * scale, 0.0)
    return mesh


def lumps():
    mesh = pyvista.ImageData(dimensions=(41, 41, 21), spacing=(50, 50, 50))
    x, y, z = mesh.points.T
    mesh["Extinction"] = np.where(np.hypot(np.hypot(x - 1000, y - 1000), z - 500) < 350, 0.05, 0.0)
    return mesh


def picture(**options):
    plotter = pyvista.Plotter(window_size=(120, 120))
    plotter.set_background("black")
    nephoscope.add_cells(plotter, lumps(), sun=(1, 0, 0.3), show_scalar_bar=False, **options)
    plotter.camera_position = [(1000, -3500, 500), (1000, 1000, 500), (0, 0, 1)]
    image = plotter.screenshot(return_img=True).astype(float).max(axis=2)
    plotter.close()
    return image


class Exposure(unittest.TestCase):
    def test_shading_without_white(self):
        image = picture()
        lit_side, dark_side = np.percentile(image[image > 10], 95), image[55:65, 40:45].mean()
        self.assertLess(dark_side, 0.6 * lit_side)
        self.assertGreater(lit_side, 140)
        self.assertLess((image > 250).mean(), 0.01)

    def test_exposure_is_that_of_the_light(self):
        self.assertLess(picture(exposure=0.5).mean(), 0.8 * picture(exposure=1.0).mean())
        self.assertGreater(picture(exposure=1.0, tone_mapping="linear")[55:65, 40:45].mean(), 1.2 * picture(exposure=1.0)[55:65, 40:45].mean())

    def test_white(self):
        mesh = pyvista.ImageData(dimensions=(101, 1, 1))
        mesh["Sunlight"], mesh["ScaledExtinction"] = np.linspace(0, 0.5, 101), np.ones(101)
        self.assertAlmostEqual(automatic_white(mesh), 1.1 * 0.49, delta=1e-6)
        mesh["Sunlight"] = mesh["Sunlight"] * 1e-3
        self.assertEqual(automatic_white(mesh), 0.15)
        mesh["ScaledExtinction"] = np.zeros(101)
        self.assertEqual(automatic_white(mesh), 0.6)


class Water(unittest.TestCase):
    def test_names_of_the_weather_reader(self):
        """Every name that the reader of weather knows, also in capitals, gives the same extinction."""
        for role in ("cloud_water", "cloud_ice", "rain", "snow"):
            names = set(ROLES[role].names) - {"clwmr"}
            least = {}
            for name in sorted(names | {name.upper() for name in names} - {"LWC", "IWC"}):
                least[name] = slab(**{name: 1}).nephoscope.cloud_optics()["Extinction"].max()
            self.assertEqual(len(set(least.values())), 1, f"{role}: {least}")
            self.assertGreater(min(least.values()), 0)

    def test_liquid_of_gfs_beside_its_ice(self):
        alone, both = (slab(**water).nephoscope.cloud_optics()["Extinction"].max() for water in ({"icmr": 1}, {"icmr": 1, "clwmr": 1}))
        self.assertGreater(both, 1.5 * alone)

    def test_units_and_names_in_sun(self):
        expected = lit(slab(qc=1), {"direction": (0, 0, 1)})["ScaledExtinction"]
        found = lit(slab(mine=1000), {"direction": (0, 0, 1), "liquid": "mine", "units": "g/kg"})["ScaledExtinction"]
        np.testing.assert_allclose(found, expected, rtol=1e-5)

    def test_messages_name_what_add_cells_has(self):
        for error, text, mesh, sun in (
                (RuntimeError, r"sun\['water'\], or two by sun\['liquid'\]", slab(), True),
                (RuntimeError, r"as sun\['ice'\] says", slab(qc=1), {"ice": "no"}),
                (RuntimeError, r"Set sun\['units'\] to g/kg", slab(qc=1000), True),
                (RuntimeError, r"name one by sun\['extinction'\]", slab(qc=1), {"extinction": "no"}),
                (RuntimeError, ": sun is 'tomorrow'", slab(qc=1), "tomorrow"),
                (RuntimeError, r"sun\['time'\] is 'tomorrow'", slab(qc=1), {"time": "tomorrow"}),
                (ValueError, r"sun\['ground_albedo'\]", slab(qc=1), {"ground_albedo": 3}),
                (ValueError, "sun has no option 'directions'", slab(qc=1), {"directions": (0, 0, 1)})):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                nephoscope.add_cells(pyvista.Plotter(), mesh, sun=sun)


if __name__ == "__main__":
    unittest.main()
