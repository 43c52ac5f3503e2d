# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Longitude-latitude-level fields on a globe or a map (`vtkGlobeGrid`), and the surface below them."""
from __future__ import annotations

import math
import re
from typing import Any, Literal, Sequence

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid, vtkStructuredGrid

from . import vtkGlobeGrid
from ._checks import choose, require_array, require_number
from ._pipeline import set_input, vtk_messages
from ._typing import StructuredMesh

EARTH_RADIUS = 6371000.0  # metres, mean radius
# Usual names of the winds: eastward, northward, and the possible names of the vertical wind. "w" of ERA5 and "wap" of CMIP are omega.
USUAL_WINDS = (("u", "v", ("w",)), ("ua", "va", ("wa", "wap")), ("U", "V", ("W", "OMEGA")))
UPWARD = ("wa", "W")  # in m/s, unless their units say otherwise
SPEED, OMEGA = ("ms-1", "m/s"), ("pas-1", "pa/s")
HEIGHTS = ("m2s-2", "m2/s2", "m", "gpm")  # units of an array "z" that gives heights
# Terms in messages of vtkGlobeGrid, and their names in Python.
_NAMES = {"Set HeightUnits if 'geometric_height' is a geopotential (m2 s-2) or in kilometres, or choose another HeightArrayName":  # the array of datasets
          "If they are in another unit, name it: ds['NAME'].attrs['units'] = 'km'; dataset.nephoscope.describe() tells what they come from",
          "set the wind array names to those of the input": "name those of the input by wind", "HeightArrayName": "height",
          "HeightUnits": "height_units", "LevelUnits": "level_units", "WindComponents": "wind_components",
          "set WindComponents to Along Grid; else set it to East And North": "pass wind_components='along-grid', else 'east-north'",
          "switch VerticalWindIsOmega off": "pass vertical_wind_is_omega=False",
          "switch VerticalWindIsOmega on": "pass vertical_wind_is_omega=True", "PlanetRadius": "radius",
          "VerticalExaggeration": "vertical_exaggeration", "(Extract Subset)": "(extract_subset)",
          "or set its name empty to say so": "or leave it out of wind",
          "Turn on Replace Fill Value With Nan of the NetCDF reader, or replace the values by NaN": "Replace the values by numpy.nan",
          "with the NetCDF CF reader switch 'Spherical Coordinates' off": "read the file by nephoscope.read_cf"}
GAPS_ARE_TOLD = "nephoscope_gaps_are_told"  # field array of a mesh whose reader has warned of points without a height
IS_SEA = "nephoscope_is_sea"  # field array of a mesh whose heights are known to be below the sea
_TOLD = {GAPS_ARE_TOLD: "values of the height array", IS_SEA: "which is implausible on Earth"}  # parts of warnings that such meshes do not need
DEGREES_PER_CELL = 1.0    # of globe_surface; its chords are at most 0.25 km below the Earth's sphere


def is_map(mesh: pyvista.DataSet) -> bool:
    """Whether the mesh lies on a map; False for one on a globe or elsewhere."""
    return str(np.ravel(mesh.field_data.get("GlobeGridProjection", ["globe"]))[0]).lower() in ("1", "1.0", "map")


def planet_radius(mesh: pyvista.DataSet) -> float:
    """The radius in metres of the planet whose globe or map the mesh lies on; that of the Earth for other meshes."""
    return float(np.ravel(mesh.field_data.get("PlanetRadius", [EARTH_RADIUS]))[0])


