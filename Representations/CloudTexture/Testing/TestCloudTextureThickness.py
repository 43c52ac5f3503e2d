# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds are as opaque as they are thick along the ray: against closed forms, per pixel."""
import itertools
import math
import os
import unittest

import numpy as np
from cloud_bodies import FACES, BodyTestCase, box, opacity, sphere, stay_in_box, together, torus, wall
from cloud_sheets import sheet
from nephoscope_testing import meshes
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkCommonTransforms import vtkTransform

LOW, HIGH = (-1.0, -0.8, -0.6), (0.9, 0.7, 0.5)


class Thickness(BodyTestCase):
    def test_box(self):
        for peeling, parallel, density in itertools.product(*3 * [(False, True)]):
            data = box(LOW, HIGH, (lambda p: np.full(len(p), 0.7)) if density else None)
            window, scene, mapper, _ = self.bodies(data, parallel_scale=1.5 if parallel else None)
            mapper.SetDensityArrayName("density" if density else None)
            scene.renderer.SetUseDepthPeeling(peeling)
            drawn = self.draw(window)
            origins, directions, _ = self.rays(scene)
            near, far = stay_in_box(origins, directions, LOW, HIGH)
            with self.subTest(peeling=peeling, parallel=parallel, density=density):
                self.compare(drawn, opacity((0.7 if density else 1) * (far - near)))

    def test_sphere(self):
        window, scene, _, _ = self.bodies(sphere(1.0), extinction=0.8)
        drawn = self.draw(window)
        origins, directions, _ = self.rays(scene)
        along = np.einsum("ij,ij->i", origins, directions)
        half = np.sqrt(np.maximum(0, 1 - np.einsum("ij,ij->i", origins, origins) + along**2))
        self.compare(drawn, opacity(0.8 * 2 * half), allowed=2 / 255, share=0.995)  # the sphere has facets

    def test_torus_twice_on_a_ray(self):
        """In the middle plane of the torus: ring, hole, ring; then something opaque in the hole, and in each part of the ring."""
        large, small, extinction = 1.0, 0.3, 0.9
        for distance in (None, 0.0, 0.9, -0.9):
            window, scene, mapper, _ = self.bodies(torus(large, small), size=(97, 97), extinction=extinction, position=(0, -6, 0),
                                                   up=(0, 0, 1), parallel_scale=1.5)
            if distance is not None:
                actor = scene.add_opaque(wall(0), (0, 0, 0))
                actor.RotateX(90)
                actor.SetPosition(0, distance, 0)
            drawn = self.draw(window)[48]
            x = scene.view().rays()[0][48 * 97:49 * 97, 0]
            outer, inner = (np.sqrt(np.maximum(0, r * r - x * x)) for r in (large + small, large - small))
            end = np.inf if distance is None else distance
            length = np.maximum(0, np.minimum(-inner, end) + outer) + np.maximum(0, np.minimum(outer, end) - np.minimum(inner, end))
            with self.subTest(distance=distance):
                self.compare(drawn, opacity(extinction * length), allowed=2 / 255, share=0.97)

    def test_eye_in_the_cloud(self):
        """From the near plane on; a cloud behind is one of its own."""
        second = ((-0.9, -0.7, -3), (0.8, 0.9, -1.5))
        for peeling in (False, True):
            window, scene, _, _ = self.bodies(together(box((-2, -2, -1), (2, 2, 2)), box(*second)), extinction=0.4,
                                              position=(0.2, 0.1, 1), near=0.3, far=8, angle=60)
            scene.renderer.SetUseDepthPeeling(peeling)
            drawn = self.draw(window)
            origins, directions, near = self.rays(scene)
            _, leave = stay_in_box(origins, directions, (-2, -2, -1), (2, 2, 2))
            enter, out = stay_in_box(origins, directions, *second)
            self.compare(drawn, opacity(0.4 * (leave - near + out - enter)))

    def test_opaque_in_the_cloud(self):
        for z, density in itertools.product((-0.8, -0.2, 0.3, 0.8), (False, True)):
            data = box(LOW, HIGH, lambda p: np.full(len(p), 1.0))
            window, scene, mapper, _ = self.bodies(data)
            mapper.SetDensityArrayName("density" if density else None)
            scene.add_opaque(wall(z), (0, 0, 0))
            drawn = self.draw(window)
            origins, directions, _ = self.rays(scene)
            near, far = stay_in_box(origins, directions, LOW, HIGH)
            stop = (z - origins[:, 2]) / directions[:, 2]
            expected = opacity(np.maximum(0, np.minimum(far, stop) - near))
            with self.subTest(z=z, density=density):
                drawn.max() and self.compare(drawn, expected)
                self.assertEqual(drawn.max() > 0, expected.max() > 0)

    def test_many_behind_one_another(self):
        """Up to the limit nothing is missing; above it a warning tells. Images in shaders need no limit."""
        unlimited = "image_load_store" not in os.environ.get("MESA_EXTENSION_OVERRIDE", "")
        slabs = [((-1, -1, -i), (1, 1, -i + 0.15 + 0.05 * i)) for i in range(8)]
        for count, layers in ((8, 8), (5, 6), (8, 4)):
            window, scene, mapper, _ = self.bodies(together(*(box(*s) for s in slabs[:count])), extinction=0.3, far=40)
            mapper.SetMaximumNumberOfLayers(layers)
            window.render()
            window.render()
            self.assertEqual(window.gl_errors(), [])
            origins, directions, _ = self.rays(scene)
            length = sum(np.subtract(*stay_in_box(origins, directions, *s)[::-1]) for s in slabs[:count])
            with self.subTest(count=count, layers=layers):
                self.compare(window.rgba()[..., 0], opacity(0.3 * length), share=1.0 if unlimited or count <= layers else 0.2)
                self.assertEqual(len(window.messages.all), not unlimited and count > layers, window.messages.all)
                self.assertTrue(all("MaximumNumberOfLayers" in m for m in window.messages.all))


