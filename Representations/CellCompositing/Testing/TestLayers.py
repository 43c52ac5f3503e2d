# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colour and opacity that jump: transfer functions per layer, layers between contour values, and functions with jumps."""
import math
import unittest

import numpy as np
from nephoscope_testing import contours, meshes
from nephoscope_testing.checks import SHIFTS, ImageTestCase, cells_of, forgive_shift, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.contours import Jumps, Surface
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant, random_transfer
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON

TOLERANCE = 1e-4


class LayerTestCase(ImageTestCase):
    def draw(self, data, transfer, configure, look=None, association="point"):
        window = Window((96, 96))
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer, association=association)
        scene.look_at(volume, **(look or {}))
        ours.ContourLightingOff()
        configure(ours)
        window.render()
        self.fail_on_messages(window)
        self.kept = window, scene, volume
        return ours, scene.view(), float_image(ours)

    def compare(self, image, draw, view, cells, label, tolerance=TOLERANCE):
        expected, mask = draw(view), edge_mask(cells.drawn_edges(), view)
        if Difference(image, expected, mask).maximum > tolerance:
            image = forgive_shift(image, expected, [draw(view.shifted(*s)) for s in SHIFTS], label)
        self.check_float(image, expected, label, tolerance, mask)


def linear_mesh(rng, count=120):
    data = meshes.delaunay(rng, count)
    return meshes.with_field(data, meshes.linear_field(rng, data))


def scaled(rng, distance):
    transfer = random_transfer(rng, 4)
    transfer.unit_distance = distance
    return transfer


