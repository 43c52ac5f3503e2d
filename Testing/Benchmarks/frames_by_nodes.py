# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the times of frames with colour and opacity functions of many control points, as multiples of the time with two colours.

    ./nephoscope bench [pixels] [frames]

The GFS globe in moving frames of Cell Compositing. The cases take turns, and each has the least time of its frames. Colours are those of 256-entry tables
rounded to 8 bits, as lookup tables of scripts have them, or curves between few points, as in ParaView's Cool to Warm.
"""
import sys
import time

import numpy as np
import pyvista
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (registers the OpenGL classes)
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from nephoscope_testing.weather import cloud_scene, forecast_globe
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import nephoscope

CASES = ("two colours", "Cool to Warm, diverging", "viridis, 256 entries", "turbo, 256 entries", "viridis, 256 entries, and 256 opacities", "256 random colours")


def set_functions(prop, name):
    colour, opacity = prop.GetRGBTransferFunction(), prop.GetScalarOpacity()
    if name == "two colours":
        return
    colour.RemoveAllPoints()
    if name.startswith("Cool"):
        colour.SetColorSpaceToDiverging()
        for row in ((0, 0.23137, 0.298039, 0.752941), (0.5, 0.865, 0.865, 0.865), (1, 0.705882, 0.0156863, 0.14902)):
            colour.AddRGBPoint(*row)
        return
    colours = np.random.default_rng(1).uniform(size=(256, 3)) if "random" in name else pyvista.LookupTable(name.split(",")[0]).values[:, :3] / 255
    for x, rgb in zip(np.linspace(0, 1, len(colours)), colours):
        colour.AddRGBPoint(x, *rgb)
    if "opacities" in name:
        opacity.RemoveAllPoints()
        for x in np.linspace(0, 1, 256):
            opacity.AddPoint(x, max(0, (x - 0.05) / 0.95))


def scene(globe, name, separate, size):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(globe)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("light" if separate else "cloud_fraction")
    if separate:
        mapper.SetOpacityArrayName("cloud_fraction")
    renderer, window = cloud_scene(mapper, 2e5, size)
    set_functions(renderer.GetVolumes().GetItemAsObject(0).GetProperty(), name)
    window.Render()
    renderer.GetActiveCamera().Elevation(35)
    window.Render()
    return renderer, window


def frame(renderer, window):
    renderer.GetActiveCamera().Azimuth(7)
    renderer.ResetCameraClippingRange()
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def main():
    size, frames = [int(a) for a in sys.argv[1:3]] + [512, 10][len(sys.argv) - 1:]
    globe = forecast_globe()
    light = numpy_to_vtk(1 - 0.5 * vtk_to_numpy(globe.GetPointData().GetArray("cloud_fraction")), deep=True)
    light.SetName("light")
    globe.GetPointData().AddArray(light)
    print(f"{size} x {size} pixels, least of {frames} frames, times that with two colours\n")
    print("| colour and opacity functions | opacity of the coloured array | of another array |\n|---|---|---|")
    ratios = []
    for separate in (False, True):
        scenes = [scene(globe, name, separate, size) for name in CASES]
        times = np.min([[frame(*s) for s in scenes] for _ in range(frames)], axis=0)
        ratios.append(times / times[0])
    for name, *both in zip(CASES, *ratios):
        print(f"| {name} | " + " | ".join(f"{r:.2f}" for r in both) + " |")


if __name__ == "__main__":
    main()