def way_in_box(origins, directions, wall=None):
    """Lengths of rays in the box, up to the wall at this z, and the middles of these ways."""
    near, far = stay_in_box(origins, directions, LOW, HIGH)
    stop = np.inf if wall is None else (wall - origins[:, 2]) / directions[:, 2]
    end = np.maximum(near, np.minimum(far, stop))
    return end - near, origins + (0.5 * (near + end))[:, None] * directions


def image(low, high, size, density, name="density"):
    """A density at the points of an image."""
    data = meshes.image([n - 1 for n in size], np.subtract(high, low) / np.maximum(np.array(size) - 1, 1), low)
    meshes.add_array(data.GetPointData(), np.asarray(density(meshes.points_of(data)), float), name)
    return data


class DensityInSpace(BodyTestCase):
    """Density of an image, integrated along the ray inside of the surface."""

    def test_constant(self):
        """As a density of the surface; box and sphere, in both projections, with and without peeling; 0 outside of the image."""
        for body, parallel, peeling in itertools.product((box(LOW, HIGH), sphere(0.8)), (False, True), (False, True)):
            pictures = []
            for volume in (False, True):
                window, scene, mapper, _ = self.bodies(body, extinction=0.7 if not volume else 1.0, parallel_scale=1.5 if parallel else None)
                mapper.SetDensityVolume(image((-2, -2, -2), (2, 2, 2), (5, 6, 7), lambda p: 0.7 + 0 * p[:, 0]) if volume else None)
                mapper.SetDensityArrayName("density" if volume else None)
                scene.renderer.SetUseDepthPeeling(peeling)
                pictures.append(self.draw(window))
            with self.subTest(parallel=parallel, peeling=peeling):
                self.assertLessEqual(np.abs(pictures[0] - pictures[1]).max(), 1.01 / 255)

    def test_linear(self):
        """Up to an opaque wall, too; the extent of the image does not begin at 0."""
        density = np.array((0.6, 0.5, 0.4))
        for z, parallel in itertools.product((None, -0.2, 0.3), (False, True)):
            volume = image((-1.5, -1, -1.2), (1.1, 1.4, 0.9), (9, 4, 13), lambda p: 2.5 + p @ density)
            volume.SetExtent(3, 11, -2, 1, 5, 17)
            spacing = np.array(volume.GetSpacing())
            volume.SetOrigin(*(np.array((-1.5, -1, -1.2)) - np.array((3, -2, 5)) * spacing))
            window, scene, mapper, _ = self.bodies(box(LOW, HIGH), extinction=0.5, parallel_scale=1.5 if parallel else None)
            mapper.SetDensityVolume(volume)
            mapper.SetDensityArrayName("density")
            if z is not None:
                scene.add_opaque(wall(z), (0, 0, 0))
            drawn = self.draw(window)
            length, middle = way_in_box(*self.rays(scene)[:2], z)
            with self.subTest(z=z, parallel=parallel):
                self.compare(drawn, opacity(0.5 * length * (2.5 + middle @ density)), share=0.999)

    def two_slabs(self, densities, peeling=False, **options):
        """A dense and a thin one behind one another; points of the image are so close that rays cross many voxels."""
        slabs = [((-1, -1, 0), (1, 1, 0.5)), ((-1, -1, -2), (1, 1, -1.5))]
        window, scene, mapper, _ = self.bodies(together(*(box(*s) for s in slabs)), **options)
        mapper.SetDensityVolume(image((-2, -2, -3), (2, 2, 1), (2, 2, 41), lambda p: np.where(p[:, 2] > -1, *densities)))
        mapper.SetDensityArrayName("density")
        scene.renderer.SetUseDepthPeeling(peeling)
        origins, directions, _ = self.rays(scene)
        optical = [options["extinction"] * d * np.subtract(*stay_in_box(origins, directions, *s)[::-1]) for s, d in zip(slabs, densities)]
        return window, mapper, optical

    def test_dense_and_thin(self):
        """Each slab has the optical depth of its own way, whichever is in front. Only one that is opaque may end a way."""
        for densities, extinction, peeling in itertools.product(((40, 10), (10, 40)), (0.05, 0.6), (False, True)):
            window, _, optical = self.two_slabs(densities, peeling, extinction=extinction)
            with self.subTest(densities=densities, extinction=extinction, peeling=peeling):
                self.compare(self.draw(window), opacity(sum(optical)), share=0.999)

    def test_added_to_the_texture(self):
        """Clouds begin at a thickness that multiplied opacity would no longer show."""
        window, mapper, optical = self.two_slabs((40, 10), extinction=1)
        mapper.SetThicknessEffectToAddToTexture()
        mapper.SetThicknessWeight(1)
        mapper.UseThresholdOn()
        for threshold in (5, 12, 30):
            mapper.SetThreshold(threshold)
            clear = np.abs(np.subtract(optical, threshold)).min(axis=0) > 4  # the texture is within 4 of its standard deviations
            seen = np.max(optical, axis=0) > threshold
            with self.subTest(threshold=threshold):
                self.assertGreater(clear.mean(), 0.3)
                self.assertGreaterEqual((self.draw(window).ravel() == seen)[clear].mean(), 0.999)  # at edges rounding decides

    def test_what_the_faces_do_not_know(self):
        """A sheet of cloud amid the body: 0 at its faces, 3 in the middle, linear between the points. The actor is stretched and turned."""
        window, scene, mapper, actor = self.bodies(box((-1, -1, -1), (1, 1, 1)))
        mapper.SetDensityVolume(image((-1, -1, -1), (1, 1, 1), (2, 2, 5), lambda p: np.where(np.abs(p[:, 2]) < 0.1, 3.0, 0.0)))
        mapper.SetDensityArrayName("density")
        origins, directions, _ = self.rays(scene)
        near, far = stay_in_box(origins, directions, (-1, -1, -1), (1, 1, 1))
        first, last = (origins[:, 2] + t * directions[:, 2] for t in (near, far))
        below = lambda z: np.where(z < 0, 0.5 * np.clip(z + 0.5, 0, None) ** 2 * 6, 1.5 - 0.5 * np.clip(0.5 - z, 0, None) ** 2 * 6)
        expected = opacity(np.where(far > near, np.abs(below(last) - below(first)) / np.abs(directions[:, 2]), 0))
        self.compare(self.draw(window), expected, share=0.999)
        turn = vtkTransform()
        turn.RotateZ(90)
        turn.Scale(1, 1, 2)
        actor.SetUserTransform(turn)
        origins, directions, _ = self.rays(scene)
        near, far = stay_in_box(origins, directions, (-1, -1, -2), (1, 1, 2))
        first, last = (0.5 * (origins[:, 2] + t * directions[:, 2]) for t in (near, far))
        expected = opacity(np.where(far > near, 2 * np.abs(below(last) - below(first)) / np.abs(directions[:, 2]), 0))
        self.compare(self.draw(window), expected, share=0.999)

    def test_eye_in_the_cloud(self):
        density = np.array((0.1, 0.2, 0.3))
        window, scene, mapper, _ = self.bodies(box((-2, -2, -1), (2, 2, 2)), extinction=0.4, position=(0.2, 0.1, 1), near=0.3, far=8, angle=60)
        mapper.SetDensityVolume(image((-2, -2, -2), (2, 2, 2), (3, 4, 5), lambda p: 1.5 + p @ density))
        mapper.SetDensityArrayName("density")
        origins, directions, near = self.rays(scene)
        _, leave = stay_in_box(origins, directions, (-2, -2, -1), (2, 2, 2))
        middle = origins + (0.5 * (near + leave))[:, None] * directions
        self.compare(self.draw(window), opacity(0.4 * (leave - near) * (1.5 + middle @ density)), share=0.999)

    def test_changes_and_messages(self):
        window, scene, mapper, _ = self.bodies(box(LOW, HIGH), extinction=0)
        plain = self.draw(window)
        volume = image((-2, -2, -2), (2, 2, 2), (3, 3, 3), lambda p: 0.01 + 0 * p[:, 0])
        mapper.SetDensityVolume(volume)
        mapper.SetDensityArrayName("density")
        self.assertLessEqual(np.abs(self.draw(window) - plain).max(), 1.01 / 255, "the default extinction follows the density")
        values = volume.GetPointData().GetArray("density")
        values.Fill(0)
        values.Modified()
        volume.Modified()
        self.assertEqual(self.draw(window).max(), 0)
        mapper.SetDensityVolume(None)
        mapper.SetDensityArrayName(None)
        np.testing.assert_array_equal(self.draw(window), plain)
        for bad, words in ((image((0, 0, 0), (1, 1, 1), (2, 2, 2), lambda p: p[:, 0], "other"), "no point array 'density'"),
                           (image((0, 0, 0), (1, 1, 1), (2, 2, 1), lambda p: p[:, 0]), "two points or more along each axis"),
                           (image((-2, -2, -2), (2, 2, 2), (2, 2, 2), lambda p: p[:, 0]), "4 values that are not a density")):
            mapper.SetDensityVolume(bad)
            mapper.SetDensityArrayName("density")
            before = len(window.messages.all)
            window.render()
            window.render()
            said = window.messages.all[before:]
            self.assertEqual(len(said), 1, said)
            self.assertIn(words, said[0])
        self.assertEqual(window.gl_errors(), [])

    def test_a_volume_elsewhere(self):
        """One in other coordinates is told once for each place."""
        window, _, mapper, _ = self.bodies(box(LOW, HIGH), extinction=1)
        volumes = [image(np.multiply(scale, (-2, -2, -2)) + shift, np.multiply(scale, (2, 2, 2)) + shift, (3, 3, 3), lambda p: 1 + 0 * p[:, 0]) for scale, shift in ((1, 0), (1, 5), (1000, 9000))]
        mapper.SetDensityArrayName("density")
        for volume, count in ((volumes[0], 0), (volumes[1], 1), (volumes[1], 1), (volumes[0], 1), (volumes[2], 2)):
            mapper.SetDensityVolume(volume)
            window.render()
            self.assertEqual(window.rgba()[..., :3].max() > 0, volume is volumes[0])
            told = window.messages.all
            self.assertEqual(len(told), count, told)
        self.assertRegex(told[0], r"not where the surface is.*the surface is at x = .* to .*, the volume at x = 3 to 7, y = 3 to 7, z = 3 to 7\. Give both the same coordinates")


