# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Advected texture coordinates made in one call, and globes with winds that are known."""
import hashlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkStructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP

from .filters import configured
from .messages import Messages

RADIUS = 6371000.0
DAY = 86400.0


def advection(source, points=None, **settings):
    """The filter, not yet updated. source: data or an algorithm."""
    import nephoscope
    made = configured(nephoscope.vtkTextureCoordinateAdvection(), source, settings)
    if points is not None:
        made.SetInputData(1, points)
    return made


def update(made, time=None):
    """(texture, messages)"""
    with Messages() as messages:
        made.Update() if time is None else made.UpdateTimeStep(time)
    return Texture(made.GetOutputDataObject(0)), messages.all


class Texture:
    """The output as numpy arrays."""

    def __init__(self, output):
        self.output = output
        self.sets = [self.point_array(f"TextureCoordinates{i}") for i in (1, 2)]
        self.weights, self.ages = self.field_array("TextureWeights"), self.field_array("TextureAges")

    def point_array(self, name):
        array = self.output.GetPointData().GetArray(name)
        return None if array is None else vtk_to_numpy(array).copy()

    def field_array(self, name):
        array = self.output.GetFieldData().GetArray(name)
        return None if array is None else vtk_to_numpy(array).copy()

    def digest(self):
        made = hashlib.sha256()
        for array in (*self.sets, self.weights, self.ages):
            made.update(array.tobytes())
        return made.hexdigest()


def direction(longitude, latitude):
    return np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], axis=-1)


def of_place(coordinates):
    """Unit vectors of the texture coordinates of a globe."""
    return direction(2 * np.pi * coordinates[:, 0], 2 * np.pi * coordinates[:, 1])


def turned(points, axis, angle):
    """Rodrigues' formula; axis of unit length."""
    axis = np.asarray(axis, float)
    along = points @ axis
    return points * np.cos(angle) + np.cross(axis, points) * np.sin(angle) + np.outer(along, axis) * (1 - np.cos(angle))


class Globe(VTKPythonAlgorithmBase):
    """A time series of winds on a globe. motion(unit vectors, height in m, time): angular velocity (1/s) and rise (m/s)."""

    def __init__(self, motion, times=None, columns=72, rows=37, levels=(0.0, 5000.0, 10000.0), poles=True, closed=True,
                 heights=None, hidden=None, radius=RADIUS):
        super().__init__(nInputPorts=0, outputType="vtkStructuredGrid")
        self.motion, self.times, self.levels, self.radius = motion, times, np.asarray(levels, float), radius
        self.heights, self.hidden, self.reads = heights, hidden, []
        self.longitudes = np.radians(np.arange(columns + (1 if closed else 0)) * 360 / columns)
        half = 0.5 * np.pi * (1 if poles else 1 - 1 / rows)
        self.latitudes = np.linspace(-half, half, rows)

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(SDDP.WHOLE_EXTENT(), (0, len(self.longitudes) - 1, 0, len(self.latitudes) - 1, 0, len(self.levels) - 1), 6)
        if self.times is not None:
            info.Set(SDDP.TIME_STEPS(), [float(t) for t in self.times], len(self.times))
            info.Set(SDDP.TIME_RANGE(), [float(self.times[0]), float(self.times[-1])], 2)
        return 1

    def grid(self, time):
        height, latitude, longitude = np.meshgrid(self.levels, self.latitudes, self.longitudes, indexing="ij")
        unit = direction(longitude, latitude).reshape(-1, 3)
        unit[np.abs(latitude.ravel()) > 0.5 * np.pi - 1e-12, :2] = 0
        height = height.ravel() if self.heights is None else self.heights(unit, height.ravel(), time)
        angular, rise = self.motion(unit, height, time)
        r = (self.radius + height)[:, None]
        points = vtkPoints()
        points.SetData(numpy_to_vtk(unit * r, deep=True))
        grid = vtkStructuredGrid()
        grid.SetDimensions(len(self.longitudes), len(self.latitudes), len(self.levels))
        grid.SetPoints(points)
        velocity = r * np.broadcast_to(angular, unit.shape) + np.broadcast_to(rise, height.shape)[:, None] * unit
        add(grid, velocity.astype(np.float32), "DisplayVelocity")
        add(grid, np.sin(3 * unit[:, 0]) + time, "Cloud")
        if self.hidden is not None:
            add(grid, np.where(self.hidden(unit, height), 2, 0).astype(np.uint8), "vtkGhostType")
        for name, value in (("PlanetRadius", self.radius), ("GlobeGridProjection", 0.0)):
            array = numpy_to_vtk(np.array([value]), deep=True)
            array.SetName(name)
            grid.GetFieldData().AddArray(array)
        return grid

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(SDDP.UPDATE_TIME_STEP()) if info.Has(SDDP.UPDATE_TIME_STEP()) else 0.0
        if self.times is not None and len(self.times):
            time = min(self.times, key=lambda t: abs(t - time))
        self.reads.append(time)
        output = vtkStructuredGrid.GetData(outputs)
        output.ShallowCopy(self.grid(time))
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


def add(data, values, name):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def rotation(axis, rate):
    """The motion of a planet that turns about an axis, rad/s."""
    axis = rate * np.asarray(axis, float) / np.linalg.norm(axis)
    return lambda unit, height, time: (np.cross(axis, unit), 0.0)
