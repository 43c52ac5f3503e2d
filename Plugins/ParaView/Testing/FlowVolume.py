# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flow Volume and Smoke Puffs in ParaView: closed-form volumes, the place found, a polygon of one's own, time, state, the picture."""
import os

import numpy as np
from PluginTesting import GFS, NAME, OUTPUT, check, check_same, color_and_alpha, image, load_plugin, look, new_view, passed, pvs, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

EXTENT = [-10, 10, -10, 10, -10, 10]
AREA = 12 / 2 * np.sin(2 * np.pi / 12)  # of the regular polygon of radius 1


def wind(x, y="0", z="0", source=None):
    """A wavelet with a wind that is a formula of the coordinates."""
    source = source or pvs.Wavelet(WholeExtent=EXTENT)
    calculator = pvs.Calculator(Input=source, ResultArrayName="wind", Function=f"({x})*iHat+({y})*jHat+({z})*kHat")
    calculator.UpdatePipeline()
    return calculator


def output_of(proxy, time=None):
    proxy.UpdatePipeline(time) if time is not None else proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def volume_and_mass(proxy):
    sizes = pvs.CellSize(Input=proxy, ComputeLength=0, ComputeArea=0)
    data = output_of(sizes)
    pvs.Delete(sizes)
    volumes = np.abs(cell_array(data, "Volume"))
    return volumes.sum(), float(np.sum(volumes * cell_array(data, "Density")))


def check_number(found, expected, name, tolerance=1e-9):
    print(f"{name}: {found!r}, expected {expected!r}", flush=True)
    check(abs(found - expected) <= tolerance * np.maximum(abs(expected), 1), f"{name} is {found}, expected {expected}")


def check_uniform():
    smoke = pvs.FlowVolume(Input=wind("2"), Velocity=["POINTS", "wind"], Center=[-5, 0, 0], Radius=1, Duration=4, TimeStep=0.5)
    data = output_of(smoke)
    volume, mass = volume_and_mass(smoke)
    check_number(volume, AREA * 2 * 4, "volume")
    check_number(mass, AREA * 2 * 4, "mass")
    check(set(cell_array(data, "EmissionStep")) == set(range(8)), "emission steps")
    check(data.GetPointData().HasArray("RTData"), "the arrays of the input are not there")
    smoke.UpdatePropertyInformation()
    check(np.allclose(smoke.NormalUsed, (1, 0, 0)), f"the normal used is {list(smoke.NormalUsed)}")
    check_number(smoke.DurationUsed, 4, "duration used")
    check_number(smoke.EmittedMass, AREA * 2 * 4, "emitted mass")
    smoke.NormalToFlow, smoke.Normal = 0, [1, 1, 0]
    check_number(volume_and_mass(smoke)[0], AREA * np.sqrt(0.5) * 2 * 4, "oblique volume")
    return smoke


def check_expanding():
    """A source flow: the volume element grows by exp(2 t); where it is thinner the density is lower, and the mass is that of the polygon."""
    smoke = pvs.FlowVolume(Input=wind("1", "coordsY", "coordsZ"), Velocity=["POINTS", "wind"], Center=[-5, 0, 0], Radius=1, Duration=1,
                           TimeStep=1 / 32, InitialDensity=3)
    volume, mass = volume_and_mass(smoke)
    check_number(mass, 3 * AREA, "mass of an expanding volume", 1e-6)
    check_number(volume, AREA * (np.exp(2) - 1) / 2, "expanding volume", 5e-3)
    density = cell_array(output_of(smoke), "Density")
    check(density.min() < 3 * np.exp(-1.8) and density.max() < 3, f"density {density.min()} to {density.max()}")


