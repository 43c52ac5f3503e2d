# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The names by which a user may call a field: its variable, its role, its standard or long name, or a derived quantity."""
from __future__ import annotations

from difflib import get_close_matches
from typing import Any

from .._checks import listed
from .derived import QUANTITIES, computable
from .prepare import made_of
from .reading import KINDS, Reading
from .roles import ROLES
from .sea import is_of_water
from .units import simple, usual

UNITS = {"temperature": "K", "potential_temperature": "K", "equivalent_potential_temperature": "K", "wind_speed": "m s-1", "wind_magnitude": "m s-1", "Wind": "m s-1", "vorticity": "s-1", "cloud_content": "kg m-3", "water_vapour": "kg m-3"}
LONGEST = 40  # letters of a title; longer names are descriptions
UNITLESS = ("", "1", "-", "~", "none", "unknown", "(0 - 1)", "0-1", "fraction", "dimensionless")


def word(name: Any) -> str:
    """The name of an array for any name that xarray allows: ("t", 850) becomes "t_850"."""
    return name if isinstance(name, str) else "_".join(map(str, name)) if isinstance(name, tuple) else str(name)


def with_words(dataset: Any) -> Any:
    """`dataset` with strings for those names of variables and dimensions that are not strings."""
    names = {name: word(name) for name in {*dataset.variables, *dataset.dims} if not isinstance(name, str)}
    return dataset.rename(names) if names else dataset


def named(reading: Reading, name: str) -> tuple[str, dict[str, Any]]:
    """The array of the mesh with this name, and the options of `globe` that load it alone."""
    fields = [known for known, _ in reading.field_variables()]
    if name in fields:
        return name, {"variables": [name]}
    if name in reading.dataset.variables:
        raise ValueError(_why_not(reading, name, fields))
    if (made := made_of(reading.dataset, name)) and made[0] in fields:
        reading.warn(f"{name!r} is drawn as {made[0]!r}, which is {made[1]} of the file.")
        return made[0], {"variables": [made[0]]}
    if name in reading.roles and reading.roles[name] in fields:
        return reading.roles[name], {"variables": [reading.roles[name]]}
    if name in QUANTITIES and (name != "temperature" or name in computable(reading)):
        return name, {"variables": [], "derive": [name]}
    told = [field for field in fields if name.lower() in [str(reading.dataset[field].attrs.get(key, "")).lower() for key in ("standard_name", "long_name", "GRIB_shortName", "GRIB_name")]]
    told = told or [field for field in fields if name.lower() == field.lower()]
    told = told or [reading.roles[role.name] for role in ROLES.values() if name.lower() in role.names and reading.roles.get(role.name) in fields]  # of another model
    if told:
        return told[0], {"variables": told[:1]}
    quantities = computable(reading)
    near = get_close_matches(name, [*fields, *quantities], 3, 0.6)
    computed = f"; computed quantities: {listed(quantities)}" if quantities else ""
    raise ValueError(f"There is no field {name!r}." + (f" Did you mean {listed(near)}?" if near else "") + f" There are: {listed(fields)}{computed}.")


def _why_not(reading: Reading, name: str, fields: list[str]) -> str:
    variable = reading.dataset[name]
    if variable.dtype.kind not in KINDS:
        return f"{name!r} is of type {variable.dtype}, but a field must have numbers. Convert it, ds[{name!r}].astype('float32'), or draw another: {listed(fields)}."
    if name in reading.helpers:
        copy = f" To draw it, copy its values: ds.assign(copy=({variable.dims!r}, ds[{name!r}].data))." if set(variable.dims) == set(reading.horizontal.dims) else ""
        return f"{name!r} tells where the points or cells are; it is not a field.{copy} There are: {listed(fields)}."
    wanted = [*([reading.vertical.dim] if reading.vertical else []), *reading.horizontal.dims]
    others = [dim for dim in variable.dims if dim not in wanted]
    of_another_grid = not others or variable.ndim <= len(reading.horizontal.dims)
    choose = "" if of_another_grid else f" Choose a place along {others[0]!r}: ds.isel({others[0]}=0)."
    alone = f" Draw it alone: ds[[{name!r}]].nephoscope.plot(), or pass ds[[{name!r}]] to animate." if of_another_grid and variable.ndim > 1 else ""
    return f"{name!r} is on {listed(list(variable.dims)) or 'no dimension'}, but the fields that can be drawn are on {listed(wanted)}: {listed(fields)}.{choose}{alone}"


def title(dataset, grid, name: str) -> str:
    """The title of a scalar bar, such as "Temperature [K]"."""
    attrs = dataset.variables[name].attrs if name in dataset.variables else {}
    text = next(text for text in (*(str(attrs.get(key, "")) for key in ("long_name", "standard_name")), name) if 0 < len(text) <= LONGEST or text == name)
    told = str(attrs.get("units", UNITS.get(name, "")))
    units = str(grid.field_data[f"{name}_units"][0]) if f"{name}_units" in grid.field_data else told
    units = told if units == simple(told) else units  # those of the file may have signs that are not ASCII
    text = text.replace("_", " ") if attrs.get("standard_name") == text or name in UNITS else text
    text = "current speed" if name in ("wind_speed", "wind_magnitude") and name not in dataset.variables and is_of_water(dataset, grid) else text
    text = text[:1].upper() + text[1:] if text != name or name in UNITS else text
    return text if units.strip().lower() in UNITLESS else f"{text} [{usual(units)}]"


def refuse_unknown(function: str, options: dict[str, Any], own: tuple[str, ...]) -> None:
    """Raises TypeError for an option that is not one of `function`, whose options are `own`, roles and those of `to_globe`."""
    from inspect import signature

    from ..cells import add_cells
    from ..globe import to_globe
    known = [*own, *list(signature(to_globe).parameters)[1:], *ROLES]
    for name in options:
        if name not in known:
            near = get_close_matches(name, known, 1, 0.55)
            told = f"Did you mean {listed(near)}?" if near else ""
            if name in signature(add_cells).parameters:
                told = f"It is an option of add_cells: nephoscope.add_cells(plotter, dataset.nephoscope.globe(), ..., {name}=...)."
            told = told or f"It takes {listed(own)}, the options of nephoscope.to_globe, and names of variables for roles."
            raise TypeError(f"{function}() has no option {name!r}. {told}")
