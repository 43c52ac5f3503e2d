# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flows whose particles, volumes and fluxes are known, and flow volumes through the same triangle in each of them.

Nothing here is taken from the filter: particles move by the exponential of a matrix, or by small steps of their own.
"""
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from . import meshes
from .flow import flow_volume, update

TURN = 2 * np.pi


def series(matrix, terms):
    """The exponential series to the power `terms`: 1 is a step of Euler, 4 one of Runge-Kutta 4."""
    term = total = np.eye(len(matrix))
    for k in range(1, terms + 1):
        term = term @ matrix / k
        total = total + term
    return total


def exponential(matrix):
    return np.linalg.matrix_power(series(matrix / 64, 16), 64)


class PlanarFlow:
    """v = (M (x, y) + b, 1): linear, so exact on any grid. The triangle has flux 0.02."""
    corners = np.array([[0.3, 0.3, 0], [0.5, 0.3, 0], [0.3, 0.5, 0]])
    bounds = (-2, 2, -2, 2, -0.5, 1.5)
    flux = 0.02

    def __init__(self, name, matrix=((0, 0), (0, 0)), shift=(0, 0)):
        self.name, self.matrix = name, np.array(matrix, float)
        self.augmented = np.zeros((3, 3))  # of (x, y, 1)
        self.augmented[:2, :2], self.augmented[:2, 2] = matrix, shift

    def velocity(self, points):
        return np.column_stack([np.column_stack([points[:, :2], np.ones(len(points))]) @ self.augmented[:2].T, np.ones(len(points))])

    def paths(self, points, times):
        """Positions at all times, from t = 0: [time, point, coordinate]."""
        start = np.column_stack([points[:, :2], np.ones(len(points))])
        moved = np.array([start @ exponential(self.augmented * t).T for t in times])
        moved[..., 2] = points[None, :, 2] + np.asarray(times)[:, None]
        return moved

    def volume(self, time=1.0):
        """Q t; with divergence D: Q (exp(D t) - 1) / D."""
        divergence = np.trace(self.matrix)
        return self.flux * (np.expm1(divergence * time) / divergence if divergence else time)

    def layered_volume(self, steps, step_matrix=exponential):
        """Of `steps` layers with bilinear sides, joining what a step moves: the cross-section between is that of (1 - s) I + s R."""
        moved = step_matrix(self.matrix / steps)
        section = lambda s: np.linalg.det((1 - s) * np.eye(2) + s * moved)
        layer = (section(0) + 4 * section(0.5) + section(1)) / 6  # Simpson's rule is exact for a quadratic
        return self.flux / steps * layer * sum(np.linalg.det(moved)**k for k in range(steps))


class ABC:
    """Arnold, Beltrami and Childress with the square roots of 3, 2 and 1; divergence-free, not linear, chaotic."""
    name = "ABC"
    corners = np.array([[1, 1, 1], [1.2, 1, 1], [1, 1.2, 1]], float)
    bounds = (0.75, 3, 0.75, 3, 0.75, 3)  # for one second
    # The integral of w = sin y + sqrt(2) cos x over the triangle.
    flux = 0.2 * np.cos(1) - np.sin(1.2) + np.sin(1) + np.sqrt(2) * (np.cos(1) - np.cos(1.2) - 0.2 * np.sin(1))

    def velocity(self, points):
        x, y, z = points.T
        a, b = np.sqrt([3, 2])
        return np.column_stack([a * np.sin(z) + np.cos(y), b * np.sin(x) + a * np.cos(z), np.sin(y) + b * np.cos(x)])

    def paths(self, points, times, longest=1 / 512):
        """By Runge-Kutta 4 in steps of at most `longest`."""
        result, now = [], 0.0
        for time in times:
            count = max(int(np.ceil((time - now) / longest - 1e-9)), 1)
            for _ in range(count):
                points = self.step(points, (time - now) / count)
            now = time
            result.append(points)
        return np.array(result)

    def step(self, p, h):
        k1 = self.velocity(p)
        k2 = self.velocity(p + h / 2 * k1)
        k3 = self.velocity(p + h / 2 * k2)
        k4 = self.velocity(p + h * k3)
        return p + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

    def volume(self, time=1.0):
        return self.flux * time


UNIFORM = PlanarFlow("uniform")
OBLIQUE = PlanarFlow("oblique", shift=(0.7, -0.4))
SADDLE = PlanarFlow("saddle", ((1, 0), (0, -1)))
HELIX = PlanarFlow("helix", ((0, -TURN), (TURN, 0)))
SPREADING = PlanarFlow("(x, y, 1)", ((1, 0), (0, 1)))


def lattice(corners, n):
    """(points, triangles) of a triangle of n x n small ones."""
    number = {(i, j): k for k, (i, j) in enumerate((i, j) for j in range(n + 1) for i in range(n + 1 - j))}
    points = np.array([corners[0] + (corners[1] - corners[0]) * i / n + (corners[2] - corners[0]) * j / n for i, j in number])
    up = [(number[i, j], number[i + 1, j], number[i, j + 1]) for i, j in number if i + j < n]
    down = [(number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]) for i, j in number if i + j < n - 1]
    return points, np.array(up + down)


def polygons(points, cells):
    data, array = vtkPolyData(), vtkCellArray()
    for cell in cells:
        array.InsertNextCell(len(cell), [int(point) for point in cell])
    data.SetPoints(meshes.vtk_points(points))
    data.SetPolys(array)
    return data


def sampled(flow, blocks=2):
    """The velocity on an image of so many cells along each axis."""
    low, high = np.array(flow.bounds[::2], float), np.array(flow.bounds[1::2], float)
    data = meshes.image((blocks,) * 3, (high - low) / blocks, low)
    meshes.add_array(data.GetPointData(), flow.velocity(meshes.points_of(data)), "v")
    return data


def smoke_of(flow, steps, n, data=None, **settings):
    """t = 1 of smoke in `steps` layers, from n x n triangles; neither steps nor edges are divided further."""
    made = flow_volume(data or sampled(flow), **{"NormalToFlow": False, "PolygonEdgeLength": 10, "MaximumEdgeLength": 100,
                                                 "MaximumTurnAngle": 0, "Duration": 1, "TimeStep": 1 / steps,
                                                 "MaximumNumberOfTetrahedra": 10_000_000, **settings})
    producer = vtkTrivialProducer()
    producer.SetOutput(polygons(*lattice(flow.corners, n)))
    made.SetPolygonConnection(producer.GetOutputPort())
    smoke, messages = update(made)
    assert not messages, messages
    assert len(smoke.cells) == 3 * n * n * steps, "a step or an edge has been divided"
    return smoke


def layer_volumes(smoke):
    """Volume of the tetrahedra, by emission step."""
    return np.bincount(smoke.cell_array("EmissionStep"), smoke.volumes())


def fronts_of(smoke, steps):
    """The points, [layer, point, coordinate]."""
    return smoke.points[np.argsort(smoke.age, kind="stable")].reshape(steps + 1, -1, 3)


def triangles_of(smoke, points):
    """The triangles of the first front, which has so many points, as the first prisms show them."""
    first = smoke.cells[smoke.cell_array("EmissionStep") == 0] % points
    return np.array([np.unique(prism) for prism in first.reshape(-1, 12)])


def prism_volumes(fronts, triangles):
    """By layer, of prisms with bilinear sides: the integral of the section times the mean way of its corners, exact by Simpson's rule."""
    p, q = fronts[:-1, triangles], fronts[1:, triangles]  # [layer, triangle, corner, coordinate]
    way = (q - p).mean(axis=2)

    def section(s):
        c = (1 - s) * p + s * q
        return np.cross(c[:, :, 1] - c[:, :, 0], c[:, :, 2] - c[:, :, 0]) / 2
    area = (section(0) + 4 * section(0.5) + section(1)) / 6
    return np.abs((area * way).sum(axis=2)).sum(axis=1)


def bilinear_volumes(smoke, steps):
    fronts = fronts_of(smoke, steps)
    return prism_volumes(fronts, triangles_of(smoke, fronts.shape[1]))


def furthest_particle(smoke, flow, steps):
    """The largest distance of a point of the smoke from the particle of the true flow that left the polygon where it did."""
    fronts = fronts_of(smoke, steps)
    return np.linalg.norm(fronts - flow.paths(fronts[0], np.arange(steps + 1) / steps), axis=2).max()


def drift(smoke, flow, steps):
    """The largest difference of a layer's volume from flux times step, relative to that."""
    return np.abs(layer_volumes(smoke) * steps / flow.flux - 1).max()
