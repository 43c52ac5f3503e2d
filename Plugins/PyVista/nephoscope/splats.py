# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured splats: the samples of any dataset as splats in the shape of their cells, with vectors as moving streaks."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid, vtkStructuredGrid

from . import vtkTexturedSplatMapper
from ._blocks import cell_dimension
from ._checks import choose, renamed_argument, require_beside_scalars, require_number
from ._copies import copied_table
from ._from_xarray import add_earth_for, darken_for, title_with_units
from ._media import is_drawn
from ._medium import Functions, MediumMapper, add_medium, named_extinction, require_dataset, require_plotter, scalar_array, title_of_scalars
from ._options import group, refuse_unknown
from ._pipeline import level_of_caller
from ._uniform import FAINTER, concentration, is_bare, uniform_colours
from ._typing import Kernel, LevelOfDetailOptions, Numbers, OldSplatNames, Preference, ToneMapping, VectorOptions
from ._vectors import OLD_NAMES as VECTOR_NAMES
from ._vectors import Vectors
from .light import brightest, lit_medium, refuse_color
from .transfer import OpacityLike

if TYPE_CHECKING:
    from typing import Unpack  # since Python 3.11

FEWEST = 8  # cells that splats can show
KERNEL_RADII = {"cubic": 1.556228, "quadratic": 1.37790, "gaussian": 1.916}  # cells; SplatKernel.h


class TexturedSplatMapper(MediumMapper, vtkTexturedSplatMapper):
    """The mapper with the properties that PyVista expects, and with the phase as a property."""

    _is_free, _is_carried = True, False  # to be moved by a film, is moved by one

    @property
    def moves_by_itself(self) -> bool:
        """Whether `animate` moves the vectors: the user has set neither ``phase`` nor ``film_time``."""
        return self._is_free and self.GetPhase() == 0

    def carry(self, carries: bool) -> None:
        """Whether the vectors move at their speed in a film, although the user has not asked for ``true_speed``."""
        if carries or self._is_carried:
            self.SetTrueSpeed(carries)
        self._is_carried = carries

    def hold(self) -> None:
        """Leaves ``phase`` and ``film_time`` as they are, also in a film."""
        self._is_free = False

    def copy(self) -> TexturedSplatMapper:
        mapper = super().copy()
        if self.GetVectorColorFunction() is not None:
            mapper.SetVectorColorFunction(copied_table(self.GetVectorColorFunction()))
        return mapper

    @property
    def phase(self) -> float:
        """Position of the streaks in their loop, 0 to 1; 1 is the same as 0. Set it and render the next frame of an animation."""
        return self.GetPhase()

    @phase.setter
    def phase(self, phase: float) -> None:
        self.SetPhase(require_number(phase, "phase"))
        self.hold()
        self.carry(False)

    @property
    def film_time(self) -> float:
        """With ``true_speed``: seconds since the start of the film. Set it and render the next frame."""
        return self.GetFilmTime()

    @film_time.setter
    def film_time(self, seconds: float) -> None:
        self.SetFilmTime(require_number(seconds, "film_time"))
        self.hold()


DETAIL_NAMES = {"error_tolerance": "tolerance", "error_unit": "unit", "error_measure": "measure", "interactive_splats": "interactive_splats",
                "level_blending": "blending"}


@dataclass
class LevelOfDetail:
    """The options `level_of_detail` of `add_splats`; see there. Checked when applied."""
    tolerance: float = 0.0
    unit: str = "image"
    measure: str = "picture"
    interactive_splats: int = 100_000
    blending: float = 0.1

    def apply(self, mapper: TexturedSplatMapper) -> None:
        mapper.SetErrorTolerance(require_number(self.tolerance, "level_of_detail['tolerance']", least=0))
        choose({"image": mapper.SetErrorToleranceUnitToImage, "data": mapper.SetErrorToleranceUnitToData}, self.unit, "level_of_detail['unit']")
        choose({"picture": mapper.SetErrorMeasureToPicture, "rms": mapper.SetErrorMeasureToRootMeanSquare,
                "greatest": mapper.SetErrorMeasureToGreatest}, self.measure, "level_of_detail['measure']")
        mapper.SetLevelBlending(require_number(self.blending, "level_of_detail['blending']", least=0, most=0.9))
        most = require_number(self.interactive_splats, "level_of_detail['interactive_splats']", least=0, most=1e15)
        mapper.SetInteractiveMaximumNumberOfSplats(int(most))


