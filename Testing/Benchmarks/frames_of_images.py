# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames of an image, ParaView's Wavelet, against VTK's GPU volume mapper and against the same cells as a list of tetrahedra.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included: the median of frames of a moving camera, the mappers in turn.
VTK's mapper samples the ray; with its default settings it takes fewer samples of a moving picture.
"""
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

POINTS, PIXELS, FRAMES = 100, 400, 9
FUNCTIONS = {"ramp to 1": ((0, 0), (1, 1)), "ramp to 0.02": ((0, 0), (1, 0.02)), "upper third to 0.1": ((0, 0), (0.7, 0), (1, 0.1)),
             "upper tenth to 0.1": ((0, 0), (0.9, 0), (1, 0.1))}


def wavelet():
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*3 * (-POINTS // 2, POINTS // 2 - 1))
    source.Update()
    return source.GetOutput()


def scene(mapper, span, function):
    low, high = span
    colour, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for t, rgb in ((0, (0.23, 0.3, 0.75)), (0.5, (0.87, 0.87, 0.87)), (1, (0.7, 0.02, 0.15))):
        colour.AddRGBPoint(low + t * (high - low), *rgb)
    for t, alpha in function:
        opacity.AddPoint(low + t * (high - low), alpha)
    volume, renderer, window = vtkVolume(), vtkRenderer(), vtkRenderWindow()
    volume.SetMapper(mapper)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetInterpolationTypeToLinear()
    renderer.AddVolume(volume)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(PIXELS, PIXELS)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Elevation(20)
    renderer.GetActiveCamera().Azimuth(30)
    return renderer, window


def frame(renderer, window):
    renderer.GetActiveCamera().Azimuth(7)
    renderer.ResetCameraClippingRange()
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def main():
    image = wavelet()
    divided = vtkDataSetTriangleFilter()
    divided.SetInputData(image)
    divided.Update()
    print(f"| opacity over the range ({POINTS}³ points, {PIXELS}²) | image s | VTK's GPU mapper s | tetrahedra s | image / GPU mapper | image / tetrahedra |")
    print("|---|---|---|---|---|---|")
    for name, function in FUNCTIONS.items():
        mappers = nephoscope.vtkCellCompositingMapper(), vtkOpenGLGPUVolumeRayCastMapper(), nephoscope.vtkCellCompositingMapper()
        scenes = []
        for mapper, data in zip(mappers, (image, image, divided.GetOutput())):
            mapper.SetInputData(data)
            scenes.append(scene(mapper, image.GetScalarRange(), function))
            frame(*scenes[-1])
        times = zip(*([frame(*s) for s in scenes] for _ in range(FRAMES)))
        ours, peer, listed = (sorted(t)[FRAMES // 2] for t in times)
        print(f"| {name} | {ours:.3f} | {peer:.3f} | {listed:.3f} | {ours / peer:.1f} | {ours / listed:.2f} |", flush=True)


main()
