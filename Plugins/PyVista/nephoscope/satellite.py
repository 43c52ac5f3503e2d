# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Satellite images of clouds: reflectances at known longitudes and latitudes."""
from __future__ import annotations

import os
import warnings
from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkRenderingCore import vtkCamera

from . import light_image, tone
from ._ground_light import irradiance
from ._checks import as_array, require_array, require_number
from ._dates import options_of
from ._medium import one_mesh
from ._pipeline import level_of_caller
from ._refined import fitting_factor, refined, step_of
from ._typing import AnyMesh, Numbers
from ._upright import matrix_of, upright_mesh, upright_sun
from .light import lit, upwards

GEOSTATIONARY_RADII = 42164.0 / 6378.137  # distance of the satellite from the centre of the planet
FINE = 1.25  # degrees between points of a globe on which light is computed
SKY_LIGHT = 0.08  # of light that the mesh has already, as by default in `sunlight`
METRES_PER_DEGREE = 1.1e5  # for drawing a globe as a map, where only heights matter


@dataclass
class SatelliteImage:
    """The result of `satellite_image`: arrays of shape (height, width), whose first row is the northernmost.

    Attributes
    ----------
    reflectance : numpy.ndarray
        pi times the radiance over the irradiance of the sun: 1 for a white surface that faces the sun; NaN outside the planet's disc.
    sun_zenith : numpy.ndarray
        Angle between the sun and the vertical at the ground, degrees.
    longitude, latitude : numpy.ndarray or None
        Degrees east and north of the visible ground; None for data that are not on a globe.
    x, y : numpy.ndarray or None
        Coordinates of the visible ground in the mesh, for data that are not on a globe. If another axis is up, those of the mesh turned so that z is up: where y is
        up, x and -z.
    """
    reflectance: np.ndarray
    sun_zenith: np.ndarray
    longitude: np.ndarray | None = None
    latitude: np.ndarray | None = None
    x: np.ndarray | None = None
    y: np.ndarray | None = None

    def coordinates(self) -> dict[str, tuple[np.ndarray, dict[str, str]]]:
        """Name -> values and attributes that follow the CF conventions."""
        if self.longitude is None:
            return {"x_of_mesh": (self.x, {"long_name": "x in the coordinates of the mesh"}), "y_of_mesh": (self.y, {"long_name": "y in the coordinates of the mesh"})}
        return {"lon": (self.longitude, {"standard_name": "longitude", "units": "degrees_east"}),
                "lat": (self.latitude, {"standard_name": "latitude", "units": "degrees_north"})}

    def variables(self) -> dict[str, tuple[np.ndarray, dict[str, str]]]:
        places = " ".join(self.coordinates())
        return {**self.coordinates(),
                "reflectance": (self.reflectance, {"long_name": "pi times radiance over solar irradiance", "units": "1", "coordinates": places}),
                "sun_zenith": (self.sun_zenith, {"standard_name": "solar_zenith_angle", "units": "degree", "coordinates": places})}

    def normalized(self, least_cosine: float = 0.05) -> np.ndarray:
        """The reflectance over the cosine of the sun's zenith angle; NaN where the cosine is below `least_cosine`."""
        cosine = np.cos(np.radians(self.sun_zenith))
        return self.reflectance / np.where(cosine >= least_cosine, cosine, np.nan)

    def picture(self, exposure: float = 1.0, tone_mapping: str = "filmic") -> np.ndarray:
        """Grey values for a display, 0 to 255: exposure, a tone curve (`"linear"` or `"filmic"`) and sRGB."""
        return np.rint(255 * tone.toned(self.reflectance, require_number(exposure, "exposure", above=0), tone.checked(tone_mapping))).astype(np.uint8)

    def to_xarray(self) -> Any:
        """As an `xarray.Dataset`; needs xarray."""
        from .weather.extras import need
        xarray = need("xarray", "to_xarray()")
        variables = {name: (("y", "x"), values, attributes) for name, (values, attributes) in self.variables().items()}
        return xarray.Dataset({name: variables[name] for name in ("reflectance", "sun_zenith")}, {name: variables[name] for name in self.coordinates()},
                              {"Conventions": "CF-1.8"})

    def save(self, path: str | os.PathLike) -> None:
        """Writes a NetCDF file (.nc) with 32-bit floats and CF attributes. Needs netCDF4 or scipy."""
        if not os.fspath(path).endswith(".nc"):
            raise ValueError(f"path is {os.fspath(path)!r}; it must end in .nc. For images of a globe GDAL makes a GeoTIFF of the file: gdalwarp -geoloc -t_srs EPSG:4326 NETCDF:image.nc:reflectance image.tif.")
        with _netcdf(os.fspath(path)) as file:
            file.Conventions = "CF-1.8"
            for name, length in zip(("y", "x"), self.reflectance.shape):
                file.createDimension(name, length)
            for name, (values, attributes) in self.variables().items():
                variable = file.createVariable(name, "f4", ("y", "x"))
                for key, value in attributes.items():
                    setattr(variable, key, value)
                variable[:] = values.astype(np.float32)