def to_globe(mesh: pyvista.DataSet, *, projection: Literal["globe", "map"] = "globe", radius: float = EARTH_RADIUS,
             vertical_exaggeration: float = 1.0, height: str | Literal[False] | None = None,
             wind: Sequence[str] | Literal[False] | None = None, vertical_wind_is_omega: bool | None = None,
             level_units: Literal["automatic", "hPa", "Pa", "m", "km"] = "automatic", close_seam: bool = True,
             close_poles: bool = True, height_units: Literal["automatic", "m", "km", "geopotential"] = "automatic",
             wind_components: Literal["automatic", "east-north", "along-grid"] = "automatic",
             central_meridian: float | None = None, mask_below_ground: bool = True,
             surface: pyvista.DataSet | None = None, temperature: str | None = None, surface_pressure: str = "sp",
             terrain_height: str = "orog") -> StructuredMesh:
    """Place a longitude-latitude-level grid on a globe or a map, with the winds as vectors.

    Also the accessor method ``mesh.nephoscope.globe(...)``.

    Parameters
    ----------
    mesh : pyvista.ImageData, pyvista.RectilinearGrid or pyvista.StructuredGrid
        Axes x longitude and y latitude in degrees, z the level: a pressure or a height.
    projection : {"globe", "map"}, default: "globe"
        Globe: distance radius + vertical_exaggeration * height from the origin, longitude 0 on the x axis, the North Pole
        on the z axis. Map (plate carrée): x and y are radius * longitude and latitude in radians, z the exaggerated height.
    radius : float, default: 6371000.0
        Radius of the planet in metres, > 0.
    vertical_exaggeration : float, default: 1.0
        Multiplies heights, >= 0. Values from 20 to 100 make weather visible on a whole globe.
    height : str or False, optional
        Array of heights above sea level. Default: ``"gh"``, ``"zg"``, or ``"z"`` if its units are known (m, gpm or m2 s-2; `read_cf` records
        them). Without such an array, or with False, the level axis gives the heights.
    wind : sequence of 2 or 3 str, or False, optional
        Arrays of the eastward, northward (m/s) and vertical wind. Default: the first of ``("u", "v", "w")``, ``("ua", "va", "wa")``, ``("ua",
        "va", "wap")``, ``("U", "V", "W")`` and ``("U", "V", "OMEGA")`` whose first two arrays exist and have one component each. False: no wind.
    vertical_wind_is_omega : bool, optional
        True: the vertical wind is omega = dp/dt in Pa/s, positive downwards. False: it is upward wind in m/s. Default: chosen by its units, if
        they are known (`read_cf` records them); otherwise False for ``"wa"`` and ``"W"`` and True for other names. Omega is converted to upward
        wind with the temperature ``"t"`` or ``"ta"`` (K), or without it by the standard atmosphere.
    level_units : {"automatic", "hPa", "Pa", "m", "km"}, default: "automatic"
        Meaning of the z axis of `mesh`. Automatic: guessed from the sign and size of the values.
    close_seam : bool, default: True
        Repeats the first column of a global grid after the last, which closes the gap at the seam.
    close_poles : bool, default: True
        Adds a row at each pole if a global grid ends within one grid spacing of it, as Gaussian and cell-centred grids do. Its values are the
        mean of the last row; its winds are the mean vector.
    height_units : {"automatic", "m", "km", "geopotential"}, default: "automatic"
        Units of `height`; a geopotential is in m2 s-2. Automatic: the units in the file. If the file has no units and the levels are pressures:
        the units that fit the standard atmosphere best, with a warning if these are not metres.
    wind_components : {"automatic", "east-north", "along-grid"}, default: "automatic"
        Directions of the horizontal wind arrays: east and north, or along and across the rows of a curvilinear grid (GRIB: uvRelativeToGrid).
        Automatic: along the grid if the arrays are named x_wind and y_wind, otherwise east and north, with a warning if the rows do not follow
        parallels.
    central_meridian : float, optional
        Map only: longitude of the middle of the map, in degrees east. Default: the map keeps the longitudes of the mesh.
    mask_below_ground : bool, default: True
        Hides points below the ground; see `surface`.
    surface : pyvista.DataSet, optional
        One level with the longitudes and latitudes of `mesh` and the surface pressure (Pa or hPa) or the terrain height (m). Default: arrays of
        `mesh`. Without either array the ground is at sea level.
    temperature : str, optional
        Array of the temperature in K, used to convert omega to upward wind. Default: ``"t"`` or ``"ta"``, if present.
    surface_pressure, terrain_height : str, default: "sp", "orog"
        Names of these arrays in `surface` or `mesh`.

    Returns
    -------
    pyvista.StructuredGrid
        Points in metres. Point arrays: those of `mesh`; ``Height`` (m); ``BelowGround`` (1 below the ground) and, if a point
        is hidden, ``vtkGhostType``; with winds ``Wind`` (m/s, Cartesian, 3 components) and the active vectors
        ``DisplayVelocity`` (m/s in display space, 3 components).

    Raises
    ------
    TypeError
        If `mesh` is not a structured dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If a named array does not exist; the message lists the arrays that do.
    ValueError
        If a number or a choice is out of range.
    RuntimeError
        If the filter cannot use the grid, with its message.

    Warns
    -----
    RuntimeWarning
        The warnings of the filter.
    """
    globe = vtkGlobeGrid()
    mesh = _structured(mesh, "mesh")
    set_input(globe, mesh)
    choose({"globe": globe.SetProjectionToGlobe, "map": globe.SetProjectionToMap}, projection, "projection")
    choose({"automatic": globe.SetLevelUnitsToAutomatic, "hPa": globe.SetLevelUnitsToPressureHectopascal,
            "Pa": globe.SetLevelUnitsToPressurePascal, "m": globe.SetLevelUnitsToHeightMetre,
            "km": globe.SetLevelUnitsToHeightKilometre}, level_units, "level_units")
    choose({"automatic": globe.SetHeightUnitsToAutomatic, "m": globe.SetHeightUnitsToMetre,
            "km": globe.SetHeightUnitsToKilometre, "geopotential": globe.SetHeightUnitsToGeopotential}, height_units,
           "height_units")
    choose({"automatic": globe.SetWindComponentsToAutomatic, "east-north": globe.SetWindComponentsToEastNorth,
            "along-grid": globe.SetWindComponentsToAlongGrid}, wind_components, "wind_components")
    globe.SetPlanetRadius(require_number(radius, "radius", above=0))
    globe.SetVerticalExaggeration(require_number(vertical_exaggeration, "vertical_exaggeration", least=0))
    _name_height(globe, mesh, height)
    vertical = _name_winds(globe, mesh, wind)
    globe.SetVerticalWindIsOmega(_is_omega(mesh, vertical) if vertical_wind_is_omega is None else vertical_wind_is_omega)
    if temperature is not None:
        require_array(mesh, temperature, "temperature")
        globe.SetTemperatureArrayName(temperature)
    elif "ta" in mesh.array_names and "t" not in mesh.array_names:
        globe.SetTemperatureArrayName("ta")
    globe.SetSurfacePressureArrayName(surface_pressure)
    globe.SetTerrainHeightArrayName(terrain_height)
    globe.SetCloseSeam(close_seam)
    globe.SetClosePoles(close_poles)
    globe.SetMaskBelowGround(mask_below_ground)
    if central_meridian is not None:
        globe.SetUseCentralMeridian(True)
        globe.SetCentralMeridian(require_number(central_meridian, "central_meridian"))
    if surface is not None:
        globe.SetSurfaceData(_structured(surface, "surface"))
    with vtk_messages(globe, _NAMES, [text for mark, text in _TOLD.items() if mark in mesh.field_data]):
        globe.Update()
    output = pyvista.wrap(globe.GetOutput())
    for mark in _TOLD:
        output.field_data.pop(mark, None)
    return output


