# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Input that is empty, incomplete or broken: no crash, a message that names the culprit, a finite picture."""
import time
import unittest

import numpy as np
from nephoscope_testing import meshes, reference
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.messages import Messages
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant, random_transfer
from vtkmodules.vtkCommonDataModel import (VTK_QUADRATIC_TETRA, VTK_TRIANGLE, vtkHyperTreeGrid, vtkImageData, vtkMultiBlockDataSet, vtkPiecewiseFunction,
                                           vtkPolyData, vtkUniformGrid, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty

CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0))
BOUNDS = (0, 1, 0, 1, 0, 1)


def corner(values=(0, 0.3, 0.6, 1)):
    data = meshes.tetrahedra(CORNERS, [(0, 1, 2, 3)])
    meshes.add_array(data.GetPointData(), np.array(values, float))
    return data


class BadInputCase(ImageTestCase):
    def draw(self, data, transfer=None, array="s", association="point", frames=2):
        window = Window((48, 48))
        scene = window.add_scene()
        ours = mapper()
        scene.add_volume(ours, data, transfer or constant(2.0), array=array, association=association)
        scene.look_at(BOUNDS)
        for _ in range(frames):
            window.render()
        picture = scene.rgb()
        self.assertEqual(window.gl_errors(), [])
        return window.messages, picture, scene, ours

    def complaint(self, label, messages, *words):
        """Some message has all the words (any of those in a tuple), without regard to case."""
        print(f"  {label}: {[m.strip().splitlines()[-1] for m in messages.all][:2]}")
        self.assertTrue(messages.all, f"{label}: nothing was reported")
        for text in messages.all:
            low = text.lower()
            if all(any(w.lower() in low for w in ((word,) if isinstance(word, str) else word)) for word in words):
                return
        self.fail(f"{label}: no message names {words}: {messages.all}")

    def nothing_drawn(self, picture, label):
        self.assertEqual(picture.max(), 0, f"{label}: something was drawn")


class Missing(BadInputCase):
    def test_no_input(self):
        messages, picture, *_ = self.draw(None)
        self.nothing_drawn(picture, "no input")
        self.complaint("no input", messages, "input")

    def test_empty(self):
        for data in (vtkUnstructuredGrid(), vtkImageData(), meshes.grid(np.zeros((0, 3)), [])):
            messages, picture, *_ = self.draw(data)
            self.nothing_drawn(picture, "empty")
            self.complaint(f"empty {data.GetClassName()}", messages, ("empty", "no cells", "no 3-d cells", "no point", "nothing"))

    def test_points_without_cells(self):
        data = meshes.with_field(meshes.grid(CORNERS, []), lambda p: p[:, 0])
        messages, picture, *_ = self.draw(data)
        self.nothing_drawn(picture, "points without cells")
        self.complaint("points without cells", messages, "cell")

    def test_too_long(self):
        data = meshes.with_field(meshes.image((4, 4, 4), (1e17,) * 3), lambda p: 1e-17 * p[:, 0])
        messages, picture, *_ = self.draw(data)
        self.nothing_drawn(picture, "4e17 long")
        self.complaint("4e17 long", messages, "single precision")

    def test_no_scalars(self):
        data = meshes.tetrahedra(CORNERS, [(0, 1, 2, 3)])
        window = Window((48, 48))
        scene = window.add_scene()
        ours = mapper()
        ours.SetInputData(data)
        volume = vtkVolume()
        volume.SetMapper(ours)
        volume.SetProperty(constant().volume_property())
        scene.renderer.AddVolume(volume)
        scene.look_at(BOUNDS)
        window.render()
        self.nothing_drawn(scene.rgb(), "no scalars")
        self.complaint("no scalars", window.messages, ("scalar", "array"))

    def test_input_that_is_no_dataset(self):
        blocks, tree = vtkMultiBlockDataSet(), vtkHyperTreeGrid()
        blocks.SetBlock(0, corner())
        for data, remedy in ((blocks, "vtkAppendFilter"), (tree, "vtkHyperTreeGridToUnstructuredGrid")):
            window = Window((32, 32))
            scene = window.add_scene()
            ours = mapper()
            ours.SetInputDataObject(data)
            scene.add_volume(ours, None, constant())
            window.render()
            self.complaint(type(data).__name__, window.messages, (type(data).__name__,), (remedy,))
            self.assertEqual(len(window.messages.all), 1, window.messages.all)

    def test_array_that_is_not_there(self):
        for association in ("point", "cell"):
            messages, picture, *_ = self.draw(corner(), array="Cloud_Water", association=association)
            self.nothing_drawn(picture, "missing array")
            self.complaint(f"missing {association} array", messages, "Cloud_Water")

    def test_array_on_the_other_association(self):
        messages, picture, *_ = self.draw(corner(), association="cell")
        self.nothing_drawn(picture, "wrong association")
        self.complaint("point array asked for as cell array", messages, "s", ("cell", "point"))

    def test_only_flat_cells(self):
        data = meshes.with_field(meshes.grid(CORNERS, [(VTK_TRIANGLE, (0, 1, 2))]), lambda p: p[:, 0])
        messages, picture, *_ = self.draw(data)
        self.nothing_drawn(picture, "flat cells")
        self.complaint("only triangles", messages, ("3-d", "3d", "three-dimensional"))
        sphere = vtkSphereSource()
        sphere.Update()
        surface = vtkPolyData()
        surface.ShallowCopy(sphere.GetOutput())
        meshes.with_field(surface, lambda p: p[:, 0])
        messages, picture, *_ = self.draw(surface)
        self.nothing_drawn(picture, "surface")
        self.complaint("a surface", messages, ("3-d", "3d", "three-dimensional"))
        flat = meshes.with_field(meshes.image((4, 4, 0)), lambda p: p[:, 0])
        messages, picture, *_ = self.draw(flat)
        self.nothing_drawn(picture, "flat image")
        self.complaint("an image of one layer", messages, ("3-d", "3d", "three-dimensional"))


