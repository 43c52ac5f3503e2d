# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras, viewports, windows and transforms of the prop: each pixel against the per-ray reference, and invariants."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import random_transfer
from vtkmodules.util.numpy_support import vtk_to_numpy


def sample(seed=1, count=20, extinction=2.0):
    """A Delaunay mesh with one linear field, and a transfer function."""
    rng = np.random.default_rng(seed)
    data = meshes.delaunay(rng, count)
    meshes.with_field(data, meshes.linear_field(rng, data))
    return data, random_transfer(rng, 5, max_extinction=extinction)


def rotation(axis, degrees):
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    a = np.radians(degrees)
    result = np.eye(4)
    result[:3, :3] += np.sin(a) * k + (1 - np.cos(a)) * k @ k
    return result


class Windows(ImageTestCase):
    def test_viewport_away_from_the_origin(self):
        data, transfer = sample()
        for viewport in ((0.5, 0, 1, 1), (0.25, 0.5, 0.75, 1), (0, 0, 0.5, 0.5)):
            self.check(data, transfer, f"viewport {viewport}", size=(160, 96), viewport=viewport)

    def test_several_renderers_in_one_window(self):
        window = Window((180, 120))
        scenes = []
        for i, viewport in enumerate(((0, 0, 0.5, 0.5), (0.5, 0, 1, 0.5), (0, 0.5, 1, 1))):
            data, transfer = sample(i)
            scene = window.add_scene(viewport=viewport, background=(0.2 * i, 0, 0.2))
            ours = mapper()
            scene.look_at(scene.add_volume(ours, data, transfer), parallel=i == 1)
            scenes.append((scene, ours, data, transfer, (0.2 * i, 0, 0.2)))
        window.render()
        for i, (scene, ours, data, transfer, background) in enumerate(scenes):
            self.verify(scene, ours, cells_of(data), transfer, f"renderer {i} of three", background=background)

    def test_window_sizes_and_resize(self):
        data, transfer = sample(2)
        for size in ((64, 64), (131, 77), (48, 150)):
            ours, window, scene, _ = self.check(data, transfer, f"window {size}", size=size)
        for size in ((90, 60), (201, 101), (33, 40)):
            window.window.SetSize(*size)
            window.render()
            self.verify(scene, ours, cells_of(data), transfer, f"resized to {size}")

    def test_two_windows(self):
        kept = []
        for seed in (3, 4):
            data, transfer = sample(seed)
            kept.append((data, transfer, *self.check(data, transfer, f"window {seed - 2} of two")))
        for data, transfer, ours, window, scene, _ in kept:
            scene.camera.Azimuth(25)
            window.render()
            self.verify(scene, ours, cells_of(data), transfer, "drawn again beside another window")

    def test_one_mapper_in_two_windows(self):
        data, transfer = sample(5)
        ours, window, scene, _ = self.check(data, transfer, "first window")
        second = Window((70, 90))
        other = second.add_scene()
        other.look_at(other.add_volume(ours, data, transfer), direction=(1, 0, 0.2))
        second.render()
        self.verify(other, ours, cells_of(data), transfer, "the same mapper in a second window")
        window.render()
        self.verify(scene, ours, cells_of(data), transfer, "back in the first window")

    def test_released_resources_come_back(self):
        data, transfer = sample(6)
        ours, window, scene, _ = self.check(data, transfer, "before release")
        ours.ReleaseGraphicsResources(window.window)
        window.render()
        self.verify(scene, ours, cells_of(data), transfer, "after release")

    def test_no_gl_error_is_left(self):
        data, transfer = sample(7)
        window = Window()
        window.add_scene()
        window.render()
        window.gl_errors()
        scene = window.add_scene()
        scene.look_at(scene.add_volume(mapper(), data, transfer))
        for _ in range(3):
            window.render()
            self.assertEqual(window.gl_errors(), [])
        self.fail_on_messages(window)


