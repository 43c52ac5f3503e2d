# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contour surfaces inside the volume: against per-ray quadrature, closed forms, and VTK's own contours drawn as polygons."""
import math
import unittest

import numpy as np
from nephoscope_testing import contours, meshes
from nephoscope_testing.checks import SHIFTS, ImageTestCase, cells_of, forgive_shift, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.contours import Surface
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, random_transfer
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper

SHADING = (0.1, 0.7, 0.2, 10)  # defaults of vtkVolumeProperty
CLEAR = Transfer([(0, 1, 0.5, 0), (1, 0, 0.5, 1)], [(0, 0), (1, 0)])
TOLERANCE = 1e-4


def add_surfaces(ours, surfaces):
    for i, surface in enumerate(surfaces):
        ours.SetContourValue(i, surface.value)
        ours.SetContourOpacity(i, surface.opacity)
        if surface.color:
            ours.SetContourColor(i, *surface.color)


class ContourTestCase(ImageTestCase):
    def draw(self, data, transfer, surfaces, configure=None, look=None, size=(96, 96), lighting=False, association="point"):
        window = Window(size)
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer, association=association)
        scene.look_at(volume, **(look or {}))
        ours.SetContourLighting(lighting)
        add_surfaces(ours, surfaces)
        if configure:
            configure(ours)
        window.render()
        self.unseen = [m for m in window.messages.all if "No contour surface is seen" in m]
        self.assertEqual(window.messages.all, self.unseen, "a normal scene must draw without other messages")
        self.kept = window, scene, volume
        return ours, scene.view(), float_image(ours)

    def compare(self, image, draw, view, cells, label, tolerance=TOLERANCE):
        expected, mask = draw(view), edge_mask(cells.drawn_edges(), view)
        if Difference(image, expected, mask).maximum > tolerance:
            image = forgive_shift(image, expected, [draw(view.shifted(*s)) for s in SHIFTS], label)
        self.check_float(image, expected, label, tolerance, mask)


class AgainstQuadrature(ContourTestCase):
    def test_planes_in_random_tetrahedra(self):
        """Unlit, lit, clear and in a medium, in perspective and parallel, opaque and translucent."""
        for seed in range(6):
            rng = np.random.default_rng([31, seed])
            data = meshes.delaunay(rng, 120)
            meshes.with_field(data, meshes.linear_field(rng, data))
            parallel, medium = seed % 2 == 0, seed % 3
            transfer = random_transfer(rng, 5, max_extinction=2 * medium)
            surfaces = [Surface(v, a, shading=SHADING if parallel else None)
                        for v, a in zip(rng.permutation(rng.uniform(0.1, 0.9, 5)), (0.2, 1, 0.5, 0, 0.7))]
            ours, view, image = self.draw(data, transfer, surfaces, lighting=parallel,
                                          look=dict(direction=rng.normal(size=3), parallel=parallel))
            cells = cells_of(data)
            self.compare(image, lambda v: contours.render(cells, v, transfer, surfaces), view, cells, f"planes, seed {seed}")

    def test_surfaces_of_another_array(self):
        """Planes of one array, coloured by another."""
        rng = np.random.default_rng(32)
        data = meshes.delaunay(rng, 120)
        meshes.with_field(data, meshes.linear_field(rng, data))
        second = meshes.linear_field(rng, data)
        meshes.add_array(data.GetPointData(), 40 * second(meshes.points_of(data)) - 7, "t")
        transfer = random_transfer(rng, 5)
        surfaces = [Surface(40 * v - 7, 0.5) for v in (0.25, 0.5, 0.75)]
        ours, view, image = self.draw(data, transfer, surfaces, lambda m: m.SetContourArrayName("t"))
        cells, other = cells_of(data), cells_of_array(data, "t")
        self.compare(image, lambda v: contours.render(cells, v, transfer, surfaces, other), view, cells, "another array")

    def test_own_colours_and_a_separate_opacity(self):
        rng = np.random.default_rng(33)
        data = meshes.delaunay(rng, 120)
        meshes.with_field(data, meshes.linear_field(rng, data))
        surfaces = [Surface(0.4, 0.3, (1, 0, 0)), Surface(0.6, 0.6, (0, 0, 1))]
        meshes.add_array(data.GetPointData(), np.full(data.GetNumberOfPoints(), 3.0), "o")
        transfer = Transfer([(0, 0, 1, 0), (1, 1, 1, 0)], [(0, 0), (6, 2)])
        ours, view, image = self.draw(data, transfer, surfaces, lambda m: m.SetOpacityArrayName("o"))
        constant = Transfer(transfer.colors, [(0, 1), (1, 1)])
        cells = cells_of(data)
        self.compare(image, lambda v: contours.render(cells, v, constant, surfaces), view, cells, "separate opacity")

    def test_order_of_cells_and_values_does_not_matter(self):
        rng = np.random.default_rng(34)
        data = meshes.delaunay(rng, 120)
        meshes.with_field(data, meshes.linear_field(rng, data))
        surfaces = [Surface(v, 0.4) for v in (0.2, 0.45, 0.7)]
        _, view, image = self.draw(data, CLEAR, surfaces, lighting=True)
        other = meshes.renumbered(data, rng)
        _, _, again = self.draw(other, CLEAR, surfaces[::-1], lighting=True)
        self.check_float(again, image, "renumbered", 1e-5, edge_mask(cells_of(data).drawn_edges(), view))


