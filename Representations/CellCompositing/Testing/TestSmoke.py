# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A medium of one colour: no order, overlapping cells, opaque surfaces in it, faint cells. And two colours where cells overlap."""
import math
import unittest

import numpy as np
from nephoscope_testing import meshes, smoke
from nephoscope_testing.checks import FLOAT_TOLERANCE, ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from nephoscope_testing.reference import opaque_distance, render
from nephoscope_testing.surfaces import plane
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource

TOLERANCE = 2e-6  # some roundings of float
COLOR = (1, 0.5, 0.25)
METHODS = ("Automatic", "Projection", "Rays")
# Boxes that overlap: one behind the other; with the same front, and faces of one in faces of the other; one within the other;
# one and the same, three times.
PARTS = {
    "staggered": [((0, 0, 0), (1, 1, 1)), ((-0.2, -0.1, 0.37), (1.1, 1.2, 1.6))],
    "same front": [((0, 0, 0), (1, 1, 1)), ((0, 0, 0), (1, 1, 2))],
    "nested": [((-1, -1, -1), (2, 2, 2)), ((0, 0, 0.3), (1, 1, 0.6))],
    "three times": [((0, 0, 0), (1, 1, 1))] * 3,
}


def scene_of(data, transfer, method="Automatic", association="point", size=(64, 64)):
    window = Window(size)
    scene, ours = window.add_scene(), mapper()
    getattr(ours, "SetMethodTo" + method)()
    scene.add_volume(ours, data, transfer, association=association)
    return window, scene, ours


def along_z(scene, side=-5.0):
    scene.look((0.5, 0.5, side), (0.5, 0.5, 0.5), parallel_scale=1.0, near=0.5, far=20)


def middle(image):
    return image[20:44, 20:44]  # over (0.13, 0.87) in x and y


class SmokeTestCase(ImageTestCase):
    def check_all(self, image, alpha, label, color=COLOR, tolerance=TOLERANCE):
        error = np.abs(image - alpha * np.array([*color, 1.0])).max()
        print(f"  {label}: error {error:.3g}", flush=True)
        self.assertLessEqual(error, tolerance, f"{label}: got {image.reshape(-1, 4)[0]}, expected alpha {alpha:.7g}")