class Blocks(BodyTestCase):
    def test_composite(self):
        """Two halves of a box, each open where they meet, are one body; blocks of other kinds are left out."""
        whole = box(LOW, HIGH)
        data = vtkMultiBlockDataSet()
        for i, faces in enumerate((FACES[:2], FACES[2:])):
            data.SetBlock(i, meshes.surface(meshes.points_of(whole), faces))
        data.SetBlock(2, vtkImageData())
        window, scene, mapper, _ = self.bodies(whole)
        mapper.SetInputDataObject(data)
        for peeling in (False, True):
            scene.renderer.SetUseDepthPeeling(peeling)
            origins, directions, _ = self.rays(scene)
            self.compare(self.draw(window), opacity(np.subtract(*stay_in_box(origins, directions, LOW, HIGH)[::-1])))
        np.testing.assert_allclose(mapper.GetBounds(), np.stack([LOW, HIGH], -1).ravel())

    def test_nothing(self):
        window, _, mapper, _ = self.bodies(box(LOW, HIGH))
        mapper.SetInputDataObject(vtkMultiBlockDataSet())
        self.assertEqual(self.draw(window).max(), 0)


class Density(BodyTestCase):
    def test_linear(self):
        """Exactly integrated where the density is linear in the body: also up to an opaque wall."""
        density = np.array((0.6, 0.5, 0.4))
        for z, peeling in itertools.product((None, -0.2, 0.3), (False, True)):
            data = box(LOW, HIGH, lambda p: 1.5 + p @ density)
            window, scene, mapper, _ = self.bodies(data, extinction=0.8)
            mapper.SetDensityArrayName("density")
            scene.renderer.SetUseDepthPeeling(peeling)
            if z is not None:
                scene.add_opaque(wall(z), (0, 0, 0))
            drawn = self.draw(window)
            length, middle = way_in_box(*self.rays(scene)[:2], z)
            with self.subTest(z=z, peeling=peeling):
                # faces are two triangles each: values at corners are linear there, too
                self.compare(drawn, opacity(0.8 * length * (1.5 + middle @ density)), share=0.999)

    def test_several_bodies(self):
        """Each has its own density, the one behind included."""
        bodies = [((-1, -1, -0.5), (1, 1, 0)), ((-1, -1, -2), (1, 1, -1.2)), ((-1, -1, -4), (1, 1, -3))]
        densities = (0.2, 0.9, 0.5)
        data = together(*(box(*b, density=lambda p, d=d: np.full(len(p), d)) for b, d in zip(bodies, densities)))
        window, scene, mapper, _ = self.bodies(data)
        mapper.SetDensityArrayName("density")
        drawn = self.draw(window)
        origins, directions, _ = self.rays(scene)
        optical = sum(d * np.subtract(*stay_in_box(origins, directions, *b)[::-1]) for b, d in zip(bodies, densities))
        self.compare(drawn, opacity(optical))


