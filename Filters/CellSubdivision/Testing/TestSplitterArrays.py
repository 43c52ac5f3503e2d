# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point and cell arrays of every type, the scalar on the cuts, ids, ghosts, hidden cells."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.meshes import Lattice
from split_checks import Cells, split
from split_meshes import centred, refined, wavy, with_sources
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkBitArray, vtkIdTypeArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkDataSetAttributes as DSA


def block(kind="hexahedron", field=wavy):
    return meshes.with_field(with_sources(Lattice(3).mesh(kind, centred)), field)


def ids(count, name):
    array = vtkIdTypeArray()
    array.SetName(name)
    for i in range(count):
        array.InsertNextValue(1000 + i)
    return array


class Points(unittest.TestCase):
    def test_linear_fields_are_carried_exactly(self):
        matrix = np.array([[1.5, -2, 0.25], [0.5, 3, -1], [2, 1, 7]])
        for data in (block(), block("tetra"), meshes.with_field(refined(), wavy)):
            points = meshes.points_of(data)
            for dtype in ("f8", "f4"):
                meshes.add_array(data.GetPointData(), (points @ matrix + 3).astype(dtype), dtype)
            out = Cells(split(data, [0.2, 0.5]))
            expected = out.points @ matrix + 3
            self.assertGreater(len(out.points), len(points))
            np.testing.assert_allclose(out.array("f8", points=True), expected, rtol=0, atol=1e-14)
            np.testing.assert_allclose(out.array("f4", points=True), expected, rtol=0, atol=3e-6)
            self.assertEqual(out.array("f4", points=True).dtype, np.float32)

    def test_whole_numbers_are_rounded_to_the_nearest(self):
        data = block(field=lambda p: p[:, 0])
        meshes.add_array(data.GetPointData(), np.round(300 * meshes.points_of(data)).astype("i4"), "i")
        out = Cells(split(data, [0.1]))
        self.assertEqual(out.array("i", points=True).dtype, np.int32)
        new = out.points[data.GetNumberOfPoints():]
        np.testing.assert_allclose(out.array("i", points=True)[data.GetNumberOfPoints():], 300 * new, atol=0.5001)

    def test_the_scalar_on_the_cut_is_the_value(self):
        data = block()
        points = meshes.points_of(data)
        meshes.add_array(data.GetPointData(), wavy(points).astype("f4"), "float")
        meshes.add_array(data.GetPointData(), np.round(10 * wavy(points)).astype("i2"), "int")
        for array, values, dtype in (("s", [0.1, 1 / 3], "f8"), ("float", [0.1, 1 / 3], "f4"), ("int", [0.5, 2.25], "f8")):
            out = Cells(split(data, values, array))
            s = out.array(array, points=True)
            self.assertEqual(s.dtype, np.dtype(dtype))
            self.assertEqual(set(s[len(points):]), set(np.array(values, dtype)))
            on_surface = np.unique(np.concatenate([out.ids[i] for i in np.flatnonzero(~out.solid)]))
            self.assertTrue(np.isin(s[on_surface], np.array(values, dtype)).all())

    def test_text_bits_and_ids(self):
        data = block(field=lambda p: p[:, 0])
        n = data.GetNumberOfPoints()
        text, bits = vtkStringArray(), vtkBitArray()
        text.SetName("text")
        bits.SetName("bits")
        for i in range(n):
            text.InsertNextValue(str(i))
            bits.InsertNextValue(i % 2)
        for array in (text, bits):
            data.GetPointData().AddArray(array)
        data.GetPointData().SetGlobalIds(ids(n, "PointIds"))
        data.GetCellData().SetGlobalIds(ids(data.GetNumberOfCells(), "CellIds"))
        output = split(data, [0.1])
        out, points = Cells(output), output.GetPointData()
        nearest = [int(np.argmin(np.linalg.norm(meshes.points_of(data) - p, axis=1))) for p in out.points]
        names, flags = points.GetAbstractArray("text"), points.GetAbstractArray("bits")
        edges = [i for i in range(len(out.points)) if names.GetValue(i) != str(nearest[i])]
        self.assertLess(len(edges), 0.7 * (len(out.points) - n))  # of a diagonal the nearer end need not be the nearest point
        self.assertEqual([flags.GetValue(i) for i in range(len(out.points))],
                         [int(names.GetValue(i)) % 2 for i in range(len(out.points))])
        self.assertEqual(list(out.array("PointIds", points=True)), [1000 + i for i in range(n)] + [-1] * (len(out.points) - n))
        np.testing.assert_array_equal(out.array("CellIds"), 1000 + out.array("Source"))
        self.assertIsNone(points.GetGlobalIds())
        self.assertIsNone(output.GetCellData().GetGlobalIds())

    def test_active_attributes_and_names(self):
        data = block()
        vectors = numpy_to_vtk(meshes.points_of(data), deep=True)
        vectors.SetName("v")
        vectors.SetComponentName(1, "north")
        data.GetPointData().SetVectors(vectors)
        data.GetPointData().SetActiveScalars("s")
        points = split(data, [0.1], array=None).GetPointData()
        self.assertEqual(points.GetVectors().GetComponentName(1), "north")
        self.assertEqual(points.GetScalars().GetName(), "s")

    def test_precision(self):
        data = block()
        for precision, expected in ((0, "f4"), (1, "f8"), (2, "f8")):
            self.assertEqual(meshes.vtk_to_numpy(split(data, [0.1], OutputPointsPrecision=precision).GetPoints().GetData()).dtype, expected)
        data.GetPoints().SetData(numpy_to_vtk(meshes.points_of(data).astype("f4"), deep=True))
        for precision, expected in ((1, "f8"), (2, "f4")):
            self.assertEqual(meshes.vtk_to_numpy(split(data, [0.1], OutputPointsPrecision=precision).GetPoints().GetData()).dtype, expected)


