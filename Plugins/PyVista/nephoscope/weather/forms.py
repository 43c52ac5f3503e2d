# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a first picture shows instead of a volume or a section in which nothing would be visible: the lowest level, the outer faces of the grid, or departures from a mean."""
from __future__ import annotations

from typing import Any, Callable

import pyvista

from .._blocks import cell_dimension
from .._fields import preset_of_field
from .departures import departures
from .faces import outer_faces
from .look import STRATIFIED
from .lowest import lowest_level
from .prisms import LEVEL_SIZE
from .sea import is_sea
from .sections import is_section

FORM = "NephoscopeForm"  # field array that names the form, for the scalar bar
FILLING = ("temperature",)  # presets of fields that fill all of the air
VOLUME = ("contours", "layers", "sun", "exposure", "tone_mapping", "opacity_scale", "opacity_unit_distance")  # options of volumes alone


def form_of(grid: pyvista.DataSet, name: str, options: dict[str, Any]) -> Callable[[pyvista.DataSet], pyvista.DataSet] | None:
    """The function that makes the form of the mesh that suits the array `name`; None if the mesh itself suits it, or if one of the `options` asks for a volume."""
    section = is_section(grid)
    if any(option in options for option in ("opacity", *VOLUME)) or cell_dimension(grid) < 3 and not section:
        return None
    on_earth = "GlobeGridProjection" in grid.field_data
    has_levels = name in grid.point_data if hasattr(grid, "dimensions") else LEVEL_SIZE in grid.field_data
    if not has_levels or on_earth and is_sea(grid):
        return None
    preset = preset_of_field(name, grid)
    if preset is not None and preset.name in FILLING and not section:
        return lambda mesh: _told(*(lowest_level if on_earth else outer_faces)(mesh, name))
    if name + STRATIFIED in grid.field_data and not {"clim", "cmap", "log_scale", "preset"} & set(options):
        return lambda mesh: _told(*departures(mesh, name))
    return None


def _told(mesh: pyvista.DataSet, form: str) -> pyvista.DataSet:
    mesh.field_data[FORM] = [form]
    return mesh


def told_form(title: Callable[[str], str], grid: pyvista.DataSet) -> Callable[[str], str]:
    """`title` for scalar bars, with a line that names the form."""
    return (lambda array: f"{title(array)}\n{grid.field_data[FORM][0]}") if FORM in grid.field_data else title
