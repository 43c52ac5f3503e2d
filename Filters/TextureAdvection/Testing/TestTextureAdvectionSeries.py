# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How a time series is followed: reads, memory, the same by every way to a time, key frames, points, threads, bad input."""
import unittest

import numpy as np
from nephoscope_testing import meshes, threads
from nephoscope_testing.texture import DAY, Globe, advection, of_place, update
from nephoscope_testing.time_series import TimeSeries
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP

HOUR = 3600.0
TIMES = np.arange(0, 61) * HOUR


def wind(unit, height, time):
    phase = 2 * np.pi * time / (3 * DAY)
    axis = 4e-6 * np.array([np.cos(phase), np.sin(phase), 1.5])
    return np.cross(axis, unit) * (1 + 0.3 * np.sin(4 * unit[:, :1] + phase)), 0.01 * np.sin(3 * unit[:, 1] + phase)


def series(times=TIMES, **options):
    return Globe(wind, times=times, columns=36, rows=19, **options)


def digest(time, **settings):
    return update(advection(series(), **settings), time)[0].digest()


class Reading(unittest.TestCase):
    def test_each_field_once_and_a_window_in_memory(self):
        source = series()
        made = advection(source)
        for time in TIMES:
            update(made, time)
            self.assertLessEqual(made.GetNumberOfTimeStepsHeld(), 26)
        self.assertEqual(source.reads, list(TIMES))

    def test_cost_of_a_frame_does_not_grow(self):
        source = series()
        made = advection(source)
        steps = {}
        for time in TIMES:
            update(made, time)
            steps.setdefault(time % (12 * HOUR), set()).add(made.GetNumberOfSteps())
        self.assertTrue(all(len(s) == 1 for s in steps.values()), steps)

    def test_frames_between_and_any_order(self):
        times = [0, 0.25 * HOUR, 11.9 * HOUR, 12 * HOUR, 30.5 * HOUR, 47 * HOUR, 13 * HOUR, 60 * HOUR, 59.75 * HOUR]
        made = advection(series())
        for time in times:
            self.assertEqual(update(made, time)[0].digest(), digest(time), time)

    def test_a_step_back_reads_what_is_missing_only(self):
        source = series()
        made = advection(source)
        update(made, 40 * HOUR)
        count = len(source.reads)
        update(made, 39.5 * HOUR)
        self.assertLessEqual(len(source.reads), count + 1)

    def test_arrays_between_steps_are_interpolated(self):
        texture, _ = update(advection(series()), 10.25 * HOUR)
        source = series()
        first, second = (np.array(update(advection(source), t)[0].point_array("Cloud")) for t in (10 * HOUR, 11 * HOUR))
        np.testing.assert_allclose(texture.point_array("Cloud"), 0.75 * first + 0.25 * second, rtol=1e-12)

    def test_changed_setting_begins_anew(self):
        made = advection(series())
        update(made, 30 * HOUR)
        made.SetPeriod(10 * HOUR)
        self.assertEqual(update(made, 30 * HOUR)[0].digest(), digest(30 * HOUR, Period=10 * HOUR))

    def test_time_in_hours(self):
        source = series()
        hours = Globe(lambda unit, height, time: wind(unit, height, time * HOUR), times=TIMES / HOUR, columns=36, rows=19)
        self.assertEqual(update(advection(hours, TimeScale=HOUR), 30.5)[0].digest(), update(advection(source), 30.5 * HOUR)[0].digest())


