# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that fill all of a flat grid, such as the temperature: as a volume they are a haze in which nothing is seen, so that a first picture shows them on the faces of the grid."""
from __future__ import annotations

import numpy as np
import pyvista

from .._blocks import outer_surface


def outer_faces(grid: pyvista.DataSet, name: str) -> tuple[pyvista.PolyData, str]:
    """The faces of the grid, with the values of its point array `name` alone. Points without a value, such as those below the ground, are left out."""
    alone = grid.copy(deep=False)
    alone.clear_data()
    alone.point_data[name] = values = np.asarray(grid.point_data[name])
    there = np.isfinite(values)
    if not there.all() and there.any():
        alone = alone.extract_points(there, adjacent_cells=False)
    faces = outer_surface(alone)
    faces.GetFieldData().ShallowCopy(grid.GetFieldData())
    return faces, "outer faces"
