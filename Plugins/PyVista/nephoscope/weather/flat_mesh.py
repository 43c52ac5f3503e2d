# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh of a flat grid in metres, its description, its fields by their names, and its first picture."""
from __future__ import annotations

from difflib import get_close_matches
from typing import Callable, Sequence

import numpy as np
import pyvista

from .._blocks import cell_dimension
from .._checks import listed, require_number
from .._fields import FLAT_GRID, choose_active_scalars
from .._medium import association_of, default_scalars
from .flat import Axis, Flat, fields_of
from .flat_air import AIR, air_roles, mark_air
from .picture import BESIDE, set_title
from .placing import note_units
from .roles import ROLES, candidates, quantity_of
from .times import listed_times
from .units import converted

CLEAR = 1e30  # greater magnitudes are fill values
GROUND = (0.06, 0.13, 0.2)
FACING = {"x": (1, 0, 0), "y": (0, -1, 0), "z": (0, 0, 1)}  # where to look from at a section, by the axis that it lacks


def flat_mesh(flat: Flat, variables: Sequence[str] | None, vertical_exaggeration: float) -> pyvista.ImageData | pyvista.RectilinearGrid:
    """Points in metres, in the places of the dataset; fields on the points."""
    stretch = {"z": require_number(vertical_exaggeration, "vertical_exaggeration", above=0)}
    axes = [flat.axes.get(letter) for letter in "xyz"]
    lines = [np.zeros(1) if axis is None else axis.values * stretch.get(letter, 1) for letter, axis in zip("xyz", axes)]
    mesh = _image(lines, axes, stretch["z"]) or pyvista.RectilinearGrid(*lines)
    mesh.field_data[FLAT_GRID], mesh.field_data["VerticalExaggeration"] = [1], [stretch["z"]]
    for name in _chosen(flat, variables):
        mesh.point_data[name] = _float(flat.values(name)).ravel()
        note_units(mesh, name, flat.dataset[name].attrs.get("units"))
    if variables is None:
        _add_wind(mesh, flat, stretch["z"])
    mark_air(mesh, air_roles((name, flat.dataset[name]) for name in flat.names()), flat.profiles)
    choose_active_scalars(mesh)
    return mesh


def _image(lines: list[np.ndarray], axes: list[Axis | None], stretch: float) -> pyvista.ImageData | None:
    """An image if all axes are even, otherwise None."""
    steps = [0.0 if axis is None else axis.step for axis in axes]
    if None in steps:
        return None
    spacing = np.array(steps) * (1, 1, stretch)
    spacing[spacing == 0] = spacing.max() or 1.0  # a single point along this axis
    return pyvista.ImageData(dimensions=[len(line) for line in lines], spacing=spacing, origin=[line[0] for line in lines])


def _float(values: np.ndarray) -> np.ndarray:
    values = np.asarray(values, np.float32)
    return np.where(np.abs(values) > CLEAR, np.float32(np.nan), values)


def _chosen(flat: Flat, variables: Sequence[str] | None) -> list[str]:
    there = [*flat.names(), *flat.profiles.values()]
    wanted = there if variables is None else [variables] if isinstance(variables, str) else list(variables)
    missing = [name for name in wanted if name not in there]
    if missing:
        raise ValueError(f"variables: {listed(missing)} not on the grid of {wanted[0]!r}. On it are: {listed(there)}. Make a grid of each.")
    return wanted


def _winds(flat: Flat) -> list[str | None]:
    """The variables of the wind along x, y and z; empty if one along the ground is missing."""
    fields = [(name, flat.dataset[name]) for name in flat.names()]
    found = []
    for role in "uvw":
        names = [name for name in candidates(ROLES[role], fields) if quantity_of(ROLES[role], flat.dataset[name]) == "speed"]
        found.append(names[0] if names else None)
    along = [name for letter, name in zip("xyz", found) if letter in flat.axes and (letter != "z" or len(flat.axes) == 2)]
    return found if None not in along else []


def _add_wind(mesh: pyvista.DataSet, flat: Flat, stretch: float) -> None:
    """The array Wind; with heights that are stretched also DisplayVelocity, along which smoke moves in the picture."""
    names = _winds(flat)
    if not names:
        return
    parts = [np.zeros(mesh.n_points, np.float32) if name is None else
             converted(_float(flat.values(name)), flat.dataset[name].attrs.get("units"), "speed", name)[0].ravel() for name in names]
    mesh.point_data["Wind"] = np.column_stack(parts)
    note_units(mesh, "Wind", "m s-1")
    if stretch != 1:
        mesh.point_data["DisplayVelocity"] = np.column_stack([*parts[:2], parts[2] * np.float32(stretch)])


