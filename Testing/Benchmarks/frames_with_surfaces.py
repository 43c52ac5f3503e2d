# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What translucent surfaces among the cells cost: still frames of the GFS globe with 0, 1, 2, 4 and 8 shells inside the clouds.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included; the ratio to the frame without surfaces is what to
quote. Every shell covers the whole planet, which is opaque: a peel takes two surfaces, the first peel one.
"""
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderWindow, vtkRenderer

from nephoscope_testing.weather import cloud_volume, forecast_globe

SIZE = 1024
RADIUS, HEIGHT = 6371000.0, 15000.0 * 45  # metres, exaggerated
FRAMES = 3


def clouds(grid):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(grid)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    return cloud_volume(mapper, 2e5)


def shell(radius, opacity):
    sphere = vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(90)
    sphere.SetPhiResolution(90)
    actor = vtkActor()
    actor.SetMapper(vtkPolyDataMapper())
    actor.GetMapper().SetInputConnection(sphere.GetOutputPort())
    actor.GetProperty().SetOpacity(opacity)
    return actor


def still_frame(grid, surfaces):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.UseDepthPeelingOn()
    renderer.UseDepthPeelingForVolumesOn()
    renderer.SetMaximumNumberOfPeels(20)
    renderer.SetOcclusionRatio(0)
    renderer.AddVolume(clouds(grid))
    renderer.AddActor(shell(0.99 * RADIUS, 1.0))
    for i in range(surfaces):
        renderer.AddActor(shell(RADIUS + (i + 1) / (surfaces + 1) * HEIGHT, 0.2))
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    window.Render()
    times = []
    for _ in range(FRAMES):
        start = time.process_time()
        window.Render()
        times.append(time.process_time() - start)
    return sorted(times)[FRAMES // 2]


grid = forecast_globe()
print(f"| translucent surfaces ({SIZE} x {SIZE}) | still frame s | times the frame without |")
print("|---|---|---|")
bare = 0
for surfaces in (0, 1, 2, 4, 8):
    seconds = still_frame(grid, surfaces)
    bare = bare or seconds
    print(f"| {surfaces} | {seconds:.2f} | {seconds / bare:.2f} |", flush=True)
