# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds for the tests of Sunlight, and the light that it computes for them."""
import numpy as np
from nephoscope import vtkSunlight
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStructuredGrid


def image(size, spacing, extinction, origin=(0, 0, 0), **arrays):
    """`extinction` and the other arrays are functions of x, y and z."""
    data = vtkImageData()
    data.SetDimensions(size)
    data.SetSpacing(spacing)
    data.SetOrigin(origin)
    places = np.array([data.GetPoint(p) for p in range(data.GetNumberOfPoints())]).T
    for name, function in {"Extinction": extinction, **arrays}.items():
        add(data, name, np.broadcast_to(function(*places), places[0].shape))
    return data


def add(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=1)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def add_to_cells(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, float), deep=1)
    array.SetName(name)
    data.GetCellData().AddArray(array)


def light_of(data, sun=(0, 0, 1), clouds=None, **options):
    light = vtkSunlight()
    light.SetInputData(data)
    light.SetInputDataObject(1, clouds)
    light.SetSunDirection(sun)
    for name, value in options.items():
        getattr(light, "Set" + name)(value)
    with Messages() as messages:
        light.Update()
    return light.GetOutputDataObject(0), messages.all


def values(output, name):
    return vtk_to_numpy(output.GetPointData().GetArray(name)).astype(float)


def places(output):
    return np.array([output.GetPoint(p) for p in range(output.GetNumberOfPoints())])


def globe(extinction=1e-7):
    """A shell of 24 x 13 x 4 points on a planet of radius 1, with its seam and poles."""
    lon, lat, r = np.meshgrid(np.radians(np.linspace(0, 360, 25)), np.radians(np.linspace(-90, 90, 13)), np.linspace(1, 1.1, 4), indexing="ij")
    xyz = np.stack([r * np.cos(lat) * np.cos(lon), r * np.cos(lat) * np.sin(lon), r * np.sin(lat)], -1).transpose(2, 1, 0, 3).reshape(-1, 3)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(xyz), deep=1))
    grid = vtkStructuredGrid()
    grid.SetDimensions(25, 13, 4)
    grid.SetPoints(points)
    add(grid, "Extinction", np.full(len(xyz), extinction))
    for name, value in (("GlobeGridProjection", 0), ("PlanetRadius", 1), ("VerticalExaggeration", 1)):
        array = numpy_to_vtk(np.array([float(value)]), deep=1)
        array.SetName(name)
        grid.GetFieldData().AddArray(array)
    return grid


def unexpected(messages):
    """The messages that are no warnings of optical depths: these tests use optical depths that no cloud has."""
    return [message for message in messages if "vtkSunlightDepth" not in message]


def beside_sides(messages):
    """The messages that are not about clouds that reach the sides of the data."""
    return [message for message in messages if "Clouds reach the sides" not in message]
