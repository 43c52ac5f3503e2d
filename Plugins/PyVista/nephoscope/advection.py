# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texture coordinates that move with the wind (`vtkTextureCoordinateAdvection`), for one grid or a time series of grids."""
from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Iterator, Literal, overload

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkDataObject

from . import vtkTextureCoordinateAdvection
from ._checks import arrays_of, choose, require_number, require_winds
from ._pipeline import level_of_caller, vtk_messages
from ._series import Grids, Series, dataset
from ._typing import AdvectionOptions, Numbers

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11

MANY = 10  # number of crossings of the data in a period beyond which the texture is destroyed


# Terms in messages of vtkTextureCoordinateAdvection, and their names in Python.
_NAMES = {"PressureArrayName": "pressure", "OmegaArrayName": "omega", "PlanetRadius": "planet_radius", "TextureLength": "texture_length",
          "KeyFrameInterval": "key_frame_interval", "MaximumStretch": "maximum_stretch", "TimeStep": "time_step", "TimeScale": "time_scale",
          "Period": "period", "ComputeLyapunovExponent": "lyapunov", "CartesianCoordinates": "cartesian_coordinates",
          "StartFromGrid": "start_from_grid",
          "SetInputArrayToProcess": "vectors", "Tolerance": "tolerance", "Choose a velocity:": "Choose a velocity by vectors:",
          "Leave the points input empty": "Leave points out"}


@overload
def advect_texture(mesh: Grids, time: float | None = None, **options: Unpack[AdvectionOptions]) -> pyvista.DataSet: ...
@overload
def advect_texture(mesh: Grids, time: Numbers, **options: Unpack[AdvectionOptions]) -> Iterator[pyvista.DataSet]: ...
def advect_texture(mesh: Grids, time: float | Numbers | None = None, *, times: Numbers | None = None,
                   vectors: str | None = None, points: pyvista.DataSet | None = None, period: float | None = None,
                   time_scale: float = 1.0, integrator: Literal["euler", "rk4", "rk45"] = "rk4", time_step: float | None = None,
                   tolerance: float = 1e-6, key_frame_interval: float = 0.0,
                   grid: Literal["automatic", "globe", "map", "cartesian"] = "automatic", planet_radius: float = 0.0,
                   cartesian_coordinates: bool = False, texture_length: float = 0.0, pressure: str | None = None,
                   omega: str | None = None, lyapunov: bool = False,
                   maximum_stretch: float = 0.0, start_from_grid: bool = False) -> pyvista.DataSet | Iterator[pyvista.DataSet]:
    """Compute two sets of texture coordinates: the positions of each point's air at two start times, half a period apart.

    Also the accessor method ``mesh.nephoscope.advect_texture(...)``, for a steady wind. Contour the result with `cloud_surface` and draw the
    surface with `add_cloud_texture`.

    Parameters
    ----------
    mesh : pyvista.DataSet, sequence of pyvista.DataSet, or callable
        One grid with a steady wind; one grid for each of `times`; or a function that takes one of `times` and returns the grid, so that not all
        grids are in memory. The grids are not changed.
    time : float or sequence of float, optional
        Time, or times, of the result, in the unit of `times`. Default: half a period after 0. A sequence gives an iterator of grids: if its
        times increase, each field is read once, and one period of winds is in memory.
    times : sequence of float, optional
        The times of the grids, increasing. The wind is held constant before the first and after the last time. Default: one grid, at time 0.
    vectors : str, optional
        Array of the velocity, in units of length of the grid per second. Default: ``DisplayVelocity`` if it exists, otherwise the active
        vectors.
    points : pyvista.DataSet, optional
        Points to trace instead of the points of the grid; they are then the result.
    period : float, optional
        Lifetime of a set of coordinates in seconds, > 0. Default: 86400 for data from Globe Grid, otherwise the time in which the fastest air of
        the first grid crosses a quarter of the diagonal of the bounds.
    time_scale : float, default: 1.0
        Seconds per unit of `time` and `times`, > 0: 3600 for hours.
    integrator : {"rk4", "euler", "rk45"}, default: "rk4"
        Runge-Kutta of fourth order; Euler, of first order, as in the paper; or Runge-Kutta 4-5 with adaptive steps, controlled by `tolerance`.
    time_step : float, optional
        Longest integration step in seconds, > 0. Default: 1/24 of the default period.
    tolerance : float, default: 1e-6
        Error tolerance of one step of ``"rk45"``, > 0: in radians on a globe, otherwise in units of length.
    key_frame_interval : float, default: 0.0
        Interval of a set's age, in seconds, at which coordinates are computed, >= 0. Times in between are interpolated. 0: all are computed.
    grid : {"automatic", "globe", "map", "cartesian"}, default: "automatic"
        Geometry of the grid. Automatic: the projection of `to_globe`; without it a globe if the points lie on one, otherwise Cartesian.
    planet_radius : float, default: 0.0
        Displayed radius at height 0, for grids that do not come from `to_globe`, >= 0. 0: the radius of the first point; on a map 6371000.
    cartesian_coordinates : bool, default: False
        On a globe: writes Cartesian coordinates, which have no seam and no poles.
    texture_length : float, default: 0.0
        Length of a texture unit in Cartesian grids, >= 0. 0: the width of the grid along x.
    pressure, omega : str, optional
        Point arrays of pressure and of its rate of change following the air. Pass both: vertical motion on a globe is then integrated in
        pressure instead of height.
    lyapunov : bool, default: False
        Adds ``FiniteTimeLyapunovExponent`` (1/s) of the older set.
    maximum_stretch : float, default: 0.0
        Fades to the younger set where the older set is stretched by more than this factor, > 1; 0: never.
    start_from_grid : bool, default: False
        True: there is no wind before the first time, so that both sets start from the grid. False: the wind of the first time is held constant
        before it.

    Returns
    -------
    pyvista.DataSet, or iterator of pyvista.DataSet
        The grid at `time` with the point arrays ``TextureCoordinates1`` and ``TextureCoordinates2`` and the field arrays ``TextureWeights``,
        ``TextureAges`` and ``TextureFrame``; Filters/TextureAdvection/README.md describes all of them.

    Raises
    ------
    TypeError
        If a grid is not a dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array does not exist; the message lists the arrays that do.
    ValueError
        If a number or a choice is out of range, or the numbers of grids and times differ.
    RuntimeError
        If the filter cannot use the grids, with its message.

    Warns
    -----
    RuntimeWarning
        If points have no wind, or the air crosses the data many times in one `period`.
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
    """The period that suits the size and the speed of the data, with a warning if `given` is far too long."""
    crossing = filter_.FindCrossingTime(first)
    if given is not None and crossing > 0 and given > MANY * crossing:
        warnings.warn(f"period is {given:g} s, in which the fastest air crosses the data {given / crossing:.0f} times: the texture will be distorted. "
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
        return  # the filter chooses
    for association, data in ((vtkDataObject.FIELD_ASSOCIATION_POINTS, first.point_data), (vtkDataObject.FIELD_ASSOCIATION_CELLS, first.cell_data)):
        if vectors in data:
            filter_.SetInputArrayToProcess(0, 0, 0, association, vectors)
            return
    raise MissingDataError(f"vectors: no array {vectors!r}. {arrays_of(first, vectors)}")
