# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Axes with round values next to a section or a map."""
from __future__ import annotations

from typing import Sequence

import numpy as np
import pyvista

from .._medium import text_colour

EAST, NORTH = "degrees east", "degrees north"  # titles of the axes of a map


def add_scales(plotter: pyvista.BasePlotter, bounds: Sequence[float], flat: str, scales: dict[str, tuple[str, float]]) -> None:
    """Axes with round values, below and on the left. `bounds`: of what is drawn in the scene. `scales`: the title of each axis, and the length of its unit in the scene."""
    bounds = np.reshape(bounds, (3, 2))
    spans = np.ptp(bounds, axis=1)
    plot = plotter.renderers.active_index  # PyVista removes labels of one name from all sub-plots
    letters = [letter for letter in "xyz" if letter != flat]
    for letter, other, where in ((*letters, ("center", "top")), (*letters[::-1], ("right", "center"))):
        i, j, gap = "xyz".index(letter), "xyz".index(other), 0.015 * spans.max()
        axis_title, size = scales[letter]
        values = ticks(*bounds[i] / size, axis_title in (EAST, NORTH))
        feet = np.repeat(bounds[None, :, 0], len(values) + 1, axis=0)
        feet[:-1, i], feet[-1, i] = values * size, bounds[i, 1] if letter == letters[1] else bounds[i].mean()
        ends = feet.copy()
        ends[:, j] -= gap
        lines = [*zip(feet[:-1], ends[:-1]), (bounds[:, 0], [bounds[k, 1 if k == i else 0] for k in range(3)])]
        plotter.add_mesh(pyvista.line_segments_from_points(np.reshape(lines, (-1, 3))), color=text_colour(plotter), lighting=False, name=f"scale_{letter}", reset_camera=False)
        ends[-1] += (0.05 * spans.max()) * np.eye(3)[i] if letter == letters[1] else (-4 * gap) * np.eye(3)[j]
        plotter.add_point_labels(ends, _texts(values, axis_title), show_points=False, shape=None, font_size=13, always_visible=True, margin=0,
                                 text_color=text_colour(plotter), bold=False, justification_horizontal=where[0], justification_vertical=where[1], name=f"labels_{letter}_{plot}" if plot else f"labels_{letter}", reset_camera=False)


def _texts(values: np.ndarray, axis_title: str) -> list[str]:
    """Those of the values, and the title. On a map each value has its sign, such as 20°W, instead of the title."""
    if axis_title == EAST:
        return [*map(meridian, values), " "]
    if axis_title == NORTH:
        return [*map(parallel, values), " "]
    return [*(f"{value - 360 if axis_title == '°E' and value > 360 else value:g}" for value in values), axis_title]


def meridian(longitude: float, digits: str = "g") -> str:
    east = (longitude + 180) % 360 - 180
    return f"{abs(east):{digits}}°" + ("" if abs(east) in (0, 180) else "E" if east > 0 else "W")


def parallel(latitude: float, digits: str = "g") -> str:
    return f"{abs(latitude):{digits}}°" + ("" if latitude == 0 else "N" if latitude > 0 else "S")


def ticks(low: float, high: float, degrees: bool = False) -> np.ndarray:
    """Three to seven round values between the limits, which may be `degrees` of a map."""
    power = 10.0 ** np.floor(np.log10((high - low) / 3)) if high > low else 1.0
    steps = (15.0, 30.0, 60.0, 90.0) if degrees and high - low >= 45 else (power, 2 * power, 5 * power)
    step = max((step for step in steps if step * 3 <= high - low), default=power)
    return step * np.arange(np.ceil(low / step - 1e-6), np.floor(high / step + 1e-6) + 1) + 0.0  # no -0
