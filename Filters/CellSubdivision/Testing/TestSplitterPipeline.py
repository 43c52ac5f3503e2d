# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Threads change nothing, blocks are taken one by one and fit, numbering does not matter, abort gives nothing."""
import hashlib
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes, threads
from nephoscope_testing.filters import some_values_given
from nephoscope_testing.meshes import Lattice
from split_checks import Cells, split
from split_meshes import centred, hexahedra_as_polyhedra, wavy, with_sources
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkThreshold


def large():
    """Several batches of cells, with arrays; polyhedra make the output cell by cell."""
    image = meshes.image((24, 22, 20), (2 / 24, 2 / 22, 2 / 20), (-1,) * 3)
    polyhedra = hexahedra_as_polyhedra((14, 13, 12), centred, every=3)
    for data in (image, polyhedra):
        meshes.with_field(with_sources(data), wavy)
        meshes.add_array(data.GetPointData(), meshes.points_of(data).astype("f4"), "v")
    return image, polyhedra


def digest(output):
    """Hash of all arrays and cells."""
    made = hashlib.sha256()
    arrays = [output.GetPoints().GetData(), output.GetCells().GetConnectivityArray(), output.GetCells().GetOffsetsArray()]
    for attributes in (output.GetPointData(), output.GetCellData()):
        arrays += [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    for array in arrays:
        made.update(vtk_to_numpy(array).tobytes())
    return made.hexdigest()


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        made = threads.results(
            __file__, "[digest(split(d, [0.2, -0.3, 0.9], PolyhedralTransitions=p)) for d in large() for p in (False, True)]")
        self.assertEqual(len(made), 1)


class Batches(unittest.TestCase):
    def test_a_cut_of_several_batches_is_one_point(self):
        for data in large():
            points = meshes.points_of(split(data, [0.2, -0.3]))
            self.assertEqual(len(np.unique(points, axis=0)), len(points))


class Blocks(unittest.TestCase):
    def test_blocks_fit_bit_by_bit(self):
        """Two halves with points of their own: the cuts on the common face are the same places."""
        data = meshes.with_field(with_sources(Lattice(4).mesh("hexahedron", centred)), wavy)
        blocks = vtkMultiBlockDataSet()
        for number, (low, high) in enumerate(((0, 31), (32, 63))):
            half = vtkThreshold()
            half.SetInputData(data)
            half.SetInputArrayToProcess(0, 0, 0, 1, "Source")
            half.SetLowerThreshold(low)
            half.SetUpperThreshold(high)
            half.Update()
            blocks.SetBlock(number, half.GetOutput())
        output = split(blocks, [0.2, -0.3])
        whole = Cells(split(data, [0.2, -0.3]))
        halves = [Cells(output.GetBlock(i)) for i in range(2)]
        self.assertEqual(sum(len(h.types) for h in halves), len(whole.types))
        rows = lambda points: {tuple(p) for p in points}
        self.assertEqual(rows(halves[0].points) | rows(halves[1].points), rows(whole.points))
        common = rows(halves[0].points) & rows(halves[1].points)
        self.assertEqual(common, rows(whole.points[whole.points[:, 2] == 0]))

    def test_a_block_without_the_array_does_not_stop_the_others(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, meshes.image((2, 2, 2)))
        blocks.SetBlock(1, meshes.with_field(meshes.image((2, 2, 2)), lambda p: p[:, 0]))
        output = split(blocks, [0.5])
        self.assertGreater(output.GetBlock(1).GetNumberOfCells(), 8)


class Pipeline(unittest.TestCase):
    def test_renumbered_mesh_gives_the_same_pieces(self):
        rng = np.random.default_rng(2)
        data = meshes.with_field(meshes.delaunay(rng, 50), wavy)
        places = lambda out: sorted(tuple(sorted(map(tuple, out.points[ids]))) for ids in out.ids)
        self.assertEqual(places(Cells(split(data, [0.2, 0.4]))), places(Cells(split(meshes.renumbered(data, rng), [0.2, 0.4]))))

    def test_values_that_were_not_given_are_zero(self):
        self.assertEqual(some_values_given(nephoscope.vtkContourCellSplitter()), [5, 0, 0, 0, 0, 2])

    def test_abort_gives_nothing(self):
        def abort(made):
            made.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
        self.assertEqual(split(large()[0], [0.2], setup=abort).GetNumberOfCells(), 0)

    def test_progress_rises_to_one(self):
        seen = []
        split(large()[0], [0.2], setup=lambda m: m.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress())))
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1.0)
        self.assertGreater(len(seen), 5)

    def test_changed_values_run_again_and_nothing_else_does(self):
        runs, made = [], nephoscope.vtkContourCellSplitter()
        made.SetInputData(large()[0])
        made.SetInputArrayToProcess(0, 0, 0, 0, "s")
        made.AddObserver("StartEvent", lambda *_: runs.append(1))
        made.GenerateValues(3, -0.5, 0.5)
        self.assertEqual([made.GetValue(i) for i in range(made.GetNumberOfContours())], [-0.5, 0, 0.5])
        for _ in range(2):
            made.Update()
        self.assertEqual(len(runs), 1)
        made.SetValue(1, 0.1)
        made.Update()
        self.assertEqual(len(runs), 2)

    def test_pieces_of_the_pieces(self):
        """Split by one array, then by another: the cell array Layer is replaced, and that is said."""
        data = meshes.with_field(Lattice(3).mesh("tetra", centred), wavy)
        meshes.add_array(data.GetPointData(), meshes.points_of(data)[:, 0], "x")
        once = split(data, [0.2], GenerateSurfaces=False)
        twice = Cells(split(once, [0.1], "x", expect=["'Layer' of the input has been replaced", "'ContourIndex' of the input"]))
        x = twice.array("x", points=True)
        for i in np.flatnonzero(twice.solid):
            self.assertTrue(x[twice.ids[i]].max() <= 0.1 or x[twice.ids[i]].min() >= 0.1)
        self.assertAlmostEqual(twice.volumes().sum(), 8, places=12)


if __name__ == "__main__":
    unittest.main()
