# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A time series that comes back to its beginning, for films that loop.

    loop = LoopedSeries(reader, length=24, fade=8)
    loop.UpdateTimeStep(7.5)          a day of 24 hours: hour 0 is hour 24 is hour 48 and so on

The first `length` hours of the reader, of which the first `fade` hours are led up to by the same hours of the next day:
    loop(t) = (1 - s) series(t + length) + s series(t),   s from 0 at t = 0 to 1 at t = fade.
At t = length that is series(length), as at t = 0, so nothing jumps. All arrays are blended, winds and clouds alike: what follows the
wind through the loop comes back to where it began. A blend of two cloudy skies would be one with more clouds, thinner ones: arrays that
are named in `distributions` keep their order, but get the values, level by level, that lie between those of the two days in their order.
"""
import numpy
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline


class LoopedSeries(VTKPythonAlgorithmBase):
    def __init__(self, reader, length, fade, distributions=("cloud_fraction",), rounds=3):
        """Hours, whatever the reader counts in; `rounds` are offered, so that paths lead back through a whole one from the last."""
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkRectilinearGrid")
        reader.Update()
        self.reader, self.length, self.fade = reader, length, fade
        self.distributions, self.rounds = distributions, rounds
        self.times = reader.GetOutputInformation(0).Get(Pipeline.TIME_STEPS()) or [0.0]
        self.hours = [(t - self.times[0]) * hours_of_unit(reader.GetOutput()) for t in self.times]
        for hour in [hour for hour in self.hours if hour < fade] + [0, fade]:
            self.number(hour + length if hour < fade else hour)

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        steps = [hour + self.length * turn for turn in range(self.rounds) for hour in self.hours if hour < self.length]
        steps.append(self.rounds * self.length)
        info.Set(Pipeline.TIME_STEPS(), steps, len(steps))
        info.Set(Pipeline.TIME_RANGE(), [steps[0], steps[-1]], 2)
        extent = self.reader.GetOutputInformation(0).Get(Pipeline.WHOLE_EXTENT())
        info.Set(Pipeline.WHOLE_EXTENT(), extent, 6)
        return 1

    def RequestData(self, request, inputs, outputs):
        output = vtkRectilinearGrid.GetData(outputs)
        time = outputs.GetInformationObject(0).Get(Pipeline.UPDATE_TIME_STEP())
        hour = time % self.length  # one of those announced
        share = self.share(hour)
        output.DeepCopy(self.at(hour))
        if share < 1:
            here = dataset_adapter.WrapDataObject(output).PointData
            next_day = dataset_adapter.WrapDataObject(self.at(hour + self.length)).PointData
            for name in here.keys():
                blend = blend_distributions if name in self.distributions else blend_values
                here[name][:] = blend(share, here[name], next_day[name], output.GetDimensions()[2]).ravel()
        output.GetInformation().Set(output.DATA_TIME_STEP(), time)
        return 1

    def at(self, hour):
        self.reader.UpdateTimeStep(self.times[self.number(hour)])
        return self.reader.GetOutput()

    def number(self, hour):
        """The number of the time step at an hour."""
        number = min(range(len(self.hours)), key=lambda i: abs(self.hours[i] - hour))
        if abs(self.hours[number] - hour) > 0.01:
            raise ValueError("a loop of %g hours that fades for %g needs %g hours of a series, with fields %g hours apart; there is none at "
                             "hour %g" % (self.length, self.fade, self.length + self.fade, self.length, hour))
        return number

    def share(self, hour):
        """The weight of the earlier day, smooth at both ends of the fade."""
        x = min(1.0, hour / self.fade)
        return x * x * (3 - 2 * x)


def hours_of_unit(data):
    """From what a CF file says of its times, such as "hours since 2011-01-01"; without a word they are hours."""
    said = data.GetFieldData().GetAbstractArray("time_units")
    unit = said.GetValue(0).split()[0].lower().rstrip("s") if said else "hour"
    hours = {"second": 1 / 3600, "sec": 1 / 3600, "": 1 / 3600, "minute": 1 / 60, "min": 1 / 60, "hour": 1, "hr": 1, "h": 1, "day": 24, "d": 24}
    if unit not in hours:
        raise ValueError('times in "%s" are not known: seconds, minutes, hours or days' % said.GetValue(0))
    return hours[unit]


def blend_values(share, here, there, levels):
    return share * here + (1 - share) * there


def blend_distributions(share, here, there, levels):
    here, there = numpy.asarray(here).reshape(levels, -1), numpy.asarray(there).reshape(levels, -1)
    order = numpy.argsort(share * here + (1 - share) * there, axis=1, kind="stable")
    result = numpy.empty_like(here)
    between = share * numpy.sort(here, axis=1) + (1 - share) * numpy.sort(there, axis=1)
    numpy.put_along_axis(result, order, between.astype(here.dtype), axis=1)
    return result
