# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a mesh on the globe or on a map, in one line."""
from __future__ import annotations

from typing import Any, Callable

import numpy as np
import pyvista
from vtkmodules.vtkRenderingCore import vtkProp3D

from .._bars import add_mesh
from .._blocks import cell_dimension
from .._globe_camera import look_at_region, look_down
from .._medium import association_of, default_scalars, diagonal
from .._over_time import follows
from ..cells import add_cells
from ..globe import EARTH_RADIUS, globe_surface, is_map, planet_radius
from .bars import BELOW, BESIDE, bars_in, finish_bars, make_room
from .forms import VOLUME, form_of, told_form
from .horizontal import GridError, section
from .look import surface_look, with_share
from .prisms import HIDDEN_CELL, HIDDEN_POINT, offsets
from .scales import EAST, NORTH, add_scales
from .sea import is_sea, look_of_water
from .shadows import shade
from .view import Frame, is_place, picture_theme, set_view, size_of
from .ground import add_coasts, add_ground, globe_coasts, map_coasts, map_ground

STRIP = 0.18  # of the height of the picture, at its lower edge, for the scalar bar and the degrees of longitude below a map
LABELS = 0.08  # of the width of the picture, at its left edge, for the degrees of latitude
MARGIN = 0.04  # of the width and of the height, around a map


def plotted(grid: pyvista.DataSet, scalars: str | None, frame: Frame, options: dict, title: Callable[[str], str] = str) -> pyvista.Plotter:
    """`title`: that of the scalar bar, for the name of an array. A map that is wide makes a new window lower."""
    refuse_sections(grid)
    grid = without_missing(grid, scalars)
    plotter = frame.begin()
    if frame.is_free and is_map(grid) and (limits := _limits_of_map(grid)) is not None:
        plotter.window_size = _window_of_map(plotter.window_size[0], limits)
    draw(plotter, grid, scalars, options, title, frame.view)
    return frame.finish(plotter)


def without_missing(grid: pyvista.DataSet, scalars: str | None) -> pyvista.DataSet:
    """`grid` with the points or cells hidden that have no value, such as land in an ocean: there is nothing to warn of."""
    name = default_scalars(grid)[1] if scalars is None else scalars
    for data, hidden in ((grid.point_data, HIDDEN_POINT), (grid.cell_data, HIDDEN_CELL)):
        if name in data and (missing := ~np.isfinite(data[name])).any() and not missing.all():
            marks = np.asarray(data["vtkGhostType"]) if "vtkGhostType" in data else np.zeros(len(missing), np.uint8)
            grid = grid.copy(deep=False)
            (grid.point_data if hidden == HIDDEN_POINT else grid.cell_data)["vtkGhostType"] = marks | (missing * np.uint8(hidden))
    return grid


def _present(grid: pyvista.DataSet, name: str, association: str) -> pyvista.DataSet:
    """The cells of one time that have values, as a copy if some have none: where a part of a globe is transparent, its far side is seen through the near one."""
    data = grid.point_data if association == "point" else grid.cell_data
    there = np.isfinite(data[name])
    if follows(grid) or not there.any() or there.all():
        return grid
    if association == "cell":
        return grid.extract_cells(np.flatnonzero(there))
    return grid.extract_points(there, adjacent_cells=False)


def _far_side(sheet: pyvista.DataSet) -> str | None:
    """The faces of a globe of rows and columns that its far side shows, "back" or "front", so that they are not visible next to the ground where the near side is transparent; None if they differ."""
    if not isinstance(sheet, pyvista.StructuredGrid) or sheet.dimensions[2] != 1:
        return None
    points = np.asarray(sheet.points).reshape(*sheet.dimensions[1::-1], 3)
    across, up = points[1:, 1:] - points[:-1, :-1], points[1:, :-1] - points[:-1, 1:]
    outward = np.einsum("ijk,ijk->ij", np.cross(across, up), points[:-1, :-1])
    largest = np.nanmax(np.abs(outward), initial=0)
    signs = np.sign(outward[np.abs(outward) > 1e-6 * largest])  # without cells that end in a pole
    return None if not signs.size or signs.min() != signs.max() else "back" if signs[0] > 0 else "front"


