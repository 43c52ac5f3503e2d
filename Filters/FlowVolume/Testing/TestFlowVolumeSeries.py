# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How a time series is followed: every step read once, two in memory, the same smoke by every way to a time; bad series."""
import unittest

import numpy as np
from nephoscope_testing import threads
from nephoscope_testing.flow import flow_volume, update
from nephoscope_testing.time_series import TimeSeries
from vtkmodules.vtkCommonCore import vtkStringArray, vtkWeakReference
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP

TIMES = np.round(np.linspace(0, 1, 11), 12)
SETTINGS = dict(Unsteady=True, NormalToFlow=False, Radius=0.1, NumberOfSides=6, TimeStep=0.04, MaximumEdgeLength=0.12)


def wind(points, time):
    x, y, z = points.T
    return np.column_stack([0.3 * x + (1 - time) * z, 0.3 * y + 0.2 * np.sin(4 * time), 1 + 0.4 * time * z])


def temperature(points, time):
    return np.sin(3 * points[:, 0]) + time


def series(times=TIMES, velocity=wind, **options):
    return TimeSeries(times, velocity, arrays={"temperature": temperature}, **options)


def digest(time, **settings):
    return update(flow_volume(series(), **SETTINGS, **settings), time)[0].digest()


class Animation(unittest.TestCase):
    def test_forward_reads_each_step_once_and_equals_direct_requests(self):
        source = series()
        made = flow_volume(source, **SETTINGS)
        for time in TIMES:
            smoke = update(made, time)[0]
        self.assertEqual(source.reads, list(TIMES))
        self.assertEqual(smoke.digest(), digest(1.0))
        update(made, 1.0)
        self.assertEqual(len(source.reads), len(TIMES))

    def test_frames_between_steps(self):
        source = series()
        made = flow_volume(source, **SETTINGS)
        for time in (0.0, 0.013, 0.07, 0.1, 0.333, 0.335, 0.5, 0.8, 0.87, 1.0):
            self.assertEqual(update(made, time)[0].digest(), digest(time), time) if time > 0 else update(made, time)
        self.assertEqual(source.reads, list(TIMES))

    def test_reads_no_more_than_needed(self):
        source = series()
        update(flow_volume(source, **SETTINGS), 0.33)
        self.assertEqual(source.reads, [0, 0.1, 0.2, 0.3, 0.4])

    def test_backward_begins_anew(self):
        source = series()
        made = flow_volume(source, **SETTINGS)
        update(made, 1.0)
        self.assertEqual(update(made, 0.55)[0].digest(), digest(0.55))
        self.assertEqual(source.reads, list(TIMES) + list(TIMES[:7]))

    def test_a_little_backward_within_what_is_kept(self):
        """From 0.395 to 0.37: the state has stopped at the release at 0.36."""
        source = series()
        made = flow_volume(source, **SETTINGS)
        update(made, 0.395)
        read = len(source.reads)
        self.assertEqual(update(made, 0.37)[0].digest(), digest(0.37))
        self.assertEqual(len(source.reads), read)

    def test_changed_setting_or_source_begins_anew(self):
        source = series()
        made = flow_volume(source, **SETTINGS)
        update(made, 0.5)
        made.SetCenter(0.1, 0, 0)
        moved = update(made, 0.5)[0]
        self.assertEqual(moved.digest(), digest(0.5, Center=(0.1, 0, 0)))
        self.assertEqual(source.reads, 2 * list(TIMES[:6]))
        source.velocity = lambda p, t: (0, 0, 1)
        source.Modified()
        smoke = update(made, 0.5)[0]
        self.assertAlmostEqual(smoke.points[:, 2].max(), 0.5, places=12)

    def test_last_time_without_a_request(self):
        self.assertEqual(digest(None), digest(1.0))
        self.assertEqual(digest(7.0), digest(1.0))

    def test_time_of_input_is_offered(self):
        made = flow_volume(series(), **SETTINGS)
        made.UpdateInformation()
        self.assertEqual(list(made.GetOutputInformation(0).Get(SDDP.TIME_STEPS())), list(TIMES))
        self.assertEqual(list(made.GetOutputInformation(0).Get(SDDP.TIME_RANGE())), [0, 1])
        made.UpdateTimeStep(0.42)
        self.assertEqual(made.GetOutput().GetInformation().Get(vtkImageData.DATA_TIME_STEP()), 0.42)