class Broken(BadInputCase):
    def test_nan_and_infinite_scalars(self):
        for bad in (np.nan, np.inf, -np.inf):
            data = meshes.with_field(meshes.Lattice(2).mesh("tetra"), lambda p: p[:, 2])
            values = meshes.points_of(data)[:, 2].copy()
            values[0] = bad
            meshes.add_array(data.GetPointData(), values)
            messages, picture, scene, ours = self.draw(data)
            self.assertTrue(np.isfinite(float_image(ours)).all(), f"{bad} in the float image")
            self.assertGreater(picture.max(), 0.3, "the other cells are drawn")
            self.complaint(f"scalar {bad}", messages, "s", ("nan", "finite"))

    def test_nan_coordinates(self):
        data = meshes.with_field(meshes.Lattice(2).mesh("tetra"), lambda p: p[:, 2])
        points = meshes.points_of(data)
        points[0] = np.nan
        data.SetPoints(meshes.vtk_points(points))
        messages, picture, scene, ours = self.draw(data)
        self.assertTrue(np.isfinite(float_image(ours)).all())
        self.assertGreater(picture.max(), 0.3, "the other cells are drawn")
        self.complaint("coordinate nan", messages, ("nan", "finite"))

    def test_cells_without_volume(self):
        """A flat tetrahedron, one with a repeated point, one with all points equal: as if they were not there."""
        rng = np.random.default_rng(1)
        base = meshes.delaunay(rng, 12)
        points = list(map(tuple, (meshes.points_of(base) + 1) / 2))
        cells = [[base.GetCell(i).GetPointId(k) for k in range(4)] for i in range(base.GetNumberOfCells())]
        n = len(points)
        points += [(0.5, 0.5, 0.5), (0.7, 0.5, 0.5), (0.5, 0.7, 0.5), (0.7, 0.7, 0.5)]
        flat = [(n, n + 1, n + 2, n + 3), (n, n, n + 1, n + 2), (n, n, n, n)]
        pictures = []
        for extra in ([], flat):
            data = meshes.with_field(meshes.tetrahedra(points, cells + extra), lambda p: np.clip(p[:, 2], 0, 1))
            messages, _, _, ours = self.draw(data, random_transfer(np.random.default_rng(2), 4))
            self.assertEqual(messages.errors, [])
            pictures.append(float_image(ours))
        self.assertLessEqual(np.abs(pictures[1] - pictures[0]).max(), 1e-6)

    def test_inverted_cells(self):
        rng = np.random.default_rng(3)
        transfer = random_transfer(rng, 4)
        for kind in ("tetra", "hexahedron", "wedge", "pyramid"):
            data = meshes.Lattice(2).mesh(kind, meshes.projective(np.random.default_rng(4), 0.1))
            meshes.with_field(data, meshes.linear_field(rng, data))
            turned = meshes.grid(meshes.points_of(data), [])
            for i in range(data.GetNumberOfCells()):
                ids = [data.GetCell(i).GetPointId(k) for k in range(data.GetCell(i).GetNumberOfPoints())]
                if i % 2 == 0:
                    ids = TURNED[kind](ids)
                turned.InsertNextCell(data.GetCellType(i), len(ids), ids)
            turned.GetPointData().AddArray(data.GetPointData().GetArray("s"))
            self.check(turned, transfer, f"every second {kind} inverted", size=(64, 64))

    def test_one_cell_of_constant_scalar(self):
        for value in (0.0, 0.5, 7.0):
            self.check(corner((value,) * 4), Transfer([(0, 1, 0, 0), (1, 0, 1, 0)], [(0, 1), (1, 2)]), f"all scalars {value}")

    def test_quadratic_cells(self):
        """Straight edges and a linear field: drawn as the linear cell would be, or refused by name."""
        middles = [np.mean([CORNERS[a], CORNERS[b]], axis=0) for a, b in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]
        data = meshes.grid(np.vstack([CORNERS, middles]), [(VTK_QUADRATIC_TETRA, range(10))])
        meshes.with_field(data, lambda p: p[:, 2])
        messages, picture, scene, ours = self.draw(data)
        if picture.max() == 0:
            self.complaint("quadratic tetrahedron", messages, "quadratic")
            return
        linear = cells_of(meshes.with_field(meshes.tetrahedra(CORNERS, [(0, 1, 2, 3)]), lambda p: p[:, 2]))
        expected = reference.render(linear, scene.view(), constant(2.0))
        # The edges along which it may be divided: those of the eight tetrahedra between corners and middles.
        nodes = np.vstack([CORNERS, middles])
        edges = np.array([(a, b) for i, a in enumerate(nodes) for b in nodes[:i]])
        self.check_float(float_image(ours), expected, "quadratic as linear", mask=edge_mask(edges, scene.view()))

    def test_vector_arrays(self):
        """An array of several components: one of them by choice of VectorComponent or the magnitude; not garbage."""
        data = corner()
        values = np.column_stack([np.zeros(4), [0, 0.3, 0.6, 1], np.zeros(4)])
        meshes.add_array(data.GetPointData(), values, "wind")
        messages, picture, scene, ours = self.draw(data, Transfer([(0, 1, 0, 0), (1, 0, 1, 0)], [(0, 1), (1, 2)]), array="wind")
        self.assertTrue(np.isfinite(float_image(ours)).all())
        if picture.max() == 0:
            self.complaint("vectors", messages, "wind", "component")


