# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_haze: every argument arrives, the ground is that of the mesh, and the picture of a plotter is hazed."""
import os
import unittest

import nephoscope
import numpy as np
import pyvista

FILE = os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc")


class Arguments(unittest.TestCase):
    def add(self, *args, **options):
        plotter = pyvista.Plotter(off_screen=True)
        haze = nephoscope.add_haze(plotter, *args, **options)
        self.assertIs(nephoscope.vtkHaze.GetHaze(plotter.renderer), haze)
        plotter.close()
        return haze

    def test_defaults_are_those_of_the_class(self):
        self.assertEqual(str(self.add()).split("Enabled:")[1], str(nephoscope.vtkHaze()).split("Enabled:")[1])

    def test_every_argument_arrives(self):
        haze = self.add(visibility=1e5, scale_height=2000, color="red", background=False, vertical_exaggeration=30, projection="map",
                        radius=2.0, center=(1, 2, 3), up=(0, 2, 0), base_level=-4)
        self.assertEqual((haze.GetVisibility(), haze.GetScaleHeight(), haze.GetVerticalExaggeration()), (1e5, 2000, 30))
        self.assertEqual((haze.GetColor(), haze.GetBackground(), haze.GetProjection()), ((1, 0, 0), False, 1))
        self.assertEqual((haze.GetPlanetRadius(), haze.GetCenter()), (2, (1, 2, 3)))
        self.assertEqual((haze.GetUpDirection(), haze.GetBaseLevel()), ((0, 2, 0), -4))

    def test_the_ground_is_that_of_the_mesh(self):
        weather = nephoscope.read_cf(FILE)
        globe = weather.nephoscope.globe(vertical_exaggeration=40, radius=1000.0)
        haze = self.add(globe)
        self.assertEqual((haze.GetProjection(), haze.GetVerticalExaggeration(), haze.GetPlanetRadius()), (0, 40, 1000))
        haze = self.add(weather.nephoscope.globe(projection="map", vertical_exaggeration=25))
        self.assertEqual((haze.GetProjection(), haze.GetVerticalExaggeration()), (1, 25))
        self.assertEqual(self.add(globe, vertical_exaggeration=2).GetVerticalExaggeration(), 2)

    def test_out_of_range(self):
        for options in ({"visibility": 0}, {"scale_height": -1}, {"vertical_exaggeration": np.nan}, {"radius": 0}, {"up": (0, 0, 0)},
                        {"center": (0, 0)}, {"projection": "moon"}, {"base_level": np.inf}):
            with self.assertRaisesRegex(ValueError, next(iter(options))):
                self.add(**options)


class Picture(unittest.TestCase):
    def test_thick_haze_is_all_that_is_seen(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        plotter.add_mesh(pyvista.Sphere(), color="red", lighting=False)
        plotter.add_mesh(pyvista.Cube(center=(1.5, 0, 0)), color="blue", opacity=0.5)
        nephoscope.add_haze(plotter, visibility=1e-3, scale_height=1e3, projection="map", color=(0.2, 0.6, 0.4), base_level=-100)
        picture = plotter.screenshot(return_img=True)
        plotter.close()
        np.testing.assert_allclose(picture[..., :3].reshape(-1, 3), np.tile((51, 153, 102), (3600, 1)), atol=2)


if __name__ == "__main__":
    unittest.main()