class OfCells(LayerTestCase):
    def test_random_layers(self):
        """Layer numbers of any size and sign; one of them has no property."""
        for seed in range(3):
            rng = np.random.default_rng([41, seed])
            data = linear_mesh(rng)
            numbers = rng.choice([-3, 0, 7, 100000], data.GetNumberOfCells())
            meshes.add_array(data.GetCellData(), numbers.astype(np.int32), "Layer")
            transfer, layers = random_transfer(rng, 4), {n: scaled(rng, d) for n, d in ((-3, 0.3), (7, 2.0), (100000, 1.0))}

            def configure(ours):
                ours.SetLayerArrayName("Layer")
                for number, function in layers.items():
                    ours.SetLayerProperty(number, function.volume_property())
            _, view, image = self.draw(data, transfer, configure, dict(direction=rng.normal(size=3), parallel=seed == 1))
            cells = cells_of(data)
            self.compare(image, lambda v: contours.render(cells, v, transfer, layers=layers, layer_of_cell=numbers), view, cells,
                         f"layers of cells, seed {seed}")

    def test_with_surfaces_and_cell_scalars(self):
        rng = np.random.default_rng(42)
        data = linear_mesh(rng)
        numbers = rng.integers(0, 2, data.GetNumberOfCells())
        meshes.add_array(data.GetCellData(), numbers.astype(np.int64), "Layer")
        transfer, layers = random_transfer(rng, 4), {1: random_transfer(rng, 4)}

        def configure(ours):
            ours.SetLayerArrayName("Layer")
            ours.SetLayerProperty(1, layers[1].volume_property())
            ours.SetContourValue(0, 0.45)
        _, view, image = self.draw(data, transfer, configure)
        cells = cells_of(data)
        self.compare(image, lambda v: contours.render(cells, v, transfer, [Surface(0.45)], None, layers, numbers), view, cells,
                     "layers of cells with a surface")
        meshes.add_array(data.GetCellData(), rng.uniform(size=data.GetNumberOfCells()), "s")

        def without_surface(ours):
            configure(ours)
            ours.SetNumberOfContourValues(0)
        _, view, image = self.draw(data, transfer, without_surface, association="cell")
        cells = cells_of(data, "cell")
        self.compare(image, lambda v: contours.render(cells, v, transfer, (), None, layers, numbers), view, cells,
                     "layers of cells with cell scalars")

    def test_a_transparent_volume_with_an_opaque_layer(self):
        data = meshes.with_field(meshes.Lattice((1, 1, 4)).mesh("hexahedron"), lambda p: p[:, 2])
        meshes.add_array(data.GetCellData(), np.array([0, 1, 2, 1], np.int32), "Layer")
        layer = constant(2.0, (0, 1, 0))

        def configure(ours):
            ours.SetLayerArrayName("Layer")
            ours.SetLayerProperty(1, layer.volume_property())
        ours, _, image = self.draw(data, constant(0.0), configure, dict(direction=(0, 0, 1), parallel=True))
        alpha = -math.expm1(-1.0)  # half of the length, extinction 2
        np.testing.assert_allclose(image[48, 48], [0, alpha, 0, alpha], atol=2e-6)
        self.assertEqual(ours.GetNumberOfDrawnTetrahedra(), 10)

    def test_changes_are_drawn(self):
        data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
        meshes.add_array(data.GetCellData(), np.array([5], np.int32), "Layer")
        ours, _, image = self.draw(data, constant(1.0), lambda m: m.SetLayerArrayName("Layer"), dict(direction=(0, 0, 1), parallel=True))
        window, _, volume = self.kept
        look = lambda: (window.render(), float_image(ours)[48, 48, 3])[1]
        self.assertAlmostEqual(look(), -math.expm1(-1), places=5)
        prop = constant(3.0).volume_property()
        ours.SetLayerProperty(5, prop)
        self.assertAlmostEqual(look(), -math.expm1(-3), places=5)
        prop.SetScalarOpacityUnitDistance(2)
        self.assertAlmostEqual(look(), -math.expm1(-1.5), places=5)
        prop.GetScalarOpacity().RemoveAllPoints()
        prop.GetScalarOpacity().AddPoint(0, 0.5)
        self.assertAlmostEqual(look(), -math.expm1(-0.25), places=5)
        self.assertIs(ours.GetLayerProperty(5), prop)
        ours.SetLayerProperty(5, None)
        self.assertAlmostEqual(look(), -math.expm1(-1), places=5)

    def test_unit_distance_never_set(self):
        """VTK's default of 1 means that of the volume, whatever the size of the data; what was set holds, and 1 next to it too."""
        for size in (1e-6, 1.0, 1e5):
            data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
            for i in range(data.GetNumberOfPoints()):
                data.GetPoints().SetPoint(i, *(size * np.array(data.GetPoint(i))))
            meshes.add_array(data.GetCellData(), np.array([5], np.int32), "Layer")
            volume = constant(0.1)
            volume.unit_distance = size
            for distance, depth in ((1.0, 3.0), (2 * size, 1.5), (size / 4, 12.0), (np.nextafter(1.0, 2.0), 3 * size)):
                prop = constant(3.0).volume_property()
                prop.SetScalarOpacityUnitDistance(distance)

                def configure(ours):
                    ours.SetLayerArrayName("Layer")
                    ours.SetLayerProperty(5, prop)
                _, _, image = self.draw(data, volume, configure, dict(direction=(0, 0, 1), parallel=True))
                self.assertAlmostEqual(image[48, 48, 3], -math.expm1(-depth), delta=2e-5, msg=f"{size:g}, {distance:g}")

    def test_missing_array(self):
        data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
        window = Window((16, 16))
        scene = window.add_scene()
        ours = mapper()
        scene.look_at(scene.add_volume(ours, data, constant()))
        ours.SetLayerArrayName("nothing")
        ours.SetLayerProperty(0, constant().volume_property())
        window.render()
        self.assertIn("No cell array named 'nothing'", " ".join(str(m) for m in window.messages.all))


