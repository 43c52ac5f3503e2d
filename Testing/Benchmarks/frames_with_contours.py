# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What contour surfaces cost: still frames of an image of 369,024 cells without and with surfaces, in one run.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included; the ratio to the frame without surfaces is what to quote.
"""
import time

import nephoscope
import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty

CELLS = (62, 62, 96)
SIZE = (400, 300)
FRAMES = 3


def waves():
    image = vtkImageData()
    image.SetDimensions(*(n + 1 for n in CELLS))
    image.SetSpacing(*(1 / max(CELLS),) * 3)
    x, y, z = (np.arange(n + 1) / max(CELLS) for n in CELLS)
    field = (np.sin(9 * x)[None, None, :] + np.sin(8 * y)[None, :, None] + np.sin(10 * z)[:, None, None]) / 6 + 0.5
    values = numpy_to_vtk(np.ascontiguousarray(field.ravel()), deep=True)
    values.SetName("s")
    image.GetPointData().SetScalars(values)
    return image


def look(clear):
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for s, rgb in ((0, (0.2, 0.3, 0.8)), (0.5, (1, 1, 1)), (1, (0.9, 0.4, 0.2))):
        color.AddRGBPoint(s, *rgb)
    for s, a in ((0, 0), (0.4, 0), (1, 0 if clear else 4)):
        opacity.AddPoint(s, a)
    prop = vtkVolumeProperty()
    prop.SetColor(color)
    prop.SetScalarOpacity(opacity)
    return prop


def frame(image, contours, clear=False):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(image)
    if contours:
        mapper.GenerateContourValues(contours, *(0.5, 0.5) if contours == 1 else (0.2, 0.8))
    mapper.SetContourOpacity(0.4)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(look(clear))
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddVolume(volume)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(30)
    renderer.GetActiveCamera().Elevation(20)
    renderer.GetActiveCamera().Zoom(1.4)
    renderer.ResetCameraClippingRange()
    window.Render()
    times = []
    for turn in range(FRAMES):
        renderer.GetActiveCamera().Azimuth(1)
        start = time.process_time()
        window.Render()
        times.append(time.process_time() - start)
    return sorted(times)[FRAMES // 2]


image = waves()
print(f"{image.GetNumberOfCells()} cells, {SIZE[0]} x {SIZE[1]} pixels, camera turning")
print("| surfaces | medium | frame s | times the frame without surfaces |")
print("|---|---|---|---|")
bare = frame(image, 0)
for contours, clear in ((0, False), (1, False), (5, False), (1, True), (5, True)):
    seconds = frame(image, contours, clear)
    print(f"| {contours} | {'none' if clear else 'white'} | {seconds:.2f} | {seconds / bare:.2f} |", flush=True)
