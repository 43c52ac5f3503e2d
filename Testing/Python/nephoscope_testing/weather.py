# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The weather forecast of Data/ on the globe."""
import os

from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader


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
