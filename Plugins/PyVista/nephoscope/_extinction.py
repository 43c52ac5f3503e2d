# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Extinction coefficients drawn as they are, in 1/length of the mesh (`opacity="extinction"`)."""
from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from ._pipeline import level_of_caller

EXTINCTION = "extinction"  # the value of `opacity`
THINNEST, THICKEST = 0.003, 1e5  # greatest optical depth across the mesh without a warning, as of vtkSunlight, and mean one


def is_extinction(opacity: Any) -> bool:
    return isinstance(opacity, str) and opacity == EXTINCTION


def require_alone(**others: Any) -> None:
    """Raises ValueError if one of the arguments that an extinction replaces is given."""
    for name, value in others.items():
        if value is not None:
            raise ValueError(f"{name} is given with opacity='extinction', which draws the array as an extinction coefficient per unit of length. Omit {name}; opacity_scale multiplies the extinction.")


def greatest_extinction(values: np.ndarray, name: str, across: float, scale: float) -> float:
    """The maximum, or 1 if no value is above 0. Warns about values that are not an extinction in 1/length of a mesh that is `across` wide."""
    finite = np.asarray(values, float)[np.isfinite(values)]
    if below := int((finite < 0).sum()):
        _warn(f"The extinction {name!r} is negative in {below} of {values.size} values, which are drawn as clear air. Name the array of the extinction coefficient, >= 0.")
    densest = max(float(finite.max(initial=0)), 0.0)
    depth = densest * across * scale
    if 0 < depth < THINNEST:
        _warn(f"The medium is hardly visible: the maximum optical depth across the mesh is {depth:.1g}. The extinction {name!r} must be per unit of length of the mesh: "
              f"set opacity_scale, such as {10 * scale / depth:.1g}, if it has another unit.")
    elif across * scale * float(finite.clip(0).mean()) > THICKEST:
        thick = across * scale * float(finite.clip(0).mean())
        _warn(f"Only the outer faces are visible: the mean optical depth across the mesh is {thick:.1g}. The extinction {name!r} must be per unit of length of the mesh: "
              f"set opacity_scale, such as {10 * scale / thick:.1g}, if it is not an extinction or has another unit.")
    return densest or 1.0


def _warn(message: str) -> None:
    warnings.warn(message, UserWarning, stacklevel=level_of_caller())
