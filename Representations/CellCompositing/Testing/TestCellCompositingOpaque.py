# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opaque surfaces in and around the cells, backgrounds, and several volumes in one renderer."""
import unittest

import numpy as np
from nephoscope_testing import meshes, reference, surfaces
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.surfaces import sphere
from nephoscope_testing.transfer import random_transfer

# Multiples of 1/255, so that the 8-bit background itself brings no error.
BACKGROUND = (51 / 255, 102 / 255, 204 / 255)
SURFACE = (204 / 255, 51 / 255, 0.0)


def sample(seed, count=30, extinction=2.0):
    rng = np.random.default_rng(seed)
    data = meshes.delaunay(rng, count)
    meshes.with_field(data, meshes.linear_field(rng, data))
    return data, random_transfer(rng, 5, max_extinction=extinction)


def plane(center, size=1.5, normal=(0.3, 0.4, 1)):
    return surfaces.plane(center, size, normal)


class Opaque(ImageTestCase):
    def test_surfaces_cut_the_cells(self):
        for label, surface in (("plane", plane((0, 0, 0))), ("small plane", plane((0.1, 0, 0.2), 0.4)),
                               ("sphere", sphere((0.1, -0.1, 0.2), 0.5))):
            for parallel in (False, True):
                data, transfer = sample(1)
                self.check(data, transfer, f"{label} inside, parallel {parallel}", opaque=(surface, SURFACE),
                           background=BACKGROUND, look=dict(parallel=parallel))

    def test_surface_in_front_hides(self):
        data, transfer = sample(2)
        drawn = self.check(data, transfer, "plane in front", opaque=(plane((0, 0, 2.5), 6, (0, 0, 1)), SURFACE),
                           look=lambda s: s.look((0, 0, 6), near=1, far=12))
        self.assertEqual(np.abs(float_image(drawn[0])).max(), 0)

    def test_surface_behind(self):
        data, transfer = sample(3)
        self.check(data, transfer, "plane behind", opaque=(plane((0, 0, -2), 6, (0, 0, 1)), SURFACE),
                   look=lambda s: s.look((0, 0, 6), near=1, far=12))

    def test_surface_with_cells_around_the_camera(self):
        data, transfer = sample(4, 40, 1.0)
        self.check(data, transfer, "camera inside, sphere ahead", opaque=(sphere((-0.3, 0, -0.3), 0.25), SURFACE),
                   look=lambda s: s.look((0.3, 0.2, 0.3), (-0.3, 0, -0.3), angle=60, near=0.02, far=6))

    def test_surface_in_a_viewport_away_from_the_origin(self):
        data, transfer = sample(5)
        self.check(data, transfer, "viewport with a sphere", opaque=(sphere((0, 0, 0.3), 0.5), SURFACE), size=(160, 96),
                   viewport=(0.4, 0.5, 1, 1), background=BACKGROUND)

    def test_depth_of_another_renderer_is_not_seen(self):
        """A surface in the left viewport does not hide the volume in the right one."""
        window = Window((160, 80))
        left = window.add_scene(viewport=(0, 0, 0.5, 1))
        left.add_opaque(plane((0, 0, 2), 6, (0, 0, 1)), SURFACE)
        left.look((0, 0, 6), near=1, far=12)
        right = window.add_scene(viewport=(0.5, 0, 1, 1))
        data, transfer = sample(6)
        ours = mapper()
        right.look_at(right.add_volume(ours, data, transfer))
        window.render()
        self.verify(right, ours, cells_of(data), transfer, "surface in the other viewport")

    def test_surface_that_moves(self):
        data, transfer = sample(7)
        surface = sphere((0, 0, 0.3), 0.4)
        ours, window, scene, _ = self.check(data, transfer, "sphere before the move", opaque=(surface, SURFACE))
        actor = scene.renderer.GetActors().GetLastActor()
        actor.SetPosition(0.4, 0.1, 0)
        window.render()
        moved = meshes.triangles_of(surface) + [0.4, 0.1, 0]
        self.verify(scene, ours, cells_of(data), transfer, "sphere after the move", (moved, SURFACE))
        scene.renderer.RemoveActor(actor)
        window.render()
        self.verify(scene, ours, cells_of(data), transfer, "sphere removed")


class Layers(ImageTestCase):
    def test_backgrounds(self):
        data, transfer = sample(10)
        for background in (BACKGROUND, (1, 1, 1)):
            self.check(data, transfer, f"background {background}", background=background)

    def test_gradient_background(self):
        data, transfer = sample(11)
        window = Window()
        scene = window.add_scene()
        scene.renderer.GradientBackgroundOn()
        scene.renderer.SetBackground2(1, 1, 1)
        window.render()
        under = scene.rgb()
        ours = mapper()
        scene.look_at(scene.add_volume(ours, data, transfer))
        window.render()
        cells, view = cells_of(data), scene.view()
        expected = reference.render(cells, view, transfer)
        # Two roundings: the background's own and the result's.
        self.check_float(scene.rgb(), reference.over(expected, under), "gradient background", 2 / 255,
                         edge_mask(cells.boundary_edges(), view))
        self.check_float(float_image(ours), expected, "over a gradient", mask=edge_mask(cells.drawn_edges(), view))

    def test_two_volumes_apart(self):
        """One behind the other: the nearer one lies over the farther one, whatever the order they were added in.
        VTK draws volumes in the order they were added unless the renderer's culler sorts them."""
        near_data, near_transfer = sample(12)
        far_data, far_transfer = sample(13)
        far_data.SetPoints(meshes.vtk_points(meshes.points_of(far_data) + [0.3, 0.2, -3]))
        for swap in (False, True):
            window = Window()
            scene = window.add_scene(background=BACKGROUND)
            scene.renderer.GetCullers().GetLastItem().SetSortingStyleToBackToFront()
            pairs = [(mapper(), near_data, near_transfer), (mapper(), far_data, far_transfer)]
            for m, data, transfer in (pairs[::-1] if swap else pairs):
                scene.add_volume(m, data, transfer)
            scene.look((0, 0, 6), (0, 0, 0), near=2, far=14, angle=30)
            window.render()
            view = scene.view()
            layers = [reference.render(cells_of(d), view, t) for _, d, t in pairs]
            expected = reference.over(layers[0], reference.over(layers[1], BACKGROUND))
            mask = edge_mask(np.concatenate([cells_of(d).boundary_edges() for _, d, t in pairs]), view)
            # Two layers laid over an 8-bit picture: two roundings.
            self.check_float(scene.rgb(), expected, f"two volumes apart, swapped {swap}", 2 / 255, mask)
            self.fail_on_messages(window)

    def test_invisible_volume(self):
        data, transfer = sample(14)
        _, window, scene, _ = self.check(data, transfer, "visible")
        scene.renderer.GetVolumes().GetLastProp().VisibilityOff()
        window.render()
        self.assertEqual(scene.rgb().max(), 0)

    def test_frame_by_frame_does_not_accumulate(self):
        data, transfer = sample(15)
        ours, window, scene, _ = self.check(data, transfer, "first frame")
        first, first_bytes = float_image(ours), scene.rgb()
        for _ in range(3):
            window.render()
        np.testing.assert_array_equal(float_image(ours), first)
        np.testing.assert_array_equal(scene.rgb(), first_bytes)


if __name__ == "__main__":
    unittest.main(verbosity=2)
