# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Earth below a first picture: NASA's Blue Marble on a globe or a map, and its coasts as lines over a field that hides it."""
from __future__ import annotations

import functools

import numpy as np
import pyvista

from ..samples import sample_data

PLAIN = "#3d5a73"   # the ground, where the picture is not installed
DIMMED = "#c0c0c0"  # multiplies the picture, so that clouds are brighter than ice
COASTS = (1024, 512)  # pixels from which coasts are drawn


@functools.cache
def blue_marble() -> str:
    """The path of the picture, "" if it is not installed."""
    try:
        return sample_data("blue_marble_2048.jpg")
    except FileNotFoundError:
        return ""


def add_ground(plotter: pyvista.BasePlotter, surface: pyvista.DataSet, render: bool = True) -> pyvista.Actor:
    path = blue_marble()
    options = {"texture": pyvista.read_texture(path), "color": DIMMED} if path else {"color": PLAIN}
    return plotter.add_mesh(surface, lighting=True, render=render, **options)


def map_ground(edges: tuple[float, float, float, float], radius: float, height: float) -> pyvista.PolyData:
    """A rectangle from west to east and from south to north, in degrees, with the texture coordinates of `globe_surface`."""
    west, east, south, north = edges
    corners = np.array([(west, south), (east, south), (east, north), (west, north)])
    ground = pyvista.PolyData(np.column_stack([np.radians(corners) * radius, np.full(4, height)]), faces=[4, 0, 1, 2, 3])
    ground.active_texture_coordinates = corners / (360, 180) + 0.5
    return ground


@functools.cache
def coasts() -> np.ndarray:
    """Segments of coast, shape (n, 2, 2): longitudes and latitudes of their ends, from -180 to 180 and from -90 to 90."""
    path = blue_marble()
    if not path:
        return np.zeros((0, 2, 2))
    picture = pyvista.read(path)
    red, green, blue = np.moveaxis(np.asarray(picture.active_scalars, float).reshape(picture.dimensions[1], picture.dimensions[0], -1)[..., :3], -1, 0)
    sea = np.clip((blue - np.maximum(red, 0.9 * green) - 4) / 10 + 0.5, 0, 1) * (red < 90)  # water is blue and dark; ice is bright
    columns, rows = COASTS
    sea = sea.reshape(rows, sea.shape[0] // rows, columns, sea.shape[1] // columns).mean(axis=(1, 3))
    image = pyvista.ImageData(dimensions=(columns, rows, 1), spacing=(360 / columns, 180 / rows, 1), origin=(-180 + 180 / columns, -90 + 90 / rows, 0))
    image["sea"] = sea.ravel()
    lines = image.contour([0.5], scalars="sea")
    return np.asarray(lines.points)[:, :2][lines.lines.reshape(-1, 3)[:, 1:]]


def _lines(points: np.ndarray) -> pyvista.PolyData:
    """A line for each pair of points of an array of shape (n, 2, 3)."""
    ends = np.arange(2 * len(points)).reshape(-1, 2)
    return pyvista.PolyData(points.reshape(-1, 3), lines=np.column_stack([np.full(len(ends), 2), ends]).ravel())


def globe_coasts(radius: float) -> pyvista.PolyData:
    longitude, latitude = np.moveaxis(np.radians(coasts()), -1, 0)
    return _lines(radius * np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], axis=-1))


def map_coasts(edges: tuple[float, float, float, float], radius: float, height: float) -> pyvista.PolyData:
    west, east, south, north = edges
    turns = np.concatenate([coasts() + (360.0 * turn, 0) for turn in range(-2, 3)])
    inside = ((turns >= (west, south)) & (turns <= (east, north))).all(axis=(1, 2))
    points = np.radians(turns[inside]) * radius
    return _lines(np.concatenate([points, np.full((*points.shape[:2], 1), height)], axis=-1))


def add_coasts(plotter: pyvista.Plotter, lines: pyvista.PolyData) -> None:
    if lines.n_cells:
        plotter.add_mesh(lines, color="black", line_width=2, lighting=False, name="coasts", reset_camera=False)