class BetweenContours(LayerTestCase):
    def test_jumps_at_surfaces(self):
        """Drawn and undrawn surfaces, a medium of its own in some layers."""
        for seed in range(6):
            rng = np.random.default_rng([43, seed])
            data = linear_mesh(rng)
            transfer, values = random_transfer(rng, 4), np.sort(rng.uniform(0.1, 0.9, 3))
            layers = {n: scaled(rng, rng.uniform(0.2, 3)) for n in (0, 2, 3)}
            surfaces = [Surface(v, o, (1, 1, 0)) for v, o in zip(values, ((0, 0, 0), (0.5, 0, 0.8))[seed % 2])]

            def configure(ours):
                ours.LayersFromContoursOn()
                for i, k in enumerate(rng.permutation(3)):
                    ours.SetContourValue(i, surfaces[k].value)
                    ours.SetContourOpacity(i, surfaces[k].opacity)
                    ours.SetContourColor(i, 1, 1, 0)
                for number, function in layers.items():
                    ours.SetLayerProperty(number, function.volume_property())
            _, view, image = self.draw(data, transfer, configure, dict(direction=rng.normal(size=3), parallel=seed > 2))
            cells = cells_of(data)
            self.compare(image, lambda v: contours.render(cells, v, transfer, surfaces, layers=layers), view, cells,
                         f"layers between contours, seed {seed}")

    def test_layers_of_another_array(self):
        rng = np.random.default_rng(44)
        data = linear_mesh(rng)
        second = meshes.linear_field(rng, data)
        meshes.add_array(data.GetPointData(), second(meshes.points_of(data)), "t")
        transfer, layers = random_transfer(rng, 4), {1: random_transfer(rng, 4)}
        surfaces = [Surface(0.5, 0)]

        def configure(ours):
            ours.SetContourArrayName("t")
            ours.LayersFromContoursOn()
            ours.SetContourValue(0, 0.5)
            ours.SetContourOpacity(0, 0)
            ours.SetLayerProperty(1, layers[1].volume_property())
        _, view, image = self.draw(data, transfer, configure)
        from nephoscope_testing import polyhedra
        cells, other = cells_of(data), polyhedra.from_dataset(data, "t")
        self.compare(image, lambda v: contours.render(cells, v, transfer, surfaces, other, layers), view, cells, "layers of another array")

    def test_dense_core(self):
        """Only above 0.5 is there a medium: a jump inside the cells, in closed form, from both sides."""
        data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
        for side in (1, -1):
            def configure(ours):
                ours.SetContourValue(0, 0.5)
                ours.SetContourOpacity(0, 0.0)
                ours.LayersFromContoursOn()
                ours.SetLayerProperty(1, constant(3.0, (1, 0, 0)).volume_property())
            _, _, image = self.draw(data, constant(0.0), configure, dict(direction=(0, 0, side), parallel=True))
            alpha = -math.expm1(-1.5)
            np.testing.assert_allclose(image[48, 48], [alpha, 0, 0, alpha], atol=2e-6)


class EarlierMethods(LayerTestCase):
    """Cells of different layers side by side, or one before the other where centroids have an order: no order to mistake."""
    LOOK = dict(direction=(0.05, 0.02, 1), parallel=True)

    def lattice(self):
        data = meshes.with_field(meshes.Lattice((4, 4, 1)).mesh("hexahedron"), lambda p: (p[:, 0] + p[:, 2]) / 2)
        numbers = np.arange(16, dtype=np.int32) % 3
        meshes.add_array(data.GetCellData(), numbers, "Layer")
        return data, numbers

    def test_layers_of_cells(self):
        data, numbers = self.lattice()
        ramps = {n: Transfer([(0, 1, n == 1, 0), (1, 0, 1, n == 2)], [(0, 0.5), (1, 1 + 2 * n)]) for n in (1, 2)}
        constants = {n: constant(n, (0, n == 1, n == 2)) for n in (1, 2)}
        for method, layers, tolerance in (("Faces", ramps, 2e-5), ("TrianglesTable", constants, 2e-4)):
            def configure(ours):
                getattr(ours, "SetMethodTo" + method)()
                ours.SetLayerArrayName("Layer")
                for number, function in layers.items():
                    ours.SetLayerProperty(number, function.volume_property())
            transfer = constant(0.7, (1, 0, 0))
            _, view, image = self.draw(data, transfer, configure, self.LOOK)
            cells = cells_of(data)
            self.compare(image, lambda v: contours.render(cells, v, transfer, (), None, layers, numbers), view, cells,
                         f"layers of cells, {method}", tolerance)

    def two_blocks(self, low, high):
        """One on the other, with points of their own where they touch."""
        points = np.array([(x, y, z) for z in (0, 1, 1, 2) for y in (0, 1) for x in (0, 1)], float)
        cube = [0, 1, 3, 2, 4, 5, 7, 6]
        data = meshes.grid(points, [(VTK_HEXAHEDRON, cube), (VTK_HEXAHEDRON, [8 + i for i in cube])])
        below = np.arange(16) < 8
        return meshes.with_field(data, lambda p: np.where(below, low[0] + (low[1] - low[0]) * p[:, 2],
                                                          high[0] + (high[1] - high[0]) * (p[:, 2] - 1)))

    def test_two_values_at_a_face(self):
        """The scalar jumps at a face: each of the segments that meet there has its own value."""
        data = self.two_blocks((0.0, 0.3), (1.0, 0.6))
        transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 0.2), (1, 3)])
        for side in (1, -1):
            def configure(ours):
                ours.SetMethodToFaces()
            _, view, image = self.draw(data, transfer, configure, dict(direction=(0.04, 0.03, side), parallel=True))
            cells = cells_of(data)
            self.compare(image, lambda v: contours.render(cells, v, transfer), view, cells, f"two values at a face, side {side}", 2e-5)

    def test_what_is_ignored_is_said_once(self):
        data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
        for method in ("Faces", "TrianglesLinear", "TrianglesTable"):
            window = Window((16, 16))
            scene = window.add_scene()
            ours = mapper()
            scene.look_at(scene.add_volume(ours, data, constant()))
            getattr(ours, "SetMethodTo" + method)()
            ours.SetContourValue(0, 0.5)
            ours.LayersFromContoursOn()
            ours.SetLayerProperty(1, constant(2).volume_property())
            window.render()
            window.render()
            said = [m for m in window.messages.all if "without the contour surfaces and the layers between contour values" in m]
            self.assertEqual(len(said), 1, window.messages.all)
            ours.SetContourOpacity(0.0)
            ours.RemoveAllLayerProperties()
            window.render()
            self.assertEqual(len(window.messages.all), 1, "nothing is ignored")