def flat_name(dataset, name: str) -> str:
    """The variable with this name, or with this standard name, long name or role."""
    fields = dict(fields_of(dataset))
    if name in fields:
        return name
    if name in dataset.variables and dataset[name].ndim == 1:
        raise ValueError(f"{name!r} has the dimension {dataset[name].dims[0]!r} alone: plot it as a profile, ds[{name!r}].plot(). Fields to draw are: {listed(list(fields))}.")
    lower = name.lower()
    found = [field for field, variable in fields.items() if lower in (field.lower(), *(str(variable.attrs.get(key, "")).lower() for key in ("standard_name", "long_name")))]
    found = found or [field for role in ROLES.values() if lower == role.name or lower in role.names for field in candidates(role, fields.items())]
    if found:
        return found[0]
    near = get_close_matches(name, fields, 3, 0.6)
    raise ValueError(f"There is no field {name!r}." + (f" Did you mean {listed(near)}?" if near else "") + f" There are: {listed(list(fields))}.")


def described_flat(flat: Flat, dataset) -> str:
    """Lines to print: axes, time, fields and what is assumed."""
    even = all(axis.step is not None for axis in flat.axes.values())
    sizes = " x ".join(f"{axis.dim} {len(axis.values)}" for axis in flat.axes.values())
    times = listed_times(dataset)
    lines = [f"grid: flat, in metres, {sizes}, {'evenly spaced (ImageData)' if even else 'not evenly spaced (RectilinearGrid)'}"]
    lines += [f"{letter}: {axis.values[0]:g} to {axis.values[-1]:g} m{_spacing(axis)}" + (f" ({axis.name})" if axis.name else "") for letter, axis in flat.axes.items()]
    lines += [f"time: {flat.time_text or 'none'}" + (f" (of {len(times)}, to {times[-1]})" if len(times) > 1 else "")]
    lines += ["fields: " + ", ".join(f"{name!r}" + (f" ({units})" if (units := flat.dataset[name].attrs.get("units")) else "") for name in flat.names())]
    lines += [f"{AIR[role].meaning}: {name!r}, a profile along z" + (f" ({units})" if (units := flat.dataset[name].attrs.get("units")) else "") + ", the same in every column"
              for role, name in flat.profiles.items()]
    lines += ["left out: " + ", ".join(f"{name!r} ({', '.join(map(str, flat.dataset[name].dims)) or 'one value'})" for name in flat.left_out())] if flat.left_out() else []
    winds = [name for name in _winds(flat) if name]
    lines += [f"wind: {listed(winds)}"] if winds else []
    return "\n".join(lines + [f"note: {note}" for note in [*(axis.note for axis in flat.axes.values() if axis.note), *flat.notes]])


def _spacing(axis: Axis) -> str:
    return f", every {axis.step:g} m" if axis.step else ""


def plotted_flat(grid: pyvista.DataSet, scalars: str | None, screenshot: str | None, options: dict, title: Callable[[str], str] = str) -> pyvista.Plotter:
    """`title`: that of the scalar bar, for the name of an array."""
    plotter = pyvista.Plotter(off_screen=screenshot is not None, theme=pyvista.themes.DarkTheme(), window_size=(800, 800))
    draw_flat(plotter, grid, scalars, options, title)
    plotter.show(screenshot=screenshot or False, auto_close=False)
    return plotter


def draw_flat(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, scalars: str | None, options: dict, title: Callable[[str], str]) -> None:
    """The field as a volume in the outline of its grid, seen from the south and from above; a field of one level or a section as a surface."""
    from ..cells import add_cells
    options = {"scalar_bar_args": BESIDE, **options}
    if cell_dimension(grid) < 3:
        name = default_scalars(grid)[1] if scalars is None else scalars
        association_of(grid, name, "point", "scalars")  # raises an error if no value is finite; VTK would end the process
        plotter.add_mesh(grid, scalars=name, **{"nan_opacity": 0, "lighting": False, **options})
        flat = next((letter for letter, count in zip("xyz", grid.dimensions) if count == 1), "z")
        plotter.view_vector(FACING[flat], viewup=(0, 1, 0) if flat == "z" else (0, 0, 1))
    else:
        west, east, south, north, bottom, _ = grid.bounds
        ground = pyvista.Plane(center=((west + east) / 2, (south + north) / 2, bottom), i_size=east - west, j_size=north - south, i_resolution=1, j_resolution=1)
        plotter.add_mesh(ground, color=GROUND, lighting=False)
        plotter.add_mesh(grid.outline(), color="grey")
        add_cells(plotter, grid, scalars, **options)
        plotter.view_vector((0.45, -1, 0.4), viewup=(0, 0, 1))
    plotter.add_axes()
    for bar in plotter.scalar_bars.values():
        set_title(bar, title(bar.GetTitle()))
    plotter.camera.zoom(0.84)
    plotter.camera.SetWindowCenter(0.08, 0)  # room for the scalar bar
    plotter.reset_camera_clipping_range()
