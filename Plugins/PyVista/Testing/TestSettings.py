# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of the mappers of drawn volumes and surfaces: those there are change the picture, all others are refused with the right name."""
import unittest

import nephoscope
import numpy as np
import pyvista


def grid():
    data = pyvista.ImageData(dimensions=(6, 6, 6))
    data["a"] = data.points[:, 0]
    return data


class Settings(unittest.TestCase):
    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(80, 80))
        self.addCleanup(plotter.close)
        return plotter

    def mappers(self):
        smoke = pyvista.ImageData(dimensions=(9, 9, 9))
        smoke["v"] = np.tile([1.0, 0, 0], (smoke.n_points, 1))
        yield nephoscope.add_cells(self.plotter(), grid()).mapper
        yield nephoscope.add_splats(self.plotter(), grid()).mapper
        yield nephoscope.add_smoke(self.plotter(), smoke.nephoscope.flow_volume(duration=2)).mapper
        yield nephoscope.add_cloud_texture(self.plotter(), pyvista.Sphere()).mapper

    def test_unknown_names_are_refused(self):
        for mapper in self.mappers():
            with self.subTest(type(mapper).__name__):
                for name, told in (("clim", "Set scalar_range"), ("cmap", "Set lookup_table"), ("scalar_rang", "Set scalar_range"), ("no_such_thing", "There are: .*scalar_range")):
                    with self.assertRaisesRegex(AttributeError, f"{name}.*{told}"):
                        setattr(mapper, name, (0, 1))
                    self.assertFalse(hasattr(mapper, name))
                mapper._of_the_caller = 1
                mapper.scalar_range = (0, 2)
                self.assertEqual(tuple(mapper.scalar_range), (0, 2))

    def test_names_of_methods(self):
        mapper = nephoscope.add_splats(self.plotter(), grid()).mapper
        if not hasattr(type(mapper), "radius_factor"):  # newer VTK has the property
            with self.assertRaisesRegex(AttributeError, r"Call SetRadiusFactor\(\.\.\.\)"):
                mapper.radius_factor = 2
        mapper.phase = 0.5
        self.assertEqual(mapper.GetPhase(), 0.5)

    def test_range_and_table_change_the_picture(self):
        plotter = self.plotter()
        volume = nephoscope.add_cells(plotter, grid(), show_scalar_bar=False)
        before = plotter.screenshot(return_img=True).astype(int)
        volume.mapper.scalar_range = (0, 20)
        plotter.render()
        fainter = plotter.screenshot(return_img=True).astype(int)
        self.assertGreater(np.abs(fainter - before).max(), 40)
        volume.mapper.lookup_table = pyvista.LookupTable(["red", "red"], scalar_range=(0, 5))
        plotter.render()
        red = plotter.screenshot(return_img=True).astype(int)
        self.assertEqual(volume.mapper.scalar_range, (0, 5))
        self.assertTrue((red[..., 0] >= 250).all())
        self.assertLess(red[..., 1].min(), 100)
        copy = volume.copy()
        copy.mapper.lookup_table = pyvista.LookupTable(["blue", "blue"], scalar_range=(0, 1))
        self.assertEqual(volume.mapper.scalar_range, (0, 5))


if __name__ == "__main__":
    unittest.main()
