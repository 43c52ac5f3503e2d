# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh of a flat grid in metres, its description, and its fields by their names."""
from __future__ import annotations

from difflib import get_close_matches
from typing import Any, Sequence

import numpy as np
import pyvista

from .._checks import listed, require_number
from .._fields import FLAT_GRID, choose_active_scalars
from .flat import Axis, Flat, fields_of
from .flat_air import AIR, air_roles, mark_air
from .flat_derived import QUANTITIES, column_of, derived_flat
from .look import note_look
from .naming import UNITS, word
from .placing import note_units
from .roles import ROLES, candidates
from .times import listed_times
from .units import UnitsError, converted

CLEAR = 1e30  # greater magnitudes are fill values


def flat_mesh(flat: Flat, variables: Sequence[str] | None, vertical_exaggeration: float, derive: str | Sequence[str] = ()) -> pyvista.ImageData | pyvista.RectilinearGrid:
    """Points in metres, at the positions in the dataset; fields on the points."""
    mesh = _points(flat, require_number(vertical_exaggeration, "vertical_exaggeration", above=0))
    for name in _chosen(flat, variables):
        mesh.point_data[name] = _float(flat.values(name)).ravel()
        note_units(mesh, name, flat.dataset[name].attrs.get("units"))
        note_look(mesh, flat.dataset, name)
    for name, values in derived_flat(derive, flat, lambda: air_mesh(flat)).items():
        mesh.point_data[name] = _float(values).ravel()
        note_units(mesh, name, UNITS.get(name))
        note_look(mesh, flat.dataset, name)
    if variables is None:
        _add_wind(mesh, flat, vertical_exaggeration)
    mark_air(mesh, air_roles((name, flat.dataset[name]) for name in flat.names()), flat.profiles)
    choose_active_scalars(mesh)
    return mesh


def air_mesh(flat: Flat) -> pyvista.DataSet:
    """The mesh with the variables of the air alone."""
    return flat_mesh(flat, [*dict.fromkeys([*air_roles((name, flat.dataset[name]) for name in flat.names()).values(), *flat.profiles.values()])], 1.0)


def flat_column(flat: Flat, quantity: str) -> pyvista.DataSet:
    """One level with the array `column`, kg/m2, at the height 0."""
    values = column_of(quantity, flat, lambda: air_mesh(flat))
    mesh = _points(flat, 1.0, level=True)
    mesh.point_data["column"] = values.astype(np.float32).ravel()
    note_units(mesh, "column", "kg m-2")
    return mesh


def _points(flat: Flat, stretch: float, level: bool = False) -> pyvista.ImageData | pyvista.RectilinearGrid:
    axes = [None if level and letter == "z" else flat.axes.get(letter) for letter in "xyz"]
    lines = [np.zeros(1) if axis is None else axis.values * (stretch if letter == "z" else 1) for letter, axis in zip("xyz", axes)]
    mesh = _image(lines, axes, stretch) or pyvista.RectilinearGrid(*lines)
    mesh.field_data[FLAT_GRID], mesh.field_data["VerticalExaggeration"] = [1], [stretch]
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
    wanted = there if variables is None else [variables] if isinstance(variables, str) else list(map(word, variables))
    missing = [name for name in wanted if name not in there]
    if missing:
        raise ValueError(f"variables: {listed(missing)} not on the grid of {wanted[0]!r}. On it are: {listed(there)}. Make a grid of each.")
    return wanted


def _add_wind(mesh: pyvista.DataSet, flat: Flat, stretch: float) -> None:
    """The array Wind; with heights that are stretched also DisplayVelocity, along which smoke moves in the picture."""
    names = flat.winds()
    if not names:
        return
    try:
        parts = [np.zeros(mesh.n_points, np.float32) if name is None else
                 converted(_float(flat.values(name)), flat.dataset[name].attrs.get("units"), "speed", name)[0].ravel() for name in names]
    except UnitsError as problem:
        flat.warn(f"The array Wind is left out. {problem}")
        return
    mesh.point_data["Wind"] = np.column_stack(parts)
    note_units(mesh, "Wind", "m s-1")
    if stretch != 1:
        mesh.point_data["DisplayVelocity"] = np.column_stack([*parts[:2], parts[2] * np.float32(stretch)])


def flat_field(dataset, name: str) -> tuple[str, dict[str, Any]]:
    """The array of the mesh with this name, and the options of `grid` that read it alone: a variable with this name, standard name, long name or role, or a computed quantity."""
    fields = dict(fields_of(dataset))
    if name in fields:
        return name, {"variables": [name]}
    if name in dataset.variables and dataset[name].ndim == 1:
        raise ValueError(f"{name!r} has the dimension {dataset[name].dims[0]!r} alone: plot it as a profile, ds[{name!r}].plot(). Fields to draw are: {listed(list(fields))}.")
    lower = name.lower()
    computed = "wind_magnitude" if lower == "wind" else lower
    if computed in QUANTITIES and lower not in (field.lower() for field in fields):
        return computed, {"variables": [], "derive": [computed]}
    found = [field for field, variable in fields.items() if lower in (field.lower(), *(str(variable.attrs.get(key, "")).lower() for key in ("standard_name", "long_name")))]
    found = found or [field for role in ROLES.values() if lower == role.name or lower in role.names for field in candidates(role, fields.items())]
    if found:
        return found[0], {"variables": found[:1]}
    near = get_close_matches(name, [*fields, *QUANTITIES], 3, 0.6)
    raise ValueError(f"There is no field {name!r}." + (f" Did you mean {listed(near)}?" if near else "") + f" There are: {listed(list(fields))}; computed quantities: "
                     f"{listed(['Wind', *QUANTITIES])}.")


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
    winds = [name for name in flat.winds() if name]
    lines += [f"wind: {listed(winds)}"] if winds else []
    return "\n".join(lines + [f"note: {note}" for note in [*(axis.note for axis in flat.axes.values() if axis.note), *flat.notes]])


def _spacing(axis: Axis) -> str:
    return f", every {axis.step:g} m" if axis.step else ""