class Memory(unittest.TestCase):
    def test_two_steps(self):
        alive, most = [], []

        class Watched(TimeSeries):
            def RequestData(self, request, inputs, outputs):
                done = super().RequestData(request, inputs, outputs)
                reference = vtkWeakReference()
                reference.Set(vtkImageData.GetData(outputs).GetPointData().GetArray("v"))
                alive.append(reference)
                most.append(sum(r.Get() is not None for r in alive))
                return done

        source = Watched(TIMES, wind)
        made = flow_volume(source, **SETTINGS)
        for time in (0.35, 1.0):
            update(made, time)
        self.assertEqual(len(most), len(TIMES))
        self.assertEqual(max(most), 2)

    def test_duration_bounds_the_smoke(self):
        source = TimeSeries(np.linspace(0, 4, 41), lambda p, t: (np.cos(7 * t), np.sin(7 * t), 1), bounds=(-1, 1, -1, 1, -0.5, 5))
        made = flow_volume(source, **{**SETTINGS, "Duration": 0.4})
        sizes = [len(update(made, time)[0].cells) for time in np.arange(0.4, 4.01, 0.4)]
        self.assertLessEqual(max(sizes), 1.25 * sizes[0])
        self.assertGreater(min(sizes), 0.75 * sizes[0])


class Threads(unittest.TestCase):
    def test_any_number_gives_the_same(self):
        self.assertEqual(len(threads.results(__file__, "digest(0.97, PolygonEdgeLength=0.02)")), 1)


class Hours(TimeSeries):
    """The unit of its times is as readers of NetCDF files write it."""
    unit = "hours since 2011-10-11 00:00:00"

    def RequestData(self, request, inputs, outputs):
        done = super().RequestData(request, inputs, outputs)
        unit = vtkStringArray()
        unit.SetName("time_units")
        unit.InsertNextValue(self.unit)
        vtkImageData.GetData(outputs).GetFieldData().AddArray(unit)
        return done


class TimeUnits(unittest.TestCase):
    def age(self, unit, speed, **settings):
        source = Hours(TIMES, lambda p, t: (0, 0, speed))
        source.unit = unit
        smoke, messages = update(flow_volume(source, **{**SETTINGS, "TimeStep": 0, "MaximumEdgeLength": 0, **settings}))
        return smoke.point_array("Age").max() if len(smoke.cells) else 0, messages

    def test_that_the_data_tell(self):
        for unit, seconds in (("Hours since 2011-10-11", 3600), ("h", 3600), ("days since 1900-01-01", 86400), ("minutes since 0", 60), ("seconds since 0", 1), ("s", 1),
                              ("msecs since 0", 1e-3), ("fortnights since 0", 1), ("", 1)):
            age, messages = self.age(unit, 0.5 / seconds)
            self.assertEqual(messages, [], unit)
            self.assertAlmostEqual(age / seconds, 1, 1)
        age, messages = self.age("hours since 0", 0.5 / 60, TimeScale=60)  # as set, whatever the data tell
        self.assertEqual(messages, [])
        self.assertAlmostEqual(age / 60, 1, 1)

    def test_that_is_not_told(self):
        for speed, words in ((0.5 / 3600, "moves by only 0.00013.* in the 1 seconds from the first time step to the last. TimeScale is 1 s per unit of time: set it to 3600"),
                             (0.5 * 3600, "crosses the data [0-9]+ times between two time steps. TimeScale is 1 s per unit of time")):
            messages = self.age("", speed)[1]
            self.assertRegex(messages[0], words)

    def test_a_duration_in_hours(self):
        """Times are in hours, the duration is in seconds."""
        messages = self.age("hours since 0", 0.5 / 3600, Duration=3)[1]
        self.assertRegex(messages[0], "moves by only 0.0004.* in the 3 seconds of Duration. Lengthen it: it is in seconds")
        self.assertEqual(self.age("hours since 0", 0.5 / 3600, Duration=3 * 3600)[1], [])


