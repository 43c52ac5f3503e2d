# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several volumes of a renderer that overlap are composited as one medium: against rays over the sum of their fields."""
import itertools
import math
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import media, meshes, reference, smoke
from nephoscope_testing.checks import SHIFTS, ImageTestCase, cells_of, forgive_shift, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant, random_transfer
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkPlaneSource

TOLERANCE = 1e-4  # of 1; the requirement is 2/255
WARM = Transfer([(0, 1, 0, 0), (1, 1, 0.6, 0)], [(0, 0.4), (0.5, 2), (1, 0.2)])
COLD = Transfer([(0, 0, 0, 1), (1.2, 0, 1, 1)], [(0, 1.4), (1.2, 0.1)])
GREEN = Transfer([(0, 0.1, 1, 0.2)], [(0, 0), (0.4, 0), (0.5, 1.5), (1, 1.5)])
UP, ACROSS, ASLANT = (lambda p: p[:, 2]), (lambda p: p[:, 0]), (lambda p: 0.2 + 0.3 * p @ (0.5, 0.4, 0.7))
EVERYTHING = (-0.3, 1.3, -0.3, 1.3, -0.2, 1.8)


def box(low, high, field, blocks=2, kind="tetra"):
    """Tetrahedra, cells of another kind, or "image" for a structured grid."""
    size = np.subtract(high, low)
    if kind == "image":
        return meshes.with_field(meshes.image((blocks,) * 3, size / blocks, low), field)
    data = meshes.Lattice(blocks).mesh(kind)
    data.SetPoints(meshes.vtk_points(np.asarray(low) + meshes.points_of(data) * size))
    return meshes.with_field(data, field)


FIRST = box((0, 0, 0), (1, 1, 1), UP)
SECOND = box((0.3, -0.2, 0.4), (1.2, 0.9, 1.7), ACROSS)
PAIRS = {
    "staggered": [(FIRST, WARM), (SECOND, COLD)],
    "one colour": [(FIRST, constant(0.7, (1, 0.5, 0.2))), (SECOND, constant(1.1, (1, 0.5, 0.2)))],
    "coincident faces": [(FIRST, WARM), (box((0, 0, 0), (1, 1, 1.5), ACROSS, 3), COLD)],
    "faces that touch": [(FIRST, WARM), (box((0, 0, 1), (1, 1, 1.5), ACROSS, 3), COLD)],
    "the same twice": [(FIRST, WARM), (FIRST, COLD)],
    "nested": [(box((-0.2, -0.2, -0.2), (1.2, 1.2, 1.4), ASLANT), WARM), (box((0.3, 0.2, 0.4), (0.8, 0.7, 0.9), UP), COLD)],
    "structured in unstructured": [(FIRST, WARM), (box((0.2, -0.2, 0.3), (1.2, 0.8, 1.6), ASLANT, 4, "image"), COLD)],
    "two structured": [(box((0, 0, 0), (1, 1, 1), UP, 5, "image"), GREEN), (box((0.2, -0.2, 0.3), (1.2, 0.8, 1.6), ASLANT, 4, "image"), COLD)],
    "hexahedra and wedges": [(box((0, 0, 0), (1, 1, 1), UP, 2, "hexahedron"), WARM), (box((0.3, -0.2, 0.4), (1.2, 0.9, 1.7), ACROSS, 2, "wedge"), GREEN)],
    "much denser": [(FIRST, constant(40, (1, 1, 1))), (SECOND, Transfer([(0, 1, 0, 0), (1.2, 0, 0, 1)], [(0, 0), (1.2, 90)]))],
}
THREE = PAIRS["structured in unstructured"] + [(box((0.1, 0.1, -0.2), (0.9, 1.2, 1.1), ACROSS, 3), GREEN)]
FOUR = THREE + [(box((-0.2, 0.3, 0.5), (0.6, 1.0, 1.5), UP, 2, "image"), constant(0.8, (0.9, 0.2, 0.9)))]


