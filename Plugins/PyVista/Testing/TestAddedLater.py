# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever is added to a plotter that has been drawn before, in place of something or not, looks as in a new plotter."""
import unittest

import nephoscope
import numpy as np
import pyvista

CAMERA = [(2, 2, 2), (0, 0, 0), (0, 0, 1)]


def grid():
    data = pyvista.ImageData(dimensions=(5, 5, 5), spacing=(0.25,) * 3, origin=(-0.5,) * 3)
    values = np.arange(data.n_points)
    data["a"], data["Density"] = np.sin(values / 20), values / values.max()
    data["v"] = np.stack([np.cos(values), np.sin(values), values / 100], axis=1)
    return data


def surface():
    sphere = pyvista.Sphere(theta_resolution=24, phi_resolution=24)
    sphere["z"] = sphere.points[:, 2]
    return sphere


def haze(visibility):
    return lambda plotter, **options: nephoscope.add_haze(plotter, projection="map", scale_height=1, base_level=-1, visibility=visibility,
                                                          **options)


def named(function, *arguments, **options):
    """In place of whatever is there."""
    return lambda plotter, **more: function(plotter, *arguments, name="x", reset_camera=False, **options, **more)


GRID, SMOKE, SURFACE = grid(), grid().cast_to_unstructured_grid(), surface()
WAYS = {
    "cells": named(nephoscope.add_cells, GRID, "a"),
    "splats": named(nephoscope.add_splats, GRID, "a", cmap="gray"),
    "winds": named(nephoscope.add_splats, GRID, "a", vectors="v"),
    "smoke": named(nephoscope.add_smoke, SMOKE),
    "clouds": named(nephoscope.add_cloud_texture, SURFACE),
    "coloured clouds": named(nephoscope.add_cloud_texture, SURFACE, "z", coverage=0.8),
    "thick clouds": named(nephoscope.add_cloud_texture, SURFACE, use_thickness=True),
    "haze": haze(3),
    "thicker haze": haze(1),
}


class AddedLater(unittest.TestCase):
    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Cube().scale(0.5), color="red")
        plotter.camera_position = CAMERA
        return plotter

    def picture(self, plotter):
        return plotter.screenshot(return_img=True)[..., :3].astype(int)

    def each(self, check):
        for name, add in WAYS.items():
            with self.subTest(name):
                plain = self.picture(self.plotter())
                plotter = self.plotter()
                add(plotter)
                expected = self.picture(plotter)
                self.assertGreater(np.abs(expected - plain).max(), 30)
                check(add, expected)

    def same(self, plotter, expected):
        np.testing.assert_allclose(self.picture(plotter), expected, atol=1)

    def test_after_a_picture(self):
        def check(add, expected):
            plotter = self.plotter()
            self.picture(plotter)
            add(plotter)
            self.same(plotter, expected)
        self.each(check)

    def test_three_times(self):
        def check(add, expected):
            plotter = self.plotter()
            for _ in range(3):
                add(plotter)
                self.same(plotter, expected)
            self.assertLessEqual(len(plotter.scalar_bars), 1)
        self.each(check)

    def test_no_picture_is_made_unasked(self):
        """With render=False the last picture stays."""
        for name in ("clouds", "haze"):
            plotter = self.plotter()
            plain = self.picture(plotter)
            WAYS[name](plotter, render=False)
            self.same(plotter, plain)

    def test_plotter_closed_and_another_opened(self):
        def check(add, expected):
            first, second = self.plotter(), self.plotter()
            add(first)
            self.same(first, expected)
            first.close()
            add(second)
            self.same(second, expected)
            third = self.plotter()
            for actor in list(second.actors.values())[1:]:
                third.add_actor(actor, reset_camera=False)
            second.close()
            self.picture(third)
        self.each(check)


if __name__ == "__main__":
    unittest.main()