def _netcdf(path: str) -> Any:
    """A file to write into, in the classic format with 64-bit offsets; netCDF4 and scipy have the same methods."""
    try:
        import netCDF4
        return netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET")
    except ImportError:
        try:
            from scipy.io import netcdf_file
        except ImportError:
            raise ModuleNotFoundError("Writing NetCDF needs the Python package 'netCDF4' or 'scipy': install one of them, or nephoscope[data].") from None
        return netcdf_file(path, "w", version=2)


def satellite_image(mesh: AnyMesh, view: str | Numbers = "automatic", *, sun: Any = None, size: Sequence[int] = (800, 800),
                    longitude: float | None = None, ground_albedo: float | np.ndarray = 0.1) -> SatelliteImage:
    """Image clouds as a satellite does: reflectances in floating point, without tone mapping, and their positions.

    Parameters
    ----------
    mesh : pyvista.DataSet, pyvista.MultiBlock, xarray.Dataset or xarray.DataArray
        Clouds with water, with an extinction, or already lit by `sunlight`.
    view : {"automatic", "geostationary", "nadir"} or sequence of 3 float
        ``"geostationary"``: from 42164 km above the centre of a globe, over the equator at `longitude`. ``"nadir"``: every position from straight above; a
        globe becomes a map of equal steps in longitude and latitude. Three numbers: the direction towards a distant satellite. Automatic: geostationary for
        globes, otherwise nadir. Flat ground is at the lowest point of the mesh, along the upward direction of its light.
    sun : sequence of 3 float, str, dict or True, optional
        The sun, as in `add_cells`. The light is computed for this view, unless a dict says otherwise. On a structured globe whose points are more than 1.25
        degrees apart, it is computed on a finer grid with interpolated extinctions. Default: the light in the mesh.
    size : sequence of 2 int, default: (800, 800)
        Width and height in pixels.
    longitude : float, optional
        Longitude of a geostationary satellite, degrees east. Default: that of the middle of the mesh, or 0 if the mesh surrounds the planet.
    ground_albedo : float or numpy.ndarray, default: 0.1
        Fraction of the light that the ground reflects; for a globe also an array of it, with the first row along the north pole and columns from 180 degrees west.
        `sunlight` uses its mean, if light is computed.

    Returns
    -------
    SatelliteImage
        `.reflectance`, `.longitude`, `.latitude`, `.sun_zenith`; `.save("image.nc")`, `.to_xarray()`, `.picture()`.

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    ValueError
        If an argument is out of range, or there is no light.

    Warns
    -----
    UserWarning
        If the points of a globe are too far apart to resolve the light, and a finer grid cannot be used: because the mesh is already lit, is not a structured grid, or has too many points.
    """
    mesh = one_mesh(mesh)
    if len(size) != 2 or min(size) < 1:
        raise ValueError(f"size is {size!r}; it must be width and height in pixels.")
    albedo = as_array(ground_albedo).astype(float)
    if albedo.ndim not in (0, 2) or not np.all((albedo >= 0) & (albedo <= 1)):
        raise ValueError("ground_albedo must be a number or a 2-D array of numbers from 0 to 1.")
    on_globe = light_image.planet_radius(mesh) > 0
    options = None if sun is None or sun is True and "Sunlight" in mesh.point_data else options_of(sun)
    if not on_globe:
        mesh, options, view = _upright(mesh, options, view)
    view = ("geostationary" if on_globe else "nadir") if isinstance(view, str) and view == "automatic" else view
    is_map = on_globe and isinstance(view, str) and view == "nadir"
    camera, eye = _camera_of(mesh, view, longitude)
    mesh = _lit_for(mesh, options, eye, float(albedo.mean()))
    drawn = _as_map(mesh) if is_map else mesh
    camera = camera or _camera_above(drawn, size)
    sky_light = SKY_LIGHT if options is None else options.get("sky_light", SKY_LIGHT)
    return _measured(mesh, drawn, camera, size, albedo, is_map, sky_light)


