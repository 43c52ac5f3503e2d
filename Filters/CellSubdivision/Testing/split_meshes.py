# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes for the splitter beyond those of nephoscope_testing.meshes: polyhedra, prisms, a pole, a refined corner."""
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.meshes import Lattice
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_HEXAGONAL_PRISM, VTK_HEXAHEDRON, VTK_POLYHEDRON, vtkUnstructuredGrid

OUTWARD = [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)]


def wavy(points):
    """A scalar from about -1.9 to 1.9 in [-1, 1]^3 that is nowhere linear."""
    x, y, z = np.asarray(points).T
    return np.sin(2.3 * x + 0.3) + y * z + 0.6 * np.cos(3 * y + z)


def with_sources(data):
    meshes.add_array(data.GetCellData(), np.arange(data.GetNumberOfCells()), "Source")
    return data


def grid_of(points, cells):
    """cells: (type, ids), for polyhedra the ids are a list of faces."""
    result = vtkUnstructuredGrid()
    result.SetPoints(meshes.vtk_points(points))
    for kind, ids in cells:
        if kind == VTK_POLYHEDRON:
            stream = vtkIdList()
            stream.InsertNextId(len(ids))
            for face in ids:
                for i in (len(face), *face):
                    stream.InsertNextId(int(i))
            result.InsertNextCell(VTK_POLYHEDRON, stream)
        else:
            result.InsertNextCell(kind, len(ids), [int(i) for i in ids])
    return result


def hexahedra_as_polyhedra(blocks, warp=None, every=1, flip=False):
    """A lattice; every n-th hexahedron as a polyhedron. flip: its first face turns the wrong way."""
    lattice, cells = Lattice(blocks), []
    for number, block in enumerate(lattice.all_blocks()):
        ids = lattice.ids(block)
        faces = [[ids[k] for k in face] for face in OUTWARD]
        if flip:
            faces[0] = faces[0][::-1]
        cells.append((VTK_POLYHEDRON, faces) if number % every == 0 else (VTK_HEXAHEDRON, ids))
    return grid_of(warp(lattice.points) if warp else lattice.points, cells)


def refined():
    """Two unit cubes side by side; one is eight hexahedra, so the other, a polyhedron, has four faces in one plane. Its least
    vertex is in that plane."""
    small = Lattice(2)
    points = [tuple(p) for p in small.points + [1, 0, 0]]
    left = [points.append(p) or len(points) - 1 for p in ((0, 0, 0), (0, 1, 0), (0, 0, 1), (0, 1, 1))]
    at = lambda y, z: points.index((1, y, z))
    a, b, c, d = left  # (y, z) = 00, 10, 01, 11
    faces = [[a, c, d, b],
             [a, at(0, 0), at(0, .5), at(0, 1), c], [b, d, at(1, 1), at(1, .5), at(1, 0)],
             [a, b, at(1, 0), at(.5, 0), at(0, 0)], [c, at(0, 1), at(.5, 1), at(1, 1), d]]
    for y in (0, .5):
        for z in (0, .5):
            faces.append([at(y, z), at(y + .5, z), at(y + .5, z + .5), at(y, z + .5)])
    cells = [(VTK_POLYHEDRON, faces)] + [(VTK_HEXAHEDRON, small.ids(block)) for block in small.all_blocks()]
    return grid_of((np.array(points) - [1, .5, .5]) * [-1, -1, 1], cells)


def honeycomb(polyhedra):
    """Seven hexagonal columns, two high, as prisms or as polyhedra."""
    points, index, cells = [], {}, []

    def point(x, y, z):
        key = (round(x * 1e6), round(y * 1e6), z)
        if key not in index:
            index[key] = len(points)
            points.append((x, y, z))
        return index[key]

    centres = [(0, 0)] + [(np.sqrt(3) * np.cos(np.pi * (k / 3 + 1 / 6)), np.sqrt(3) * np.sin(np.pi * (k / 3 + 1 / 6))) for k in range(6)]
    for cx, cy in centres:
        for layer in range(2):
            low, high = ([point(cx + np.cos(np.pi * k / 3), cy + np.sin(np.pi * k / 3), float(z)) for k in range(6)]
                         for z in (layer, layer + 1))
            sides = [[low[k], low[(k + 1) % 6], high[(k + 1) % 6], high[k]] for k in range(6)]
            cells.append((VTK_POLYHEDRON, [low[::-1], high] + sides) if polyhedra else (VTK_HEXAGONAL_PRISM, low + high))
    return grid_of(np.array(points) * [0.4, 0.4, 0.9] - [0, 0, 0.9], cells)


def pole():
    """A structured grid round an axis: its hexahedra there have an edge that is one place."""
    def warp(p):
        r, turn = p[:, 0], 0.9 * np.pi * p[:, 1]
        return np.column_stack([r * np.cos(turn), r * np.sin(turn), 2 * p[:, 2] - 1])
    return meshes.structured((3, 4, 3), warp)


def centred(p):
    return 2 * p - 1
