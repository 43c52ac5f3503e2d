# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texture coordinates that move with the wind (`vtkTextureCoordinateAdvection`), of one grid or a time series of them."""
from __future__ import annotations

import warnings
from typing import Any, Callable, Iterator, Literal, Sequence

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkDataObject

from . import vtkTextureCoordinateAdvection
from ._checks import arrays_of, choose, require_number, require_winds
from ._pipeline import level_of_caller, vtk_messages
from ._series import Grids, Series, dataset

MANY = 10  # crossings of the data in a period, beyond which nothing of the texture is left


# What the messages of vtkTextureCoordinateAdvection say, and what it is called here.
_NAMES = {"PressureArrayName": "pressure", "OmegaArrayName": "omega", "PlanetRadius": "planet_radius", "TextureLength": "texture_length",
          "KeyFrameInterval": "key_frame_interval", "MaximumStretch": "maximum_stretch", "TimeStep": "time_step", "TimeScale": "time_scale",
          "Period": "period", "ComputeLyapunovExponent": "lyapunov", "CartesianCoordinates": "cartesian_coordinates",
          "StartFromGrid": "start_from_grid",
          "SetInputArrayToProcess": "vectors", "Tolerance": "tolerance", "Choose a velocity:": "Choose a velocity by vectors:",
          "Leave the points input empty": "Leave points out"}

def advect_texture(mesh: Grids, time: float | Sequence[float] | None = None, *, times: Sequence[float] | None = None,
                   vectors: str | None = None, points: pyvista.DataSet | None = None, period: float | None = None,
                   time_scale: float = 1.0, integrator: Literal["euler", "rk4", "rk45"] = "rk4", time_step: float | None = None,
                   tolerance: float = 1e-6, key_frame_interval: float = 0.0,
                   grid: Literal["automatic", "globe", "map", "cartesian"] = "automatic", planet_radius: float = 0.0,
                   cartesian_coordinates: bool = False, texture_length: float = 0.0, pressure: str | None = None,
                   omega: str | None = None, lyapunov: bool = False,
                   maximum_stretch: float = 0.0, start_from_grid: bool = False) -> pyvista.DataSet | Iterator[pyvista.DataSet]:
    """Give every point the places where its air was when two sets of texture coordinates were born, half a period apart.

    Also the accessor method ``mesh.nephoscope.advect_texture(...)``, for a steady wind. Contour the result with `cloud_surface`, and
    draw the surface with `add_cloud_texture`.

    Parameters
    ----------
    mesh : pyvista.DataSet, sequence of pyvista.DataSet, or callable
        A grid with winds, which is steady; or one for each of `times`; or a function that is called with a time of `times` and
        returns the grid, so that not all are in memory. They are not changed.
    time : float or sequence of float, optional
        When the coordinates are wanted, in the unit of `times`. Default: half a period after 0. A sequence gives an iterator of grids: each field is read once while
        times rise, and one period of winds is in memory.
    times : sequence of float, optional
        The times of the grids, rising. Before the first and after the last the wind is steady. Default: one grid, at 0.
    vectors : str, optional
        Array of the velocity in lengths of the grid per second. Default: ``DisplayVelocity`` if there is one, else the active vectors.
    points : pyvista.DataSet, optional
        Points that are followed in place of those of the grid; they are then the result.
    period : float, optional
        Life of a set in seconds, > 0. Default: 86400 for the data of Globe Grid, otherwise the time in which the fastest air of the first
        grid crosses a quarter of the diagonal of the bounds.
    time_scale : float, default: 1.0
        Seconds in the unit of `time` and `times`, > 0: 3600 for hours.
    integrator : {"rk4", "euler", "rk45"}, default: "rk4"
        Runge-Kutta of fourth order; of first order, as in the paper; of order 5 (4) with error control by `tolerance`.
    time_step : float, optional
        Longest step in seconds, > 0. Default: 1/24 of the default period.
    tolerance : float, default: 1e-6
        Error of one step of ``"rk45"``: radians on a globe, else lengths, > 0.
    key_frame_interval : float, default: 0.0
        Compute only every so many seconds of a set's age and interpolate between, >= 0; 0: compute all.
    grid : {"automatic", "globe", "map", "cartesian"}, default: "automatic"
        What the grid is. Automatic: what `to_globe` says, else a globe if the points are on one, else Cartesian.
    planet_radius : float, default: 0.0
        Displayed radius of height 0 if `to_globe` has not told it, >= 0; 0: that of the first point, on a map 6371000.
    cartesian_coordinates : bool, default: False
        On a globe, coordinates without seam and poles.
    texture_length : float, default: 0.0
        Length of a texture unit in Cartesian grids, >= 0; 0: the width along x.
    pressure, omega : str, optional
        Point arrays of pressure and of its rate following the air: air on a globe then follows its pressure. Both or neither.
    lyapunov : bool, default: False
        Add ``FiniteTimeLyapunovExponent`` (1/s) of the older set.
    maximum_stretch : float, default: 0.0
        Give way to the younger set where the older one has been stretched by this factor, > 1; 0: never.
    start_from_grid : bool, default: False
        Before the first time the air stood still, so that both sets start from the grid; else its wind was that of the first time.

    Returns
    -------
    pyvista.DataSet, or iterator of pyvista.DataSet
        The grid at `time` with the point arrays ``TextureCoordinates1`` and ``TextureCoordinates2`` and the field arrays
        ``TextureWeights``, ``TextureAges`` and ``TextureFrame``; the meaning of all is in Filters/TextureAdvection/README.md.

    Raises
    ------
    TypeError
        If a grid is not a dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If there is no such array; the message lists those that are there.
    ValueError
        If a number or a choice is out of range, or grids and times are not equally many.
    RuntimeError
        If the filter cannot use the grids, with its message.

    Warns
    -----
    RuntimeWarning
        Points without a wind; a `period` in which the air crosses the data many times.
    """
    series = Series(mesh, times)
    filter_ = vtkTextureCoordinateAdvection()
    filter_.SetInputConnection(series.GetOutputPort())
    _set_vectors(filter_, series.first, vectors)
    if points is not None:
        filter_.SetInputData(1, dataset(points, "points"))
    usual = _usual_period(filter_, series.first, period)
    period, time_step = (usual if period is None else period), (usual / 24 if time_step is None else time_step)
    for set_value, value, name in ((filter_.SetPeriod, period, "period"), (filter_.SetTimeScale, time_scale, "time_scale"),
                                   (filter_.SetTimeStep, time_step, "time_step"), (filter_.SetTolerance, tolerance, "tolerance")):
        set_value(require_number(value, name, above=0))
    for set_value, value, name in ((filter_.SetKeyFrameInterval, key_frame_interval, "key_frame_interval"),
                                   (filter_.SetPlanetRadius, planet_radius, "planet_radius"),
                                   (filter_.SetTextureLength, texture_length, "texture_length"),
                                   (filter_.SetMaximumStretch, maximum_stretch, "maximum_stretch")):
        set_value(require_number(value, name, least=0))
    choose({"euler": filter_.SetIntegratorToEuler, "rk4": filter_.SetIntegratorToRungeKutta4,
            "rk45": filter_.SetIntegratorToRungeKutta45}, integrator, "integrator")
    choose({"automatic": filter_.SetGridToAutomatic, "globe": filter_.SetGridToGlobe, "map": filter_.SetGridToMap,
            "cartesian": filter_.SetGridToCartesian}, grid, "grid")
    filter_.SetCartesianCoordinates(cartesian_coordinates)
    filter_.SetStartFromGrid(start_from_grid)
    for name in (pressure, omega):
        if name is not None and name not in series.first.point_data:
            raise MissingDataError(f"pressure and omega: no point array {name!r}. {arrays_of(series.first)}")
    filter_.SetPressureArrayNames(pressure or "", omega or "")
    filter_.SetComputeLyapunovExponent(lyapunov)
    if time is None:
        time = 0.5 * period / time_scale
    if np.ndim(time) == 0:
        return _at(filter_, series, require_number(time, "time"))
    wanted = [require_number(one, "time") for one in time]
    return (_at(filter_, series, one) for one in wanted)


