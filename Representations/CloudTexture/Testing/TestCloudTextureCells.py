# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Density of grids of all kinds, integrated along rays inside of a body: against closed forms, per pixel."""
import itertools
import os
import unittest

import numpy as np
from cloud_bodies import BodyTestCase, box, opacity, sphere, stay_in_box, wall
from nephoscope_testing import meshes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkHyperTreeGrid, vtkMultiBlockDataSet, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter

LOW, HIGH = (-1.0, -0.8, -0.6), (0.9, 0.7, 0.5)
GRADIENT = np.array((0.6, 0.5, 0.4))
EXACT = 0.5 / 255 + 1e-3  # colours are rounded to 8 bits
HAS_LISTS = "image_load_store" not in os.environ.get("MESA_EXTENSION_OVERRIDE", "")


def linear(places):
    return 2.5 + places @ GRADIENT


def spread(points):
    """From the unit cube to one about the bodies."""
    return (points - 0.5) * 3 + (0.02, 0.05, -0.03)


def curved(points):
    """Faces of hexahedra become curved, the whole stays the same cube."""
    bump = 0.06 * np.prod(np.sin(2 * np.pi * points), axis=1)[:, None]
    return spread(points + bump * (1, -1, 0.5))


def with_density(data, function=linear, on_cells=False):
    meshes.with_field(data, function, "cell" if on_cells else "point")
    (data.GetCellData() if on_cells else data.GetPointData()).GetArray("s").SetName("density")
    return data


