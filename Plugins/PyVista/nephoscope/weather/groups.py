# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""NetCDF and HDF5 files whose variables are in groups: those of all groups as one dataset, if they fit together."""
from __future__ import annotations

from .._checks import listed
from .extras import need


def with_groups(path, root, chunks, options):
    """`root`, which has no variables, with those of the groups."""
    xarray = need("xarray", "opening weather data")
    names = _names(path)
    if not names:
        return root
    parts = [root, *(xarray.open_dataset(path, group=name, chunks=chunks, **options) for name in names)]
    try:
        if clash := _twice(parts[1:]):
            raise ValueError(f"{clash!r} is in several")
        return xarray.merge(parts, compat="override", join="exact", combine_attrs="override")
    except ValueError as problem:
        raise ValueError(f"{path} has its variables in {len(names)} groups, {listed(names)}, which do not fit together ({problem}). Choose one: "
                         f"nephoscope.open({str(path)!r}, group={names[0]!r}).") from problem


def _names(path) -> list[str]:
    """The groups that have variables, as netCDF4 names them."""
    def walk(group):
        return ([group.path] if group.variables and group.parent is not None else []) + [name for part in group.groups.values() for name in walk(part)]
    with need("netCDF4", "reading groups of NetCDF").Dataset(path) as file:
        return walk(file)


def _twice(parts) -> str | None:
    seen: set[str] = set()
    for part in parts:
        for name in part.data_vars:
            if name in seen:
                return str(name)
            seen.add(name)
    return None