def globe_surface(*, projection: Literal["globe", "map"] = "globe", radius: float = EARTH_RADIUS,
                  central_meridian: float = 0.0, below: pyvista.DataSet | None = None) -> pyvista.StructuredGrid:
    """Make the surface of the planet at height 0, with texture coordinates for a plate carrée picture.

    The picture spans longitude -180 to 180 from its left to its right edge and latitude -90 to 90 from bottom to top,
    as NASA's Blue Marble does.

    Parameters
    ----------
    projection : {"globe", "map"}, default: "globe"
        As in `to_globe`.
    radius : float, default: 6371000.0
        Radius of the planet in metres, > 0.
    central_meridian : float, default: 0.0
        Longitude of the middle of the map, in degrees east; 180 for data from 0 to 360. It has no effect on a globe.
    below : pyvista.StructuredGrid, optional
        A result of `to_globe`. Its cells are flat, so their middles lie below the sphere through their corners: 3 km for cells of 2.5
        degrees, 12 km for 5 degrees. The surface is placed below them. It has no effect on a map.

    Returns
    -------
    pyvista.StructuredGrid
        Quadrilaterals of one degree, 361 x 181 x 1 points in metres, active texture coordinates.

    Raises
    ------
    ValueError
        If the projection is unknown or the radius is not above 0.
    """
    centre = require_number(central_meridian, "central_meridian")
    longitudes = centre + np.linspace(-180, 180, 1 + round(360 / DEGREES_PER_CELL))
    latitudes = np.linspace(-90, 90, 1 + round(180 / DEGREES_PER_CELL))
    flat = pyvista.RectilinearGrid(longitudes, latitudes, [0.0])
    u, v = np.meshgrid(longitudes / 360 + 0.5, latitudes / 180 + 0.5)
    flat.point_data["TextureCoordinates"] = np.stack([u.ravel(), v.ravel()], axis=1)
    surface = to_globe(flat, projection=projection, radius=radius, level_units="m", wind=False, close_seam=False,
                       mask_below_ground=False)
    surface.active_texture_coordinates = np.asarray(surface.point_data["TextureCoordinates"])
    surface.set_active_scalars(None)  # without a texture it has one colour
    if below is not None and projection == "globe":
        surface.points *= min(1.0, lowest_middle(_structured(below, "below")) / radius)
    return surface