class SmallInThePicture(ImageTestCase):
    """Only the pixels that the boundary can cover are drawn: nothing is cut off, and nothing of an earlier picture is left."""

    def test_far_and_near(self):
        data, transfer = sample(8)
        cut_off = 1e-3  # far less than what is cut off; a ray that runs in an edge passes beside its pixel's centre
        shapes = {"mesh": data, "image": meshes.with_field(meshes.image((3, 3, 3), (0.3,) * 3), lambda p: p[:, 0])}
        for label, shape in shapes.items():
            for viewport in ((0, 0, 1, 1), (0.4, 0.3, 1, 0.9)):
                background = (0.1, 0.3, 0.2)
                ours, window, scene, _ = self.check(shape, transfer, f"{label} near, {viewport}", size=(150, 110), viewport=viewport,
                                                    background=background, tolerance=cut_off)
                for zoom, center in ((0.2, (0, 0)), (0.3, (0.8, -0.7)), (0.5, (1, 0.2)), (1, (0, 0)), (0.05, (0.3, 0.3)), (3, (0.5, 0))):
                    scene.look_at(shape, zoom=zoom)
                    scene.camera.SetWindowCenter(*center)
                    window.render()
                    self.verify(scene, ours, cells_of(shape, decompose=label == "image"), transfer, f"{label}, zoom {zoom} at {center}",
                                background=background, tolerance=cut_off)

    def test_out_of_the_picture(self):
        data, transfer = sample(8)
        ours, window, scene, _ = self.check(data, transfer, "before")
        scene.camera.SetWindowCenter(3, 0)
        window.render()
        self.assertEqual(scene.rgb().max(), 0)


class Cameras(ImageTestCase):
    def test_up_vectors_window_center_and_angles(self):
        data, transfer = sample(10)
        for parallel in (False, True):
            def look(scene):
                scene.look_at(data, up=(0.3, -0.8, 0.5), parallel=parallel, angle=70)
                scene.camera.SetWindowCenter(0.3, -0.2)
            self.check(data, transfer, f"off-centre window, parallel {parallel}", look=look)
        for angle in (3, 120):
            self.check(data, transfer, f"view angle {angle}", look=dict(angle=angle))

    def test_horizontal_view_angle(self):
        data, transfer = sample(11)

        def look(scene):
            scene.look_at(data)
            scene.camera.UseHorizontalViewAngleOn()
        self.check(data, transfer, "horizontal view angle", look=look, size=(120, 80))

    def test_inside_the_volume(self):
        for seed, near in ((12, 1e-3), (13, 0.2)):
            data, transfer = sample(seed, 40, 1.0)
            for position, focus in (((0.1, 0.05, -0.02), (1, 0.3, 0.2)), ((-0.2, 0.1, 0.3), (0, 0, -1))):
                look = lambda s: s.look(position, focus, (0, 0.9, 0.1), 70, near=near, far=10)
                self.check(data, transfer, f"camera inside at {position}, near {near}", look=look)

    def test_inside_one_large_tetrahedron(self):
        data = meshes.tetrahedra(4 * np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1.0)]), [(0, 1, 2, 3)])
        meshes.with_field(data, meshes.linear_field(np.random.default_rng(14), data))
        transfer = random_transfer(np.random.default_rng(14), 4, max_extinction=0.5)
        self.check(data, transfer, "inside one tetrahedron",
                   look=lambda s: s.look((0.3, 0.2, 0.5), (0, 0.1, -1), angle=60, near=0.1, far=50))

    def test_near_plane_through_the_cells(self):
        data, transfer = sample(15, 30)
        for near in (2.2, 3.0, 3.6):
            for parallel in (None, 1.2):
                self.check(data, transfer, f"near plane at {near}, parallel scale {parallel}",
                           look=lambda s: s.look((0, 1, 2.8), (0, 0, 0), angle=40, parallel_scale=parallel, near=near, far=9))

    def test_mirrored_camera_gives_the_mirrored_image(self):
        data, transfer = sample(16, 30)
        mirrored = meshes.tetrahedra(meshes.points_of(data) * [-1, 1, 1],
                                     [[data.GetCell(i).GetPointId(k) for k in range(4)] for i in range(data.GetNumberOfCells())])
        meshes.add_array(mirrored.GetPointData(), vtk_to_numpy(data.GetPointData().GetArray("s")))
        pictures = []
        for mesh, sign in ((data, 1), (mirrored, -1)):
            result = self.check(mesh, transfer, f"mirrored {sign}", look=lambda s: s.look((sign * 2, 1, 4), near=1, far=9))
            pictures.append((float_image(result[0]), edge_mask(cells_of(mesh).drawn_edges(), result[2].view())))
        mask = pictures[0][1] | pictures[1][1][:, ::-1]
        self.check_float(pictures[1][0][:, ::-1], pictures[0][0], "mirrored camera", 1e-4, mask)

    def test_moving_camera_keeps_no_state(self):
        """The picture after a round trip of the camera is the first picture, bit for bit."""
        data, transfer = sample(17, 30)
        ours, window, scene, _ = self.check(data, transfer, "round trip")
        first = float_image(ours)
        position = scene.camera.GetPosition()
        for step in ((4, 1, 1), (-3, 2, 1), position):
            scene.camera.SetPosition(*step)
            window.render()
        np.testing.assert_array_equal(float_image(ours), first)