class WhichSide(BodyTestCase):
    def test_mirrored(self):
        """By the actor, by the camera, by a surface that is inside out: the same picture, mirrored or not."""
        expected = None
        for way in ("none", "actor", "inside out", "actor and inside out"):
            data = box(LOW, HIGH)
            if "inside out" in way:
                data = together(data)
                cells = data.GetPolys()
                cells.ReverseCellAtId and [cells.ReverseCellAtId(i) for i in range(cells.GetNumberOfCells())]
            window, scene, mapper, actor = self.bodies(data)
            if "actor" in way:
                actor.SetScale(-1, 1, 1)
                actor.SetPosition(HIGH[0] + LOW[0], 0, 0)
            drawn = self.draw(window)
            expected = drawn if expected is None else expected
            np.testing.assert_allclose(drawn, expected, atol=1.01 / 255, err_msg=way)

    def test_mirrored_camera(self):
        window, scene, _, _ = self.bodies(box(LOW, HIGH))
        expected = self.draw(window)
        mirror = vtkTransform()
        mirror.Scale(-1, 1, 1)
        scene.camera.SetUserTransform(mirror)
        np.testing.assert_allclose(self.draw(window)[:, ::-1], expected, atol=1.01 / 255)

    def test_scaled_actor(self):
        """Lengths are those of the scene."""
        window, scene, _, actor = self.bodies(box(np.array(LOW) / (1, 2, 3), np.array(HIGH) / (1, 2, 3)))
        actor.SetScale(1, 2, 3)
        drawn = self.draw(window)
        origins, directions, _ = self.rays(scene)
        self.compare(drawn, opacity(np.subtract(*stay_in_box(origins, directions, LOW, HIGH)[::-1])))


