# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar bars of sub-plots: each has its own, with its own title and range, also where the arrays have the same name."""
import unittest

import nephoscope
import numpy as np
import pyvista

RANGES = ((0.0, 10.0), (200.0, 300.0))


def mesh(low, high):
    grid = pyvista.ImageData(dimensions=(5, 5, 5))
    grid["q"] = np.linspace(low, high, grid.n_points)
    grid["v"] = np.ones((grid.n_points, 3))
    return grid


def surface(low, high, name="q"):
    found = mesh(low, high).extract_surface(algorithm="dataset_surface")
    found[name] = found["q"]
    return found


class Subplots(unittest.TestCase):
    def drawn(self, draw):
        """The bars of two sub-plots: (sub-plot, title, range)."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 100), shape=(1, 2))
        self.addCleanup(plotter.close)
        actors = []
        for column, limits in enumerate(RANGES):
            plotter.subplot(0, column)
            actors.append(draw(plotter, *limits))
        bars = [(place, bar.GetTitle(), bar.GetLookupTable().GetRange()) for bar in plotter.scalar_bars.values() for place, renderer in enumerate(plotter.renderers)
                if renderer.HasViewProp(bar)]
        return actors, sorted(bars)

    def test_each_has_its_own(self):
        ways = {"cells": ("q", lambda plotter, *limits: nephoscope.add_cells(plotter, mesh(*limits), "q")), "splats": ("q", lambda plotter, *limits: nephoscope.add_splats(plotter, mesh(*limits), "q")),
                "texture": ("q", lambda plotter, *limits: nephoscope.add_cloud_texture(plotter, surface(*limits), "q")),
                "smoke": ("q", lambda plotter, *limits: nephoscope.add_smoke(plotter, mesh(*limits).cast_to_unstructured_grid(), "q", density="q", show_scalar_bar=True)),
                "terrain": ("Height (m)", lambda plotter, *limits: nephoscope.add_terrain(plotter, surface(*limits, "Terrain"), clim=limits)),
                "streaks": ("q", lambda plotter, *limits: nephoscope.add_splats(plotter, mesh(*limits), "q", opacity=0, vectors={"array": "v", "scalars": "q"}))}
        for way, (title, draw) in ways.items():
            with self.subTest(way):
                actors, bars = self.drawn(draw)
                self.assertEqual(bars, [(place, title, limits) for place, limits in enumerate(RANGES)])
                if way in ("cells", "splats", "texture"):
                    self.assertEqual([actor.mapper.scalar_range for actor in actors], list(RANGES))

    def test_titles_of_the_user(self):
        _, bars = self.drawn(lambda plotter, *limits: nephoscope.add_cells(plotter, mesh(*limits), "q", scalar_bar_args={"title": "water"}))
        self.assertEqual([title for _, title, _ in bars], ["water", "water"])

    def test_labels_stand_side_by_side(self):
        """Fewer in a narrow sub-plot, with the last one inside; as many as the user wants."""
        for options, count in (({}, 4), ({"scalar_bar_args": {"n_labels": 5}}, 5)):
            plotter = pyvista.Plotter(off_screen=True, window_size=(1000, 300), shape=(1, 2))
            self.addCleanup(plotter.close)
            nephoscope.add_cells(plotter, mesh(0, 0.000976), "q", **options)
            (bar,) = plotter.scalar_bars.values()
            self.assertEqual(bar.GetNumberOfLabels(), count)
            if not options:
                plotter.background_color = "black"
                bar.GetLabelTextProperty().SetColor(1, 1, 1)
                picture = plotter.screenshot(return_img=True).max(axis=2)
                self.assertGreater(picture[200:, 400:495].max(), 200)
                self.assertLess(picture[200:, 495:498].max(), 50)

    def test_one_in_a_subplot(self):
        """Two volumes of one array have one range and one bar, as in PyVista."""
        def two(plotter, low, high):
            for number, top in enumerate((high, 2 * high)):
                nephoscope.add_cells(plotter, mesh(low, top), "q", name=f"{low}-{number}")
        _, bars = self.drawn(two)
        self.assertEqual(bars, [(0, "q", (0.0, 20.0)), (1, "q", (200.0, 600.0))])


if __name__ == "__main__":
    unittest.main()
