#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One sun for several Sunlight filters: its directions, what follows them, what is wrong."""
import unittest

import numpy as np
from nephoscope import vtkSunlight, vtkSunSource
from nephoscope_testing.messages import Messages
from lit import globe, image
from vtkmodules.util.numpy_support import vtk_to_numpy


def direction_of(data, name="SunDirection"):
    return vtk_to_numpy(data.GetFieldData().GetArray(name))[0]


def sun(**options):
    source = vtkSunSource()
    for name, value in options.items():
        getattr(source, "Set" + name)(value)
    return source


def lit(data, source, **options):
    light = vtkSunlight()
    light.SetInputData(data)
    light.SetInputConnection(2, source.GetOutputPort())
    for name, value in options.items():
        getattr(light, "Set" + name)(value)
    return light


class SunSource(unittest.TestCase):
    def setUp(self):
        self.cloud = image((3, 3, 9), (1, 1, 1), lambda x, y, z: 0.1 + 0 * x)

    def test_direction(self):
        source = sun(SunDirection=(0, 3, 4))
        source.Update()
        for name in ("SunDirection", "SunDirectionOnGlobe"):
            np.testing.assert_allclose(direction_of(source.GetOutput(), name), (0, 0.6, 0.8))
        self.assertEqual(source.GetOutput().GetNumberOfPoints(), 0)

    def test_dates(self):
        """Offsets from UTC count; days that there are not, and what is left over, are no dates."""
        def direction(date):
            source = sun(DateTime=date)
            with Messages() as messages:
                source.Update()
            return None if messages.errors else direction_of(source.GetOutput())
        expected = direction("2020-02-29 18:30")
        for date in ("2020-02-29T18:30Z", "2020-02-29 18:30:00 UTC", "2020-02-29T20:30:00+02:00", "2020-02-29 13:30 -0500", "2020-03-01T00:00:00.000+05:30", "2020-02-29 18:30:00.0-00"):
            np.testing.assert_allclose(direction(date), expected, atol=1e-9, err_msg=date)
        for date in ("2020-02-30", "2021-02-29", "2024-06-31 12:00", "2020-02-29 06:30 PM", "2020-02-29 18:30 CET", "2020-02-29 18:30+2 h", "2020-02-29 18:30:00+25:00", "2020-02-29x18:30", "2020-13-01"):
            self.assertIsNone(direction(date), date)

    def test_takes_the_place_of_the_sun_of_the_filter(self):
        light = lit(self.cloud, sun(SunDirection=(0, 3, 4)), SunDirection=(1, 0, 1), DateTime="2011-10-11 12:00")
        light.Update()
        np.testing.assert_allclose(direction_of(light.GetOutput()), (0, 0.6, 0.8))

    def test_one_change_moves_all(self):
        source = sun(SunDirection=(0, 0, 1))
        lights = [lit(self.cloud, source), lit(globe(), source)]
        for towards in ((0, 0, 1), (0.6, 0, 0.8), (0, 0, 1)):
            source.SetSunDirection(towards)
            for light in lights:
                light.Update()
                np.testing.assert_allclose(direction_of(light.GetOutput()), towards)
        bottom = [vtk_to_numpy(lights[0].GetOutput().GetPointData().GetArray("SunTransmittance"))[0]]
        source.SetSunDirection(0, 0.6, 0.8)
        lights[0].Update()
        bottom.append(vtk_to_numpy(lights[0].GetOutput().GetPointData().GetArray("SunTransmittance"))[0])
        self.assertNotAlmostEqual(*bottom, 3)  # computed anew, not only written

    def test_date_and_time_as_the_filter_has_them(self):
        """On a globe, and at a place; hours later is the same as a later time."""
        for data in (globe(), self.cloud):
            own = vtkSunlight()
            own.SetInputData(data)
            own.SetDateTime("2011-10-11 21:30")
            own.SetLongitude(-100)
            own.SetLatitude(30)
            own.Update()
            for source in (sun(DateTime="2011-10-11 21:30", Longitude=-100, Latitude=30),
                           sun(DateTime="2011-10-10 21:00", HoursLater=24.5, Longitude=-100, Latitude=30)):
                light = lit(data, source)
                light.Update()
                np.testing.assert_allclose(direction_of(light.GetOutput()), direction_of(own.GetOutput()), atol=1e-12)

    def test_wrong_input(self):
        for options, words in (({"SunDirection": (0, 0, 0)}, "longer than 0"), ({"SunDirection": (float("nan"), 0, 1)}, "finite"),
                               ({"DateTime": "tomorrow"}, "'tomorrow'"), ({"DateTime": "2011-10-11", "HoursLater": float("inf")}, "inf")):
            with self.subTest(options), Messages() as messages:
                lit(self.cloud, sun(**options)).Update()
            self.assertTrue(any(words in one for one in messages.all), messages.all)
        with Messages() as messages:
            light = vtkSunlight()
            light.SetInputData(self.cloud)
            light.SetInputDataObject(2, lit(self.cloud, sun()).GetInputDataObject(2, 0).NewInstance())
            light.Update()
        self.assertTrue(any("has no sun" in one for one in messages.all), messages.all)


if __name__ == "__main__":
    unittest.main()
