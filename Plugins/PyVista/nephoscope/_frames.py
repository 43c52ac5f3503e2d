# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Warns of data in one plotter that do not match the others: globe and map, other radii, other longitudes."""
from __future__ import annotations

import warnings
from typing import Any, Iterator

import numpy as np
import pyvista

from ._fields import FLAT_GRID
from .globe import lowest_middle

HIDDEN = 0.1  # of the height of the data
LEVEL = 4  # stack level of the caller of add_cells or add_splats


def warn_of_other_frames(plotter: pyvista.BasePlotter, data: pyvista.DataSet) -> None:
    """One RuntimeWarning for each way in which `data` from `to_globe` does not fit the other data in the plotter."""
    problems = {problem for other in _shown(plotter) for problem in _differences(data, other)}
    for problem in sorted(problems):
        warnings.warn(problem, RuntimeWarning, stacklevel=LEVEL)


def _shown(plotter: pyvista.BasePlotter) -> Iterator[pyvista.DataSet]:
    for actor in getattr(getattr(plotter, "renderer", None), "actors", {}).values():
        dataset = getattr(getattr(actor, "mapper", None), "dataset", None)
        if isinstance(dataset, pyvista.DataSet) and dataset.n_points:
            yield dataset


def _differences(data: pyvista.DataSet, other: pyvista.DataSet) -> Iterator[str]:
    here, there = (_number(mesh, "GlobeGridProjection") for mesh in (data, other))
    scales = [_number(mesh, "VerticalExaggeration") for mesh in (data, other)]
    if None not in scales and scales[0] != scales[1] and all(FLAT_GRID in mesh.field_data and mesh.bounds[5] > mesh.bounds[4] for mesh in (data, other)):
        yield _other_scale(*scales, "grid")
    if here is None or there is None:
        return
    if here != there:
        names = ("a globe", "a map")
        yield (f"The data are on {names[int(here)]}, but the data shown already are on {names[int(there)]}. "
               "Use the same projection for to_globe and globe_surface.")
        return
    radius, other_radius = (_number(mesh, "PlanetRadius") for mesh in (data, other))
    if radius and other_radius and abs(radius / other_radius - 1) > 1e-6:
        yield (f"The data are on a planet with a radius of {radius:g} m, but the data shown already on one of {other_radius:g} m. "
               "Use the same radius for to_globe and globe_surface.")
    elif here == 1 and radius:
        yield from _other_longitudes(data, other, radius)
    elif not _has_height(other):
        yield from _hidden_cells(data, other)
    if None not in scales and scales[0] != scales[1] and all(_has_height(mesh) for mesh in (data, other)):
        yield _other_scale(*scales, "to_globe")


def _other_scale(here: float | None, there: float | None, function: str) -> str:
    return (f"The vertical exaggeration of the data is {here:g}, but that of the data shown already is {there:g}. "
            f"Use the same vertical_exaggeration in {function} for both.")


def _other_longitudes(data: pyvista.DataSet, other: pyvista.DataSet, radius: float) -> Iterator[str]:
    """True on maps if one dataset spans the globe and the other extends beyond its edges."""
    spans = [np.degrees(np.array(mesh.bounds[:2]) / radius) for mesh in (data, other)]
    for (west, east), (left, right) in (spans, spans[::-1]):
        if right - left > 300 and (west < left - 1 or east > right + 1) and (east - west) < 361:
            yield (f"On the map one dataset has the longitudes {spans[0][0]:.4g} to {spans[0][1]:.4g}, the other {spans[1][0]:.4g} to "
                   f"{spans[1][1]:.4g}. Use the same central_meridian, in degrees east, for to_globe and globe_surface.")
            return


def _hidden_cells(data: pyvista.DataSet, surface: pyvista.DataSet) -> Iterator[str]:
    """True on globes whose flat cells cut into the surface of the planet by much of the height of the data."""
    lowest, ground = lowest_middle(data), float(np.linalg.norm(surface.points, axis=1).min())
    top = float(np.nanmax(np.linalg.norm(data.points, axis=1))) - ground
    if ground - lowest > HIDDEN * top:
        yield (f"The cells of the data are flat: their middles lie up to {(ground - lowest) / 1000:.2g} km below the surface of the planet, which hides them there; "
               f"the data are {top / 1000:.2g} km high. Make the surface with globe_surface(below=the data), or raise vertical_exaggeration.")


def _has_height(mesh: pyvista.DataSet) -> bool:
    heights = mesh.point_data.get("Height")
    return heights is not None and float(np.nanmax(np.abs(heights))) > 0


def _number(mesh: pyvista.DataSet, name: str) -> float | None:
    values: Any = mesh.field_data.get(name)
    return None if values is None or len(values) == 0 else float(values[0])
