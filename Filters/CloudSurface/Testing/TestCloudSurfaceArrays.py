# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every point array reaches the surface: linear fields exactly, the contoured one with the value, text and ids from a grid point."""
import unittest

import cloud_grids as cg
import numpy as np
from TestCloudSurfaceShapes import ball, bent, lattice
from vtkmodules.vtkCommonCore import vtkBitArray, vtkDoubleArray, vtkStringArray


def linear(p):
    return p @ [1.5, -2.0, 0.7] + 3


def grid(n=10):
    positions = bent(lattice(n)[0])
    numbers = np.arange(positions[..., 0].size).reshape(positions.shape[:3])
    fields = {"f": ball(positions), "d": linear(positions), "s": linear(positions).astype("f4"), "x": positions,
              "n": numbers.astype("i8")}
    return cg.structured(positions, fields)


class Arrays(unittest.TestCase):
    def test_linear_fields_are_exact(self):
        data = grid()
        names = [data.GetPointData().GetArrayName(i) for i in range(5)]
        out = cg.surface(data, [0.8, 0.7], 2)
        self.assertGreater(out.GetNumberOfPoints(), 150)
        self.assertLessEqual(set(names), {out.GetPointData().GetArrayName(i) for i in range(out.GetPointData().GetNumberOfArrays())})
        p = cg.points(out)
        np.testing.assert_allclose(cg.values(out, "x"), p, atol=1e-14)
        np.testing.assert_allclose(cg.values(out, "d"), linear(p), atol=1e-14)
        np.testing.assert_allclose(cg.values(out, "s"), linear(p), atol=1e-6)
        self.assertEqual(cg.values(out, "s").dtype, np.float32)

    def test_only_the_contoured_array_is_smoothed(self):
        """Others are interpolated at the place that the smoothed field gives."""
        data = grid()
        cg.add(data, {"g": cg.values(data, "d") ** 2})
        data.GetPointData().SetActiveScalars("f")
        out = cg.surface(data, [0.8], 3)
        self.assertLess(np.abs(cg.values(out, "g") - linear(cg.points(out)) ** 2).max(), 0.1)  # h^2
        self.assertGreater((cg.values(out, "g") - linear(cg.points(out)) ** 2).min(), -1e-12)  # chords of a parabola

    def test_values_and_their_index(self):
        data = grid()
        values = [0.8, 0.5, 0.8, 0.65]
        out = cg.surface(data, values)
        index = cg.cell_values(out, "ContourIndex")
        self.assertEqual(set(index), {0, 1, 3})
        on_cells = cg.values(out)[cg.triangles(out)]
        np.testing.assert_array_equal(on_cells, np.repeat(np.array(values)[index][:, None], 3, axis=1))
        self.assertEqual(out.GetPointData().GetScalars().GetName(), "f")
        for i, value in enumerate((0.5, 0.65, 0.8)):
            self.assertEqual((index == [1, 3, 0][i]).sum(), cg.surface(data, [value]).GetNumberOfCells())
        self.assertEqual([cg.cell_values(cg.surface(data, [v]), "ContourIndex")[0] for v in values], [0] * 4)

    def test_types_of_the_contoured_array(self):
        for dtype, expected in (("f4", "float"), ("f8", "double"), ("i4", "double")):
            field = (100 * ball(lattice(8)[0])).astype(dtype)
            out = cg.surface(cg.image(field), [60.5])
            self.assertEqual(out.GetPointData().GetScalars().GetDataTypeAsString(), expected)
            self.assertTrue((cg.values(out) == 60.5).all())

    def test_points_keep_their_precision(self):
        positions = lattice(8)[0]
        for dtype, expected in (("f4", "float"), ("f8", "double")):
            out = cg.surface(cg.structured(positions.astype(dtype), {"f": ball(positions)}), [0.7])
            self.assertEqual(out.GetPoints().GetData().GetDataTypeAsString(), expected)

    def test_text_bits_and_ids_come_from_a_neighbour(self):
        data = grid()
        text, bits = vtkStringArray(), vtkBitArray()
        for array, name in ((text, "text"), (bits, "bits")):
            array.SetName(name)
            array.SetNumberOfValues(data.GetNumberOfPoints())
            for i in range(data.GetNumberOfPoints()):
                array.SetValue(i, str(i) if array is text else i % 2)
            data.GetPointData().AddArray(array)
        data.GetPointData().SetGlobalIds(cg.array("gid", np.arange(data.GetNumberOfPoints())))
        out = cg.surface(data, [0.7])
        at = cg.points(data).reshape(-1, 3)
        ids = cg.values(out, "gid")
        spacing = np.linalg.norm(at[1] - at[0])
        self.assertLess(np.linalg.norm(at[ids] - cg.points(out), axis=1).max(), spacing)
        names, flags = (out.GetPointData().GetAbstractArray(n) for n in ("text", "bits"))
        self.assertEqual([int(names.GetValue(i)) for i in range(len(ids))], list(ids))
        self.assertEqual([flags.GetValue(i) for i in range(len(ids))], list(ids % 2))
        self.assertIsNone(out.GetPointData().GetGlobalIds())

    def test_names(self):
        """Component names stay; vectors stay vectors; an array without a name does no harm."""
        data = grid()
        data.GetPointData().SetActiveVectors("x")
        data.GetPointData().GetArray("x").SetComponentName(1, "north")
        nameless = vtkDoubleArray()
        nameless.SetNumberOfTuples(data.GetNumberOfPoints())
        nameless.Fill(2.5)
        data.GetPointData().AddArray(nameless)
        out = cg.surface(data, [0.7])
        self.assertEqual(out.GetPointData().GetVectors().GetName(), "x")
        self.assertEqual(out.GetPointData().GetArray("x").GetComponentName(1), "north")
        self.assertEqual([out.GetPointData().GetArrayName(i) for i in range(out.GetPointData().GetNumberOfArrays())].count(None), 1)

    def test_an_array_chosen_by_name(self):
        data = grid()
        out = cg.surface(data, [3.0], setup=lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, "d"))
        np.testing.assert_allclose(linear(cg.points(out)), 3, atol=1e-13)
        np.testing.assert_allclose(cg.values(out, "Normals"), [-np.array([1.5, -2.0, 0.7]) / np.sqrt(6.74)] * out.GetNumberOfPoints(), atol=1e-6)


if __name__ == "__main__":
    unittest.main()