class JumpingFunctions(LayerTestCase):
    """Two control points at one scalar, or one double apart, in either function."""

    def property_of(self, transfer, gap):
        prop = transfer.volume_property()
        opacity, color = prop.GetScalarOpacity(), prop.GetRGBTransferFunction()
        for function, rows in ((opacity, transfer.opacities), (color, transfer.colors)):
            function.AllowDuplicateScalarsOn()
            function.RemoveAllPoints()
            last = None
            for row in rows:
                x = np.nextafter(row[0], np.inf) if gap and row[0] == last else row[0]
                (function.AddPoint if function is opacity else function.AddRGBPoint)(x, *row[1:])
                last = row[0]
            self.assertEqual(function.GetSize(), len(rows))
        return prop

    def jumping(self, rng, scale):
        """Values low, high of each piece between four places."""
        at = np.concatenate([[0], np.sort(rng.uniform(0.05, 0.95, 3)), [1]])
        rows = lambda n: np.array([(x, *rng.uniform(0, 1, n)) for i, x in enumerate(at) for _ in range(1 if i in (0, 4) else 2)])
        return Jumps(rows(3), rows(1), unit_distance=scale)

    def test_random_jumps(self):
        for seed in range(6):
            rng = np.random.default_rng([45, seed])
            data, transfer = linear_mesh(rng), self.jumping(rng, 10.0 ** rng.uniform(-1.5, 0.5))
            prop = self.property_of(transfer, gap=seed % 2)
            _, view, image = self.draw(data, prop, lambda m: None, dict(direction=rng.normal(size=3), parallel=seed > 2))
            cells = cells_of(data)
            self.compare(image, lambda v: contours.render(cells, v, transfer), view, cells, f"jumps, seed {seed}")

    def test_jump_at_a_face(self):
        """The jump lies in a plane of the lattice: each side has its own limit."""
        data = meshes.with_field(meshes.Lattice(4).mesh("tetra"), lambda p: p[:, 2])
        transfer = Jumps([(0, 1, 0, 0), (0.5, 1, 0, 0), (0.5, 0, 0, 1), (1, 0, 0, 1)], [(0, 1), (0.5, 1), (0.5, 4), (1, 4)])
        red, blue = -math.expm1(-0.5), -math.expm1(-2.0)
        for side in (1, -1):
            _, _, image = self.draw(data, self.property_of(transfer, False), lambda m: None, dict(direction=(0.001, 0.002, side), parallel=True))
            expected = [red * (1 - blue), 0, blue, 1 - (1 - red) * (1 - blue)] if side > 0 else [red, 0, blue * (1 - red), 1 - (1 - red) * (1 - blue)]
            np.testing.assert_allclose(image[50, 45], expected, atol=2e-5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
