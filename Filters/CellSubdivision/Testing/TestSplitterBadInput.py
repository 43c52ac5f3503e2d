# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each bad input gets its own message, which names the array or the cell and the remedy; nothing crashes."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.meshes import Lattice
from nephoscope_testing.messages import Messages
from split_checks import Cells, split
from split_meshes import centred, grid_of, wavy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_LINE, VTK_POLYHEDRON, VTK_QUAD, VTK_VERTEX, vtkImageData, vtkMultiBlockDataSet,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkFiltersSources import vtkSphereSource


class BadInput(unittest.TestCase):
    def nothing(self, data, text, values=(0.5,), array="s", **settings):
        out = split(data, list(values), array, expect=[text], **settings)
        self.assertEqual(out.GetNumberOfCells(), 0)

    def block(self, **arrays):
        data = Lattice(2).mesh("hexahedron")
        for name, values in arrays.items():
            meshes.add_array(data.GetPointData(), np.asarray(values, float), name)
        return data

    def test_empty(self):
        for data in (vtkUnstructuredGrid(), vtkImageData()):
            self.nothing(data, "The input is empty")
        self.assertEqual(split(meshes.grid(np.zeros((3, 3)), []), [0.5]).GetNumberOfCells(), 0)

    def test_missing_array(self):
        self.nothing(self.block(t=np.zeros(27), u=np.zeros(27)), "There is no point array 's'")
        self.nothing(self.block(t=np.zeros(27), u=np.zeros(27)), "Point arrays: 't', 'u'.")
        self.nothing(self.block(), "no point array of the active scalars", array=None)
        on_cells = meshes.with_field(self.block(), wavy, "cell")
        self.nothing(on_cells, "It is on cells: apply Cell Data to Point Data first")

    def test_association(self):
        data = meshes.with_field(self.block(), wavy, "cell")
        self.nothing(data, "'s' is not on points", array=None,
                     setup=lambda made: made.SetInputArrayToProcess(0, 0, 0, 1, "s"))

    def test_components_and_type(self):
        data = self.block(v=np.zeros((27, 3)))
        self.nothing(data, "'v' of type double has 3 components; one number", array="v")
        text = vtkStringArray()
        text.SetName("text")
        text.SetNumberOfValues(27)
        data.GetPointData().AddArray(text)
        self.nothing(data, "'text' of type string", array="text")

    def test_too_short_array(self):
        data = self.block()
        meshes.add_array(data.GetPointData(), np.zeros(5))
        self.nothing(data, "'s' has 5 values for 27 points")

    def test_values(self):
        data = self.block(s=np.arange(27))
        self.nothing(data, "Contour value 1 is nan", values=(1, np.nan))
        self.nothing(data, "Contour value 0 is inf", values=(np.inf,))

    def test_default_value_of_equal_values(self):
        """Nothing is chosen: one value, that of the field everywhere, divides nothing, which is told; once for all blocks."""
        def nothing_chosen(block, expect):
            filter_ = nephoscope.vtkContourCellSplitter()
            filter_.SetInputDataObject(block)
            filter_.SetInputArrayToProcess(0, 0, 0, 0, "")
            with Messages() as messages:
                filter_.Update()
            self.assertEqual([expect in m for m in messages.all], [True] * bool(expect), messages.all)
        def field(function):
            data = meshes.with_field(meshes.image((2, 2, 2)), function)
            data.GetPointData().SetActiveScalars("s")
            return data
        constant = field(lambda p: 5 + 0 * p[:, 0])
        blocks = vtkMultiBlockDataSet()
        for i in range(2):
            blocks.SetBlock(i, constant)
        for data in (constant, blocks):
            nothing_chosen(data, "No cell is divided: the values of the array 's' are all 5, so that no value is between them. Choose another array.")
        blocks.SetBlock(2, field(lambda p: p[:, 0]))
        nothing_chosen(blocks, "")

    def test_cells_that_are_not_solid(self):
        sphere = vtkSphereSource()
        sphere.Update()
        data = meshes.with_field(sphere.GetOutput(), lambda p: p[:, 0])
        self.nothing(data, "96 cells (the first one is cell 0) of the input are not three-dimensional")
        flat = meshes.with_field(meshes.image((3, 3, 0)), lambda p: p[:, 0])
        self.nothing(flat, "9 cells")
        points = Lattice(1).points
        mixed = meshes.with_field(meshes.grid(points, [(VTK_HEXAHEDRON, Lattice(1).ids((0, 0, 0))), (VTK_QUAD, (0, 1, 3, 2)),
                                                       (VTK_LINE, (0, 1)), (VTK_VERTEX, (0,))]), lambda p: p[:, 0])
        out = Cells(split(mixed, [0.5], expect=["3 cells (the first one is cell 1) of the input are not three-dimensional"]))
        self.assertAlmostEqual(out.volumes().sum(), 1)

    def test_not_convex(self):
        """A prism in the form of a U: the message names the cell. One in the form of an L is seen whole from its corner."""
        outline = [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
        self.prism(outline, ["1 cell (the first one is cell 0) crossed by a value is not convex"])
        out = self.prism([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], [])
        self.assertAlmostEqual(out.volumes().sum(), 3, places=12)
        self.assertGreater(out.volumes()[out.solid].min(), 0)

    def prism(self, outline, expect):
        points = np.array([(x, y, z) for z in (0, 1) for x, y in outline], float)
        n = len(outline)
        faces = [list(range(n))[::-1], list(range(n, 2 * n))] + [[k, (k + 1) % n, (k + 1) % n + n, k + n] for k in range(n)]
        data = meshes.with_field(grid_of(points, [(VTK_POLYHEDRON, faces)]), lambda p: p[:, 0] + p[:, 1])
        return Cells(split(data, [0.5, 1.7], expect=expect))

    def test_flat_cells(self):
        """Cells without volume do no harm to others."""
        for kind in ("hexahedron", "tetra", "wedge"):
            for flatten in ([1, 1, 0], [1, 0, 0], [0, 0, 0]):
                data = Lattice(2).mesh(kind, lambda p: centred(p) * flatten)
                meshes.add_array(data.GetPointData(), wavy(Lattice(2).points))
                made = split(data, [0.2], expect=[] if kind == "tetra" else ["no volume to divide"])
                self.assertTrue(np.isfinite(meshes.points_of(made)).all())

    def test_points_that_are_not_numbers(self):
        data = self.block(s=np.arange(27.0))
        points = meshes.points_of(data)
        points[26] = np.nan
        data.GetPoints().SetData(meshes.vtk_points(points).GetData())
        with_nan = Cells(split(data, [20.5], expect=["1 cell (the first one is cell 7) crossed by a value is not convex"]))
        self.assertGreater(np.sum(with_nan.solid), 8)

    def test_huge_scalars(self):
        data = self.block(s=np.linspace(-0.8e308, 0.8e308, 27))
        out = Cells(split(data, [0.0, 1e307]))
        self.assertTrue(np.isfinite(out.points).all())
        self.assertAlmostEqual(out.volumes().sum(), 1, places=12)


if __name__ == "__main__":
    unittest.main()
