# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Columns over the polygons of an unstructured globe, as wedges, hexahedra and prisms."""
from __future__ import annotations

import numpy as np
import pyvista
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR

from .._checks import require_number
from .._fields import choose_active_scalars
from ..globe import EARTH_RADIUS
from .air import Air
from .look import note_look
from .naming import UNITS
from .placing import NEAR, chosen, note_units, order_of
from .polygons import Polygons, find_polygons, vectors
from .reading import Reading
from .winds import winds

HIDDEN_CELL, HIDDEN_POINT = 32, 2  # vtkDataSetAttributes
LARGEST = 6  # maximum number of sides of a VTK prism; larger polygons are divided
LEVEL_SIZE = "SizeOfLevel"  # field array of columns of two levels at least: the numbers of points and of cells in a level
POLYGON = 7  # VTK_POLYGON
TYPES = {3: 13, 4: 12, 5: 15, 6: 16}  # VTK_WEDGE, VTK_HEXAHEDRON, VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM


def place_columns(reading: Reading, air: Air, variables, extra: dict[str, np.ndarray], *, radius: float = EARTH_RADIUS, vertical_exaggeration: float = 1.0,
                  mask_below_ground: bool = True, **others) -> pyvista.UnstructuredGrid:
    if others:
        raise ValueError(f"{', '.join(others)}: no option for an unstructured mesh, which is drawn on a globe with radius, vertical_exaggeration and mask_below_ground.")
    planet = require_number(radius, "radius", above=0), require_number(vertical_exaggeration, "vertical_exaggeration", least=0)
    polygons = find_polygons(reading.dataset, reading.horizontal)
    reading.note(f"cells by {polygons.source}: fields at their {'corners' if polygons.on_corners else 'centres'}")
    heights = air.heights if reading.vertical is not None else np.zeros((1, *reading.horizontal.shape))
    order = order_of(reading, heights)
    if polygons.on_corners:
        surfaces = heights[order]
    else:
        surfaces = at_corners(air.interfaces(order), polygons)
    faces, owner = divided(polygons.faces)
    grid = columns(polygons.corners, faces, surfaces, *planet)
    data = grid.point_data if polygons.on_corners else grid.cell_data
    spread = (lambda values: values) if polygons.on_corners else (lambda values: values[..., owner])
    _add_fields(grid, data, reading, chosen(reading, variables), extra, order, spread)
    _add_winds(data, reading, air, heights, order, spread, planet)
    data["Height"] = spread(heights[order]).astype(np.float32).ravel()
    _hide(data, reading, air, heights, order, spread, mask_below_ground, polygons.on_corners)
    grid.field_data["GlobeGridProjection"], grid.field_data["PlanetRadius"], grid.field_data["VerticalExaggeration"] = [0], [planet[0]], [planet[1]]
    choose_active_scalars(grid)
    return grid


def place_sheet_of_cells(reading: Reading, fields: dict[str, np.ndarray], units: str, *, radius: float = EARTH_RADIUS) -> pyvista.UnstructuredGrid:
    polygons = find_polygons(reading.dataset, reading.horizontal)
    faces, owner = divided(polygons.faces)
    grid = columns(polygons.corners, faces, np.zeros((1, len(polygons.corners))), radius, 1.0)
    for name, values in fields.items():
        (grid.point_data if polygons.on_corners else grid.cell_data)[name] = (values if polygons.on_corners else values[owner]).astype(np.float32)
        note_units(grid, name, units)
    return grid


def at_corners(heights: np.ndarray, polygons: Polygons) -> np.ndarray:
    """Heights (levels, cells) at the corners: the mean over the cells that meet there."""
    used = polygons.faces >= 0
    corner, cell = polygons.faces[used], np.nonzero(used)[0]
    result = np.empty((len(heights), len(polygons.corners)))
    for k, row in enumerate(heights):
        there = np.isfinite(row[cell])
        sums = np.bincount(corner[there], row[cell[there]], len(polygons.corners))
        counts = np.bincount(corner[there], minlength=len(polygons.corners))
        result[k] = sums / np.maximum(counts, 1)
    return result