def cells_of_array(data, name):
    from nephoscope_testing import polyhedra
    return polyhedra.from_dataset(data, name)


class AtFaces(ContourTestCase):
    """Values that lie exactly in faces between cells: drawn once, from wherever one looks."""

    def alpha(self, data, values, direction, parallel=True):
        surfaces = [Surface(v, 0.25) for v in values]
        ours, view, image = self.draw(data, CLEAR, surfaces, look=dict(direction=direction, parallel=parallel))
        mask = edge_mask(cells_of(data).drawn_edges(), view)
        return np.log1p(-image[..., 3]) / math.log(0.75), mask, ours

    def check_count(self, function, values, count, kinds=("tetra", "hexahedron")):
        for kind in kinds:
            data = meshes.with_field(meshes.Lattice(4).mesh(kind), function)
            for direction in ((0.1, 0.07, 1), (0.1, 0.07, -1)):
                layers, mask, _ = self.alpha(data, values, direction)
                middle = np.zeros_like(mask)
                middle[40:56, 40:56] = True  # rays through bottom and top
                np.testing.assert_allclose(layers[middle & ~mask], count, atol=1e-5, err_msg=f"{kind} from {direction}")

    def test_planes_of_the_lattice(self):
        self.check_count(lambda p: p[:, 2], (0.25, 0.5, 0.75), 3)

    def test_boundary(self):
        self.check_count(lambda p: p[:, 2], (0,), 0)  # all is above it
        self.check_count(lambda p: p[:, 2], (1,), 1)  # the interior is below, the face is not

    def test_cells_of_constant_scalar(self):
        self.check_count(lambda p: np.minimum(p[:, 2], 0.5), (0.5,), 1)  # at the bottom of the plateau
        self.check_count(lambda p: np.maximum(p[:, 2], 0.5), (0.5,), 0)  # nothing is below
        self.check_count(lambda p: np.where(p[:, 2] == 0.5, 0.5, 1), (0.75,), 2)

    def test_from_everywhere(self):
        """Every ray crosses a whole number of surfaces, the number of lattice planes between its ends."""
        data = meshes.with_field(meshes.Lattice(4).mesh("tetra"), lambda p: p[:, 2])
        rng = np.random.default_rng(35)
        for parallel in (True, False):
            for _ in range(4):
                direction = rng.normal(size=3)
                layers, mask, _ = self.alpha(data, (0.25, 0.5, 0.75), direction, parallel)
                whole = np.abs(layers - np.rint(layers))[~mask].max()
                self.assertLess(whole, 1e-4)
                view, cells = self.kept[1].view(), cells_of(data)
                exact = contours.render(cells, view, CLEAR, [Surface(v - 1e-9, 0.25) for v in (0.25, 0.5, 0.75)])
                wrong = np.abs(np.rint(layers) - np.rint(np.log1p(-exact[..., 3]) / math.log(0.75)))[~mask]
                self.assertEqual(wrong.max(), 0, f"{int((wrong > 0).sum())} pixels from {direction}")

    def test_no_pixel_at_an_edge_misses_a_surface(self):
        """Next to an edge a rasteriser may give a pixel to no tetrahedron, or to two. A ray is in one at a time: no single dots."""
        dots, covered = 0, 0
        for seed in range(2):
            rng = np.random.default_rng([37, seed])
            data = meshes.delaunay(rng, 2000) if seed else meshes.Lattice(12).mesh("tetra")
            meshes.with_field(data, meshes.linear_field(rng, data) if seed else lambda p: p[:, 2])
            surfaces = [Surface((i + 1) / 12, 0.1) for i in range(11)]
            _, _, image = self.draw(data, CLEAR, surfaces, look=dict(direction=rng.normal(size=3)), size=(600, 600))
            alpha = image[..., 3]
            around = np.stack([np.roll(alpha, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)])
            median = np.median(around, axis=0)
            alone = (np.abs(around - median) < 1e-4).sum(axis=0) >= 8
            dots += int((alone & (np.abs(alpha - median) > 1e-4)).sum())
            covered += int((median > 0).sum())
        print(f"  single dots: {dots} of {covered} pixels")
        self.assertEqual(dots, 0)

    def test_only_crossed_cells_are_drawn(self):
        data = meshes.with_field(meshes.Lattice(4).mesh("hexahedron"), lambda p: p[:, 2])
        for value, layers in ((0.3, 1), (0.5, 1), (2.0, 0)):
            _, _, ours = self.alpha(data, (value,), (0, 0, 1))
            self.assertLessEqual(ours.GetNumberOfDrawnTetrahedra(), layers * 16 * 6)
            self.assertEqual(ours.GetNumberOfDrawnTetrahedra() > 0, layers > 0)
            self.assertEqual(len(self.unseen), layers == 0)
            self.assertTrue(layers or "none at 2 of 's', whose values go from 0 to 1." in self.unseen[0], self.unseen)


