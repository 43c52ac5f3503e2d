# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes whose points coincide, to within rounding or exactly with other values, and meshes that rays enter many times: each tetrahedron
is drawn as it is given."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, cells_of, mapper
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

TRANSFER = Transfer([(0, 0.1, 0.3, 1), (0.4, 1, 0.8, 0.1), (1, 1, 0.1, 0.2)], [(0, 0.2), (0.5, 3), (1, 1)])


def globe(kind, shape=(24, 12, 2)):
    """Tetrahedra from pole to pole and around, radii 1 to 1.3; sines and cosines are those of the numpy type."""
    one = kind(1)
    longitude = np.linspace(0, 2 * kind(np.pi), shape[0] + 1, dtype=kind)
    latitude = np.linspace(-kind(np.pi) / 2, kind(np.pi) / 2, shape[1] + 1, dtype=kind)
    r, lat, lon = np.meshgrid(np.linspace(one, kind(1.3), shape[2] + 1, dtype=kind), latitude, longitude, indexing="ij")
    points = np.stack([r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)], axis=-1).reshape(-1, 3)
    grid = vtkStructuredGrid()
    grid.SetDimensions(shape[0] + 1, shape[1] + 1, shape[2] + 1)
    grid.SetPoints(meshes.vtk_points(points.astype(float)))
    split = vtkDataSetTriangleFilter()
    split.SetInputData(grid)
    split.Update()
    return meshes.with_field(split.GetOutput(), lambda p: 0.5 + 0.4 * np.sin(5 * p[:, 0]) * np.cos(4 * p[:, 1] + p[:, 2]))


def apart(data, rng=None, values=None):
    """Every tetrahedron with points of its own, and values of its own if there is a random generator."""
    points, count = meshes.points_of(data), data.GetNumberOfCells()
    ids = np.array([[data.GetCell(i).GetPointId(k) for k in range(4)] for i in range(count)])
    result = meshes.tetrahedra(points[ids.ravel()], np.arange(4 * count).reshape(-1, 4).tolist())
    meshes.add_array(result.GetPointData(), rng.uniform(0, 1, 4 * count) if rng else values(points)[ids.ravel()])
    return result


def with_extent(data):
    """The tetrahedra that are not flat, which the reference cannot have."""
    points, keep = meshes.points_of(data), []
    for i in range(data.GetNumberOfCells()):
        ids = [data.GetCell(i).GetPointId(k) for k in range(4)]
        a, b, c, d = points[ids]
        if abs(np.dot(np.cross(b - a, c - a), d - a)) > 1e-9:
            keep.append(ids)
    result = meshes.tetrahedra(points, keep)
    result.GetPointData().ShallowCopy(data.GetPointData())
    return result


class CoincidentPoints(ImageTestCase):
    def layers(self, data, most, label, **options):
        ours = self.check(data, TRANSFER, label, **options)[0]
        print(f"  {label}: {ours.GetNumberOfRayLayers()} layers")
        self.assertLessEqual(ours.GetNumberOfRayLayers(), most, label)

    def test_globes_are_entered_from_outside_and_inside(self):
        for kind in (np.float64, np.float32):
            data = globe(kind)
            window = Window((96, 96))
            scene, ours, cells = window.add_scene(), mapper(), cells_of(with_extent(data))
            volume = scene.add_volume(ours, data, TRANSFER)
            for direction in ((0.45, 0.3, 0.84), (0, 0, 1), (1, 0, 0), (0.02, -1, 0.03)):
                scene.look_at(volume, direction, (0, 1, 0) if abs(direction[1]) < 0.9 else (0, 0, 1))
                window.render()
                label = f"{kind.__name__} from {direction}"
                self.verify(scene, ours, cells, TRANSFER, label)
                print(f"  {label}: {ours.GetNumberOfRayLayers()} layers")
                self.assertLessEqual(ours.GetNumberOfRayLayers(), 4, label)

    def test_values_that_jump_at_every_face(self):
        data = apart(meshes.Lattice(4).mesh("tetra"), np.random.default_rng(3))
        self.layers(data, 2, "jumps")
        self.layers(data, 2, "jumps, eye inside", look=lambda s: s.look((0.41, 0.53, 0.37), (0.9, 0.2, -0.6), near=1e-3, far=5))

    def test_points_of_their_own_with_equal_values(self):
        data = apart(meshes.Lattice(4).mesh("tetra"), values=lambda p: np.sin(3 * p[:, 0] + p[:, 1]) ** 2)
        self.layers(data, 2, "apart")

    def test_cell_values(self):
        rng = np.random.default_rng(4)
        data = apart(meshes.Lattice(4).mesh("tetra"), rng)
        meshes.add_array(data.GetCellData(), rng.uniform(0, 1, data.GetNumberOfCells()))
        self.layers(data, 2, "cells", association="cell")

    def test_faces_without_extent(self):
        """Two tetrahedra that share a face, and one as flat as float has it on their side."""
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.9, 0.8, 0.7), (0.5, 0.5, 1e-9)])
        data = meshes.tetrahedra(points, [[0, 1, 2, 3], [1, 2, 3, 4], [0, 1, 2, 5]])
        meshes.with_field(data, lambda p: p[:, 0])
        self.layers(data, 3, "flat", look={"direction": (0.3, 0.4, -0.9)})


class ManyLayers(ImageTestCase):
    def stack(self, count, thickness):
        points, cells = [], []
        for k in range(count):
            part = meshes.Lattice(1).mesh("tetra", lambda p, k=k: p * (1, 1, thickness / count) + (0, 0, k / count))
            first = 8 * k
            points.append(meshes.points_of(part))
            cells += [[first + part.GetCell(i).GetPointId(j) for j in range(4)] for i in range(part.GetNumberOfCells())]
        return meshes.with_field(meshes.tetrahedra(np.vstack(points), cells), lambda p: 0.5 + 0.5 * np.sin(17 * p[:, 2] + 3 * p[:, 0]))

    def test_stacks_of_slabs(self):
        for count in (6, 40):
            data = self.stack(count, 0.6)
            for direction in ((0.2, 0.3, 0.9), (0.9, 0.3, 0.1)):
                ours = self.check(data, TRANSFER, f"{count} slabs from {direction}", look={"direction": direction}, size=(64, 64))[0]
                self.assertLessEqual(ours.GetNumberOfRayLayers(), 2 * count)

    def test_holes(self):
        rng = np.random.default_rng(8)
        whole = meshes.Lattice(6).mesh("tetra")
        keep = rng.uniform(size=whole.GetNumberOfCells()) < 0.6
        cells = [[whole.GetCell(i).GetPointId(k) for k in range(4)] for i in range(whole.GetNumberOfCells()) if keep[i]]
        data = meshes.with_field(meshes.tetrahedra(meshes.points_of(whole), cells), lambda p: p[:, 0] * p[:, 1])
        self.check(data, TRANSFER, "holes")
        self.check(data, TRANSFER, "holes, in parallel", look={"parallel": True})


if __name__ == "__main__":
    unittest.main(verbosity=2)