def _usual_period(filter_: vtkTextureCoordinateAdvection, first: pyvista.DataSet, given: float | None) -> float:
    """The period for the size and the speed of the data, with a warning if `given` is far too long for them."""
    crossing = filter_.FindCrossingTime(first)
    if given is not None and crossing > 0 and given > MANY * crossing:
        warnings.warn(f"period is {given:g} s, in which the fastest air crosses the data {given / crossing:.0f} times: the texture will be torn. "
                      f"Leave period out, or give about {0.25 * crossing:.2g}; time_scale has the seconds in the unit of time.",
                      RuntimeWarning, stacklevel=level_of_caller())
    return filter_.FindPeriod(first)


def _at(filter_: vtkTextureCoordinateAdvection, series: Series, time: float) -> pyvista.DataSet:
    with series.raising(), vtk_messages(filter_, _NAMES):
        filter_.UpdateTimeStep(time)
    result = filter_.GetOutputDataObject(0)
    return pyvista.wrap(result).copy(deep=False)


def _set_vectors(filter_: vtkTextureCoordinateAdvection, first: pyvista.DataSet, vectors: str | None) -> None:
    if vectors is None:
        require_winds(first)
        return  # the filter has a rule
    for association, data in ((vtkDataObject.FIELD_ASSOCIATION_POINTS, first.point_data), (vtkDataObject.FIELD_ASSOCIATION_CELLS, first.cell_data)):
        if vectors in data:
            filter_.SetInputArrayToProcess(0, 0, 0, association, vectors)
            return
    raise MissingDataError(f"vectors: no array {vectors!r}. {arrays_of(first, vectors)}")