def check_fading():
    """Where smoke leaves the data triangle by triangle, it fades without bands across the stream: of the grey values of a row, the second differences are rounding."""
    view = new_view((500, 500))
    pvs.Show(pvs.FlowVolume(Input=wind("1+0.05*(coordsX+10)", "0.15*coordsY", "0.15*coordsZ"), Velocity=["POINTS", "wind"],
                            Center=[-0.5, 0.5, -0.5], Radius=20 * np.sqrt(3) / 50), view)
    pvs.ResetCamera(view)
    grey = image(view).astype(float).mean(axis=2)
    rows = [row[row > 0] for row in grey if (row > 0).sum() > 400]  # those that the stream crosses from end to end
    bends = [np.abs(np.diff(row[len(row) * 3 // 4:-40], 2)).max() for row in rows]
    check(len(rows) > 5 and np.median(bends) < 3, f"{len(rows)} rows bend by {np.median(bends)} of 255 where smoke fades")


def check_place():
    """A fresh filter is where the flow is fast, faces it, and its polygon is inside."""
    jet = wind("3*exp(-((coordsY-4)^2+(coordsZ+3)^2)/4)")
    smoke = pvs.FlowVolume(Input=jet)
    check(list(smoke.Velocity) == ["POINTS", "wind"], f"the velocity is {list(smoke.Velocity)}")
    check(np.linalg.norm(np.subtract(smoke.Center[1:3], (4, -3))) < 1, f"the centre is {list(smoke.Center)}")
    check(np.allclose(smoke.Normal, (1, 0, 0), atol=1e-6), f"the normal is {list(smoke.Normal)}")
    check_number(smoke.Radius, 20 * np.sqrt(3) / 50, "radius")
    check(output_of(smoke).GetNumberOfCells() > 1000, "no smoke from the place that was found")
    on_cells = pvs.PointDatatoCellData(Input=jet)
    on_cells.UpdatePipeline()
    for number in range(3):  # the smoke before, which is active, has the velocity at points
        another = pvs.FlowVolume(Input=on_cells)
        check(list(another.Velocity) == ["CELLS", "wind"] and another.Radius > 0, f"smoke {number} of a velocity on cells: {list(another.Velocity)}, radius {another.Radius}")
        another.UpdatePipeline()
    chosen = pvs.FlowVolume(Input=jet, Center=[1, 2, 3], Radius=0.5)
    check(list(chosen.Center) == [1, 2, 3] and chosen.Radius == 0.5, "a place from a script is overridden")


def check_place_follows():
    """Before there are data nothing is made up; when there are, and when they change, the place is found anew, unless it has been touched."""
    weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=50)
    smoke = pvs.FlowVolume(Input=globe)
    check(smoke.Radius >= 0, f"without data the radius is {smoke.Radius}")
    seen = []
    for exaggeration in (50, 1, 20):
        globe.VerticalExaggeration = exaggeration
        cells = output_of(smoke).GetNumberOfCells()
        seen.append((*smoke.Center, smoke.Radius))
        check(1000 < cells <= 100_000, f"{cells} tetrahedra at an exaggeration of {exaggeration}")
        check(smoke.Radius > 0, f"radius {smoke.Radius}")
    check(len(set(seen)) == 3, f"the place has not followed the data: {seen}")
    smoke.Radius = 12345
    globe.VerticalExaggeration = 1
    smoke.UpdatePipeline()
    check(smoke.Radius == 12345 and (*smoke.Center,) == seen[-1][:3], "a place that has been touched has moved")
    chosen = pvs.FlowVolume(Input=pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="v", Function="coordsX*jHat+2*kHat"), Center=[0, 0, 0], Radius=1)
    chosen.UpdatePipeline()
    check(list(chosen.Center) == [0, 0, 0] and chosen.Radius == 1, "a place chosen before there were data has moved")


def messages_of(update):
    """What ParaView's output window gets."""
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        update()
    finally:
        vtkOutputWindow.SetInstance(before)
    return window.GetOutput()


def check_messages():
    """They name properties as the panel does, and each is told once."""
    smoke = pvs.FlowVolume(Input=wind("2"), Velocity=["POINTS", "wind"], Center=[-5, 0, 0], Radius=1, TimeStep=0.01,
                           MaximumNumberOfTetrahedra=500)
    text = messages_of(smoke.UpdatePipeline)
    for label in ("Maximum Number Of Tetrahedra (500)", "Time Step of", "Polygon Edge Length of", "Maximum Edge Length of"):
        check(text.count(label) == 1, f"{label!r} is {text.count(label)} times in {text!r}")
    smoke.NormalToFlow, smoke.Normal = 0, [0, 1, 0]
    text = messages_of(smoke.UpdatePipeline)
    check("Normal To Flow" in text and "NormalToFlow" not in text, text)


def check_polygon():
    """A polygon of one's own stays as it is, unless Normal To Flow is set."""
    square = pvs.Plane(Origin=[-5, -1, -1], Point1=[-5, 1, -1], Point2=[-5, -1, 1])
    smoke = pvs.FlowVolumeFromPolygon(Input=wind("2"), Polygon=square, Velocity=["POINTS", "wind"], Duration=2)
    check_number(volume_and_mass(smoke)[0], 4 * 4, "volume from a square")
    oblique = pvs.Plane(Origin=[-5, -1, -1], Point1=[-5, 1, -1], Point2=[-3, -1, 1])
    smoke = pvs.FlowVolumeFromPolygon(Input=wind("2"), Polygon=oblique, Velocity=["POINTS", "wind"], Duration=2)
    check_number(volume_and_mass(smoke)[0], 4 * 4, "volume from an oblique rectangle")
    smoke.NormalToFlow = 1
    check_number(volume_and_mass(smoke)[0], 4 * 4 * np.sqrt(2), "volume from a rectangle that has been turned")


def check_unsteady():
    """A wind that blows faster with every time step: u = 1 + t. Smoke released at s is at t + t^2/2 - s - s^2/2 at time t."""
    times = pvs.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=TIMES_INFORMATION, Script=TIMES)
    times.UpdatePipelineInformation()
    times.UpdatePipeline(0)
    smoke = pvs.FlowVolume(Input=times, Velocity=["POINTS", "wind"], Center=[-5, 0, 0], Radius=1, Unsteady=1, NormalToFlow=0,
                           Normal=[1, 0, 0])
    scene = pvs.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    pvs.Show(smoke)
    for time in (1, 2, 3):
        scene.AnimationTime = time
        volume, mass = volume_at(smoke, time)
        check_number(volume, AREA * (time + time ** 2 / 2), f"streak volume at {time} s", 1e-3)
        check_number(mass, AREA * (time + time ** 2 / 2), f"streak mass at {time} s", 1e-3)


def volume_at(proxy, time):
    data = output_of(proxy, time)
    points = vtk_to_numpy(data.GetPoints().GetData())
    cells = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, 4)
    corner, *others = (points[cells[:, i]] for i in range(4))
    a, b, c = (o - corner for o in others)
    volumes = np.abs(np.einsum("ij,ij->i", a, np.cross(b, c))) / 6
    return volumes.sum(), float(np.sum(volumes * cell_array(data, "Density")))