class Spheres(ContourTestCase):
    """Spheres in the field r on a lattice, lit: closed form per ray. The error falls with the size of the cells."""
    RADII = ((0.35, 0.5), (0.25, 0.8))

    def expected(self, view):
        origins, directions, _, _ = view.rays()
        o = origins - 0.5
        result = np.zeros((len(o), 4))
        b = np.einsum("ij,ij->i", o, directions)
        events = []
        for radius, opacity in self.RADII:
            root = b * b - np.einsum("ij,ij->i", o, o) + radius ** 2
            for sign in (-1, 1):
                t = -b + sign * np.sqrt(np.maximum(root, 0))
                normal = (o + t[:, None] * directions) / radius
                towards = np.abs(np.einsum("ij,ij->i", normal, directions))
                light = np.minimum(SHADING[0] + SHADING[1] * towards + SHADING[2] * towards ** SHADING[3], 1)
                events.append((t, np.where(root > 0, opacity, 0), light))
        order = np.argsort([e[0] for e in events], axis=0)
        for k in range(len(events)):
            t, opacity, light = (np.choose(order[k], [e[n] for e in events]) for n in range(3))
            result += ((1 - result[:, 3]) * opacity)[:, None] * np.column_stack([light] * 3 + [np.ones(len(t))])
        return result.reshape(view.height, view.width, 4), events

    def error(self, blocks):
        data = meshes.with_field(meshes.image((blocks,) * 3, (1 / blocks,) * 3), lambda p: np.linalg.norm(p - 0.5, axis=1))
        white = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (1, 0)])
        surfaces = [Surface(r, a) for r, a in self.RADII]
        ours, view, image = self.draw(data, white, surfaces, look=dict(parallel=True), lighting=True)
        expected, _ = self.expected(view)
        x, y = np.meshgrid(*2 * [np.arange(96) + 0.5 - 48])
        scale = 48 / view.half[0]
        distance = np.hypot(x, y) / scale
        inner = np.any([(distance > low) & (distance < high) for low, high in ((0, 0.2), (0.27, 0.31))], axis=0)  # no silhouette
        return np.abs(image - expected)[inner].max(), np.abs(image - expected)[inner].mean()

    def test_convergence(self):
        errors = {n: self.error(n) for n in (16, 32, 64)}
        for n, (largest, mean) in errors.items():
            print(f"  spheres, {n}^3 cells: max {largest:.4f}, mean {mean:.6f}")
        self.assertLess(errors[64][0], 1.5 / 255)
        self.assertLess(errors[32][1], 0.45 * errors[16][1])
        self.assertLess(errors[64][1], 0.45 * errors[32][1])


