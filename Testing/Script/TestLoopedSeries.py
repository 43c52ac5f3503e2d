# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The series of the film that loops: its end is its beginning, in between it is the series, and no step is larger than that of a day."""
import os
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "Figures", "common"))
import looped_series  # noqa: E402

LENGTH, FADE = 4, 2  # of the 6 hours that there are


def reader():
    result = vtkNetCDFCFReader()
    result.SetFileName(os.path.join(TOP, "Data", "forecast_10deg_6h.nc"))
    result.SphericalCoordinatesOff()
    result.UpdateMetaData()
    result.SetDimensions("(lev, lat, lon)")
    return result


def values(algorithm, time, name):
    algorithm.UpdateTimeStep(time)
    return np.array(vtk_to_numpy(algorithm.GetOutputDataObject(0).GetPointData().GetArray(name)))


class Loop(unittest.TestCase):
    def setUp(self):
        self.series = reader()
        self.loop = looped_series.LoopedSeries(reader(), LENGTH, FADE)

    def test_times(self):
        self.loop.UpdateInformation()
        times = self.loop.GetOutputInformation(0).Get(Pipeline.TIME_STEPS())
        self.assertEqual(list(times), list(range(3 * LENGTH + 1)))

    def test_the_series_where_it_does_not_fade(self):
        for name in ("u", "cloud_fraction"):
            for hour in (2, 3, 7, 10):
                np.testing.assert_array_equal(values(self.loop, hour, name), values(self.series, 6792 + hour % LENGTH, name))

    def test_the_end_is_the_beginning(self):
        for name in ("u", "cloud_fraction"):
            last = values(self.series, 6792 + LENGTH, name)
            for hour in (0, LENGTH, 2 * LENGTH):
                np.testing.assert_array_equal(values(self.loop, hour, name), last)

    def test_in_between(self):
        wind = values(self.loop, 1, "u")
        np.testing.assert_allclose(
            wind, (values(self.series, 6793, "u") + values(self.series, 6793 + LENGTH, "u")) / 2, rtol=1e-5, atol=1e-5)
        clouds, days = values(self.loop, 1, "cloud_fraction"), [values(self.series, t, "cloud_fraction") for t in (6793, 6793 + LENGTH)]
        mean = (days[0] + days[1]) / 2
        for level in np.arange(clouds.size).reshape(5, -1):
            np.testing.assert_allclose(np.sort(clouds[level]), (np.sort(days[0][level]) + np.sort(days[1][level])) / 2, atol=1e-6)
            self.assertTrue(np.all(np.diff(clouds[level][np.argsort(mean[level], kind="stable")]) >= 0))
        self.assertEqual(clouds[(days[0] == 0) & (days[1] == 0)].max(), 0)  # no cloud where neither day has one

    def test_a_series_that_is_too_short(self):
        with self.assertRaisesRegex(ValueError, "needs 8 hours of a series"):
            looped_series.LoopedSeries(reader(), 6, 2)

    def test_units_of_time(self):
        for words, hours in (("hours since 2011-01-01", 1), ("days since 1900-01-01 00:00:00", 24), ("seconds since 1970-01-01", 1 / 3600)):
            data, said = vtkRectilinearGrid(), vtkStringArray()
            said.SetName("time_units")
            said.InsertNextValue(words)
            data.GetFieldData().AddArray(said)
            self.assertEqual(looped_series.hours_of_unit(data), hours)
        self.assertEqual(looped_series.hours_of_unit(vtkRectilinearGrid()), 1)
        said.SetValue(0, "fortnights since 1066")
        with self.assertRaisesRegex(ValueError, "seconds, minutes, hours or days"):
            looped_series.hours_of_unit(data)


if __name__ == "__main__":
    unittest.main()
