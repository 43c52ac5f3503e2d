# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ten thousand columns of MPAS' shape, drawn by every technique: nothing is blank, and what is drawn follows the field, which is a band."""
import unittest

import nephoscope
import numpy as np
import pyvista
from TestWeatherMeshes import mpas

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


if __name__ == "__main__":
    unittest.main()
