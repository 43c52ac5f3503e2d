# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays, attributes, other cells, ghosts, blocks and threads."""
import unittest

import numpy as np
from division import HAS_TETGEN, DivisionTestCase, divide
from nephoscope_testing import dual_meshes, meshes, nonconvex
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkSMPTools, vtkStringArray
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_TETRA, VTK_TRIANGLE, vtkImageData,
                                           vtkMultiBlockDataSet)

GRADIENT = np.array([1.0, -2.0, 0.5])


def schonhardt_and_others():
    """A polyhedron that needs a new point, between a hexahedron, a triangle and a convex polyhedron."""
    points, faces, volume = nonconvex.schonhardt()
    cube, cube_faces, _ = nonconvex.prism(((0, 0), (1, 0), (1, 1), (0, 1)))
    n = len(points)
    data = nonconvex.grid_of(np.vstack([points, cube + (4, 0, 0)]), [])
    from vtkmodules.vtkCommonCore import vtkIdList

    def insert(loops, shift):
        stream = vtkIdList()
        for value in [len(loops)] + [v for f in loops for v in [len(f)] + [i + shift for i in f]]:
            stream.InsertNextId(value)
        data.InsertNextCell(VTK_POLYHEDRON, stream)
    data.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(n, n + 8)))
    insert(faces, 0)
    data.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
    insert(cube_faces, n)
    return data, volume


