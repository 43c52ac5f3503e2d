# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light of the sun on the Earth below lit clouds, with their shadows."""
from __future__ import annotations

import numpy as np
import pyvista

from ..light import sunlight

SHADE = "Shade"  # array of colours that multiply the texture
FINE, COARSE = 151, 2.0  # lines across the clouds in each direction; degrees between lines elsewhere


def shade(earth: pyvista.Actor, clouds: pyvista.DataSet) -> None:
    """Gives the surface of the Earth, an actor of `add_ground`, the light of the sun of the clouds, instead of the lights of the plotter."""
    old = earth.mapper.dataset
    surface = _map(old) if old.n_points == 4 else _globe(old, clouds)
    light = sunlight(surface, clouds=clouds)["Irradiance"]  # 1: a surface that faces the sun
    tint = np.asarray(earth.prop.color.float_rgb)
    surface[SHADE] = np.rint(255 * np.clip(light, 0, 1)[:, None] * tint).astype(np.uint8)
    surface.set_active_scalars(None)
    earth.mapper.dataset = surface
    earth.mapper.SetScalarModeToUsePointFieldData()
    earth.mapper.SelectColorArray(SHADE)
    earth.mapper.SetColorModeToDirectScalars()
    earth.mapper.ScalarVisibilityOn()
    earth.prop.lighting = False


def _grid(points: np.ndarray, coordinates: np.ndarray) -> pyvista.StructuredGrid:
    """Points and texture coordinates in rows."""
    rows, columns, _ = points.shape
    surface = pyvista.StructuredGrid()
    surface.points = points.reshape(-1, 3)
    surface.dimensions = (columns, rows, 1)
    surface.active_texture_coordinates = coordinates.reshape(-1, 2)
    return surface


def _map(old: pyvista.PolyData) -> pyvista.StructuredGrid:
    west, east, south, north, bottom, _ = old.bounds
    x, y = np.meshgrid(np.linspace(west, east, FINE), np.linspace(south, north, FINE))
    low, high = np.asarray(old.active_texture_coordinates)[[0, 2]]
    share = np.stack(np.meshgrid(*[np.linspace(0, 1, FINE)] * 2), axis=-1)
    return _grid(np.stack([x, y, np.full(x.shape, bottom)], axis=-1), low + share * (high - low))


def _globe(old: pyvista.StructuredGrid, clouds: pyvista.DataSet) -> pyvista.StructuredGrid:
    """With lines between those of the clouds, if these are a region."""
    radius = float(np.linalg.norm(old.points[0]))
    x, y, z = np.asarray(clouds.points, float)[np.isfinite(clouds.points).all(axis=1)].T
    middle = np.degrees(np.arctan2(y.mean(), x.mean()))
    away = (np.degrees(np.arctan2(y, x)) - middle + 180) % 360 - 180
    latitude = np.degrees(np.arctan2(z, np.hypot(x, y)))
    longitudes = _lines(-180, 180, (np.linspace(away.min(), away.max(), FINE) + middle + 180) % 360 - 180)
    latitudes = _lines(-90, 90, np.linspace(latitude.min(), latitude.max(), FINE))
    east, north = np.radians(np.meshgrid(longitudes, latitudes))
    places = np.stack([np.cos(north) * np.cos(east), np.cos(north) * np.sin(east), np.sin(north)], axis=-1)
    surface = _grid(radius * places, np.stack(np.meshgrid(longitudes / 360 + 0.5, latitudes / 180 + 0.5), axis=-1))
    for name in ("GlobeGridProjection", "PlanetRadius"):
        surface.field_data[name] = old.field_data[name]
    return surface


def _lines(first: float, last: float, fine: np.ndarray) -> np.ndarray:
    return np.unique(np.concatenate([np.arange(first, last + 0.5 * COARSE, COARSE), fine]))
