# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a dataset: on a globe, on a map, of one level; options that the dataset itself answers."""
import tempfile
import unittest
from pathlib import Path

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import pyvista
from weather_data import isothermal

LON, LAT = np.arange(0, 40, 5.0), np.arange(20, 60, 5.0)


def forecast():
    first = isothermal(LON, LAT)
    return first.assign(cl=(first.ta.dims, 0.5 + 0 * first.ta.values, {"units": "1"}))


class Plots(unittest.TestCase):
    def plotted(self, dataset, name, **options):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "picture.png")
            plotter = dataset.nephoscope.plot(name, screenshot=str(path), **options)
            self.addCleanup(plotter.close)
            picture = pyvista.read(path)["PNGImage"].reshape(800, 800, -1)[..., :3].astype(float)
        return plotter, picture

    def sizes(self, plotter):
        return sorted(actor.GetLength() for actor in plotter.renderer.actors.values() if hasattr(actor, "GetLength") and actor.GetLength())

    def test_a_map_has_no_globe(self):
        plotter, _ = self.plotted(forecast(), "cl", projection="map")
        self.assertFalse(any(isinstance(actor, pyvista.Actor) for actor in plotter.renderer.actors.values()))

    def test_one_level_is_a_coloured_surface(self):
        level = forecast().isel({forecast().ta.dims[0]: 1})
        plotter, picture = self.plotted(level, "ta")
        self.assertEqual(sum(isinstance(actor, pyvista.Actor) for actor in plotter.renderer.actors.values()), 2)
        self.assertGreater(np.std(picture), 10)

    def test_one_level_with_nothing_set_and_large_cells(self):
        """It is coloured by its field, and the globe under it is nowhere in front of it: 20 degrees a cell."""
        level = isothermal(np.arange(0, 360, 20.0), np.arange(-80, 81, 20.0)).isel(plev=0)
        level = level[["ta"]].assign(ta=level.ta + 40 * np.sin(np.radians(level.lat)))
        plotter, picture = self.plotted(level, None)
        inside = picture[300:500, 300:500].reshape(-1, 3)
        ground = np.array([0x3d, 0x5a, 0x73]) * 1.0
        self.assertGreater(np.ptp(inside, axis=0).max(), 60)  # colours of a field
        self.assertGreater(np.abs(inside / np.maximum(inside.max(1, keepdims=True), 1) - ground / ground.max()).max(1).min(), 0.02)
        self.assertEqual([bar.GetOrientation() for bar in plotter.scalar_bars.values()], [1])  # upright, beside the globe
        self.assertEqual([plotter.scalar_bars[name].GetPosition()[0] > 0.88 for name in plotter.scalar_bars.keys()], [True])
        self.assertEqual([bar.GetPosition()[0] * 800 + 20 + 9 * 6.5 < 800 for bar in plotter.scalar_bars.values()], [True])  # room for a label such as -1.66e+04

    def test_one_level_without_a_value(self):
        level = forecast().isel({forecast().ta.dims[0]: 1})[["ta"]]
        with self.assertRaisesRegex(ValueError, "the array 'ta' has no finite value"):
            self.plotted(level * np.nan, None)

    def test_what_the_dataset_answers(self):
        for option in ({"height": "z"}, {"height_units": "m"}, {"level_units": "hPa"}):
            with self.subTest(option), self.assertRaisesRegex(TypeError, f"globe.. takes {next(iter(option))} from the variables"):
                forecast().nephoscope.globe(**option)


if __name__ == "__main__":
    unittest.main()