class Overlap(SmokeTestCase):
    def test_boxes(self):
        """Along z the light is exp(-(tau1 + tau2 + ...)), from either side, with every method."""
        for label, parts in PARTS.items():
            data = meshes.with_field(smoke.boxes(parts), lambda p: 0 * p[:, 0])
            depth = 0.4 * sum(high[2] - low[2] for low, high in parts)
            for method in METHODS:
                for side in (-5, 6):
                    window, scene, ours = scene_of(data, constant(0.4, COLOR), method)
                    along_z(scene, side)
                    window.render()
                    self.check_all(middle(float_image(ours)), -math.expm1(-depth), f"{label}, {method}, from {side}")
                    self.assertTrue(ours.GetOrderIndependent())
                    self.fail_on_messages(window)

    def test_each_box_has_its_own_density(self):
        """Extinction from the cell array "Density": of the overlapping boxes a different one each."""
        for label, parts in PARTS.items():
            data = meshes.with_field(smoke.boxes(parts), lambda p: p[:, 2])
            part = meshes.vtk_to_numpy(data.GetCellData().GetArray("part"))
            meshes.add_array(data.GetCellData(), 0.3 + 0.25 * part, "Density")
            depth = sum((0.3 + 0.25 * i) * (high[2] - low[2]) for i, (low, high) in enumerate(parts))
            for method in METHODS:
                window, scene, ours = scene_of(data, Transfer([(0, *COLOR)], [(0, 0), (2, 2)]), method)
                ours.SetOpacityArrayName("Density")
                along_z(scene)
                window.render()
                self.check_all(middle(float_image(ours)), -math.expm1(-depth), f"{label}, densities, {method}")

    def test_the_eye_inside(self):
        """Where the eye is in both of two boxes: what is left of either."""
        data = meshes.with_field(smoke.boxes([((-1, -1, 0), (2, 2, 1)), ((-1, -1, 0.2), (2, 2, 1.6))]), lambda p: 0 * p[:, 0])
        for method in METHODS:
            window, scene, ours = scene_of(data, constant(0.8, COLOR), method, size=(65, 65))
            scene.look((0.43, 0.41, 0.3), (0.43, 0.41, 9), angle=20, near=0.01, far=20)
            window.render()
            image = float_image(ours)
            depth = 0.8 * (0.7 + 1.3 - 2 * 0.01)
            self.check_all(image[32:33, 32:33], -math.expm1(-depth), f"eye in both boxes, {method}", tolerance=1e-5)

    def test_the_eye_in_several_copies(self):
        """One box three times, and two with planes in common: on a vertex, in a face, and amid a cell."""
        for label, parts, count in (("three times", PARTS["three times"], 3), ("same planes", [((0, 0, 0), (1, 1, 1)), ((-1, -1, 0), (2, 2, 1))], 2)):
            data = meshes.with_field(smoke.boxes(parts), lambda p: 0 * p[:, 0])
            window, scene, ours = scene_of(data, constant(0.8, COLOR), "Rays", size=(33, 33))
            for eye in ((0.43, 0.41, 0.3), (0.5, 0.41, 0.3), (0.5, 0.5, 0.5)):
                scene.look(eye, (eye[0], eye[1], 9), angle=1, near=0.001, far=20)
                window.render()
                self.check_all(float_image(ours)[16:17, 16:17], -math.expm1(-0.8 * count * (1 - eye[2] - 0.001)), f"{label} at {eye}", tolerance=2e-4)

    def test_rays_draw_it_unless_told_otherwise(self):
        data = meshes.with_field(meshes.Lattice(10).mesh("tetra"), lambda p: p[:, 2])
        for method in METHODS:
            window, scene, ours = scene_of(data, constant(0.4, COLOR), method)
            along_z(scene)
            window.render()
            self.check_all(middle(float_image(ours)), -math.expm1(-0.4), method)
            self.assertEqual(ours.GetNumberOfRayLayers() > 0, method != "Projection")
            self.assertTrue(ours.GetOrderIndependent())

    def test_meshes_that_pass_through_themselves(self):
        """Against the rays of the reference, of which every segment counts whatever overlaps it."""
        looks = {"parallel": dict(parallel=True), "perspective": dict(direction=(0.3, -0.2, 1)), "edge on": dict(direction=(1, 0.2, 0.1))}
        for name, data in (("loop", smoke.loop()), ("fan", smoke.fan())):
            meshes.with_field(data, lambda p: 0.5 + 0.3 * p[:, 2])
            transfer = Transfer([(0, *COLOR), (1, *COLOR)], [(0, 0.2), (1, 3)])
            for label, look in looks.items():
                for method in METHODS:
                    ours = self.check(data, transfer, f"{name}, {label}, {method}", look=look,
                                      configure=lambda m: getattr(m, "SetMethodTo" + method)())[0]
                    self.assertTrue(ours.GetOrderIndependent())

    def test_two_colours(self):
        """What is documented: alpha is right; rays lay one stretch of mesh, as a whole, over the next one they enter."""
        red, blue = np.array((1, 0, 0)), np.array((0, 0, 1))
        parts = PARTS["staggered"]
        data = smoke.boxes(parts)
        transfer = Transfer([(0, *red), (1, *blue)], [(0, 0.9), (1, 0.6)])
        near, far = (-math.expm1(-rate * (high[2] - low[2])) for rate, (low, high) in zip((0.9, 0.6), parts))
        expected = [*(near * red + (1 - near) * far * blue), 1 - (1 - near) * (1 - far)]
        for method in METHODS:
            window, scene, ours = scene_of(data, transfer, method)
            scene.renderer.RemoveAllViewProps()
            scene.add_volume(ours, data, transfer, "part", "cell")
            along_z(scene)
            window.render()
            image = middle(float_image(ours))
            self.assertFalse(ours.GetOrderIndependent())
            self.assertLessEqual(np.abs(image[..., 3] - expected[3]).max(), TOLERANCE, method)
            if method != "Projection":
                self.assertLessEqual(np.abs(image - expected).max(), TOLERANCE, method)


    def test_smoke_in_and_behind_clouds_before_a_wall(self):
        """Cells of clouds with thin smoke in them, one mesh, in the order of centroids: each is before or behind a cloud as a whole."""
        clouds = [((0, 0, z), (1, 1, z + 1)) for z in (0, 1, 2)]
        thin = [((0, 0, 0.02), (1, 1, 0.08)), ((0, 0, 1.92), (1, 1, 1.98)), ((0, 0, 2.5), (1, 1, 2.6))]
        data = smoke.boxes(clouds + thin)
        part = meshes.vtk_to_numpy(data.GetCellData().GetArray("part"))
        meshes.add_array(data.GetCellData(), np.where(part < len(clouds), 0.5, 2.5), "medium")
        white, orange, green = np.array((0.9, 0.9, 1)), np.array((1, 0.4, 0)), np.array((0, 0.5, 0))
        transfer = Transfer([(0, *white), (1, *white), (1.5, *orange), (3, *orange)], [(0, 0), (1, 1), (2, 0), (3, 24)])
        wall = vtkPlaneSource()
        wall.SetOrigin(-1, -1, 2.2)
        wall.SetPoint1(2, -1, 2.2)
        wall.SetPoint2(-1, 2, 2.2)
        wall.Update()
        seen = [(orange, 12 * 0.06), (white, 0.5), (white, 0.5), (orange, 12 * 0.06), (white, 0.5 * 0.2)]  # the third smoke is behind the wall
        expected = green
        for color, depth in seen[::-1]:
            expected = -math.expm1(-depth) * color + math.exp(-depth) * expected
        window = Window((64, 64))
        scene, ours = window.add_scene(), mapper()
        ours.SetMethodToCells()
        ours.SetVisibilityOrderToCentroid()
        scene.add_volume(ours, data, transfer, "medium", "cell")
        scene.add_opaque(wall.GetOutput(), green)
        along_z(scene)
        window.render()
        self.fail_on_messages(window)
        self.assertLessEqual(np.abs(middle(scene.rgb()) - expected).max(), 2 / 255)  # the window's 8 bits