class AgainstPolygons(ContourTestCase):
    """vtkContourFilter and VTK's surface rendering, opaque, lit by its headlight and by lights of the scene."""

    def polygons(self, data, value):
        contour = vtkContourFilter()
        contour.SetInputData(data)
        contour.SetInputArrayToProcess(0, 0, 0, 0, "s")
        contour.SetValue(0, value)
        contour.ComputeNormalsOff()
        window = Window((256, 256))
        scene = window.add_scene()
        actor = vtkActor()
        actor.SetMapper(vtkPolyDataMapper())
        actor.GetMapper().SetInputConnection(contour.GetOutputPort())
        actor.GetMapper().ScalarVisibilityOff()
        prop = actor.GetProperty()
        prop.SetInterpolationToFlat()
        prop.SetColor(0.8, 0.6, 0.4)
        prop.SetSpecularColor(1, 1, 1)
        prop.SetAmbient(SHADING[0])
        prop.SetDiffuse(SHADING[1])
        prop.SetSpecular(SHADING[2])
        prop.SetSpecularPower(SHADING[3])
        scene.renderer.AddActor(actor)
        return window, scene

    def surfaces(self, data, value):
        window = Window((256, 256))
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, CLEAR)
        ours.SetContourValue(0, value)
        ours.SetContourOpacity(0, 1)
        ours.SetContourColor(0, 0.8, 0.6, 0.4)
        ours.SmoothContourNormalsOff()
        return window, scene, volume

    def add_light(self, renderer, name):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(2, 1, 3)
        light.SetColor(1, 0.9, 0.7)
        light.SetPositional(name != "directional")
        light.SetConeAngle(12 if name == "spot" else 120)
        light.SetExponent(3)
        light.SetAttenuationValues(0.5, 0.1, 0.05)
        renderer.AddLight(light)

    def test_lights(self):
        rng = np.random.default_rng(36)
        data = meshes.delaunay(rng, 30)
        meshes.add_array(data.GetPointData(), np.linalg.norm(meshes.points_of(data) - 0.1, axis=1), "s")
        for name in ("headlight", "directional", "positional", "spot"):
            window, scene = self.polygons(data, 0.5)
            own_window, own_scene, volume = self.surfaces(data, 0.5)
            for s, w in ((scene, window), (own_scene, own_window)):
                s.look_at(volume)
                if name != "headlight":
                    self.add_light(s.renderer, name)
                w.render()
            self.fail_on_messages(own_window, name)
            expected, image = scene.rgb(), own_scene.rgb()
            shifts = [np.roll(expected, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)]
            facet = (np.ptp(shifts, axis=0).max(axis=2) < 5 / 255) & (expected.max(axis=2) > 0)  # not at an edge of a facet
            error = np.abs(image - expected).max(axis=2)[facet]
            print(f"  {name}: {error.size} pixels, largest difference {255 * error.max():.0f}/255, above 2/255: {(error > 2.01 / 255).sum()}")
            self.assertGreater(error.size, 1000)
            self.assertLessEqual((error > 2.01 / 255).mean(), 0.001, name)


