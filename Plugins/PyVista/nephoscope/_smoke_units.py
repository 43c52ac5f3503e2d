# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What smoke that is too short tells about the units of its data: coordinates in degrees or kilometres with a wind in metres per second."""
from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pyvista

from ._blocks import named_blocks
from ._pipeline import level_of_caller

SHORT = 0.15  # of the diagonal of the data: as in the warning of vtkFlowVolume about smoke that leaves them at once
MIXED = 0.1  # of the diagonal: a flow that leaves after less crosses the data along an axis that is much shorter than others
UNITS = "longitudes and latitudes in degrees are put into metres by mesh.nephoscope.globe(), kilometres by mesh.scale(1000)"


def warn_of_units(smoke: pyvista.DataSet, mesh: Any, name: str) -> None:
    """Warns if `smoke`, of the velocity `name` or the default one, is short, and if the units of `mesh` may be the reason."""
    bounds = np.array([block.bounds for _, block in named_blocks(mesh) if block.n_points]).reshape(-1, 3, 2)
    size, wind = bounds[:, :, 1].max(axis=0) - bounds[:, :, 0].min(axis=0), _mean_wind(mesh, name)
    diagonal, speed = float(np.linalg.norm(size)), float(np.linalg.norm(wind))
    if speed == 0 or not np.isfinite(diagonal) or smoke.n_cells > 0 and smoke.length > SHORT * diagonal:
        return
    crossing = min((extent / along for extent, along in zip(size, wind) if extent > 0 and along > 0), default=np.inf)
    if crossing * speed < MIXED * diagonal:
        warnings.warn(f"At its mean speed of {speed:.3g} the flow crosses the data, which extend over {' x '.join(f'{extent:.3g}' for extent in size)}, in {crossing:.3g} seconds. "
                      f"The smoke is short if the coordinates have different units, or another unit of length than the velocity: {UNITS}.", RuntimeWarning, stacklevel=level_of_caller())


def _mean_wind(mesh: Any, name: str) -> np.ndarray:
    """The mean magnitude of each component."""
    for block in (block for _, block in named_blocks(mesh)):
        for data in (block.point_data, block.cell_data):
            vectors = [one for one in data.keys() if data[one].ndim == 2 and data[one].shape[1] == 3]
            chosen = [one for one in (name, "DisplayVelocity", data.active_vectors_name if not name else None, *([] if name else vectors)) if one in vectors]
            if chosen:
                values = np.abs(np.asarray(data[chosen[0]], float))
                values = values[np.isfinite(values).all(axis=1)]
                return values.mean(axis=0) if len(values) else np.zeros(3)
    return np.zeros(3)
