#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A grid in blocks is smoothed and contoured as the whole grid is: the same values, the same surface, no crack."""
import itertools
import unittest

import numpy as np
from nephoscope import vtkCloudSurface, vtkStructuredSmoothing
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkRectilinearGrid,
                                           vtkStructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkFeatureEdges, vtkMassProperties

PASSES = 2
WHOLE = ((0, 14), (0, 12), (0, 10))
CUTS = ((0, 6, 14), (0, 5, 12), (0, 6, 10))
THIN = ((0, 6, 14), (0, 3, 12), (0, 1, 10))


def blob(points):
    """Steep and lumpy, above 0.5 well inside the grid."""
    x, y, z = ((points - (7.2, 6.1, 5.3)) / (4.5, 4, 3.4)).T
    return 1.2 - np.sqrt(x * x + y * y + z * z) + 0.15 * np.sin(7 * x) * np.cos(9 * y + 5 * z)


def image(extent, own_indices):
    low = [first for first, _ in extent]
    grid = vtkImageData()
    grid.SetExtent(*(e for first, last in extent for e in ((0, last - first) if own_indices else (first, last))))
    grid.SetOrigin(low if own_indices else (0, 0, 0))
    return grid


def rectilinear(extent, _):
    grid = vtkRectilinearGrid()
    grid.SetDimensions(*(last - first + 1 for first, last in extent))
    for (first, last), put in zip(extent, (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates)):
        put(numpy_to_vtk(np.arange(first, last + 1.0), deep=1))
    return grid


def structured(extent, own_indices):
    grid = vtkStructuredGrid()
    grid.SetExtent(*(e for first, last in extent for e in ((0, last - first) if own_indices else (first, last))))
    like = image(extent, False)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.array([like.GetPoint(i) for i in range(like.GetNumberOfPoints())]), deep=1))
    grid.SetPoints(points)
    return grid


def with_field(grid):
    points = np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])
    for name, values in (("height", points[:, 2]), ("cloud", blob(points))):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid


def in_blocks(make, own_indices, group=vtkMultiBlockDataSet, cuts=CUTS):
    blocks = group()
    put = blocks.SetBlock if group is vtkMultiBlockDataSet else blocks.SetPartition
    for number, parts in enumerate(itertools.product(*(zip(along, along[1:]) for along in cuts))):
        put(number, with_field(make(parts, own_indices)))
    return blocks


def leaves(group):
    blocks = group.NewIterator()
    while not blocks.IsDoneWithTraversal():
        yield blocks.GetCurrentDataObject()
        blocks.GoToNextItem()


def surface_of(data):
    surface = vtkCloudSurface()
    surface.SetInputDataObject(data)
    surface.SetInputArrayToProcess(0, 0, 0, 0, "cloud")
    surface.SetValue(0, 0.5)
    surface.SetNumberOfSmoothingIterations(PASSES)
    surface.Update()
    return surface.GetOutputDataObject(0)


def joined(group):
    append = vtkAppendPolyData()
    for leaf in leaves(group):
        append.AddInputData(leaf)
    clean = vtkCleanPolyData()
    clean.SetInputConnection(append.GetOutputPort())
    clean.SetAbsoluteTolerance(1e-5)
    clean.ToleranceIsAbsoluteOn()
    clean.Update()
    return clean.GetOutput()


def open_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def volume_and_area(surface):
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    mass.Update()
    return mass.GetVolume(), mass.GetSurfaceArea()


def by_place(surface):
    """Points, normals and heights in an order of their own."""
    data = surface.GetPointData()
    rows = np.hstack([vtk_to_numpy(surface.GetPoints().GetData()), vtk_to_numpy(data.GetArray("Normals")),
                      vtk_to_numpy(data.GetArray("height"))[:, None]]).astype(float)
    return rows[np.lexsort(np.round(rows[:, :3], 3).T)]