def is_untouched(plotter: pyvista.BasePlotter) -> bool:
    """True for a plotter that has nothing but the defaults of PyVista."""
    return bool(plotter.shape == (1, 1) and has_defaults(plotter, plotter.renderer))


def has_defaults(plotter: pyvista.BasePlotter, renderer: pyvista.Renderer) -> bool:
    """True for a sub-plot that has nothing but the defaults of PyVista."""
    empty = all(actor.GetClassName() == "vtkActor2D" for actor in renderer.actors.values())  # the border between sub-plots
    return bool(empty and not renderer.camera_set and plotter.theme == pyvista.global_theme and renderer.background_color == plotter.theme.background)


def darken(plotter: pyvista.BasePlotter, alone: bool = False) -> None:
    """`alone`: only the background of the active sub-plot."""
    theme = picture_theme()
    if not alone:
        plotter.theme.load_theme(theme)  # of this plotter alone
    plotter.set_background(theme.background, all_renderers=not alone)


def draw(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, scalars: str | None, options: dict, title: Callable[[str], str], view: Any = None) -> None:
    """The field, the Earth below it, the scalar bar and the view."""
    on_globe, clim, bars = not is_map(grid), options.get("clim"), bars_in(plotter)
    name = default_scalars(grid)[1] if scalars is None else scalars
    if not follows(grid) and (form := form_of(grid, name, options)) is not None:
        grid, scalars = form(grid), name
    title = told_form(title, grid)
    sun = None
    flat = cell_dimension(grid) < 3
    sea = not flat and is_sea(grid)
    earth = add_earth(plotter, grid)
    options = {"scalar_bar_args": BESIDE if on_globe else BELOW, **options}
    if flat:  # one level
        refuse_volume(options)
        association = association_of(grid, name, "point", "scalars")  # raises an error if no value is finite; VTK would end the process
        sheet = _present(grid, name, association)
        look = surface_look(plotter, grid, name, association, options)
        title = with_share(title, grid, name, association, options, look)
        culling = _far_side(sheet) if on_globe and sheet is grid else None
        add_mesh(plotter, sheet, name, scalars=name, **{"nan_opacity": float(not follows(grid)), "lighting": False, "culling": culling, **look})
    else:
        if sea:
            asked = options
            options = look_of_water(grid, name, options, VOLUME)
            title = with_share(title, grid, name, association_of(grid, name, "point", "scalars"), asked, options)
        volume = add_cells(plotter, grid, scalars, **{"show_scalar_bar": "sun" not in options, **options})
        sun = np.ravel(volume.mapper.dataset.field_data["SunDirection"])[:3] if "sun" in options else None
        if "sun" in options and earth is not None:
            shade(earth, volume.mapper.dataset)
    finish_bars(plotter, bars, title, clim)
    limits = None if on_globe else _limits_of_map(grid)
    if limits is not None:
        _finish_map(plotter, grid, limits)
    if on_globe and (view is None or is_place(view)):
        look_down(plotter, grid, seen(grid), name, view, sea, sun)
    elif view is None and limits is not None:
        _look_at_map(plotter, limits)
    elif view is not None:
        set_view(plotter, view)
        plotter.camera.SetWindowCenter(0.08 if on_globe else 0, 0)  # room for the scalar bar
    if on_globe and (view is None or is_place(view)):
        make_room(plotter, as_high=True)


def turn_to_field(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, name: str, sun: np.ndarray | None = None) -> None:
    """Turns the camera to the side of a globe that `draw` shows, or to a region. What has been drawn is then in the middle of the picture."""
    look_at_region(plotter, grid)
    if not plotter.renderer.camera.is_set:
        look_down(plotter, grid, seen(grid), name, None, sun=sun)
        plotter.camera.SetWindowCenter(0, 0)
        plotter.reset_camera(render=False)