def unstructured(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def blocks(*parts):
    result = vtkMultiBlockDataSet()
    for i, part in enumerate(parts):
        result.SetBlock(i, part)
    return result


def hide(data, cells, flag):
    ghosts = vtkUnsignedCharArray()
    ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
    ghosts.SetNumberOfTuples(data.GetNumberOfCells())
    ghosts.Fill(0)
    for cell in cells:
        ghosts.SetValue(cell, flag)
    data.GetCellData().AddArray(ghosts)
    return data


KINDS = {
    "tetra": lambda: meshes.Lattice(4).mesh("tetra", curved),
    "hexahedron": lambda: meshes.Lattice(4).mesh("hexahedron", spread),
    "voxel": lambda: meshes.Lattice((3, 4, 5)).mesh("voxel", spread),
    "wedge": lambda: meshes.Lattice(3).mesh("wedge", spread),
    "pyramid": lambda: meshes.Lattice(3).mesh("pyramid", spread),
    "mixed, warped": lambda: meshes.Lattice(4).mesh("mixed", curved),
    "one cell": lambda: meshes.Lattice(1).mesh("hexahedron", spread),
    "polyhedron": lambda: meshes.polyhedron(spread(np.array(meshes.HEXAHEDRON, float)), meshes.HEX_FACES),
    "structured": lambda: meshes.structured((5, 4, 3), curved),
    "rectilinear": lambda: meshes.rectilinear([np.array((-2, -0.4, 0.1, 1.5)), np.array((-1.5, 0, 2)), np.array((-1, -0.6, 0.5, 2))]),
    "blocks": lambda: blocks(meshes.structured(3, lambda p: spread(p) * (0.5, 1, 1) - (0.74, 0, 0)), None,
                             meshes.Lattice(2).mesh("wedge", lambda p: spread(p) * (0.5, 1, 1) + (0.76, 0, 0)), meshes.particles([(0, 0, 0)])),
}


class CellsTestCase(BodyTestCase):
    def cloud(self, volume, body=None, extinction=0.5, **look):
        window, scene, mapper, actor = self.bodies(body or box(LOW, HIGH), extinction=extinction, **look)
        mapper.SetDensityVolume(volume)
        mapper.SetDensityArrayName("density")
        return window, scene, mapper, actor

    def expected(self, scene, low=LOW, high=HIGH, stop=np.inf, density=linear, extinction=0.5, from_near_plane=False):
        origins, directions, near_plane = self.rays(scene)
        near, far = stay_in_box(origins, directions, low, high)
        near = near_plane if from_near_plane else near
        end = np.maximum(near, np.minimum(far, stop))
        return opacity(extinction * (end - near) * density(origins + (0.5 * (near + end))[:, None] * directions))


class Kinds(CellsTestCase):
    def test_linear(self):
        """Every kind of cell holds a linear density exactly."""
        for name, make in KINDS.items():
            volume = make()
            for part in ([volume.GetBlock(i) for i in range(4)] if name == "blocks" else [volume]):
                part and with_density(part)
            for parallel in (False, True):
                window, scene, _, _ = self.cloud(volume, parallel_scale=1.5 if parallel else None)
                with self.subTest(kind=name, parallel=parallel):
                    drawn = self.draw(window)
                    self.compare(drawn, self.expected(scene), allowed=EXACT, share=0.999)
                    self.assertLess(abs(drawn.ravel() - self.expected(scene)).mean(), 1.2e-3)

    def test_up_to_what_is_opaque(self):
        for z, peeling in itertools.product((-0.2, 0.3), (False, True)):
            window, scene, _, _ = self.cloud(with_density(KINDS["structured"]()))
            scene.renderer.SetUseDepthPeeling(peeling)
            scene.add_opaque(wall(z), (0, 0, 0))
            origins, directions, _ = self.rays(scene)
            with self.subTest(z=z, peeling=peeling):
                self.compare(self.draw(window), self.expected(scene, stop=(z - origins[:, 2]) / directions[:, 2]), allowed=EXACT, share=0.999)

    def test_as_an_image(self):
        """An image, and the same as cells, where density is linear in each voxel; 0 outside."""
        values = np.random.default_rng(3).uniform(0, 4, 7)
        image = meshes.image((4, 5, 6), (0.3, 0.25, 0.2), (-0.6, -0.6, -0.6))
        with_density(image, lambda p: np.interp(p[:, 2], np.linspace(-0.6, 0.6, 7), values))
        for parallel in (False, True):
            pictures = []
            for volume in (image, unstructured(image), blocks(image)):
                window, _, _, _ = self.cloud(volume, sphere(0.8), parallel_scale=1.5 if parallel else None)
                pictures.append(self.draw(window))
            for picture in pictures[1:]:
                self.assertLessEqual(np.abs(picture - pictures[0]).max(), 1.01 / 255)
            self.assertGreater(pictures[0].max(), 0.3)

    def test_as_stored_otherwise(self):
        """The order of points, cells and corners does not matter."""
        rng = np.random.default_rng(5)
        mesh = meshes.with_field(meshes.Lattice(3).mesh("tetra", curved), lambda p: 1 + np.sin(3 * p).prod(axis=1))
        pictures = []
        for volume in (mesh, meshes.renumbered(mesh, rng)):
            window, _, mapper, _ = self.cloud(volume)
            mapper.SetDensityArrayName("s")
            pictures.append(self.draw(window))
        self.assertGreater(pictures[0].max(), 0.2)
        self.assertLessEqual(np.abs(pictures[1] - pictures[0]).max(), 1.01 / 255)

    def test_as_a_grid_and_as_cells(self):
        """Random densities: hexahedra are divided in the same way."""
        values = np.random.default_rng(7).uniform(0, 4, 5 * 6 * 7)
        for warp in (spread, curved):
            grid = with_density(meshes.structured((4, 5, 6), warp), lambda p: values)
            pictures = []
            for volume in (grid, unstructured(grid), blocks(unstructured(grid))):
                window, _, _, _ = self.cloud(volume)
                pictures.append(self.draw(window))
            self.assertGreater(np.ptp(pictures[0]), 0.2)
            for picture in pictures[1:]:
                self.assertLessEqual(np.abs(picture - pictures[0]).max(), 1.01 / 255)

    def test_cell_arrays(self):
        """One density in each cell: a slab is as dense as it is; of an image as well."""
        layers = np.array((1.0, 0.0, 3.0, 0.5))
        for data in (meshes.Lattice((2, 2, 4)).mesh("hexahedron", lambda p: (p - 0.5) * 2), meshes.image((3, 2, 4), (0.7, 1, 0.5), (-1, -1, -1)),
                     meshes.structured((2, 3, 4), lambda p: (p - 0.5) * 2)):
            with_density(data, lambda p: layers[np.clip(np.floor((p[:, 2] + 1) * 2), 0, 3).astype(int)], on_cells=True)
            window, scene, _, _ = self.cloud(data)
            origins, directions, _ = self.rays(scene)
            optical = 0
            for k, density in enumerate(layers):
                near, far = stay_in_box(origins, directions, (LOW[0], LOW[1], max(LOW[2], k * 0.5 - 1)), (HIGH[0], HIGH[1], min(HIGH[2], k * 0.5 - 0.5)))
                optical = optical + 0.5 * density * (far - near)
            self.compare(self.draw(window), opacity(optical), allowed=EXACT, share=0.999)


class Places(CellsTestCase):
    """Rays in faces, through edges and vertices; eyes in cells and in clouds."""

    def test_special_positions(self):
        """The eye in planes and on lines of the grid, looking along them."""
        regular = {kind: with_density(make()) for kind, make in {
            "image": lambda: meshes.image((6, 6, 6), 3 * [0.5], 3 * [-1.5]),
            "hexahedron": lambda: meshes.Lattice(6).mesh("hexahedron", lambda p: (p - 0.5) * 3),
            "tetra": lambda: meshes.Lattice(6).mesh("tetra", lambda p: (p - 0.5) * 3),
            "structured": lambda: meshes.structured(6, lambda p: (p - 0.5) * 3),
            "rectilinear": lambda: meshes.rectilinear(3 * [np.linspace(-1.5, 1.5, 7)])}.items()}
        for kind, volume in regular.items():
            for position, parallel in itertools.product(((0, 0, 5), (0, 5, 0), (5, 0, 0), (3, 3, 0), (3, 3, 3)), (None, 1.5)):
                window, scene, _, _ = self.cloud(volume, size=(97, 97), position=position, up=(0, 0, 1) if position[2] == 0 else (0, 1, 0),
                                                 parallel_scale=parallel)
                with self.subTest(kind=kind, position=position, parallel=parallel):
                    self.compare(self.draw(window), self.expected(scene), allowed=EXACT, share=0.998)  # at edges of the body

    def test_eye_in_the_cloud(self):
        dense = lambda p: linear(p) + 2
        for position in ((0.2, 0.1, 1), (0, 0, 0.5), (0, 0, 0)):
            window, scene, _, _ = self.cloud(with_density(meshes.structured(4, lambda p: (p - 0.5) * 4.2), dense), box((-2, -2, -1), (2, 2, 2)), 0.2,
                                             position=position, focus=(0, 0, -5), near=0.3, far=8, angle=60)
            with self.subTest(position=position):
                self.compare(self.draw(window), self.expected(scene, (-2, -2, -1), (2, 2, 2), density=dense, extinction=0.2, from_near_plane=True), allowed=EXACT, share=0.999)

    def test_moved_far_away_and_turned(self):
        """As large as the Earth, far from the origin; the actor stretched and turned."""
        radius = 6.4e6
        shift = np.array((3, -2, 5)) * radius
        data = with_density(meshes.structured((6, 5, 4), lambda p: spread(p) * radius + shift), lambda p: linear((p - shift) / radius))
        look = {"position": tuple(shift + np.array((1.2, 0.9, 5)) * radius), "focus": tuple(shift), "near": 0.5 * radius, "far": 20 * radius}
        window, scene, _, _ = self.cloud(data, box(shift + np.array(LOW) * radius, shift + np.array(HIGH) * radius), 0.5 / radius, **look)
        expected = self.expected(scene, shift + np.array(LOW) * radius, shift + np.array(HIGH) * radius, extinction=0.5 / radius,
                                 density=lambda p: linear((p - shift) / radius))
        self.compare(self.draw(window), expected, allowed=EXACT, share=0.99)
        window, scene, _, actor = self.cloud(with_density(KINDS["mixed, warped"]()))
        turn = vtkTransform()
        turn.Scale(1, 1, 2)
        actor.SetUserTransform(turn)
        stretched = lambda p: linear(p / (1, 1, 2))
        self.compare(self.draw(window), self.expected(scene, np.array(LOW) * (1, 1, 2), np.array(HIGH) * (1, 1, 2), density=stretched), allowed=EXACT,
                     share=0.999)

    def test_holes_and_poles(self):
        """Hidden and ghost cells are holes; a shell that closes at its poles and its seam has none."""
        half = lambda data, flag: hide(data, [i for i in range(data.GetNumberOfCells()) if data.GetCell(i).GetBounds()[1] <= 0.01], flag)
        for data, flag in itertools.product((meshes.Lattice(4).mesh("hexahedron", lambda p: (p - 0.5) * 3), meshes.image((4, 4, 4), 3 * [0.75], 3 * [-1.5])),
                                            (vtkDataSetAttributes.HIDDENCELL, vtkDataSetAttributes.DUPLICATECELL)):
            window, scene, _, _ = self.cloud(half(with_density(data), flag))
            self.compare(self.draw(window), self.expected(scene, (0, *LOW[1:]), HIGH), allowed=EXACT, share=0.999)

        def globe(p):
            longitude, latitude, radius = 2 * np.pi * p[:, 0], np.pi * (p[:, 1] - 0.5), 0.5 + p[:, 2]
            return radius[:, None] * np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], -1)

        grid = with_density(meshes.structured((48, 24, 4), globe), lambda p: 1 + 0 * p[:, 0])
        for position in ((0, 0, 5), (0, -5, 0), (1, 2, 4)):
            window, scene, _, _ = self.cloud(grid, sphere(0.9), position=position, up=(1, 0, 0))
            origins, directions, _ = self.rays(scene)
            along = np.einsum("ij,ij->i", origins, directions)
            away = np.einsum("ij,ij->i", origins, origins) - along**2
            chord = lambda r: 2 * np.sqrt(np.maximum(0, r * r - away))
            self.compare(self.draw(window), opacity(0.5 * (chord(0.9) - chord(0.5))), allowed=4 / 255, share=0.99)  # facets


def fan(points):
    """Wedges of a cylinder, all of which meet in the x axis."""
    angle, radius = 2 * np.pi * points[:, 0], 2.5 * points[:, 1]
    return np.stack([4 * points[:, 2] - 2, radius * np.cos(angle), radius * np.sin(angle)], -1)


class ManyCells(CellsTestCase):
    """Mesa's software OpenGL ends all loops of a shader after 65,535 iterations: rays lost what came after them."""

    def in_fan(self, wedges):
        volume = with_density(meshes.structured((wedges, 3, 3), fan), lambda p: 1 + 0 * p[:, 0])
        window, scene, _, _ = self.cloud(volume, size=(24, 24))
        return window, self.expected(scene, density=lambda p: 1)

    def test_whole_rays(self):
        """As about the poles of a globe with fine cells, where rays cross thousands."""
        for wedges in (800, 2000) if HAS_LISTS else (800,):
            window, expected = self.in_fan(wedges)
            with self.subTest(wedges=wedges):
                self.compare(self.draw(window), expected, allowed=EXACT, share=0.998)

    @unittest.skipUnless(HAS_LISTS, "the surface's own shader walks, and cannot tell")
    def test_too_many(self):
        window, expected = self.in_fan(4000)
        window.render()
        window.render()
        said = window.messages.all
        self.assertLessEqual(len(said), 1)
        self.compare(window.rgba()[..., 0], expected, allowed=EXACT, share=0.8 if said else 0.998)  # OpenGL of a GPU has no such limit
        self.assertTrue(all("Some rays cross more small cells" in words for words in said), said)


