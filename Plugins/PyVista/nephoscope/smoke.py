# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flow volumes: the smoke that a flow carries from a polygon (`vtkFlowVolume`), and its puffs (`vtkSmokePuffs`)."""
from __future__ import annotations

import datetime
from typing import Any, Iterable, Literal

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject

from . import vtkFlowVolume, vtkFlowVolumePlacement, vtkSmokePuffs
from ._blocks import named_blocks
from ._checks import arrays_of, choose, listed, require_number, require_winds
from ._from_xarray import meshed
from ._pipeline import _renamed, set_input, vtk_messages
from ._series import Grids, Series
from ._smoke_units import UNITS, warn_of_units
from ._typing import Numbers

# Terms in messages of vtkFlowVolume, and their names in Python.
_NAMES = {"move the polygon there, by Center if it is regular": "pass that as center, or move the polygon there", "switch NormalToFlow off": "give normal", "switch NormalToFlow on": "leave normal out", "Center": "center", "Radius": "radius",
          "Normal": "normal", "Duration": "duration", "TimeStep": "time_step", "PolygonEdgeLength": "polygon_edge_length",
          "MaximumEdgeLength": "max_edge_length", "MinimumEdgeLength": "min_edge_length", "InitialDensity": "initial_density",
          "MaximumNumberOfTetrahedra": "max_tetrahedra", "StartTime": "start_time", "TimeScale": "time_scale", "or switch Unsteady off": "or leave times out", "Play the animation, choose a later time": "Choose a later time", "Tolerance": "tolerance", "MaximumTurnAngle": "max_turn_angle", "MaximumAreaRatio": "max_area_ratio", "MaximumDivergence": "max_divergence", "ObstacleSize": "obstacle_size",
          "than the velocity, convert them": f"than the velocity, convert them: {UNITS}", "Choose a velocity:": "Choose a velocity by vectors:", "(ObstacleMass)": "(smoke.field_data['ObstacleMass'])", "(LostMass)": "(smoke.field_data['LostMass'])", "Period": "period"}


