# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats against cell compositing of the same field: two reconstructions, whose pictures become one as the samples of a smooth field
get closer, with the square of their distance."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer

COLORS = Transfer([(0, 1, 0.2, 0.1), (1.5, 0.1, 0.4, 1)], [(0, 0), (1.5, 4.5)])

THRESHOLD = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.4, 1)], [(0, 0), (0.5, 0), (1, 0.2)])


def bump(points):
    """Smooth, and 0 on the faces of the unit cube."""
    x, y, z = (2 * points - 1).T
    shape = np.cos(np.pi * x / 2) * np.cos(np.pi * y / 2) * np.cos(np.pi * z / 2)
    return shape**4 * (1 + 0.5 * np.sin(3 * x + 2 * y - z))


def bent(points):
    return points + 0.05 * np.sin(3 * points[:, [1, 2, 0]])


class SplatsAgainstCells(ImageTestCase):
    def draw(self, mapper, data):
        window = Window((64, 64))
        scene = window.add_scene()
        scene.add_volume(mapper, data, COLORS)
        scene.look((2.3, 1.9, 3.5), (0.5, 0.5, 0.5), angle=25)
        window.render()
        self.fail_on_messages(window)
        return float_image(mapper)

    def compare(self, label, make):
        found = []
        for blocks in (8, 16, 32):
            data = make(blocks)
            splats, cells = self.draw(nephoscope.vtkTexturedSplatMapper(), data), self.draw(nephoscope.vtkCellCompositingMapper(), data)
            difference = np.abs(splats - cells)
            found.append((np.sqrt((difference**2).mean()), difference[..., 3].max(), difference[..., :3].max()))
            print(f"  {label}, {blocks}^3 cells: root mean square {found[-1][0]:.2e}, largest of opacity {found[-1][1]:.1e}, "
                  f"of colour {found[-1][2]:.1e}", flush=True)
        self.assertGreater(cells[..., 3].max(), 0.5)
        rms = [f[0] for f in found]
        for coarse, fine in zip(rms[:-1], rms[1:]):
            self.assertGreater(coarse / fine, 3.3)
        self.assertLess(found[-1][1], 3e-3)
        self.assertLess(found[-1][2], 5e-3)

    def test_smooth_field_on_a_grid(self):
        self.compare("grid", lambda n: meshes.with_field(meshes.image((n,) * 3, (1 / n,) * 3), bump))

    def test_smooth_field_on_a_bent_grid(self):
        def make(n):
            data = meshes.structured((n,) * 3, bent)
            meshes.add_array(data.GetPointData(), bump(meshes.Lattice(n).points))
            return data
        self.compare("bent grid", make)

    def test_smooth_field_on_unstructured_cells(self):
        def make(n):
            data = meshes.Lattice(n).mesh("hexahedron", bent)
            meshes.add_array(data.GetPointData(), bump(meshes.Lattice(n).points))
            return data
        self.compare("unstructured", make)

    def opacity(self, mapper, data):
        """Mean opacity of the picture, of thin clouds: the optical depth adds up."""
        window = Window((96, 96))
        scene = window.add_scene()
        scene.add_volume(mapper, data, THRESHOLD)
        scene.look((2.3, 1.9, 3.5), (0.5, 0.5, 0.5), angle=30)
        window.render()
        self.fail_on_messages(window)
        return float_image(mapper)[..., 3].mean()

    def test_threshold(self):
        """An opacity function with a threshold, of values that change from point to point: as opaque as the cells are."""
        lattice = meshes.Lattice(9)
        values = np.random.default_rng(7).random(len(lattice.points))
        values[((lattice.points < 0.01) | (lattice.points > 0.99)).any(axis=1)] = 0  # splats reach beyond the boundary, cells do not
        grid = meshes.structured((9, 9, 9), bent)
        meshes.add_array(grid.GetPointData(), values)
        solids = {"grid": grid}
        for kind in ("hexahedron", "voxel", "wedge", "mixed", "tetra"):
            solids[kind] = lattice.mesh(kind, None if kind == "voxel" else bent)
            meshes.add_array(solids[kind].GetPointData(), values)
        for label, data in solids.items():
            trilinear = nephoscope.vtkCellCompositingMapper()
            trilinear.SetCellInterpolationToTrilinear()
            cells = self.opacity(trilinear, data)
            mapper = nephoscope.vtkTexturedSplatMapper()
            interpolated = self.opacity(mapper, data) / cells
            mapper.InterpolateScalarsBeforeMappingOff()
            each = self.opacity(mapper, data) / cells
            print(f"  {label}: opacity of splats over that of cells {interpolated:.3f}, mapped sample by sample {each:.3f}", flush=True)
            self.assertAlmostEqual(interpolated, 1, delta=0.02)
            self.assertGreater(each, 1.05)


if __name__ == "__main__":
    unittest.main()
