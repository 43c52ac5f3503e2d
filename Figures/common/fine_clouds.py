# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds finer than the forecast that they come from: a cloud generator.

    grid = fine_grid((-150, -60), (-20, 50), 0.5, seed=1)   degrees; vtkRectilinearGrid with clwmr, t and gh

Cloud fraction c, cloud water q, temperature and heights of the forecast of Data/ are interpolated (Catmull-Rom) to the fine grid. A fractal noise u, uniform
from 0 to 1, then breaks the clouds: the water is 3 q (u - 1 + c)^2 / c^3 where u > 1 - c, else 0. So the share of c of the fine points has cloud, and
the mean of their water is q. What is finer than 2.5 degrees is therefore made up, as in the cloud generators of radiation schemes (Raisanen et al. 2004).
"""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid

import vtk_globe

LEAST_FRACTION = 0.08  # cloud with less would be a few dense points


def forecast(names=("cloud_fraction", "clwmr", "t", "gh")):
    """Longitudes, latitudes, levels (Pa) and the fields as arrays (level, latitude, longitude)."""
    reader = vtk_globe.read_fields(vtk_globe.ANALYSIS)
    reader.Update()
    grid = reader.GetOutput()
    axes = [vtk_to_numpy(a).astype(float) for a in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())]
    shape = [len(axis) for axis in reversed(axes)]
    fields = {name: vtk_to_numpy(grid.GetPointData().GetArray(name)).reshape(shape).astype(float) for name in names}
    return axes, fields


def weights(coarse, fine, period=None):
    """A matrix that interpolates from equal steps of `coarse` to the places `fine`, by the cubic of Catmull and Rom."""
    at = (numpy.asarray(fine) - coarse[0]) / (coarse[1] - coarse[0])
    first = numpy.floor(at).astype(int)
    t = at - first
    parts = (-0.5 * t + t**2 - 0.5 * t**3, 1 - 2.5 * t**2 + 1.5 * t**3, 0.5 * t + 2 * t**2 - 1.5 * t**3, -0.5 * t**2 + 0.5 * t**3)
    matrix, rows = numpy.zeros((len(fine), len(coarse))), numpy.arange(len(fine))
    for k, part in enumerate(parts):
        column = first - 1 + k
        column = column % period if period else numpy.clip(column, 0, len(coarse) - 1)
        numpy.add.at(matrix, (rows, column), part)
    return matrix


def fractal_noise(shape, seed, slope=3.0, thickness=3.0, longest=None):
    """Noise of power k^-slope in the plane, up to the wavelength `longest` (points), smooth over `thickness` levels; uniform from 0 to 1 at every level."""
    generator = numpy.random.default_rng(seed)
    spectrum = numpy.fft.rfft2(generator.standard_normal(shape))
    wave = numpy.hypot(*numpy.meshgrid(numpy.fft.fftfreq(shape[1]), numpy.fft.rfftfreq(shape[2]), indexing="ij"))
    wave[0, 0] = 1
    noise = numpy.fft.irfft2(spectrum * wave ** (-slope / 2) * (wave > 1.0 / (longest or max(shape[1:]))), shape[1:])
    levels = numpy.arange(shape[0])
    blur = numpy.exp(-0.5 * ((levels[:, None] - levels) / thickness) ** 2)
    noise = numpy.tensordot(blur / numpy.sqrt((blur**2).sum(axis=1, keepdims=True)), noise, 1)
    order = noise.reshape(shape[0], -1).argsort(axis=1).argsort(axis=1)
    return ((order + 0.5) / order.shape[1]).reshape(shape)


def broken(water, fraction, noise, power=2):
    """The water of the fine points: none in the share 1 - fraction of them, the same mean. The greater the power, the more of it is in few points."""
    share = numpy.clip(fraction, LEAST_FRACTION, 1)
    return (power + 1) * water * numpy.maximum(noise - 1 + share, 0) ** power / share ** (power + 1)


def fine_grid(longitudes, latitudes, step, seed=1, levels=slice(None), slope=3.0, closed=False):
    (lon, lat, level), fields = forecast()
    count = round((longitudes[1] - longitudes[0]) / step)
    x = numpy.linspace(*longitudes, count + (0 if closed else 1), endpoint=not closed)
    y = numpy.linspace(*latitudes, round((latitudes[1] - latitudes[0]) / step) + 1)
    along, up = weights(lon, x, len(lon)), weights(lat, y)
    fine = {name: numpy.einsum("yj,kji,xi->kyx", up, field[levels], along, optimize=True) for name, field in fields.items()}
    noise = fractal_noise(fine["t"].shape, seed, slope)
    fine["clwmr"] = broken(numpy.maximum(fine["clwmr"], 0), numpy.clip(fine.pop("cloud_fraction"), 0, 1), noise)
    return grid_of(x, y, level[levels], fine)


def grid_of(x, y, level, fields):
    """Fields (level, latitude, longitude) as a vtkRectilinearGrid."""
    grid = vtkRectilinearGrid()
    grid.SetDimensions(len(x), len(y), len(level))
    for set_axis, axis in ((grid.SetXCoordinates, x), (grid.SetYCoordinates, y), (grid.SetZCoordinates, level)):
        set_axis(numpy_to_vtk(axis, deep=1))
    for name, field in fields.items():
        array = numpy_to_vtk(field.astype(numpy.float32).ravel(), deep=1)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid
