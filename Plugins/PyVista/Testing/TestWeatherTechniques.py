# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ten thousand columns of MPAS' shape, drawn by every technique: nothing is blank, and what is drawn follows the field, which is a band."""
import unittest

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from TestWeatherMeshes import mpas
from vtkmodules.vtkRenderingCore import vtkActor2D
from weather_data import isothermal

BAND = np.radians(20)  # half its width; clouds at the equator alone


def picture(draw):
    plotter = pyvista.Plotter(off_screen=True, window_size=(200, 200))
    plotter.set_background("black")
    draw(plotter)
    plotter.camera_position = [(0, -4.5e7, 0), (0, 0, 0), (0, 0, 1)]
    image = np.asarray(plotter.screenshot(return_img=True), float).max(axis=-1)
    plotter.close()
    return image


class Techniques(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        dataset = mpas(5)
        band = np.clip(1 - np.abs(dataset.latCell.values) / BAND, 0, 1)
        cls.mesh = dataset.assign(cloud=(("nVertLevels", "nCells"), np.broadcast_to(band, (3, len(band))))).nephoscope.globe(vertical_exaggeration=60)
        cls.points = cls.mesh.cell_data_to_point_data()

    def test_size(self):
        self.assertEqual(self.mesh.n_cells, 3 * 10242)
        self.assertLess(self.mesh.actual_memory_size * 1024 / self.mesh.n_cells, 300)  # bytes; Documentation/weather.md

    def test_techniques(self):
        half = self.points.contour([0.5], scalars="cloud")
        ways = {"cells": lambda plotter: nephoscope.add_cells(plotter, self.mesh, "cloud", cmap="gray", show_scalar_bar=False),
                "splats": lambda plotter: nephoscope.add_splats(plotter, self.mesh, "cloud", cmap="gray", show_scalar_bar=False),
                "contours": lambda plotter: nephoscope.add_cells(plotter, self.points, "cloud", contours=[0.5], opacity=[0, 0], show_scalar_bar=False),
                "pieces": lambda plotter: plotter.add_mesh(nephoscope.split_cells(self.points, [0.5], "cloud").threshold(0.5, scalars="Layer"), color="white"),
                "texture": lambda plotter: nephoscope.add_cloud_texture(plotter, half, color="white"),
                "smoke": lambda plotter: nephoscope.add_smoke(plotter, nephoscope.flow_volume(self.mesh, center=(0, -6.5e6, 0)))}
        for name, draw in ways.items():
            with self.subTest(name):
                image = picture(draw)
                self.assertGreater(np.count_nonzero(image > 20), 50)
                if name != "smoke":
                    rows = image.mean(axis=1)
                    self.assertGreater(rows[85:115].mean(), 5 * rows[:60].mean())

    def test_streaks(self):
        self.assertGreater(np.count_nonzero(picture(lambda plotter: nephoscope.add_splats(plotter, self.mesh, "cloud", vectors="DisplayVelocity", show_scalar_bar=False)) > 20), 50)


class FromDatasets(unittest.TestCase):
    """Functions that take a dataset in place of a mesh: what `plot` draws besides the field."""

    def drawn(self, dataset, function, *args, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100), **options)
        self.addCleanup(plotter.close)
        function(plotter, dataset, *args)
        return plotter

    def test_titles_have_units(self):
        data = isothermal(np.arange(0, 40, 5.0), np.arange(20, 60, 5.0))
        data["ta"].attrs["long_name"] = "Temperature"
        data["u"] = data.ta.dims, np.arange(data.ta.size, dtype=float).reshape(data.ta.shape), {"units": "m s-1", "standard_name": "eastward_wind"}
        data["v"] = data.ta.dims, np.arange(data.ta.size, dtype=float).reshape(data.ta.shape), {"units": "m s-1", "standard_name": "northward_wind"}
        flat = xr.Dataset({"ql": (("z", "y", "x"), np.arange(64.0).reshape(4, 4, 4), {"units": "g kg-1", "long_name": "liquid water"})},
                          {letter: (letter, np.arange(4.0), {"units": "m"}) for letter in "xyz"})
        for function in (nephoscope.add_cells, nephoscope.add_splats):
            for dataset, args, title in ((data, ("ta",), "Temperature [K]"), (data.ta, (), "Temperature [K]"), (data, ("u",), "eastward wind [m s-1]"), (flat, ("ql",), "Liquid water [g kg-1]"),
                                         (data, ("Wind",), "Wind Magnitude [m s-1]"), (data.nephoscope.mesh(), ("ta",), "ta")):
                with self.subTest(function=function.__name__, title=title):
                    (bar,) = self.drawn(dataset, function, *args).scalar_bars.values()
                    self.assertEqual(bar.GetTitle().lower(), title.lower())
        (bar,) = self.drawn(data, lambda plotter, one: nephoscope.add_cells(plotter, one, "ta", scalar_bar_args={"title": "mine"})).scalar_bars.values()
        self.assertEqual(bar.GetTitle(), "mine")

    @staticmethod
    def shown(plotter):
        """Surfaces and volumes, without scalar bars and, in some versions of PyVista, the border of a sub-plot."""
        return [actor for actor in plotter.renderer.actors.values() if not isinstance(actor, vtkActor2D)]

    def test_the_earth_is_below(self):
        data = isothermal(np.arange(0, 40, 5.0), np.arange(20, 60, 5.0))
        for function in (nephoscope.add_cells, nephoscope.add_splats):
            plotter = self.drawn(data, function, "ta")
            self.assertEqual(len(self.shown(plotter)), 2)
            self.assertEqual(plotter.background_color, pyvista.Color("black"))
            function(plotter, data, "ta")
            self.assertEqual(len(self.shown(plotter)), 3)
            plotter = self.drawn(data, function, "ta", theme=pyvista.themes.ParaViewTheme())
            self.assertEqual(len(self.shown(plotter)), 2)
            self.assertEqual(plotter.background_color, pyvista.themes.ParaViewTheme().background)
            self.assertEqual(len(self.shown(self.drawn(data, function, "ta", shape=(1, 2)))), 2)
            self.assertEqual(len(self.shown(self.drawn(data.nephoscope.mesh(), function, "ta"))), 1)
            for side in (1, -1):  # the Earth does not hide them
                cap = isothermal(np.arange(0, 360, 10.0), side * np.arange(10, 81, 10.0))
                self.assertGreater(side * self.drawn(cap, function, "ta").camera.position[2], 0)
        with self.assertRaises(ValueError):
            plotter = pyvista.Plotter(off_screen=True)
            self.addCleanup(plotter.close)
            nephoscope.add_cells(plotter, data, "none")
        self.assertFalse(plotter.renderer.actors)


if __name__ == "__main__":
    unittest.main()