class Decision(ImageTestCase):
    def setUp(self):
        data = meshes.delaunay(np.random.default_rng(1), 40)
        meshes.with_field(data, meshes.linear_field(np.random.default_rng(2), data))
        meshes.add_array(data.GetPointData(), np.full(data.GetNumberOfPoints(), 0.3), "same")
        meshes.add_array(data.GetCellData(), np.zeros(data.GetNumberOfCells()), "layer")
        self.data, self.transfer = data, constant(2.0, COLOR)
        self.window, self.scene, self.mapper = scene_of(data, self.transfer)
        self.scene.look_at(data)

    def answer(self):
        self.window.render()
        return self.mapper.GetOrderIndependent()

    def test_before_and_after_the_first_frame(self):
        self.assertFalse(self.mapper.GetOrderIndependent())
        self.assertTrue(self.answer())
        self.assertIn("OrderIndependent: 1", str(self.mapper))

    def test_it_follows_the_colour_function(self):
        color = self.scene.renderer.GetVolumes().GetLastProp().GetProperty().GetRGBTransferFunction()
        for answer, point in ((True, (0.5, *COLOR)), (False, (0.5, 0, 1, 1)), (True, (0.5, *COLOR)), (True, (3, 0, 0, 0)),
                              (False, (0.5, 0, 1, 1))):
            color.AddRGBPoint(*point)
            self.assertEqual(self.answer(), answer, point)
            self.assertIn(f"OrderIndependent: {int(answer)}", str(self.mapper))
        self.mapper.SelectScalarArray("same")
        self.assertTrue(self.answer(), "one value has one colour")

    def test_the_picture_follows_too(self):
        """From one colour to several and back: each frame is the reference's, whichever way it was drawn."""
        several = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 1), (1, 4)])
        volume = self.scene.renderer.GetVolumes().GetLastProp()
        for transfer in (self.transfer, several, self.transfer, several):
            volume.SetProperty(transfer.volume_property())
            self.assertEqual(self.answer(), transfer is self.transfer)
            self.verify(self.scene, self.mapper, cells_of(self.data), transfer, "another colour function")

    def test_what_needs_an_order(self):
        ours = self.mapper
        for label, set_up, take_back in (
                ("contour", lambda: ours.SetContourValue(0, 0.5), lambda: ours.SetNumberOfContourValues(0)),
                ("layers", lambda: (ours.SetLayerArrayName("layer"), ours.SetLayerProperty(1, constant(1, (1, 0, 0)).volume_property())),
                 ours.RemoveAllLayerProperties),
                ("faces", ours.SetMethodToFaces, ours.SetMethodToAutomatic)):
            set_up()
            self.assertFalse(self.answer(), label)
            take_back()
            self.assertTrue(self.answer(), label)
        renderer = self.scene.renderer
        translucent = self.scene.add_opaque(plane((0, 0, 0)), (0, 1, 0))
        translucent.GetProperty().SetOpacity(0.5)
        for peels in (True, False):
            renderer.SetUseDepthPeeling(peels)
            renderer.SetUseDepthPeelingForVolumes(peels)
            self.assertEqual(self.answer(), not peels, "surfaces between the cells")

    def test_methods(self):
        for method in ("Rays", "Projection", "TrianglesLinear", "TrianglesTable", "Automatic"):
            getattr(self.mapper, "SetMethodTo" + method)()
            self.assertTrue(self.answer(), method)

    def test_nothing_is_made_for_a_moved_camera(self):
        """Progress events tell of work; an order is some."""
        for transfer, sorts in ((self.transfer, False), (Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 1), (1, 4)]), True)):
            for method in ("Automatic", "Projection"):
                window, scene, ours = scene_of(self.data, transfer, method)
                scene.look_at(self.data)
                window.render()
                events = []
                ours.AddObserver("ProgressEvent", lambda *_: events.append(1))
                scene.camera.Azimuth(30)
                window.render()
                self.assertEqual(bool(events), sorts and method == "Projection", f"{method}, {len(events)} events")
                self.assertEqual(ours.GetNumberOfBrokenRelations(), 0)