def flow_volume(mesh: Grids, polygon: pyvista.PolyData | None = None, *, vectors: str | None = None,
                center: Numbers | None = None, radius: float | None = None,
                normal: Numbers | Literal["flow"] | None = None, n_sides: int = 12, duration: float | None = None,
                time_step: float | None = None, initial_density: float = 1.0, polygon_edge_length: float | None = None,
                max_edge_length: float | None = None, min_edge_length: float = 0.0, max_turn_angle: float = 15.0,
                max_area_ratio: float = 2.0, max_divergence: float = 0.5, max_halvings: int = 4, edge_levels: int = 6,
                obstacle_levels: int = 2, obstacle_size: float | None = None,
                integrator: Literal["rk4", "rk45"] = "rk4", tolerance: float = 1e-6,
                max_tetrahedra: int = 100_000, times: Numbers | None = None, time: float | None = None,
                start_time: float | None = None, time_scale: float | None = None) -> pyvista.UnstructuredGrid:
    """Compute smoke: the volume that a flow sweeps from a polygon, as tetrahedra. With `times` the flow is unsteady.

    Also the accessor method ``mesh.nephoscope.flow_volume(...)``. Lengths are in units of length of the mesh, times in seconds.

    Parameters
    ----------
    mesh : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset, sequence of pyvista.DataSet, or callable
        Any mesh with a velocity; one mesh for each of `times`; or a function that takes one of `times` and returns the mesh, so that not all
        meshes are in memory. The meshes are not changed.
    polygon : pyvista.PolyData, optional
        The generating polygon: planar polygons, convex or not. It keeps its orientation unless `normal` is ``"flow"``. Default: the regular
        polygon that the following arguments describe.
    vectors : str, optional
        Point or cell array of three components: the velocity, in units of length of the mesh per second. Default: ``"DisplayVelocity"`` if it
        exists, otherwise the active vectors or the only array of three components.
    center : sequence of 3 float, optional
        Centre of the polygon. Default: where the flow enters the data, or a position where it is fast, and the polygon fits into the data.
    radius : float, optional
        Circumradius of the polygon, > 0. Default: 1/50 of the diagonal of the bounds; if `center` is not given, less where such a
        polygon does not fit, and up to four times as much where the flow enters the data.
    normal : sequence of 3 float or "flow", optional
        Normal of the regular polygon. ``"flow"``: the direction of the flow at the centre of the polygon, for a regular or a given polygon.
        Default: ``"flow"`` for the regular polygon.
    n_sides : int, default: 12
        Number of sides, 3 to 1000.
    duration : float, optional
        Time for which the smoke flows, in seconds, > 0. Default: the time in which the flow at the polygon crosses half the diagonal of the
        bounds; less if `max_tetrahedra` requires it.
    time_step : float, optional
        Time between two layers, in seconds, > 0. Default: 1/64 of the duration, or the time in which the flow crosses 1/32 of the
        diagonal of the bounds if that is shorter; longer if `max_tetrahedra` requires it.
    initial_density : float, default: 1.0
        Density at the polygon.
    polygon_edge_length : float, optional
        Maximum edge length of the triangles into which the polygon is divided, > 0. Default: a quarter of the polygon's extent; longer if
        `max_tetrahedra` requires it.
    max_edge_length : float, optional
        Longer edges of a layer are split, > 0. Default: three times the longest edge of the polygon's triangles, or the distance that the flow
        covers in a time step if that is longer; longer still if `max_tetrahedra` requires it.
    min_edge_length : float, default: 0.0
        Shorter edges of a layer are collapsed; with `times`, those of tetrahedra, at each release. At most `max_edge_length`, of which at most a third
        has an effect. 0: never.
    max_turn_angle : float, default: 15.0
        A time step is halved if a path turns by more than this angle, in degrees. 0: never. With `times`, only points whose path turns more
        take shorter steps (with ``"rk4"``), and more layers are released where the smoke turns at the polygon.
    max_area_ratio : float, default: 2.0
        A time step is halved if the area of a triangle of the layer changes by more than this factor, >= 1. 0: never. Not used with `times`.
    max_divergence : float, default: 0.5
        A time step is halved if the divergence times the step is more than this. 0: never. Not used with `times`.
    max_halvings : int, default: 4
        How often a time step is halved at most, 0 to 16: 4 gives up to 16 parts.
    edge_levels : int, default: 6
        Edges of a layer are halved down to `max_edge_length` over 2 to this power, 0 to 16. Not used with `times`.
    obstacle_levels : int, default: 2
        Before smoke ends at an obstacle, it is divided down to `max_edge_length` over 2 to this power, 0 to 16. 0: never.
    obstacle_size : float, optional
        Size of the smallest obstacles that are found where no corner of the smoke meets them, > 0. Default: that of the smallest blanked cell;
        without blanked cells, obstacles are found at corners only.
    integrator : {"rk4", "rk45"}, default: "rk4"
        Runge-Kutta of fourth order with fixed steps, or Runge-Kutta 4-5 with adaptive steps.
    tolerance : float, default: 1e-6
        Error tolerance of one step of ``"rk45"``, relative to the longest edge of the polygon's triangles; 1e-14 to 1.
    max_tetrahedra : int, default: 100_000
        Maximum number of tetrahedra, >= 1. The filter coarsens the volume until the whole duration fits, and warns if the result is coarser
        than requested.
    times : sequence of float, optional
        The times of the meshes, two or more, increasing numbers, not dates. The flow is unsteady and interpolated linearly in time. Smoke older than `duration` is
        dropped; by default none is. Default: one mesh, a steady flow.
    time : float, optional
        With `times`: time of the result, in the unit of `times`. Default: the last time; later ones give that, with a warning.
    start_time : float, optional
        With `times`: time of the first release, in the unit of `times`. Default: the first time.
    time_scale : float, optional
        With `times`: seconds per unit of `times`, > 0: 3600 for hours. Default: that of the field array ``time_units`` of the first mesh, such as
        "hours since 2011-10-11", which `read_cf` writes; otherwise 1, also if ``TimeValue`` of this mesh is not the first of `times`.

    Returns
    -------
    pyvista.UnstructuredGrid
        Tetrahedra. Cell arrays: ``EmissionStep`` (number of the time step), ``Age`` (s since the smoke left the polygon), ``Density``;
        the sum of density times volume is the emitted mass. Point arrays: ``Age`` and those of `mesh`. Field arrays: ``EmittedMass``; ``LostMass``, the part that is
        not in the volume. ``LostMass`` includes ``ObstacleMass``, which ended at bodies and missing values inside the data, and in a steady flow ``FoldedMass``, of prisms that would have folded.

    Raises
    ------
    TypeError
        If `mesh` or `polygon` has the wrong type.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array of three components does not exist; the message lists the arrays that do.
    ValueError
        If an argument is out of range or contradicts another, or if `center` is not given and the mesh has no flow.
    RuntimeError
        If the filter cannot make a volume, with its message.

    Warns
    -----
    RuntimeWarning
        The warnings of the filter: a polygon partly outside the data, smoke that ended at a body or at velocities that are not finite (with the time of the mesh), a `time` after the last mesh, smoke coarser than requested or much coarser than usual,
        a `duration` of more than two million automatic time steps, a flow that hardly moves in all `times`, or crosses the data several times between two of
        them. And smoke that is short because coordinates are in degrees or kilometres and the velocity in metres per second.

    Examples
    --------
    >>> smoke = mesh.nephoscope.flow_volume(center=(0, 0, 1), radius=0.2, duration=10)  # doctest: +SKIP
    """
    smoke, series = _filter(**locals())
    if series is None:
        with vtk_messages(smoke, _NAMES):
            smoke.Update()
        volume = pyvista.wrap(smoke.GetOutput())
        warn_of_units(volume, meshed(mesh), vectors or "")
        return volume
    with series.raising(), vtk_messages(smoke, _NAMES):
        smoke.UpdateTimeStep(series.times[-1] if time is None else require_number(time, "time"))
    volume = pyvista.wrap(smoke.GetOutput()).copy(deep=False)
    if time is None:  # until an earlier one the smoke may be short
        warn_of_units(volume, series.first, vectors or "")
    return volume