def refuse_volume(options: dict) -> None:
    """Raises ValueError for options that a surface does not have."""
    wrong = [name for name in VOLUME if name in options]
    if wrong:
        raise ValueError(f"{wrong[0]}: an option of volumes, but this grid is one level or section.")


def refuse_sections(grid: pyvista.DataSet) -> None:
    """Raises GridError for a grid of one longitude or one latitude, which is a line from above."""
    for kind, size in zip(("longitude", "latitude"), getattr(grid, "dimensions", ())):
        if size == 1:
            raise GridError(section(kind, "lon" if kind == "longitude" else "lat"))


def add_earth(plotter: pyvista.BasePlotter, grid: pyvista.DataSet) -> pyvista.Actor | None:
    """The Earth below the data, with coasts above those that hide it. Returns its surface; None if the data have no positions."""
    flat = cell_dimension(grid) < 3
    return (_add_map if is_map(grid) else _add_globe)(plotter, grid, flat, not flat and is_sea(grid))


def _add_globe(plotter: pyvista.Plotter, grid: pyvista.DataSet, flat: bool, sea: bool) -> pyvista.Actor:
    radii = np.linalg.norm(_finite(grid), axis=1)
    lowest = radii.min(initial=EARTH_RADIUS) if sea else EARTH_RADIUS
    coarse = None if flat or not isinstance(grid, pyvista.StructuredGrid) else grid
    ground = globe_surface(radius=_below(grid) if flat else lowest, below=coarse)
    ground.field_data["PlanetRadius"] = grid.field_data.get("PlanetRadius", [EARTH_RADIUS])  # although it is lower
    actor = add_ground(plotter, ground)
    if (flat or sea) and radii.size:
        add_coasts(plotter, globe_coasts((1 + 0.5 * _gap(grid)) * radii.max()))
    return actor


def _add_map(plotter: pyvista.Plotter, grid: pyvista.DataSet, flat: bool, sea: bool) -> pyvista.Actor | None:
    points = _finite(grid)
    if not points.size:
        return None
    (west, south, bottom), (east, north, top) = points.min(axis=0), points.max(axis=0)
    step = 0.001 * max(east - west, north - south)
    ground = bottom - step if flat or sea else 0.0
    radius = planet_radius(grid)
    edges = tuple(np.degrees(np.array([west, east, south, north]) / radius))
    actor = add_ground(plotter, map_ground(edges, radius, ground))
    if flat or sea:
        add_coasts(plotter, map_coasts(edges, radius, top + step))
    return actor


def _finite(grid: pyvista.DataSet) -> np.ndarray:
    points = np.asarray(grid.points)
    return points[np.isfinite(points).all(axis=1)]


def seen(grid: pyvista.DataSet) -> np.ndarray:
    """The points that are not hidden, as land in an ocean is; all that have a position, if all are hidden, or in a film, in which others may be hidden later."""
    marks = grid.point_data.get("vtkGhostType")
    if marks is None or follows(grid):
        return _finite(grid)
    points = np.asarray(grid.points)[np.asarray(marks) & HIDDEN_POINT == 0]
    points = points[np.isfinite(points).all(axis=1)]
    return points if len(points) else _finite(grid)


def _look_at_map(plotter: pyvista.BasePlotter, limits: np.ndarray) -> None:
    """From above, with north up, above a strip for the scalar bar and right of the degrees of latitude. `limits`: of the map in the scene, shape (2, 3)."""
    (low, high), aspect = limits, np.divide(*size_of(plotter))
    middle, (width, height, depth) = 0.5 * (low + high), high - low
    scale = max(width / aspect / (1 - 2 * MARGIN - LABELS), height / (1 - 2 * MARGIN - STRIP)) or 1.0  # height of the picture in the scene
    middle -= (0.5 * LABELS * scale * aspect, 0.5 * STRIP * scale, 0)
    plotter.camera.focal_point = middle
    plotter.camera.position = middle + (0, 0, depth + 2 * scale)
    plotter.camera.up = (0, 1, 0)
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 0.5 * scale
    plotter.reset_camera_clipping_range()


