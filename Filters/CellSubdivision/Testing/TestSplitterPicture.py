# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pieces drawn as a volume are the picture of the cells they were cut from: no ray finds a gap or an overlap."""
import unittest

import numpy as np
from nephoscope_testing import meshes, reference
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import random_transfer
from split_checks import split
from split_meshes import centred


class Picture(ImageTestCase):
    def check_picture(self, data, values, label, decompose=False):
        rng = np.random.default_rng(8)
        low, high = meshes.vtk_to_numpy(data.GetPointData().GetArray("s")).min(), meshes.vtk_to_numpy(data.GetPointData().GetArray("s")).max()
        values = [low + v * (high - low) for v in values]
        pieces = split(data, values, GenerateSurfaces=False)
        window = Window((96, 96))
        scene, ours, transfer = window.add_scene(), mapper(), random_transfer(rng, 4)
        volume = scene.add_volume(ours, pieces, transfer)
        scene.look_at(volume, rng.normal(size=3))
        window.render()
        cells, view = cells_of(data, decompose=decompose), scene.view()
        mask = edge_mask(cells_of(pieces, decompose=decompose).drawn_edges(), view)
        self.assertLess(mask.mean(), 0.5)
        self.check_float(float_image(ours), reference.render(cells, view, transfer), label, mask=mask)
        self.fail_on_messages(window, label)

    def test_tetrahedra(self):
        data = meshes.delaunay(np.random.default_rng(6), 40)
        values = np.random.default_rng(7).uniform(size=data.GetNumberOfPoints())  # nothing but linear in each
        meshes.add_array(data.GetPointData(), values)
        self.check_picture(data, [0.3, 0.5, 0.8], "pieces of tetrahedra")

    def test_warped_hexahedra_with_whole_ones_beside(self):
        """Whole cells are drawn with the same triangles as their divided neighbours have."""
        def warped(p):
            return centred(p) + np.random.default_rng(11).uniform(-0.1, 0.1, p.shape)
        data = meshes.Lattice(2).mesh("hexahedron", warped)
        meshes.with_field(data, lambda p: p[:, 0] + 0.5 * p[:, 1] ** 2 - 0.2 * p[:, 2])
        self.check_picture(data, [0.85], "pieces of warped hexahedra", decompose="cones")


if __name__ == "__main__":
    unittest.main()
