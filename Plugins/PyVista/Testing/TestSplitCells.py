# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""mesh.nephoscope.split_cells: values, layers, arguments, errors."""
import unittest

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet


def block(n=6):
    mesh = pyvista.ImageData(dimensions=(n + 1,) * 3, spacing=(2 / n,) * 3, origin=(-1,) * 3)
    mesh.point_data["r"] = np.linalg.norm(mesh.points, axis=1)
    mesh.point_data["x"] = mesh.points[:, 0]
    mesh.cell_data["number"] = np.arange(mesh.n_cells)
    return mesh


class SplitCells(unittest.TestCase):
    def test_layers(self):
        mesh = block()
        names = list(mesh.array_names)
        split = mesh.nephoscope.split_cells([0.75, 0.25], "r")
        self.assertIsInstance(split, pyvista.UnstructuredGrid)
        self.assertEqual(set(split.cell_data["Layer"]), {0, 1, 2})
        solid = split.extract_cells(split.cell_data["ContourIndex"] == -1)
        self.assertAlmostEqual(solid.volume, 8, places=10)
        middle = split.extract_cells((split.cell_data["Layer"] == 1) & (split.cell_data["ContourIndex"] == -1))
        self.assertEqual((middle.point_data["r"].min(), middle.point_data["r"].max()), (0.25, 0.75))
        surface = split.extract_cells(split.cell_data["ContourIndex"] == 0)
        self.assertTrue((surface.point_data["r"] == 0.75).all())
        self.assertEqual(mesh.array_names, names)

    def test_number_of_values(self):
        split = block().nephoscope.split_cells(3, "x", rng=(-0.5, 0.5), surfaces=False)
        self.assertEqual(set(split.cell_data["Layer"]), {0, 1, 2, 3})
        self.assertEqual(set(split.cell_data["ContourIndex"]), {-1})
        new = split.points[block().n_points:]
        self.assertTrue(len(new) and np.isin(new[:, 0].round(12), (-0.5, 0, 0.5)).all())

    def test_one_value_and_the_active_scalars(self):
        mesh = block()
        mesh.set_active_scalars("r")
        self.assertEqual(set(nephoscope.split_cells(mesh, 0.5).cell_data["Layer"]), {0, 1})
        self.assertEqual(mesh.active_scalars_name, "r")

    def test_vectors_first(self):
        mesh = pyvista.ImageData(dimensions=(4, 4, 4))
        mesh["U"] = mesh.points
        with self.assertRaisesRegex(MissingDataError, r'mesh\["magnitude"\] = numpy.linalg.norm\(mesh\["U"\], axis=1\)'):
            mesh.nephoscope.split_cells(3)
        mesh["T"] = mesh.points[:, 0]
        for data in (mesh, pyvista.MultiBlock([mesh])):
            pieces = data.nephoscope.split_cells([1.5])
            self.assertEqual(set((pieces if data is mesh else pieces[0]).cell_data["Layer"]), {0, 1})

    def test_transitions(self):
        split = block().nephoscope.split_cells(0.5, "r", polyhedral_transitions=True)
        self.assertIn(pyvista.CellType.POLYHEDRON, split.celltypes)

    def test_blocks(self):
        """Each for itself, at values that are those of all; names and empty blocks stay."""
        left, right = block(), block()
        right.origin = (1, -1, -1)
        right["x"] = right.points[:, 0]
        for data in (left, right):
            data.set_active_scalars("x")
        blocks = pyvista.MultiBlock({"left": left, "nested": pyvista.MultiBlock({"right": right}), "none": None})
        split = nephoscope.split_cells(blocks, 4)  # -1, 1/3, 5/3 and 3
        self.assertEqual(split.keys(), ["left", "nested", "none"])
        self.assertIsNone(split["none"])
        for data, index, other in ((split["left"], 1, 2), (split["nested"]["right"], 2, 1)):
            self.assertIn(index, data.cell_data["ContourIndex"])
            self.assertNotIn(other, data.cell_data["ContourIndex"])
        halves = nephoscope.split_cells(blocks, [0.0, 2.0], "x")
        self.assertEqual([sorted(set(b.cell_data["Layer"])) for b in (halves["left"], halves["nested"]["right"])], [[0, 1], [1, 2]])
        if hasattr(pyvista.MultiBlock, "nephoscope"):
            self.assertEqual(blocks.nephoscope.split_cells(3).keys(), split.keys())
        with self.assertRaisesRegex(MissingDataError, "no point array 'q'"):
            nephoscope.split_cells(blocks, 3, "q")
        self.assertEqual(nephoscope.split_cells(pyvista.MultiBlock(), 3).n_blocks, 0)

    def test_partitions(self):
        """They become a MultiBlock."""
        parts = vtkPartitionedDataSet()
        parts.SetPartition(0, block())
        split = nephoscope.split_cells(parts, [0.5], "r")
        self.assertIsInstance(split, pyvista.MultiBlock)
        self.assertEqual(set(split[0].cell_data["Layer"]), {0, 1})

    def test_errors(self):
        mesh = block()
        with self.assertRaisesRegex(MissingDataError, "no point array 'q'. Point arrays: .*'r'"):
            mesh.nephoscope.split_cells(0.5, "q")
        with self.assertRaisesRegex(MissingDataError, "cell_data_to_point_data"):
            mesh.nephoscope.split_cells(0.5, "number")
        with self.assertRaisesRegex(ValueError, "finite"):
            mesh.nephoscope.split_cells([0.5, np.nan], "r")
        with self.assertRaisesRegex(ValueError, "at least 0"):
            mesh.nephoscope.split_cells(-1, "r")
        with self.assertRaisesRegex(TypeError, "mesh is a list"):
            nephoscope.split_cells([1])
        mesh.point_data["v"] = mesh.points
        with self.assertRaisesRegex(ValueError, "'v' has 3 components.*Point arrays of one component: 'r', 'x'"):
            mesh.nephoscope.split_cells(0.5, "v")
        with self.assertWarnsRegex(RuntimeWarning, "not three-dimensional"):
            pyvista.Sphere().elevation().nephoscope.split_cells(0.1)
        mesh.set_active_scalars(None)
        self.assertGreater(mesh.nephoscope.split_cells(3).n_cells, 0)  # of the first array of numbers
        empty = pyvista.ImageData(dimensions=(2, 2, 2))
        with self.assertRaisesRegex(MissingDataError, "no point or cell array with one component"):
            empty.nephoscope.split_cells(0.5)


if __name__ == "__main__":
    unittest.main()