TURNED = {
    "tetra": lambda i: [i[1], i[0], i[2], i[3]],
    "hexahedron": lambda i: i[4:] + i[:4],
    "wedge": lambda i: i[3:] + i[:3],
    "pyramid": lambda i: i[3::-1] + [i[4]],
}


class Ghosts(BadInputCase):
    def ghosted(self, points=None, cells=None):
        data = meshes.with_field(meshes.Lattice(3).mesh("hexahedron"), lambda p: p[:, 2])
        for attributes, marks, count in ((data.GetPointData(), points, 64), (data.GetCellData(), cells, 27)):
            if marks:
                flags = np.zeros(count, np.uint8)
                for index, flag in marks.items():
                    flags[index] = flag
                meshes.add_array(attributes, flags, "vtkGhostType")
        return data

    def test_duplicate_refined_and_hidden_cells(self):
        data = self.ghosted(cells={0: 1, 13: 8, 26: 32, 5: 33})
        drawn = self.check(data, constant(2.0), "ghost cells")
        self.assertEqual(drawn[0].GetNumberOfTetrahedra() % 23, 0, "23 of 27 cells, divided alike")
        self.check(self.ghosted(), constant(2.0), "without ghosts")

    def test_nothing_left_to_draw(self):
        hidden = meshes.with_field(self.ghosted(cells={i: 32 for i in range(27)}), lambda p: p[:, 0])
        flat = meshes.with_field(meshes.tetrahedra(np.array(CORNERS) * (1, 1, 0), [(0, 1, 2, 3)]), lambda p: p[:, 0])
        for data in (hidden, flat):
            window = Window()
            scene = window.add_scene()
            scene.look_at(scene.add_volume(mapper(), data, constant(2.0)))
            window.render()
            self.assertEqual(len(window.messages.all), 1)
            self.assertRegex(window.messages.all[0], "27 cells, all are hidden|the only cell is hidden or has no volume")

    def test_cells_of_hidden_points(self):
        data = self.ghosted(points={0: 2, 63: 2, 21: 2})
        hidden = {i for i in range(27) if {0, 63, 21} & {data.GetCell(i).GetPointId(k) for k in range(8)}}
        window = Window()
        scene = window.add_scene()
        ours = mapper()
        scene.look_at(scene.add_volume(ours, data, constant(2.0)))
        window.render()
        cells = cells_of(self.ghosted(cells={i: 32 for i in hidden}))
        expected = reference.render(cells, scene.view(), constant(2.0))
        self.check_float(float_image(ours), expected, "hidden points", mask=edge_mask(cells.drawn_edges(), scene.view()))

    def test_duplicate_points_are_drawn(self):
        """A point of another process is still a corner of this one's cells."""
        self.check(self.ghosted(points={0: 1, 21: 1}), constant(2.0), "duplicate points")

    def test_blanked_image(self):
        data = vtkUniformGrid()
        data.SetDimensions(4, 4, 4)
        meshes.with_field(data, lambda p: p[:, 2] / 3)
        data.BlankCell(13)
        data.BlankCell(0)
        self.check(data, constant(1.0), "image with blanked cells")

    def test_everything_hidden(self):
        data = self.ghosted(cells={i: 32 for i in range(27)})
        messages, picture, *_ = self.draw(data)
        self.nothing_drawn(picture, "everything hidden")