class Births(unittest.TestCase):
    def test_weight_and_displacement_are_zero_at_birth(self):
        made = advection(series())
        own = update(made, 0.0)[0].sets[0]
        for hour in (12, 24, 36):
            texture, _ = update(made, hour * HOUR)
            born = 1 if hour % 24 else 0
            self.assertEqual(texture.weights[born], 0)
            self.assertEqual(texture.weights[1 - born], 1)
            self.assertEqual(texture.ages[born], 0)
            np.testing.assert_array_equal(texture.sets[born], own)

    def test_both_sets_start_from_the_grid(self):
        """With StartFromGrid; half a period later the second set is born, and there is no difference any more."""
        made = advection(series(), StartFromGrid=True, KeyFrameInterval=4 * HOUR)
        first, second = np.copy(update(made, 0)[0].sets)
        np.testing.assert_array_equal(first, second)
        later, _ = update(made, 3 * HOUR)
        np.testing.assert_array_equal(*later.sets)
        self.assertGreater(np.abs(later.sets[1] - second).max(), 1e-3)
        self.assertEqual(list(later.weights), [0.25, 0.75])
        self.assertEqual(list(later.ages), [3 * HOUR, 3 * HOUR])
        self.assertNotEqual(digest(3 * HOUR), digest(3 * HOUR, StartFromGrid=True))
        self.assertEqual(digest(12 * HOUR), digest(12 * HOUR, StartFromGrid=True))

    def test_weights_add_up_to_one(self):
        made = advection(series())
        for time in np.linspace(0, 60 * HOUR, 17):
            self.assertAlmostEqual(update(made, time)[0].weights.sum(), 1, places=15)

    def test_a_life_is_continuous(self):
        made = advection(series())
        late = [update(made, t)[0].sets[0] for t in (23.999 * HOUR, 23.998 * HOUR)]
        self.assertLess(np.abs(late[0] - late[1])[abs(late[0][:, 1]) < 0.2].max(), 1e-4)  # 3.6 s


class KeyFrames(unittest.TestCase):
    def test_at_keys_nothing_changes_and_between_they_are_near(self):
        made = advection(series(), KeyFrameInterval=HOUR)
        for time in (5 * HOUR, 12 * HOUR, 24 * HOUR, 30 * HOUR):
            self.assertEqual(update(made, time)[0].digest(), digest(time), time)
        for time in (11.75 * HOUR, 12.25 * HOUR, 30.5 * HOUR):
            near, exact = update(made, time)[0], update(advection(series()), time)[0]
            for a, b in zip(near.sets, exact.sets):
                away = np.linalg.norm(of_place(a) - of_place(b), axis=1)[np.abs(b[:, 1]) < 0.2]
                self.assertLess(away.max(), 2e-3)
            np.testing.assert_array_equal(near.weights, exact.weights)

    def test_frames_between_cost_nothing(self):
        source = series()
        made = advection(source, KeyFrameInterval=HOUR)
        steps = []
        for quarter in range(4 * 30):
            update(made, quarter * HOUR / 4)
            steps.append(made.GetNumberOfSteps())
        self.assertEqual(sum(s > 0 for s in steps), 31)
        self.assertEqual(source.reads, list(TIMES[:31]))

    def test_any_order(self):
        made = advection(series(), KeyFrameInterval=5 * HOUR)
        for time in (30.5 * HOUR, 23.9 * HOUR, 24.1 * HOUR, 59.9 * HOUR, 60 * HOUR):
            self.assertEqual(update(made, time)[0].digest(), digest(time, KeyFrameInterval=5 * HOUR), time)


class Points(unittest.TestCase):
    def test_some_points_give_what_the_grid_gives(self):
        for time in (20 * HOUR, 30.5 * HOUR):
            grid, _ = update(advection(series()), time)
            chosen = np.arange(500, grid.output.GetNumberOfPoints(), 37)
            points = vtkPolyData()
            points.SetPoints(meshes.vtk_points(np.array([grid.output.GetPoint(int(i)) for i in chosen])))
            some, messages = update(advection(series(), points=points), time)
            self.assertEqual(messages, [])
            self.assertEqual(some.output.GetClassName(), "vtkPolyData")
            for a, b in zip(grid.sets, some.sets):
                np.testing.assert_allclose(of_place(a[chosen]), of_place(b), atol=1e-6)
                np.testing.assert_allclose(a[chosen, 2], b[:, 2], atol=1e-8)

    def test_no_points(self):
        texture, messages = update(advection(series(), points=vtkPolyData()), HOUR)
        self.assertEqual((texture.output.GetNumberOfPoints(), messages), (0, []))


def request(piece, time):
    from vtkmodules.vtkCommonCore import vtkInformation, vtkInformationVector
    info = vtkInformation()
    info.Set(SDDP.UPDATE_TIME_STEP(), time)
    info.Set(SDDP.UPDATE_PIECE_NUMBER(), piece)
    info.Set(SDDP.UPDATE_NUMBER_OF_PIECES(), 3)
    vector = vtkInformationVector()
    vector.Append(info)
    return vector


