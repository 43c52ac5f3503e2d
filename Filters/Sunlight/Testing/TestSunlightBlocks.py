# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds in several blocks have the light of all of them as one mesh, whatever their kinds and their order."""
import itertools
import unittest

import numpy as np
from lit import add, beside_sides, image, light_of, places, values
from nephoscope import vtkSunlight
from nephoscope_testing import meshes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkDataSetAttributes, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkPointDataToCellData
from vtkmodules.vtkFiltersGeneral import vtkImageDataToPointSet
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkExtractVOI

SIZE, SPACING = (13, 9, 9), 0.5
LIGHT = ("Sunlight", "ScaledExtinction", "SunTransmittance", "Irradiance", "UpwardIrradiance", "AbsorbedLight")
SUN = (2, 0.5, 1)
OPTICS = {"Albedo": 0.95}
ROUNDING = 2e-5  # of sums in another order
ABSORBED = 3e-4  # likewise: a difference of fluxes, divided by thin layers of the image


def clouds():
    return image(SIZE, (SPACING,) * 3, lambda x, y, z: 0.4 * np.maximum(0, np.sin(1.7 * x + 0.5) * np.cos(1.3 * y) * np.sin(0.8 * z)) + 0.01 * x)


def part(data, first, last):
    """Layers of an image from x = `first` to x = `last`, in cells."""
    cut = vtkExtractVOI()
    cut.SetInputData(data)
    cut.SetVOI(first, last, 0, SIZE[1] - 1, 0, SIZE[2] - 1)
    cut.Update()
    return cut.GetOutput()


def cells_of(data, precision=None):
    append = vtkAppendFilter()
    append.SetInputData(data)
    if precision is not None:
        append.SetOutputPointsPrecision(precision)
    append.Update()
    return append.GetOutput()


def merged(blocks):
    """One mesh with the cells of all, of the same types: VTK samples voxels and hexahedra with other rounding."""
    append = vtkAppendFilter()
    append.MergePointsOn()
    for block in blocks:
        append.AddInputData(block)
    append.Update()
    return append.GetOutput()


def structured(data):
    convert = vtkImageDataToPointSet()
    convert.SetInputData(data)
    convert.Update()
    return convert.GetOutput()


def on_cells(data):
    convert = vtkPointDataToCellData()
    convert.SetInputData(data)
    convert.Update()
    return convert.GetOutput()


def multi_block(blocks):
    group = vtkMultiBlockDataSet()
    for i, block in enumerate(blocks):
        group.SetBlock(i, block)
    return group


def collection(blocks):
    """All blocks as partitions of one dataset, but the last."""
    group = vtkPartitionedDataSetCollection()
    for i, block in enumerate(blocks[:-1]):
        group.SetPartition(0, i, block)
    group.SetPartition(1, 0, blocks[-1])
    return group


def lit(blocks, group=multi_block, sun=SUN, **options):
    """The leaves with their light, and the messages."""
    output, messages = light_of(group(blocks), sun, **{**OPTICS, **options})
    leaves = [output.GetBlock(i) for i in range(len(blocks))] if group is multi_block else \
        [output.GetPartition(0, i) for i in range(len(blocks) - 1)] + [output.GetPartition(1, 0)]
    return leaves, messages


def keys(output):
    return [tuple(place) for place in np.round(places(output), 4)]


def light_by_place(output, name):
    return dict(zip(keys(output), values(output, name)))


