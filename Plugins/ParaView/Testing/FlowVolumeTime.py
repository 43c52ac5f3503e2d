# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke over a time series whose data grow: the place of its polygon, its duration and time step, and the period of its puffs are those of the first time, so
that a film does not jump; unsteady smoke says at its first time that it needs time to grow."""
import numpy as np

from PluginTesting import check, listen, load_plugin, new_view, passed, pvs

TIMES = [0.0, 1.0, 2.0, 3.0, 4.0]
INFORMATION = f"""
information = self.GetExecutive().GetOutputInformation(0)
information.Set(self.GetExecutive().TIME_STEPS(), {TIMES}, {len(TIMES)})
information.Set(self.GetExecutive().TIME_RANGE(), [{TIMES[0]}, {TIMES[-1]}], 2)
information.Set(self.GetExecutive().WHOLE_EXTENT(), [0, 16] * 3, 6)
"""
DATA = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
information = self.GetExecutive().GetOutputInformation(0)
time = information.Get(self.GetExecutive().UPDATE_TIME_STEP()) if information.Has(self.GetExecutive().UPDATE_TIME_STEP()) else 0.0
image = output.VTKObject
image.SetDimensions(17, 17, 17)
image.SetSpacing((1 + 0.1 * time) / 16, 1 / 16, 1 / 16)
x, y, z = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())]).T
velocity = np.column_stack([(1 + 0.5 * time) * (1 + y), 0.3 * np.sin(6 * x + time), 0.2 * np.cos(5 * x)])
array = numpy_to_vtk(velocity, deep=True)
array.SetName("v")
image.GetPointData().AddArray(array)
"""


def series(growth=0.5):
    """`growth`: of the speed, in units of that at time 0 per unit of time."""
    source = pvs.ProgrammableSource(OutputDataSetType="vtkImageData", Script=DATA.replace("0.5 * time", f"{growth} * time"), ScriptRequestInformation=INFORMATION)
    source.UpdatePipeline(TIMES[0])
    return source


def place_of(smoke):
    smoke.UpdatePropertyInformation()
    return np.array([*smoke.Center, smoke.Radius])


def times_of(smoke):
    smoke.UpdatePropertyInformation()
    return [smoke.DurationUsed, smoke.TimeStepUsed]


def period_of(puffs):
    puffs.UpdatePropertyInformation()
    return puffs.ActualPeriod


def film(view, smoke, puffs, times=TIMES):
    """Places, durations with time steps, and periods, one for each time."""
    found = []
    for time in times:
        view.ViewTime = time
        pvs.Render(view)
        found.append([*place_of(smoke), *times_of(smoke), period_of(puffs)])
    return np.array(found)


def check_steady(flow):
    view, moved = new_view((60, 60)), pvs.Transform(Input=flow)
    smoke = pvs.FlowVolume(Input=moved)
    puffs = pvs.SmokePuffs(Input=smoke)
    pvs.Show(puffs, view)
    first = film(view, smoke, puffs)
    check((first == first[0]).all() and first[0, -1] > 0, f"place, duration and period change with the time: {first.tolist()}")
    again = film(view, smoke, puffs, (2.0, 0.0))
    check((again == first[0]).all(), f"place, duration and period on the way back: {again.tolist()}")
    smoke.Duration = 0.5 * smoke.DurationUsed
    view.ViewTime = 3.0
    pvs.Render(view)
    check(period_of(puffs) < 0.7 * first[0, -1], f"the period of half the smoke is {period_of(puffs)}, of all {first[0, -1]}")
    check((place_of(smoke) == first[0, :4]).all(), "another Duration moves the polygon")
    moved.Transform.Scale = [3, 3, 3]
    view.ViewTime = 0.0  # at other times the flow is another
    pvs.Render(view)
    check(place_of(smoke)[3] > 2 * first[0, 3], f"the polygon does not follow other data: radius {place_of(smoke)[3]}")
    placed = [0.5, 0.6, 1.2, 0.1]
    smoke.Center, smoke.Radius, puffs.Period = placed[:3], placed[3], 0.125
    given = film(view, smoke, puffs)[:, [0, 1, 2, 3, -1]]
    check((given == [*placed, 0.125]).all(), f"the place and the period of the user: {given.tolist()}")
    pvs.Delete(view)


def check_much_faster():
    """A duration that suits a flow of a quarter of the speed is no longer kept: a time step would lead through much of the data."""
    view = new_view((60, 60))
    smoke = pvs.FlowVolume(Input=series(growth=4))
    pvs.Show(smoke, view)
    found = []
    for time in TIMES:
        view.ViewTime = time
        pvs.Render(view)
        bounds = np.array(smoke.GetDataInformation().GetBounds())
        found.append([times_of(smoke)[0], np.linalg.norm(bounds[1::2] - bounds[::2])])
    durations, lengths = np.array(found).T
    speeds = 1 + 4 * np.array(TIMES)
    check((durations[1:] < durations[0] / 4).all() and (durations * speeds / durations[0] < 4.5).all(), f"durations of faster and faster smoke: {durations}")
    check((lengths > lengths[0] / 2).all(), f"smoke is lost: {lengths} long")
    pvs.Delete(view)


def check_unsteady(flow, messages):
    """Nothing at the first time, with one message; later puffs of one period, a quarter of the series."""
    messages.clear()
    view = new_view((60, 60))
    smoke = pvs.FlowVolume(Input=flow, Unsteady=1)
    puffs = pvs.SmokePuffs(Input=smoke)
    pvs.Show(puffs, view)
    for time in (0.0, 0.0, 1.0, 0.0):
        film(view, smoke, puffs, (time,))
        told = [text for text in messages if "There is no smoke at time 0" in text]
        check(len(told) == len(messages) == 1, f"at time {time}: {messages}")
        check("Play the animation" in told[0] and "later time, such as 4, or switch Unsteady off" in told[0], f"no remedy: {told}")
    periods = film(view, smoke, puffs, TIMES[1:])[:, -1]
    check((periods == (TIMES[-1] - TIMES[0]) / 4).all(), f"periods of unsteady puffs: {periods}")
    pvs.Delete(view)


load_plugin()
messages = listen()
flow = series()
check_steady(flow)
check_much_faster()
check_unsteady(flow, messages)
passed()
