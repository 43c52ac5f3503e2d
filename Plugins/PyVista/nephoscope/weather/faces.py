# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that fill all of a flat grid, such as the temperature: as a volume they are a haze in which nothing is seen, so that a first picture shows them on the faces of the grid."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .._blocks import cell_dimension, outer_surface
from .lowest import is_filling

FACES = "OuterFaces"  # field array of such faces


def fills_the_box(grid: pyvista.DataSet, name: str, options: dict[str, Any], of_volumes: tuple[str, ...] = ()) -> bool:
    """Whether a picture of the array `name` is better one of the faces of the grid, unless one of the `options` is `of_volumes` or the opacity."""
    return cell_dimension(grid) == 3 and is_filling(grid, name, options, of_volumes)


def outer_faces(grid: pyvista.DataSet, name: str) -> pyvista.PolyData:
    """The faces of the grid, with the values of its point array `name` alone. Points without a value, such as those below the ground, are left out."""
    alone = grid.copy(deep=False)
    alone.clear_data()
    alone.point_data[name] = values = np.asarray(grid.point_data[name])
    there = np.isfinite(values)
    if not there.all() and there.any():
        alone = alone.extract_points(there, adjacent_cells=False)
    faces = outer_surface(alone)
    faces.GetFieldData().ShallowCopy(grid.GetFieldData())
    faces.field_data[FACES] = [1]
    return faces
