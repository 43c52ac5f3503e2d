# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the camera of a first picture is: above the data, above the field, or above the position that the user wants."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from ._checks import require_number
from ._fields import preset_of_field
from ._over_time import step_with_greatest
from .globe import EARTH_RADIUS, is_map

AMERICA = np.array([0.3, -1.0, 0.35])  # of fields all round the globe
WIDE, HIGH = 0.8, 0.92  # of the picture, for a region beside the scalar bar
ABOVE_BAR = (0.85, 0.7)  # the same, above PyVista's scalar bar
ASIDE = (40.0, 20.0)  # degrees of the camera above the horizon, at least, and from the south to the east, for water
NEAREST = 0.001  # of the distance of the farthest, VTK's default for the nearest that is seen
BESIDE_SUN = 40.0  # degrees of the camera east of the sun, so that the line between day and night is seen
CONCENTRATED = 0.75  # length of the mean direction of a field on one side of the globe; that of one that increases evenly from pole to pole is 2/3


def _direction_to(view: Any) -> np.ndarray:
    """The unit vector towards a longitude and latitude."""
    longitude = np.radians(require_number(view[0], "view[0], a longitude,", least=-360, most=360))
    latitude = np.radians(require_number(view[1], "view[1], a latitude,", least=-90, most=90))
    return np.array([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])


def _side_of(grid: pyvista.DataSet, name: str) -> np.ndarray | None:
    """The mean direction of what the field has above its median, on a globe; None if these values are all around it."""
    on_points = name in grid.point_data
    values = np.asarray((grid.point_data if on_points else grid.cell_data)[name], float)
    if not np.nanmax(values, initial=-np.inf) > np.nanmin(values, initial=np.inf) and (fullest := step_with_greatest(grid, name)) is not grid:
        return _side_of(fullest, name)  # rain that begins later
    places = np.asarray(grid.points if on_points else grid.cell_centers().points, float)
    lengths = np.linalg.norm(places, axis=1)
    preset = preset_of_field(name, grid)
    values = np.abs(values) if preset is not None and preset.range_rule == "symmetric" else values
    good = np.isfinite(values) & np.isfinite(lengths) & (lengths > 0)
    if values.ndim != 1 or not good.any():
        return None
    places, values = places[good] / lengths[good, None], values[good]
    weights = np.clip(values - np.median(values), 0, None)
    if isinstance(grid, pyvista.StructuredGrid):
        weights *= np.hypot(places[:, 0], places[:, 1])  # columns are crowded at the poles
    mean = (weights @ places) / (weights.sum() or 1.0)
    return mean if np.linalg.norm(mean) > CONCENTRATED else None


def middle_of(grid: pyvista.DataSet, points: np.ndarray, name: str | None) -> np.ndarray | None:
    """The middle of the data or, if they are all around the globe, of the field; None if the field is, too. `points`: those that count."""
    middle = points.mean(axis=0)
    if np.linalg.norm(middle) >= 0.2 * EARTH_RADIUS:
        return middle
    side = _side_of(grid, name) if name is not None else None
    return None if side is None else side / np.linalg.norm(side) * EARTH_RADIUS


def _beside(sun: np.ndarray) -> np.ndarray:
    """A direction east of the sun, at its latitude."""
    sine, cosine = np.sin(np.radians(BESIDE_SUN)), np.cos(np.radians(BESIDE_SUN))
    return np.array([cosine * sun[0] - sine * sun[1], sine * sun[0] + cosine * sun[1], sun[2]])


def _some(points: np.ndarray) -> np.ndarray:
    """About 5000 of the points, at random: those of a mesh repeat at regular distances."""
    return points if len(points) <= 5000 else points[np.random.default_rng(0).choice(len(points), 5000, replace=False)]


def _fitted(across: np.ndarray, towards: np.ndarray, share: float) -> tuple[float, float]:
    """Where the camera is along an axis of the picture, and its distance, so that no point is seen farther from the middle than `share` of the distance to it."""
    low, high = (float((side * across + share * towards).max()) for side in (-1, 1))
    return 0.5 * (high - low), 0.5 * (high + low) / share