def aslant(scene):
    scene.look_at(EVERYTHING)


def parallel(scene):
    scene.look_at(EVERYTHING, direction=(-0.3, 0.5, 0.6), parallel=True)


def along(axis, sign):
    def look(scene):
        direction = np.zeros(3)
        direction[axis] = sign
        scene.look_at(EVERYTHING, direction=direction, up=(0, 0, 1) if axis == 1 else (0, 1, 0), parallel=True)
    return look


def eye_at(place):
    return lambda scene: scene.look(place, np.add(place, (0.35, 0.2, 1)), angle=60, near=0.01, far=9)


class MediaTestCase(ImageTestCase):
    def draw(self, volumes, look=aslant, configure=None, prepare=None, size=(48, 44), order=1):
        window = Window(size)
        scene = window.add_scene()
        mappers = [mapper() for _ in volumes]
        for i in range(len(volumes))[::order]:
            scene.add_volume(mappers[i], *volumes[i])
        if configure:
            configure(mappers)
        if prepare:
            prepare(scene)
        look(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        self.kept = window
        return scene, mappers

    def compare(self, image, volumes, view, label, tolerance=TOLERANCE, planes=None, **options):
        """Rays that pass within 1e-3 pixels of an edge of a tetrahedron are left out, as of one medium."""
        all_ = [(cells_of(data), transfer, *([planes[i]] if planes else [])) for i, (data, transfer) in enumerate(volumes)]
        draw = lambda v: media.render(all_, v, **options)
        expected = draw(view)
        mask = edge_mask(np.concatenate([cells.drawn_edges() for cells, *_ in all_]), view)
        if Difference(image, expected, mask).maximum > tolerance:
            image = forgive_shift(image, expected, [draw(view.shifted(*s)) for s in SHIFTS], label)
        self.check_float(image, expected, label, tolerance, mask)
        return expected

    def check(self, volumes, label, look=aslant, **options):
        scene, mappers = self.draw(volumes, look, **options)
        return self.compare(float_image(mappers[0]), volumes, scene.view(), label)


class Sums(MediaTestCase):
    def test_pairs(self):
        for name, pair in PAIRS.items():
            for look in (aslant, parallel):
                self.check(pair, f"{name}, {look.__name__}")

    def test_along_axes(self):
        for name in ("staggered", "coincident faces", "two structured"):
            for axis, sign in itertools.product(range(3), (-1, 1)):
                self.check(PAIRS[name], f"{name} along axis {axis}, {sign:+}", along(axis, sign))

    def test_the_eye_inside(self):
        for place, where in (((0.15, 0.12, 0.2), "one"), ((0.63, 0.44, 0.71), "both"), ((0.5, 0.5, 0.5), "both, on a vertex of one")):
            for name in ("staggered", "structured in unstructured", "nested", "coincident faces"):
                self.check(PAIRS[name], f"eye in {where}: {name}", eye_at(place))

    def test_three_and_four(self):
        self.check(THREE, "three media")
        self.check(FOUR, "four media")
        self.check(FOUR, "eye in four media", eye_at((0.45, 0.5, 0.7)))

    def test_thickness_in_closed_form(self):
        """Along z through two boxes of one colour: 1 - exp(-(a1 l1 + a2 l2)); of two colours in the same place, their mean by extinction."""
        red, blue = constant(0.7, (1, 0, 0)), constant(1.4, (0, 0, 1))
        scene, mappers = self.draw([(FIRST, red), (FIRST, blue)], along(2, 1))
        alpha = -math.expm1(-2.1)
        np.testing.assert_allclose(float_image(mappers[0])[22, 24], [alpha / 3, 0, alpha * 2 / 3, alpha], atol=2e-6)

    def test_a_medium_in_two_parts_is_the_medium(self):
        """Random functions, a mesh with gaps that rays enter again and again, and any cut of its extinction."""
        rng = np.random.default_rng(5)
        data = meshes.with_field(smoke.boxes([((x, y, z), (x + 0.3, y + 0.3, z + 0.3)) for x, y, z in
                                              itertools.product((0, 0.45, 0.9), repeat=3)], 1), UP)
        whole = random_transfer(rng, 5, max_extinction=3)
        parts = [Transfer(whole.colors, whole.opacities * (1, share)) for share in (0.3, 0.7)]
        one = float_image(self.draw([(data, whole)])[1][0])
        _, several = self.draw([(data, part) for part in parts])
        self.assertGreater(several[0].GetNumberOfRayLayers(), 2)
        self.check_float(float_image(several[0]), one, "27 boxes in two parts", 1e-5)

    def test_gaps(self):
        data = meshes.with_field(smoke.boxes([((0, 0, z), (1, 1, z + 0.1)) for z in (0, 0.3, 0.55, 0.9, 1.2)], 1), UP)
        for look in (aslant, along(2, 1), along(0, 1), eye_at((0.4, 0.45, 0.35))):
            self.check([(data, WARM), (SECOND, COLD)], "five slabs in a box", look)

    def test_a_shell_around_and_through(self):
        """A grid whose first axis is closed, entered twice by most rays."""
        shell = meshes.with_field(meshes.shell(16, 8, 2, (0.6, 1.0)), lambda p: 0.5 + 0.4 * p[:, 2])
        pair = [(shell, WARM), (box((-0.8, -0.9, -0.7), (0.7, 0.8, 0.9), ASLANT, 3), COLD)]
        scene, mappers = self.draw(pair, lambda scene: scene.look_at((-1, 1, -1, 1, -1, 1)))
        cells = [cells_of(shell, decompose=True), cells_of(pair[1][0])]
        expected = media.render([(cells[0], WARM), (cells[1], COLD)], scene.view())
        mask = edge_mask(np.concatenate([c.drawn_edges() for c in cells]), scene.view())
        self.check_float(float_image(mappers[0]), expected, "shell and box", 2 / 255, mask)

    def test_parts_that_overlap_themselves(self):
        """Smoke that passes through itself, in a box: the opacity is exact."""
        tube = meshes.with_field(smoke.loop(), lambda p: 0.5 + 0.3 * p[:, 2])
        around = box((-1.2, -1.1, -0.4), (1.1, 0.9, 0.4), UP)
        pair = [(tube, constant(2, (1, 0.4, 0.1))), (around, constant(0.6, (1, 0.4, 0.1)))]
        scene, mappers = self.draw(pair, lambda scene: scene.look_at(tube, direction=(0.3, -0.2, 1)))
        view = scene.view()
        apart = [reference.render(cells_of(data), view, transfer)[..., 3] for data, transfer in pair]
        mask = edge_mask(np.concatenate([cells_of(data).drawn_edges() for data, _ in pair]), view)
        self.check_float(float_image(mappers[0])[..., 3:], (1 - (1 - apart[0]) * (1 - apart[1]))[..., None], "loop in a box", 3e-4, mask)


class Order(MediaTestCase):
    def test_order_of_adding_does_not_matter(self):
        for volumes in (PAIRS["staggered"], PAIRS["structured in unstructured"], THREE):
            pictures = [self.draw(volumes, order=order)[0].rgb() for order in (1, -1)]
            self.check_float(pictures[1], pictures[0], f"{len(volumes)} media, two orders", 1 / 255 + 1e-9)

    def test_one_behind_the_other(self):
        """Apart in space: the one in front is in front, whichever was added first."""
        pair = [(FIRST, WARM), (box((0.1, 0.1, -2), (0.9, 0.8, -1), ACROSS), COLD)]
        for order in (1, -1):
            scene, mappers = self.draw(pair, order=order, look=lambda scene: scene.look((0.4, 0.7, 6), (0.5, 0.5, 0)))
            self.compare(float_image(mappers[0]), pair, scene.view(), f"apart, order {order}")

    def test_apart_in_the_picture_nothing_changes(self):
        pair = [(FIRST, WARM), (box((3, 0.1, -2), (4, 0.8, -1), ACROSS), COLD)]
        look = lambda scene: scene.look((2, 0.7, 9), (2, 0.5, 0))
        scene, mappers = self.draw(pair, look)
        together, pictures = scene.rgb(), [float_image(ours) for ours in mappers]
        for i, one in enumerate(pair):
            alone, (ours,) = self.draw([one], look)
            np.testing.assert_array_equal(float_image(ours), pictures[i])
            seen = alone.rgb() > 0
            self.assertGreater(seen.sum(), 50)
            np.testing.assert_array_equal(alone.rgb()[seen], together[seen])

    def test_volumes_come_and_go(self):
        """Hidden, out of the picture, or removed, the other one is drawn as if it were alone."""
        window = Window((48, 44))
        scene = window.add_scene()
        mappers = [mapper(), mapper()]
        volumes = [scene.add_volume(m, *v) for m, v in zip(mappers, PAIRS["staggered"])]
        aslant(scene)
        alone = [float_image(self.draw([v])[1][0]) for v in PAIRS["staggered"]]
        window.render()
        both = float_image(mappers[0])
        for i in (0, 1):
            volumes[i].VisibilityOff()
            window.render()
            np.testing.assert_array_equal(float_image(mappers[1 - i]), alone[1 - i])
            volumes[i].VisibilityOn()
            volumes[i].SetPosition(100, 0, 0)
            window.render()
            np.testing.assert_array_equal(float_image(mappers[1 - i]), alone[1 - i])
            volumes[i].SetPosition(0, 0, 0)
            window.render()
            np.testing.assert_array_equal(float_image(mappers[1]), both)
        scene.renderer.RemoveVolume(volumes[0])
        window.render()
        np.testing.assert_array_equal(float_image(mappers[1]), alone[1])
        self.fail_on_messages(window)

    def test_moved_volumes(self):
        """Each with a matrix of its own."""
        moved = np.array([[1.1, 0.2, 0, 0.1], [-0.3, 0.9, 0.1, 0.2], [0, 0.1, 1.3, -0.1], [0, 0, 0, 1]])
        window = Window((48, 44))
        scene = window.add_scene()
        mappers = [mapper(), mapper()]
        scene.add_volume(mappers[0], FIRST, WARM, matrix=moved)
        scene.add_volume(mappers[1], SECOND, COLD)
        aslant(scene)
        window.render()
        self.fail_on_messages(window)
        cells = [cells_of(FIRST, matrix=moved), cells_of(SECOND)]
        expected = media.render(list(zip(cells, (WARM, COLD))), scene.view())
        mask = edge_mask(np.concatenate([c.drawn_edges() for c in cells]), scene.view())
        self.check_float(float_image(mappers[0]), expected, "with a matrix", 2 / 255, mask)


class Scenes(MediaTestCase):
    def test_opaque_polygon_in_both(self):
        source = vtkPlaneSource()
        source.SetOrigin(-0.1, 0, 0.2)
        source.SetPoint1(1.1, 0.1, 0.9)
        source.SetPoint2(0, 1, 0.8)
        source.Update()
        triangles = np.array([[source.GetOutput().GetPoint(i) for i in t] for t in ((0, 1, 3), (0, 3, 2))])
        for name in ("staggered", "structured in unstructured"):
            for look in (aslant, parallel, eye_at((0.63, 0.44, 0.71))):
                scene, mappers = self.draw(PAIRS[name], look, prepare=lambda scene: scene.add_opaque(source.GetOutput(), (0.9, 0.9, 0.9)))
                view = scene.view()
                image = float_image(mappers[0])
                # The depth of the silhouette is the rasterizer's.
                edges = np.stack([triangles, np.roll(triangles, 1, 1)], 2).reshape(-1, 2, 3)
                expected = media.render([(cells_of(d), t) for d, t in PAIRS[name]], view, opaque=reference.opaque_distance(triangles, view))
                mask = edge_mask(np.concatenate([edges, *(cells_of(d).drawn_edges() for d, _ in PAIRS[name])]), view)
                self.check_float(image, expected, f"opaque polygon, {name}", 2 / 255, mask)

    def test_clipping_planes_of_one_and_of_both(self):
        def plane(origin, normal):
            result = vtkPlane()
            result.SetOrigin(*origin)
            result.SetNormal(*normal)
            return result
        cuts = ([((0.5, 0.4, 0.6), (1, 0.3, -0.4))], [((0.7, 0.5, 0.9), (-0.3, 0.4, -1)), ((0.5, 0.2, 0.5), (0, 1, 0))])
        for planes in ((cuts[0], []), ([], cuts[1]), cuts, (cuts[1], cuts[1]), ([((9, 9, 9), (1, 1, 1))], [])):
            def configure(mappers):
                for ours, own in zip(mappers, planes):
                    for one in own:
                        ours.AddClippingPlane(plane(*one))
            scene, mappers = self.draw(PAIRS["staggered"], configure=configure)
            self.compare(float_image(mappers[0]), PAIRS["staggered"], scene.view(), f"planes {[len(p) for p in planes]}", planes=planes)

    def test_haze_and_translucent_surfaces(self):
        """What is in front of or between two halves of a medium is as it is of the whole."""
        def haze(scene):
            air = nephoscope.vtkHaze()
            air.SetProjectionToMap()
            air.SetBaseLevel(-1)
            air.SetScaleHeight(1)
            air.SetExtinction(0.15)
            air.SetColor(0.2, 0.4, 0.8)
            nephoscope.vtkHaze.SetHaze(scene.renderer, air)

        def peel(scene):
            source = vtkPlaneSource()
            source.SetCenter(0.5, 0.5, 0.6)
            source.SetNormal(0.2, 0.3, 1)
            source.Update()
            scene.add_opaque(source.GetOutput(), (0.2, 0.9, 0.3)).GetProperty().SetOpacity(0.4)
            scene.renderer.UseDepthPeelingOn()
            scene.renderer.UseDepthPeelingForVolumesOn()
            scene.renderer.SetMaximumNumberOfPeels(20)
            scene.renderer.SetOcclusionRatio(0)
        halves = Transfer(WARM.colors, WARM.opacities * (1, 0.5))
        for prepare, tolerance in ((haze, 1 / 255), (peel, 2 / 255)):
            plain = self.draw([(FIRST, WARM)])[0].rgb()
            whole = self.draw([(FIRST, WARM)], prepare=prepare)[0].rgb()
            both = self.draw([(FIRST, halves), (FIRST, halves)], prepare=prepare)[0].rgb()
            self.assertGreater(np.abs(whole - plain).max(), 0.05)
            self.check_float(both, whole, f"halves with {prepare.__name__}", tolerance + 1e-9)

    def test_opacity_from_other_arrays_and_layers(self):
        data = box((0, 0, 0), (1, 1, 1), UP)
        meshes.add_array(data.GetPointData(), np.linspace(0.2, 1.5, data.GetNumberOfPoints()), "density")
        meshes.add_array(data.GetCellData(), (np.arange(data.GetNumberOfCells()) % 3).astype(np.int32), "layer")
        function = random_transfer(np.random.default_rng(3), 5, max_extinction=2)
        halves = Transfer(function.colors, function.opacities * (1, 0.5))
        layer = random_transfer(np.random.default_rng(4), 4, max_extinction=3)

        def with_density(scale, mappers):
            for ours in mappers:
                ours.SetOpacityArrayName("density")

        def with_layers(scale, mappers):
            for ours in mappers:
                ours.SetLayerArrayName("layer")
                ours.SetLayerProperty(1, Transfer(layer.colors, layer.opacities * (1, scale)).volume_property())
        for configure in (with_density, with_layers):
            whole = float_image(self.draw([(data, function)], configure=lambda m: configure(1, m))[1][0])
            both = float_image(self.draw([(data, halves), (data, halves)], configure=lambda m: configure(0.5, m))[1][0])
            self.check_float(both, whole, configure.__name__, 2e-5)

    def test_cell_scalars(self):
        data = meshes.with_field(meshes.Lattice(3).mesh("tetra"), ASLANT, "cell")
        window = Window((48, 44))
        scene = window.add_scene()
        mappers = [mapper(), mapper()]
        scene.add_volume(mappers[0], data, WARM, association="cell")
        scene.add_volume(mappers[1], SECOND, COLD)
        aslant(scene)
        window.render()
        cells = [cells_of(data, "cell"), cells_of(SECOND)]
        expected = media.render(list(zip(cells, (WARM, COLD))), scene.view())
        mask = edge_mask(np.concatenate([c.drawn_edges() for c in cells]), scene.view())
        self.check_float(float_image(mappers[0]), expected, "cell scalars", 2 / 255, mask)
        self.fail_on_messages(window)

    def test_in_place_of_vtk(self):
        """Mappers that draw in place of VTK's take part."""
        inside = [nephoscope.vtkCellCompositingRayCastMapper() for _ in range(2)]
        window = Window((48, 44))
        scene = window.add_scene()
        for ours, volume in zip(inside, PAIRS["staggered"]):
            scene.add_volume(ours, *volume)
        aslant(scene)
        window.render()
        self.compare(float_image(inside[0].GetCellCompositingMapper()), PAIRS["staggered"], scene.view(), "in place")


class Slices(MediaTestCase):
    """What cannot be one medium ray by ray is drawn in slices of depth, without a message."""

    def check_slices(self, volumes, configure, label, look=aslant):
        scene, mappers = self.draw(volumes, look, configure)
        expected = media.render([(cells_of(data), transfer) for data, transfer in volumes], scene.view())[..., :3]
        mask = edge_mask(np.concatenate([cells_of(data).drawn_edges() for data, _ in volumes]), scene.view())
        self.check_float(scene.rgb(), expected, label, 2 / 255, mask)

    def test_other_settings(self):
        def contours(mappers):
            mappers[1].SetNumberOfContourValues(1)
            mappers[1].SetContourValue(0, 0.5)
            mappers[1].SetContourOpacity(0, 0)
        for configure in (contours, lambda m: m[1].SetMethodToProjection(), lambda m: m[0].SetVisibilityOrderToCentroid()):
            self.check_slices(PAIRS["staggered"], configure, "in slices")

    def test_small_overlap(self):
        """Most rays pass through one box at a time, some through three that lie apart: only those through two at once need slices."""
        chain = [(FIRST, WARM), (box((0.8, 0.7, 0.8), (1.3, 1.3, 1.4), UP), COLD), (box((-0.3, -0.3, -0.2), (0.2, 0.2, 0.2), ACROSS), GREEN),
                 (box((0.4, 0.2, 0.95), (0.7, 0.6, 1.8), ASLANT, 2, "image"), constant(0.8, (0.9, 0.2, 0.9)))]
        for look in (aslant, parallel, along(2, 1), along(0, -1), eye_at((0.1, 0.15, -0.1))):
            self.check_slices(chain, lambda m: m[1].SetVisibilityOrderToCentroid(), "small overlap", look)

    def test_five(self):
        self.check_slices(FOUR + [(SECOND, GREEN)], None, "five media")


class Warnings(MediaTestCase):
    def test_earlier_methods_are_told_once(self):
        for method in ("TrianglesLinear", "TrianglesTable", "Faces"):
            window = Window((48, 44))
            scene = window.add_scene()
            for i, volume in enumerate(PAIRS["staggered"]):
                ours = mapper()
                if i:
                    getattr(ours, "SetMethodTo" + method)()
                scene.add_volume(ours, *volume)
            aslant(scene)
            for _ in range(3):
                window.render()
            self.assertEqual(len(window.messages.all), 1, window.messages.all)
            self.assertIn("not composited as one medium", str(window.messages.all[0]))
            self.assertIn("method", str(window.messages.all[0]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
