# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames with haze against the same frames without, in one run: surfaces, cells and splats of the GFS forecast over the globe.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included; frames with and without haze alternate, and the ratio is what to quote.
"""
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from nephoscope_testing.weather import cloud_volume, forecast_globe
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

RADIUS = 6.371e6
EXAGGERATION = 30
SIZE = 768
PAIRS = 6


def planet():
    sphere = vtkSphereSource()
    sphere.SetRadius(RADIUS)
    sphere.SetThetaResolution(180)
    sphere.SetPhiResolution(90)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor.SetMapper(mapper)
    return actor


def medium(data, mapper):
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    return cloud_volume(mapper, 2e5)


def scene(prop):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    renderer.AddViewProp(prop)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(3.2 * RADIUS, 0, 0.5 * RADIUS)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(40)
    renderer.ResetCameraClippingRange()
    haze = nephoscope.vtkHaze()
    haze.SetVerticalExaggeration(EXAGGERATION)
    nephoscope.vtkHaze.SetHaze(renderer, haze)
    return window, haze


def frame(window, haze, on):
    haze.SetEnabled(on)
    start = time.process_time()
    window.Render()
    window.WaitForCompletion()
    return time.process_time() - start


def main():
    data = forecast_globe(EXAGGERATION)
    rays, cells = nephoscope.vtkCellCompositingMapper(), nephoscope.vtkCellCompositingMapper()
    rays.SetMethodToRays()
    cells.SetMethodToCells()
    scenes = {"surface": planet(), "cells, by rays": medium(data, rays), "cells, one by one": medium(data, cells),
              "splats": medium(data, nephoscope.vtkTexturedSplatMapper())}
    print(f"{'':20}{'clear, s':>10}{'hazed, s':>10}{'ratio':>8}")
    for name, prop in scenes.items():
        window, haze = scene(prop)
        for on in (False, True, False, True):  # programs are made
            frame(window, haze, on)
        times = [[frame(window, haze, on) for on in (False, True)] for _ in range(PAIRS)]
        clear, hazed = (sorted(column)[PAIRS // 2] for column in zip(*times))
        print(f"{name:20}{clear:10.3f}{hazed:10.3f}{hazed / clear:8.2f}", flush=True)


main()