def _measured(mesh: pyvista.DataSet, drawn: pyvista.DataSet, camera: vtkCamera, size: Sequence[int], albedo: np.ndarray, is_map: bool, sky_light: float) -> SatelliteImage:
    light, hidden = light_image.light_of_clouds(drawn, camera, size)
    places = light_image.meet_ground(drawn, *light_image.rays(camera, size))
    longitude = latitude = x = y = None
    if is_map:
        longitude, latitude = places[..., 0] / METRES_PER_DEGREE, places[..., 1] / METRES_PER_DEGREE
        places = light_image.planet_radius(mesh) * _on_globe(longitude, latitude)
    elif light_image.planet_radius(mesh) > 0:
        longitude, latitude = light_image.longitudes_latitudes(places)
    else:
        x, y = places[..., 0], places[..., 1]
    cosine = light_image.zenith_cosine(mesh, places)
    arriving = irradiance(mesh, places, sky_light)
    share = albedo if albedo.ndim == 0 else _at(albedo, longitude, latitude)
    ground = np.nan_to_num(share * arriving)
    reflectance = light[..., 0] + (1 - hidden) * ground
    reflectance[np.isnan(cosine) & (hidden == 0)] = np.nan
    return SatelliteImage(reflectance, np.degrees(np.arccos(np.clip(cosine, -1, 1))), longitude, latitude, x, y)


def _on_globe(longitude: np.ndarray, latitude: np.ndarray) -> np.ndarray:
    a, b = np.radians(longitude), np.radians(latitude)
    return np.stack([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)], axis=-1)


def _at(albedo: np.ndarray, longitude: np.ndarray | None, latitude: np.ndarray | None) -> np.ndarray:
    """The albedo of the nearest pixel of a picture of the whole planet."""
    if longitude is None:
        raise ValueError("ground_albedo is an array, which needs data on a globe; give one number.")
    rows, columns = albedo.shape
    i = (np.nan_to_num(longitude) + 180) / 360 * columns
    j = (90 - np.nan_to_num(latitude)) / 180 * rows
    return albedo[np.clip(j.astype(int), 0, rows - 1), np.floor(i).astype(int) % columns]


def _upright(mesh: pyvista.DataSet, options: dict[str, Any] | None, view: Any) -> tuple[pyvista.DataSet, dict[str, Any] | None, Any]:
    """All turned so that z is up."""
    recorded = mesh.field_data["Up"][0] if "Up" in mesh.field_data else "z"
    up = upwards(recorded if options is None else options.get("up", "z"), lambda name: f"sun[{name!r}]")
    if up[2] >= 1:
        return mesh, options, view
    matrix = matrix_of(up)
    view = view if isinstance(view, str) or np.shape(view) != (3,) else np.asarray(view, float) @ matrix
    return upright_mesh(mesh, matrix), options if options is None else upright_sun(options, matrix), view


def _lit_for(mesh: pyvista.DataSet, options: dict[str, Any] | None, eye: dict[str, Any], ground_albedo: float) -> pyvista.DataSet:
    if options is None:
        if not {"Sunlight", "ScaledExtinction", "Irradiance", "SunTransmittance"} <= set(mesh.point_data):
            raise ValueError("mesh has no light: give sun, for example a date and time, or use mesh.nephoscope.sunlight() first.")
        if light_image.planet_radius(mesh) > 0:
            _warn_of_steps(mesh)
        return mesh
    return lit(mesh, {"ground_albedo": ground_albedo, **eye, **options}, resolve=_resolved)


def _resolved(mesh: pyvista.DataSet, names: list[str]) -> pyvista.DataSet:
    """A coarse globe with more columns, as far as it can have them."""
    if light_image.planet_radius(mesh) == 0:
        return mesh
    if isinstance(mesh, pyvista.StructuredGrid) and names[0] in mesh.point_data:
        weights = {name: names[0] if name != names[0] else None for name in names if name in mesh.point_data}
        mesh = refined(mesh, fitting_factor(mesh, FINE), weights)
    _warn_of_steps(mesh)
    return mesh


def _warn_of_steps(mesh: pyvista.DataSet) -> None:
    step = step_of(mesh) if isinstance(mesh, pyvista.StructuredGrid) else np.degrees(np.arccos(1 - light_image.sag(mesh))) * 2**0.5
    if step > 1.3 * FINE:
        warnings.warn(f"The light was computed at points {step:.2g} degrees apart. Where clouds are patchy, reflectances may be a tenth too low: use points at most {FINE:g} degrees apart.",
                      UserWarning, stacklevel=level_of_caller())


