# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""All other CF projections, with pyproj in a separate process: pyproj's PROJ crashes a process in which VTK has loaded another PROJ."""
from __future__ import annotations

import io
import json
import subprocess
import sys

import numpy as np

from .extras import need_elsewhere
from .projections import row_angles

NAMES = ("transverse_mercator", "lambert_azimuthal_equal_area", "oblique_mercator", "geostationary", "stereographic", "albers_conical_equal_area", "azimuthal_equidistant", "orthographic",
         "vertical_perspective", "sinusoidal", "lambert_cylindrical_equal_area", "polar_stereographic", "lambert_conformal_conic", "mercator")
_RADIANS = {"rad": 1.0, "radian": 1.0, "radians": 1.0, "microradian": 1e-6, "microradians": 1e-6}

_SCRIPT = """
import io, json, sys
import numpy as np
import pyproj
keys = json.loads(sys.stdin.buffer.readline())
x, y = np.load(io.BytesIO(sys.stdin.buffer.read()))
crs = pyproj.CRS.from_cf(keys)
lon, lat = pyproj.Transformer.from_crs(crs, crs.geodetic_crs, always_xy=True).transform(x, y)
made = io.BytesIO()
np.save(made, np.stack([lon, lat]))
sys.stdout.buffer.write(made.getvalue())  # numpy asks for the position in a file, and a pipe has none
"""


class Proj:
    """A projection by its CF attributes `keys`."""

    def __init__(self, keys: dict) -> None:
        self.name = keys["grid_mapping_name"]
        self._keys = {key: value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value for key, value in keys.items()}

    def lengths(self, axis) -> np.ndarray:
        """Metres. The scan angles of a geostationary satellite are multiplied by its height."""
        units = str(axis.attrs.get("units", "m")).lower()
        if units in _RADIANS:
            return np.asarray(axis.values, float) * _RADIANS[units] * float(np.ravel(self._keys.get("perspective_point_height", 35786023.0))[0])
        return np.asarray(axis.values, float) * (1000.0 if units in ("km", "kilometer", "kilometre", "kilometers") else 1.0)

    def to_degrees(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """NaN where the Earth is not seen."""
        need_elsewhere("pyproj", f"placing a grid of the projection {self.name}")
        points = io.BytesIO()
        np.save(points, np.stack([x, y]))
        told = subprocess.run([sys.executable, "-c", _SCRIPT], input=json.dumps(self._keys).encode() + b"\n" + points.getvalue(), capture_output=True)
        if told.returncode:
            raise ValueError(f"The projection {self.name} cannot be used: {told.stderr.decode().strip().splitlines()[-1]}. Its attributes are {self._keys}.")
        lon, lat = np.load(io.BytesIO(told.stdout))
        seen = np.isfinite(lon) & np.isfinite(lat)
        return np.where(seen, lon, np.nan), np.where(seen, lat, np.nan)

    def angles(self, lon: np.ndarray, lat: np.ndarray) -> np.ndarray:
        """From point to point."""
        return row_angles(lon, lat)
