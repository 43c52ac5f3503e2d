# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a surface cannot be textured with is told, once, with a remedy; every way to draw a surface works."""
import itertools
import unittest

import numpy as np
from cloud_sheets import TextureTestCase, sheet
from nephoscope_testing import meshes
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

CORNERS = ((0, 0, 0), (2, 2, 1))
ONE_SET = [((0, 0, 0), 1.0)]


class BadInput(TextureTestCase):
    def messages(self, data, configure=lambda mapper: None):
        self.window, mapper, _ = self.scene(data, (64, 64))
        configure(mapper)
        for _ in range(2):  # told once
            self.window.render()
        self.assertEqual(self.window.gl_errors(), [])
        return self.window.messages, self.window.rgba()[..., 0].max()

    def expect(self, text, data, configure=lambda mapper: None, drawn=False):
        messages, brightest = self.messages(data, configure)
        self.assertEqual(len(messages.all), 1, messages.all)
        self.assertIn(text, messages.all[0])
        self.assertEqual(brightest > 0, drawn)

    def test_missing_cover(self):
        self.expect('no point array "q"', sheet(CORNERS, ONE_SET), lambda m: m.SetCoverageArrayName("q"))

    def test_cover_with_components(self):
        data = sheet(CORNERS, ONE_SET)
        self.expect("number of components than 1", data, lambda m: m.SetCoverageArrayName("TextureCoordinates1"))

    def test_cover_of_cells(self):
        data = sheet(CORNERS, ONE_SET)
        meshes.add_array(data.GetCellData(), np.full(data.GetNumberOfCells(), 0.5), "cover")
        self.expect("convert cell data to point data", data, lambda m: m.SetCoverageArrayName("cover"))

    def test_percent_and_nan(self):
        for bad in (50.0, -0.5, np.nan):
            data = sheet(CORNERS, ONE_SET)
            values = np.full(data.GetNumberOfPoints(), 0.5)
            values[5] = bad
            meshes.add_array(data.GetPointData(), values, "cover")
            self.expect("Divide percent by 100", data, lambda m: m.SetCoverageArrayName("cover"), drawn=True)

    def test_coordinates_with_nan(self):
        self.expect('"TextureCoordinates1" are not used', sheet(CORNERS, [((np.nan, 0, 0), 1.0)]), drawn=True)

    def test_negative_weights(self):
        self.expect("TextureWeights must be", sheet(CORNERS, 2 * ONE_SET, weights=(-1, 2)), drawn=True)

    def test_weights_of_points(self):
        for bad, text in (((-1.0, 1.0), "TextureWeights of points must be"), ((0.0, 0.0), "TextureWeights of points must be"),
                          ((np.nan, 1.0), "TextureWeights of points must be"), ((1.0,), "needs 2 components")):
            data = sheet(CORNERS, 2 * ONE_SET, weights=(0.5, 0.5))
            weights = np.full((data.GetNumberOfPoints(), len(bad)), 0.5)
            weights[7] = bad
            meshes.add_array(data.GetPointData(), weights, "TextureWeights")
            self.expect(text, data, drawn=True)

    def test_density(self):
        def with_density(mapper):
            mapper.UseThicknessOn()
            mapper.SetDensityArrayName("density")

        self.expect('no point array "density" for the density. Choose an existing one, or convert cell data to point data. If it is the array of a density volume, choose this volume too', sheet(CORNERS, ONE_SET), with_density)
        for bad in (-0.5, np.nan, np.inf):
            data = sheet(CORNERS, ONE_SET)
            values = np.full(data.GetNumberOfPoints(), 0.5)
            values[5] = bad
            meshes.add_array(data.GetPointData(), values, "density")
            self.expect("not a density", data, with_density, drawn=True)

    def test_nothing_to_draw(self):
        for data in (vtkPolyData(), meshes.particles(np.zeros((0, 3))), meshes.surface(np.zeros((3, 3)), [(0, 1, 2)])):
            messages, brightest = self.messages(data)
            self.assertEqual((messages.all, brightest), ([], 0))

    def test_no_polygons(self):
        """Vertices or lines alone, by themselves and as blocks."""
        corners = np.array(((0, 0, 0), (1, 0, 0), (1, 1, 0.5), (0, 1, 0)), float)
        points, lines = meshes.particles(corners), meshes.particles(corners)
        points.SetVerts(meshes.surface(corners, [(i,) for i in range(4)]).GetPolys())
        lines.SetLines(meshes.surface(corners, [(0, 1), (2, 3)]).GetPolys())
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, points)
        for data in (points, lines, blocks):
            self.expect("4 points but no polygons", data)
        mixed = sheet(CORNERS, ONE_SET)
        mixed.SetVerts(points.GetVerts())
        self.assertEqual(self.messages(mixed)[0].all, [])

    def test_no_input(self):
        window, mapper, _ = self.scene(sheet(CORNERS, ONE_SET), (32, 32))
        mapper.RemoveAllInputs()
        window.render()
        self.assertEqual(window.rgba()[..., 0].max(), 0)

    def test_a_remedy_helps(self):
        window, mapper, _ = self.scene(sheet(CORNERS, ONE_SET), (64, 64))
        mapper.SetCoverageArrayName("q")
        window.render()
        mapper.SetCoverageArrayName(None)
        window.render()
        self.assertGreater(window.rgba()[..., 0].max(), 0.5)


class WaysToDraw(TextureTestCase):
    def test_edges_lines_points_lights_and_colours(self):
        def colours(mapper, actor):
            mapper.ScalarVisibilityOn()
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray("TextureCoordinates1")

        ways = {
            "lights": lambda m, a: a.GetProperty().LightingOn(),
            "flat": lambda m, a: (a.GetProperty().LightingOn(), a.GetProperty().SetInterpolationToFlat()),
            "edges": lambda m, a: a.GetProperty().EdgeVisibilityOn(),
            "wide lines": lambda m, a: (a.GetProperty().SetRepresentationToWireframe(), a.GetProperty().SetLineWidth(4)),
            "points": lambda m, a: (a.GetProperty().SetRepresentationToPoints(), a.GetProperty().SetPointSize(4)),
            "colours": colours,
        }
        for peeling, thickness in itertools.product(*2 * [(False, True)]):
            for name, way in ways.items():
                with self.subTest(name, peeling=peeling, thickness=thickness):
                    window, mapper, scene = self.scene(sheet(CORNERS, 2 * ONE_SET, with_normals=name == "lights"), (64, 64))
                    scene.renderer.SetUseDepthPeeling(peeling)
                    mapper.SetUseThickness(thickness)
                    way(mapper, scene.renderer.GetActors().GetLastActor())
                    self.assertGreater(self.draw(window).max(), 0.1)

    def test_a_second_window(self):
        first, mapper, scene = self.scene(sheet(CORNERS, ONE_SET), (64, 64))
        picture = self.draw(first)
        actor = scene.renderer.GetActors().GetLastActor()
        scene.renderer.RemoveActor(actor)
        first.window.Finalize()
        other, _, scene = self.scene(sheet(CORNERS, ONE_SET), (64, 64))
        scene.renderer.RemoveAllViewProps()
        scene.renderer.AddActor(actor)
        np.testing.assert_array_equal(self.draw(other), picture)


if __name__ == "__main__":
    unittest.main()