def _camera_of(mesh: pyvista.DataSet, view: Any, longitude: float | None) -> tuple[vtkCamera | None, dict[str, Any]]:
    """The camera, and the eye for `sunlight`: for the nadir view of a globe that of any camera, because each position has its own direction."""
    radius = light_image.planet_radius(mesh)
    if isinstance(view, str) and view == "geostationary":
        if radius == 0:
            raise ValueError("view is 'geostationary', which needs data on a globe (to_globe); use view='nadir'.")
        angle = np.radians(_middle_longitude(mesh) if longitude is None else require_number(longitude, "longitude", least=-360, most=360))
        place = GEOSTATIONARY_RADII * radius * np.array([np.cos(angle), np.sin(angle), 0])
        highest = np.linalg.norm(mesh.points, axis=1).max()
        return _camera(place, -place, (0, 0, 1), angle=2 * np.degrees(np.arcsin(max(highest, radius) / np.linalg.norm(place)))), {"eye": tuple(place)}
    if isinstance(view, str) and view == "nadir":
        return None, {"eye": "camera"} if radius > 0 else {"eye": (0, 0, 1), "parallel": True}
    if isinstance(view, str) or np.shape(view) != (3,) or not np.linalg.norm(view) > 0:
        raise ValueError(f"view is {view!r}; it must be 'automatic', 'geostationary', 'nadir' or a direction of three numbers.")
    towards = np.asarray(view, float) / np.linalg.norm(view)
    middle = np.zeros(3) if radius > 0 else np.array(mesh.center)
    camera = _camera(middle + 2 * mesh.length * towards, -towards, (0, 1, 0) if abs(towards[2]) > 0.99 else (0, 0, 1))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * mesh.length if radius == 0 else np.linalg.norm(mesh.points, axis=1).max())
    return camera, {"eye": tuple(towards), "parallel": True}


def _camera(place: Any, direction: Any, up: Any, angle: float = 30.0) -> vtkCamera:
    camera = vtkCamera()
    camera.SetPosition(*place)
    camera.SetFocalPoint(*(np.asarray(place) + np.asarray(direction)))
    camera.SetViewUp(*up)
    camera.SetViewAngle(angle)
    return camera


def _camera_above(mesh: pyvista.DataSet, size: Sequence[int]) -> vtkCamera:
    """A camera straight above flat data, which sees all of them."""
    x0, x1, y0, y1, _, z1 = mesh.bounds
    camera = _camera((0.5 * (x0 + x1), 0.5 * (y0 + y1), z1 + max(mesh.length, 1e-30)), (0, 0, -1), (0, 1, 0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5 * max(y1 - y0, (x1 - x0) * size[1] / size[0]))
    return camera


def _middle_longitude(mesh: pyvista.DataSet) -> float:
    middle = mesh.points[np.linalg.norm(mesh.points, axis=1) > 0].mean(axis=0)
    return float(np.degrees(np.arctan2(middle[1], middle[0]))) if np.hypot(*middle[:2]) > 0.05 * np.abs(mesh.points).max() else 0.0


def _as_map(mesh: pyvista.DataSet) -> pyvista.DataSet:
    """A structured globe with longitude, latitude and height as coordinates. Verticals are parallel and keep their length."""
    if light_image.planet_radius(mesh) == 0:
        return mesh
    if not isinstance(mesh, vtkStructuredGrid):
        raise ValueError(f"view is 'nadir', which needs a structured grid on the globe, not a {type(mesh).__name__}; use view='geostationary'.")
    places = mesh.points.astype(float)
    radii = np.linalg.norm(places, axis=1)
    longitude, latitude = light_image.longitudes_latitudes(places)
    columns, rows, levels = mesh.dimensions
    longitude = longitude.reshape(levels, rows, columns)[:, rows // 2]
    longitude = np.degrees(np.unwrap(np.radians(longitude), axis=1))[:, None].repeat(rows, axis=1).ravel()
    flat = pyvista.StructuredGrid()
    flat.dimensions = mesh.dimensions
    flat.points = np.column_stack([METRES_PER_DEGREE * longitude, METRES_PER_DEGREE * latitude, radii - light_image.planet_radius(mesh)])
    for name in ("Sunlight", "ScaledExtinction"):
        require_array(mesh, name, "mesh")
    flat.point_data["Sunlight"] = light_image.light_upwards(mesh)
    flat.point_data["ScaledExtinction"] = mesh.point_data["ScaledExtinction"]
    return flat