class Pieces(unittest.TestCase):
    def test_pieces_are_parts_of_the_whole(self):
        for settings in ({}, dict(ComputeLyapunovExponent=True)):
            whole = update(advection(series(), **settings), 30.5 * HOUR)[0]
            made = advection(series(), **settings)
            found = 0
            for piece in range(3):
                made.Update(0, request(piece, 30.5 * HOUR))
                part = made.GetOutput()
                found += part.GetNumberOfCells()
                for name in ("TextureCoordinates1", "TextureCoordinates2") + (("FiniteTimeLyapunovExponent",) if settings else ()):
                    values = part.GetPointData().GetArray(name)
                    everything = whole.output.GetPointData().GetArray(name)
                    extent = part.GetExtent()
                    for i, j, k in ((extent[0], extent[2], extent[4]), (extent[1], extent[3], extent[5])):
                        nx, ny = extent[1] - extent[0] + 1, extent[3] - extent[2] + 1
                        here = (i - extent[0]) + nx * ((j - extent[2]) + ny * (k - extent[4]))
                        there = i + 37 * (j + 19 * k)
                        self.assertEqual(values.GetTuple(here), everything.GetTuple(there))
            self.assertEqual(found, whole.output.GetNumberOfCells())


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        self.assertEqual(len(threads.results(__file__, "digest(30.5 * 3600)")), 1)


class Boxes(unittest.TestCase):
    def test_a_uniform_wind_also_beyond_the_border(self):
        source = TimeSeries(np.linspace(0, 30, 31), lambda p, t: (0.2 + 0.02 * t, 0.1, 0), bounds=(-1, 1, -1, 1, 0, 1))
        texture, messages = update(advection(source, Period=12, TimeStep=1), 20)
        self.assertEqual(messages, [])
        points = meshes.points_of(texture.output)
        for coordinates, age in zip(texture.sets, texture.ages):
            x = points[:, 0] - 0.2 * age - 0.01 * (20**2 - (20 - age)**2)
            expected = (np.column_stack([x, points[:, 1] - 0.1 * age, points[:, 2]]) - [-1, -1, 0]) / 2
            np.testing.assert_allclose(coordinates, expected, atol=2e-6)

    def test_period_from_the_data(self):
        """A quarter of the time in which the fastest air of the first time step crosses the data, whatever time is asked for first."""
        def source():
            return TimeSeries(np.linspace(0, 30, 31), lambda p, t: (0.2 + 0.02 * t, 0.1, 0), bounds=(-1, 1, -1, 1, 0, 1))
        period = 0.25 * 3 / np.hypot(0.2, 0.1)
        for time in (0, 20):
            made = advection(source())
            texture, messages = update(made, time)
            self.assertEqual(messages, [])
            self.assertAlmostEqual(made.GetPeriodUsed(), period, places=9)
            self.assertAlmostEqual(made.GetTimeStepUsed(), period / 24, places=9)
            expected, _ = update(advection(source(), Period=made.GetPeriodUsed(), TimeStep=made.GetTimeStepUsed()), time)
            self.assertEqual(texture.digest(), expected.digest())
        self.assertEqual(advection(source()).FindPeriod(None), DAY)
        made = advection(series())
        update(made, 30 * HOUR)
        self.assertEqual((made.GetPeriodUsed(), made.GetTimeStepUsed()), (DAY, HOUR))

    def test_exponent_of_a_saddle(self):
        source = TimeSeries([0.0], lambda p, t: p * [0.3, -0.3, 0], bounds=(-1, 1, -1, 1, 0, 1), dimensions=(9, 9, 3))
        texture, _ = update(advection(source, Period=2, TimeStep=0.05, ComputeLyapunovExponent=True), 1.6)
        exponent = texture.point_array("FiniteTimeLyapunovExponent").reshape(3, 9, 9)
        np.testing.assert_allclose(exponent[:, 3:6, 3:6], 0.3, rtol=1e-4)

    def test_weights_by_stretch(self):
        source = TimeSeries([0.0], lambda p, t: p * [0.1, -0.1, 0], bounds=(-1, 1, -1, 1, 0, 1), dimensions=(9, 9, 3))
        texture, _ = update(advection(source, Period=20, TimeStep=0.1, MaximumStretch=2), 13)
        weights = texture.point_array("TextureWeights")
        np.testing.assert_allclose(weights.sum(axis=1), 1, rtol=1e-6)
        middle = weights.reshape(3, 9, 9, 2)[1, 4, 4]
        expected = texture.weights / (1 + (np.exp(0.1 * texture.ages) / 2)**4)
        np.testing.assert_allclose(middle, expected / expected.sum(), rtol=1e-3)


