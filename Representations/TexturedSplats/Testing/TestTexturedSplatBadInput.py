# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What splats cannot be drawn from is told, once, with a remedy."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import constant
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet


class BadInput(unittest.TestCase):
    def draw(self, data, configure=None, transfer=None):
        window = Window((32, 32))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(mapper, data, transfer or constant())
        scene.look((0, 0, 8), (0, 0, 0))
        if configure:
            configure(mapper, scene)
        window.render()
        window.render()
        self.window = window  # whose pictures go with it
        return window.messages, mapper

    def cube(self):
        return meshes.with_field(meshes.image((2, 2, 2), origin=(-1, -1, -1)), lambda p: p[:, 0])

    def expect(self, text, *arguments, **options):
        messages, _ = self.draw(*arguments, **options)
        self.assertEqual(len(messages.errors), 1, messages.all)
        self.assertIn(text, messages.errors[0])

    def test_nothing_to_draw(self):
        self.expect("no points", meshes.particles(np.zeros((0, 3))))

    def test_too_long(self):
        self.expect("single precision", meshes.with_field(meshes.image((2, 2, 2), (1e13,) * 3), lambda p: p[:, 0]))

    def test_too_small(self):
        """Splats whose volume is no number in single precision are told; those just large enough are drawn as those of 1."""
        def small(size, make):
            return meshes.with_field(make(size), lambda p: p[:, 0] / size)
        makers = {"image": lambda size: meshes.image((2, 2, 2), (size,) * 3, origin=(-size,) * 3),
                  "points": lambda size: meshes.particles(size * np.mgrid[-1:2, -1:2, -1:2].reshape(3, -1).T)}
        for name, make in makers.items():
            pictures = []
            for size in (1.0, 1e-12):
                def configure(mapper, scene):
                    scene.look((0, 0, 8 * size), (0, 0, 0))
                    scene.renderer.GetVolumes().GetItemAsObject(0).GetProperty().SetScalarOpacityUnitDistance(size)
                with self.subTest(name, size=size):
                    messages, mapper = self.draw(small(size, make), configure)
                    self.assertEqual(messages.all, [])
                    pictures.append(float_image(mapper))
            self.assertGreater(pictures[0].max(), 0.1)
            np.testing.assert_allclose(pictures[1], pictures[0], atol=1e-3)
            for size in (1e-13, 1e-20, 1e-30):
                with self.subTest(name, size=size):
                    self.expect("too small for the single precision of graphics cards. Choose a smaller unit", small(size, make))

    def test_small_polyhedra(self):
        """They are drawn as those of 1, without messages of VTK, which cannot triangulate them at that size."""
        corners = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-0.8, -1, 1], [1, -0.9, 1], [0.9, 1, 1], [-1, 0.9, 1]])
        faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        pictures = []
        for size in (1.0, 1e-5, 1e-10, 3e-12):
            def configure(mapper, scene):
                scene.look((0, 0, 8 * size), (0, 0, 0))
                scene.renderer.GetVolumes().GetItemAsObject(0).GetProperty().SetScalarOpacityUnitDistance(size)
            with self.subTest(size=size):
                messages, mapper = self.draw(meshes.with_field(meshes.polyhedron(size * corners, faces), lambda p: p[:, 0] / size), configure)
                self.assertEqual(messages.all, [])
                pictures.append(float_image(mapper))
                np.testing.assert_allclose(pictures[-1], pictures[0], atol=1e-3)
        self.assertGreater(pictures[0].max(), 0.1)

    def test_missing_array(self):
        self.expect("No point array named 'q'", self.cube(), lambda m, s: m.SelectScalarArray("q"))

    def test_missing_opacity_array(self):
        self.expect("No point or cell array named 'q'", self.cube(), lambda m, s: m.SetOpacityArrayName("q"))

    def test_missing_and_wrong_vectors(self):
        self.expect("three components named 'q'", self.cube(), lambda m, s: m.SetVectorArrayName("q"))
        self.expect("three components named 's'", self.cube(), lambda m, s: m.SetVectorArrayName("s"))

    def winds(self, vectors):
        data = self.cube()
        meshes.add_array(data.GetPointData(), np.broadcast_to(np.asarray(vectors, float), (27, 3)).copy(), "v")
        return data

    def test_missing_color_array_and_function(self):
        def configure(name):
            def call(mapper, scene):
                mapper.SetVectorArrayName("v")
                mapper.SetVectorColorArrayName(name)
            return call
        self.expect("No point array named 'q' for the colours", self.winds((1, 0, 0)), configure("q"))
        self.expect("SetVectorColorFunction", self.winds((1, 0, 0)), configure("s"))

    def test_vectors_that_are_zero_or_not_finite_are_not_drawn(self):
        for style in (0, 1):
            for placement in (0, 1):
                pictures = []
                for name, vectors in (("", (1, 0, 0)), ("v", (0, 0, 0)), ("v", (np.nan, 1, 0)), ("v", (np.inf, 0, 0))):
                    def configure(mapper, scene):
                        mapper.SetVectorArrayName(name)
                        mapper.SetVectorStyle(style)
                        mapper.SetVectorPlacement(placement)
                    messages, mapper = self.draw(self.winds(vectors), configure)
                    told = [] if np.isfinite(vectors).all() else ["The vectors of 27 points are not drawn because array 'v' is not finite there. Blank"]
                    self.assertEqual(len(messages.all), len(told), messages.all)
                    for text, expected in zip(messages.warnings, told):
                        self.assertIn(expected, text)
                    pictures.append(float_image(mapper))
                for picture in pictures[1:]:
                    np.testing.assert_allclose(picture, pictures[0], atol=1e-6)
                self.assertGreater(pictures[0][..., 3].max(), 0.01)

    def test_vectors_that_are_not_finite_are_counted(self):
        """Once, at points and cells; those of samples that are hidden do not count."""
        random = np.random.default_rng(5)
        for on_cells in (False, True):
            data = meshes.image((4, 3, 5))
            attributes = data.GetCellData() if on_cells else data.GetPointData()
            count = data.GetNumberOfCells() if on_cells else data.GetNumberOfPoints()
            vectors, hidden = random.random((count, 3)), random.random(count) < 0.4
            vectors[random.random(count) < 0.3, 1] = np.nan
            wrong = (np.isnan(vectors[:, 1]) & ~hidden).sum()
            meshes.add_array(attributes, random.random(count))
            meshes.add_array(attributes, vectors, "v")
            meshes.add_array(attributes, hidden * np.uint8(32 if on_cells else 2), "vtkGhostType")
            window = Window((20, 20))
            scene = window.add_scene()
            mapper = nephoscope.vtkTexturedSplatMapper()
            mapper.SetVectorArrayName("v")
            scene.add_volume(mapper, data, constant(), association="cell" if on_cells else "point")
            scene.look((3, 4, 9), (0.5, 0.5, 0.5))
            window.render()
            mapper.SetPhase(0.5)
            window.render()
            self.assertEqual(len(window.messages.all), 1, window.messages.all)
            self.assertIn(f"The vectors of {wrong} {'cell' if on_cells else 'point'}{'' if wrong == 1 else 's'} are not drawn because array 'v'", window.messages.warnings[0])

    def test_phases_without_vectors(self):
        def configure(mapper, scene):
            with scene.window.messages:
                mapper.AdvancePhases(1.0)
        self.expect("no vectors to move", self.cube(), configure)

    def test_input_that_is_no_dataset(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, self.cube())
        window = Window((32, 32))
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetInputDataObject(blocks)
        window.add_scene().add_volume(mapper, None, constant())
        window.render()
        self.assertEqual(len(window.messages.all), 1, window.messages.all)
        self.assertRegex(window.messages.all[0], "vtkMultiBlockDataSet.*vtkAppendFilter")

    def test_missing_and_wrong_sizes(self):
        data = meshes.particles(np.eye(3))
        meshes.add_array(data.GetPointData(), np.zeros(3))
        meshes.add_array(data.GetPointData(), np.zeros((3, 2)), "pair")
        meshes.add_array(data.GetPointData(), -np.ones(3), "negative")
        for name in ("q", "pair"):
            self.expect(f"No point array of one component named '{name}'", data, lambda m, s: m.SetCellSizeArrayName(name))
        self.expect("no visible points", data, lambda m, s: m.SetCellSizeArrayName("negative"))

    def test_unit_distance(self):
        def configure(mapper, scene):
            scene.renderer.GetVolumes().GetItemAsObject(0).GetProperty().SetScalarOpacityUnitDistance(0)
        self.expect("ScalarOpacityUnitDistance", self.cube(), configure)

    def test_samples_without_a_number_or_place_are_left_out(self):
        points = np.array([(0, 0, 0), (np.nan, 0, 0), (1, 0, 0), (0, 1, 0)])
        data = meshes.particles(points)
        meshes.add_array(data.GetPointData(), np.array([0, 0, np.nan, 0.5]))
        messages, mapper = self.draw(data, lambda m, s: m.SetCellSize(0.5))
        self.assertEqual(messages.errors, [])
        self.assertEqual(mapper.GetNumberOfDrawnSplats(), 2)
        self.assertTrue(np.isfinite(float_image(mapper)).all())
        self.assertEqual(len(messages.warnings), 1, messages.all)
        self.assertIn("2 points are not drawn because array 's' or a coordinate is not finite there. Blank", messages.warnings[0])

    def test_what_is_left_out_is_reported(self):
        """Once, with the number: by value, by the array of opacity and by size, at points and cells; hidden samples are not counted."""
        random = np.random.default_rng(3)
        for on_cells in (False, True):
            for trial in range(4):
                data = meshes.image((4, 3, 5))
                attributes, kind = (data.GetCellData(), "cell") if on_cells else (data.GetPointData(), "point")
                count = data.GetNumberOfCells() if on_cells else data.GetNumberOfPoints()
                value, dense = random.random(count), random.random(count)
                value[random.random(count) < 0.3] = np.nan
                dense[random.random(count) < 0.3] = np.inf
                hidden = random.random(count) < (0.4 if trial % 2 else 0)
                meshes.add_array(attributes, value)
                meshes.add_array(attributes, dense, "dense")
                meshes.add_array(attributes, hidden * np.uint8(32 if on_cells else 2), "vtkGhostType")
                wrong = ~np.isfinite(value + dense) & ~hidden
                window = Window((20, 20))
                scene = window.add_scene()
                mapper = nephoscope.vtkTexturedSplatMapper()
                mapper.SetOpacityArrayName("dense")
                scene.add_volume(mapper, data, constant(), association="cell" if on_cells else "point")
                scene.look((3, 4, 9), (0.5, 0.5, 0.5))
                window.render()
                mapper.SetRadiusFactor(1.5)
                window.render()
                self.assertEqual(len(window.messages.all), 1, window.messages.all)
                self.assertIn(f"{wrong.sum()} {kind}{' is' if wrong.sum() == 1 else 's are'} not drawn because array 's', 'dense' or", window.messages.warnings[0])

    def test_hierarchy_of_vectors_in_layers(self):
        data = self.cube()
        meshes.add_array(data.GetPointData(), np.ones((data.GetNumberOfPoints(), 3)), "wind")

        def layers(mapper, _):
            mapper.SetVectorArrayName("wind")
            mapper.SetVectorPlacementToLayers()
            mapper.SetErrorTolerance(1)

        messages, mapper = self.draw(data, layers)
        self.assertEqual(len(messages.all), 1, messages.all)
        self.assertIn("ErrorTolerance is ignored", messages.warnings[0])
        self.assertEqual(mapper.GetNumberOfDrawnSplats(), data.GetNumberOfPoints())

    def test_axis_of_layers_without_a_grid(self):
        for data, axis, told in ((meshes.particles(np.eye(3)), 1, 1), (meshes.particles(np.eye(3)), -1, 0), (self.cube(), 1, 0)):
            meshes.add_array(data.GetPointData(), np.ones(data.GetNumberOfPoints()))
            meshes.add_array(data.GetPointData(), np.ones((data.GetNumberOfPoints(), 3)), "wind")

            def layers(mapper, _):
                mapper.SetVectorArrayName("wind")
                mapper.SetVectorPlacementToLayers()
                mapper.SetLayerAxis(axis)

            messages, _ = self.draw(data, layers)
            self.assertEqual([m for m in messages.all if "is ignored: these samples are not on a structured grid" not in m], [])
            self.assertEqual(len(messages.all), told, messages.all)

    def test_one_point_and_one_layer(self):
        for data in (meshes.particles(np.zeros((1, 3))), meshes.image((3, 3, 0))):
            data = meshes.with_field(data, lambda p: 0 * p[:, 0])
            messages, mapper = self.draw(data)
            self.assertEqual(messages.all, [])
            self.assertGreater(float_image(mapper)[..., 3].max(), 0.01)

    def test_huge_coordinates(self):
        pictures = []
        for scale in (1, 1e7):
            window = Window((32, 32))
            scene = window.add_scene()
            mapper = nephoscope.vtkTexturedSplatMapper()
            data = meshes.with_field(meshes.image((2, 2, 2), (scale,) * 3, (-scale,) * 3), lambda p: 0 * p[:, 0])
            scene.add_volume(mapper, data, constant(1 / scale))
            scene.look((0, 0, 8 * scale), (0, 0, 0))
            window.render()
            pictures.append(float_image(mapper))
        self.assertGreater(pictures[0][..., 3].max(), 0.5)
        np.testing.assert_allclose(pictures[1], pictures[0], atol=1e-5)


if __name__ == "__main__":
    unittest.main()