class Opaque(SmokeTestCase):
    SURFACE = (0.0, 0.4, 0.8)

    def test_cut_inside_cells(self):
        """A surface at z = 0.55, inside cells of both boxes, ends them exactly there: the closed form of what lies in front."""
        parts = PARTS["staggered"]
        data = meshes.with_field(smoke.boxes(parts), lambda p: 0 * p[:, 0])
        for method in METHODS:
            for side, depth in ((-5, 0.4 * (0.55 + 0.55 - 0.37)), (6, 0.4 * (0.45 + 1.6 - 0.55))):
                window, scene, ours = scene_of(data, constant(0.4, COLOR), method)
                scene.add_opaque(plane((0.5, 0.5, 0.55), 3), self.SURFACE)
                along_z(scene, side)
                window.render()
                alpha = -math.expm1(-depth)
                # The depth buffer holds z to within 2^-24 of the clipping range.
                self.check_all(middle(float_image(ours)), alpha, f"opaque plane in the cells, {method}, from {side}", tolerance=4e-6)
                over = alpha * np.array(COLOR) + (1 - alpha) * np.array(self.SURFACE)
                self.assertLessEqual(np.abs(middle(scene.rgb()) - over).max(), 1.5 / 255)

    def test_a_slanted_surface_in_a_loop(self):
        data = meshes.with_field(smoke.loop(), lambda p: 0.5 + 0.3 * p[:, 2])
        transfer = Transfer([(0, *COLOR), (1, *COLOR)], [(0, 0.2), (1, 3)])
        surface = meshes.triangles_of(plane((0, 0.2, 0), 1.2, (0.2, 0.3, 0.5)))
        for method in METHODS:
            for parallel in (False, True):
                window, scene, ours = scene_of(data, transfer, method, size=(96, 96))
                scene.add_opaque(plane((0, 0.2, 0), 1.2, (0.2, 0.3, 0.5)), self.SURFACE)
                scene.look_at(data, parallel=parallel)
                window.render()
                view, cells = scene.view(), cells_of(data)
                distance = opaque_distance(surface, view)
                edges = np.concatenate([cells.drawn_edges(), np.stack([surface, np.roll(surface, 1, 1)], 2).reshape(-1, 2, 3)])
                self.check_float(float_image(ours), render(cells, view, transfer, distance), f"slanted plane in a loop, {method}",
                                 FLOAT_TOLERANCE, edge_mask(edges, view))

    def test_depth_is_tested_and_not_written(self):
        data = meshes.with_field(smoke.boxes(PARTS["staggered"]), lambda p: 0 * p[:, 0])
        window, scene, ours = scene_of(data, constant(3.0, COLOR))
        scene.add_opaque(plane((0.5, 0.5, 0.7), 0.3), self.SURFACE)
        along_z(scene)
        depths = []
        for visible in (True, False):
            scene.renderer.GetVolumes().GetLastProp().SetVisibility(visible)
            window.render()
            depth = vtkFloatArray()
            window.window.GetZbufferData(0, 0, 63, 63, depth)
            depths.append(meshes.vtk_to_numpy(depth).copy())
        np.testing.assert_array_equal(*depths)
        self.assertLess(depths[0].min(), 1, "the surface is there")
        scene.renderer.GetVolumes().GetLastProp().SetVisibility(True)
        window.render()
        hidden = float_image(ours)
        scene.add_opaque(plane((0.5, 0.5, -1), 3), self.SURFACE)
        window.render()
        self.assertGreater(hidden[..., 3].max(), 0.5)
        self.assertEqual(np.abs(float_image(ours)).max(), 0, "a surface in front hides all")