def _filter(mesh: Any, polygon: Any = None, *, vectors: Any, center: Any, radius: Any, normal: Any, n_sides: Any, duration: Any, time_step: Any,
            initial_density: Any, polygon_edge_length: Any, max_edge_length: Any, min_edge_length: Any, max_turn_angle: Any,
            max_area_ratio: Any, max_divergence: Any, max_halvings: Any, edge_levels: Any, obstacle_levels: Any, obstacle_size: Any,
            integrator: Any, tolerance: Any, max_tetrahedra: Any, times: Any, time: Any, start_time: Any,
            time_scale: Any) -> tuple[vtkFlowVolume, Series | None]:
    """The filter described by the arguments of flow_volume, and the meshes of an unsteady flow."""
    smoke = vtkFlowVolume()
    series = None
    if times is None:
        if time is not None or start_time is not None:
            raise ValueError("time or start_time is given without times, the times of the meshes of an unsteady flow.")
        mesh = meshed(mesh)
        if not isinstance(mesh, (pyvista.DataSet, vtkCompositeDataSet)):
            raise TypeError(f"mesh is a {type(mesh).__name__}; it must be a pyvista dataset or MultiBlock, or several meshes with times.{_times_of(mesh)}")
        set_input(smoke, mesh)
    else:
        series = _unsteady(smoke, mesh, times, start_time)
        mesh = series.first
    smoke.SetTimeScale(_time_scale(mesh, times) if time_scale is None else require_number(time_scale, "time_scale", above=0))
    name, on_cells = _velocity(mesh, vectors)
    if name:
        association = vtkDataObject.FIELD_ASSOCIATION_CELLS if on_cells else vtkDataObject.FIELD_ASSOCIATION_POINTS
        smoke.SetInputArrayToProcess(0, 0, 0, association, name)
    if polygon is None:
        smoke.SetNumberOfSides(int(require_number(n_sides, "n_sides", least=3, most=1000)))
        _place(smoke, [mesh] if series is None else series.meshes(), (name, on_cells), center, radius)
    else:
        _take_polygon(smoke, polygon, {"center": center, "radius": radius, "normal": None if _is_flow(normal) else normal})
    if _is_flow(normal):
        smoke.NormalToFlowOn()
    elif normal is not None:
        smoke.NormalToFlowOff()
        smoke.SetNormal(_vector(normal, "normal"))
    for setter, value, argument in ((smoke.SetDuration, duration, "duration"), (smoke.SetTimeStep, time_step, "time_step"),
                                    (smoke.SetPolygonEdgeLength, polygon_edge_length, "polygon_edge_length"),
                                    (smoke.SetMaximumEdgeLength, max_edge_length, "max_edge_length"),
                                    (smoke.SetObstacleSize, obstacle_size, "obstacle_size")):
        setter(0.0 if value is None else require_number(value, argument, above=0))
    smoke.SetMinimumEdgeLength(require_number(min_edge_length, "min_edge_length", least=0))
    smoke.SetMaximumTurnAngle(require_number(max_turn_angle, "max_turn_angle", least=0))
    smoke.SetMaximumAreaRatio(require_number(max_area_ratio, "max_area_ratio", least=0))
    smoke.SetMaximumDivergence(require_number(max_divergence, "max_divergence", least=0))
    for setter, value, argument in ((smoke.SetMaximumHalvings, max_halvings, "max_halvings"), (smoke.SetEdgeLevels, edge_levels, "edge_levels"),
                                    (smoke.SetObstacleLevels, obstacle_levels, "obstacle_levels")):
        setter(int(require_number(value, argument, least=0, most=16)))
    smoke.SetInitialDensity(require_number(initial_density, "initial_density"))
    choose({"rk4": smoke.SetIntegratorToRungeKutta4, "rk45": smoke.SetIntegratorToRungeKutta45}, integrator, "integrator")
    smoke.SetTolerance(require_number(tolerance, "tolerance", above=0))
    smoke.SetMaximumNumberOfTetrahedra(int(require_number(max_tetrahedra, "max_tetrahedra", least=1, most=1e15)))
    return smoke, series


