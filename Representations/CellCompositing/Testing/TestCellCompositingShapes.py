# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes that rays leave and enter again: holes, separate parts, and parts that overlap in a cycle without touching. Every tetrahedron
has a colour of its own, so that a wrong order shows."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, cells_of
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.offscreen import float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import vtk_to_numpy


def colours(rng, extinction):
    """Sixteen unrelated colours over [0, 1], one extinction."""
    at = np.linspace(0, 1, 16)
    return Transfer(np.column_stack([at, rng.uniform(0, 1, (16, 3))]), [(0, extinction), (1, extinction)])


def random_cells(data, rng):
    meshes.add_array(data.GetCellData(), rng.uniform(0, 1, data.GetNumberOfCells()))
    return data


def cells_with(data, keep):
    """The tetrahedra i of a mesh for which keep(i, centre)."""
    points, cells = meshes.points_of(data), []
    for i in range(data.GetNumberOfCells()):
        ids = [data.GetCell(i).GetPointId(k) for k in range(4)]
        if keep(i, points[ids].mean(axis=0)):
            cells.append(ids)
    return meshes.tetrahedra(points, cells)


def box(low, high, blocks):
    lattice = meshes.Lattice(blocks)
    return lattice.mesh("tetra", lambda p: np.array(low) + p * (np.array(high) - low))


def joined(parts):
    """One mesh of several, no point shared."""
    points, cells = [], []
    for part in parts:
        first = sum(len(p) for p in points)
        points.append(meshes.points_of(part))
        cells += [[first + part.GetCell(i).GetPointId(k) for k in range(4)] for i in range(part.GetNumberOfCells())]
    return meshes.tetrahedra(np.vstack(points), cells)


def three_bars():
    """Square bars that do not touch, each of six tetrahedra: along z, every bar is in front of the next."""
    bars = []
    for turn in (0, 2 * np.pi / 3, 4 * np.pi / 3):
        c, s = np.cos(turn), np.sin(turn)

        def place(p, c=c, s=s):
            x, y, z = -1.2 + 2.4 * p[:, 0], -0.5 + 0.16 * (p[:, 1] - 0.5), 0.3 - 0.6 * p[:, 0] + 0.16 * (p[:, 2] - 0.5)
            return np.column_stack([c * x - s * y, s * x + c * y, z])
        bars.append(meshes.Lattice(1).mesh("tetra", place))
    return joined(bars)


