# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images and particles to .vdb files and back."""
import os
import tempfile
import unittest

import nephoscope
import numpy as np
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

HAS_OPENVDB = nephoscope.vtkSparseVolumeReader.HasOpenVDB()


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def image(arrays, dimensions, first=(0, 0, 0), origin=(0, 0, 0), spacing=(1, 1, 1), direction=None, cells=None):
    """arrays: name -> values in the order of points, x fastest."""
    data = vtkImageData()
    extent = [value for n, f in zip(dimensions, first) for value in (f, f + n - 1)]
    data.SetExtent(extent)
    data.SetOrigin(origin)
    data.SetSpacing(spacing)
    if direction is not None:
        data.SetDirectionMatrix([float(v) for v in np.ravel(direction)])
    for name, values in arrays.items():
        add(data.GetPointData(), name, values)
    for name, values in (cells or {}).items():
        add(data.GetCellData(), name, values)
    return data


def particles(places, arrays=None):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places, float), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    for name, values in (arrays or {}).items():
        add(data.GetPointData(), name, values)
    return data


def places_of(data):
    return np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def values_of(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


class VdbTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.path = os.path.join(folder.name, "test.vdb")

    def run_quietly(self, work, expect):
        """expect: parts of the messages, in any order; there must be no others than those that have one."""
        with Messages() as messages:
            result = work()
        texts = [text for text in messages.all if "returned failure for request" not in text]
        for part in expect:
            self.assertTrue(any(part in text for text in texts), f"no message has '{part}', there are {texts}")
        for text in texts:
            self.assertTrue(any(part in text for part in expect), f"unexpected: {text}")
        return result

    def write(self, data, setup=lambda writer: None, expect=(), path=None):
        writer = nephoscope.vtkSparseVolumeWriter()
        writer.SetFileName(path or self.path)
        writer.SetInputData(data)
        setup(writer)
        return self.run_quietly(writer.Write, expect)

    def read(self, setup=lambda reader: None, expect=(), path=None, as_image=False):
        reader = nephoscope.vtkSparseVolumeReader()
        reader.SetFileName(path or self.path)
        if as_image:
            reader.SetOutputToImage()

        def work():
            setup(reader)
            reader.Update()

        self.run_quietly(work, expect)
        self.reader = reader
        return reader.GetOutputDataObject(0)