class Messages(CellsTestCase):
    def said(self, window):
        before = len(window.messages.all)
        window.render()
        window.render()
        return window.messages.all[before:]

    def test_not_finite(self):
        """Cells with a value that is not finite are left out, with one message."""
        data = with_density(meshes.Lattice(4).mesh("hexahedron", lambda p: (p - 0.5) * 3))
        places = meshes.points_of(data)
        vtk_to_numpy(data.GetPointData().GetArray("density"))[places[:, 0] < -0.01] = np.nan
        window, scene, _, _ = self.cloud(data)
        said = self.said(window)
        self.assertEqual(len(said), 1, said)
        self.assertIn("32 cells", said[0])
        self.compare(window.rgba()[..., 0], self.expected(scene, (0, *LOW[1:]), HIGH), allowed=EXACT, share=0.999)

    def test_bad_input(self):
        lattice = lambda: meshes.Lattice(2).mesh("hexahedron", spread)
        negative = with_density(lattice(), lambda p: p[:, 0] - 0.02)
        vectors = lattice()
        meshes.add_array(vectors.GetPointData(), np.ones((27, 3)), "density")
        flat = meshes.surface(spread(np.array(meshes.HEXAHEDRON, float)), meshes.HEX_FACES)
        for bad, words in ((lattice(), "no point array 'density' of the density, and no such cell array"), (vtkUnstructuredGrid(), "has no cells"),
                           (vtkMultiBlockDataSet(), "has no cells"), (negative, "9 values that are not a density"), (vectors, "density has 3"),
                           (with_density(flat), "no three-dimensional cells"), (vtkTable(), "vtkTable"), (vtkHyperTreeGrid(), "unstructured grid"),
                           (blocks(with_density(lattice()), lattice()), "incomplete")):
            window, _, _, _ = self.cloud(bad)
            said = self.said(window)
            with self.subTest(words=words):
                self.assertEqual(len(said), 1, said)
                self.assertIn(words, said[0])
                self.assertEqual(window.gl_errors(), [])

    def test_changes(self):
        """Values and points that change, nothing but zeros, and back to none; blocks that change."""
        data = with_density(meshes.Lattice(2).mesh("hexahedron", spread), lambda p: 1 + 0 * p[:, 0])
        for volume in (data, blocks(data)):
            window, scene, mapper, _ = self.cloud(volume)
            plain = self.draw(window)
            self.compare(plain, self.expected(scene, density=lambda p: 1), allowed=EXACT, share=0.998)
            values = data.GetPointData().GetArray("density")
            for value in (0, 2, 1):
                values.Fill(value)
                values.Modified()
                data.Modified()
                drawn = self.draw(window)
                self.assertEqual(drawn.max() > 0, value > 0)
            np.testing.assert_array_equal(drawn, plain)
            mapper.SetDensityVolume(None)
            mapper.SetDensityArrayName(None)
            self.assertGreater(self.draw(window).max(), plain.max() - 0.01)
            self.assertEqual(window.gl_errors(), [])
            self.assertEqual(window.messages.all, [])


if __name__ == "__main__":
    unittest.main()
