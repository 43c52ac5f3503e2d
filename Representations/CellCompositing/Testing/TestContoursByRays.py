# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contour surfaces and layers ray by ray: every pixel crosses a whole number of surfaces, known in closed form, wherever the eye is."""
import math
import unittest

import numpy as np
from nephoscope_testing import contours, meshes
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.contours import Surface
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkFiltersCore import vtkAppendFilter

CLEAR = Transfer([(0, 1, 0.5, 0), (1, 0, 0.5, 1)], [(0, 0), (1, 0)])
OPACITY = 0.25
PLANES = (0.25, 0.5, 0.75)
NEAR = 1e-5  # a ray that enters, leaves or runs so near to a plane may be on either side of it


def unstructured(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


class RayTestCase(ImageTestCase):
    def start(self, data, values=PLANES, transfer=CLEAR, size=(48, 48), configure=None, association="point"):
        self.window = Window(size)
        self.scene = self.window.add_scene()
        self.mapper = mapper()
        self.mapper.ContourLightingOff()
        self.volume = self.scene.add_volume(self.mapper, data, transfer, association=association)
        for i, value in enumerate(values):
            self.mapper.SetContourValue(i, value)
            self.mapper.SetContourOpacity(i, OPACITY)
        if configure:
            configure(self.mapper)

    def image(self):
        self.window.render()
        self.fail_on_messages(self.window)
        return float_image(self.mapper)

    def layers(self):
        return np.log1p(-self.image()[..., 3]) / math.log(1 - OPACITY)


def through_cube(view, start):
    """z where each ray enters and leaves the unit cube, and whether it does; not for rays that pass its faces or edges near by."""
    origins, directions, near, far = view.rays()
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (0 - origins) / directions, (1 - origins) / directions
    low, high = np.fmin(a, b), np.fmax(a, b)
    parallel = directions == 0
    inside = (origins > 0) & (origins < 1)
    low = np.where(parallel, np.where(inside, -np.inf, np.inf), low)
    high = np.where(parallel, np.where(inside, np.inf, -np.inf), high)
    enter, leave = np.maximum(low.max(axis=1), near if start else -np.inf), high.min(axis=1)
    hit = (leave > enter + 1e-3) | (leave < enter - 1e-3)
    at = lambda t: origins[:, 2] + np.where(np.isfinite(t), t, 0) * directions[:, 2]
    return at(enter), at(leave), leave > enter, hit


class WholeNumbers(RayTestCase):
    """The field is z: between where a ray enters and leaves, it crosses as many surfaces as there are values."""
    MESHES = {"image": lambda: meshes.image((4, 4, 4), (0.25, 0.25, 0.25)), "tetra": lambda: meshes.Lattice(4).mesh("tetra"),
              "hexahedron": lambda: meshes.Lattice(4).mesh("hexahedron"), "odd image": lambda: meshes.image((5, 3, 4), (1 / 5, 1 / 3, 1 / 4)),
              "trilinear grid": lambda: meshes.rectilinear([np.array((0, 0.2, 0.5, 0.8, 1)), np.linspace(0, 1, 5), np.linspace(0, 1, 5)]),
              "trilinear hexahedra": lambda: meshes.Lattice(4).mesh("hexahedron"), "trilinear wedges": lambda: meshes.Lattice(4).mesh("wedge")}
    DIRECTIONS = ((0, 0, 1), (0, 0, -1), (1, 0, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (1, 1, 1), (1, -2, 3), (0.3, 0.2, -1))

    def check(self, name, values, inside):
        z0, z1, hits, sure = through_cube(self.scene.view(), inside)
        expected = np.zeros(len(z0))
        for value in values:
            expected += (z0 >= value) != (z1 >= value)
            sure &= (np.abs(z0 - value) > NEAR) & (np.abs(z1 - value) > NEAR)
        layers = self.layers().ravel()
        wrong = sure & (np.abs(layers - np.where(hits, expected, 0)) > 1e-4)
        self.assertEqual(int(wrong.sum()), 0, f"{name}: {layers[wrong][:5]} instead of {np.where(hits, expected, 0)[wrong][:5]}")
        return int((sure & hits).sum())

    def each(self):
        for name, make in self.MESHES.items():
            data = meshes.with_field(make(), lambda p: p[:, 2])
            for values in (PLANES, (0.1, 0.3, 0.6, 0.9)):
                self.start(data, values, configure=self.interpolation(name))
                yield name, values

    @staticmethod
    def interpolation(name):
        return (lambda ours: ours.SetCellInterpolationToTrilinear()) if name.startswith("trilinear") else None

    def test_from_outside(self):
        seen = 0
        for name, values in self.each():
            for parallel in (True, False):
                for direction in self.DIRECTIONS:
                    self.scene.look_at((0, 1, 0, 1, 0, 1), direction, (0, 1, 0) if direction[1] == 0 else (0.2, 0.1, 1), 1.6, parallel)
                    seen += self.check(f"{name} from {direction}, parallel {parallel}", values, False)
                    self.scene.camera.ParallelProjectionOff()
        self.assertGreater(seen, 100000)

    def test_from_inside(self):
        """On a vertex, an edge, a face, in planes of the grid, and amid a cell."""
        seen = 0
        for name, values in self.each():
            for eye in ((0.5, 0.5, 0.5), (0.5, 0.5, 0.6), (0.25, 0.6, 0.5), (0.3, 0.4, 0.5), (0.31, 0.42, 0.13), (0.5, 0.3, 0.8)):
                for direction in self.DIRECTIONS:
                    self.scene.look(eye, np.add(eye, direction), (0, 1, 0) if direction[1] == 0 else (0.2, 0.1, 1), 70, near=1e-3, far=10)
                    seen += self.check(f"{name} at {eye} towards {direction}", values, True)
        self.assertGreater(seen, 100000)

    def test_values_at_whole_cells_faces_and_vertices(self):
        """A layer of cells has the value, a plane between higher ones, a single vertex."""
        for name, make in self.MESHES.items():
            for function, value, count in ((lambda p: np.clip(p[:, 2], 0.25, 0.5), 0.5, 1), (lambda p: np.clip(p[:, 2], 0.25, 0.5), 0.25, 0),
                                           (lambda p: np.abs(p[:, 2] - 0.5), 0, 0), (lambda p: -np.abs(p[:, 2] - 0.5), 0, 2)):
                self.start(meshes.with_field(make(), function), (value,), configure=self.interpolation(name))
                for direction in ((0.1, 0.07, 1), (0, 0, 1), (0, 0, -1)):
                    self.scene.look_at((0, 1, 0, 1, 0, 1), direction, parallel=True)
                    middle = self.layers()[21:27, 21:27]
                    np.testing.assert_allclose(middle, count, atol=1e-4, err_msg=f"{name}: {value} from {direction}")

    def test_rays_are_the_default(self):
        data = meshes.with_field(meshes.Lattice(2).mesh("hexahedron"), lambda p: p[:, 2])
        self.start(data)
        self.scene.look_at(self.volume)
        self.image()
        self.assertEqual(self.mapper.GetNumberOfRayLayers(), 1)

    def test_hundreds_of_values(self):
        data = meshes.with_field(meshes.image((4, 4, 4), (0.25, 0.25, 0.25)), lambda p: p[:, 2])
        self.start(data, ())
        self.mapper.GenerateContourValues(500, 1e-3, 1 - 1e-3)
        self.mapper.SetContourOpacity(0.002)
        self.scene.look_at((0, 1, 0, 1, 0, 1), (0.1, 0.07, 1), parallel=True)
        self.assertAlmostEqual(np.log1p(-self.image()[24, 24, 3]) / math.log(1 - 0.002), 500, delta=0.01)


class Grids(RayTestCase):
    """Structured data, which rays walk through without a list of tetrahedra, against the quadrature of the same cells."""
    LOOK = dict(direction=(0.4, 0.3, 0.8), zoom=1.2)

    def grid(self, rng):
        data = meshes.image((5, 4, 6), (1 / 5, 1 / 4, 1 / 6))
        field, other = (rng.uniform(-1, 1, 3) for _ in range(2))
        meshes.with_field(data, lambda p: p @ field)
        meshes.add_array(data.GetPointData(), meshes.points_of(data) @ other + 3, "t")
        return data

    def compare(self, data, expected, label):
        cells = cells_of(unstructured(data))
        view = self.scene.view()
        self.check_float(self.image(), expected(cells, view), label, 1e-4, edge_mask(cells.drawn_edges(), view))

    def test_another_array_and_layers(self):
        from nephoscope_testing import polyhedra
        for seed in range(2):
            rng = np.random.default_rng([51, seed])
            data = self.grid(rng)
            t = meshes.points_of(data) @ np.zeros(3) + np.array([data.GetPointData().GetArray("t").GetValue(i) for i in range(data.GetNumberOfPoints())])
            values = np.quantile(t, (0.3, 0.6))
            transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 0.5), (1, 3)])
            layer = Transfer([(0, 0, 1, 0), (1, 1, 1, 0)], [(0, 2), (1, 0.2)])

            def configure(ours):
                ours.SetContourArrayName("t")
                if seed:
                    ours.LayersFromContoursOn()
                    ours.SetLayerProperty(1, layer.volume_property())
            self.start(data, values, transfer, (64, 64), configure)
            self.scene.look_at(self.volume, **self.LOOK)
            surfaces = [Surface(v, OPACITY) for v in values]
            other = polyhedra.from_dataset(unstructured(data), "t")
            self.compare(data, lambda cells, view: contours.render(cells, view, transfer, surfaces, other, {1: layer} if seed else None),
                         f"another array of a grid, layers {seed}")

    def test_layers_of_cells(self):
        rng = np.random.default_rng(52)
        data = self.grid(rng)
        numbers = rng.integers(0, 3, data.GetNumberOfCells())
        meshes.add_array(data.GetCellData(), numbers, "Layer")
        transfer, layers = constant(0.0), {1: constant(2.0, (0, 1, 0)), 2: Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 0), (1, 3)])}

        def configure(ours):
            ours.SetLayerArrayName("Layer")
            for number, function in layers.items():
                ours.SetLayerProperty(number, function.volume_property())
        self.start(data, (), transfer, (64, 64), configure)
        self.scene.look_at(self.volume, **self.LOOK)
        self.compare(data, lambda cells, view: contours.render(cells, view, transfer, (), None, layers, numbers), "layers of a grid's cells")

    def test_only_crossed_cells_count(self):
        data = meshes.with_field(meshes.image((4, 4, 4), (0.25, 0.25, 0.25)), lambda p: p[:, 2])
        for value, layers in ((0.3, 1), (0.5, 1), (2.0, 0)):
            self.start(data, (value,))
            self.scene.look_at(self.volume)
            self.window.render()
            self.assertLessEqual(self.mapper.GetNumberOfDrawnTetrahedra(), layers * 16 * 5)
            self.assertEqual(self.mapper.GetNumberOfDrawnTetrahedra() > 0, layers > 0)

    def test_missing_values(self):
        """No surface in the tetrahedra around a NaN; on the way behind it all are there."""
        data = meshes.with_field(meshes.image((4, 4, 4), (0.25, 0.25, 0.25)), lambda p: p[:, 0])
        values = meshes.points_of(data)[:, 2].copy()
        values[62] = np.nan
        meshes.add_array(data.GetPointData(), values, "t")
        self.start(data, (0.4, 0.9), configure=lambda m: m.SetContourArrayName("t"))
        for side in (1, -1):
            self.scene.look_at(self.volume, direction=(0.01, 0.02, side), parallel=True)
            layers = self.layers()
            self.assertAlmostEqual(layers[24, 24], 1, places=3, msg="0.9 alone")
            self.assertAlmostEqual(layers[13, 13], 2, places=3)

    def test_a_seam_where_the_contoured_array_jumps(self):
        """The grid closes on itself with the coloured array; the other one has its own value on each side, and no surface between."""
        closed = meshes.structured((8, 4, 2), lambda p: np.column_stack(
            [(1 + p[:, 2]) * np.cos(2 * np.pi * p[:, 0]), (1 + p[:, 2]) * np.sin(2 * np.pi * p[:, 0]), 3 * p[:, 1]]))
        points = meshes.points_of(closed)
        meshes.with_field(closed, lambda p: p[:, 2] / 3)
        turn = np.tile(np.arange(9) / 8, len(points) // 9)
        for values, count in ((turn, 0), (np.where(turn == 1, 0, turn), 1)):  # it jumps at the seam; it falls to 0 in the last cell
            meshes.add_array(closed.GetPointData(), values, "t")
            self.start(closed, (0.3,), configure=lambda m: m.SetContourArrayName("t"))
            self.scene.look((5, 0.04, 1.4), (0, 0.04, 1.4), (0, 0, 1), parallel_scale=0.9, near=0.1, far=20)
            layers = self.layers()
            y = self.scene.view().rays()[0][:, 1].reshape(layers.shape)
            for middle, expected in ((0, 0), (-0.4, count)):  # at the seam, and through the last cell
                seen = layers[np.abs(y - middle) < 0.06]
                self.assertGreater(seen.size, 100)
                np.testing.assert_allclose(seen, expected, atol=1e-3, err_msg=f"at {middle}")

    def test_values_that_jump_between_blocks(self):
        """Blocks that repeat their points: where the contoured array jumps past a value there is no surface."""
        points = np.array([(x, y, z) for z in (0, 1, 1, 2) for y in (0, 1) for x in (0, 1)], float)
        cube = [0, 1, 3, 2, 4, 5, 7, 6]
        data = meshes.grid(points, [(12, cube), (12, [8 + i for i in cube])])
        meshes.with_field(data, lambda p: 0 * p[:, 2])
        for low, high, count in (((0, 0.4), (0.6, 1), 0), ((0, 0.6), (0.7, 1), 1), ((0, 0.6), (0.4, 1), 2), ((0, 1), (0, 1), 2)):
            below = np.arange(16) < 8
            t = np.where(below, low[0] + (low[1] - low[0]) * points[:, 2], high[0] + (high[1] - high[0]) * (points[:, 2] - 1))
            meshes.add_array(data.GetPointData(), t, "t")
            self.start(data, (0.5,), configure=lambda m: m.SetContourArrayName("t"))
            for side in (1, -1):
                self.scene.look_at(self.volume, direction=(0.02, 0.03, side), parallel=True)
                self.assertAlmostEqual(self.layers()[24, 24], count, places=3, msg=f"{low}, {high} from {side}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
