# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids for the tests of smoothing and cloud surfaces, and numpy views of what comes out. Fields are [k, j, i]."""
import numpy as np
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid, vtkStructuredGrid

import nephoscope

HIDDEN_POINT, HIDDEN_CELL = 2, 32


def array(name, values):
    made = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    made.SetName(name)
    return made


def add(data, fields):
    """Point arrays from [k, j, i(, component)]; the first one becomes the active scalars."""
    for name, values in fields.items():
        values = np.asarray(values)
        flat = values.reshape((-1,) + values.shape[3:]) if values.ndim >= 3 else values
        data.GetPointData().AddArray(array(name, flat))
    if fields:
        data.GetPointData().SetActiveScalars(next(iter(fields)))
    return data


def image(field, spacing=(1, 1, 1), origin=(0, 0, 0), name="f"):
    made = vtkImageData()
    made.SetDimensions(*np.asarray(field).shape[:3][::-1])
    made.SetSpacing(*spacing)
    made.SetOrigin(*origin)
    return add(made, {name: field})


def rectilinear(x, y, z, fields=None):
    made = vtkRectilinearGrid()
    made.SetDimensions(len(x), len(y), len(z))
    made.SetXCoordinates(array("x", np.asarray(x, float)))
    made.SetYCoordinates(array("y", np.asarray(y, float)))
    made.SetZCoordinates(array("z", np.asarray(z, float)))
    return add(made, fields or {})


def structured(positions, fields=None):
    """positions: [k, j, i, 3]."""
    made = vtkStructuredGrid()
    made.SetDimensions(*positions.shape[:3][::-1])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(positions.reshape(-1, 3)), deep=True))
    made.SetPoints(points)
    return add(made, fields or {})


def globe_positions(columns=24, rows=13, radii=(1.0, 1.1, 1.25, 1.3), repeat=True):
    """Longitudes with or without the first one again, latitudes from pole to pole."""
    lon = np.linspace(0, 2 * np.pi, columns, endpoint=False)
    lon = np.append(lon, lon[0]) if repeat else lon
    lat = np.linspace(-np.pi / 2, np.pi / 2, rows)
    r, y, x = np.meshgrid(radii, lat, lon, indexing="ij")
    ring = np.cos(y)
    ring[:, [0, -1]] = 0  # the pole is one point
    return np.stack([r * ring * np.cos(x), r * ring * np.sin(x), r * np.sin(y)], axis=-1)


def closed(field):
    """The first column again at the end."""
    return np.concatenate([field, field[:, :, :1]], axis=2)


def set_up(made, settings):
    for name, value in settings.items():
        if name == "Periodic":
            for axis in np.atleast_1d(value):
                made.SetPeriodic(int(axis), True)
        else:
            getattr(made, "Set" + name)(value)


def run(made, data, expect=(), setup=None):
    """Updates; every message must contain one of `expect`, and each of those must come."""
    made.SetInputDataObject(data)
    if setup:
        setup(made)
    with Messages() as messages:
        made.Update()
    for text in expect:
        assert any(text in m for m in messages.all), (text, messages.all)
    unexpected = [m for m in messages.all if not any(text in m for text in expect)]
    assert not unexpected, unexpected
    return made.GetOutputDataObject(0)


def smooth(data, iterations=1, expect=(), setup=None, **settings):
    made = nephoscope.vtkStructuredSmoothing()
    made.SetNumberOfIterations(iterations)
    set_up(made, settings)
    return run(made, data, expect, setup)


def surface(data, values, smoothing=0, expect=(), setup=None, **settings):
    made = nephoscope.vtkCloudSurface()
    made.SetNumberOfSmoothingIterations(smoothing)
    made.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        made.SetValue(i, value)
    set_up(made, settings)
    return run(made, data, expect, setup)


def values(data, name="f"):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def cube(data, name="f"):
    e = data.GetExtent()
    flat = values(data, name)
    return flat.reshape((e[5] - e[4] + 1, e[3] - e[2] + 1, e[1] - e[0] + 1) + flat.shape[1:])


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def triangles(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def cell_values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def edge_counts(data):
    """How often each edge is used: {1: boundary edges, 2: inner edges, ...}."""
    t = triangles(data)
    edges = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
    _, uses = np.unique(edges, axis=0, return_counts=True)
    return dict(zip(*np.unique(uses, return_counts=True)))


def boundary_edges(data):
    """Ends of the edges of one triangle only, (n, 2, 3)."""
    t = triangles(data)
    edges = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
    unique, uses = np.unique(edges, axis=0, return_counts=True)
    return points(data)[unique[uses == 1]]