def _window_of_map(across: int, limits: np.ndarray) -> tuple[int, int]:
    """Size of a window that the map fills: at least half as high as wide, at most square."""
    width, height, _ = limits[1] - limits[0]
    share = height * (1 - 2 * MARGIN - LABELS) / ((width or 1.0) * (1 - 2 * MARGIN - STRIP))
    return across, int(across * min(1.0, max(0.5, share)))


def _limits_of_map(grid: pyvista.DataSet) -> np.ndarray | None:
    """Those of a map in the scene, where degrees of longitude are as long as they are in its middle, shape (2, 3); None if no point has a position."""
    points = _finite(grid)
    if not len(points):
        return None
    limits = np.array([points.min(axis=0), points.max(axis=0)])
    limits[:, 0] *= _shorter(grid, limits)
    return limits


def _shorter(grid: pyvista.DataSet, limits: np.ndarray) -> float:
    """The length of a degree of longitude in the middle of a map, over that at the equator."""
    return max(float(np.cos(limits[:, 1].mean() / planet_radius(grid))), 0.05)


def _finish_map(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, limits: np.ndarray) -> None:
    """Makes the map as wide as the `limits`, and adds axes with degrees."""
    shorter = _shorter(grid, limits)
    for actor in plotter.renderer.actors.values():
        if isinstance(actor, vtkProp3D):
            actor.SetScale(shorter, 1, 1)
    degree = np.radians(1.0) * planet_radius(grid)
    add_scales(plotter, limits.T.ravel(), "z", {"x": (EAST, degree * shorter), "y": (NORTH, degree)})


def _below(sheet: pyvista.DataSet) -> float:
    """A radius below the sheet's flat cells, which are also bent along a diagonal: that of the middle of the longest diagonal."""
    half = 0.5 * _longest_diagonal(sheet)
    lowest = min(EARTH_RADIUS, np.linalg.norm(_finite(sheet), axis=1).min(initial=EARTH_RADIUS))  # a level of an ocean is below the level of the sea
    return (1 - _gap(sheet)) * float(np.sqrt(np.clip(1 - (half / EARTH_RADIUS) ** 2, 0.64, 1))) * lowest


def _gap(grid: pyvista.DataSet) -> float:
    """Between the data and the ground below, as a part of the radius: less for a small region, which is seen from near."""
    return min(0.002, 0.02 * diagonal(grid) / EARTH_RADIUS)


def _longest_diagonal(sheet: pyvista.DataSet) -> float:
    """That of the cells that are drawn: those on land may reach from one sea to a displaced one, as in the grids ORCA of NEMO."""
    points = np.asarray(sheet.points)
    if isinstance(sheet, pyvista.StructuredGrid):
        marks = sheet.point_data.get("vtkGhostType")
        points = points if marks is None or follows(sheet) else np.where((np.asarray(marks) & HIDDEN_POINT)[:, None], np.nan, points)
        grid = points.reshape(*[size for size in sheet.dimensions[::-1] if size > 1], 3)
        sizes = np.linalg.norm(grid[1:, 1:] - grid[:-1, :-1] + 0 * (grid[1:, :-1] + grid[:-1, 1:]), axis=-1) if grid.ndim == 3 else np.zeros(1)
    else:
        corners, starts = points[sheet.cell_connectivity], offsets(sheet)[:-1]
        sizes = np.linalg.norm(np.maximum.reduceat(corners, starts) - np.minimum.reduceat(corners, starts), axis=1) if len(starts) else np.zeros(1)
    sizes = sizes[np.isfinite(sizes)]
    return float(sizes.max()) if sizes.size else 0.0