class AbuttingBlocks(unittest.TestCase):
    kinds = [(image, True), (image, False), (rectilinear, True), (structured, True), (structured, False)]

    def test_surface(self):
        whole = surface_of(with_field(image(WHOLE, False)))
        self.assertEqual(open_edges(whole), 0)
        for group in (vtkMultiBlockDataSet, vtkPartitionedDataSet):
            for make, own_indices in self.kinds:
                with self.subTest(make.__name__, own_indices=own_indices, group=group.__name__):
                    surface = joined(surface_of(in_blocks(make, own_indices, group)))
                    self.assertEqual(open_edges(surface), 0)
                    np.testing.assert_allclose(volume_and_area(surface), volume_and_area(whole), rtol=1e-6)
                    self.assertEqual(surface.GetNumberOfPoints(), whole.GetNumberOfPoints())
                    np.testing.assert_allclose(by_place(surface), by_place(whole), atol=2e-5)

    def test_smoothing(self):
        smoothing = vtkStructuredSmoothing()
        smoothing.SetInputArrayToProcess(0, 0, 0, 0, "cloud")
        smoothing.SetNumberOfIterations(PASSES)
        smoothing.SetConservative(True)
        smoothing.SetGenerateMassArray(True)
        smoothing.SetInputDataObject(with_field(image(WHOLE, False)))
        smoothing.Update()
        whole = smoothing.GetOutputDataObject(0)
        for make, own_indices in self.kinds:
            with self.subTest(make.__name__, own_indices=own_indices):
                blocks = in_blocks(make, own_indices)
                smoothing.SetInputDataObject(blocks)
                smoothing.Update()
                for before, after in zip(leaves(blocks), leaves(smoothing.GetOutputDataObject(0))):
                    self.assertEqual(after.GetExtent(), before.GetExtent())
                    at = [whole.FindPoint(after.GetPoint(i)) for i in range(after.GetNumberOfPoints())]
                    for name in ("cloud", "Mass"):
                        np.testing.assert_allclose(vtk_to_numpy(after.GetPointData().GetArray(name)),
                                                   vtk_to_numpy(whole.GetPointData().GetArray(name))[at], atol=1e-12)

    def test_thin_blocks(self):
        """Thinner than the reach of the passes: a surface of every block, near that of the whole grid."""
        area = volume_and_area(surface_of(with_field(image(WHOLE, False))))[1]
        for make, own_indices in self.kinds:
            with self.subTest(make.__name__, own_indices=own_indices):
                surface = joined(surface_of(in_blocks(make, own_indices, cuts=THIN)))
                self.assertLess(abs(volume_and_area(surface)[1] / area - 1), 0.02)

    def test_hidden_cells_stay_hidden(self):
        blocks = in_blocks(structured, True)
        for leaf in leaves(blocks):
            flags = numpy_to_vtk(np.full(leaf.GetNumberOfCells(), vtkDataSetAttributes.HIDDENCELL, np.uint8), deep=1)
            flags.SetName(vtkDataSetAttributes.GhostArrayName())
            leaf.GetCellData().AddArray(flags)
            break
        surfaces = list(leaves(surface_of(blocks)))
        self.assertEqual(surfaces[0].GetNumberOfCells(), 0)
        self.assertTrue(all(surface.GetNumberOfCells() > 0 for surface in surfaces[1:]))

    def test_blocks_that_overlap_stay_alone(self):
        """Two grids of other steps in one box: each has the surface that it has by itself. It ended the program."""
        grids = []
        for size in ((5, 7, 5), (7, 5, 3)):
            grid = vtkRectilinearGrid()
            grid.SetDimensions(size)
            for put, count in zip((grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates), size):
                put(numpy_to_vtk(np.linspace(0, 1, count), deep=1))
            cloud = numpy_to_vtk(np.array([1 - np.hypot(*np.array(grid.GetPoint(i))[:2]) for i in range(grid.GetNumberOfPoints())]), deep=1)
            cloud.SetName("cloud")
            grid.GetPointData().AddArray(cloud)
            grids.append(grid)
        both = vtkMultiBlockDataSet()
        for number, grid in enumerate(grids):
            both.SetBlock(number, grid)
        for surface, grid in zip(leaves(surface_of(both)), grids):
            alone = surface_of(grid)
            self.assertGreater(alone.GetNumberOfPoints(), 10)
            np.testing.assert_array_equal(vtk_to_numpy(surface.GetPoints().GetData()), vtk_to_numpy(alone.GetPoints().GetData()))

    def test_blocks_with_other_arrays_stay_alone(self):
        """Names, types and components differ: no value is made up."""
        blocks = in_blocks(structured, True)
        for number, leaf in enumerate(leaves(blocks)):
            array = numpy_to_vtk(np.zeros((leaf.GetNumberOfPoints(), 1 + number % 3)), deep=1)
            array.SetName(f"a{number // 3}")
            leaf.GetPointData().AddArray(array)
        height = [vtk_to_numpy(leaf.GetPointData().GetArray("height")) for leaf in leaves(surface_of(blocks)) if leaf.GetNumberOfPoints()]
        self.assertTrue(all(values.min() >= 0 and values.max() <= 10 for values in height))


if __name__ == "__main__":
    unittest.main()
