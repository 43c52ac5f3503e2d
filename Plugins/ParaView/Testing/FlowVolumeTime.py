# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke over a time series whose data grow: the place of its polygon, its duration and time step, and the period of its puffs are those of the first time, so
that a film does not jump; unsteady smoke says at its first time that it needs time to grow, and a camera that is set then sees where it will be; the first
wind that blows places the polygon; the data tell the unit of their times."""
import numpy as np
from PluginTesting import GFS, check, image, listen, load_plugin, new_view, passed, pvs, save_image

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


def shown(view):
    picture = image(view)
    save_image(picture, "FlowVolumeTime-" + str(int(view.ViewTime)))
    return abs(picture - picture[0, 0]).max(axis=2) > 8


def check_first_camera(flow, messages):
    """Set at the first time, where there is no smoke, it looks at the data, and sees the smoke of a film."""
    view = new_view((120, 120))
    smoke = pvs.FlowVolume(Input=flow, Unsteady=1)
    display = pvs.Show(smoke, view)
    view.ViewTime = TIMES[0]
    pvs.ResetCamera(view)
    pvs.Render(view)
    check(display.Representation == "Cell Compositing" and not shown(view).any(), "the first picture")
    check(np.allclose(view.CameraFocalPoint, 0.5, atol=0.1) and 1 < view.CameraPosition[2] < 6, f"the camera is at {view.CameraPosition}, and looks at {view.CameraFocalPoint}")
    view.ViewTime = TIMES[-1]
    pvs.Render(view)
    check(shown(view).mean() > 0.01, f"{shown(view).mean():.1%} of the picture show smoke")
    messages.clear()
    pvs.Delete(view)


def check_still_at_first(messages):
    """The wind begins after time 2: the polygon is where it blows then, and faces it."""
    source = pvs.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=INFORMATION,
                                    Script=DATA.replace('array.SetName("v")', 'array = numpy_to_vtk(velocity * (time > 2) * (time - 2), deep=True)\narray.SetName("v")'))
    source.UpdatePipeline(TIMES[0])
    view = new_view((120, 120))
    messages.clear()
    smoke = pvs.FlowVolume(Input=source, Unsteady=1)
    pvs.Show(smoke, view)
    for time in TIMES:
        view.ViewTime = time
        pvs.Render(view)
    check(len(messages) == 1 and "the flow is zero everywhere up to time 0" in messages[0], f"before the wind: {messages}")
    check(smoke.GetDataInformation().GetNumberOfCells() > 100 and place_of(smoke)[3] > 0, f"no smoke from {place_of(smoke)}")
    check(list(smoke.Center) == [smoke.SMProxy.GetProperty("PlaceCenter").GetElement(i) for i in range(3)], "the panel does not show where the polygon is")
    messages.clear()
    pvs.Delete(view)


def check_unit_of_times(messages):
    """Times in hours, as NetCDFReader and Globe Grid tell: the smoke of hours of wind in m/s."""
    reader = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    grid = pvs.GlobeGrid(Input=reader)
    grid.UpdatePipeline()
    unit = pvs.servermanager.Fetch(pvs.ExtractSubset(Input=grid, VOI=[0, 1] * 3)).GetFieldData().GetAbstractArray("time_units").GetValue(0)
    check(unit.startswith("hours since"), f"the unit of times of {GFS} is {unit!r}")
    script = DATA.replace("numpy_to_vtk(velocity, deep=True)", "numpy_to_vtk(velocity / 3600, deep=True)")
    source = pvs.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=INFORMATION, Script=script + f"""
from vtkmodules.vtkCommonCore import vtkStringArray
unit = vtkStringArray()
unit.SetName("time_units")
unit.InsertNextValue({unit!r})
image.GetFieldData().AddArray(unit)
""")
    messages.clear()
    smoke = pvs.FlowVolume(Input=source, Unsteady=1)
    ages = {}
    for scale in (0, 60, 1):
        smoke.TimeScale = scale
        pvs.UpdatePipeline(time=0.5, proxy=smoke)
        ages[scale or 3600] = smoke.CellData["Age"].GetRange()[1]
    shares = np.array(list(ages.values())) / np.array(list(ages)) / 0.5
    check((shares > 0.8).all() and (shares <= 1).all(), f"ages by the scale of times: {ages}")
    told = [text for text in messages if "set it to 3600 for time steps in hours" in text]
    check(len(told) == len(messages) == 1 and "Time Scale is 1 s" in told[0], f"of units: {messages}")


load_plugin()
messages = listen()
flow = series()
check_steady(flow)
check_much_faster()
check_unsteady(flow, messages)
check_first_camera(flow, messages)
check_still_at_first(messages)
check_unit_of_times(messages)
passed()
