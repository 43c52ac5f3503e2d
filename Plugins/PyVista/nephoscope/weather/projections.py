# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Projections of regional grids, by CF grid mappings and GRIB keys.

Conformal projections and the rotated pole use the formulas of Snyder 1987 (Map Projections: A Working Manual, USGS Professional Paper 1395) and no other package; all
other projections are in `proj.py`.
"""
from __future__ import annotations

from typing import Union

import numpy as np

MODEL_RADIUS = 6371229.0  # metres, of the sphere of most models


class Conic:
    """Lambert's conformal conic projection and its limits: polar stereographic (a cone of one parallel at a pole) and Mercator (a cylinder).

    `parallels`: latitudes of true scale; `earth`: both axes in metres; `false`: easting and northing.
    """

    def __init__(self, name: str, centre: tuple[float, float], parallels: tuple[float, ...], earth: tuple[float, float] = (MODEL_RADIUS, MODEL_RADIUS),
                 scale: float = 1.0, false: tuple[float, float] = (0.0, 0.0)) -> None:
        self.name, self._meridian, self._false = name, centre[0], false
        self._a, self._e = earth[0], np.sqrt(max(0.0, 1 - (earth[1] / earth[0]) ** 2))
        first, last = np.radians(parallels[0]), np.radians(parallels[-1])
        self.n = self._cone(name, first, last)
        if self.n == 0:
            self._size, self._y0 = self._a * scale * self._m(first), 0.0
            return
        t = self._t(first)
        if abs(parallels[0]) == 90:  # the limit of m/t at the pole
            e = self._e
            factor = 2 / np.sqrt((1 + e) ** (1 + e) * (1 - e) ** (1 - e))
        else:
            factor = self._m(first) / (abs(self.n) * t ** self.n)
        self._size = self._a * scale * factor
        self._y0 = 0.0 if abs(centre[1]) == 90 else self._radius(np.radians(centre[1]))

    def _cone(self, name: str, first: float, last: float) -> float:
        if name == "mercator":
            return 0.0
        if name == "polar_stereographic":
            return 1.0 if first > 0 else -1.0
        if abs(first - last) < 1e-9:
            return float(np.sin(first))
        return float(np.log(self._m(first) / self._m(last)) / np.log(self._t(first) / self._t(last)))

    def _m(self, latitude):
        return np.cos(latitude) / np.sqrt(1 - (self._e * np.sin(latitude)) ** 2)

    def _t(self, latitude):
        s = self._e * np.sin(latitude)
        return np.tan(np.pi / 4 - np.asarray(latitude) / 2) / ((1 - s) / (1 + s)) ** (self._e / 2)

    def _radius(self, latitude):
        """Distance from the pole of the cone."""
        return self._size * self._t(latitude) ** self.n * np.sign(self.n)

    def lengths(self, axis) -> np.ndarray:
        factor = 1000.0 if str(axis.attrs.get("units", "m")).lower() in ("km", "kilometer", "kilometre", "kilometers") else 1.0
        return np.asarray(axis.values, dtype=float) * factor

    def to_degrees(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        x, y = x - self._false[0], y - self._false[1]
        if self.n == 0:
            return self._meridian + np.degrees(x / self._size), np.degrees(self._latitude(np.exp(-y / self._size)))
        sign, down = np.sign(self.n), self._y0 - y
        radius = np.hypot(x, down)
        turn = np.arctan2(sign * x, sign * down)
        with np.errstate(divide="ignore"):
            t = (radius / self._size) ** (1 / self.n)
        return self._meridian + np.degrees(turn) / self.n, np.degrees(self._latitude(t))

    def _latitude(self, t):
        latitude = np.pi / 2 - 2 * np.arctan(t)
        for _ in range(6 if self._e else 0):
            s = self._e * np.sin(latitude)
            latitude = np.pi / 2 - 2 * np.arctan(t * ((1 - s) / (1 + s)) ** (self._e / 2))
        return latitude

    def angles(self, lon: np.ndarray, lat: np.ndarray) -> np.ndarray:
        """Angles from east to the direction of growing x, counter-clockwise: the meridians of a cone are straight."""
        return np.radians(-self.n * (np.mod(lon - self._meridian + 180, 360) - 180))


class RotatedPole:
    """Longitude and latitude relative to another pole, in degrees."""

    def __init__(self, pole_longitude: float, pole_latitude: float, turned: float = 0.0) -> None:
        self.name = "rotated_latitude_longitude"
        tilt, self._turned = np.radians(90.0 - pole_latitude), turned
        about_y = np.array([[np.cos(tilt), 0, np.sin(tilt)], [0, 1, 0], [-np.sin(tilt), 0, np.cos(tilt)]])
        turn = np.radians(pole_longitude)
        about_z = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
        half = np.diag([-1.0, -1.0, 1.0])  # the meridian 0 of the grid runs from the new pole over the old one
        self._matrix = about_z @ about_y @ half

    def lengths(self, axis) -> np.ndarray:
        return np.asarray(axis.values, dtype=float)

    def to_degrees(self, x, y):
        return _angles(self._matrix @ _vectors(x - self._turned, y), np.shape(x))

    def from_degrees(self, lon, lat):
        x, y = _angles(self._matrix.T @ _vectors(lon, lat), np.shape(lon))
        return x + self._turned, y

    def angles(self, lon, lat):
        """By the frames of both poles, exactly."""
        x, y = self.from_degrees(lon, lat)
        row = self._matrix @ _eastward(x - self._turned)
        east, north = _eastward(lon), _northward(lon, lat)
        return np.arctan2((row * north).sum(0), (row * east).sum(0)).reshape(np.shape(lon))


def _vectors(lon, lat) -> np.ndarray:
    lon, lat = np.radians(np.ravel(lon)), np.radians(np.ravel(lat))
    return np.stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])


def _angles(vectors: np.ndarray, shape):
    lon, lat = np.arctan2(vectors[1], vectors[0]), np.arcsin(np.clip(vectors[2], -1, 1))
    return np.degrees(lon).reshape(shape), np.degrees(lat).reshape(shape)


def _eastward(lon) -> np.ndarray:
    lon = np.radians(np.ravel(lon))
    return np.stack([-np.sin(lon), np.cos(lon), np.zeros_like(lon)])


def _northward(lon, lat) -> np.ndarray:
    lon, lat = np.radians(np.ravel(lon)), np.radians(np.ravel(lat))
    return np.stack([-np.sin(lat) * np.cos(lon), -np.sin(lat) * np.sin(lon), np.cos(lat)])


def vectors(lon: np.ndarray, lat: np.ndarray) -> np.ndarray:
    """Unit vectors (..., 3) of positions in degrees."""
    return np.moveaxis(_vectors(lon, lat), 0, -1).reshape(*np.shape(lon), 3)


def row_angles(lon: np.ndarray, lat: np.ndarray) -> np.ndarray:
    """The direction of the rows from point to point, by central differences on the sphere, for grids without a known projection."""
    places = _vectors(lon, lat).reshape(3, *lon.shape)
    if lon.shape[1] == 1:  # a column alone: its rows are across it
        return row_angles(lon.T, lat.T).T - np.pi / 2
    along = np.gradient(places, axis=2).reshape(3, -1)
    angles = np.arctan2((along * _northward(lon, lat)).sum(0), (along * _eastward(lon)).sum(0))
    return angles.reshape(lon.shape)


Projection = Union[Conic, RotatedPole, "Proj"]  # noqa: F821 (proj.py)


def find_projection(dataset, variable) -> Projection | None:
    """The projection from the variable's grid_mapping or its GRIB keys; None if neither gives a known one."""
    name = _mapping_variable(variable)
    if name and name in dataset.variables:
        from .proj import NAMES, Proj
        keys = dict(dataset[name].attrs)
        return _of_mapping(keys) or (Proj(keys) if keys.get("grid_mapping_name") in NAMES else None)
    return _of_grib(variable.attrs)


