# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Constant data on a lattice are drawn flat from any direction, and splats draw one picture in any order of the input."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

LAYERS = 8
RIPPLE = 0.006


def shapes_of_cubes(edge, count):
    array = vtkFloatArray()
    array.SetName("shape")
    array.SetNumberOfComponents(9)
    for _ in range(count):
        array.InsertNextTuple9(edge, 0, 0, 0, edge, 0, 0, 0, edge)
    return array


def as_list(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def closed_shell(axis):
    """Half of a shell around z, stored with the angle along this axis, and its points as a list."""
    sizes = [4, 5]
    sizes.insert(axis, 33)
    index = np.stack(np.meshgrid(*map(np.arange, sizes), indexing="ij"))
    angle = 2 * np.pi * (index[axis] % 32) / 32
    radius, z = (4 + index[other] for other in range(3) if other != axis)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=-1)
    grid = vtkStructuredGrid()
    grid.SetDimensions(sizes)
    grid.SetPoints(meshes.vtk_points(points.transpose(2, 1, 0, 3).reshape(-1, 3)))
    return meshes.with_field(grid, lambda p: 0 * p[:, 0])


class Flatness(ImageTestCase):
    def draw(self, data, transfer, direction, parallel_scale=2.5, size=(96, 96), factor=1.0, association="point"):
        window = Window(size)
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetRadiusFactor(factor)
        scene.add_volume(mapper, data, transfer, association=association)
        center = np.array(data.GetCenter())
        scene.look(center + 60 * np.asarray(direction), center, (0.1, 1, 0.05), parallel_scale=parallel_scale, near=5, far=150)
        window.render()
        self.fail_on_messages(window)
        return float_image(mapper)

    def test_slab_is_flat_from_any_direction(self):
        rng = np.random.default_rng(11)
        worst = 0
        for i in range(10):
            spacing = (1, 1, 1) if i < 6 else tuple(rng.uniform(0.6, 1.6, 3))
            data = meshes.with_field(meshes.image((40, 40, LAYERS - 1), spacing), lambda p: 0 * p[:, 0])
            direction = np.array([0, 0, 1.0]) if i == 0 else np.append(rng.uniform(-0.7, 0.7, 2), 1)
            direction /= np.linalg.norm(direction)
            depth = -np.log1p(-self.draw(data, constant(0.1), direction)[..., 3])
            exact = 0.1 * (LAYERS - 1) * spacing[2] / direction[2]
            ripple = np.abs(depth / exact - 1).max()
            worst = max(worst, ripple)
            self.assertLessEqual(ripple, RIPPLE, f"direction {direction}, spacing {spacing}")
        print(f"  largest ripple {100 * worst:.2f} %")

    def test_thin_cells_have_their_optical_depth(self):
        """Cells of weather models are a thousand times as wide as they are thick; of an image, and of a list of cells."""
        for width in (10, 60, 300, 1000, 5000):
            image = meshes.image((20, 20, LAYERS), (width, width, 1))
            meshes.add_array(image.GetCellData(), np.ones(image.GetNumberOfCells()), "s")
            for name, data in (("image", image), ("list of cells", as_list(image))):
                depth = -np.log1p(-self.draw(data, constant(0.1), (0, 0, 1), parallel_scale=2.5 * width, association="cell")[..., 3])
                np.testing.assert_allclose(depth, 0.1 * LAYERS, rtol=0.02, err_msg=f"{name}, {width} to 1")

    def test_closed_along_any_axis(self):
        """A grid that comes back to where it began has no seam, whichever of its axes goes around: each angle looks like the others."""
        for axis in range(3):
            depth = -np.log1p(-self.draw(closed_shell(axis), constant(0.03), (0, 0, 1), parallel_scale=12)[..., 3])
            quarters = [np.rot90(depth, turn) for turn in range(4)]
            self.assertGreater(depth.max(), 0.1)
            for other in quarters[1:]:
                np.testing.assert_allclose(other, quarters[0], atol=0.02 * depth.max(), err_msg=f"around axis {axis}")

    def ripple_of_flat_cells(self, ordered, direction, height=0.05):
        """A thick medium that is bright above and dark below; its layers are even."""
        data = meshes.with_field(meshes.image((40, 40, LAYERS - 1), (1, 1, height)), lambda p: p[:, 2] / (height * LAYERS))
        window = Window((96, 96))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetOrderByLayers(ordered)
        scene.add_volume(mapper, data, Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 1), (1, 1)], unit_distance=0.1))
        center = np.array(data.GetCenter())
        scene.look(center + 60 * np.asarray(direction), center, (0.1, 1, 0.05), parallel_scale=2.5, near=5, far=150)
        window.render()
        self.fail_on_messages(window)
        picture = float_image(mapper)
        return np.ptp(picture[..., 0]) / picture[..., 0].mean()

    def test_flat_cells_have_no_ribs(self):
        """Seen from the side, the lower cells of the next column are nearer to the eye than the upper ones of this column, but do not hide them."""
        for direction in ((0.5, 0.3, 0.8), (-0.8, 0.1, 0.6), (0.1, 0.85, -0.5)):
            direction = np.array(direction) / np.linalg.norm(direction)
            ribs, even = (self.ripple_of_flat_cells(ordered, direction) for ordered in (False, True))
            print(f"  ribs by distance {100 * ribs:.1f} %, by layers {100 * even:.2f} %")
            self.assertLess(even, 0.01)
            self.assertGreater(ribs, 5 * even)

    def test_surface_of_long_cells_has_no_gaps(self):
        """A sheet of quadrilaterals or triangles four times as long as wide is even, and so are the rings of a disk around a point."""
        def sheet(rows, columns, place, triangles):
            points = [place(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
            quads = [(a, a + 1, a + columns + 2, a + columns + 1) for j in range(rows) for a in range(j * (columns + 1), j * (columns + 1) + columns)]
            cells = [t for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))] if triangles else quads
            return meshes.with_field(meshes.surface(np.array(points, float), cells), lambda p: 0 * p[:, 0])

        flat = lambda u, v: (8 * u - 4, 8 * v - 4, 0)
        disk = lambda u, v: (4 * v * np.cos(2 * np.pi * u), 4 * v * np.sin(2 * np.pi * u), 0)
        for name, data, most in (("quadrilaterals", sheet(10, 40, flat, False), 0.02), ("triangles", sheet(10, 40, flat, True), 0.02),
                                 ("disk", sheet(8, 64, disk, False), 0.3)):
            depth = -np.log1p(-self.draw(data, constant(0.1), (0, 0, 1), 2.4)[..., 3])
            # Cells are as thick as a ball of their area, so what is even is the depth by that.
            y, x = np.mgrid[-2.4:2.4:96j, -2.4:2.4:96j]
            radius = np.hypot(x, y) if name.startswith("disk") else 0 * x + 1
            counts = [depth[(radius >= r) & (radius < r + 0.3)] for r in (np.arange(0.6, 2.0, 0.3) if name.startswith("disk") else (0.9,))]
            ripple = max(np.abs(ring / ring.mean() - 1).max() for ring in counts)
            print(f"  {name}: {100 * ripple:.1f} %")
            self.assertLess(ripple, most, name)

    def test_wider_splats_keep_the_medium(self):
        """Inside a slab of constant data the optical depth stays, more evenly; near its faces it is blurred."""
        data = meshes.with_field(meshes.image((40, 40, 11)), lambda p: 0 * p[:, 0])
        for factor in (1.5, 2.0):
            depth = -np.log1p(-self.draw(data, constant(0.1), (0, 0, 1), factor=factor)[..., 3])
            self.assertLessEqual(np.abs(depth / 1.1 - 1).max(), RIPPLE, f"factor {factor}")
        gaps = -np.log1p(-self.draw(data, constant(0.1), (0, 0, 1), factor=0.25)[..., 3])
        self.assertGreater(gaps.max(), 4 * gaps.mean())

    def test_wider_splats_of_a_shape_are_those_of_a_wider_cell(self):
        points = np.random.default_rng(8).uniform(-1, 1, (50, 3))
        data = meshes.particles(points)
        meshes.add_array(data.GetPointData(), np.zeros(50))
        mean = self.draw(data, constant(8.0), (0, 0, 1), 2.0, factor=1.6)
        edges = np.ptp(points, axis=0)
        data.GetPointData().AddArray(shapes_of_cubes(1.6 * np.cbrt(edges.prod() / 50), 50))
        window = Window((96, 96))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetShapeArrayName("shape")
        scene.add_volume(mapper, data, constant(8.0 / 1.6**3))
        center = np.array(data.GetCenter())
        scene.look(center + (0, 0, 60), center, (0.1, 1, 0.05), parallel_scale=2.0, near=5, far=150)
        window.render()
        self.assertGreater(mean[..., 3].max(), 0.3)
        np.testing.assert_allclose(float_image(mapper), mean, atol=2e-5)

    def test_picture_does_not_depend_on_the_order_of_the_input(self):
        rng = np.random.default_rng(5)
        points = rng.uniform(-1, 1, (200, 3))
        points[100:] = np.round(points[100:], 1)  # some at equal depths
        values = rng.uniform(0, 1, 200)
        transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 2), (1, 4)])
        pictures = []
        for order in (np.arange(200), rng.permutation(200)):
            data = meshes.particles(points[order])
            meshes.add_array(data.GetPointData(), values[order])
            pictures.append(self.draw(data, transfer, (0, 0, 1), 1.5))
        self.assertGreater(pictures[0][..., 3].max(), 0.3)
        np.testing.assert_array_equal(pictures[0], pictures[1])

    def test_points_in_one_place_are_in_the_order_of_their_values(self):
        rng = np.random.default_rng(9)
        points = np.repeat(rng.uniform(-1, 1, (40, 3)), 4, axis=0)
        values = rng.uniform(0, 1, 160)
        transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 6), (1, 9)])
        pictures = []
        for order in (np.arange(160), rng.permutation(160), np.arange(160)[::-1]):
            data = meshes.particles(points[order])
            meshes.add_array(data.GetPointData(), values[order])
            pictures.append(self.draw(data, transfer, (0, 0, 1), 1.5))
        self.assertGreater(pictures[0][..., 3].max(), 0.3)
        for picture in pictures[1:]:
            np.testing.assert_array_equal(picture, pictures[0])

    def test_transparency_does_not_depend_on_the_order_of_the_splats(self):
        """Seen from the opposite side, along the same rays, other splats are in front: the transparency is the same to rounding, and so is the
        light where all have one colour; of several colours it is another."""
        rng = np.random.default_rng(12)
        data = meshes.particles(rng.uniform(-1, 1, (300, 3)))
        meshes.add_array(data.GetPointData(), rng.uniform(0, 1, 300))
        opacities = [(0, 1), (1, 6)]
        one = Transfer([(0, 0.4, 0.6, 0.8), (1, 0.4, 0.6, 0.8)], opacities)
        two = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], opacities)
        for transfer, commutes in ((one, True), (two, False)):
            front = self.draw(data, transfer, (0, 0, 1), 1.5)
            back = self.draw(data, transfer, (0, 0, -1), 1.5)[:, ::-1]
            self.assertGreater(front[..., 3].max(), 0.5)
            np.testing.assert_allclose(back[..., 3], front[..., 3], atol=3e-6)
            difference = np.abs(back[..., :3] - front[..., :3]).max()
            print(f"  {'one colour' if commutes else 'two colours'}: light differs by {difference:.1e}")
            (self.assertLess if commutes else self.assertGreater)(difference, 3e-6 if commutes else 0.1)

    def test_tiny_splats_keep_their_mass(self):
        """Far below a pixel, the light of all pixels together stays that of the splats."""
        points = np.random.default_rng(2).uniform(-1, 1, (60, 3))
        data = meshes.particles(points)
        meshes.add_array(data.GetPointData(), np.zeros(60))
        sums = []
        for pixels in (512, 24):
            window = Window((pixels, pixels))
            scene = window.add_scene()
            mapper = nephoscope.vtkTexturedSplatMapper()
            mapper.SetCellSize(0.04)
            scene.add_volume(mapper, data, constant(1e-3))
            scene.look((0, 0, 10), (0, 0, 0), parallel_scale=1.5)
            window.render()
            depth = -np.log1p(-float_image(mapper)[..., 3])
            sums.append(depth.sum() * (3 / pixels)**2)
        print(f"  mass large {sums[0]:.4g}, tiny {sums[1]:.4g}, exact {1e-3 * 60 * 0.04**3:.4g}")
        self.assertAlmostEqual(sums[0] / (1e-3 * 60 * 0.04**3), 1, delta=0.01)
        self.assertAlmostEqual(sums[1] / (1e-3 * 60 * 0.04**3), 1, delta=0.05)


if __name__ == "__main__":
    unittest.main()
