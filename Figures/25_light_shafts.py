# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 25: shafts of light in haze below a broken layer of cloud. On the left clouds cast no shadows in the haze, on the right they do.

vtkSunlight computes the light in the clouds. vtkHaze takes the fraction of the sun's beam that they let through from it, and shades the haze along every ray. The layer
of cloud is made of random waves. Writes the picture (1600 x 600).
"""
import argparse
import os
import sys

import numpy
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  the factory
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderer

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import nephoscope  # noqa: E402
import pictures  # noqa: E402
import vtk_globe  # noqa: E402

NAME = "25_light_shafts"
POINTS, SPACING, BASE = (161, 161, 17), (100.0, 100.0, 100.0), 2600.0  # metres
WIDTH = 160 * SPACING[0]
ELEVATION, AZIMUTH = numpy.radians((40, 25))
SUN = (numpy.cos(ELEVATION) * numpy.cos(AZIMUTH), numpy.cos(ELEVATION) * numpy.sin(AZIMUTH), numpy.sin(ELEVATION))
WATER = (0.05, 0.07, 0.08)
MOST = 0.03                          # extinction of the cloud, 1/m
WHITE = 0.7                          # light that is shown as white


def waves(random):
    """Random waves whose amplitude falls with their number, of mean 0 and standard deviation 1."""
    number = numpy.hypot(*numpy.meshgrid(numpy.fft.fftfreq(POINTS[1]), numpy.fft.fftfreq(POINTS[0]), indexing="ij")) * POINTS[0]
    spectrum = numpy.where((number > 4) & (number < 40), (number + 2) ** -2.0, 0)
    field = numpy.fft.ifft2(spectrum * numpy.fft.fft2(random.standard_normal(number.shape))).real
    return field / field.std()


def clouds():
    """Cloud where the waves are high, with a flat base and rounded tops."""
    thickness = 800.0 * numpy.sqrt(numpy.clip(waves(numpy.random.default_rng(25)) + 0.7, 0, None) / 2)
    height = numpy.arange(POINTS[2])[:, None, None] * SPACING[2]
    fraction = numpy.clip((thickness + 100.0 - height) / 200.0, 0, 1) * (thickness > 0) * numpy.clip(height / 100.0, 0, 1)
    data = vtkImageData()
    data.SetDimensions(POINTS)
    data.SetSpacing(SPACING)
    data.SetOrigin(0, -WIDTH / 2, BASE)
    array = numpy_to_vtk((MOST * fraction).ravel(), deep=1)
    array.SetName("Extinction")
    data.GetPointData().AddArray(array)
    return data


def lit(data):
    light = nephoscope.vtkSunlight()
    light.SetInputData(data)
    light.SetSunDirection(SUN)
    light.Update()
    return light.GetOutput()


def volume(data):
    """The light of each point, and its extinction as it is."""
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("Sunlight")
    mapper.SetOpacityArrayName("ScaledExtinction")
    return vtk_globe.volume(mapper, [(0, 0, 0, 0), (WHITE, 1.0, 0.98, 0.94)], [(0, 0), (MOST, 1)], 1 / MOST)


def panel(window, data, left, shadows):
    renderer = vtkRenderer()
    renderer.SetViewport(left, 0, left + 0.5, 1)
    renderer.SetBackground(0.10, 0.16, 0.28)
    window.AddRenderer(renderer)
    renderer.AddActor(vtk_globe.sea(WATER, 2e5))
    renderer.AddVolume(volume(data))
    vtk_globe.look(renderer, eye=(-6000, -2000, 700), focus=(8000, 0, 2000), up=(0, 0, 1), angle=42)
    renderer.ResetCameraClippingRange()
    haze = nephoscope.vtkHaze()
    haze.SetProjectionToMap()
    haze.SetVisibility(55e3)
    haze.SetScaleHeight(3000)
    haze.SetVerticalExaggeration(1)
    haze.SetColor(0.45, 0.43, 0.39)
    haze.SetSunDirection(SUN)
    haze.SetCloudShadows(shadows)
    nephoscope.vtkHaze.SetHaze(renderer, haze)


options = argparse.ArgumentParser(description="Haze below clouds, without and with shafts of light: a picture.")
options.add_argument("--size", type=int, nargs=2, default=[1600, 600], help="width and height, pixels")
window = vtk_globe.make_window(options.parse_args().size, samples=0)
data = lit(clouds())
for left, shadows in ((0, False), (0.5, True)):
    panel(window, data, left, shadows)
window.Render()
pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"))
