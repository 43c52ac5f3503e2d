# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a flat grid: a volume over its ground, or a level or section with axes."""
from __future__ import annotations

from typing import Callable

import numpy as np
import pyvista

from .._bars import add_mesh
from .._blocks import cell_dimension
from .._medium import association_of, default_scalars
from .._over_time import follows
from .bars import BESIDE, bars_in, finish_bars, make_room
from .exaggeration import write_exaggeration
from .forms import form_of, told_form
from .look import surface_look, with_share
from .picture import refuse_volume, without_missing
from .scales import add_scales
from .section_ground import LAND, ground_of, visible
from .sections import unrolled
from .view import Frame, set_view, size_of

GROUND = (0.06, 0.13, 0.2)
FACING = {"x": (1, 0, 0), "y": (0, -1, 0), "z": (0, 0, 1)}  # where to look from at a section, by the axis that it lacks
WIDE, HIGH = 0.66, 0.78  # of the picture, for a section beside its labels and the scalar bar


def plotted_flat(grid: pyvista.DataSet, scalars: str | None, frame: Frame, options: dict, title: Callable[[str], str] = str) -> pyvista.Plotter:
    """`title`: that of the scalar bar, for the name of an array."""
    plotter = frame.begin()
    draw_flat(plotter, without_missing(grid, scalars), scalars, options, title)
    if frame.view is not None:
        plotter.camera.view_angle = 30  # PyVista's
        set_view(plotter, frame.view)
    return frame.finish(plotter)


def plotted_section(grid: pyvista.StructuredGrid, scalars: str | None, frame: Frame, options: dict, title: Callable[[str], str]) -> pyvista.Plotter:
    """A section of the globe, by latitude, longitude or distance and height."""
    plotter = frame.begin()
    name = default_scalars(grid)[1] if scalars is None else scalars
    if (form := form_of(grid, name, options)) is not None:
        grid, scalars = form(grid), name
    draw_section(plotter, *unrolled(grid, shape_of_section(plotter)), scalars, options, title)
    if frame.view is not None:
        set_view(plotter, frame.view)
    return frame.finish(plotter)


def shape_of_section(plotter: pyvista.BasePlotter) -> float:
    """Height over width of a section that fills the picture."""
    across, high = size_of(plotter)
    return min(1.0, max(0.4, HIGH / WIDE * high / across))


def draw_section(plotter: pyvista.BasePlotter, sheet: pyvista.StructuredGrid, scales: dict[str, tuple[str, float]], scalars: str | None, options: dict, title: Callable[[str], str]) -> None:
    """As `plotted_section`, into a plotter. `sheet` and `scales`: what `unrolled` returns."""
    bars = bars_in(plotter)
    name = default_scalars(sheet)[1] if scalars is None else scalars
    for part in ground_of(sheet):
        plotter.add_mesh(part, color=LAND, lighting=False, reset_camera=False)
    title = told_form(title, sheet)
    title = _draw_section(plotter, sheet, name, {"scalar_bar_args": BESIDE, **options}, "y", scales, title)
    finish_bars(plotter, bars, title, options.get("clim"))
    make_room(plotter, as_high=False)


def draw_flat(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, scalars: str | None, options: dict, title: Callable[[str], str]) -> None:
    """The field as a volume in the outline of its grid, seen from the south and from above, or on the faces of the grid if it fills all of it; a field of one level or a section as a surface."""
    options, bars = {"scalar_bar_args": BESIDE, **options}, bars_in(plotter)
    name = default_scalars(grid)[1] if scalars is None else scalars
    if not follows(grid) and (form := form_of(grid, name, options)) is not None:
        grid, scalars = form(grid), name
    title = told_form(title, grid)
    if isinstance(grid, pyvista.PolyData):
        title = _draw_faces(plotter, grid, name, options, title)
    elif cell_dimension(grid) == 3:
        _draw_volume(plotter, grid, scalars, options)
    else:
        flat = next((letter for letter, count in zip("xyz", grid.dimensions) if count == 1), "z")
        title = _draw_section(plotter, grid, scalars, options, flat, _lengths(grid), title)
    write_exaggeration(plotter, grid)
    finish_bars(plotter, bars, title, options.get("clim"))
    make_room(plotter, as_high=False)