def divided(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Faces with at most six sides, and for each the original face."""
    owner, parts = np.arange(len(faces)), [faces[:, :LARGEST]]
    owners, rest = [owner], faces
    while rest.shape[1] > LARGEST:
        more = rest[:, LARGEST] >= 0
        owner, rest = owner[more], np.concatenate([rest[more, :1], rest[more, LARGEST - 1:]], axis=1)
        parts.append(rest[:, :LARGEST])
        owners.append(owner)
    width = max(part.shape[1] for part in parts)
    return np.concatenate([np.pad(part, ((0, 0), (0, width - part.shape[1])), constant_values=-1) for part in parts]), np.concatenate(owners)


def columns(corners: np.ndarray, faces: np.ndarray, heights: np.ndarray, radius: float, exaggeration: float) -> pyvista.UnstructuredGrid:
    """Prisms between the surfaces `heights` (levels, corners), layer by layer; polygons if there is only one surface."""
    points = (corners[None] * (radius + exaggeration * heights)[..., None]).reshape(-1, 3)
    count = (faces >= 0).sum(axis=1)
    layers, sheet = len(heights) - 1, len(corners)
    cells, types, places = [], [], []
    for sides in np.unique(count[count > 2]):
        here = np.flatnonzero(count == sides)
        bottom = faces[here, :sides]
        if layers == 0:
            cells.append(bottom)
            types.append(np.full(len(here), POLYGON, np.uint8))
            places.append(here)
            continue
        if sides == 3:
            bottom = bottom[:, ::-1]  # point order of wedges in VTK up to 9.6; the package reads both orders
        prism = np.concatenate([bottom, bottom + sheet], axis=1)
        cells.append((prism[None] + sheet * np.arange(layers)[:, None, None]).reshape(-1, 2 * sides))
        types.append(np.full(len(cells[-1]), TYPES[sides], np.uint8))
        places.append((here[None] + len(faces) * np.arange(layers)[:, None]).ravel())
    grid = pyvista.UnstructuredGrid()
    grid.points = points
    if layers > 0:
        grid.field_data[LEVEL_SIZE] = [sheet, int(np.count_nonzero(count > 2))]
    connections, starts, types = _in_order(cells, types, places)
    grid.SetCells(numpy_to_vtk(types, deep=True, array_type=VTK_UNSIGNED_CHAR), pyvista.CellArray.from_arrays(starts, connections, deep=True))
    return grid


def offsets(grid: pyvista.UnstructuredGrid) -> np.ndarray:
    """Where the points of each cell begin in its connectivity; PyVista 0.49 has another name for it."""
    return np.asarray(grid.cell_offsets if hasattr(grid, "cell_offsets") else grid.offset)


def bases(grid: pyvista.UnstructuredGrid, cells: int, points: np.ndarray) -> pyvista.UnstructuredGrid:
    """The lower polygons of the first `cells` prisms of the grid that `columns` made, with these points."""
    starts = offsets(grid)[:cells + 1]
    sizes = np.diff(starts)
    corner = np.arange(starts[-1]) - np.repeat(starts[:-1], sizes)
    below = corner < np.repeat(sizes // 2, sizes)
    sheet = pyvista.UnstructuredGrid()
    sheet.points = points
    sheet.SetCells(numpy_to_vtk(np.full(cells, POLYGON, np.uint8), deep=True, array_type=VTK_UNSIGNED_CHAR),
                   pyvista.CellArray.from_arrays(np.concatenate([[0], np.cumsum(sizes // 2)]), grid.cell_connectivity[:starts[-1]][below], deep=True))
    return sheet


def _in_order(cells, types, places) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Corners of cells of several sizes, where each cell starts and its type, in the order of their positions."""
    if len(cells) == 1:  # in order
        return cells[0].ravel(), np.arange(len(cells[0]) + 1) * cells[0].shape[1], types[0]
    lengths = np.concatenate([np.full(len(part), part.shape[1]) for part in cells])
    order = np.argsort(np.concatenate(places), kind="stable")
    types = np.concatenate(types)[order]
    starts = np.concatenate([[0], np.cumsum(lengths[order])])
    found = np.empty(starts[-1], cells[0].dtype)
    new = np.empty(len(order), int)
    new[order] = starts[:-1]  # where each cell of the groups begins
    first = 0
    for part in cells:
        found[new[first:first + len(part), None] + np.arange(part.shape[1])] = part
        first += len(part)
    return found, starts, types


def _add_fields(grid, data, reading: Reading, names, extra, order, spread) -> None:
    fields = {name: reading.values(name) for name in names} | extra
    for name, values in fields.items():
        values = values[order] if values.ndim == 2 else values[None]
        data[name] = spread(values).astype(np.float32).ravel()
        note_units(grid, name, reading.dataset[name].attrs.get("units") if name in reading.dataset else UNITS.get(name))
        note_look(grid, reading.dataset, name)
    if reading.has("land"):
        data["Land"] = np.tile(spread(reading.role("land")), len(order)).astype(np.float32)


def _add_winds(data, reading: Reading, air: Air, heights, order, spread, planet) -> None:
    found, names = winds(reading, air)
    if not found:
        return
    lon, lat = reading.horizontal.places()
    up = vectors(lon, lat)
    east = vectors(lon + 90.0, np.zeros_like(lat))
    level = np.cross(up, east)
    u, v, w = (np.asarray(field)[order] for field in (*found, *[np.zeros_like(found[0])] * (3 - len(found))))
    flat = u[..., None] * east + v[..., None] * level
    wind = flat + w[..., None] * up
    radius, exaggeration = planet
    ratio = (radius + exaggeration * heights[order]) / (radius + heights[order])
    display = flat * ratio[..., None] + exaggeration * w[..., None] * up
    for name, values in (("Wind", wind), ("DisplayVelocity", display)):
        data[name] = np.stack([spread(values[..., c]) for c in range(3)], -1).reshape(-1, 3).astype(np.float32)
    data.active_vectors_name = "DisplayVelocity"


def _hide(data, reading: Reading, air: Air, heights, order, spread, mask: bool, on_corners: bool) -> None:
    below = ~np.isfinite(heights)
    if mask and reading.level_pressure is not None and air.surface_pressure is not None:
        below |= reading.level_pressure > air.surface_pressure
    if mask and reading.vertical is not None:
        if reading.vertical.kind == "pressure" and air.surface_pressure is not None:
            below |= air.pressure > air.surface_pressure
        elif air.terrain is not None:
            below |= heights < air.terrain - NEAR
    data["BelowGround"] = spread(below[order]).astype(np.uint8).ravel()
    hidden = np.asarray(data["BelowGround"]) * np.uint8(HIDDEN_POINT if on_corners else HIDDEN_CELL)
    if hidden.any():
        data["vtkGhostType"] = hidden