def lowest_middle(globe: pyvista.DataSet) -> float:
    """The least distance of the middle of a cell's side from the centre of the planet, along the first level of a globe; inf for other data."""
    sizes = getattr(globe, "dimensions", (0, 0, 0))
    if not isinstance(globe, pyvista.StructuredGrid) or min(sizes[:2]) < 2:
        return math.inf
    level = np.asarray(globe.points, float)[:sizes[0] * sizes[1]].reshape(sizes[1], sizes[0], 3)
    middles = 0.25 * (level[1:, 1:] + level[:-1, 1:] + level[1:, :-1] + level[:-1, :-1])
    radii = np.linalg.norm(middles, axis=-1)
    return float(np.min(radii, initial=math.inf, where=np.isfinite(radii)))


def _structured(mesh: Any, argument: str) -> pyvista.DataSet:
    if not isinstance(mesh, (vtkImageData, vtkRectilinearGrid, vtkStructuredGrid)):
        raise TypeError(f"{argument} is a {type(mesh).__name__}; it must be an ImageData, a RectilinearGrid or a StructuredGrid "
                        "with axes longitude, latitude and level.")
    return pyvista.wrap(mesh)


def _name_height(globe: vtkGlobeGrid, mesh: pyvista.DataSet, height: str | Literal[False] | None) -> None:
    if height is False:
        globe.SetHeightArrayName("")
    elif height is not None:
        require_array(mesh, height, "height")
        globe.SetHeightArrayName(height)
    elif not _is_scalar(mesh, "gh"):
        if _is_scalar(mesh, "zg"):
            globe.SetHeightArrayName("zg")
        elif _is_scalar(mesh, "z") and _units(mesh, "z") in HEIGHTS:
            globe.SetHeightArrayName("z")


def _is_scalar(mesh: pyvista.DataSet, name: str) -> bool:
    return name in mesh.array_names and mesh[name].ndim == 1


def _units(mesh: pyvista.DataSet, name: str) -> str:
    """The units that the reader recorded, in lower case, without spaces, stars, carets and dots; empty if there are none."""
    units = mesh.field_data[f"{name}_units"] if f"{name}_units" in mesh.field_data else ""
    return re.sub(r"[\s*^.]", "", str(np.ravel(units)[0]) if np.size(units) else "").lower()


def _is_omega(mesh: pyvista.DataSet, vertical: str) -> bool:
    units = _units(mesh, vertical)
    return units not in SPEED and (units in OMEGA or vertical not in UPWARD)


def _usual_winds(mesh: pyvista.DataSet) -> list[str]:
    for east, north, verticals in USUAL_WINDS:
        if _is_scalar(mesh, east) and _is_scalar(mesh, north):
            return [east, north, *[name for name in verticals if _is_scalar(mesh, name)][:1]]
    return []


def _name_winds(globe: vtkGlobeGrid, mesh: pyvista.DataSet, wind: Sequence[str] | Literal[False] | None) -> str:
    """The name of the vertical wind, empty if there is none."""
    if wind is None:
        names = _usual_winds(mesh)
    else:
        names = [] if wind is False else [wind] if isinstance(wind, str) else list(wind)
        if wind is not False and len(names) not in (2, 3):
            raise ValueError(f"wind is {wind!r}; it must name two or three arrays: eastward, northward and, optionally, vertical.")
        for name in names:
            require_array(mesh, name, "wind")
    names = [*names, *[""] * (3 - len(names))]  # an empty name: no vertical wind, and no warning
    globe.SetWindArrayNames(*names)
    return names[2]
