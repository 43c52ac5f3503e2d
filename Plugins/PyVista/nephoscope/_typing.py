# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What editors and type checkers know of arguments: numbers, choices, options given as a dict, earlier names. The functions check all of them themselves.

Type checkers know `{"style": "streaks"}` by its names, but take `dict(style="streaks")` for any mapping. Functions accept both.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Sequence, TypedDict, Union

import numpy as np

if TYPE_CHECKING:
    import pyvista
    import xarray

    from .accessor import NephoscopeAccessor
    from .weather.accessor import WeatherAccessor

    # PyVista and xarray add accessors when a program runs, so type checkers do not know them. These classes exist for type checkers alone:
    # what the functions return is one of PyVista's or xarray's own.
    class Mesh(pyvista.DataSet):
        nephoscope: NephoscopeAccessor

    class StructuredMesh(pyvista.StructuredGrid):
        nephoscope: NephoscopeAccessor

    class WeatherDataset(xarray.Dataset):
        nephoscope: WeatherAccessor

    AnyMesh = Union[pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset, xarray.DataArray]
else:
    Mesh = StructuredMesh = WeatherDataset = AnyMesh = Any

Numbers = Union[Sequence[float], np.ndarray]
Kernel = Literal["cubic", "quadratic", "gaussian"]
Preference = Literal["point", "cell"]
Integration = Literal["exact", "average"]
Interpolation = Literal["automatic", "trilinear", "tetrahedra"]
Order = Literal["exact", "centroid", "none"]
Method = Literal["automatic", "rays", "cells", "triangles-linear", "triangles-table", "faces"]
ToneMapping = Literal["contrast", "linear", "filmic"]
PolygonChoice = Literal["contours", "all", "none"]


class VectorOptions(TypedDict, total=False):
    """`vectors` of `add_splats`."""
    array: str | None
    style: Literal["streaks", "segments"]
    placement: Literal["middle", "layers"]
    opacity: float | None
    color: Any
    scalars: str | None
    cmap: Any
    clim: float | Numbers | None
    maximum_speed: float | None
    fraction: float | None
    unit: float | None
    streak_period: float
    streak_width: float
    segment_length: float
    segment_width: float
    layer_axis: Literal["eye", 0, 1, 2]
    phase: float
    phase_cycles: int
    phase_steps: int
    true_speed: bool
    time_scale: float | None
    film_time: float
    speed_key: bool | None
    speed_unit: str | None
    length_unit: float


class LevelOfDetailOptions(TypedDict, total=False):
    """`level_of_detail` of `add_splats`."""
    tolerance: float
    unit: Literal["image", "data"]
    measure: Literal["picture", "rms", "greatest"]
    interactive_splats: int
    blending: float


class ContourOptions(TypedDict, total=False):
    """`contours` of `add_cells`."""
    values: int | Numbers | None
    opacity: float | Numbers
    color: Any
    scalars: str | None
    lighting: bool
    smooth: bool


class PolygonOptions(TypedDict, total=False):
    """`polygons` of `add_cells`."""
    which: PolygonChoice
    opacity: float | Numbers
    color: Any


class AdvectionOptions(TypedDict, total=False):
    """Options of `advect_texture`, for one time and for several."""
    times: Numbers | None
    vectors: str | None
    points: pyvista.DataSet | None
    period: float | None
    time_scale: float
    integrator: Literal["euler", "rk4", "rk45"]
    time_step: float | None
    tolerance: float
    key_frame_interval: float
    grid: Literal["automatic", "globe", "map", "cartesian"]
    planet_radius: float
    cartesian_coordinates: bool
    texture_length: float
    pressure: str | None
    omega: str | None
    lyapunov: bool
    maximum_stretch: float
    start_from_grid: bool


class OldSplatNames(TypedDict, total=False):
    """Earlier names of options of `add_splats`."""
    unit_distance: float
    vector_style: str
    vector_placement: str
    vector_opacity: float
    vector_color: Any
    vector_scalars: str
    vector_cmap: Any
    vector_clim: float | Numbers
    greatest_speed: float
    vector_share: float
    vector_unit: float
    streak_period: float
    streak_width: float
    segment_length: float
    segment_width: float
    layer_axis: int
    phase: float
    phase_cycles: int
    phase_steps: int
    error_tolerance: float
    error_unit: str
    error_measure: str
    interactive_splats: int
    level_blending: float


class OldCellNames(TypedDict, total=False):
    """Earlier names of options of `add_cells`."""
    unit_distance: float
    contour_opacity: float | Numbers
    contour_color: Any
    contour_scalars: str
    contour_lighting: bool
    smooth_contours: bool
    polygon_opacity: float | Numbers
    polygon_color: Any