def add_splats(plotter: pyvista.BasePlotter, mesh: Any, scalars: str | np.ndarray | None = None, *, component: int | None = None,
               color: Any = None, cmap: Any = None, opacity: OpacityLike | None = None,
               clim: float | Numbers | None = None, n_colors: int = 256, flip_scalars: bool = False,
               log_scale: bool = False, opacity_scalars: str | None = None,
               opacity_clim: float | Numbers | None = None, opacity_scale: float = 1.0,
               opacity_unit_distance: float | None = None, kernel: Kernel = "cubic", radius: float | str | None = None,
               sizes: str | None = None, volumes: str | None = None, radius_factor: float = 1.0,
               level_of_detail: float | LevelOfDetailOptions | Mapping[str, Any] | None = None,
               vectors: str | VectorOptions | Mapping[str, Any] | None = None,
               preference: Preference = "point", name: str | None = None, show_scalar_bar: bool | None = None, scalar_bar_args: dict | None = None,
               reset_camera: bool | None = None, pickable: bool = True, user_matrix: Any = None, render: bool = True,
               preset: str | bool | None = None, sun: Any = None, exposure: float | None = None, tone_mapping: ToneMapping = "contrast",
               **old: Unpack[OldSplatNames]) -> pyvista.Volume:
    """Add the points or cells of a dataset to a plotter as splats drawn by `vtkTexturedSplatMapper`.

    Every sample is a kernel in the shape of its grid cell, or a ball if there is no grid. Its extinction coefficient is opacity *
    `opacity_scale` / `opacity_unit_distance`, integrated exactly along every ray. Vectors are streaks on the splats. A point on the boundary of a mesh
    represents the part of its cell that lies inside, so that the mass is the same as with `add_cells`; the kernels blur the boundary over half a cell. The centres of
    tetrahedra are not evenly spaced: splats of their cell arrays show as dots where few of them lie along the line of sight. Draw these by `add_cells`, or pass
    ``radius_factor=1.25``.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets the splats.
    mesh : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset, xarray.DataArray or numpy.ndarray
        Any dataset with points, including particles as a PolyData or an array of shape (n, 3). Blocks are combined into one dataset, whose
        splats are balls. Surface blocks next to blocks of 3-D cells, and blocks without the requested arrays, are skipped, with a warning. Data
        of xarray are drawn as in `add_cells`. It is not changed.
    scalars : str or numpy.ndarray, optional
        Name of a point or cell array, or values for all points or all cells; masked values count as missing. A cell array makes one splat per cell. Default: the active scalars,
        otherwise the first numeric array, otherwise vectors; none if `color` is given or the mesh has no arrays.
    component : int, optional
        As in `add_cells`: the component of vectors that are `scalars`. Default: their magnitude.
    color : ColorLike, optional
        One colour for all splats; `scalars` then set the opacity only. Without `scalars` the medium is uniform. Default for a mesh without
        arrays: the theme's colour of meshes.
    cmap, opacity, clim, n_colors, flip_scalars, log_scale, opacity_scalars, opacity_clim, opacity_scale
        As in `add_cells`, also ``opacity="extinction"``. ``opacity=0`` draws the vectors only, coloured by `scalars`. `opacity_scalars` must be on points or cells, like
        `scalars`.
    opacity_unit_distance : float, optional
        Length in world units over which a medium of opacity 1 has an optical depth of 1, > 0. Default: the length that gives rays through the
        splats a mean optical depth of 2, with opacities scaled to reach 1, as in `add_cells`; 0.4 in a uniform medium, less if
        points are crowded. With `clim` (or `opacity_clim`) it assumes
        opacities that are linear over the range of the scalars, so that in a time series the medium fades as its values do. To compare pictures,
        pass the same distance for all.
    kernel : {"cubic", "quadratic", "gaussian"}, default: "cubic"
        Shape of a splat: cubic for samples in space, quadratic for one flat sheet seen from the front, gaussian for comparison.
    radius : float or "neighbors", optional
        Radius of the splats of particles and unstructured points, in units of length, > 0. ``"neighbors"``: 1.56 times the mean distance to each
        point's nearest neighbours. Default: the size of the surrounding cells or, without cells, 1.56 times the mean spacing of all points.
        Structured grids raise a ValueError, because their splats have the shape of their cells.
    sizes, volumes : str, optional
        Instead of `radius`: array, on points or cells like the scalars, with the edge length or the volume of the cube that each sample
        represents.
    radius_factor : float, default: 1.0
        Multiplies the width of splats, on any data, 0.01 to 100. Their mass is conserved.
    level_of_detail : float or dict, optional
        A number is the option ``tolerance``. Options:

        - ``tolerance``, default 0.0: a block of samples is drawn as one splat if its error is at most this value, >= 0. 0: every sample is
          drawn. Ignored if the placement of the vectors is ``"layers"``.
        - ``unit``, default ``"image"``: error of the optical depth along the ray through the block. ``"data"``: error of the opacity function's
          value, or of the speed as a fraction of the maximum speed.
        - ``measure``, default ``"picture"``: error of a block as the root of the sum of the squared errors over its pixels, which usually gives
          the fewest splats; ``"rms"``: root mean square over the block; ``"greatest"``: largest deviation of a sample.
        - ``interactive_splats``, default 100,000: maximum number of splats while the camera moves in an interactive window. 0: no limit.
        - ``blending``, default 0.1: fraction of the tolerance, 0 to 0.9, over which a block fades in while its samples fade out, so that levels
          of detail do not pop.
    vectors : str or dict, optional
        Array of three components, on points or cells like the scalars, to draw on the splats: its name, or options:

        - ``array``: its name.
        - ``style``, default ``"streaks"``: comets with a sharp head; or ``"segments"``, anti-aliased line segments. Both move with ``phase``.
        - ``placement``, default ``"middle"``: half of a splat's medium lies in front of its vector. ``"layers"``: for each layer of the grid, the
          scalars are drawn first and then the vectors; without a structured grid, for each layer at right angles to the line of sight, with a
          warning.
        - ``opacity``: optical depth of the streaks of the longest vectors, >= 0; other streaks are proportional to the length of their vectors.
          Default: 2 for vectors alone; in a medium the value that gives vectors of mean length 0.6, clamped to 0.8 to 2.
        - ``color``: one colour for all vectors. Default: in a medium, or if other volumes are in the view and no colours of the splats are given, black, white or orange, whichever contrasts best
          with all media in the view, or another strong colour if these media have those; otherwise the colour of the splats.
        - ``scalars``, ``cmap``, ``clim``: array that colours the vectors independently of the splats, for example altitude; its magnitude if it
          has several components. Its colour map and range are given as for `cmap` and `clim`.
        - ``maximum_speed``: length of a vector, in its own unit, at and above which streaks have full opacity, > 0. Default: the maximum length
          in the data, but at most 1.25 times the 99th percentile, with a warning if the maximum is more than twice that. For the mesh of a series,
          as drawn by `animate`, all steps count.
        - ``fraction``: fraction of the samples whose vectors are drawn, chosen at random, > 0 and <= 1. Fewer streaks are longer and wider.
          Default: for segments all vectors. The number of streaks is limited to the density of 7 streaks of the longest vectors along a line of
          sight, and to 6000 in a sheet (up to seven times as many in data that are many samples deep): a mean distance of 8
          pixels if they fill a picture of 600 by 600 pixels.
        - ``unit``: length of the vector unit, in units of length of the mesh, > 0. Default: the mean length of a cell along its vector, longer if
          ``fraction`` is below 1; for the mesh of a series that of the step with the fastest vectors. To make pictures comparable, pass it and
          ``maximum_speed``.
        - ``streak_period``, default 4.0: distance between streaks along a vector, in vector units, 0.01 to 1000.
        - ``streak_width``, default 0.1: standard deviation of a streak's brightness across it, in vector units, 0.001 to 10.
        - ``segment_length``, default 2.0: length of the segment of a vector with the maximum speed, in vector units, 0 to 1000. Other segments are
          proportional to their vectors.
        - ``segment_width``, default 1.5: width of segments in pixels, 0.1 to 100.
        - ``layer_axis``, default ``"eye"``: with the placement ``"layers"``, the axis 0, 1 or 2 of a structured grid whose index numbers the
          layers. ``"eye"``: the axis that points most towards the camera.
        - ``phase``, default 0.0: position of the streaks in their loop, 0 to 1; 1 is the same as 0. Change it with ``volume.mapper.phase``. `animate` moves the
          streaks from step to step, unless you set ``phase`` here or there.
        - ``true_speed``, default False: patterns move at the speed of their vectors, by length of the vector * ``time_scale`` *
          ``volume.mapper.film_time``, instead of through a loop. ``phase`` and ``phase_cycles`` have no effect then.
        - ``time_scale``: with ``true_speed``, time in the data per second of the film, in the time unit of the vectors, > 0: 3600 is
          an hour for vectors in metres per second on a mesh in metres, or in another unit that ``length_unit`` gives. Default: a round number for which the fastest patterns move by at most
          one period in a second; in a renderer the smallest of all volumes with ``true_speed``, so that their speeds are comparable.
        - ``film_time``, default 0.0: with ``true_speed``, seconds since the start of the film. Change it with ``volume.mapper.film_time``; `animate` does, unless
          you set it.
        - ``speed_key``: legend of the motion: an arrow as long as the distance that a stated speed covers in a second of the film, the time
          in the data per second, and the speed of the fastest streaks or the longest segments. Keys of several volumes are placed one above the other. Default: with ``true_speed``, if the theme shows scalar bars.
        - ``speed_unit``: unit of the vectors in the legend. With ``"m/s"`` distances and times have units too. Default:
          ``"m/s"`` for ``DisplayVelocity``, the winds of a globe, otherwise none.
        - ``length_unit``, default 1.0: unit of length of the mesh, in that of the vectors, > 0: 1000 for vectors in metres per second on a mesh in kilometres. The
          legend and ``time_scale`` are in the units of the vectors then. A mesh in degrees has no such unit; 1.11e5 is that of latitudes.
        - ``phase_cycles``, default 4: number of periods by which the fastest pattern moves in a loop, 1 to 1000.
        - ``phase_steps``, default 0: number of positions of the pattern along its period, 0 to 1000. 0: continuous, for smooth motion; 16: as in
          the stored textures of 1993.
    preference : {"point", "cell"}, default: "point"
        Which array to use if points and cells both have an array of that name, or if their numbers are equal.
    name, show_scalar_bar, scalar_bar_args, reset_camera, pickable, user_matrix, render, preset
        As in `add_cells`. With `color` there is no scalar bar unless `show_scalar_bar` is True. Scalars of the vectors get their own scalar bar,
        which is the only one if only the vectors are drawn.
    sun, exposure, tone_mapping
        As in `add_cells`, for data with 3-D cells: splats at the points have the colours of the light there, and the extinction for which the light was computed.
    **old
        Earlier names of options, with a DeprecationWarning that gives the current name: `unit_distance`; `vector_style`, `vector_color`, ... and
        `greatest_speed`, `vector_share`, `streak_period`, ..., `phase`; `error_tolerance`, `error_unit`, `error_measure`, `interactive_splats` and
        `level_blending`.

    Returns
    -------
    pyvista.Volume
        The volume in the plotter: `.mapper` is the `vtkTexturedSplatMapper` with all its other settings, `.prop` the volume property.

    Raises
    ------
    TypeError
        If `plotter` or `mesh` has the wrong type, the scalars are not numeric, or an option does not exist.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array does not exist; the message lists the arrays that do.
    ValueError
        If an argument is out of range, the mesh has no points, or an array has the wrong number of components.

    Examples
    --------
    >>> volume = nephoscope.add_splats(plotter, winds, "Height", opacity=0, vectors="DisplayVelocity")  # doctest: +SKIP
    >>> volume.mapper.phase = 0.25  # doctest: +SKIP
    """
    require_plotter(plotter)
    data, field = mesh, scalars
    streaks = group("vectors", vectors, Vectors, "array", old, VECTOR_NAMES)
    detail = group("level_of_detail", level_of_detail, LevelOfDetail, "tolerance", old, DETAIL_NAMES)
    opacity_unit_distance = renamed_argument(opacity_unit_distance, "opacity_unit_distance", old.pop("unit_distance", None), "unit_distance")
    refuse_unknown(add_splats, old)
    brightest(None, exposure, tone_mapping)  # rejects wrong values, also without sun
    shows_bars = plotter.theme.show_scalar_bar if show_scalar_bar is None else show_scalar_bar
    if sun is not None:
        refuse_color(color)
        light = lit_medium(plotter, data, _sampled_mesh(mesh, {}), sun, cmap, clim, n_colors, exposure, tone_mapping)
        mesh, scalars, opacity_scalars, opacity, opacity_clim, opacity_unit_distance, cmap, clim = light.values()
        preference, show_scalar_bar = "point", bool(show_scalar_bar)
    mesh = _sampled_mesh(mesh, {**({"scalars": scalars} if color is None or scalars is not None else {}), "opacity_scalars": opacity_scalars,
                                "vectors": streaks.array, "vectors['scalars']": streaks.scalars, "sizes": sizes, "volumes": volumes})
    opacity_scalars = named_extinction(mesh, opacity, scalars, opacity_scalars)
    uniform = scalars is None and (color is not None or is_bare(mesh))
    if color is not None or uniform:
        cmap, show_scalar_bar = uniform_colours(plotter, color, cmap), bool(show_scalar_bar)
        if uniform:
            on_cells = not mesh.point_data and mesh.cell_data  # for hyper tree grids, for example: each cell has its own size
            scalars, clim, preference = np.ones(mesh.n_cells if on_cells else mesh.n_points), (0, 1), "cell" if on_cells else "point"
    if 0 < mesh.n_cells < FEWEST and streaks.array is None and sizes is None and cell_dimension(mesh) == 3:
        warnings.warn(f"The mesh has {mesh.n_cells} {'cell' if mesh.n_cells == 1 else 'cells'}. Splats are soft blobs: they do not show the shape of so few cells, and may be too faint "
                      "to see. Draw the mesh by add_cells.", RuntimeWarning, stacklevel=level_of_caller())
    given, coloured = mesh, any(one is not None for one in (field, color, cmap, clim, sun))
    mesh, array_name, association = scalar_array(mesh, scalars, preference, component)
    darken_for(plotter, data, mesh)
    if opacity_scalars is not None:
        require_beside_scalars(mesh, opacity_scalars, association, "opacity_scalars")
    mapper = TexturedSplatMapper()
    choose({"cubic": mapper.SetKernelToCubic, "quadratic": mapper.SetKernelToQuadratic,
            "gaussian": mapper.SetKernelToGaussian}, kernel, "kernel")
    mapper.SetRadiusFactor(require_number(radius_factor, "radius_factor", least=0.01, most=100))
    _set_sizes(mapper, mesh, association, {"radius": radius, "sizes": sizes, "volumes": volumes}, KERNEL_RADII[kernel])
    detail.apply(mapper)
    streaks.apply(mapper, plotter, mesh, association)
    fainter = FAINTER * concentration(mesh.points) if uniform and opacity_scalars is None else 1.0
    prop = Functions(cmap, opacity, clim, n_colors, flip_scalars, log_scale, opacity_scalars, opacity_clim,
                     opacity_scale, preset, fainter, component).attach(mapper, plotter, mesh, array_name, association, association, opacity_unit_distance)
    streaks.suit(mapper, plotter, prop, given, coloured)
    if (streaks.table is not None or mapper.GetUseVectorColor()) and not is_drawn(prop.GetScalarOpacity()):
        show_scalar_bar = False  # nothing uses its colours
    title = title_of_scalars(mesh, array_name, association, component)
    add_earth_for(plotter, data, mesh, array_name if sun is None else field, sun is not None)
    volume = add_medium(plotter, mapper, prop, title, words=title_with_units(data, mesh, array_name, title), user_matrix=user_matrix, show_scalar_bar=show_scalar_bar,
                        scalar_bar_args=scalar_bar_args, reset_camera=reset_camera, name=name, pickable=pickable, render=render)
    if shows_bars:
        streaks.add_bar(plotter, scalar_bar_args)
    streaks.add_key(plotter, volume, shows_bars)
    return volume