def find_lost_projection(dataset, variable, dims) -> tuple[Projection | None, str]:
    """The projection of a variable that has lost its grid_mapping, as arithmetic of xarray does: that of other variables on `dims`, or the only one there is. Its name."""
    named = [_mapping_variable(other) for other in dataset.data_vars.values() if set(dims) <= set(other.dims)]
    known = [str(name) for name, other in dataset.variables.items() if "grid_mapping_name" in other.attrs]
    found = list(dict.fromkeys(name for name in named if name in known)) or known
    if _mapping_variable(variable) or len(found) != 1:
        return None, ""
    return find_projection(dataset, variable.assign_attrs(grid_mapping=found[0])), found[0]


def _mapping_variable(variable) -> str:
    return str(variable.attrs.get("grid_mapping", variable.encoding.get("grid_mapping", ""))).split(":")[0].strip()


def mapping_of(dataset, variable) -> str:
    """The name of the projection in the file; "" if there is none."""
    name = _mapping_variable(variable)
    return str(dataset[name].attrs.get("grid_mapping_name", name)) if name in dataset.variables else str(variable.attrs.get("GRIB_gridType", ""))


def _of_mapping(keys: dict) -> Projection | None:
    """From the CF attributes (appendix F)."""
    kind, get = keys.get("grid_mapping_name", ""), lambda key, default=0.0: float(np.ravel(keys.get(key, default))[0])
    if kind == "rotated_latitude_longitude":
        return RotatedPole(get("grid_north_pole_longitude"), get("grid_north_pole_latitude"), get("north_pole_grid_longitude"))
    false = get("false_easting"), get("false_northing")
    parallels = tuple(float(value) for value in np.ravel(keys.get("standard_parallel", ())))
    scale = get("scale_factor_at_projection_origin", 1.0)
    if kind == "lambert_conformal_conic" and parallels:
        return Conic(kind, (get("longitude_of_central_meridian"), get("latitude_of_projection_origin", parallels[0])), parallels, _axes(keys), 1.0, false)
    if kind == "mercator":
        return Conic(kind, (get("longitude_of_projection_origin"), 0.0), parallels or (0.0,), _axes(keys), scale, false)
    if kind in ("polar_stereographic", "stereographic") and abs(get("latitude_of_projection_origin")) == 90:
        pole = get("latitude_of_projection_origin")
        meridian = get("straight_vertical_longitude_from_pole", keys.get("longitude_of_projection_origin", 0.0))
        return Conic("polar_stereographic", (meridian, pole), parallels or (pole,), _axes(keys), scale, false)
    return None


