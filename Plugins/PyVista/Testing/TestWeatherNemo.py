# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""NEMO on an ORCA grid, with the corners of its cells, land that is missing, and a sea that is stored in place of land elsewhere: pictures, rows, columns and single levels."""
import tempfile
import unittest
from pathlib import Path

import numpy as np
import pyvista
import xarray as xr
from nephoscope.weather.horizontal import GridError

EARTH = 6371000.0
DEPTHS = np.array([5.0, 100, 1000, 4000])
LON, LAT = np.arange(0, 360, 5.0), np.arange(-80, 81, 5.0)


def nemo():
    """Warm at the surface and at the equator. On land there are no values, and the places of a sea far away from there."""
    lon, lat = np.meshgrid(LON, LAT)
    lat = lat + np.where(lat > 40, 4 * np.sin(np.radians(2 * lon)), 0)  # curvilinear in the north
    values = 30 * np.cos(np.radians(lat)) * np.exp(-DEPTHS / 800)[:, None, None]
    values[:, 22:27, 10:16] = np.nan
    lon[23:26, 11:15], lat[23:26, 11:15] = np.meshgrid(np.arange(300, 304), np.arange(40, 43))
    corners = [[-2.5, 2.5, 2.5, -2.5], [-2.5, -2.5, 2.5, 2.5]]
    places = ("y", "x")
    return xr.Dataset({"votemper": (("deptht", *places), values.astype("f4"), {"standard_name": "sea_water_potential_temperature", "units": "degC", "long_name": "Temperature"}),
                       "nav_lon_bnds": ((*places, "corner"), lon[..., None] + corners[0]), "nav_lat_bnds": ((*places, "corner"), lat[..., None] + corners[1])},
                      {"deptht": ("deptht", DEPTHS, {"units": "m", "positive": "down"}), "nav_lon": (places, lon, {"units": "degrees_east", "bounds": "nav_lon_bnds"}),
                       "nav_lat": (places, lat, {"units": "degrees_north", "bounds": "nav_lat_bnds"})})


class Nemo(unittest.TestCase):
    def plotted(self, dataset, **options):
        with tempfile.TemporaryDirectory() as folder:
            plotter = dataset.nephoscope.plot("votemper", screenshot=str(Path(folder, "picture.png")), window_size=(200, 200), **options)
        self.addCleanup(plotter.close)
        return plotter

    def test_the_ground_is_just_below_a_level(self):
        """Not below cells on land that reach across the globe."""
        for level in (0, [3]):
            plotter = self.plotted(nemo().isel(deptht=level))
            meshes = [actor.mapper.dataset for name, actor in plotter.renderer.actors.items() if isinstance(actor, pyvista.Actor) and name != "coasts"]
            radii = {"votemper" in mesh.array_names: np.linalg.norm(np.asarray(mesh.points), axis=1).min() for mesh in meshes}
            self.assertLess(radii[False], radii[True])
            self.assertGreater(radii[False], 0.99 * radii[True])

    def test_depths_are_below_the_sea_level_and_exaggerated(self):
        plotter = self.plotted(nemo())
        (mesh,) = [volume.mapper.dataset for volume in plotter.renderer.actors.values() if isinstance(volume, pyvista.Volume)]
        heights, factor = np.linalg.norm(np.asarray(mesh.points), axis=1) - EARTH, mesh.field_data["VerticalExaggeration"][0]
        self.assertGreaterEqual(factor, 30)
        np.testing.assert_allclose((heights.min(), heights.max()), (-4000 * factor, -5 * factor), rtol=0.01)

    def test_a_row_and_a_column_are_sections(self):
        """With the corners of their cells, as files have them, and whether the dimension of one entry is there or not."""
        data = nemo()
        for part in (data.isel(y=16), data.isel(y=[16]), data.isel(x=3), data.isel(x=[3])):
            plotter = self.plotted(part)
            (sheet,) = [actor.mapper.dataset for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Actor) and "votemper" in actor.mapper.dataset.array_names]
            self.assertEqual(np.ptp(np.asarray(sheet.points)[:, 1]), 0)
            self.assertTrue(plotter.camera.parallel_projection)

    def test_a_row_of_one_level_is_told(self):
        for part in (nemo().isel(deptht=0, y=16), nemo().isel(deptht=0, y=[16]), nemo().isel(deptht=[0], x=[3])):
            with self.assertRaisesRegex(GridError, r"a line.*ds\['votemper'\]\.squeeze\(\)\.plot\(\)"):
                self.plotted(part)


if __name__ == "__main__":
    unittest.main()