def _times_of(mesh: Any) -> str:
    """What a user who gives several meshes, or a function, has to add."""
    if callable(mesh):
        return " For a function of the time pass times=[...], the times that it is called with."
    if isinstance(mesh, dict):
        return " For meshes in a dict by time pass list(meshes.values()) and times=list(meshes)."
    if isinstance(mesh, (list, tuple)) and len(mesh) > 1:
        return f" For an unsteady flow pass times=[...] with the times of the {len(mesh)} meshes; for a steady flow pass one of them."
    return ""


def _unsteady(smoke: vtkFlowVolume, mesh: Any, times: Numbers, start_time: float | None) -> Series:
    """The meshes as input of the filter."""
    if np.asarray(times).dtype.kind in "mM" or any(isinstance(one, datetime.date) for one in times):
        raise TypeError("times has dates; it must have numbers. For seconds since the first one pass (dates - dates[0]) / numpy.timedelta64(1, 's') "
                        "with dates = numpy.asarray(times, 'datetime64[ns]').")
    if len(times) < 2:
        raise ValueError(f"times has {len(times)} values; an unsteady flow needs two or more. Leave times out for a steady flow.")
    series = Series(mesh, times)
    if any(b <= a for a, b in zip(series.times, series.times[1:])):
        raise ValueError(f"times is {times!r}; they must increase.")
    smoke.SetInputConnection(series.GetOutputPort())
    smoke.UnsteadyOn()
    if start_time is not None:
        smoke.SetStartTime(require_number(start_time, "start_time"))
    return series


def smoke_puffs(volume: pyvista.UnstructuredGrid, time: float = 0.0, *, period: float | None = None, width: float = 0.5,
                floor: float = 0.1, normalization: Literal["peak", "mean"] = "peak", max_density: float | None = None,
                on_points: bool = False) -> pyvista.UnstructuredGrid:
    """Compute the smoke at one time if it is released in puffs, which move along the volume with the flow.

    Also the accessor method ``volume.nephoscope.smoke_puffs(...)``.

    Parameters
    ----------
    volume : pyvista.UnstructuredGrid
        The result of `flow_volume`; it is not changed.
    time : float, default: 0.0
        Time of the result, in seconds. Times that differ by a period give the same puffs.
    period : float, optional
        Time from one puff to the next, in seconds, > 0; with the default `width` at least four time steps of the volume, because puffs that fall
        between cells flicker. Default: a quarter of the maximum age.
    width : float, default: 0.5
        Length of a puff, as a fraction of the period, up to 1.
    floor : float, default: 0.1
        Smoke between puffs, as a fraction of the peak, 0 to 1.
    normalization : {"peak", "mean"}, default: "peak"
        Peak: the peak of a pulse is 1. Mean: the mean of a pulse is 1, which conserves the mass.
    max_density : float, optional
        Higher densities are clamped to this value, > 0.
    on_points : bool, default: False
        Writes values on points, which vary smoothly within cells, instead of values on cells.

    Returns
    -------
    pyvista.UnstructuredGrid
        `volume` with the array ``SmokeDensity``, which `add_smoke` draws.

    Raises
    ------
    TypeError
        If `volume` is not an UnstructuredGrid.
    ValueError
        If an argument is out of range.
    RuntimeError
        If the volume lacks its arrays, with the filter's message.

    Warns
    -----
    RuntimeWarning
        The warnings of the filter: puffs shorter than two time steps of the volume, ages that are not finite.
    """
    if not isinstance(volume, pyvista.UnstructuredGrid):
        raise TypeError(f"volume is a {type(volume).__name__}; it must be an UnstructuredGrid from flow_volume.")
    puffs = vtkSmokePuffs()
    puffs.SetInputData(volume)
    puffs.SetTime(require_number(time, "time"))
    puffs.SetPeriod(0.0 if period is None else require_number(period, "period", above=0))
    puffs.SetWidth(require_number(width, "width", above=0, most=1))
    puffs.SetFloor(require_number(floor, "floor", least=0, most=1))
    puffs.SetMaximumDensity(0.0 if max_density is None else require_number(max_density, "max_density", above=0))
    choose({"peak": puffs.SetNormalizationToPeak, "mean": puffs.SetNormalizationToMean}, normalization, "normalization")
    (puffs.SetAssociationToPoints if on_points else puffs.SetAssociationToCells)()
    with vtk_messages(puffs, _NAMES):
        puffs.Update()
    return pyvista.wrap(puffs.GetOutput())


