# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data with an analytic flow, spread over ranks in several ways."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_TETRA, vtkCellArray, vtkDataObject, vtkDataSetAttributes, vtkImageData,
                                           vtkMultiBlockDataSet, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP

CELLS = 16  # along each axis of [-1, 1]^3
A, B, C = np.sqrt(3.0), np.sqrt(2.0), 1.0


def abc(p):
    """The flow of Arnold, Beltrami and Childress."""
    x, y, z = 3.0 * np.asarray(p).T
    return np.stack([A * np.sin(z) + C * np.cos(y), B * np.sin(x) + A * np.cos(z), C * np.sin(y) + B * np.cos(x)], axis=1)


def helix(p):
    x, y, _ = np.asarray(p).T
    return np.stack([-2.0 * y, 2.0 * x, np.ones(len(p))], axis=1)


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    attributes.AddArray(array)


def lattice(extent):
    axes = [np.linspace(-1.0, 1.0, CELLS + 1)[extent[2 * a]:extent[2 * a + 1] + 1] for a in range(3)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)


def bend(p):
    """A curved copy of the cube, one to one."""
    x, y, z = p.T
    return np.stack([x + 0.15 * np.sin(2 * y), y + 0.1 * np.cos(2 * z), z + 0.1 * np.sin(3 * x + y)], axis=1)


def vtk_points(p):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(p), deep=1))
    return points


def fill(data, p, flow):
    """A velocity, and arrays of other types that must come along unchanged."""
    add(data.GetPointData(), "Flow", flow(p))
    add(data.GetPointData(), "Height", p[:, 2].astype(np.float32))
    add(data.GetPointData(), "Count", np.rint(1000 * p[:, 0]).astype(np.int64))


class Structured(VTKPythonAlgorithmBase):
    """An image or a curved grid that makes the part that it is asked for."""

    def __init__(self, kind, flow, on_cells=False, last_has_none=False):
        super().__init__(nInputPorts=0, outputType=kind)
        self.kind, self.flow, self.on_cells, self.last_has_none = kind, flow, on_cells, last_has_none

    def RequestInformation(self, _, __, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(SDDP.WHOLE_EXTENT(), (0, CELLS) * 3, 6)
        info.Set(self.CAN_PRODUCE_SUB_EXTENT(), 1)
        if self.kind == "vtkImageData":
            info.Set(vtkDataObject.ORIGIN(), (-1.0,) * 3, 3)
            info.Set(vtkDataObject.SPACING(), (2.0 / CELLS,) * 3, 3)
        return 1

    def RequestData(self, _, __, outputs):
        extent = outputs.GetInformationObject(0).Get(SDDP.UPDATE_EXTENT())
        data = vtkDataObject.GetData(outputs, 0)
        data.SetExtent(extent)
        if min(np.diff(extent)[::2]) < 0:
            return 1
        p = lattice(extent)
        if self.kind == "vtkImageData":
            data.SetOrigin(-1.0, -1.0, -1.0)
            data.SetSpacing(2.0 / CELLS, 2.0 / CELLS, 2.0 / CELLS)
        else:
            p = bend(p)
            data.SetPoints(vtk_points(p))
        if self.on_cells:
            centers = 0.5 * (lattice([e - i % 2 for i, e in enumerate(extent)]) +
                             lattice([e + 1 - i % 2 for i, e in enumerate(extent)]))
            add(data.GetCellData(), "Flow", self.flow(centers))
        else:
            fill(data, p, self.flow)
        info = outputs.GetInformationObject(0)
        if self.last_has_none and info.Get(SDDP.UPDATE_PIECE_NUMBER()) == info.Get(SDDP.UPDATE_NUMBER_OF_PIECES()) - 1:
            data.GetPointData().RemoveArray("Flow")
        return 1


def tetrahedra():
    """The bent cube as tetrahedra: points and corners."""
    n = CELLS + 1
    i, j, k = np.meshgrid(*[np.arange(CELLS)] * 3, indexing="ij")
    first = (i + n * (j + n * k)).ravel()
    ways = [(1, n, n * n), (n, 1, n * n), (1, n * n, n), (n, n * n, 1), (n * n, 1, n), (n * n, n, 1)]
    corners = np.concatenate([np.stack([first, first + a, first + a + b, first + a + b + c], axis=1) for a, b, c in ways])
    p = bend(lattice((0, CELLS) * 3))
    edges = p[corners[:, 1:]] - p[corners[:, :1]]
    left = np.linalg.det(edges) < 0
    corners[left] = corners[left][:, [0, 2, 1, 3]]
    return p, corners


def grid_of(p, corners, flow, ghost=None):
    used, ids = np.unique(corners, return_inverse=True)
    data = vtkUnstructuredGrid()
    data.SetPoints(vtk_points(p[used]))
    cells = vtkCellArray()
    for cell in ids.reshape(-1, 4).tolist():
        cells.InsertNextCell(4, cell)
    data.SetCells(VTK_TETRA, cells)
    fill(data, p[used], flow)
    if ghost is not None:
        add(data.GetCellData(), vtkDataSetAttributes.GhostArrayName(), ghost.astype(np.uint8))
    return data


class Unstructured(VTKPythonAlgorithmBase):
    """Tetrahedra in ragged parts: `part` tells the rank of each from its middle. `ghosts` adds copies of the other ranks'
    cells around, whose velocities are spoilt: they must not answer."""

    def __init__(self, flow, part, ghosts=False):
        super().__init__(nInputPorts=0, outputType="vtkUnstructuredGrid")
        self.flow, self.part, self.ghosts = flow, part, ghosts

    def RequestInformation(self, _, __, outputs):
        outputs.GetInformationObject(0).Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, _, __, outputs):
        info = outputs.GetInformationObject(0)
        piece, pieces = info.Get(SDDP.UPDATE_PIECE_NUMBER()), info.Get(SDDP.UPDATE_NUMBER_OF_PIECES())
        p, corners = tetrahedra()
        mine = self.part(p[corners].mean(axis=1), pieces) == piece
        if not mine.any():
            return 1
        output = vtkDataObject.GetData(outputs, 0)
        if not self.ghosts or pieces == 1:
            output.ShallowCopy(grid_of(p, corners[mine], self.flow))
            return 1
        near = np.isin(corners, corners[mine]).any(axis=1)
        ghost = np.where(mine[near], 0, vtkDataSetAttributes.DUPLICATECELL)
        output.ShallowCopy(grid_of(p, corners[near], self.flow, ghost))
        own = np.isin(np.unique(corners[near]), corners[mine])
        from vtkmodules.util.numpy_support import vtk_to_numpy
        vtk_to_numpy(output.GetPointData().GetArray("Flow"))[~own] *= 1.5
        return 1


