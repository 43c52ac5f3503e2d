# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wall-clock milliseconds of a frame of every way of drawing, on the OpenGL that the process gets, which is named.

    ./nephoscope bench

The clouds of the forecast over the globe, with a moving camera; the median of frames that have ended on the device (glFinish), after
those that compile and upload. For graphics cards: with software OpenGL it takes minutes, and the other benchmarks count processor time.
"""
import sys
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from nephoscope_testing.weather import cloud_volume, forecast_globe
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

RADIUS = 6.371e6
EXAGGERATION = 45
SIZES = (512, 1024)
FRAMES = 15


def surface(mapper, opacity=1.0):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def globe():
    sphere = vtkSphereSource()
    sphere.SetRadius(0.999 * RADIUS)
    sphere.SetThetaResolution(180)
    sphere.SetPhiResolution(90)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    return surface(mapper)


def volume(mapper, data):
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    return cloud_volume(mapper, 2e5)


def cells(data, method):
    mapper = nephoscope.vtkCellCompositingMapper()
    getattr(mapper, "SetMethodTo" + method)()
    return volume(mapper, data)


def unstructured(grid):
    append = vtkAppendFilter()
    append.AddInputData(grid)
    append.Update()
    return append.GetOutput()


def textured(grid):
    contour = nephoscope.vtkCloudSurface()
    contour.SetInputData(grid)
    contour.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
    contour.SetValue(0, 0.15)
    contour.Update()
    mapper = nephoscope.vtkCloudTextureMapper()
    mapper.SetInputData(contour.GetOutput())
    mapper.SetUseThickness(True)
    mapper.ScalarVisibilityOff()
    return surface(mapper, 0.7)


def view(props, size, hazed):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    for prop in props:
        renderer.AddViewProp(prop)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(3.2 * RADIUS, -2.4 * RADIUS, 1.6 * RADIUS)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(30)
    renderer.ResetCameraClippingRange()
    if hazed:
        haze = nephoscope.vtkHaze()
        haze.SetVerticalExaggeration(EXAGGERATION)
        nephoscope.vtkHaze.SetHaze(renderer, haze)
    return renderer, window


def milliseconds(renderer, window):
    renderer.GetActiveCamera().Azimuth(5)
    renderer.ResetCameraClippingRange()
    start = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    return 1000 * (time.perf_counter() - start)


def main():
    frames = int(sys.argv[1]) if len(sys.argv) > 1 else FRAMES
    grid = forecast_globe(EXAGGERATION)
    mesh = unstructured(grid)
    ways = {"globe alone": (), "rays, structured grid": (cells(grid, "Rays"),), "rays, hexahedra": (cells(mesh, "Rays"),),
            "projection": (cells(grid, "Projection"),), "splats": (volume(nephoscope.vtkTexturedSplatMapper(), grid),),
            "cloud texture, by thickness": (textured(grid),)}
    first = True
    for hazed in (False, True):
        for name, props in ways.items():
            for size in SIZES:
                renderer, window = view((globe(), *props), size, hazed)
                times = [milliseconds(renderer, window) for _ in range(frames + 3)]
                if first:
                    lines = window.ReportCapabilities().splitlines()
                    print("\n".join(line for line in lines if line.startswith("OpenGL") and len(line) < 200))
                    print(f"{grid.GetNumberOfCells()} cells\n\n| drawn | haze | pixels | first frame, ms | median, ms |\n|---|---|---|---|---|")
                    first = False
                print(f"| {name} | {'yes' if hazed else 'no'} | {size}² | {times[0]:.0f} | {sorted(times[3:])[frames // 2]:.2f} |", flush=True)
                for prop in props:
                    prop.GetMapper().ReleaseGraphicsResources(window)
                window.Finalize()


main()
