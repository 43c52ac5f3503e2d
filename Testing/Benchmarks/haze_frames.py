# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames with haze against the same frames without, in one run: surfaces, cells and splats of the GFS forecast over the globe; images
and tetrahedra over flat ground, where haze has its default settings.

    ./nephoscope bench
    PYTHONPATH=$PWD/Testing/Python ./nephoscope python Testing/Benchmarks/haze_frames.py image   # scenes whose names contain a word

Seconds are processor time of the whole process, software OpenGL included; frames with and without haze alternate, and the ratio is what to quote.
"""
import sys
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from nephoscope_testing.weather import cloud_volume, forecast_globe
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume

RADIUS = 6.371e6
EXAGGERATION = 30
SIZE = 512
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


def clouds(mapper):
    mapper.SetInputData(forecast_globe(EXAGGERATION))
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    return cloud_volume(mapper, 2e5)


def cells(data=None, method="Rays"):
    mapper = nephoscope.vtkCellCompositingMapper()
    getattr(mapper, "SetMethodTo" + method)()
    if data is None:
        return clouds(mapper)
    mapper.SetInputData(data)
    volume, colour, opacity = vtkVolume(), vtkColorTransferFunction(), vtkPiecewiseFunction()
    low, high = data.GetScalarRange()
    colour.AddRGBPoint(low, 0.2, 0.3, 0.8)
    colour.AddRGBPoint(high, 0.8, 0.1, 0.1)
    opacity.AddPoint(low, 0)
    opacity.AddPoint(high, 0.05)
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    return volume


def wavelet(points):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*3 * (-(points // 2), points - 1 - points // 2))
    source.Update()
    return source.GetOutput()


def with_shadows(data):
    """The fraction of sunlight that the haze takes for shadows: less below."""
    fraction = vtkFloatArray()
    fraction.SetName("SunTransmittance")
    for point in range(data.GetNumberOfPoints()):
        fraction.InsertNextValue(0.3 if data.GetPoint(point)[2] < 0 else 1.0)
    data.GetPointData().AddArray(fraction)
    return data


def tetrahedra(points):
    divided = vtkDataSetTriangleFilter()
    divided.SetInputData(wavelet(points))
    divided.Update()
    return divided.GetOutput()


SCENES = {
    "surface": planet,
    "globe, cells by rays": cells,
    "globe, one by one": lambda: cells(None, "Cells"),
    "globe, splats": lambda: clouds(nephoscope.vtkTexturedSplatMapper()),
    "globe, lit haze": cells,
    "image of 25³ points": lambda: cells(wavelet(25)),
    "image of 100³ points": lambda: cells(wavelet(100)),
    "image 25³, lit haze": lambda: cells(wavelet(25)),
    "image 25³, lit, shadows": lambda: cells(with_shadows(wavelet(25))),
    "tetrahedra, 25³ points": lambda: cells(tetrahedra(25)),
}


def scene(name):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    renderer.AddViewProp(SCENES[name]())
    camera, haze = renderer.GetActiveCamera(), nephoscope.vtkHaze()
    if "image" in name or "tetrahedra" in name:
        renderer.ResetCamera()
        camera.Elevation(-70)
        camera.SetViewUp(0, 0, 1)
        camera.Azimuth(25)
    else:
        camera.SetPosition(3.2 * RADIUS, 0, 0.5 * RADIUS)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(40)
        haze.SetVerticalExaggeration(EXAGGERATION)
    renderer.ResetCameraClippingRange()
    if "lit" in name:
        haze.SetSunDirection(1, -1, 0.7)
    nephoscope.vtkHaze.SetHaze(renderer, haze)
    return window, haze


def frame(window, haze, on):
    haze.SetEnabled(on)
    start = time.process_time()
    window.Render()
    window.WaitForCompletion()
    return time.process_time() - start


def main():
    word = sys.argv[1] if len(sys.argv) > 1 else ""
    print(f"{'':26}{'clear, s':>10}{'hazed, s':>10}{'ratio':>8}")
    for name in (n for n in SCENES if word in n):
        window, haze = scene(name)
        for on in (False, True, False, True):  # programs are made
            frame(window, haze, on)
        times = [[frame(window, haze, on) for on in (False, True)] for _ in range(PAIRS)]
        clear, hazed = (sorted(column)[PAIRS // 2] for column in zip(*times))
        print(f"{name:26}{clear:10.3f}{hazed:10.3f}{hazed / clear:8.2f}", flush=True)


main()
