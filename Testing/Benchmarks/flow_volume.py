# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times updates of vtkFlowVolume on the forecast's globe, against vtkStreamSurface in the same run.

    ./nephoscope bench

Every update moves the polygon a little, as a user who drags it. The search structure of the wind is made by the first update, which has
a row of its own. Wall times depend on what else the machine does; processor time is that of all threads together. The picture is
drawn by whatever OpenGL there is: its name is printed.
"""
import time

import nephoscope
import numpy as np
import pyvista
from nephoscope_testing import weather
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersFlowPaths import vtkStreamSurface
from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the factory)

EXAGGERATION = 45
DURATION, TIME_STEP = 86400.0, 1350.0  # s
UPDATES = 20


def position(longitude, latitude=40.0, height=9000.0):
    """Over the Pacific's jet stream; degrees, m."""
    longitude, latitude = np.radians([longitude, latitude])
    radius = 6371000 + EXAGGERATION * height
    return radius * np.array([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])


def flow_volume(globe, edge):
    made = nephoscope.vtkFlowVolume()
    made.SetInputData(globe)
    made.SetCenter(*position(-150))
    made.SetRadius(3e5)
    made.SetPolygonEdgeLength(edge)
    made.SetDuration(DURATION)
    made.SetTimeStep(TIME_STEP)
    made.SetMaximumNumberOfTetrahedra(10_000_000)
    return made


def move(made, number):
    made.SetCenter(*position(-150 - 0.02 * number))


def measure(action, count=UPDATES):
    """Medians of wall and processor milliseconds."""
    wall, processor = [], []
    for number in range(1, count + 1):
        start = time.perf_counter(), time.process_time()
        action(number)
        wall.append(time.perf_counter() - start[0])
        processor.append(time.process_time() - start[1])
    return 1e3 * np.median(wall), 1e3 * np.median(processor)


def row(name, times, size):
    print(f"| {name} | {times[0]:.1f} | {times[1]:.1f} | {1e3 / times[0]:.0f} | {size} |", flush=True)


def updates(globe, edge):
    made = flow_volume(globe, edge)
    row("vtkFlowVolume, first update", measure(lambda _: made.Update(), 1), f"{made.GetOutput().GetNumberOfCells()} tetrahedra")

    def update(number):
        move(made, number)
        made.Update()
        sizes.append(made.GetOutput().GetNumberOfCells())
    sizes = []
    times = measure(update)
    row("vtkFlowVolume, polygon moved", times, f"{int(np.median(sizes))} tetrahedra (median)")
    return made, times


def stream_surface(globe):
    """About 18,000 points, from a line through the same place."""
    globe.GetPointData().SetActiveVectors("DisplayVelocity")
    line, made = vtkLineSource(), vtkStreamSurface()
    line.SetResolution(280)
    made.SetInputData(0, globe)
    made.SetInputConnection(1, line.GetOutputPort())
    made.SetUseIterativeSeeding(False)
    made.SetIntegratorTypeToRungeKutta4()
    made.SetIntegrationDirectionToForward()
    made.SetIntegrationStepUnit(1)  # lengths
    made.SetInitialIntegrationStep(4e4)
    made.SetMaximumPropagation(1e9)
    made.SetMaximumNumberOfSteps(32)

    def update(number):
        line.SetPoint1(*(position(-150 - 0.02 * number, 37)))
        line.SetPoint2(*(position(-150 - 0.02 * number, 43)))
        made.Update()
    times = measure(update, 5)
    row("vtkStreamSurface, line moved", times, f"{made.GetOutput().GetNumberOfPoints()} points")
    return times


def pictures(made):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputConnection(made.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectScalarArray("Density")
    volume, renderer, window = vtkVolume(), vtkRenderer(), vtkRenderWindow()
    volume.SetMapper(mapper)
    colour, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    colour.AddRGBPoint(0, 1, 1, 1)
    opacity.AddPoint(0, 0)
    opacity.AddPoint(1, 1)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(5e5)
    renderer.AddVolume(volume)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(600, 600)
    window.AddRenderer(renderer)
    window.Render()
    renderer.ResetCamera()

    def draw(number):
        move(made, number)
        window.Render()
    device = [line for line in window.ReportCapabilities().splitlines() if "renderer string" in line]
    device = device[0].split(":", 1)[1].strip() if device else "unknown"
    for rate, rays in ((1e-4, "a picture"), (10, "a picture while dragging")):
        window.SetDesiredUpdateRate(rate)
        row(f"with {rays} of 600² pixels ({device})", measure(draw, 8), f"{made.GetOutput().GetNumberOfCells()} tetrahedra")


def widget(globe):
    """A drag of `add_smoke_widget`, without the globe's surface, after the eight updates in which it finds its pace."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(600, 600))
    plotter.render_window.SetMultiSamples(0)
    dragged = nephoscope.add_smoke_widget(plotter, pyvista.wrap(globe), center=position(-150), radius=3e5, duration=DURATION, color="white")
    plotter.view_vector(position(-150), viewup=(0, 0, 1))
    plotter.show(auto_close=False, interactive=False)
    plotter.render_window.SetDesiredUpdateRate(plotter.iren.interactor.GetDesiredUpdateRate())
    sizes = []

    def draw(number):
        dragged.drag(position(-150 - 0.02 * number))
        plotter.render_window.Render()
        sizes.append(dragged.filter.GetOutput().GetNumberOfCells())
    measure(draw, 8)
    row("add_smoke_widget, dragged, with a picture of 600² pixels", measure(draw), f"{int(np.median(sizes[8:]))} tetrahedra (median)")
    plotter.close()


def main():
    globe = weather.forecast_globe(EXAGGERATION)
    print("| | wall ms | processor ms | updates/s | size |")
    print("|---|---|---|---|---|")
    made, ours = updates(globe, 1.5e5)
    theirs = stream_surface(globe)
    pictures(made)
    widget(globe)
    print(f"\nvtkStreamSurface takes {theirs[0] / ours[0]:.1f} times the wall time, {theirs[1] / ours[1]:.1f} times the processor time.")


main()
