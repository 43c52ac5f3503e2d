# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the analysis through VTK, which is there wherever Nephoscope is, so that no NetCDF module is needed."""
import hashlib

import numpy as np


class Analysis:
    """levels: hPa; latitudes and longitudes: radians; fields: {name: (longitude, latitude, level) or (longitude, latitude, 1)}."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.digest = hashlib.sha256(file.read()).hexdigest()
        volume, ground = _read(path, "(lev, lat, lon)"), _read(path, "(lat, lon)")
        self.longitudes, self.latitudes = (np.radians(_axis(volume, axis)) for axis in "XY")
        self.levels = np.abs(_axis(volume, "Z"))
        self.time = volume.GetInformation().Get(volume.DATA_TIME_STEP())  # hours
        self.fields = {**_fields(volume), **_fields(ground)}

    def on_levels(self, name, levels):
        """The field on those of its levels (hPa)."""
        return self.fields[name][:, :, [int(np.flatnonzero(np.abs(self.levels - level) < 1e-3)[0]) for level in levels]]


def _read(path, dimensions):
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
    reader = vtkNetCDFCFReader()
    reader.SetFileName(path)
    reader.UpdateMetaData()
    reader.SphericalCoordinatesOff()
    reader.SetDimensions(dimensions)
    reader.SetOutputType(3)  # VTK_RECTILINEAR_GRID, also where the axes are even
    reader.UpdateInformation()
    reader.UpdateTimeStep(reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())[0])
    output = reader.GetOutput()
    if output is None or output.GetPointData().GetNumberOfArrays() == 0:
        raise OSError("%s holds no fields of the dimensions %s" % (path, dimensions))
    return output


def _axis(grid, name):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    return vtk_to_numpy(getattr(grid, "Get%sCoordinates" % name)()).astype(float)


def _fields(grid):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    size, data = grid.GetDimensions(), grid.GetPointData()
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {a.GetName(): vtk_to_numpy(a).astype(float).reshape(size[::-1]).transpose(2, 1, 0) for a in arrays}
