# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Humidity of the air: saturation, relative and specific."""
from __future__ import annotations

import numpy as np

from .columns import VAPOUR_RATIO


def saturation_pressure(temperature: np.ndarray) -> np.ndarray:
    """Saturation pressure of water vapour over water, in Pa (Bolton 1980, equation 10)."""
    celsius = temperature - 273.15
    return 611.2 * np.exp(17.67 * celsius / (celsius + 243.5))


def specific_from_relative(relative: np.ndarray, temperature: np.ndarray, pressure: np.ndarray) -> np.ndarray:
    vapour = np.minimum(relative * saturation_pressure(temperature), 0.5 * pressure)
    ratio = VAPOUR_RATIO * vapour / (pressure - vapour)
    return ratio / (1 + ratio)


def vapour_pressure(specific: np.ndarray, pressure: np.ndarray) -> np.ndarray:
    """Partial pressure of water vapour, in the unit of `pressure`."""
    ratio = specific / (1 - specific)
    return pressure * ratio / (VAPOUR_RATIO + ratio)


def relative_from_specific(specific: np.ndarray, temperature: np.ndarray, pressure: np.ndarray) -> np.ndarray:
    return vapour_pressure(specific, pressure) / saturation_pressure(temperature)