def _draw_volume(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, scalars: str | None, options: dict) -> None:
    from ..cells import add_cells
    west, east, south, north, bottom, _ = grid.bounds
    ground = pyvista.Plane(center=((west + east) / 2, (south + north) / 2, bottom), i_size=east - west, j_size=north - south, i_resolution=1, j_resolution=1)
    plotter.add_mesh(ground, color=GROUND, lighting=False)
    plotter.add_mesh(grid.outline(), color="grey")
    add_cells(plotter, grid, scalars, **{"show_scalar_bar": "sun" not in options, **options})
    _look_from_the_south(plotter)


def _draw_faces(plotter: pyvista.BasePlotter, faces: pyvista.PolyData, name: str, options: dict, title: Callable[[str], str]) -> Callable[[str], str]:
    """Returns the titles of scalar bars."""
    association = association_of(faces, name, "point", "scalars")  # raises an error if no value is finite; VTK would end the process
    look = surface_look(plotter, faces, name, association, options, over_ground=False)
    plotter.add_mesh(faces.outline(), color="grey")
    add_mesh(plotter, faces, name, scalars=name, **{"lighting": False, **look})
    _look_from_the_south(plotter)
    return with_share(title, faces, name, association, options, look)


def _look_from_the_south(plotter: pyvista.BasePlotter) -> None:
    plotter.view_vector((0.45, -1, 0.4), viewup=(0, 0, 1))
    plotter.add_axes()
    plotter.camera.zoom(0.84)
    plotter.camera.SetWindowCenter(0.08, 0)  # room for the scalar bar
    plotter.reset_camera_clipping_range()


def _draw_section(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, scalars: str | None, options: dict, flat: str, scales: dict[str, tuple[str, float]],
                  title: Callable[[str], str]) -> Callable[[str], str]:
    """Returns the titles of scalar bars."""
    refuse_volume(options)
    name = default_scalars(grid)[1] if scalars is None else scalars
    association = association_of(grid, name, "point", "scalars")  # raises an error if no value is finite; VTK would end the process
    look = surface_look(plotter, grid, name, association, options, over_ground=False)
    title = with_share(title, grid, name, association, options, look)
    add_mesh(plotter, visible(grid, name), name, scalars=name, **{"nan_opacity": 0, "lighting": False, **look})
    plotter.view_vector(FACING[flat], viewup=(0, 1, 0) if flat == "z" else (0, 0, 1))
    add_scales(plotter, grid.bounds, flat, scales)
    plotter.enable_parallel_projection()
    across, up = (np.ptp(grid.bounds[2 * axis:2 * axis + 2]) for axis in ["xyz".index(letter) for letter in "xyz" if letter != flat])
    aspect = np.divide(*size_of(plotter))
    plotter.camera.parallel_scale = 0.5 * max(across / aspect / WIDE, up / HIGH) or 1.0
    plotter.camera.SetWindowCenter(0.06, 0)  # room for the scalar bar
    plotter.reset_camera_clipping_range()
    return title


def _lengths(grid: pyvista.DataSet) -> dict[str, tuple[str, float]]:
    """The unit of each axis, metres or kilometres, and its length in the scene."""
    stretch = float(grid.field_data["VerticalExaggeration"][0]) if "VerticalExaggeration" in grid.field_data else 1.0
    spans, scale = np.ptp(np.reshape(grid.bounds, (3, 2)), axis=1), np.array([1, 1, stretch])
    unit, size = ("km", 1000.0) if (spans / scale).max() > 1e4 else ("m", 1.0)
    return {letter: (f"{letter} [{unit}]", size * factor) for letter, factor in zip("xyz", scale)}