def _axes(keys: dict) -> tuple[float, float]:
    """Semi-axes of the Earth, in metres."""
    if keys.get("earth_radius") is not None:
        return (float(keys["earth_radius"]),) * 2
    if keys.get("semi_major_axis") is None:
        return MODEL_RADIUS, MODEL_RADIUS
    a = float(keys["semi_major_axis"])
    flattening = float(keys.get("inverse_flattening", 0))
    return a, float(keys.get("semi_minor_axis", a * (1 - 1 / flattening) if flattening else a))


def _of_grib(keys) -> Projection | None:
    kind, get = keys.get("GRIB_gridType"), lambda key: float(keys.get("GRIB_" + key, 0))
    if kind in ("rotated_ll", "rotated_gg"):
        return RotatedPole(get("longitudeOfSouthernPoleInDegrees") + 180.0, -get("latitudeOfSouthernPoleInDegrees"), -get("angleOfRotationInDegrees"))
    oblate = get("earthIsOblate") and keys.get("GRIB_earthMajorAxisInMetres")
    earth = (get("earthMajorAxisInMetres"), get("earthMinorAxisInMetres")) if oblate else (get("radius") or MODEL_RADIUS,) * 2
    if kind in ("lambert", "lambert_lam"):
        return Conic("lambert_conformal_conic", (get("LoVInDegrees"), get("LaDInDegrees") or get("Latin1InDegrees")), (get("Latin1InDegrees"), get("Latin2InDegrees")), earth)
    if kind == "mercator":
        return Conic("mercator", (0.0, 0.0), (get("LaDInDegrees"),), earth)
    if kind == "polar_stereographic":
        south = int(get("projectionCentreFlag")) & 128 or get("southPoleOnProjectionPlane")
        pole = -90.0 if south else 90.0
        return Conic(kind, (get("orientationOfTheGridInDegrees"), pole), (get("LaDInDegrees") or pole * 60 / 90,), earth)
    return None
