# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of which only some have the array that a filter works on are no error; where none has it, there is one."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.messages import Messages
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkDataObject, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection

TETRAHEDRON = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)


def multi_block(blocks):
    group = vtkMultiBlockDataSet()
    for i, block in enumerate(blocks):
        group.SetBlock(i, block)
    return group


def collection(blocks):
    group = vtkPartitionedDataSetCollection()
    for i, block in enumerate(blocks):
        group.SetPartition(i, 0, block)
    return group


def image(place, **arrays):
    """3 x 3 x 3 points; each array is constant, or a function of the points."""
    data = meshes.image((2, 2, 2), origin=(3 * place, 0, 0))
    for name, value in arrays.items():
        points = meshes.points_of(data)
        meshes.add_array(data.GetPointData(), value(points) if callable(value) else np.full(len(points), value), name)
    return data


def smoke(**arrays):
    data = meshes.grid(TETRAHEDRON, [(VTK_TETRA, range(4))])
    for name, value in arrays.items():
        meshes.add_array(data.GetCellData(), np.full(1, value), name)
    return data


def height(points):
    return points[:, 2]


def chosen(filter_, name="s"):
    filter_.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    return filter_


def contoured(class_):
    filter_ = chosen(class_())
    filter_.SetValue(0, 0.5)
    return filter_


def smoothing():
    filter_ = nephoscope.vtkStructuredSmoothing()
    filter_.AddArrayName("s")
    return filter_


# The filter; a block with its array and one without; what becomes of the latter beside the former; the message if no block has the array.
LEFT_OUT, PASSED_ON, CLEAR_AIR = "left out", "passed on", "clear air"
FIELD, OTHER = image(0, s=height), image(1, other=height)
WATER = image(0, clwc=1e-4, t=280.0, p=9e4)
CASES = {
    "ContourCellSplitter": (lambda: contoured(nephoscope.vtkContourCellSplitter), FIELD, OTHER, LEFT_OUT, "no point array 's' to split"),
    "active scalars": (nephoscope.vtkContourCellSplitter, FIELD, OTHER, LEFT_OUT, "no point array of the active scalars"),
    "nothing chosen": (lambda: chosen(nephoscope.vtkContourCellSplitter(), ""), FIELD, image(1), LEFT_OUT, "no point array of the active scalars"),
    "CloudSurface": (lambda: contoured(nephoscope.vtkCloudSurface), FIELD, OTHER, LEFT_OUT, "no point array 's'"),
    "StructuredSmoothing": (lambda: chosen(nephoscope.vtkStructuredSmoothing()), FIELD, OTHER, PASSED_ON, "no point array 's'"),
    "names of arrays": (smoothing, FIELD, OTHER, PASSED_ON, "no point array 's'"),
    "CloudOptics": (nephoscope.vtkCloudOptics, WATER, OTHER, PASSED_ON, "no array of cloud water"),
    "Sunlight": (nephoscope.vtkSunlight, image(0, Extinction=0.1), OTHER, CLEAR_AIR, "no array 'Extinction'"),
    "SmokePuffs": (nephoscope.vtkSmokePuffs, smoke(Density=1.0, Age=1.0), smoke(other=1.0), LEFT_OUT, "no numeric array 'Density'"),
}
FIELD.GetPointData().SetActiveScalars("s")


def arrays_of(block):
    """Names of all arrays but those that the filter may have made."""
    return {attributes.GetArrayName(i) for attributes in (block.GetPointData(), block.GetCellData()) for i in range(attributes.GetNumberOfArrays())}


class BlocksWithArray(unittest.TestCase):
    def executed(self, make, blocks, group):
        """The leaves of the output in the order of the blocks, None for what is not there, and the messages of two updates."""
        filter_ = make()
        filter_.SetInputDataObject(group(blocks))
        with Messages() as messages:
            filter_.Update()
            filter_.Modified()
            first = len(messages.errors)
            filter_.Update()
        output = filter_.GetOutputDataObject(0)
        leaf = output.GetBlock if hasattr(output, "GetBlock") else lambda i: output.GetPartition(i, 0)
        return filter_, [leaf(i) for i in range(len(blocks))], messages, first

    def test_some_have_it(self):
        for name, (make, having, lacking, fate, _) in CASES.items():
            for group in (multi_block, collection):
                for order in (1, -1):
                    with self.subTest(filter=name, group=group.__name__, order=order):
                        filter_, leaves, messages, _ = self.executed(make, [having, lacking][::order], group)
                        self.assertEqual(messages.errors, [])
                        self.assertEqual(bool(messages.warnings), fate == CLEAR_AIR)
                        self.assertEqual(filter_.GetErrorCode(), 0)
                        good, other = leaves[::order]
                        self.assertGreater(good.GetNumberOfCells(), 0)
                        there = other is not None and other.GetNumberOfCells() > 0
                        self.assertEqual(there, fate != LEFT_OUT)
                        if fate == PASSED_ON:
                            self.assertEqual(arrays_of(other), arrays_of(lacking))

    def test_none_has_it(self):
        for name, (make, _, lacking, _, expected) in CASES.items():
            for group in (multi_block, collection):
                with self.subTest(filter=name, group=group.__name__):
                    filter_, leaves, messages, first = self.executed(make, [lacking] * 3, group)
                    self.assertEqual(first, 1, messages.errors)
                    self.assertIn(expected, messages.errors[0])
                    self.assertIn("No other block has it either.", messages.errors[0])
                    self.assertNotEqual(filter_.GetErrorCode(), 0)
                    self.assertEqual([leaf.GetNumberOfCells() for leaf in leaves if leaf], [0] * sum(leaf is not None for leaf in leaves))

    def test_array_on_cells_of_one_block(self):
        """Is told, because it is not left out for want of the array."""
        on_cells = image(1)
        meshes.add_array(on_cells.GetCellData(), np.arange(8.0), "s")
        for name in ("ContourCellSplitter", "CloudSurface", "StructuredSmoothing"):
            _, _, messages, first = self.executed(CASES[name][0], [FIELD, on_cells, OTHER], multi_block)
            self.assertEqual(first, 1, messages.errors)
            self.assertIn("It is on cells", messages.errors[0])


if __name__ == "__main__":
    unittest.main()
