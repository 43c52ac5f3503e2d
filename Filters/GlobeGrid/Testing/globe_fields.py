# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids of longitudes, latitudes and levels for the tests, and numpy views of what comes out."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid, vtkStructuredGrid

import nephoscope

RADIUS = 6371000.0
PRESSURES = np.array([1000.0, 850.0, 500.0, 200.0])  # hPa


def array(name, values):
    made = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    made.SetName(name)
    return made


def mesh(lon, lat, lev):
    """Coordinates of all points in VTK's order (longitude fastest), each 1-D."""
    z, y, x = np.meshgrid(lev, lat, lon, indexing="ij")
    return x.ravel(), y.ravel(), z.ravel()


def add(grid, arrays, cells=False):
    data = grid.GetCellData() if cells else grid.GetPointData()
    for name, values in arrays.items():
        data.AddArray(array(name, values))
    return grid


def rectilinear(lon, lat, lev, arrays=None):
    grid = vtkRectilinearGrid()
    grid.SetDimensions(len(lon), len(lat), len(lev))
    grid.SetXCoordinates(array("lon", np.asarray(lon, float)))
    grid.SetYCoordinates(array("lat", np.asarray(lat, float)))
    grid.SetZCoordinates(array("lev", np.asarray(lev, float)))
    return add(grid, arrays or {})


def structured(x, y, z, dimensions, arrays=None):
    grid = vtkStructuredGrid()
    grid.SetDimensions(*dimensions)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([x, y, z]).astype(float), deep=True))
    grid.SetPoints(points)
    return add(grid, arrays or {})


class Messages(list):
    """Error and warning texts of an algorithm and its executive."""

    def __init__(self, algorithm):
        def keep(caller, event, text):
            self.append(text)
        keep.CallDataType = "string0"
        for source in (algorithm, algorithm.GetExecutive()):
            source.AddObserver("ErrorEvent", keep)
            source.AddObserver("WarningEvent", keep)


def globe(grid=None, quiet=True, **settings):
    """The filter with its setters called: globe(grid, VerticalExaggeration=50)."""
    made = nephoscope.vtkGlobeGrid()
    made.messages = Messages(made)
    if grid is not None:
        made.SetInputData(grid)
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    made.Update()
    if quiet:
        unexpected = [m for m in made.messages if "wind arrays" not in m]
        assert not unexpected, unexpected
    return made


def dimensions(output):
    size = [0, 0, 0]
    output.GetDimensions(size)  # VTK 9.6 wants the argument for structured grids, VTK 9.2 takes it
    return tuple(size)


def points(output):
    return vtk_to_numpy(output.GetPoints().GetData())


def values(output, name, cells=False):
    data = output.GetCellData() if cells else output.GetPointData()
    return vtk_to_numpy(data.GetArray(name))


def cube(output, flat):
    """Points of the output as [k, j, i(, component)]."""
    e = output.GetExtent()
    size = (e[5] - e[4] + 1, e[3] - e[2] + 1, e[1] - e[0] + 1)
    return flat.reshape(size + flat.shape[1:])


def frame(x, y):
    """East, north, up at degrees, each (n, 3): by differentiating the position, not by the filter's formula."""
    lon, lat = np.radians(x), np.radians(y)
    up = np.column_stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
    east = np.cross([0.0, 0.0, 1.0], np.column_stack([np.cos(lon), np.sin(lon), 0 * lon]))
    return east, np.cross(up, east), up


def corner_determinants(output):
    """Triple product of the three edges at the first corner of each hexahedron, in units of the cell's size."""
    p = cube(output, points(output))
    o = p[:-1, :-1, :-1]
    a, b, c = p[:-1, :-1, 1:] - o, p[:-1, 1:, :-1] - o, p[1:, :-1, :-1] - o
    return np.einsum("...i,...i", np.cross(a, b), c)
