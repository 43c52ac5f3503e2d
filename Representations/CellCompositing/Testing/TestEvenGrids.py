# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images, which rays cross by arithmetic and in leaps, look as the same tetrahedra in a list, which rays walk through one by one.

From anywhere, along axes and planes of the grid, from inside and from points of the grid; with functions that are clear somewhere.
"""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_TETRA, vtkCellArray, vtkDataSetAttributes, vtkImageData, vtkPlane, vtkPlaneCollection,
                                           vtkStructuredGrid, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersSources import vtkSphereSource

COLOURS = [(-1, 1, 0, 0), (0, 0.2, 1, 0.3), (1, 0, 0, 1)]
RAMP = Transfer(COLOURS, [(-1, 0), (1, 1)], unit_distance=2)
HIGH = Transfer(COLOURS, [(-1, 0), (0.6, 0), (1, 1)], unit_distance=1)
BAND = Transfer(COLOURS, [(-1, 0), (0.1, 0), (0.1, 0.5), (0.3, 0.5), (0.3, 0), (1, 0)], unit_distance=1)
SPIKE = Transfer(COLOURS, [(-1, 0), (0.2, 0), (0.2005, 1), (0.201, 0), (1, 0)], unit_distance=1e-2)
DENSE = Transfer(COLOURS, [(-1, 0), (-0.5, 0), (1, 1)], unit_distance=0.01)
FUNCTIONS = dict(ramp=RAMP, high=HIGH, band=BAND, spike=SPIKE, dense=DENSE)
# Position, focus, parallel scale or None.
VIEWS = dict(far=((30, 22, 15), (5, 4, 3), None), axis=((40, 4, 3), (5, 4, 3), None), plane=((5, 4, 40), (5, 4, 3), 6),
             beside_a_plane=((5, 4.5, 40), (5, 4.5, 3), 6), diagonal=((40, 40, 40), (4, 4, 4), 6), inside=((3.3, 2.2, 4.1), (9, 5, 2), None),
             on_a_point=((3, 2, 4), (9, 5, 2), None), on_a_face=((3, 2.5, 4.5), (3, 9, 5), None), at_a_corner=((0, 0, 0), (5, 4, 3), None))


def image(size=(11, 9, 8), extent_start=(0, 0, 0), spacing=(1, 1, 1), seed=3):
    """Smooth noise from -1 to 1; `extent_start` moves numbers and origin, so that the place does not change."""
    rng = np.random.default_rng(seed)
    coarse = rng.uniform(-1, 1, [n // 2 + 2 for n in size[::-1]])
    values = coarse.repeat(2, 0).repeat(2, 1).repeat(2, 2)[1:size[2] + 1, 1:size[1] + 1, 1:size[0] + 1] + rng.uniform(-0.1, 0.1, size[::-1])
    result = vtkImageData()
    result.SetExtent(*[e for start, n in zip(extent_start, size) for e in (start, start + n - 1)])
    result.SetSpacing(*spacing)
    result.SetOrigin(*[-s * h for s, h in zip(extent_start, spacing)])
    add(result.GetPointData(), values.ravel())
    return result


def add(attributes, values, name="s"):
    array = numpy_to_vtk(np.ascontiguousarray(values, np.float32), deep=1)
    array.SetName(name)
    attributes.AddArray(array)


def tetrahedra(data, keep=lambda i, j, k: True):
    """The tetrahedra of a chessboard's cells: one of the even vertices, four at the odd ones."""
    e = data.GetExtent()
    n = [e[2 * a + 1] - e[2 * a] + 1 for a in range(3)]
    lists, owners = [], []
    for k in range(n[2] - 1):
        for j in range(n[1] - 1):
            for i in range(n[0] - 1):
                if not keep(i, j, k):
                    continue
                number = [i + (c & 1) + n[0] * (j + (c >> 1 & 1) + n[1] * (k + (c >> 2 & 1))) for c in range(8)]
                first_is_odd = (i + j + k + e[0] + e[2] + e[4]) % 2
                even, odd = ((1, 2, 4, 7), (0, 3, 5, 6)) if first_is_odd else ((0, 3, 5, 6), (1, 2, 4, 7))
                lists.append([number[c] for c in even])
                lists += [[number[c], number[c ^ 1], number[c ^ 2], number[c ^ 4]] for c in odd]
                owners += 5 * [i + (n[0] - 1) * (j + (n[1] - 1) * k)]
    result, points, cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for p in range(data.GetNumberOfPoints()):
        points.InsertNextPoint(data.GetPoint(p))
    for t in lists:
        cells.InsertNextCell(4, t)
    result.SetPoints(points)
    result.SetCells(VTK_TETRA, cells)
    result.GetPointData().ShallowCopy(data.GetPointData())
    if data.GetCellData().HasArray("s"):
        source = data.GetCellData().GetArray("s")
        add(result.GetCellData(), [source.GetComponent(o, 0) for o in owners])
    return result


