# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames at rest, with a ray for each pixel, and frames of a moving camera, which have as many rays as ten frames a second allow.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included; use them as ratios. "lit" has colour and extinction from vtkSunlight and
vtkCloudOptics; "unlit" the same extinction in one colour. The pixels between rays follow the elapsed time and so the load of the machine.
"""
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

from nephoscope_testing.weather import cloud_scene, forecast_globe

MOVES = 8


def output(algorithm, data=None):
    if data is not None:
        algorithm.SetInputDataObject(data) if hasattr(algorithm, "SetInputDataObject") else algorithm.AddInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def lit_globe():
    optics = nephoscope.vtkCloudOptics()
    optics.SetInputData(forecast_globe())
    sunlight = nephoscope.vtkSunlight()
    sunlight.SetInputConnection(optics.GetOutputPort())
    sunlight.SetSunDirection(0.3, -1, 0.4)
    return output(sunlight)


def scenes():
    globe = forecast_globe()
    globe.GetPointData().SetActiveScalars("cloud_fraction")
    yield "globe, structured", globe, "cloud_fraction", "", 2e5
    yield "globe, unstructured", output(vtkAppendFilter(), globe), "cloud_fraction", "", 2e5
    yield "globe, tetrahedra", output(vtkDataSetTriangleFilter(), globe), "cloud_fraction", "", 2e5
    lit = lit_globe()
    largest = lit.GetPointData().GetArray("ScaledExtinction").GetRange()[1]
    yield "globe, unlit", lit, "ScaledExtinction", "", 1 / largest
    yield "globe, lit", lit, "Sunlight", "ScaledExtinction", 1 / largest
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(*(-49, 50) * 3)
    yield "image of 100³ points", output(wavelet), "RTData", "", 30


def frame(renderer, window):
    renderer.GetActiveCamera().Azimuth(3)
    renderer.ResetCameraClippingRange()
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def median(times):
    return sorted(times)[len(times) // 2]


def measure(data, array, opacity, unit_distance, size):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(array)
    mapper.SetOpacityArrayName(opacity)
    renderer, window = cloud_scene(mapper, unit_distance, size)
    properties = renderer.GetVolumes().GetItemAsObject(0).GetProperty()
    low, high = data.GetPointData().GetArray(opacity or array).GetRange()
    properties.GetScalarOpacity().RemoveAllPoints()
    properties.GetScalarOpacity().AddPoint(low + (0.05 if array == "cloud_fraction" else 0) * (high - low), 0)
    properties.GetScalarOpacity().AddPoint(high, 1)
    low, high = data.GetPointData().GetArray(array).GetRange()
    properties.GetRGBTransferFunction().RemoveAllPoints()
    properties.GetRGBTransferFunction().AddRGBPoint(low, *((0, 0, 0) if opacity else (1, 1, 1)))
    properties.GetRGBTransferFunction().AddRGBPoint(high, 1, 1, 1)
    window.Render()
    renderer.ResetCamera()
    rest = median([frame(renderer, window) for _ in range(3)])
    window.SetDesiredUpdateRate(10)
    moving = median([frame(renderer, window) for _ in range(MOVES)])
    return rest, moving, mapper.GetLastImageSampleDistance()


if __name__ == "__main__":
    print("| data | pixels | at rest s | moving s | rest / moving | pixels between rays |")
    print("|---|---|---|---|---|---|")
    for name, *scene in scenes():
        for size in (512, 1024):
            rest, moving, distance = measure(*scene, size)
            print(f"| {name} | {size}² | {rest:.3f} | {moving:.3f} | {rest / moving:.1f} | {distance:g} |", flush=True)