class ParentCells(unittest.TestCase):
    def test_cell_arrays_are_those_of_the_cell(self):
        data = block()
        n = data.GetNumberOfCells()
        rng = np.random.default_rng(1)
        arrays = {"f": rng.normal(size=(n, 3)), "i": rng.integers(0, 99, n).astype("u1"), "d": rng.normal(size=n)}
        for name, values in arrays.items():
            meshes.add_array(data.GetCellData(), values, name)
        text = vtkStringArray()
        text.SetName("text")
        for i in range(n):
            text.InsertNextValue(str(i))
        data.GetCellData().AddArray(text)
        output = split(data, [0.2, 0.6])
        out = Cells(output)
        source = out.array("Source")
        for name, values in arrays.items():
            np.testing.assert_array_equal(out.array(name), values[source])
        names = output.GetCellData().GetAbstractArray("text")
        self.assertEqual([names.GetValue(i) for i in range(len(source))], [str(i) for i in source])
        inside = [np.abs(out.points[out.ids[i]].mean(axis=0) - Cells(data).points[Cells(data).ids[source[i]]].mean(axis=0)).max() for i in (0, len(source) // 2)]
        self.assertLess(max(inside), 1 / 3 + 1e-12)
        self.assertTrue((np.diff(source[out.solid]) >= 0).all())


def flags(attributes, count, values):
    array = np.zeros(count, "u1")
    for flag, where in values.items():
        array[where] |= int(flag) # newer NumPy takes VTK's enumerations for 64-bit integers
    meshes.add_array(attributes, array, "vtkGhostType")


class Ghosts(unittest.TestCase):
    def test_hidden_cells_are_left_out_and_duplicates_stay(self):
        data = block()
        flags(data.GetCellData(), data.GetNumberOfCells(), {DSA.HIDDENCELL: [0, 13], DSA.REFINEDCELL: [1], DSA.DUPLICATECELL: [2, 26]})
        out = Cells(split(data, [0.2]))
        source, ghost = out.array("Source"), out.array("vtkGhostType")
        self.assertEqual(set(range(27)) - set(source), {0, 1, 13})
        np.testing.assert_array_equal(ghost != 0, np.isin(source, [2, 26]))
        self.assertTrue((ghost[ghost != 0] == DSA.DUPLICATECELL).all())

    def test_cells_at_hidden_points_are_left_out(self):
        data = block()
        flags(data.GetPointData(), data.GetNumberOfPoints(), {DSA.HIDDENPOINT: [0], DSA.DUPLICATEPOINT: range(1, 32)})
        meshes.add_array(data.GetPointData(), np.r_[0.0, np.ones(31), np.zeros(32)], "share")  # of flagged points along an edge
        out = Cells(split(data, [0.2]))
        self.assertEqual(set(range(27)) - set(out.array("Source")), {0})
        ghost = out.array("vtkGhostType", points=True)
        self.assertFalse((ghost[64:] & DSA.HIDDENPOINT).any())
        np.testing.assert_array_equal(ghost[64:] == DSA.DUPLICATEPOINT, out.array("share", points=True)[64:] == 1)

    def test_blanked_cells_of_images_and_structured_grids(self):
        structured = meshes.structured((3, 3, 3), centred)
        structured.BlankCell(5)
        structured.BlankPoint(63)
        image = meshes.image((3, 3, 3), (2 / 3,) * 3, (-1,) * 3)
        flags(image.GetCellData(), 27, {DSA.HIDDENCELL: [5]})
        flags(image.GetPointData(), 64, {DSA.HIDDENPOINT: [63]})
        for data in (structured, image):
            meshes.with_field(with_sources(data), wavy)
            self.assertEqual(set(range(27)) - set(Cells(split(data, [0.2])).array("Source")), {5, 26})

    def test_missing_numbers(self):
        data = block()
        values = wavy(meshes.points_of(data))
        values[0], values[63] = np.nan, -np.inf
        meshes.add_array(data.GetPointData(), values)
        out = Cells(split(data, [0.2], expect=["The array 's' is not a finite number at vertices of 2 cells (the first one is cell 0)"]))
        self.assertEqual(list(out.array("Source")[out.array("Layer") < 0]), [0, 26])
        self.assertTrue((out.types[out.array("Layer") < 0] == VTK_HEXAHEDRON).all())


if __name__ == "__main__":
    unittest.main()
