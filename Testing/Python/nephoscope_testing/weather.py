# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The weather forecast of Data/ on the globe, and a volume of clouds as benchmarks draw it."""
import os

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderWindow, vtkRenderer, vtkVolume


def forecast_globe(exaggeration=45):
    """A structured grid with the point array "cloud_fraction" among others."""
    import nephoscope
    reader = vtkNetCDFCFReader()
    reader.SetFileName(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))
    reader.SphericalCoordinatesOff()
    reader.UpdateInformation()
    reader.SetDimensions("(lev, lat, lon)")
    globe = nephoscope.vtkGlobeGrid()
    globe.SetInputConnection(reader.GetOutputPort())
    globe.SetVerticalExaggeration(exaggeration)
    globe.Update()
    return globe.GetOutput()


def cloud_volume(mapper, unit_distance):
    """Clouds that are clear below 0.05; `unit_distance` is the length over which full cloud has an optical depth of 1."""
    volume = vtkVolume()
    volume.SetMapper(mapper)
    colour, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    colour.AddRGBPoint(0, 0.6, 0.7, 1)
    colour.AddRGBPoint(1, 1, 1, 1)
    for value, alpha in ((0, 0), (0.05, 0), (1, 1)):
        opacity.AddPoint(value, alpha)
    volume.GetProperty().SetColor(colour)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(unit_distance)
    return volume


def cloud_scene(mapper, unit_distance, size):
    """(renderer, window) of `size` pixels squared, off screen."""
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.AddVolume(cloud_volume(mapper, unit_distance))
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    return renderer, window
