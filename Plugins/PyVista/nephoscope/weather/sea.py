# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Water below the level of the sea, and how a first picture shows it."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .._fields import preset_of_field
from .._medium import association_of
from .._outliers import is_mostly_zero, skewed_range
from .._over_time import values_over_time

DRY = 0.5  # of the depth: the most that points are above the level of the sea, such as those of tides
DEEPEST = 12000.0  # m
OPAQUE = 1e-7  # of the diagonal: the distance over which the water has an optical depth of 1


def is_below(bottom: float, top: float) -> bool:
    """Whether heights from `bottom` to `top` (m) are those of water below the level of the sea."""
    return bool(bottom < 0 and top <= -DRY * bottom)


def is_sea(grid: pyvista.DataSet) -> bool:
    """Whether the mesh, on a globe or a map, is water below the level of the sea."""
    heights = np.asarray(grid.point_data["Height"] if "Height" in grid.point_data else grid.cell_data.get("Height", []), float)
    heights = heights[np.isfinite(heights)]
    return heights.size > 0 and is_below(heights.min(), heights.max())


def is_of_water(dataset: Any, grid: pyvista.DataSet) -> bool:
    """Whether velocities of the dataset are those of currents."""
    names = [str(variable.attrs.get("standard_name", "")) for variable in dataset.variables.values()]
    return is_sea(grid) or any("sea_water" in name or name.startswith(("ocean_s_", "ocean_sigma", "ocean_double_sigma")) for name in names)


def look_of_water(grid: pyvista.DataSet, name: str, options: dict[str, Any], transparent: tuple[str, ...]) -> dict[str, Any]:
    """Options of `add_cells` that make the water opaque, so that its surface and its sides are seen, unless the field is zero almost everywhere or the options have
    one of those that are named by `transparent`."""
    if any(option in options for option in ("opacity", *transparent)):
        return options
    values = values_over_time(grid, name, association_of(grid, name, "point", "scalars"))
    if is_mostly_zero(values):
        return options
    preset = preset_of_field(name, grid)
    bulk = skewed_range(values) if not any(key in options for key in ("clim", "preset", "log_scale")) and (preset is None or preset.clim(values) is None) else None
    return {"opacity": 1.0, "opacity_unit_distance": OPAQUE * grid.length, **({} if bulk is None else {"clim": bulk}), **options}
