# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""terrain_surface and add_terrain: usual names, colours by altitude, clouds end at mountains, errors."""
import os
import unittest

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

PATH = os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc")


def level(**arrays):
    lons, lats = np.arange(0, 360, 10.0), np.arange(-90, 91, 10.0)
    grid = pyvista.RectilinearGrid(lons, lats, [0.0])
    for name, value in arrays.items():
        grid[name] = np.broadcast_to(value, grid.n_points).copy()
    return grid


class Terrain(unittest.TestCase):
    def test_forecast(self):
        fields = nephoscope.read_cf(PATH, dimensions="lat, lon")
        terrain = fields.nephoscope.terrain(vertical_exaggeration=30)
        self.assertEqual(terrain.active_scalars_name, "Terrain")
        self.assertAlmostEqual(np.linalg.norm(terrain.points, axis=1).max(), 6371000 + 30 * 5635.35, delta=5)
        self.assertAlmostEqual(terrain["Terrain"].min(), -100)

    def test_usual_names(self):
        for name in ("orog", "topo", "HSURF", "elevation"):
            self.assertEqual(nephoscope.terrain_surface(level(**{name: 700.0}))["Height"].min(), 700)
        halves = np.repeat([0.0, 1.0], level().n_points // 2)
        terrain = nephoscope.terrain_surface(level(topo=700.0, LANDMASK=halves))
        self.assertEqual(set(np.round(terrain["Height"])), {0, 700})
        self.assertEqual(nephoscope.terrain_surface(level(topo=700.0, LANDMASK=halves), land=False)["Height"].min(), 700)

    def test_colours(self):
        """A plateau of 1000 m is yellow, the sea is blue."""
        for height, dominant in ((1000.0, 0), (-1.0, 2)):
            plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60), lighting="none")
            nephoscope.add_terrain(plotter, nephoscope.terrain_surface(level(orog=height)), show_scalar_bar=False)
            middle = plotter.screenshot(return_img=True)[30, 30]
            plotter.close()
            self.assertEqual(np.argmax(middle), dominant, middle)

    def test_errors(self):
        for mesh, options, error, expected in ((level(a=1.0), {}, MissingDataError, "name one with height.*'a'"),
                                               (level(a=1.0), {"height": "b"}, MissingDataError, "no array 'b'.*'a'"),
                                               (level(orog=1.0), {"land": "b"}, MissingDataError, "no array 'b'"),
                                               (level(orog=1.0), {"sea_depth": -1}, ValueError, "sea_depth"),
                                               (level(orog=1.0), {"projection": "flat"}, ValueError, "projection"),
                                               (pyvista.Sphere(), {}, TypeError, "longitude, latitude"),
                                               (nephoscope.read_cf(PATH), {"height": "t"}, RuntimeError, "one level")):
            with self.assertRaisesRegex(error, expected):
                nephoscope.terrain_surface(mesh, **options)
        with self.assertRaisesRegex(MissingDataError, "terrain_surface"):
            nephoscope.add_terrain(pyvista.Plotter(off_screen=True), pyvista.Sphere())


if __name__ == "__main__":
    unittest.main()