def _sampled_mesh(mesh: Any, arrays: Mapping[str, Any]) -> pyvista.DataSet:
    """`mesh` as one PyVista dataset with points. If there are several blocks, only those with the `arrays` are used."""
    mesh = require_dataset(mesh, "mesh", ", or points of shape (n, 3)", merge_points=False, arrays=arrays)
    if mesh.n_points == 0:
        raise ValueError(f"mesh, a {type(mesh).__name__}, has no points.")
    return mesh


def _set_sizes(mapper: TexturedSplatMapper, mesh: pyvista.DataSet, association: str, options: dict[str, Any], kernel_radius: float) -> None:
    given = {name: value for name, value in options.items() if value is not None}
    if not given:
        return
    if len(given) > 1:
        raise ValueError(f"{' and '.join(given)} are both given; splats have one size.")
    name, value = given.popitem()
    if isinstance(mesh, (vtkImageData, vtkRectilinearGrid, vtkStructuredGrid)):
        raise ValueError(f"{name} is {value!r}, but splats of a {type(mesh).__name__} have the shape of its cells: "
                         "use radius_factor, in cells.")
    if name == "radius":
        if isinstance(value, str):
            choose({"neighbors": mapper.CellSizeFromNeighborsOn}, value, "radius")
            mapper.CellSizeFromCellsOff()
        else:
            mapper.SetCellSize(require_number(value, "radius", above=0) / kernel_radius)
        return
    require_beside_scalars(mesh, value, association, name)
    mapper.SetCellSizeArrayName(value)
    mapper.SetCellSizeArrayHoldsVolumes(name == "volumes")