def chessboard(middles, pieces):
    """Parts that meet each other everywhere."""
    return np.floor(3.0 * middles + 0.01).astype(int).sum(axis=1) % pieces


def slabs(middles, pieces):
    return np.clip(np.floor((middles[:, 0] + 1.0) / 2.0 * pieces).astype(int), 0, pieces - 1)


def last_alone(middles, pieces):
    """Everything on the last rank."""
    return np.full(len(middles), pieces - 1)


TIMES = (0.0, 0.4, 0.8, 1.2)


def turning(time):
    """abc, whose vectors turn about z with time."""
    c, s = np.cos(time), np.sin(time)
    return lambda p: abc(p) @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def changing(source):
    """The same source as a series of time steps, in each of which the flow is another."""
    class Series(type(source)):
        def RequestInformation(self, request, inputs, outputs):
            info = outputs.GetInformationObject(0)
            info.Set(SDDP.TIME_STEPS(), TIMES, len(TIMES))
            info.Set(SDDP.TIME_RANGE(), (TIMES[0], TIMES[-1]), 2)
            return super().RequestInformation(request, inputs, outputs)

        def RequestData(self, request, inputs, outputs):
            info = outputs.GetInformationObject(0)
            time = info.Get(SDDP.UPDATE_TIME_STEP()) if info.Has(SDDP.UPDATE_TIME_STEP()) else TIMES[0]
            self.flow = turning(time)
            done = super().RequestData(request, inputs, outputs)
            vtkDataObject.GetData(outputs, 0).GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
            return done
    source.__class__ = Series
    return source


class Blocks(VTKPythonAlgorithmBase):
    """Eight images, dealt to the ranks in turn; those of `missing`
    have no velocity, the upper four have an array that the others are without."""

    def __init__(self, flow, missing=()):
        super().__init__(nInputPorts=0, outputType="vtkMultiBlockDataSet")
        self.flow, self.missing = flow, missing

    def RequestInformation(self, _, __, outputs):
        outputs.GetInformationObject(0).Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, _, __, outputs):
        info = outputs.GetInformationObject(0)
        piece, pieces = info.Get(SDDP.UPDATE_PIECE_NUMBER()), info.Get(SDDP.UPDATE_NUMBER_OF_PIECES())
        output = vtkMultiBlockDataSet.GetData(outputs, 0)
        output.SetNumberOfBlocks(8)
        half = CELLS // 2
        for b in range(8):
            if b % pieces != piece:
                continue
            extent = [half * (((b >> (i // 2)) & 1) + i % 2) for i in range(6)]
            image = vtkImageData()
            image.SetExtent(extent)
            image.SetOrigin(-1.0, -1.0, -1.0)
            image.SetSpacing(2.0 / CELLS, 2.0 / CELLS, 2.0 / CELLS)
            fill(image, lattice(extent), self.flow)
            if b in self.missing:
                image.GetPointData().RemoveArray("Flow")
            if b >= 4:
                add(image.GetPointData(), "Upper", lattice(extent)[:, 0])
            output.SetBlock(b, image)
        return 1