class TransferFunctions(BadInputCase):
    def test_property_without_functions(self):
        """VTK gives a property default functions; whatever they are, the picture is finite."""
        for prop in (vtkVolumeProperty(), self.property_of(vtkColorTransferFunction(), vtkPiecewiseFunction())):
            messages, picture, scene, ours = self.draw(corner(), prop)
            self.assertTrue(np.isfinite(picture).all())

    def test_empty_functions_are_named(self):
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 1)
        color = vtkColorTransferFunction()
        color.AddRGBPoint(0, 1, 1, 1)
        messages, picture, *_ = self.draw(corner(), self.property_of(color, vtkPiecewiseFunction()))
        self.nothing_drawn(picture, "no opacity point")
        self.complaint("empty opacity function", messages, "opacity")
        messages, *_ = self.draw(corner(), self.property_of(vtkColorTransferFunction(), opacity))
        self.complaint("empty colour function", messages, ("color", "colour"))

    def test_path_search_colours_do_not_stall(self):
        """VTK needs tens of milliseconds for one colour of the CIEDE2000 space: it must be asked for few."""
        color = vtkColorTransferFunction()
        color.SetColorSpaceToLabCIEDE2000()
        color.AddRGBPoint(0, 0.1, 0.2, 0.7)
        color.AddRGBPoint(1, 0.9, 0.3, 0.1)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 1)
        start = time.process_time()
        messages, picture, *_ = self.draw(corner(), self.property_of(color, opacity))
        self.assertLess(time.process_time() - start, 20)
        self.assertGreater(picture.max(), 0)

    def property_of(self, color, opacity):
        prop = vtkVolumeProperty()
        prop.SetColor(color)
        prop.SetScalarOpacity(opacity)
        return prop

    def test_unit_distance_of_zero(self):
        for distance in (0.0, -1.0):
            transfer = constant(1.0)
            transfer.unit_distance = distance
            messages, picture, scene, ours = self.draw(corner(), transfer)
            self.complaint(f"unit distance {distance}", messages, ("unit distance", "UnitDistance"))

    def test_nan_in_the_opacity_function(self):
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 1)
        opacity.AddPoint(1, float("nan"))
        color = vtkColorTransferFunction()
        color.AddRGBPoint(0, 1, 1, 1)
        messages, picture, scene, ours = self.draw(corner(), self.property_of(color, opacity))
        self.assertTrue(np.isfinite(picture).all())

    def test_float_image_before_any_render(self):
        image = vtkImageData()
        with Messages() as messages:
            self.assertFalse(mapper().CopyFloatImage(image))
            self.assertFalse(mapper().CopyFloatImage(None))
        self.complaint("no render yet", messages, "render")

    def test_recovery(self):
        """After a bad input the same mapper draws a good one, and is silent."""
        window = Window((64, 64))
        scene = window.add_scene()
        ours = mapper()
        scene.add_volume(ours, corner(), constant(2.0), array="absent")
        scene.look_at(BOUNDS)
        window.render()
        self.assertTrue(window.messages.all)
        window.messages.clear()
        ours.SelectScalarArray("s")
        window.render()
        self.verify(scene, ours, cells_of(corner()), constant(2.0), "after a missing array")


if __name__ == "__main__":
    unittest.main(verbosity=2)
