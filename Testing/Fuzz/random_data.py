# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Datasets at random, valid for VTK: some as they should be, some with degenerate cells, coincident or infinite points, NaN, any type of array."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPolyData,
                                           vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)

NAMES = ("s", "v", "cloud_fraction", "u", "TextureCoordinates1", "TextureWeights", "FlowVolumeDensity", "with space", "ü", "")
WEATHER = ("u", "v", "w", "t", "gh", "sp", "orog", "lsm", "cloud_fraction")
TYPES = ("int8", "uint8", "int16", "uint16", "int32", "int64", "float32", "float64", "float64", "float64")
ODD = (np.nan, np.inf, -np.inf, 0.0, 1e30, -1e30, 1e-300, 1e308)
CELLS = {1: 1, 3: 2, 5: 3, 8: 4, 9: 4, 10: 4, 11: 8, 12: 8, 13: 6, 14: 5, 15: 10, 16: 12, 24: 10, 25: 20}  # VTK's type: number of points
LATTICE = {12: ([0, 1, 3, 2, 4, 5, 7, 6],), 11: ([0, 1, 2, 3, 4, 5, 6, 7],), 13: ([0, 1, 2, 4, 5, 6], [1, 3, 2, 5, 7, 6]), 14: ([0, 1, 3, 2, 4],),
           10: ([0, 1, 2, 4], [1, 3, 2, 7], [1, 5, 7, 4], [2, 7, 6, 4], [1, 2, 4, 7])}  # cells of a voxel, by its corners


class Dice:
    """A random generator of one case; `odd` is rare in calm cases."""

    def __init__(self, seed):
        self.rng = np.random.default_rng(seed)
        self.wildness = self.rng.choice([0.05, 0.3, 1.0])

    def odd(self, probability):
        return self.rng.random() < probability * self.wildness

    def pick(self, choices):
        return choices[self.rng.integers(len(choices))]


# ---- arrays

def numbers(dice, shape):
    """Ordinary, or of another order of magnitude, constant, whole, or with values that are odd."""
    values = dice.rng.normal(size=shape)
    if dice.odd(0.4):
        values *= 10.0 ** dice.pick([6, -6, 20, -20])
    if dice.odd(0.2):
        values[...] = dice.pick([0.0, 1.0, 0.5, *ODD])
    if dice.odd(0.3) and values.size:
        values.flat[dice.rng.integers(values.size, size=min(values.size, 3))] = dice.pick(ODD)
    return np.round(values) if dice.odd(0.2) else values


def add_array(dice, attributes, tuples, name=None, components=None):
    name = dice.pick(NAMES) if name is None else name
    components = components or dice.pick([1, 1, 1, 3, 3, 2, 4, 9])
    if dice.odd(0.05):
        array = vtkStringArray()
        array.SetNumberOfTuples(tuples)
    else:
        with np.errstate(all="ignore"):
            values = numbers(dice, (tuples, components)).astype(dice.pick(TYPES) if dice.odd(0.5) else "float64")
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def fill(dice, data):
    """Scalars s, or those of weather, and vectors, on points or cells; other arrays and ghosts at random."""
    on_cells = dice.rng.random() < 0.2
    main, tuples = (data.GetCellData(), data.GetNumberOfCells()) if on_cells else (data.GetPointData(), data.GetNumberOfPoints())
    for name in WEATHER if dice.rng.random() < 0.3 or isinstance(data, vtkRectilinearGrid) else ():
        add_array(dice, main, tuples, name, 1)
    if not dice.odd(0.1):
        add_array(dice, main, tuples, "s", 1)
        add_array(dice, main, tuples, "velocity", 3)
        main.SetActiveScalars("s")
        main.SetActiveVectors("velocity")
    for attributes, count in ((data.GetPointData(), data.GetNumberOfPoints()), (data.GetCellData(), data.GetNumberOfCells())):
        for _ in range(dice.rng.integers(3)):
            add_array(dice, attributes, count)
        if dice.odd(0.2):
            ghosts = numpy_to_vtk(dice.rng.choice([0, 0, 0, 1, 2, 8, 16, 32], size=count).astype("uint8"), deep=True)
            ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
            attributes.AddArray(ghosts)
    if dice.odd(0.3):
        add_array(dice, data.GetFieldData(), int(dice.rng.integers(4)))
    return data


# ---- places

def sizes(dice):
    return [int(dice.pick([1, 2]) if dice.odd(0.3) else dice.rng.integers(3, 8)) for _ in range(3)]


def lattice(dice, dimensions):
    axes = np.meshgrid(*[np.arange(n) for n in dimensions[::-1]], indexing="ij")[::-1]
    return np.stack([axis.ravel() for axis in axes], 1) + 0.1 * dice.rng.normal(size=(int(np.prod(dimensions)), 3)) * (dice.rng.random() < 0.5)