class Blocks(unittest.TestCase):
    def check(self, leaves, whole, tolerance=ROUNDING, names=LIGHT):
        for name in names:
            expected = light_by_place(whole, name)
            for leaf in leaves:
                np.testing.assert_allclose(values(leaf, name), [expected[place] for place in keys(leaf)],
                                           atol=max(tolerance, ABSORBED) if name == "AbsorbedLight" else tolerance, err_msg=name)

    def test_light_of_a_mesh_cut_in_parts(self):
        """Blocks of every kind have the light of the mesh, and keep their kind."""
        data = clouds()
        beam, _ = light_of(cells_of(data), SUN, **OPTICS)
        kinds = (lambda block: block, cells_of, structured, lambda block: cells_of(block, 0))  # the last in single precision
        for borders in ((0, 6, 12), (0, 3, 8, 12)):
            parts = [part(data, *ends) for ends in zip(borders, borders[1:])]
            for offset, group in zip(range(len(kinds)), itertools.cycle((multi_block, collection))):
                with self.subTest(borders=borders, first=offset, group=group.__name__):
                    blocks = [kinds[(offset + i) % len(kinds)](block) for i, block in enumerate(parts)]
                    leaves, messages = lit(blocks, group)
                    self.assertEqual(messages, [])
                    for block, leaf in zip(blocks, leaves):
                        self.assertEqual((leaf.GetClassName(), leaf.GetNumberOfCells(), keys(leaf)), (block.GetClassName(), block.GetNumberOfCells(), keys(block)))
                    self.check(leaves, light_of(merged(blocks), SUN, **OPTICS)[0])
                    self.check(leaves, beam, names=("ScaledExtinction", "SunTransmittance"))

    def test_extinction_on_cells(self):
        """Points between blocks have the mean of the cells of both."""
        data = on_cells(clouds())
        whole, _ = light_of(cells_of(data), SUN, **OPTICS)
        self.check(lit([cells_of(part(data, 0, 5)), part(data, 5, 12)])[0], whole)

    def test_order_of_blocks(self):
        data = clouds()
        blocks = [part(data, 0, 3), cells_of(part(data, 3, 8)), structured(part(data, 8, 12))]
        expected = {id(block): leaf for block, leaf in zip(blocks, lit(blocks)[0])}
        for order in ((2, 1, 0), (1, 2, 0)):
            for block, leaf in zip([blocks[i] for i in order], lit([blocks[i] for i in order])[0]):
                self.check([leaf], expected[id(block)])

    def test_discontinuous_blocks_keep_their_extinction(self):
        dense, thin = image((5, 5, 5), (1, 1, 1), lambda x, y, z: 1 + 0 * x), image((5, 5, 5), (1, 1, 1), lambda x, y, z: 0.01 + 0 * x, origin=(4, 0, 0))
        for blocks in ((dense, thin), (thin, dense)):
            for block, leaf in zip(blocks, lit(list(blocks), MultipleScattering=False)[0]):
                self.assertEqual(set(values(leaf, "ScaledExtinction")), set(np.float32(values(block, "Extinction"))))

    def test_one_block_alone(self):
        """Has exactly the light that it has without a block, beside empty blocks too."""
        for block, blocks_of in ((structured(clouds()), lambda block: ([block], [block, vtkUnstructuredGrid()])), (cells_of(clouds()), lambda block: ([None, block],))):
            whole, _ = light_of(block, SUN, **OPTICS)
            for blocks in blocks_of(block):
                leaf = lit(blocks)[0][blocks.index(block)]
                for name in LIGHT:
                    np.testing.assert_array_equal(values(leaf, name), values(whole, name), err_msg=name)

    def test_ghosts_do_not_count_twice(self):
        """Cells that finer blocks refine are left out."""
        data = clouds()
        whole, _ = light_of(cells_of(data), SUN, **OPTICS)
        for flag, make in ((vtkDataSetAttributes.DUPLICATECELL, cells_of), (vtkDataSetAttributes.REFINEDCELL, lambda block: block)):
            overlapping = make(part(data, 0, 8))
            meshes.add_array(overlapping.GetCellData(), np.where(centres(overlapping)[:, 0] > 6 * SPACING, flag, 0).astype(np.uint8), "vtkGhostType")
            self.check(lit([overlapping, part(data, 6, 12)])[0], whole)

    def test_shadow_across_a_gap(self):
        """A sheet of cloud in one block shades another, by exp(-optical depth)."""
        above, below = (image((5, 5, 3), (1, 1, 1), lambda x, y, z: 0.5 + 0 * x, origin=(0, 0, z)) for z in (10, 0))
        leaves, messages = lit([below, above], sun=(0, 0, 1), MultipleScattering=False)
        self.assertEqual(messages, [])
        depths = -np.log(values(leaves[0], "SunTransmittance"))
        np.testing.assert_allclose(depths, 0.5 * (2 - places(leaves[0])[:, 2]) + 1, atol=1e-5)
        np.testing.assert_allclose(-np.log(values(leaves[1], "SunTransmittance")), 0.5 * (12 - places(leaves[1])[:, 2]), atol=1e-5)

    def test_polyhedra(self):
        data = clouds()
        whole, _ = light_of(cells_of(data), SUN, **OPTICS)
        self.check(lit([polyhedra(part(data, 0, 6)), cells_of(part(data, 6, 12))])[0], whole, 0.02)  # divided in another way

    def test_shadow_of_blocks_on_the_ground(self):
        """Clouds in blocks shade a surface as those of the mesh do."""
        data = clouds()
        plane = vtkPlaneSource()
        plane.SetOrigin(-3, -1, -0.5)
        plane.SetPoint1(9, -1, -0.5)
        plane.SetPoint2(-3, 5, -0.5)
        plane.SetResolution(24, 12)
        plane.Update()
        ground = plane.GetOutput()
        whole = light_of(cells_of(data), SUN, **OPTICS)[0]
        expected, _ = light_of(ground, SUN, whole)
        self.assertGreater(np.ptp(values(expected, "Sunlight")), 0.1)
        blocks = light_of(multi_block([part(data, 0, 6), cells_of(part(data, 6, 12))]), SUN, **OPTICS)[0]
        found, messages = light_of(ground, SUN, blocks)
        self.assertEqual(messages, [])
        self.check([found], expected)
        leaf = light_of(multi_block([ground]), SUN, blocks)[0].GetBlock(0)
        self.check([leaf], expected)
        _, messages = light_of(ground, SUN, multi_block([data]))
        self.assertIn("The clouds have no array 'SunTransmittance'", "".join(messages))

    def test_another_eye_and_another_sun(self):
        """New settings or data give new light, not the one kept from before."""
        data = clouds()
        blocks = multi_block([part(data, 0, 6), cells_of(part(data, 6, 12))])
        light = vtkSunlight()
        light.SetInputDataObject(blocks)
        light.MultipleScatteringOff()
        for sun, eye in ((SUN, None), (SUN, (30, 0, 0)), ((-1, 0, 1), (30, 0, 0)), (SUN, None)):
            light.SetSunDirection(sun)
            light.SetUseViewPosition(eye is not None)
            light.SetViewPosition(eye or (0, 0, 0))
            light.Update()
            expected, _ = light_of(blocks, sun, MultipleScattering=False, UseViewPosition=eye is not None, ViewPosition=eye or (0, 0, 0))
            for i in (0, 1):
                np.testing.assert_array_equal(values(light.GetOutputDataObject(0).GetBlock(i), "Sunlight"), values(expected.GetBlock(i), "Sunlight"))

    def test_messages_are_told_once(self):
        data = clouds()
        blocks = [part(data, 0, 6), part(data, 6, 12)]
        for options, words in (({"sun": (0, 0, -1)}, "below the horizon"), ({"ExtinctionScale": 1e4}, "optical depth above"), ({"sun": (0, 0, 0)}, "SunDirection is")):
            messages = beside_sides(lit(blocks, **options)[1])
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(words, messages[0])
        negative = clouds()
        add(negative, "Extinction", np.where(np.arange(negative.GetNumberOfPoints()) == 0, -1, values(negative, "Extinction")))
        messages = beside_sides(lit([part(negative, 0, 6), part(negative, 6, 12)])[1])
        self.assertEqual(len(messages), 1, messages)
        self.assertIn("1 value of 'Extinction' negative", messages[0])


def centres(data):
    bounds = np.array([data.GetCell(c).GetBounds() for c in range(data.GetNumberOfCells())])
    return (bounds[:, ::2] + bounds[:, 1::2]) / 2


def polyhedra(data):
    """The voxels of an image as polyhedra."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for place in places(data):
        points.InsertNextPoint(place)
    grid.SetPoints(points)
    for c in range(data.GetNumberOfCells()):
        ids = [data.GetCell(c).GetPointId(i) for i in range(8)]
        stream = [6]
        for face in ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)):
            stream += [4] + [ids[i] for i in face]
        list_ = vtkIdList()
        for value in stream:
            list_.InsertNextId(value)
        grid.InsertNextCell(VTK_POLYHEDRON, list_)
    add(grid, "Extinction", vtk_to_numpy(data.GetPointData().GetArray("Extinction")))
    return grid


if __name__ == "__main__":
    unittest.main()
