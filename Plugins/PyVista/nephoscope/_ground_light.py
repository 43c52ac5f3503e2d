# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light that arrives at the ground below lit clouds."""
from __future__ import annotations

import warnings

import numpy as np
import pyvista

from .light import sunlight


def irradiance(clouds: pyvista.DataSet, places: np.ndarray, sky_light: float) -> np.ndarray:
    """At positions on the ground, (..., 3): by the sun, with the shadows of the clouds, by their diffuse light and, outside them, by the sky."""
    there = np.isfinite(places).all(axis=-1)
    result = np.full(there.shape, np.nan)
    ground = pyvista.PolyData(places[there])
    ground.GetFieldData().PassData(clouds.GetFieldData())
    if ground.n_points:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", ".*The sun is below the horizon", RuntimeWarning)  # the light of the clouds has told it
            result[there] = sunlight(ground, clouds=clouds, sky_light=sky_light).point_data["Irradiance"]
    return result