def disturbed(dice, places):
    """Far, near, flat, coincident or not finite."""
    places = np.array(places, float)
    if dice.odd(0.4):
        places = places * 10.0 ** dice.pick([7, -7]) + dice.pick([0, 1e6])
    if dice.odd(0.3) and len(places):
        places[dice.rng.integers(len(places), size=len(places) // 2 + 1)] = places[0]
    if dice.odd(0.2):
        places[:, dice.rng.integers(3)] = 0
    if dice.odd(0.2) and len(places):
        places[dice.rng.integers(len(places)), dice.rng.integers(3)] = dice.pick(ODD)
    result = vtkPoints()
    result.SetData(numpy_to_vtk(np.ascontiguousarray(places, dice.pick(["float32", "float64"])), deep=True))
    return result


# ---- datasets

def image(dice):
    data = vtkImageData()
    data.SetDimensions(sizes(dice))
    data.SetOrigin(*dice.rng.normal(size=3))
    data.SetSpacing(*(0.1 + dice.rng.random(3)) * (dice.pick([0, 1e-9, 1e9]) if dice.odd(0.3) else 1))
    if dice.odd(0.3):
        data.SetDirectionMatrix(*dice.rng.choice([-1, 0, 1], size=9).astype(float))
    return data


def rectilinear(dice):
    """Often longitudes, latitudes and pressures."""
    data, dimensions = vtkRectilinearGrid(), sizes(dice)
    data.SetDimensions(dimensions)
    world = ((0, 360), (-90, 90), (1000, 100)) if dice.rng.random() < 0.6 else ((0, 1), (0, 2), (0, 3))
    for size, ends, put in zip(dimensions, world, (data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates)):
        axis = np.linspace(*ends, size)
        put(numpy_to_vtk(numbers(dice, size) if dice.odd(0.2) else axis, deep=True))
    return data


def curvilinear(dice):
    data, dimensions = vtkStructuredGrid(), sizes(dice)
    data.SetDimensions(dimensions)
    data.SetPoints(disturbed(dice, lattice(dice, dimensions)))
    return data


def cells(dice):
    """Cells of a lattice, of one or several types, some of them left out."""
    data, (nx, ny, nz) = vtkUnstructuredGrid(), (n + 1 for n in dice.rng.integers(1, 4, size=3))
    data.SetPoints(disturbed(dice, lattice(dice, (nx, ny, nz))))
    kinds = [dice.pick(list(LATTICE))] if dice.rng.random() < 0.7 else list(LATTICE)
    for start in (x + nx * (y + ny * z) for x in range(nx - 1) for y in range(ny - 1) for z in range(nz - 1)):
        corners = [start + a + nx * (b + ny * c) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
        kind = dice.pick(kinds)
        for cell in LATTICE[kind] if not dice.odd(0.2) else ():
            data.InsertNextCell(kind, len(cell), [corners[i] for i in cell])
    return data


def soup(dice):
    """Cells of any type with any points, polyhedra among them."""
    data, count = vtkUnstructuredGrid(), int(dice.pick([0, 1, 4, 8, 20, 40]))
    data.SetPoints(disturbed(dice, dice.rng.normal(size=(count, 3))))
    for _ in range(dice.rng.integers(30) if count else 0):
        if dice.odd(0.1):
            add_polyhedron(dice, data, count)
            continue
        kind = dice.pick(list(CELLS))
        data.InsertNextCell(kind, CELLS[kind], dice.rng.choice(count, size=CELLS[kind], replace=count < CELLS[kind] or dice.odd(0.3)).tolist())
    return data


def add_polyhedron(dice, data, count):
    faces, number = vtkIdList(), int(dice.rng.integers(1, 7))
    faces.InsertNextId(number)
    for _ in range(number):
        ids = dice.rng.integers(count, size=dice.rng.integers(1, 6))
        for one in (len(ids), *ids):
            faces.InsertNextId(int(one))
    data.InsertNextCell(42, faces)


def polygons(dice):
    """A surface of quadrilaterals, or any polygons."""
    data = vtkPolyData()
    data.AllocateEstimate(30, 4)
    if dice.odd(0.5):
        count = int(dice.pick([0, 1, 3, 10, 30]))
        data.SetPoints(disturbed(dice, dice.rng.normal(size=(count, 3))))
        for _ in range(dice.rng.integers(30) if count else 0):
            size = int(dice.rng.integers(1, 6))
            data.InsertNextCell({1: 1, 2: 3, 3: 5}.get(size, 7), size, dice.rng.integers(count, size=size).tolist())
        return data
    n = int(dice.rng.integers(2, 7))
    data.SetPoints(disturbed(dice, lattice(dice, (n, n, 1)) + dice.rng.normal(size=3) * 0.3))
    for corner in (x + n * y for x in range(n - 1) for y in range(n - 1)):
        data.InsertNextCell(9, 4, [corner, corner + 1, corner + n + 1, corner + n])
    return data


GRIDS = (image, rectilinear, curvilinear)
SOLIDS = (*GRIDS, cells, cells)
ALL = (*SOLIDS, soup, polygons)


def leaf(dice, kinds=SOLIDS):
    return fill(dice, dice.pick(ALL if dice.odd(0.3) else kinds)(dice))


def dataset(dice, kinds=SOLIDS):
    """Now and then in blocks, some of which may be missing."""
    if not dice.odd(0.3):
        return leaf(dice, kinds)
    multiple = dice.rng.random() < 0.5
    data = vtkMultiBlockDataSet() if multiple else vtkPartitionedDataSet()
    for i in range(dice.rng.integers(4)):
        block = leaf(dice, kinds)
        if multiple:
            data.SetBlock(i, None if dice.odd(0.2) else block)
        else:
            data.SetPartition(i, block)
    return data


def array_name(dice, data):
    """Mostly the name of an array that is there."""
    names = [attributes.GetArrayName(i) for attributes in (data.GetPointData(), data.GetCellData())
             for i in range(attributes.GetNumberOfArrays())] if hasattr(data, "GetPointData") else []
    return dice.pick(NAMES) if dice.odd(0.3) or not names else dice.pick(names)
