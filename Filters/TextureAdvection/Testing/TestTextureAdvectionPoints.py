# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of port 1: they carry what the grid carries there, whether or not they come of the source of the winds."""
import unittest

import numpy as np
from nephoscope_testing.texture import DAY, Globe, add, advection, update
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkStructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkResampleToImage
from vtkmodules.vtkFiltersParallel import vtkPieceRequestFilter

HOUR = 3600.0
TIMES = np.arange(0, 31) * HOUR


def wind(unit, height, time):
    phase = 2 * np.pi * time / DAY
    axis = 1e-5 * np.array([np.cos(phase), np.sin(phase), 1.5])
    return np.cross(axis, unit), 0.0


class Exact(Globe):
    """Gives every time it is asked for, and fails after the last one."""

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(SDDP.UPDATE_TIME_STEP())
        if time > self.times[-1] or time < self.times[0]:
            return 0
        self.reads.append(time)
        grid = self.grid(time)
        output = vtkStructuredGrid.GetData(outputs)
        output.ShallowCopy(grid)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


class Sub(Exact):
    """Gives the piece that it is asked for."""

    def RequestInformation(self, request, inputs, outputs):
        outputs.GetInformationObject(0).Set(self.CAN_PRODUCE_SUB_EXTENT(), 1)
        return super().RequestInformation(request, inputs, outputs)

    def RequestData(self, request, inputs, outputs):
        made = super().RequestData(request, inputs, outputs)
        vtkStructuredGrid.GetData(outputs).Crop(outputs.GetInformationObject(0).Get(SDDP.UPDATE_EXTENT()))
        return made


def source(kind=Exact):
    return kind(wind, times=TIMES, columns=36, rows=19)


def clouds(winds):
    """A surface whose place depends on the time."""
    made = vtkContourFilter()
    made.SetInputConnection(winds.GetOutputPort())
    made.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Swell")
    made.SetValue(0, 0.3)
    return made


class Swelling(Exact):
    def grid(self, time):
        grid = super().grid(time)
        points = np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]) / self.radius
        add(grid, np.sin(3 * points[:, 0] + 5 * points[:, 2]) + time / (100 * HOUR), "Swell")
        return grid


class SwellingSub(Swelling, Sub):
    pass


def connected(winds, points):
    made = advection(winds)
    made.SetPointsConnection(points.GetOutputPort())
    return made


def piece_of(made, piece, time=7.25 * HOUR):
    request = vtkPieceRequestFilter()
    request.SetInputConnection(made.GetOutputPort())
    request.SetNumberOfPieces(3)
    request.SetPiece(piece)
    return update(request, time)


def check_same(test, first, second):
    test.assertEqual(first.output.GetNumberOfPoints(), second.output.GetNumberOfPoints())
    test.assertGreater(first.output.GetNumberOfPoints(), 100)
    for a, b in zip(first.sets, second.sets):
        np.testing.assert_array_equal(a, b)


class SharedSource(unittest.TestCase):
    def test_grid_on_both_ports(self):
        winds = source()
        made = connected(winds, winds)
        for time in (0, 5 * HOUR, 7.25 * HOUR, 29.9 * HOUR, 12 * HOUR):
            texture, messages = update(made, time)
            self.assertEqual(messages, [])
            expected, _ = update(advection(source()), time)
            for a, b in zip(texture.sets, expected.sets):
                np.testing.assert_allclose(a[:, 1:], b[:, 1:], atol=1e-7)
                np.testing.assert_allclose(np.exp(2j * np.pi * a[:, 0]), np.exp(2j * np.pi * b[:, 0]), atol=1e-6)

    def test_a_surface_of_the_grid_is_that_of_the_requested_time(self):
        winds = source(Swelling)
        surface = clouds(winds)
        made = connected(winds, surface)
        for time in (5 * HOUR, 7.25 * HOUR, 29.9 * HOUR, 6 * HOUR):
            texture, messages = update(made, time)
            self.assertEqual(messages, [])
            expected, _ = update(connected(source(), clouds(source(Swelling))), time)
            check_same(self, texture, expected)
            np.testing.assert_allclose(texture.point_array("Swell"), 0.3, atol=1e-6)

    def test_an_image_with_more_points_along_an_axis_than_the_grid(self):
        winds = source()
        image = vtkResampleToImage()
        image.SetInputConnection(winds.GetOutputPort())
        image.SetSamplingDimensions(60, 5, 5)
        texture, messages = update(connected(winds, image), 7.25 * HOUR)
        self.assertEqual(messages, [])
        self.assertEqual(texture.output.GetNumberOfPoints(), 60 * 5 * 5)

    def test_after_the_last_time_and_before_the_first(self):
        winds = source(Swelling)
        made = connected(winds, clouds(winds))
        for time, asked in ((31 * HOUR, 30 * HOUR), (-2 * HOUR, 0.0)):
            texture, messages = update(made, time)
            self.assertEqual(messages, [])
            self.assertEqual(winds.reads[-1], asked)
            self.assertGreater(len(texture.sets[0]), 100)

    def test_a_piece_of_the_surface_is_the_piece_that_was_there(self):
        for piece in range(3):
            winds = source(SwellingSub)
            surface = clouds(winds)
            texture, messages = piece_of(connected(winds, surface), piece)
            self.assertEqual(messages, [])
            self.assertEqual(winds.reads.count(7.25 * HOUR), 1)
            alone, _ = piece_of(clouds(source(SwellingSub)), piece)
            self.assertEqual(texture.output.GetNumberOfCells(), alone.output.GetNumberOfCells())
            np.testing.assert_array_equal(texture.point_array("Cloud"), alone.point_array("Cloud"))
            self.assertIsNotNone(texture.sets[0])


class OtherSource(unittest.TestCase):
    def test_winds_are_read_once_and_points_once_a_frame(self):
        winds, other = source(), source(Swelling)
        made = connected(winds, clouds(other))
        frames = (0, 5 * HOUR, 7.25 * HOUR)
        for time in frames:
            self.assertEqual(update(made, time)[1], [])
        self.assertEqual(winds.reads, list(TIMES[:9]))
        self.assertEqual(other.reads, list(frames))


if __name__ == "__main__":
    unittest.main()