TIMES_INFORMATION = """
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
information.Set(executive.TIME_STEPS(), [0.0, 1.0, 2.0, 3.0], 4)
information.Set(executive.TIME_RANGE(), [0.0, 3.0], 2)
information.Set(executive.WHOLE_EXTENT(), (0, 20, 0, 10, 0, 10), 6)
"""
TIMES = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
time = information.Get(executive.UPDATE_TIME_STEP()) if information.Has(executive.UPDATE_TIME_STEP()) else 0.0
image = self.GetOutput()
image.SetDimensions(21, 11, 11)
image.SetOrigin(-10, -5, -5)
array = numpy_to_vtk(np.tile((1.0 + time, 0.0, 0.0), (21 * 11 * 11, 1)), deep=1)
array.SetName("wind")
image.GetPointData().AddArray(array)
image.GetInformation().Set(image.DATA_TIME_STEP(), time)
"""


def check_puffs(smoke):
    """Crests of puffs are where the age is the time."""
    puffs = pvs.SmokePuffs(Input=smoke, Period=1, Floor=0)
    for time in (0.25, 0.5):
        data = output_of(puffs, time)
        age, density = cell_array(data, "Age"), cell_array(data, "SmokeDensity")
        phase = (age - time + 0.5) % 1 - 0.5
        check(np.allclose(density, np.where(np.abs(phase) < 0.25, np.cos(2 * np.pi * phase) ** 2, 0), atol=1e-9), f"puffs at {time} s")
    puffs.UpdatePropertyInformation()
    check_number(puffs.ActualPeriod, 1, "period")
    return puffs


def show(proxy):
    view = new_view((200, 200))
    display = pvs.Show(proxy, view)
    check(display.Representation == NAME, f"smoke comes up as {display.Representation}")
    look(view, position=(-1, 0, 30), focal_point=(-1, 0, 0))
    return view, display


def check_picture(smoke):
    """White smoke of a beam: through its middle the optical depth is 1, whatever it is coloured by, and however dense it was made."""
    smoke.NormalToFlow = 1
    smoke.NumberOfSides = 60  # all but a disc
    view, display = show(smoke)
    pvs.ColorBy(display, None)
    picture, alpha = color_and_alpha(view)
    middle = alpha[100, 90:110].mean()
    check(abs(middle - (1 - np.exp(-1))) < 0.02, f"the middle of the beam has an opacity of {middle:.3f}, expected {1 - np.exp(-1):.3f}")
    check(np.ptp(picture[100, 100]) == 0 and alpha[10, 10] == 0, "white smoke on nothing")
    smoke.InitialDensity = 7
    check_same(color_and_alpha(view)[0], picture, "smoke of another density", largest=1)
    smoke.InitialDensity = 1
    pvs.ColorBy(display, ("CELLS", "Age"))
    colored, alpha_colored = color_and_alpha(view)
    check(np.abs(alpha_colored - alpha).max() < 0.02, "colouring by age changes the opacity")
    check(np.ptp(colored[100, 30]) > 20 and np.ptp(colored[100, 170]) > 20, "there are no colours")
    display.CellCompositingOpacityScale = 0.5
    half = color_and_alpha(view)[1][100, 90:110].mean()
    check(abs(half - (1 - np.exp(-0.5))) < 0.02, f"with half the opacity scale it is {half:.3f}")
    return view


def check_puffs_picture(puffs):
    view, display = show(puffs)
    pvs.ColorBy(display, None)
    rows = []
    for time in (0.0, 0.5):
        view.ViewTime = time
        rows.append(color_and_alpha(view)[1][100])
    # Half a period moves crests to where gaps were: speed 2, so a crest every 2 units of length.
    inside = rows[0] + rows[1] > 0.3
    check(np.corrcoef(rows[0][inside], rows[1][inside])[0, 1] < -0.7, "puffs do not move in the picture")
    check(np.max(rows) > 0.5 and rows[0][inside].min() < 0.15, "there are no crests and gaps")


def check_state(smoke):
    smoke.Center, smoke.MaximumTurnAngle, smoke.Integrator = [-4, 1, 0], 10, "Runge-Kutta 4-5"
    for other in pvs.GetRenderViews():
        pvs.Delete(other)
    view, _ = show(smoke)
    before, count = image(view), output_of(smoke).GetNumberOfCells()
    state = os.path.join(OUTPUT, "FlowVolume.pvsm")
    pvs.SaveState(state)
    pvs.ResetSession()
    load_plugin()
    pvs.LoadState(state)
    found = [p for p in pvs.GetSources().values() if p.GetXMLName() == "FlowVolume" and list(p.Center) == [-4, 1, 0]]
    check(len(found) == 1 and found[0].MaximumTurnAngle == 10 and found[0].Integrator == "Runge-Kutta 4-5", "not as saved")
    check(output_of(found[0]).GetNumberOfCells() == count, "the state gives another volume")
    restored = pvs.GetRenderViews()
    check(len(restored) == 1, f"{len(restored)} views")
    check_same(image(restored[0]), before, "state", largest=1)


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_uniform()
check_expanding()
check_fading()
check_place()
check_place_follows()
check_messages()
check_polygon()
check_unsteady()
beam = pvs.FlowVolume(Input=wind("2"), Velocity=["POINTS", "wind"], Center=[-8, 0, 0], Radius=1, Duration=8, TimeStep=0.125)
check_picture(beam)
check_puffs_picture(check_puffs(beam))
check_state(beam)
passed()