class Faint(SmokeTestCase):
    def test_a_thousand_faint_cells(self):
        """Opacity per cell from 1e-2 down to 1e-7. The thickness of a cell, 1e-3 at a distance of 5, is known in float to
        6e-8 * 5 / 1e-3 = 3e-4 of itself; half floats would lose all of a cell."""
        data = meshes.with_field(meshes.Lattice((1, 1, 1000)).mesh("voxel"), lambda p: 0 * p[:, 0])
        for each in (1e-2, 1e-4, 1e-5, 1e-7):
            for method in METHODS:
                window, scene, ours = scene_of(data, constant(1000 * each, COLOR), method)
                along_z(scene)
                window.render()
                alpha = -math.expm1(-1000 * each)
                self.check_all(middle(float_image(ours)), alpha, f"1000 cells of {each:g}, {method}", tolerance=3e-4 * alpha)

    def test_faint_boxes_in_one_place(self):
        """Boxes of optical depth 1e-4 over each other, each a little displaced: 400 roundings of float, of 6e-8 each at most."""
        parts = [((-0.0005 * i, 0, 0.0025 * i), (1, 1, 1 + 0.0025 * i)) for i in range(400)]
        data = meshes.with_field(smoke.boxes(parts, 1), lambda p: 0 * p[:, 0])
        for method in METHODS:
            window, scene, ours = scene_of(data, constant(1e-4, COLOR), method, size=(48, 48))
            along_z(scene)
            window.render()
            alpha = -math.expm1(-0.04)
            self.check_all(float_image(ours)[20:28, 20:28], alpha, f"400 faint boxes, {method}", tolerance=2.4e-5 * alpha)


if __name__ == "__main__":
    unittest.main(verbosity=2)