class Shapes(ImageTestCase):
    def views(self, data, label, looks, extinction=4.0, size=(80, 80)):
        """Holds each view to the reference; the order of centroids must be seen to fail in one of them."""
        rng = np.random.default_rng(11)
        random_cells(data, rng)
        transfer, worst = colours(rng, extinction), 0
        for number, look in enumerate(looks):
            ours, window, scene, expected = self.check(data, transfer, f"{label} {number}", "cell", look=look, size=size)
            mask = edge_mask(cells_of(data, "cell").drawn_edges(), scene.view())
            ours.SetVisibilityOrderToCentroid()
            window.render()
            self.assertEqual(ours.GetNumberOfRayLayers(), 0, "projected")
            worst = max(worst, Difference(float_image(ours), expected, mask).maximum)
        print(f"  {label}: order Centroid is wrong by up to {worst:.3f}")
        self.assertGreater(worst, 0.01, label)

    LOOKS = (dict(direction=(3, 1, 0.5)), dict(direction=(0.4, 0.2, 1), parallel=True),
             lambda s: s.look((0.05, -0.1, 0.0), (1, 0.5, 0.2), angle=70, near=0.01, far=9))

    def test_holes(self):
        inner = lambda c: np.abs(c - 0.5) < 1 / 6
        tunnels = cells_with(meshes.Lattice(3).mesh("tetra"), lambda i, c: inner(c).sum() < 2)
        cavity = cells_with(meshes.Lattice(3).mesh("tetra"), lambda i, c: not inner(c).all())
        for label, data in (("tunnels", tunnels), ("cavity", cavity)):
            data.GetPoints().SetData(meshes.vtk_points(meshes.points_of(data) - 0.5).GetData())
            self.views(data, label, self.LOOKS)

    def test_a_shell_without_a_planet(self):
        data = meshes.shell(longitudes=14, latitudes=7, layers=2)
        self.views(data, "shell", (self.LOOKS[0], self.LOOKS[2]), 3.0)

    def test_separate_parts(self):
        blocks = joined([box((-1, -0.1, -0.1), (1, 0.1, 0.1), (6, 1, 1)), box((0.6, 0.15, -0.2), (0.9, 0.5, 0.2), 2),
                         box((-0.9, -0.6, -0.3), (0.9, -0.15, 0.4), 1)])
        self.views(blocks, "blocks", (dict(direction=(0.3, 1, 0.1)), dict(direction=(-0.2, -1, 0.3), parallel=True)))
        nested = joined([meshes.shell(10, 5, 1, (r, r + 0.2)) for r in (0.5, 0.8, 1.1)])
        self.views(nested, "nested shells", (self.LOOKS[0], self.LOOKS[2]))

    def test_tetrahedra_missing_at_random(self):
        rng = np.random.default_rng(12)
        data = cells_with(meshes.delaunay(rng, 90), lambda i, c: rng.uniform() > 0.6)
        self.views(data, "gaps", self.LOOKS[:2])

    def test_bars_in_a_cycle(self):
        for label, look in (("above", dict(direction=(0, 0, 1), parallel=True)), ("below", dict(direction=(0, 0, -1))),
                            ("oblique", dict(direction=(0.2, 0.1, 1))), ("the side", dict(direction=(1, 0.3, 0.1)))):
            rng = np.random.default_rng(13)
            data = random_cells(three_bars(), rng)
            self.check(data, colours(rng, 8.0), f"bars from {label}", "cell", look=look, size=(128, 128))

    def test_interlaced_rods(self):
        """Seen along a diagonal, all are in one cycle."""
        rods = []
        for axis in range(3):
            for i, j in np.ndindex(2, 2):
                low, high = np.full(3, -0.5), np.full(3, 0.5)
                for side, middle in ((1, i / 2 - 0.375), (2, j / 2 - 0.125)):
                    low[(axis + side) % 3], high[(axis + side) % 3] = middle - 0.1, middle + 0.1
                rods.append(box(low, high, 1))
        self.views(joined(rods), "rods", (dict(direction=(1, 1, 1), parallel=True), dict(direction=(1, 0.9, 0.8))), 6.0)

    def test_a_twisted_tube(self):
        """Each sector leans over the next, all the way round."""
        def twisted(p):
            angle, r = 2 * np.pi * (p[:, 0] % 1) + p[:, 2] - 0.5, 0.6 + 0.4 * p[:, 1]
            return np.column_stack([r * np.cos(angle), r * np.sin(angle), p[:, 2] - 0.5])
        looks = (dict(direction=(0.02, 0.01, 1)), dict(direction=(0.5, 0.3, 1), parallel=True))
        self.views(meshes.Lattice((24, 2, 2)).mesh("tetra", twisted), "tube", looks)

    def test_scalars_on_points_of_bars(self):
        """A linear field for colour, and for opacity from another array."""
        data = meshes.with_field(three_bars(), lambda p: 0.5 + 0.3 * p[:, 0] - 0.2 * p[:, 1])
        transfer = Transfer([(0, 1, 0, 0), (0.4, 0, 1, 0), (1, 0, 0, 1)], [(0, 1), (0.5, 9), (1, 2)])
        drawn = self.check(data, transfer, "bars with a field", look=dict(direction=(0, 0, 1)), size=(128, 128))
        whole = float_image(drawn[0])
        meshes.add_array(data.GetPointData(), vtk_to_numpy(data.GetPointData().GetArray("s")), "same")
        drawn[0].SetOpacityArrayName("same")
        drawn[1].render()
        self.check_float(float_image(drawn[0]), whole, "opacity from a copy of the array", 1e-6)


if __name__ == "__main__":
    unittest.main(verbosity=2)
