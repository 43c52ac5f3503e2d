# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hausdorff distance from the boundary of a flow volume to that of the smoke, as densely seeded particles."""
import numpy as np
from vtkmodules.vtkFiltersModeling import vtkHausdorffDistancePointSetFilter, vtkLinearSubdivisionFilter

from .known_flows import lattice, polygons


def outline(corners, count):
    """`count` points along each side of the triangle."""
    share = np.arange(count)[:, None] / count
    return np.concatenate([a + share * (b - a) for a, b in zip(corners, np.roll(corners, -1, axis=0))])


def sheet(rows, columns, first):
    """Triangles between rows of points in rings."""
    i, j = (index.ravel() for index in np.mgrid[:rows - 1, :columns])
    a, b = first + i * columns + j, first + i * columns + (j + 1) % columns
    return np.concatenate([np.column_stack([a, b, b + columns]), np.column_stack([a, b + columns, a + columns])])


def surface_of_particles(flow, per_side=48, layers=512):
    """Where the outline, the triangle at the start and that at the end are, in the true flow."""
    sides = flow.paths(outline(flow.corners, per_side), np.linspace(0, 1, layers + 1)).reshape(-1, 3)
    base, triangles = lattice(flow.corners, per_side)
    top = flow.paths(base, [1.0])[0]
    faces = [sheet(layers + 1, 3 * per_side, 0), triangles + len(sides), triangles + len(sides) + len(base)]
    return polygons(np.concatenate([sides, base, top]), np.concatenate(faces))


def boundary_of(smoke, subdivisions):
    """The boundary of the tetrahedra, every triangle as 4^subdivisions flat parts, so that places between corners count too."""
    faces = smoke.boundary()
    used, faces = np.unique(faces, return_inverse=True)
    divide = vtkLinearSubdivisionFilter()
    divide.SetNumberOfSubdivisions(subdivisions)
    divide.SetInputData(polygons(smoke.points[used], faces.reshape(-1, 3)))
    divide.Update()
    return divide.GetOutput()


def hausdorff_distance(smoke, particles, subdivisions=2):
    """The largest distance of a point of either surface from the triangles of the other."""
    distance = vtkHausdorffDistancePointSetFilter()
    distance.SetInputData(0, boundary_of(smoke, subdivisions))
    distance.SetInputData(1, particles)
    distance.SetTargetDistanceMethodToPointToCell()
    distance.Update()
    return distance.GetHausdorffDistance()