class Bad(unittest.TestCase):
    def expect(self, text, source, time=HOUR, **settings):
        texture, messages = update(advection(source, **settings), time)
        self.assertTrue(any(text in m for m in messages), (text, messages))
        self.assertEqual(len(messages), 1, messages)
        self.assertIsNone(texture.sets[0])

    def test_settings(self):
        for name, value in (("Period", -1), ("Period", np.nan), ("TimeStep", -1), ("TimeStep", np.nan), ("TimeScale", 0),
                            ("Tolerance", 0), ("KeyFrameInterval", -1), ("MaximumStretch", 0.5)):
            self.expect(f"{name} is", series(), **{name: value})
        self.expect("go together", series(), PressureArrayName="p")
        self.expect("a million steps", series(), TimeStep=1e-3)

    def test_times_that_do_not_rise(self):
        self.expect("Times must increase", series([0, 2 * HOUR, HOUR]))
        self.expect("Times must increase", series([0, np.nan, HOUR]))
        self.expect("no time steps", TimeSeries([], lambda p, t: (1, 0, 0)))

    def test_no_velocity(self):
        grid = series().grid(0)
        grid.GetPointData().RemoveArray("DisplayVelocity")
        self.expect("no velocity", grid)
        self.expect("empty", vtkStructuredGrid())

    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, series().grid(0))
        self.expect("one grid is needed", blocks)

    def test_wrong_kind(self):
        self.expect("Grid is Globe", TimeSeries([0.0], lambda p, t: (1, 0, 0)), Grid=1)

    def test_a_grid_that_changes(self):
        class Changing(Globe):
            def grid(self, time):
                self.latitudes = self.latitudes * (0.9 if time > HOUR else 1)
                return super().grid(time)
        self.expect("change from one time step", Changing(wind, times=TIMES, columns=36, rows=19), 3 * HOUR)

    def test_array_that_is_missing_later(self):
        class Forgetful(Globe):
            def grid(self, time):
                grid = super().grid(time)
                if time > HOUR:
                    grid.GetPointData().RemoveArray("DisplayVelocity")
                return grid
        self.expect("no point array 'DisplayVelocity'", Forgetful(wind, times=TIMES, columns=36, rows=19), 3 * HOUR)

    def test_source_that_fails_midway(self):
        class Failing(Globe):
            fails = True

            def RequestData(self, request, inputs, outputs):
                return 0 if self.fails and len(self.reads) == 4 else super().RequestData(request, inputs, outputs)
        source = Failing(wind, times=TIMES, columns=36, rows=19)
        made = advection(source)
        _, messages = update(made, 8 * HOUR)
        self.assertTrue(any("has not delivered the time step" in m for m in messages), messages)
        source.fails = False
        source.Modified()
        self.assertEqual(update(made, 8 * HOUR)[0].digest(), digest(8 * HOUR))

    def test_missing_winds(self):
        def holed(unit, height, time):
            angular, rise = wind(unit, height, time)
            angular[(unit[:, 0] > 0.9) & (height < 6000)] = np.nan
            return angular, rise
        texture, messages = update(advection(Globe(holed, columns=36, rows=19).grid(0)), 20 * HOUR)
        self.assertEqual(len(messages), 1)
        self.assertIn("not a finite number at", messages[0])
        self.assertTrue(np.isfinite(texture.sets[0]).all())

    def test_abort(self):
        for share in (0.0, 0.5):
            made = advection(series())
            made.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(caller.GetProgress() >= share))
            texture, messages = update(made, 20 * HOUR)
            self.assertEqual((texture.output.GetNumberOfPoints(), messages), (0, []))
            made.RemoveAllObservers()
            made.SetAbortExecute(0)
            self.assertEqual(update(made, 20 * HOUR)[0].digest(), digest(20 * HOUR))

    def test_progress_rises_to_one(self):
        made, seen = advection(series()), []
        update(made, 5 * HOUR)
        made.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress()))
        update(made, 5.5 * HOUR)
        self.assertEqual(seen[-1], 1)
        self.assertEqual(seen, sorted(seen))


if __name__ == "__main__":
    unittest.main()
