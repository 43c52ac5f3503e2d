# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the cost of sunlight: of the forecast on the globe, and of random clouds on 320 x 160 points in 19 levels.

    ./nephoscope bench

Seconds, the least of three runs: as a clock shows them, and of processors, all threads together. `rays` is with the sun's beam alone; `sun` a new
direction of the sun, `eye` a new eye. Reading and Cloud Optics are not counted.
"""
import os
import time

import numpy as np
from nephoscope import vtkCloudOptics, vtkSunlight
from nephoscope_testing.weather import forecast_globe
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData


def forecast():
    optics = vtkCloudOptics()
    optics.SetInputData(forecast_globe())
    optics.Update()
    return optics.GetOutput()


def random_clouds(nx=320, ny=160, nz=19):
    """Smooth noise on 100 km x 50 km x 10 km; optical depths up to about 100."""
    noise = np.random.default_rng(0).normal(size=(nz, ny, nx))
    for axis, width in ((0, 2), (1, 6), (2, 6)):
        frequency = np.fft.fftfreq(noise.shape[axis]).reshape([-1 if a == axis else 1 for a in range(3)])
        noise = np.fft.ifft(np.fft.fft(noise, axis=axis) * np.exp(-2 * (np.pi * width * frequency) ** 2), axis=axis).real
    image = vtkImageData()
    image.SetDimensions(nx, ny, nz)
    image.SetSpacing(1e5 / nx, 5e4 / ny, 1e4 / (nz - 1))
    array = numpy_to_vtk(np.maximum(noise / noise.std(), 0).ravel() * 1e-2, deep=1)
    array.SetName("Extinction")
    image.GetPointData().AddArray(array)
    return image


def seconds(algorithm, change):
    best = np.array([np.inf, np.inf])
    for k in range(3):
        change(k)
        start = np.array([time.perf_counter(), time.process_time()])
        algorithm.Update()
        best = np.minimum(best, np.array([time.perf_counter(), time.process_time()]) - start)
    return best


def main():
    print(f"{os.cpu_count()} processors")
    print(f"{'data':>16} {'points':>9} {'of':>5} {'clock':>7} {'processor':>10} {'iterations':>10}")
    for name, data in (("forecast", forecast()), ("320 x 160 x 19", random_clouds()), ("160 x 80 x 19", random_clouds(160, 80))):
        light = vtkSunlight()
        light.SetInputData(data)
        light.UseViewPositionOn()
        for what, change in (("rays", lambda k: (light.SetMultipleScattering(False), light.SetSunDirection(1, -1, 0.5 + 0.1 * k))),
                             ("sun", lambda k: (light.SetMultipleScattering(True), light.SetSunDirection(1, -1, 0.5 + 0.1 * k))),
                             ("eye", lambda k: light.SetViewPosition(k, 1, 1))):
            clock, processor = seconds(light, change)
            print(f"{name:>16} {data.GetNumberOfPoints():9} {what:>5} {clock:7.2f} {processor:10.2f} {light.GetNumberOfIterations():10}")


if __name__ == "__main__":
    main()