class Arrays(DivisionTestCase):
    def setUp(self):
        self.data, self.volume = schonhardt_and_others()
        self.points = meshes.points_of(self.data)

    def add(self, attributes, values, name):
        meshes.add_array(attributes, values, name)
        return attributes.GetArray(name)

    def divided(self):
        divider, messages = divide(self.data)
        self.no_messages(messages)
        return divider.GetOutput()

    def test_cells_keep_their_order_and_arrays(self):
        self.add(self.data.GetCellData(), np.arange(4.0), "number")
        self.add(self.data.GetCellData(), np.arange(12.0).reshape(4, 3), "vector")
        names = vtkStringArray()
        names.SetName("name")
        for name in ("hexahedron", "Schonhardt", "triangle", "cube"):
            names.InsertNextValue(name)
        self.data.GetCellData().AddArray(names)
        out = self.divided()
        types = [out.GetCellType(i) for i in range(out.GetNumberOfCells())]
        self.assertEqual(types, [VTK_HEXAHEDRON] + [VTK_TETRA] * 8 + [VTK_TRIANGLE, VTK_POLYHEDRON])
        parents = np.array([0] + [1] * 8 + [2, 3])
        np.testing.assert_array_equal(vtk_to_numpy(out.GetCellData().GetArray("number")), parents)
        np.testing.assert_array_equal(vtk_to_numpy(out.GetCellData().GetArray("vector"))[:, 2], 3 * parents + 2)
        carried = out.GetCellData().GetAbstractArray("name")
        self.assertEqual([carried.GetValue(i) for i in (0, 1, 8, 9, 10)],
                         ["hexahedron", "Schonhardt", "Schonhardt", "triangle", "cube"])

    def test_linear_fields_are_exact_at_new_points(self):
        self.add(self.data.GetPointData(), self.points @ GRADIENT + 3, "s")
        self.add(self.data.GetPointData(), self.points * 2, "vector")
        self.add(self.data.GetPointData(), (self.points @ GRADIENT).astype(np.float32), "float")
        out = self.divided()
        placed = meshes.points_of(out)
        self.assertEqual(len(placed), len(self.points) + 1)
        np.testing.assert_allclose(nonconvex.point_values(out), placed @ GRADIENT + 3, atol=1e-14)
        np.testing.assert_allclose(nonconvex.point_values(out, "vector"), placed * 2, atol=1e-14)
        np.testing.assert_allclose(nonconvex.point_values(out, "float"), placed @ GRADIENT, atol=1e-6)

    @unittest.skipUnless(HAS_TETGEN, "this build has no TetGen")
    def test_several_new_points_in_one_cell(self):
        points, faces, _ = nonconvex.tower(5)
        rng = np.random.default_rng(1)
        data = nonconvex.grid_of(points, [faces])
        self.add(data.GetPointData(), points @ GRADIENT, "s")
        random = rng.uniform(2, 3, len(points))
        self.add(data.GetPointData(), random, "random")
        out = divide(data)[0].GetOutput()
        placed = meshes.points_of(out)
        self.assertGreaterEqual(len(placed) - len(points), 5)
        np.testing.assert_allclose(nonconvex.point_values(out), placed @ GRADIENT, atol=1e-13)
        new = nonconvex.point_values(out, "random")[len(points):]
        self.assertTrue((new > random.min()).all() and (new < random.max()).all(), new)

    def test_integers_are_rounded_and_strings_taken_from_the_nearest(self):
        self.add(self.data.GetPointData(), np.array([0, 0, 0, 1, 1, 1] + [9] * 8), "step")
        names = vtkStringArray()
        names.SetName("name")
        for i in range(14):
            names.InsertNextValue("corner" if i < 6 else "cube")
        self.data.GetPointData().AddArray(names)
        out = self.divided()
        self.assertIn(out.GetPointData().GetArray("step").GetTuple1(14), (0, 1))
        self.assertEqual(out.GetPointData().GetAbstractArray("name").GetValue(14), "corner")

    def test_active_attributes_and_ids(self):
        scalars = self.add(self.data.GetPointData(), self.points @ GRADIENT, "s")
        self.data.GetPointData().SetActiveScalars("s")
        self.data.GetCellData().SetActiveVectors(self.add(self.data.GetCellData(), np.ones((4, 3)), "v").GetName())
        for attributes, n in ((self.data.GetPointData(), 14), (self.data.GetCellData(), 4)):
            ids = vtkIdTypeArray()
            ids.SetName("GlobalIds")
            for i in range(n):
                ids.InsertNextValue(100 + i)
            attributes.SetGlobalIds(ids)
        out = self.divided()
        self.assertEqual(out.GetPointData().GetScalars().GetName(), scalars.GetName())
        self.assertEqual(out.GetCellData().GetVectors().GetName(), "v")
        self.assertIsNone(out.GetCellData().GetGlobalIds(), "not unique any more")
        self.assertIsNone(out.GetPointData().GetGlobalIds())
        cell_ids = vtk_to_numpy(out.GetCellData().GetArray("GlobalIds"))
        np.testing.assert_array_equal(cell_ids, [100] + [101] * 8 + [102, 103])
        np.testing.assert_array_equal(vtk_to_numpy(out.GetPointData().GetArray("GlobalIds")), [*range(100, 114), -1])

    def test_ghosts(self):
        """Hidden cells, and cells at a hidden point, stay whole; duplicates are divided and stay duplicates."""
        def ghosts(attributes, n, index, value):
            array = numpy_to_vtk(np.where(np.arange(n) == index, value, 0).astype(np.uint8), deep=True)
            array.SetName("vtkGhostType")
            attributes.AddArray(array)
        for hidden in ("cell", "point"):
            data, _ = schonhardt_and_others()
            attributes = data.GetCellData() if hidden == "cell" else data.GetPointData()
            ghosts(attributes, 4 if hidden == "cell" else 14, 1, 32 if hidden == "cell" else 2)
            divider, messages = divide(data)
            self.no_messages(messages)
            self.assertEqual(divider.GetNumberOfDividedCells(), 0, hidden)
        ghosts(self.data.GetCellData(), 4, 1, 1)
        ghosts(self.data.GetPointData(), 14, 0, 1)
        out = self.divided()
        np.testing.assert_array_equal(vtk_to_numpy(out.GetCellData().GetArray("vtkGhostType")), [0] + [1] * 8 + [0, 0])
        self.assertEqual(out.GetPointData().GetArray("vtkGhostType").GetTuple1(14), 0)

    def test_what_needs_nothing_is_passed_untouched(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        for data in (image, meshes.Lattice(2).mesh("hexahedron")):
            divider, messages = divide(data)
            self.no_messages(messages)
            out = divider.GetOutput()
            self.assertEqual(out.GetClassName(), data.GetClassName())
            self.assertEqual(out.GetNumberOfCells(), data.GetNumberOfCells())
        points, faces, _ = nonconvex.prism(((0, 0), (1, 0), (1, 1), (0, 1)))
        data = nonconvex.grid_of(points, [faces])
        out = divide(data)[0].GetOutput()
        self.assertEqual(out.GetPoints(), data.GetPoints(), "the points are shared")

    def test_field_data_and_input_are_kept(self):
        self.add(self.data.GetFieldData(), np.array([1.5]), "time")
        before = self.data.GetNumberOfCells(), self.data.GetNumberOfPoints(), self.data.GetMTime()
        out = self.divided()
        self.assertEqual(out.GetFieldData().GetArray("time").GetTuple1(0), 1.5)
        self.assertEqual((self.data.GetNumberOfCells(), self.data.GetNumberOfPoints(), self.data.GetMTime()), before)

    def test_multiblock(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, self.data)
        image = vtkImageData()
        image.SetDimensions(2, 2, 2)
        blocks.SetBlock(1, image)
        divider, messages = divide(blocks)
        self.no_messages(messages)
        out = divider.GetOutputDataObject(0)
        self.assertEqual(out.GetBlock(0).GetNumberOfCells(), 11)
        self.assertEqual(out.GetBlock(1).GetClassName(), "vtkImageData")

    def test_threads_and_numbering_change_nothing(self):
        mesh, _ = dual_meshes.openfoam_like(np.random.default_rng(1), 0.5, 0.2)
        grid = mesh.grid()
        meshes.with_field(grid, lambda p: p @ GRADIENT)
        results = []
        for threads in (1, 2, 4):
            vtkSMPTools.Initialize(threads)
            out = divide(grid)[0].GetOutput()
            connectivity = vtk_to_numpy(out.GetCells().GetConnectivityArray())
            results.append((connectivity.tolist(), meshes.points_of(out).tolist(), nonconvex.point_values(out).tolist()))
        vtkSMPTools.Initialize(0)
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])


if __name__ == "__main__":
    unittest.main(verbosity=2)