class BadSeries(unittest.TestCase):
    def expect(self, text, source, cells=0, time=None, **settings):
        smoke, messages = update(flow_volume(source, **{**SETTINGS, **settings}), time)
        self.assertTrue(any(text in m for m in messages), (text, messages))
        self.assertEqual(len(messages), 1, messages)
        if cells is not None:
            self.assertEqual(len(smoke.cells), cells)
        return smoke

    def test_steady_data(self):
        for source, text in ((series(None), "no time steps"), (series([0.5]), "one time step only")):
            smoke = self.expect(text, source, cells=None, Duration=0.4)
            steady = flow_volume(source, **{**SETTINGS, "Unsteady": False}, Duration=0.4)
            self.assertEqual(smoke.digest(), update(steady)[0].digest())
            self.assertGreater(len(smoke.cells), 0)

    def test_empty_series(self):
        self.expect("has no time steps", series([]))

    def test_times_that_do_not_rise(self):
        self.expect("time step 2 is at 0.05 after 0.1", series([0, 0.1, 0.05, 0.2]))
        self.expect("time step 1 is at nan after 0", series([0, np.nan, 1]))

    def test_settings(self):
        self.expect("StartTime is 2, after the last time step, which is at 1", series(), StartTime=2)
        self.expect("StartTime (nan)", series(), StartTime=np.nan)
        for wrong in (-1, np.nan, np.inf):
            self.expect(f"TimeScale is {wrong}; it must be positive, or 0 (the unit that the data tell, or seconds)", series(), TimeScale=wrong)
        self.expect("TimeStep is -0.1", series(), TimeStep=-0.1)
        self.expect("more than a million steps", series(), TimeStep=1e-7)

    def test_polygon(self):
        self.expect("outside the data", series(), Center=(5, 0, 0))
        self.expect("outside the data", series(), Center=(5, 0, 0), NormalToFlow=True)
        self.expect("zero everywhere at all times", series(velocity=lambda p, t: (0, 0, 0)), NormalToFlow=True)
        shear = series(velocity=lambda p, t: p * (0, 0, 1))
        self.expect("zero at the centre", shear, Center=(0, 0, 0), NormalToFlow=True)

    def test_no_smoke(self):
        self.expect("No smoke has come", series(velocity=lambda p, t: (0, 0, 0)))
        self.expect("No smoke has come", series(velocity=lambda p, t: (1, 0, 0)))

    def test_wind_that_begins_later(self):
        made = flow_volume(series(velocity=lambda p, t: (0, 0, t)), **SETTINGS)
        smoke, messages = update(made)
        self.assertEqual(messages, [])
        self.assertAlmostEqual(smoke.points[:, 2].max(), 0.5, places=12)

    def test_still_at_first(self):
        """The polygon waits for a flow that it can face; until then a message says so, once."""
        def gust(points, time):
            return (0, 0, max(0, time - 0.5))
        made = flow_volume(series(velocity=gust), **{**SETTINGS, "NormalToFlow": True})
        told = [message for time in (0.0, 0.4, 0.5) for message in update(made, time)[1]]
        self.assertEqual(len(told), 1, told)
        self.assertRegex(told[0], "no smoke at time 0: the flow is zero everywhere up to time 0. Play the animation")
        for direct in (False, True):
            again = flow_volume(series(velocity=gust), **{**SETTINGS, "NormalToFlow": True}) if direct else made
            smoke, messages = update(again, 1.0)
            self.assertEqual(messages, [])
            self.assertAlmostEqual(smoke.points[:, 2].max(), 0.5 ** 2 / 2, places=12)

    def test_no_cells_at_first(self):
        class Late(TimeSeries):
            def RequestData(self, request, inputs, outputs):
                done = super().RequestData(request, inputs, outputs)
                if self.reads[-1] < 0.2:
                    vtkImageData.GetData(outputs).Initialize()
                return done
        self.expect("This is time step 0, at 0: leave it out, or choose a later StartTime.", Late(TIMES, wind))
        self.assertGreater(len(update(flow_volume(Late(TIMES, wind), **SETTINGS, StartTime=0.2))[0].cells), 0)

    def test_bounds_at_first(self):
        """Where the smoke will be: a camera that is set at the first time suits a film."""
        made = flow_volume(series(), **SETTINGS)
        smoke, messages = update(made, 0.0)
        self.assertEqual((len(messages), len(smoke.cells)), (1, 0))
        told = made.GetOutput().GetFieldData().GetArray("BoundsToCome")
        self.assertEqual(tuple(told.GetValue(i) for i in range(6)), made.GetInputDataObject(0, 0).GetBounds())
        self.assertFalse(update(made, 1.0)[0].output.GetFieldData().HasArray("BoundsToCome"))

    def test_missing_values_at_a_time(self):
        """The smoke in the hole ends; what comes later does not."""
        def holed(points, time):
            v = wind(points, time)
            v[(points[:, 2] > 0.4) & (0.45 < time < 0.55)] = np.nan
            return v
        smoke, messages = update(flow_volume(series(velocity=holed, dimensions=(5, 5, 21)), **SETTINGS))
        self.assertEqual(len(messages), 2, messages)
        self.assertRegex(messages[0], "not a finite number at .* of 525 points at time 0.5")
        self.assertRegex(messages[1], "ended at missing velocities or obstacles inside the data .* A tetrahedron ends")
        self.assertTrue(np.isfinite(smoke.points).all() and np.isfinite(smoke.density).all())
        self.assertGreater(smoke.made.GetObstacleMass(), 0.5 * smoke.made.GetLostMass())
        self.assertAlmostEqual((smoke.mass() + smoke.made.GetLostMass()) / smoke.made.GetEmittedMass(), 1, places=12)

    def test_time_step_without_velocities(self):
        """All smoke ends there; the message names the time, once in an animation."""
        made = flow_volume(series(velocity=lambda p, t: wind(p, t) if t != 0.5 else np.full(p.shape, np.nan)), **SETTINGS)
        told = [message for time in (0.3, 0.8, 0.9, 1.0) for message in update(made, time)[1]]
        self.assertEqual(len(told), 1, told)
        self.assertGreater(made.GetObstacleMass(), 0.8 * made.GetLostMass())
        self.assertRegex(told[0], r"at time 0\.5\. .*ended or left the data .*Leave this time step out")

    def test_time_after_the_last(self):
        made = flow_volume(series(), **SETTINGS)
        told = [message for time in (0.5, 1.0, 5, 6) for message in update(made, time)[1]]
        self.assertEqual(len(told), 1, told)
        self.assertRegex(told[0], "no data at time 5: the last time step of the input is at 1, and the smoke is that of this time")

    def test_few_tetrahedra(self):
        self.expect("even the coarsest volume has more tetrahedra", series(), MaximumNumberOfTetrahedra=1)

    def test_edges_merged_above_the_longest(self):
        for unsteady in (True, False):
            self.expect("Edges are merged up to a third of MaximumEdgeLength: choose a MinimumEdgeLength of 0.1 or less", series(),
                        Unsteady=unsteady, MinimumEdgeLength=0.4, MaximumEdgeLength=0.3)

    def test_array_that_is_missing_later(self):
        class Forgetful(TimeSeries):
            def RequestData(self, request, inputs, outputs):
                done = super().RequestData(request, inputs, outputs)
                if len(self.reads) > 4:
                    vtkImageData.GetData(outputs).GetPointData().RemoveArray("v")
                return done
        self.expect("This is time step 4, at 0.4:", Forgetful(TIMES, wind), Velocity="v")
        self.expect("no point array 'v'", Forgetful(TIMES, wind), Velocity="v")

    def test_source_that_fails_midway(self):
        """The update ends, and the next one begins anew."""
        class Failing(TimeSeries):
            fails = True

            def RequestData(self, request, inputs, outputs):
                return 0 if self.fails and len(self.reads) == 4 else super().RequestData(request, inputs, outputs)
        source = Failing(TIMES, wind)
        made = flow_volume(source, **SETTINGS)
        smoke, messages = update(made, 1.0)
        self.assertTrue(any("has not delivered the time step at 0.4" in m for m in messages), messages)
        self.assertEqual(len(smoke.cells), 0)
        source.fails, source.reads = False, []
        source.Modified()
        update(made, 0.7)
        self.assertEqual(source.reads, list(TIMES[:8]))

    def test_abort(self):
        made = flow_volume(series(), **SETTINGS)
        made.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(caller.GetProgress() > 0.5))
        smoke, messages = update(made)
        self.assertEqual((len(smoke.cells), messages), (0, []))
        made.RemoveAllObservers()
        made.SetAbortExecute(0)
        self.assertEqual(update(made)[0].digest(), digest(1.0))


if __name__ == "__main__":
    unittest.main()