class BadInput(ContourTestCase):
    def messages(self, configure, data=None):
        data = data or meshes.with_field(meshes.Lattice(2).mesh("tetra"), lambda p: p[:, 2])
        window = Window((32, 32))
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, CLEAR)
        scene.look_at(volume)
        with window.messages:
            ours.SetContourValue(0, 0.5)
            configure(ours)
        window.render()
        return ours, " ".join(str(m) for m in window.messages.all)

    def test_missing_array(self):
        self.assertIn("No point array named 'nothing'", self.messages(lambda m: m.SetContourArrayName("nothing"))[1])

    def test_the_medium_is_drawn_without_its_contours(self):
        data = meshes.with_field(meshes.Lattice(2).mesh("tetra"), lambda p: p[:, 2])
        meshes.add_array(data.GetCellData(), np.linspace(0.2, 1, data.GetNumberOfCells()), "s")
        smoke = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0.5), (1, 0.5)])
        for association, name, said in (("point", "nothing", "No point array named 'nothing'"), ("cell", "", "is a cell array")):
            pictures = []
            for contours in (False, True):
                window = Window((32, 32))
                scene, ours = window.add_scene(), mapper()
                volume = scene.add_volume(ours, data, smoke, association=association)
                scene.look_at(volume)
                if contours:
                    ours.SetContourValue(0, 0.5)
                    ours.SetContourArrayName(name)
                window.render()
                window.render()
                pictures.append(scene.rgb())
                found = [str(m) for m in window.messages.all]
                self.assertEqual(len(found), int(contours), found)
            self.assertIn(said, found[0])
            self.assertIn("Contour surfaces are not drawn", found[0])
            np.testing.assert_allclose(*pictures, atol=1.01 / 255)
            self.assertGreater(pictures[0].max(), 0.1)

    def test_cell_array(self):
        data = meshes.with_field(meshes.Lattice(2).mesh("tetra"), lambda p: p[:, 2])
        meshes.add_array(data.GetCellData(), np.arange(data.GetNumberOfCells(), dtype=float), "c")
        self.assertIn("Cell Data to Point Data", self.messages(lambda m: m.SetContourArrayName("c"), data)[1])

    def test_values(self):
        ours, said = self.messages(lambda m: m.SetContourValue(1, math.nan))
        self.assertIn("finite", said)
        self.assertEqual(ours.GetNumberOfContourValues(), 1)
        self.assertIn("There is no contour value 7", self.messages(lambda m: m.SetContourOpacity(7, 1))[1])
        self.assertIn("finite", self.messages(lambda m: m.SetContourValue(-1, 0))[1])
        ours, said = self.messages(lambda m: m.SetContourOpacity(0, 3))
        self.assertEqual((ours.GetContourOpacity(0), said), (1, ""))
        self.assertEqual(self.messages(lambda m: m.SetNumberOfContourValues(-1))[0].GetNumberOfContourValues(), 0)

    def test_missing_values(self):
        """No surface in the tetrahedra around a NaN, all others drawn."""
        data = meshes.with_field(meshes.Lattice(4).mesh("tetra"), lambda p: p[:, 0])
        values = meshes.points_of(data)[:, 2]
        values[62] = np.nan
        meshes.add_array(data.GetPointData(), values, "t")
        _, _, image = self.draw(data, CLEAR, [Surface(0.4)], lambda m: m.SetContourArrayName("t"), dict(direction=(0, 0, 1)), lighting=True)
        self.assertTrue(np.isfinite(image).all())
        self.assertEqual(image[48, 48, 3], 0)
        self.assertAlmostEqual(image[25, 25, 3], 0.3, places=5)

    def test_one_flat_value(self):
        data = meshes.with_field(meshes.Lattice(1).mesh("tetra"), lambda p: 0 * p[:, 2] + 5)
        for value in (5, 4, 6):
            _, _, image = self.draw(data, CLEAR, [Surface(value)], lighting=True)
            self.assertEqual(image.max(), 0)
            self.assertEqual(len(self.unseen), value != 5)
            self.assertTrue(value == 5 or "whose values are all 5." in self.unseen[0], self.unseen)


if __name__ == "__main__":
    unittest.main(verbosity=2)
