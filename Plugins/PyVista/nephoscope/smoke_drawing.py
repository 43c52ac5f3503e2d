# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke in a plotter: a flow volume drawn by cell compositing, with opacity from its density."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

from ._checks import arrays_of, require_number
from ._medium import is_light, require_plotter
from .cells import add_cells
from .light import SMOKE, lit, lit_colours


def add_smoke(plotter: pyvista.BasePlotter, volume: pyvista.UnstructuredGrid, scalars: str | None = None, *,
              color: Any = None, density: str | None = None, optical_depth: float = 1.0,
              sun: Any = None, **options: Any) -> pyvista.Volume:
    """Add smoke to a plotter. Its extinction coefficient is proportional to its density; its colour is uniform or comes from an array.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets the smoke.
    volume : pyvista.UnstructuredGrid
        The result of `flow_volume` or `smoke_puffs`.
    scalars : str, optional
        Point or cell array that colours the smoke, for example ``"Age"``. Default: none; the smoke has one colour, and its cells need no
        sorting.
    color : ColorLike, optional
        The colour without `scalars`. Default: white, or dark grey on a light background.
    density : str, optional
        Point or cell array that the extinction coefficient is proportional to. Default: ``"SmokeDensity"`` if it exists, otherwise
        ``"Density"``.
    optical_depth : float, default: 1.0
        Optical depth of a path as long as the generating polygon is wide, through smoke of the mean ``Density``, > 0. 1 transmits exp(-1) of the
        light.
    sun : sequence of 3 float, str, dict or True, optional
        Draws the smoke as the sun shows it, as in `add_cells`: with its own shadow, and that of clouds, ``{'direction': (1, 0, 0.5), 'clouds': lit_clouds}``. Smoke
        scatters as that of vegetation fires does: ``'albedo'`` 0.9, ``'asymmetry'`` 0.6. Light that goes straight on counts as let through. `color` multiplies the light.
        `exposure` and `tone_mapping` are those of `add_cells`.
    **options
        The other arguments of `add_cells`: `cmap`, `clim`, `name`, `show_scalar_bar`, ...

    Returns
    -------
    pyvista.Volume
        The volume in the plotter, see `add_cells`.

    Raises
    ------
    TypeError
        If `volume` is not an UnstructuredGrid.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array does not exist; the message lists the arrays that do.
    ValueError
        If an argument is out of range, or the volume has no cells.
    """
    if not isinstance(volume, pyvista.UnstructuredGrid):
        raise TypeError(f"volume is a {type(volume).__name__}; it must be an UnstructuredGrid from flow_volume.")
    density = _density_name(volume, density)
    highest = _highest(volume, density)
    if sun is not None:
        return _add_lit(plotter, volume, density, scalars, color, optical_depth, sun, options)
    options.setdefault("opacity", "linear")
    depth = require_number(optical_depth, "optical_depth", above=0)
    if "unit_distance" not in options:  # the old name
        options.setdefault("opacity_unit_distance", _unit_distance(volume, density) / highest / depth)
    if scalars is None:
        require_plotter(plotter)
        default = "dimgray" if is_light(plotter) else "white"
        one = pyvista.Color(default if color is None else color).hex_rgb
        return add_cells(plotter, volume, density, cmap=[one, one], clim=(0.0, highest),
                         show_scalar_bar=options.pop("show_scalar_bar", False), **options)
    return add_cells(plotter, volume, scalars, opacity_scalars=density, opacity_clim=(0.0, highest), **options)


def _add_lit(plotter: pyvista.BasePlotter, volume: pyvista.UnstructuredGrid, density: str, scalars: str | None, color: Any, optical_depth: float, sun: Any,
             options: dict[str, Any]) -> pyvista.Volume:
    if scalars is not None:
        raise ValueError("scalars and sun are both given: the colours are those of the light. Leave one out; color multiplies the light.")
    mesh = volume.copy(deep=False)
    if sun is not True or "SmokeExtinction" not in volume.point_data:  # the light of the clouds that it was made in
        depth = require_number(optical_depth, "optical_depth", above=0)
        data = mesh.cell_data if density in mesh.cell_data else mesh.point_data
        data["SmokeExtinction"] = _array(volume, density) * depth / _unit_distance(volume, density)
        mesh = lit(mesh, {} if sun is True else sun, extinction="SmokeExtinction", **SMOKE)
    tint = (1.0, 1.0, 1.0) if color is None else pyvista.Color(color).float_rgb
    options.setdefault("cmap", lit_colours(256, options.get("tone_mapping", "contrast"), tint))
    return add_cells(plotter, mesh, sun=True, show_scalar_bar=options.pop("show_scalar_bar", False), **options)


def _density_name(volume: pyvista.UnstructuredGrid, name: str | None) -> str:
    names = ("SmokeDensity", "Density") if name is None else (name,)
    for candidate in names:
        if candidate in volume.cell_data or candidate in volume.point_data:
            return candidate
    raise MissingDataError(f"density: no array {names[-1]!r}. {arrays_of(volume)}")


def _array(volume: pyvista.UnstructuredGrid, name: str) -> np.ndarray:
    return np.asarray(volume.cell_data[name] if name in volume.cell_data else volume.point_data[name], float)


def _highest(volume: pyvista.UnstructuredGrid, name: str) -> float:
    """The density at the upper end of the opacity function, a straight line from zero."""
    values = _array(volume, name)
    values = values[np.isfinite(values)]
    return float(values.max()) if values.size and values.max() > 0 else 1.0


def _unit_distance(volume: pyvista.UnstructuredGrid, density: str) -> float:
    """Length in smoke of density 1 that has an optical depth of 1, chosen as in ParaView's Cell Compositing.

    It is the extent of the youngest layer of points, which is the generating polygon, times the mean density: a disc of radius R has bounds
    with a diagonal of sqrt(8) R, however it is turned. SmokeDensity changes with time, Density does not.
    """
    if volume.n_cells == 0:
        return 1.0  # add_cells reports the error
    points = volume.points
    if "Age" in volume.point_data:
        points = points[volume.point_data["Age"] <= np.nanmin(volume.point_data["Age"])]
    width = float(np.linalg.norm(np.ptp(points, axis=0)) / np.sqrt(2)) or volume.length / 50
    name = "Density" if "Density" in volume.cell_data else density
    if name not in volume.cell_data:
        return width
    volumes = np.abs(volume.compute_cell_sizes(length=False, area=False)["Volume"])
    values = _array(volume, name)
    known = np.isfinite(values)
    mean = float(np.sum(values[known] * volumes[known]) / max(volumes[known].sum(), np.finfo(float).tiny))
    return width * mean if mean > 0 else width