class Drawn:
    """A volume in a window of its own."""

    def __init__(self, data, association="point", settings=None):
        self.window = Window((60, 60))
        self.scene = self.window.add_scene()
        self.mapper = mapper()
        self.mapper.SetCellInterpolationToTetrahedra()
        self.mapper.SetMethodToRays()
        self.volume = self.scene.add_volume(self.mapper, data, HIGH, association=association)
        if settings:
            settings(self.scene, self.mapper, self.volume)

    def picture(self, transfer, view):
        position, focus, scale = view
        distance = np.linalg.norm(np.subtract(position, focus))
        up = (0, 1, 0) if abs(focus[1] - position[1]) < 0.9 * distance else (0, 0, 1)
        self.volume.SetProperty(transfer.volume_property())
        self.scene.camera.SetParallelProjection(scale is not None)
        self.scene.look(position, focus, up, 40, scale, near=0.01, far=100 + distance)
        self.window.render()
        return float_image(self.mapper)


class EvenGrids(unittest.TestCase):
    def assert_same(self, pair, transfer, view, label=None, rows=slice(None)):
        one, other = (drawn.picture(transfer, view)[rows] for drawn in pair)
        self.assertGreater(other[..., 3].max(), 0.01, label)
        differs = np.abs(one - other).max(axis=-1) > 1 / 255
        self.assertFalse(differs.any(), f"{label}: {differs.sum()} pixels, {np.argwhere(differs)[:5].tolist()}")
        self.assertEqual(pair[0].window.messages.all, [])

    def test_every_function_from_everywhere(self):
        data = image()
        pair = Drawn(data), Drawn(tetrahedra(data))
        for function, transfer in FUNCTIONS.items():
            # From points, faces and within planes the tetrahedra are seen from 4e-6 of the size beside, where a spike is not the same.
            names = ("far", "axis", "inside", "diagonal") if function == "spike" else VIEWS
            for name, view in ((name, VIEWS[name]) for name in names):
                with self.subTest(function=function, view=name):
                    # Rays within the plane of a side of the box have no one right value.
                    rows = slice(8, 47) if name == "beside_a_plane" else slice(None)
                    self.assert_same(pair, transfer, view, f"{function}, {name}", rows)

    def test_random_eyes(self):
        data = image()
        pair, rng = (Drawn(data), Drawn(tetrahedra(data))), np.random.default_rng(8)
        for number in range(40):
            view = (tuple(rng.uniform(-4, 14, 3)), tuple(rng.uniform(2, 6, 3)), None)
            with self.subTest(number=number):
                self.assert_same(pair, HIGH if number % 2 else RAMP, view, number)

    def test_numbers_that_start_elsewhere_and_thin_cells(self):
        for start in ((1, 0, 0), (-3, 5, 7), (2, -1, 1)):
            data = image(extent_start=start, spacing=(1, 0.5, 1.5))
            self.assert_same((Drawn(data), Drawn(tetrahedra(data))), HIGH, VIEWS["far"], start)

    def test_turned(self):
        data = image()
        s, c = np.sin(0.5), np.cos(0.5)
        data.SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, -1)
        self.assert_same((Drawn(data), Drawn(tetrahedra(data))), HIGH, VIEWS["far"])

    def test_evenly_spaced_structured_grid(self):
        data, grid = image(), vtkStructuredGrid()
        grid.SetExtent(data.GetExtent())
        points = vtkPoints()
        for p in range(data.GetNumberOfPoints()):
            x, y, z = data.GetPoint(p)
            points.InsertNextPoint(x + 0.3 * y, y, z - 0.2 * x)
        grid.SetPoints(points)
        grid.GetPointData().ShallowCopy(data.GetPointData())
        self.assert_same((Drawn(grid), Drawn(tetrahedra(grid))), HIGH, VIEWS["far"])

    def test_nearly_even_grid_is_drawn_as_it_is(self):
        data, grid = image(), vtkStructuredGrid()
        grid.SetExtent(data.GetExtent())
        points = vtkPoints()
        for p in range(data.GetNumberOfPoints()):
            x, y, z = data.GetPoint(p)
            points.InsertNextPoint(x, y, z + (0.3 if (x, y, z) == (5, 4, 3) else 0))
        grid.SetPoints(points)
        grid.GetPointData().ShallowCopy(data.GetPointData())
        self.assert_same((Drawn(grid), Drawn(tetrahedra(grid))), RAMP, VIEWS["far"])

    def test_missing_values(self):
        data = image()
        values = data.GetPointData().GetArray("s")
        listed = tetrahedra(image(), lambda i, j, k: not (i in (4, 5) and j in (2, 3) and k in (3, 4)))
        values.SetComponent(data.ComputePointId((5, 3, 4)), 0, float("nan"))
        one, other = Drawn(data), Drawn(listed)
        for name in ("far", "inside"):
            pictures = [drawn.picture(RAMP, VIEWS[name]) for drawn in (one, other)]
            np.testing.assert_allclose(*pictures, atol=1 / 255)

    def test_blanked_cells(self):
        data = image()
        ghosts = np.zeros((7, 8, 10), np.uint8)
        ghosts[2:4, 3:6, 4:8] = vtkDataSetAttributes.HIDDENCELL
        hidden = numpy_to_vtk(ghosts.ravel(), deep=1)
        hidden.SetName(vtkDataSetAttributes.GhostArrayName())
        data.GetCellData().AddArray(hidden)
        pair = Drawn(data), Drawn(tetrahedra(data, lambda i, j, k: not ghosts[k, j, i]))
        for name in ("far", "inside", "plane"):
            self.assert_same(pair, RAMP, VIEWS[name], name)

    def test_cell_data(self):
        data = image()
        add(data.GetCellData(), np.random.default_rng(2).uniform(-1, 1, data.GetNumberOfCells()))
        data.GetPointData().Initialize()
        pair = Drawn(data, "cell"), Drawn(tetrahedra(data), "cell")
        for name in ("far", "inside"):
            for transfer in (RAMP, HIGH):
                self.assert_same(pair, transfer, VIEWS[name], name)

    def test_surroundings_and_settings(self):
        data = image()
        listed = tetrahedra(data)

        def opaque(scene, _, __):
            ball = vtkSphereSource()
            ball.SetCenter(5, 4, 3)
            ball.SetRadius(2)
            ball.SetThetaResolution(40)
            ball.SetPhiResolution(40)
            ball.Update()
            scene.add_opaque(ball.GetOutput(), (1, 0, 1))

        def planes(_, made, __):
            collection, plane = vtkPlaneCollection(), vtkPlane()
            plane.SetOrigin(5, 4, 3.2)
            plane.SetNormal(0.3, -0.2, 1)
            collection.AddItem(plane)
            made.SetClippingPlanes(collection)

        def average(_, made, __):
            made.SetIntegrationToAverage()

        def uncut(_, made, __):
            made.SplitAtControlPointsOff()

        def haze(scene, _, __):
            air = nephoscope.vtkHaze()
            air.SetProjectionToMap()
            air.SetExtinction(0.03)
            air.SetScaleHeight(5)
            nephoscope.vtkHaze.SetHaze(scene.renderer, air)

        def contours(_, made, __):
            made.SetContourValue(0, -0.4)
            made.SetContourOpacity(0, 0.5)
            made.SmoothContourNormalsOff()  # those are from the edges of cells, and these cells have other edges

        for settings in (opaque, planes, average, uncut, haze, contours):
            pair = Drawn(data, settings=settings), Drawn(listed, settings=settings)
            for transfer in (HIGH, RAMP):
                self.assert_same(pair, transfer, VIEWS["far"], settings.__name__)

    def test_leaps_far(self):
        """One cloud in many clear cells."""
        data = image((21, 23, 17))
        values = np.full((17, 23, 21), -1.0)
        values[10:12, 20:22, 5:7] = 1
        add(data.GetPointData(), values.ravel())
        pair = Drawn(data), Drawn(tetrahedra(data))
        for position in ((20, 40, 25), (15.3, 10.1, 5.1), (5.5, 20.5, 30)):
            self.assert_same(pair, HIGH, (position, (5.5, 20.5, 10.5), None), position)


if __name__ == "__main__":
    unittest.main(verbosity=2)