def _has_vectors(data: Any, name: str) -> bool:
    return name in data and np.ndim(data[name]) == 2 and data[name].shape[1] == 3


def _velocity(mesh: pyvista.DataSet | vtkCompositeDataSet, name: str | None) -> tuple[str, bool]:
    """Name of the velocity, and whether it is a cell array; an empty name leaves the choice to the filter."""
    blocks = [block for _, block in named_blocks(mesh)]
    if name is None:
        for block in blocks[:1]:
            require_winds(block)
        return "", False
    for on_cells in (False, True):
        if any(_has_vectors(b.cell_data if on_cells else b.point_data, name) for b in blocks):
            return name, on_cells
    arrays = arrays_of(blocks[0], name) if blocks else "The mesh is empty."
    raise MissingDataError(f"vectors: no array {name!r} of three components. {arrays}")


def _time_scale(mesh: Any, times: Numbers | None) -> float:
    """0, which leaves it to the filter, if `times` are in the unit that `mesh` tells: other times may be in seconds."""
    told = getattr(mesh, "field_data", {})
    is_other = times is not None and "TimeValue" in told and float(told["TimeValue"][0]) != float(times[0])
    return 1.0 if times is None or is_other else 0.0


def _place(smoke: vtkFlowVolume, meshes: Iterable[Any], velocity: tuple[str, bool], center: Numbers | None,
           radius: float | None) -> None:
    """Centre and radius of the regular polygon, by the first of the meshes in which anything flows."""
    smoke.SetRadius(0.0 if radius is None else require_number(radius, "radius", above=0))
    if center is not None:
        smoke.SetCenter(_vector(center, "center"))
        return
    place = vtkFlowVolumePlacement()
    place.SetNumberOfSides(smoke.GetNumberOfSides())
    if not any(place.Find(mesh, *velocity) for mesh in meshes):
        raise ValueError(_renamed(place.GetProblem(), _NAMES) or "center: the mesh has no position with a flow; pass the centre of the polygon.")
    smoke.SetCenter(place.GetCenter())
    if radius is None:
        smoke.SetRadius(place.GetRadius())


def _take_polygon(smoke: vtkFlowVolume, polygon: Any, others: dict[str, Any]) -> None:
    if isinstance(polygon, str):
        raise TypeError(f"polygon is the text {polygon!r}; it must be a pyvista.PolyData with polygons. To name the array of the velocity: vectors={polygon!r}.")
    if not isinstance(polygon, pyvista.PolyData):
        raise TypeError(f"polygon is a {type(polygon).__name__}; it must be a pyvista.PolyData with polygons.")
    superfluous = [name for name, value in others.items() if value is not None]
    if superfluous:
        raise ValueError(f"polygon is given, and {listed(superfluous)} as well: they describe another polygon, so leave them out.")
    smoke.SetInputDataObject(1, polygon)


def _is_flow(normal: Any) -> bool:
    if isinstance(normal, str) and normal != "flow":
        raise ValueError(f"normal is {normal!r}; it must be three finite numbers or 'flow'.")
    return isinstance(normal, str)


def _vector(values: Numbers, argument: str) -> tuple[float, ...]:
    vector = np.asarray(values, float)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{argument} is {values!r}; it must be three finite numbers.")
    return tuple(float(v) for v in vector)
