# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain on a globe or a map (`vtkGlobeTerrain`), and its colours."""
from __future__ import annotations

from typing import Any, Literal

import pyvista
from pyvista.core.errors import MissingDataError

from . import vtkGlobeTerrain
from ._bars import add_mesh
from ._checks import choose, listed, require_number
from ._fields import terrain_preset
from ._medium import require_plotter
from ._pipeline import set_input, vtk_messages
from .globe import EARTH_RADIUS, _NAMES, _structured

# Usual names of the height of the ground and of the land fraction, including CF standard names.
USUAL_HEIGHTS = ("orog", "surface_altitude", "orography", "topo", "topography", "elevation", "terrain", "HGT", "HSURF", "hsurf", "zs", "zsurf")
USUAL_LAND = ("lsm", "land_area_fraction", "land_binary_mask", "sftlf", "LANDMASK", "LANDFRAC", "FR_LAND", "land")
COLOURS = 2048  # of the table, which has a jump at the coast


def terrain_surface(mesh: pyvista.DataSet, height: str | None = None, *, land: str | Literal[False] | None = None,
                    projection: Literal["globe", "map"] = "globe", radius: float = EARTH_RADIUS, vertical_exaggeration: float = 1.0,
                    height_units: Literal["automatic", "m", "km", "geopotential"] = "automatic",
                    central_meridian: float | None = None, sea_depth: float = 100.0) -> pyvista.StructuredGrid:
    """Make the terrain as a surface on a globe or a map, with mountains at their height and a flat sea.

    Also the accessor method ``mesh.nephoscope.terrain(...)``. Draw it with `add_terrain`, or with a texture like `globe_surface`.

    Parameters
    ----------
    mesh : pyvista.ImageData, pyvista.RectilinearGrid or pyvista.StructuredGrid
        One level: axes x longitude and y latitude in degrees, as in fields without levels from `read_cf`.
    height : str, optional
        Point or cell array of heights above sea level. Default: the first of these usual names that exists: ``"orog"``, ``"surface_altitude"``,
        ``"topo"``, ``"elevation"``, ``"HGT"``, ``"HSURF"``, ...
    land : str or False, optional
        Array of the land fraction, 0 to 1; 0.5 and more is land. Default: ``"lsm"`` or another usual name. Without such an array, or with False,
        points above sea level are land.
    projection, radius, vertical_exaggeration, central_meridian
        As in `to_globe`. An exaggeration of 20 to 50 makes mountains visible on a whole globe.
    height_units : {"automatic", "m", "km", "geopotential"}, default: "automatic"
        Units of `height`. Automatic: the units in the file; metres if there are none.
    sea_depth : float, default: 100.0
        Depth below 0 of the array ``Terrain`` in the open sea, in metres, 0 to 20000. It affects the colour only.

    Returns
    -------
    pyvista.StructuredGrid
        Points in metres. Point arrays: those of `mesh`; ``Height`` (m), 0 in the sea; the active scalars ``Terrain`` (m), the height on land,
        and in the sea from 0 at the coast to -`sea_depth`; ``Normals``; texture coordinates for a plate carrée picture from 180° W to 180° E.

    Raises
    ------
    TypeError
        If `mesh` is not a structured dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array does not exist; the message lists the arrays that do.
    ValueError
        If a number or a choice is out of range.
    RuntimeError
        If the filter cannot use the grid, with its message.
    """
    mesh = _structured(mesh, "mesh")
    terrain = vtkGlobeTerrain()
    set_input(terrain, mesh)
    terrain.SetHeightArrayName(_height_name(mesh, height))
    terrain.SetLandArrayName(_land_name(mesh, land))
    terrain.SetSeaDepth(require_number(sea_depth, "sea_depth", least=0, most=20000))
    choose({"globe": terrain.SetProjectionToGlobe, "map": terrain.SetProjectionToMap}, projection, "projection")
    choose({"automatic": terrain.SetHeightUnitsToAutomatic, "m": terrain.SetHeightUnitsToMetre, "km": terrain.SetHeightUnitsToKilometre,
            "geopotential": terrain.SetHeightUnitsToGeopotential}, height_units, "height_units")
    terrain.SetPlanetRadius(require_number(radius, "radius", above=0))
    terrain.SetVerticalExaggeration(require_number(vertical_exaggeration, "vertical_exaggeration", least=0))
    if central_meridian is not None:
        terrain.SetUseCentralMeridian(True)
        terrain.SetCentralMeridian(require_number(central_meridian, "central_meridian"))
    with vtk_messages(terrain, {**_NAMES, "Set HeightArrayName to": "Set height to"}):
        terrain.Update()
    return pyvista.wrap(terrain.GetOutput())


def add_terrain(plotter: pyvista.BasePlotter, terrain: pyvista.DataSet, *, cmap: Any = None, clim: Any = None, **options: Any) -> pyvista.Actor:
    """Add terrain to a plotter, coloured by altitude: blue sea; green, brown and white land.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter.
    terrain : pyvista.DataSet
        A result of `terrain_surface`, or any surface with an array ``Terrain`` in metres.
    cmap, clim
        As in `pyvista.Plotter.add_mesh`. Default: the preset *Nephoscope Terrain*, -100 to 6000 m.
    **options
        Passed on to `pyvista.Plotter.add_mesh`.

    Returns
    -------
    pyvista.Actor
        The actor in the plotter.

    Raises
    ------
    TypeError
        If `plotter` is not a plotter.
    pyvista.core.errors.MissingDataError
        (a ValueError) If `terrain` has no array ``Terrain``.
    """
    require_plotter(plotter)
    if "Terrain" not in getattr(terrain, "point_data", ()):
        raise MissingDataError("terrain has no point array 'Terrain'. Make it with terrain_surface.")
    limits, colours = terrain_preset(COLOURS)
    defaults = {"scalars": "Terrain", "clim": limits if clim is None else clim, "cmap": colours if cmap is None else cmap}
    return add_mesh(plotter, terrain, "Height (m)", **{**defaults, **options})


def _height_name(mesh: pyvista.DataSet, height: str | None) -> str:
    if height is None:
        height = next((name for name in USUAL_HEIGHTS if name in mesh.array_names), None)
        if height is None:
            raise MissingDataError("mesh has no array with a usual name for the height of the ground; name one with height. "
                                   f"Its arrays: {listed(_arrays(mesh))}.")
    elif height not in _arrays(mesh):
        raise MissingDataError(f"height: there is no array {height!r}. The arrays: {listed(_arrays(mesh))}.")
    return height


def _land_name(mesh: pyvista.DataSet, land: str | Literal[False] | None) -> str:
    if land is None:
        return next((name for name in USUAL_LAND if name in mesh.array_names), "")
    if land is not False and land not in _arrays(mesh):
        raise MissingDataError(f"land: there is no array {land!r}. The arrays: {listed(_arrays(mesh))}.")
    return land or ""


def _arrays(mesh: pyvista.DataSet) -> list[str]:
    return [*mesh.point_data.keys(), *mesh.cell_data.keys()]