class Default(BodyTestCase):
    def test_mean_chord(self):
        """Four times the volume over the area: 4/3 of the radius of a sphere, in the scene."""
        for scale in (1, 0.5):
            window, scene, mapper, actor = self.bodies(sphere(1 / scale), size=(65, 65), extinction=0, position=(0, 0, 5))
            actor.SetScale(scale)
            mapper.SetOpticalDepth(0.9)
            self.assertAlmostEqual(self.draw(window)[32, 32], opacity(0.9 * 2 / (4 / 3)), delta=1.5 / 255)

    def test_open_surface(self):
        """Nothing behind: a layer, seen at an angle. Something opaque behind: up to there."""
        for opaque in (False, True):
            data = sheet(((0, 0, 0), (1, 2, 1)), [], tilt=40)
            window, scene, mapper, _ = self.bodies(data, size=(65, 65), extinction=0.5, position=(0, 0, 5))
            mapper.SetOpticalDepth(0.4)
            if opaque:
                scene.add_opaque(wall(-0.8), (0, 0, 0))
            expected = opacity(0.5 * 0.8 if opaque else 0.4 / math.cos(math.radians(40)))
            self.assertAlmostEqual(self.draw(window)[32, 32], expected, delta=1.5 / 255)

    def test_through_an_opening(self):
        """A box without its lid: its floor is seen from inside, as a layer; where a side is before it, nothing is added."""
        for peeling in (False, True):
            window, scene, mapper, _ = self.bodies(meshes.surface(meshes.points_of(box(LOW, HIGH)), FACES[:1] + FACES[2:]), size=(65, 65),
                                                   position=(0, 0, 5))
            mapper.SetOpticalDepth(0.4)
            scene.renderer.SetUseDepthPeeling(peeling)
            self.assertAlmostEqual(self.draw(window)[32, 32], opacity(0.4), delta=1.5 / 255)

    def test_regions(self):
        """Two that share a picture draw that of one: each fragment once, with the thickness of the whole, turned or not."""
        data = together(box(LOW, HIGH), box((-0.9, -0.7, -3), (0.8, 0.9, -1.5)))
        for axis, border, turn in ((0, 0.1, 0), (0, 0.1, 30), (2, -0.9, 0)):
            parts = []
            for low, high in ((-np.inf, np.inf), (-np.inf, border), (border, np.inf), (border, border)):
                window, scene, mapper, actor = self.bodies(data, extinction=0.5)
                actor.RotateZ(turn)
                region = [-np.inf, np.inf] * 3
                region[2 * axis:2 * axis + 2] = low, high
                mapper.SetRegion(region)
                scene.renderer.SetUseDepthPeeling(True)
                parts.append(self.draw(window))
            whole, first, second, none = parts
            with self.subTest(axis=axis, turn=turn):
                self.assertGreater(min(first.max(), second.max()), 0.2)
                self.assertEqual(none.max(), 0)
                self.compare(1 - (1 - first) * (1 - second), whole.ravel(), allowed=2.5 / 255)

    def test_off(self):
        window, scene, mapper, _ = self.bodies(box(LOW, HIGH), size=(65, 65), position=(0, 0, 5))
        mapper.UseThicknessOff()
        mapper.SetOpticalDepth(0.4)
        self.assertAlmostEqual(self.draw(window)[32, 32], opacity(2 * 0.4), delta=2.5 / 255)  # both faces


if __name__ == "__main__":
    unittest.main()