def _from_aside(vertical: np.ndarray, north: np.ndarray, points: np.ndarray) -> np.ndarray:
    """The direction, from the middle of the points, of a camera in the south and above, a little to the east; higher above a wide region, which is bent."""
    widest = np.degrees(np.arccos(np.clip(points @ vertical / np.linalg.norm(points, axis=1), -1, 1).min()))
    east = np.cross(north, vertical) / np.linalg.norm(np.cross(north, vertical))
    height, turn = np.radians((ASIDE[0] + 0.5 * widest, ASIDE[1]))
    return np.sin(height) * vertical + np.cos(height) * (np.sin(turn) * east - np.cos(turn) * np.cross(vertical, east))


def look_at_region(plotter: pyvista.BasePlotter, grid: pyvista.DataSet) -> None:
    """Places the camera straight above the data of a region of a globe, with north up and room for a scalar bar below; for data all around the globe, on a map or elsewhere the camera is not changed.
    PyVista looks at everything from the direction (1, 1, 1), which is from inside the Earth in most regions."""
    if "GlobeGridProjection" not in grid.field_data or is_map(grid):
        return
    points = np.asarray(grid.points)
    points = _some(points[np.isfinite(points).all(axis=1)])
    if len(points) and _is_part(points, middle := points.mean(axis=0)):
        _look_at_part(plotter, points, middle, False, *ABOVE_BAR)
        plotter.renderer.camera.is_set = True


def _is_part(points: np.ndarray, middle: np.ndarray) -> bool:
    """Whether the points, with this mean, are a region of a globe."""
    return bool(np.linalg.norm(middle) > 0.6 * EARTH_RADIUS and np.ptp(points, axis=0).max() < 1.2 * EARTH_RADIUS)


def _look_at_part(plotter: pyvista.BasePlotter, points: np.ndarray, middle: np.ndarray, aside: bool, wide: float = WIDE, high: float = HIGH) -> None:
    """Places the camera above the middle of the data of a region, or at their side, so that they fill these fractions of the picture."""
    towards = middle / np.linalg.norm(middle)
    north = np.array((0, 0, 1) if abs(towards[2]) < 0.95 else (1, 0, 0), float)
    towards, north = (_from_aside(towards, north, points), towards) if aside else (towards, north)
    east = np.cross(north, towards) / np.linalg.norm(np.cross(north, towards))
    upward = np.cross(towards, east)
    half = np.tan(np.radians(0.5 * plotter.camera.view_angle))
    sideways, distance = _fitted((points - middle) @ east, (points - middle) @ towards, wide * half)
    upwards, other = _fitted((points - middle) @ upward, (points - middle) @ towards, high * half)
    plotter.camera.focal_point = middle + sideways * east + upwards * upward
    plotter.camera.position = plotter.camera.focal_point + max(distance, other) * towards
    plotter.camera.up = north
    _see_near(plotter, max(distance, other))


def _see_near(plotter: pyvista.BasePlotter, distance: float) -> None:
    """Lets the camera see what is at this distance before a globe: VTK cuts what is nearer than a thousandth of the farthest, which is 25 km."""
    share = 0.1 * distance / (distance + 2 * EARTH_RADIUS)
    if share < NEAREST:
        plotter.renderer.SetNearClippingPlaneTolerance(share)
    plotter.reset_camera_clipping_range()


def look_down(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, points: np.ndarray, name: str | None, view: Any, aside: bool = False, sun: np.ndarray | None = None) -> None:
    """Places the camera above a position, by default the middle of the data or of the field, far enough to show all of them, with north up. `aside`: data of a region are seen
    from the side instead. `sun`: the direction towards it; fields all around the globe are seen from its side."""
    middle = middle_of(grid, points, name)
    middle = (AMERICA if sun is None else _beside(sun)) * EARTH_RADIUS if middle is None else middle
    points = _some(points)
    part = _is_part(points, middle)
    centre = middle if part else np.zeros(3)
    if part and view is None:
        _look_at_part(plotter, points, middle, aside)
        plotter.camera.SetWindowCenter(0.13, 0)  # room for the scalar bar
        return
    size = np.linalg.norm(points - centre, axis=1).max()
    upward = middle / np.linalg.norm(middle)
    if view is not None:
        upward = _direction_to(view)
        centre = np.linalg.norm(middle) * upward if part else centre
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + upward * size * 4.6
    plotter.camera.up = (0, 0, 1) if abs(upward[2]) < 0.95 else (1, 0, 0)
    plotter.camera.SetWindowCenter(0.08, 0)  # room for the scalar bar
    _see_near(plotter, size)
