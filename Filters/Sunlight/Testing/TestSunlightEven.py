#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays through evenly spaced grids have the depths of rays that walk from tetrahedron to tetrahedron, for suns in special and other directions."""
import itertools
import pathlib
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from lit import add, light_of, places, values  # noqa: E402

rng = np.random.default_rng(1)
AXES = [sun for sun in itertools.product((-1, 0, 1), repeat=3) if any(sun)]
OTHERS = [tuple(rng.normal(size=3)) for _ in range(8)] + [(1e-13, 0, 1), (1, 2, 0.01), (2, 1, 0), (-0.3, 1, -1e-3)]
CORNERS = np.array(list(itertools.product((0, 1), repeat=3)))


def image(size, spacing=(1, 1, 1), start=(0, 0, 0)):
    data = vtkImageData()
    data.SetExtent([bound for first, n in zip(start, size) for bound in (first, first + n - 1)])
    data.SetSpacing(spacing)
    data.SetOrigin(10, -3, 2)
    return data


def levels(size, heights):
    data = vtkRectilinearGrid()
    data.SetDimensions(size)
    for place, coordinates in zip((data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates), (0.7 * np.arange(size[0]), 1.3 * np.arange(size[1]), heights)):
        place(numpy_to_vtk(np.asarray(coordinates, float), deep=1))
    return data


def sheared(size, steps):
    data = vtkStructuredGrid()
    data.SetDimensions(size)
    numbers = np.array([(i, j, k) for k, j, i in itertools.product(*(range(n) for n in reversed(size)))], float)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(numbers @ np.array(steps, float), deep=1))
    data.SetPoints(points)
    return data


def tetrahedra(data):
    """The tetrahedra of a grid: each cell has one between its even vertices and one at each odd vertex."""
    extent = np.array(data.GetExtent())
    size = extent[1::2] - extent[::2] + 1
    cells = np.stack(np.meshgrid(*(np.arange(n - 1) for n in size), indexing="ij"), -1).reshape(-1, 3)
    parity = (cells.sum(1) + extent[::2].sum()) % 2
    found = []
    for odd in (0, 1):
        here = cells[parity == odd]
        even = CORNERS[(CORNERS.sum(1) + odd) % 2 == 0]
        groups = [even] + [np.concatenate([[c], even[np.abs(even - c).sum(1) == 1]]) for c in CORNERS[(CORNERS.sum(1) + odd) % 2 == 1]]
        for group in groups:
            found.append((here[:, None] + group) @ [1, size[0], size[0] * size[1]])
    ids = np.concatenate(found)
    mesh = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places(data), deep=1))
    mesh.SetPoints(points)
    array = vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(np.arange(0, ids.size + 1, 4), deep=1), numpy_to_vtkIdTypeArray(ids.ravel(), deep=1))
    mesh.SetCells(VTK_TETRA, array)
    mesh.GetPointData().ShallowCopy(data.GetPointData())
    return mesh


class Even(unittest.TestCase):
    def check(self, data, suns):
        mesh = tetrahedra(data)
        for sun in suns:
            found, walked = (values(light_of(one, sun, MultipleScattering=False)[0], "SunTransmittance") for one in (data, mesh))
            self.assertLess(np.abs(found - walked).max(), 1e-5, sun)

    def test_grids(self):
        cases = {
            "odd start": image((7, 6, 5), (1, 0.5, 2), (1, 0, 2)),
            "even size": image((6, 6, 4), start=(-3, 2, -1)),
            "one cell": image((2, 2, 2)),
            "one cell wide": image((2, 9, 2)),
            "levels": levels((6, 5, 7), [0, 0.1, 0.3, 0.35, 1, 2, 4.5]),
            "levels downwards": levels((6, 5, 6), [5, 4, 2, 1.9, 0.5, 0]),
            "sheared": sheared((6, 7, 5), [(1, 0.2, 0.1), (0.3, 1, 0), (-0.2, 0.4, 0.8)]),
            "left-handed": sheared((6, 7, 5), [(0, 1, 0), (1, 0, 0), (0, 0, 1)]),
            "vertical first index": sheared((5, 6, 7), [(0, 0, 1), (1, 0, 0), (0, 1, 0)]),
        }
        for number, (name, data) in enumerate(cases.items()):
            extinction = 0.3 * rng.random(data.GetNumberOfPoints())
            extinction *= (1, 30, rng.random(extinction.size) < 0.2)[number % 3]  # thin, dark, with clear gaps
            add(data, "Extinction", extinction)
            with self.subTest(name):
                self.check(data, AXES + OTHERS)

    def test_parts_of_rows(self):
        """More points than one thread takes at a time, clear levels above and below."""
        data = image((41, 30, 8))
        extinction = 0.1 * rng.random((8, 30, 41))
        extinction[[0, 1, 6, 7]] = 0
        add(data, "Extinction", extinction.ravel())
        self.check(data, [(0, 0, 1), (1, 1, 0.2), (-0.7, 0.3, 0.5)])

    def test_uneven(self):
        """One point is out of line."""
        data = sheared((6, 7, 5), np.eye(3))
        data.GetPoints().SetPoint(100, np.array(data.GetPoint(100)) + [0, 0.3, 0])
        add(data, "Extinction", rng.random(210))
        self.check(data, OTHERS)


if __name__ == "__main__":
    unittest.main()