class Transforms(ImageTestCase):
    def test_prop_matrix(self):
        data, transfer = sample(20)
        move = np.eye(4)
        move[:3, 3] = (5, -3, 2)
        cases = {"scale 3": np.diag([3, 3, 3, 1.0]), "scale 300": np.diag([300, 300, 300, 1.0]),
                 "scale 1e-3": np.diag([1e-3] * 3 + [1.0]), "non-uniform scale": np.diag([1, 0.2, 6, 1.0]),
                 "mirrored": np.diag([-1, 1, 1, 1.0]), "mirrored and stretched": np.diag([2, -0.5, 1, 1.0]),
                 "rotated": rotation((1, 2, 3), 70), "all together": move @ rotation((1, 1, 0), 40) @ np.diag([1, -2, 0.7, 1.0])}
        for label, matrix in cases.items():
            size = abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3)
            transfer.unit_distance = size  # keeps the optical depth near 1
            for parallel in (False, True):
                self.check(data, transfer, f"{label}, parallel {parallel}", matrix=matrix, look=dict(parallel=parallel))

    def test_scale_and_orientation_of_the_prop(self):
        """The prop's own Scale, Position and RotateZ, not only a user matrix."""
        data, transfer = sample(21)
        window = Window()
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer)
        volume.SetScale(1, 1, 3)
        volume.RotateZ(30)
        volume.SetPosition(1, 0, -1)
        scene.look_at(volume)
        window.render()
        m = volume.GetMatrix()
        matrix = np.array([[m.GetElement(i, j) for j in range(4)] for i in range(4)])
        self.verify(scene, ours, cells_of(data, matrix=matrix), transfer, "prop scale, rotation and position")

    def test_huge_coordinates(self):
        for seed, offset, scale in ((22, 1e7, 1.0), (23, 1e7, 0.01), (24, 6.4e6, 1e3)):
            rng = np.random.default_rng(seed)
            data, transfer = sample(seed)
            data.SetPoints(meshes.vtk_points(meshes.points_of(data) * scale + offset * rng.uniform(0.5, 1, 3)))
            transfer.unit_distance = scale
            self.check(data, transfer, f"cells of size {scale:g} at {offset:g}")

    def test_huge_and_small_units(self):
        for scale in (1e-6, 1e6):
            data, transfer = sample(25)
            data.SetPoints(meshes.vtk_points(meshes.points_of(data) * scale))
            transfer.unit_distance = scale
            for parallel in (False, True):
                self.check(data, transfer, f"unit {scale:g}, parallel {parallel}", look=dict(parallel=parallel))

    def test_numbering_does_not_matter(self):
        rng = np.random.default_rng(26)
        data, transfer = sample(26, 60)
        ours, _, scene, expected = self.check(data, transfer, "as it came")
        mask = edge_mask(cells_of(data).drawn_edges(), scene.view())
        for number in range(3):
            other = self.check(meshes.renumbered(data, rng), transfer, f"renumbered {number}", look=lambda s: s.look_at(data))
            difference = Difference(float_image(other[0]), float_image(ours), mask)
            print("  renumbered against original:", difference)
            self.assertLessEqual(difference.maximum, 1e-5)


if __name__ == "__main__":
    unittest.main(verbosity=2)
