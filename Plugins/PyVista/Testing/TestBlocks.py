# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which blocks add_cells and add_splats draw: those with 3-D cells and the array; a warning names the others."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError


def cube(x=0.0, **arrays):
    grid = pyvista.ImageData(dimensions=(4, 4, 4), spacing=(1 / 3,) * 3, origin=(x, 0, 0))
    for name in arrays.get("names", ("density",)):
        grid.point_data[name] = np.linspace(0, 1, grid.n_points)
    return grid


def patch(*names):
    surface = pyvista.Plane(i_resolution=3, j_resolution=3)
    for name in names:
        surface.point_data[name] = np.full(surface.n_points, 7.0)
    return surface


class Blocks(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(40, 40))
        self.addCleanup(self.plotter.close)

    def add(self, add, blocks, *args, **options):
        """The dataset drawn, and the warnings."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            volume = add(self.plotter, pyvista.MultiBlock(blocks), *args, show_scalar_bar=False, **options)
        for warning in caught:
            self.assertEqual(warning.filename, __file__)
        return volume.mapper.dataset, " ".join(str(warning.message) for warning in caught)

    def test_a_patch_without_the_array(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for scalars in (("density",), ()):
                drawn, told = self.add(add, {"internalMesh": cube(), "wall": patch()}, *scalars)
                self.assertEqual((drawn.n_points, "density" in drawn.point_data), (64, True))
                self.assertRegex(told, r"not drawn: 'wall' \(no 3-D cells\)")

    def test_a_patch_with_the_array(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            drawn, told = self.add(add, {"internalMesh": cube(), "boundary": pyvista.MultiBlock({"inlet": patch("density")})}, "density")
            self.assertEqual((drawn.n_points, drawn["density"].max()), (64, 1))
            self.assertIn("'inlet' (no 3-D cells)", told)

    def test_a_volume_without_the_array(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            blocks = {"air": cube(), "solid": cube(5.0, names=("T",)), "more air": cube(9.0)}
            for scalars in (("density",), ()):
                drawn, told = self.add(add, blocks, *scalars)
                self.assertEqual(drawn.n_points, 128)
                self.assertIn("'solid' (no point array 'density')", told)
            with self.assertRaisesRegex(MissingDataError, "no block has an array 'dens'. Point arrays: 'T', 'density'"):
                add(self.plotter, pyvista.MultiBlock(blocks), "dens")

    def test_an_array_on_cells_in_one_block(self):
        on_cells = cube(2, names=())
        on_cells.cell_data["density"] = np.linspace(0, 1, on_cells.n_cells)
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            drawn, told = self.add(add, {"first": cube(), "second": on_cells}, "density")
            self.assertEqual(drawn.n_points, 64)
            self.assertIn("'second' ('density' is on cells there, on points in other blocks: use block.cell_data_to_point_data())", told)

    def test_what_fits_says_nothing(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            drawn, told = self.add(add, {"a": cube(names=("density", "T")), "b": cube(5.0)})
            self.assertEqual((drawn.n_points, told), (128, ""))
        particles = {"dust": pyvista.PolyData(np.random.default_rng(2).random((9, 3))), "wall": patch()}
        drawn, told = self.add(nephoscope.add_splats, particles, color="red", opacity=0.5)
        self.assertEqual((drawn.n_points, told), (25, ""))

    def test_a_block_without_vectors_keeps_its_scalars(self):
        windy = cube()
        windy["Wind"] = np.ones((64, 3), np.float32)
        drawn, told = self.add(nephoscope.add_splats, {"windy": windy, "calm": cube(5.0)}, "density", vectors="Wind")
        self.assertEqual((drawn.n_points, told), (128, ""))
        calm = drawn.points[:, 0] > 2
        self.assertEqual((drawn["density"][calm].max(), np.ptp(drawn["Wind"][calm]), drawn["Wind"][~calm].min()), (1, 0, 1))

    def test_types_that_differ(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for types in ((np.float32, np.float64), (np.int32, np.float64), (np.uint8, np.float32), (np.float64, np.int16)):
                blocks = [cube(), cube(1.0)]
                for block, its in zip(blocks, types):
                    block["density"] = (100 * block["density"]).astype(its)
                drawn, told = self.add(add, blocks, "density")
                self.assertEqual((told, drawn["density"].min(), drawn["density"].max()), ("", 0, 100))
                self.assertEqual(blocks[0]["density"].dtype, types[0])  # the blocks are left alone

    def test_flags_that_only_some_have(self):
        """A coarse block whose covered cells are marked, beside a fine one that has no flags."""
        coarse = cube()
        coarse.cell_data["vtkGhostType"] = np.where(np.arange(coarse.n_cells) < 9, 8, 0).astype(np.uint8)  # refined
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            drawn, _ = self.add(add, {"coarse": coarse, "fine": cube(5.0)}, "density")
            self.assertEqual((drawn.cell_data["vtkGhostType"] == 8).sum(), 9)

    def test_points_of_a_common_face_are_drawn_once(self):
        drawn, _ = self.add(nephoscope.add_splats, [cube(), cube(1.0)], "density")
        self.assertEqual(drawn.n_points, 64 + 48)
        particles = pyvista.PolyData(np.zeros((5, 3)))
        particles["density"] = np.ones(5)
        drawn, _ = self.add(nephoscope.add_splats, [particles, particles], "density")
        self.assertEqual(drawn.n_points, 10)  # particles in one place are several

    def test_nothing_left(self):
        with self.assertRaisesRegex(ValueError, "no 3-D cells"):
            nephoscope.add_cells(self.plotter, pyvista.MultiBlock({"wall": patch("density")}), "density")


if __name__ == "__main__":
    unittest.main()
