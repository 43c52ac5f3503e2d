# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts light to display values: exposure, a tone curve and the sRGB encoding. It needs only numpy."""
from __future__ import annotations

import numpy as np

TONE_MAPPINGS = ("contrast", "linear", "filmic")
CONTRAST = 2.0  # exponent; sunlit sides of clouds are only about twice as bright as their shadows


def filmic(light: np.ndarray) -> np.ndarray:
    """The curve of Narkowicz (2016), a fit to the ACES curve: dark values stay dark, and bright values approach 1 slowly."""
    light = np.maximum(light, 0)
    return np.clip(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0, 1)


def contrast(light: np.ndarray) -> np.ndarray:
    """The square of the light, so that differences are larger than in nature, as in photographic prints."""
    return np.clip(light, 0, 1) ** CONTRAST


def encoded(linear: np.ndarray) -> np.ndarray:
    """sRGB (IEC 61966-2-1) of linear light from 0 to 1."""
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.power(linear, 1 / 2.4) - 0.055)


def decoded(srgb: np.ndarray) -> np.ndarray:
    """Linear light of sRGB from 0 to 1."""
    srgb = np.asarray(srgb, float)
    return np.where(srgb <= 0.04045, srgb / 12.92, np.power((srgb + 0.055) / 1.055, 2.4))


def toned(light: np.ndarray, exposure: float = 1.0, tone_mapping: str = "linear") -> np.ndarray:
    """Display values of light, 0 to 1. `exposure` multiplies the light."""
    light = exposure * np.nan_to_num(np.asarray(light, float))
    return encoded({"contrast": contrast, "filmic": filmic}.get(tone_mapping, np.asarray)(light))


def checked(tone_mapping: str) -> str:
    """`tone_mapping`, or ValueError with the choices."""
    if tone_mapping not in TONE_MAPPINGS:
        raise ValueError(f"tone_mapping is {tone_mapping!r}; it must be one of 'contrast', 'linear', 'filmic'.")
    return tone_mapping
