# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colour maps and opacity names of PyVista as VTK transfer functions in floating point.

PyVista itself uses a table of 8-bit entries, which loses opacities below 1/255 and has 256 control points where two are enough. A mapper that
integrates exactly between control points is faster with fewer control points.
"""
from __future__ import annotations

import re
from typing import Union

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from ._checks import as_array, listed
from ._typing import Numbers

SAMPLES = 256            # of a curve that is not defined by points
COLOUR_TOLERANCE = 1 / 255   # colour maps are 8-bit tables
OPACITY_TOLERANCE = 5e-4     # of the largest opacity
STEP = 1e-4                  # of the range: width of the step to colours beyond it

_SIGMOIDS = ("sigmoid", *(f"sigmoid_{i}" for i in (*range(1, 11), 15, 20)))
OPACITY_NAMES = (*(name + end for name in ("linear", "geom", *_SIGMOIDS) for end in ("", "_r")), "foreground")

OpacityLike = Union[str, float, Numbers]


def opacity_values(opacity: OpacityLike, n_colors: int = SAMPLES) -> np.ndarray:
    """Opacities at equal steps of the scalar (of its logarithm, on a logarithmic scale).

    Parameters
    ----------
    opacity : str, float or sequence of float
        A name that `pyvista.opacity_transfer_function` knows, one value for all scalars, or values at equal steps over the scalar range. 0 to 1;
        an array of type uint8 is divided by 255.
    n_colors : int, default: 256
        Number of steps of ``'foreground'``: its first step is transparent.

    Returns
    -------
    numpy.ndarray
        Float values, shape (n,), n >= 2.

    Raises
    ------
    TypeError
        If it is something else, such as a function.
    ValueError
        If the name is unknown or a value is not in 0 to 1.
    """
    if isinstance(opacity, str):
        return _named_opacity(opacity, n_colors)
    values = np.atleast_1d(as_array(opacity))
    if values.dtype.kind not in "buif":
        raise TypeError(f"opacity is a {type(opacity).__name__}; it must be a name, a number or a list of numbers from 0 to 1 at equal steps over the range. "
                        "Pass a function's values, such as f(np.linspace(0, 1, 256)).")
    values = values / 255.0 if values.dtype == np.uint8 else values.astype(float)
    if values.ndim != 1 or values.size == 0:
        raise ValueError(f"opacity has shape {values.shape}; it must be one value or a list of values.")
    if not np.all((values >= 0) & (values <= 1)):
        raise ValueError("opacity has a value outside 0 to 1. Divide values from 0 to 255 by 255. For a denser medium lower opacity_unit_distance or "
                         "raise opacity_scale.")
    return np.repeat(values, 2) if values.size == 1 else values


def _named_opacity(name: str, n_colors: int) -> np.ndarray:
    if name not in OPACITY_NAMES:
        raise ValueError(f"opacity {name!r} is unknown. There are: {listed((*OPACITY_NAMES, 'extinction'))}.")
    if name == "foreground":
        return np.r_[0.0, np.ones(max(n_colors, 2) - 1)]
    base = name[:-2] if name.endswith("_r") else name
    if base == "linear":
        values = np.array([0.0, 1.0])
    elif base == "geom":
        values = np.geomspace(1e-6 / 255, 1.0, SAMPLES)
    else:
        steepness = float(re.sub(r"\D", "", base) or 10)
        values = 1 / (1 + np.exp(-np.linspace(-steepness, steepness, SAMPLES)))
    return values[::-1] if name.endswith("_r") else values


def scalars_at(fractions: np.ndarray, clim: tuple[float, float], log_scale: bool) -> np.ndarray:
    """Scalars at fractions (0 to 1) of the range `clim`, or of its logarithm."""
    if log_scale:
        return clim[0] * (clim[1] / clim[0]) ** fractions
    return clim[0] + fractions * (clim[1] - clim[0])


def control_points(values: np.ndarray, clim: tuple[float, float], log_scale: bool,
                   tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """The fewest-by-bisection points whose polyline stays within `tolerance` of `values` at equal steps over `clim`.

    Parameters
    ----------
    values : numpy.ndarray
        Shape (n,) or (n, components), n >= 2.
    clim : tuple of float
        Scalar at the first and last value.
    log_scale : bool
        The steps are equal in the logarithm of the scalar.
    tolerance : float
        Largest difference in any component.

    Returns
    -------
    tuple of numpy.ndarray
        Scalars, shape (m,), and values, shape (m, components), 2 <= m.
    """
    values = values.reshape(len(values), -1)
    fractions = np.linspace(0, 1, len(values))
    if log_scale and len(values) < SAMPLES:  # a straight line in the logarithm is not straight in the scalar
        finer = np.unique(np.r_[fractions, np.linspace(0, 1, SAMPLES)])
        values = np.stack([np.interp(finer, fractions, column) for column in values.T], axis=1)
        fractions = finer
    scalars = scalars_at(fractions, clim, log_scale)
    keep = _polyline(scalars, values, tolerance)
    return scalars[keep], values[keep]


def _polyline(x: np.ndarray, y: np.ndarray, tolerance: float) -> np.ndarray:
    """Indices of the points of a polyline (Douglas and Peucker 1973, with the vertical distance)."""
    keep, spans = {0, len(x) - 1}, [(0, len(x) - 1)]
    while spans:
        first, last = spans.pop()
        if not x[last] > x[first]:
            continue  # no number lies in between
        t = (x[first:last + 1] - x[first]) / (x[last] - x[first])
        line = y[first] + t[:, None] * (y[last] - y[first])
        errors = np.abs(y[first:last + 1] - line).max(axis=1)
        worst = int(errors.argmax())
        if errors[worst] > tolerance:
            keep.add(first + worst)
            spans += [(first, first + worst), (first + worst, last)]
    return np.array(sorted(keep))


def beyond(table: pyvista.LookupTable) -> list[tuple[float, pyvista.Color]]:
    """Scalars close to the ends of the range of `table`, and the colours that it has from there on, if it has any: ``below_range_color``, ``above_range_color``."""
    low, high = table.scalar_range
    rounding = float(np.finfo(np.float32).eps) * max(abs(low), abs(high))  # the GPU's numbers
    steps = (STEP * low, STEP * high) if table.log_scale else (max(STEP * (high - low), rounding),) * 2
    ends = ((low - steps[0], getattr(table, "below_range_color", None)), (high + steps[1], getattr(table, "above_range_color", None)))
    return [(scalar, colour) for scalar, colour in ends if colour is not None]


def colour_function(table: pyvista.LookupTable) -> vtkColorTransferFunction:
    """The colours of `table` over its scalar range and beyond, straight lines between the table's entries."""
    colours = np.asarray(table.values)[:, :3] / 255.0
    if len(colours) == 1:
        colours = np.repeat(colours, 2, axis=0)
    function = vtkColorTransferFunction()
    points = control_points(colours, table.scalar_range, table.log_scale, COLOUR_TOLERANCE)
    for scalar, colour in zip(*points):
        function.AddRGBPoint(scalar, *colour)
    for scalar, colour in beyond(table):
        function.AddRGBPoint(scalar, *colour.float_rgb)
    return function


def opacity_function(opacities: np.ndarray, clim: tuple[float, float], log_scale: bool) -> vtkPiecewiseFunction:
    """`opacities` (see `opacity_values`) over the scalar range `clim`."""
    function = vtkPiecewiseFunction()
    points = control_points(opacities, clim, log_scale, OPACITY_TOLERANCE * opacities.max())
    for scalar, (opacity,) in zip(*points):
        function.AddPoint(scalar, opacity)
    return function
