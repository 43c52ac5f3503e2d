# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh of a reading: longitude, latitude and level as points, then `to_globe`."""
from __future__ import annotations

import warnings
from typing import Sequence

import numpy as np
import pyvista

from .._checks import listed
from .._fields import choose_active_scalars
from .._pipeline import level_of_caller
from ..globe import GAPS_ARE_TOLD, IS_SEA, to_globe
from .air import Air
from .horizontal import GridError
from .look import note_look
from .naming import UNITS, word
from .prepare import made_of
from .reading import Reading
from .sea import DEEPEST, is_below
from .units import UnitsError, simple
from .winds import winds

NEAR = 1.0  # m: points that much below the ground are on it, such as a level at the ground
HEIGHT = "geometric_height"  # the array that passes the heights to `to_globe`
GROUND = "GroundOfColumns"  # field array of a section whose levels are neither pressures nor heights: the height of the ground below each column, in m


def place(reading: Reading, air: Air, variables: Sequence[str] | None, extra: dict[str, np.ndarray], options: dict) -> pyvista.StructuredGrid:
    """`extra`: computed fields, in the shape of the grid."""
    refuse_found(options)
    if reading.horizontal.is_list:
        from .prisms import place_columns
        return place_columns(reading, air, variables, extra, **options)
    mesh, order = structure(reading, air)
    if sum(size > 1 for size in mesh.dimensions) < 2:
        raise GridError(f"The data are a line or a single point, {' x '.join(map(str, mesh.dimensions))} longitudes, latitudes and levels. Keep at least two longitudes and two latitudes, "
                        f"or one of them and two levels, for example ds.sel(lon=slice(FIRST, LAST)). Plot a line as a curve: ds[{reading.example!r}].squeeze().plot().")
    _warn_of_gaps(mesh, reading)
    for name in chosen(reading, variables):
        add(mesh, name, reading.values(name), order)
        note_units(mesh, name, reading.dataset[name].attrs.get("units"))
        note_look(mesh, reading.dataset, name)
    for name, values in extra.items():
        add(mesh, name, values, order)
        note_units(mesh, name, UNITS.get(name))
        note_look(mesh, reading.dataset, name)
    if _is_section_over_ground(mesh, reading, air):
        add(mesh, GROUND, np.broadcast_to(air.terrain, air.shape), order)
    names = _add_winds(mesh, reading, air, order)
    height = HEIGHT
    if IS_SEA in mesh.field_data:
        options = {"mask_below_ground": False, **options}
    if reading.vertical and reading.vertical.kind in ("depth", "ocean sigma"):
        options, height = {"mask_below_ground": False, **options}, HEIGHT if reading.horizontal.missing is not None or reading.vertical.kind == "ocean sigma" else False
    ground = ground_mesh(reading, air)
    if options.get("projection") == "map":
        mesh, ground = _without_fold(reading, mesh), _without_fold(reading, ground)
    hides = reading.vertical is not None or ground is not None and "sp" in ground.point_data
    if ground is not None and "orog" in ground.point_data:
        ground.point_data["orog"] -= np.float32(NEAR)
    if not hides:  # one level is drawn at the height 0, which tells nothing: only its pressure does, if it is known
        options, ground = {**options, "mask_below_ground": False}, None
    choose_active_scalars(mesh)
    if "units" in mesh.field_data:
        mesh.field_data.remove("units")
    calm = _without_wind(mesh, names)
    grid = to_globe(mesh, height=height, height_units="m", wind=names or False, vertical_wind_is_omega=False, wind_components="east-north", level_units=_level_units(reading),
                    surface=ground, **options)
    if not hides:
        grid.point_data["BelowGround"] = np.zeros(grid.n_points, np.uint8)
    del grid.point_data[HEIGHT]
    if GROUND in grid.point_data:
        grid.field_data[GROUND] = np.array(grid.point_data.pop(GROUND)[: grid.n_points // grid.dimensions[2]], float)
    if grid.point_data.active_scalars_name is None:
        choose_active_scalars(grid)
    _forget_wind(grid, names, calm)
    return grid


def _is_section_over_ground(mesh: pyvista.DataSet, reading: Reading, air: Air) -> bool:
    levels = reading.vertical is not None and reading.vertical.kind not in ("pressure", "height", "depth", "ocean sigma")
    return levels and 1 in mesh.dimensions[:2] and air.terrain is not None


def _without_fold(reading: Reading, mesh: pyvista.DataSet | None) -> pyvista.DataSet | None:
    """The mesh without the row that closes the northern fold: its longitudes run backward, so that on a map it would lie far from the others."""
    if mesh is None or reading.horizontal.fold is None or reading.horizontal.fold.dropped:
        return mesh
    columns, rows, levels = mesh.dimensions
    cut = mesh.extract_subset((0, columns - 1, 0, rows - 2, 0, levels - 1))
    cut.GetFieldData().ShallowCopy(mesh.GetFieldData())
    cut.point_data.active_scalars_name = mesh.point_data.active_scalars_name
    return cut


def _warn_of_gaps(mesh: pyvista.DataSet, reading: Reading) -> None:
    if reading.horizontal.gaps:
        mesh.field_data[GAPS_ARE_TOLD] = [1]
        warnings.warn("; ".join(reading.horizontal.gaps) + ".", UserWarning, stacklevel=level_of_caller())


CALM = "nephoscope_without_wind"


def _without_wind(mesh: pyvista.DataSet, names: list[str]) -> bool:
    """Marks the points that have fields but no wind, and sets it to 0 there: Globe Grid would hide them."""
    missing = np.any([~np.isfinite(mesh.point_data[name]) for name in names], axis=0) if names else np.zeros(1, bool)
    if not missing.any():
        return False
    for name in names:
        mesh.point_data[name] = np.where(missing, np.float32(0), mesh.point_data[name])
    mesh.point_data[CALM] = missing.astype(np.float32)
    return True


def _forget_wind(grid: pyvista.DataSet, names: list[str], calm: bool) -> None:
    """The wind at the marked points is missing again."""
    if calm:
        missing = np.asarray(grid.point_data[CALM]) != 0
        del grid.point_data[CALM]
        for name in (*names, "Wind", "DisplayVelocity"):
            grid.point_data[name][missing] = np.nan


FOUND = ("height", "height_units", "level_units", "wind", "vertical_wind_is_omega", "wind_components", "surface")


def refuse_found(options: dict) -> None:
    """Raises TypeError for arguments of `to_globe` that the dataset determines."""
    for name in FOUND:
        if name in options:
            raise TypeError(f"globe() takes {name} from the variables of the dataset. Name a variable by its role instead, such as geopotential_height='z' or "
                            "geopotential='z', or give it units; describe() lists what has been found.")


def place_sheet(reading: Reading, fields: dict[str, np.ndarray], units: str, options: dict) -> pyvista.DataSet:
    """Fields of one level, at the height 0, all with the same `units`."""
    refuse_found(options)
    if reading.horizontal.is_list:
        from .prisms import place_sheet_of_cells
        return place_sheet_of_cells(reading, fields, units, **options)
    mesh = _mesh(reading, np.zeros(1))
    _warn_of_gaps(mesh, reading)
    for name, values in fields.items():
        mesh.point_data[name] = np.ascontiguousarray(values, dtype=np.float32).ravel()
        note_units(mesh, name, units)
    mesh = _without_fold(reading, mesh) if options.get("projection") == "map" else mesh
    return to_globe(mesh, height=False, wind=False, level_units="m", mask_below_ground=False, **options)


def chosen(reading: Reading, variables: Sequence[str] | None) -> list[str]:
    """The variables to put on the mesh: those named, or all on the grid, last those that only give the positions of the points."""
    places = {reading.roles.get(role) for role in ("altitude", "thickness", "geopotential_height", "geopotential", "pressure", "pressure_thickness")}
    there = sorted(reading.plain_variables(), key=lambda name: name in places)
    fields = [name for name, _ in reading.field_variables()]
    wanted = there if variables is None else [variables] if isinstance(variables, str) else list(map(word, variables))
    missing = [name for name in wanted if name not in fields]
    if missing:
        made = "".join(f" {name!r} of the file has become {found[0]!r}, {found[1]}." for name in missing if (found := made_of(reading.dataset, name)))
        raise ValueError(f"variables: {listed(missing)} not on the grid.{made} There are: {listed(fields)}.")
    return _with_usable_units(reading, wanted, variables is not None)


def _with_usable_units(reading: Reading, names: list[str], asked: bool) -> list[str]:
    """`names` without the variables whose units cannot be converted, with a warning; if they are asked for, or nothing else is there, UnitsError."""
    reading.has_winds()  # they are read in any case
    gone = {reading.roles[role]: problem for role, problem in reading.unusable.items() if reading.roles[role] in names}
    if gone and (asked or len(gone) == len(names)):
        raise UnitsError(next(iter(gone.values())))
    for name, problem in gone.items():
        warnings.warn(f"{name!r} is left out. {problem}", UserWarning, stacklevel=level_of_caller())
    return [name for name in names if name not in gone]


def structure(reading: Reading, air: Air) -> tuple[pyvista.DataSet, np.ndarray]:
    """The grid with its heights, and the order of its levels, from the bottom to the top."""
    if np.prod(reading.horizontal.shape) == 1:
        raise GridError(f"The grid ({', '.join(reading.horizontal.dims)}) is one column, and there is nothing between columns to draw. Plot it as a profile: ds[{reading.example!r}].squeeze().plot()"
                        + (f", with y={reading.vertical.dim!r}." if reading.vertical else "."))
    heights = _heights(reading, air)
    if reading.horizontal.missing is not None:
        places_alone = np.isfinite(heights).all()
        heights = np.where(reading.horizontal.missing, np.nan, heights)
    order = order_of(reading, heights)
    levels = reading.levels()[order] if reading.vertical and reading.vertical.kind in ("pressure", "depth") else np.arange(len(order), dtype=float)
    if reading.level_pressure is not None:
        levels = np.array([reading.level_pressure])
    mesh = _mesh(reading, levels)
    if reading.horizontal.missing is not None and places_alone:  # of repeated points and of those without a place
        mesh.field_data[GAPS_ARE_TOLD] = [1]
    add(mesh, HEIGHT, heights, order)
    if is_below(np.nanmin(heights, initial=0.0), np.nanmax(heights, initial=-DEEPEST)) and np.nanmin(heights) >= -DEEPEST:
        mesh.field_data[IS_SEA] = [1]
    return mesh, order


def _heights(reading: Reading, air: Air) -> np.ndarray:
    if reading.vertical is not None:
        return air.heights
    reading.note("one level, at the height 0")
    air.height_source = "none: one level"
    return np.zeros((1, *reading.horizontal.shape))


def order_of(reading: Reading, heights: np.ndarray) -> np.ndarray:
    """The levels from the bottom to the top, without repetitions, ordered by their own values or, if these do not decide, by their heights."""
    kind = reading.vertical.kind if reading.vertical else ""
    if kind not in ("pressure", "height", "height above ground", "depth"):
        return order_of_levels(heights)
    values = reading.levels() * (-1 if kind == "pressure" else 1)
    order = np.argsort(values, kind="stable")
    order = order[np.isfinite(values[order])]
    order = order[np.diff(values[order], prepend=-np.inf) > 0]
    if len(order) < len(values):
        reading.note(f"{len(values) - len(order)} of {len(values)} levels are repeated or missing and were left out")
    return order


def order_of_levels(heights: np.ndarray) -> np.ndarray:
    """From the bottom to the top."""
    return np.argsort(_height_of_levels(heights.reshape(len(heights), -1)), kind="stable")


def _height_of_levels(flat: np.ndarray) -> np.ndarray:
    """A height for each level, used for ordering: the mean over the columns that have all levels, or over all columns if none has."""
    whole = np.isfinite(flat).all(axis=0)
    if whole.any():
        return flat[:, whole].mean(axis=1)
    count = np.isfinite(flat).sum(axis=1)
    means = np.nansum(flat, axis=1) / np.maximum(count, 1)
    return np.where(count, means, -np.inf)


def _mesh(reading: Reading, levels: np.ndarray) -> pyvista.DataSet:
    horizontal = reading.horizontal
    if horizontal.is_regular:
        return pyvista.RectilinearGrid(horizontal.longitude, horizontal.latitude, levels)
    lon, lat = horizontal.places()
    points = np.empty((len(levels), *lon.shape, 3))
    points[..., 0], points[..., 1], points[..., 2] = lon, lat, levels[:, None, None]
    grid = pyvista.StructuredGrid()
    grid.points = points.reshape(-1, 3)
    grid.dimensions = (lon.shape[1], lon.shape[0], len(levels))
    return grid


def add(mesh: pyvista.DataSet, name: str, values: np.ndarray, order: np.ndarray) -> None:
    values = values[order] if values.ndim == 3 else values
    mesh.point_data[name] = np.ascontiguousarray(values, dtype=np.float64 if name == HEIGHT else np.float32).ravel()


def note_units(mesh: pyvista.DataSet, name: str, units) -> None:
    if units is not None:
        mesh.field_data[f"{name}_units"] = [simple(units)]


def _add_winds(mesh: pyvista.DataSet, reading: Reading, air: Air, order: np.ndarray) -> list[str]:
    fields, names = winds(reading, air)
    for name, values in zip(names, fields):
        add(mesh, name, values, order)
        note_units(mesh, name, "m s-1")
    return names


def _level_units(reading: Reading) -> str:
    return "Pa" if reading.level_pressure is not None or reading.vertical and reading.vertical.kind == "pressure" else "m"


def ground_mesh(reading: Reading, air: Air) -> pyvista.DataSet | None:
    """One level with the pressure, height and land fraction of the ground, as far as they are available."""
    on_pressures = _level_units(reading) == "Pa"
    arrays = {"sp": air.surface_pressure if on_pressures else None, "orog": air.terrain, "lsm": reading.role("land") if reading.has("land") else None}
    arrays = {name: values for name, values in arrays.items() if values is not None}
    if not {"sp", "orog"} & set(arrays):
        return None
    levels = 1 if min(reading.horizontal.shape) > 1 or reading.horizontal.is_list else 2  # below a section it would be a line, which Globe Grid does not take
    mesh = _mesh(reading, np.arange(levels, dtype=float))
    for name, values in arrays.items():
        mesh.point_data[name] = np.tile(np.ravel(values), levels).astype(np.float32)
    return mesh
