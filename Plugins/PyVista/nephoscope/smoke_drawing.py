# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke in a plotter: a flow volume drawn by cell compositing, with opacity from its density."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

from ._checks import arrays_of, require_number
from ._media import colours_of, extinction_at, media_in_view, vector_colours
from ._medium import is_light, require_plotter
from .cells import add_cells
from .light import SMOKE, lit, lit_colours

LOUD = "orangered"  # for smoke that would have the colour of a medium
NEAR = 0.35  # distance of colours that are hardly told apart, as of streaks in a medium
SHOWN = 4.0  # least extinction, of that of the media around: of the light that comes from there, four fifths are the smoke's own
DEEPEST = 2.0  # optical depth of the width by default: thicker smoke would look like a solid body
HEADROOM = 1e4  # densities up to so many times the one of opacity 1 are drawn: values may be raised in place, and flows may converge


def add_smoke(plotter: pyvista.BasePlotter, volume: pyvista.UnstructuredGrid, scalars: str | None = None, *,
              color: Any = None, density: str | None = None, optical_depth: float | None = None, reference_density: float | None = None,
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
        sorting. Vectors give their magnitude, or one component if `component` is among the options.
    color : ColorLike, optional
        The colour without `scalars`. Default: white, or dark grey on a light background. If a volume in the view other than smoke has that colour, the other of these, or orange.
    density : str, optional
        Point or cell array that the extinction coefficient is proportional to. Default: ``"SmokeDensity"`` if it exists, otherwise
        ``"Density"``.
    optical_depth : float, optional
        Optical depth of a path as long as the generating polygon is wide, through smoke of the `reference_density`, > 0. 1 transmits exp(-1) of the
        light. Default: 1; within the bounds of other volumes in the view as much more as the smoke needs to have four times their greatest extinction, but at most 2. What these hide in front of the smoke
        stays hidden: give them a larger `opacity_unit_distance`. With `sun` always 1.
    reference_density : float, optional
        The density to which `optical_depth` refers, > 0. Default: in smoke of an unsteady flow (`flow_volume` with `times`) the density at the polygon,
        so that the frames of a film are comparable; otherwise the mean ``Density``, so that any smoke is visible. To compare pictures of steady
        smoke, pass the same density for all: `initial_density` of `flow_volume`, 1 by default.
    sun : sequence of 3 float, str, dict or True, optional
        Lights the smoke by the sun, given as in `add_cells`, with its own shadow and that of clouds, ``{'direction': (1, 0, 0.5), 'clouds': lit_clouds}``. The
        scattering is that of smoke from vegetation fires: ``'albedo'`` 0.9, ``'asymmetry'`` 0.6. Light scattered straight forward counts as transmitted. `color` multiplies the light.
        `exposure` and `tone_mapping` are those of `add_cells`.
    **options
        The other arguments of `add_cells`: `name`, `show_scalar_bar`, ...; with `scalars` also `cmap` and `clim`. Opacities are proportional to the
        density, however high it is. `opacity` gives another function of the density, from 0 to its maximum or, if `reference_density` is given or
        the flow is unsteady, to that density.

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
        If an argument is out of range or has no effect on smoke, or the volume has no cells.
    """
    if not isinstance(volume, pyvista.UnstructuredGrid):
        raise TypeError(f"volume is a {type(volume).__name__}; it must be an UnstructuredGrid from flow_volume.")
    if volume.n_cells == 0:
        raise ValueError("volume, the result of flow_volume, has no cells: no smoke was traced, and the warning of flow_volume says why. With coordinates in different units, such as "
                         "degrees and metres, give it duration and radius.")
    _refuse_ranges(scalars is not None or sun is not None, options)
    density = _density_name(volume, density)
    reference = _reference(volume, density, reference_density)
    require_plotter(plotter)
    width, media = _width(volume), [one for one in media_in_view(plotter) if not getattr(one.GetMapper(), "_is_smoke", False)]
    least = 1.0 if sun is not None else min(max(1.0, SHOWN * width * extinction_at(media, volume.bounds)), DEEPEST)
    depth = least if optical_depth is None else require_number(optical_depth, "optical_depth", above=0)
    distance = width * (reference or _mean(volume, density) or 1.0) / depth  # in smoke of density 1
    if sun is not None:
        return _add_lit(plotter, volume, density, scalars, color, distance, sun, options)
    full = reference or _highest(volume, density)  # the density of opacity 1
    if "unit_distance" not in options:  # the old name
        options.setdefault("opacity_unit_distance", distance / full)
    is_linear = isinstance(options.setdefault("opacity", "linear"), str) and options["opacity"] == "linear"
    headroom = HEADROOM if is_linear else 1.0
    options["opacity_scale"] = headroom * require_number(options.get("opacity_scale", 1.0), "opacity_scale", least=0)
    limits = (0.0, full * headroom)
    if scalars is None:
        one = pyvista.Color(_colour(plotter, media) if color is None else color).hex_rgb
        options["cmap"] = [one, one]
        if not options.setdefault("show_scalar_bar", False):
            return _smoke(add_cells(plotter, volume, density, clim=limits, **options))
        scalars, options["clim"] = density, (0.0, full)
    return _smoke(add_cells(plotter, volume, scalars, opacity_scalars=density, opacity_clim=limits, **options))


def _smoke(drawn: pyvista.Volume) -> pyvista.Volume:
    """The volume, marked for smoke that is added later: all smoke looks alike."""
    drawn.mapper._is_smoke = True
    return drawn


def _colour(plotter: pyvista.BasePlotter, media: list[Any]) -> str:
    """The first that is not near a colour of the other media and of vectors; otherwise the farthest."""
    usual = ["dimgray", "white"] if is_light(plotter) else ["white", "dimgray"]
    vectors = vector_colours(plotter)
    if not media and not vectors:
        return usual[0]
    others = np.concatenate([[plotter.background_color.float_rgb, *vectors], *(colours_of(volume.GetProperty()) for volume in media)])
    distances = {name: float(np.linalg.norm(others - pyvista.Color(name).float_rgb, axis=1).min()) for name in (*usual, LOUD)}
    return next((name for name, distance in distances.items() if distance >= NEAR), max(distances, key=distances.__getitem__))


def _refuse_ranges(has_colours: bool, options: dict[str, Any]) -> None:
    """Raises ValueError for arguments of `add_cells` that would contradict those of `add_smoke`."""
    for name in () if has_colours else ("cmap", "clim"):
        if options.get(name) is not None:
            raise ValueError(f"{name} is given without scalars: smoke has one colour, color. Pass scalars, the name of the array to colour it by. For denser or thinner "
                             "smoke pass optical_depth or reference_density.")
    if options.get("opacity_scalars") is not None:
        raise ValueError(f"opacity_scalars is {options['opacity_scalars']!r}; name the array that the opacity of smoke comes from as density.")
    if options.get("opacity_clim") is not None:
        raise ValueError("opacity_clim is given, but the opacity of smoke is proportional to its density. Pass reference_density, the density to which optical_depth refers.")


def _add_lit(plotter: pyvista.BasePlotter, volume: pyvista.UnstructuredGrid, density: str, scalars: str | None, color: Any, distance: float, sun: Any,
             options: dict[str, Any]) -> pyvista.Volume:
    if scalars is not None:
        raise ValueError("scalars and sun are both given: the colours are those of the light. Leave one out; color multiplies the light.")
    mesh = volume.copy(deep=False)
    if sun is not True or "SmokeExtinction" not in volume.point_data:  # the light of the clouds that it was made in
        data = mesh.cell_data if density in mesh.cell_data else mesh.point_data
        data["SmokeExtinction"] = _array(volume, density) / distance
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


def _reference(volume: pyvista.UnstructuredGrid, density: str, given: float | None) -> float | None:
    """The density that the caller has given, or that at the polygon where the flow is unsteady."""
    if given is not None:
        return require_number(given, "reference_density", above=0)
    known = np.ravel(volume.field_data.get("InitialDensity", ()))
    return float(known[0]) if known.size == 1 and density in ("Density", "SmokeDensity") and 0 < known[0] < np.inf else None


def _width(volume: pyvista.UnstructuredGrid) -> float:
    """The extent of the youngest layer of points, which is the generating polygon, as in ParaView's Cell Compositing: a disc of radius R has bounds with a
    diagonal of sqrt(8) R, however it is turned."""
    if volume.n_cells == 0:
        return 1.0  # add_cells reports the error
    points = volume.points
    if "Age" in volume.point_data:
        points = points[volume.point_data["Age"] <= np.nanmin(volume.point_data["Age"])]
    return float(np.linalg.norm(np.ptp(points, axis=0)) / np.sqrt(2)) or volume.length / 50


def _mean(volume: pyvista.UnstructuredGrid, density: str) -> float:
    """The mean over the volume, as in ParaView, of Density, which unlike SmokeDensity does not change with time; 0 if it is not known."""
    name = "Density" if "Density" in volume.cell_data else density
    if name not in volume.cell_data:
        return 0.0
    volumes = np.abs(volume.compute_cell_sizes(length=False, area=False)["Volume"])
    values = _array(volume, name)
    known = np.isfinite(values)
    return max(0.0, float(np.sum(values[known] * volumes[known]) / max(volumes[known].sum(), np.finfo(float).tiny)))
