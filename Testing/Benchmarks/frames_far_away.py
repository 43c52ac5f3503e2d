# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a volume costs that covers little of a large picture: still frames from near and from far away, and a scene without a volume.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included; use them as ratios.
"""
import time

import nephoscope
import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty

SIZE = 1600
FRAMES = 9


def ball(cells):
    image = vtkImageData()
    image.SetDimensions(*(cells + 1,) * 3)
    image.SetSpacing(*(1 / cells,) * 3)
    x = (np.arange(cells + 1) / cells - 0.5) ** 2
    values = numpy_to_vtk((1 - 2 * np.sqrt(x[:, None, None] + x[:, None] + x)).ravel(), deep=True)
    values.SetName("s")
    image.GetPointData().SetScalars(values)
    return image


def still_frame(zoom):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    if zoom:
        mapper, volume, prop = nephoscope.vtkCellCompositingMapper(), vtkVolume(), vtkVolumeProperty()
        mapper.SetInputData(ball(40))
        color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
        for s in (0, 1):
            color.AddRGBPoint(s, 1, s, 0)
            opacity.AddPoint(s, 3 * s)
        prop.SetColor(color)
        prop.SetScalarOpacity(opacity)
        volume.SetMapper(mapper)
        volume.SetProperty(prop)
        renderer.AddVolume(volume)
        renderer.ResetCamera()
        renderer.GetActiveCamera().Dolly(zoom)
        renderer.ResetCameraClippingRange()
    window.Render()
    times = []
    for _ in range(FRAMES):
        start = time.process_time()
        window.Render()
        times.append(time.process_time() - start)
    return sorted(times)[FRAMES // 2]


bare = still_frame(0)
print(f"{SIZE} x {SIZE} pixels; a frame without a volume takes {bare:.3f} s")
print("| distance | frame s, above that without a volume |")
print("|---|---|")
for zoom in (1, 0.5, 0.25, 0.1, 0.02):
    print(f"| {1 / zoom:g} | {still_frame(zoom) - bare:.3f} |", flush=True)
