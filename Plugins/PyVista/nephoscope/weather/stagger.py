# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Averages values on staggered grids (Arakawa C) to the centres of the cells."""
from __future__ import annotations

import re

import numpy as np

from .horizontal import is_latitude, is_longitude

_STAGGERED = re.compile(r"stag|_(u|v|psi|g)$|^[xy]q$")  # WRF, ROMS, MITgcm, MOM6


def is_staggered(dim) -> bool:
    """True if a dimension is by its name that of faces or corners of cells."""
    return bool(_STAGGERED.search(str(dim)))


def centres_of(dataset, shapes) -> str | None:
    """The longitudes at the centres of the cells, if all fields, with the horizontal dimensions `shapes`, are on faces of the cells; None otherwise.

    The faces may have no longitudes themselves. The largest of several grids is that of the centres: the corners of ROMS are between them.
    """
    grids = [{variable.dims[-2:]: str(name) for name, variable in dataset.variables.items() if fits(str(name), variable) and variable.ndim >= 2} for fits in (is_longitude, is_latitude)]
    sizes = dataset.sizes
    found = [dims for dims in grids[0] if dims in grids[1] and dims not in shapes and all(len(shape) == 2 and shares_axes(shape, dims) and _on_faces(sizes, shape, dims) for shape in shapes)]
    if len(shapes) < 2 and any(shape in grids[0] for shape in shapes):
        return None
    return grids[0][max(found, key=lambda dims: sizes[dims[0]] * sizes[dims[1]])] if found else None


def shares_axes(shape, dims) -> bool:
    """Whether some dimensions are the same, or all have the same names except for their position on the grid, as ROMS' (eta_u, xi_u) and (eta_rho, xi_rho)."""
    return bool(set(shape) & set(dims)) or all(map(is_same_axis, shape, dims))


def is_same_axis(a, b) -> bool:
    """Whether the names differ only in what follows the last underscore, as ROMS' xi_u and xi_rho."""
    stems = [str(dim).rpartition("_")[0] for dim in (a, b)]
    return stems[0] == stems[1] != ""


def _on_faces(sizes, shape, dims) -> bool:
    return any(map(is_staggered, shape)) and all(abs(sizes[a] - sizes[b]) <= 1 for a, b in zip(shape, dims))


def to_centres(dataset, array, wanted: list[str]):
    """`array`, with every dimension that stands for one in `wanted` averaged onto it, and a note about this."""
    strange = [dim for dim in array.dims if dim not in wanted]
    missing = [dim for dim in wanted if dim not in array.dims]
    notes = []
    for dim in strange:
        own = _partner(dataset, dim, missing)
        if own is None:
            raise ValueError(f"{array.name!r} has the dimension {dim!r}, which is none of {wanted}. Choose an index: ds.isel({dim}=0).")
        missing.remove(own)
        array = _averaged(dataset, array, dim, own)
        notes.append(f"{array.name!r} averaged from {dim} to {own}")
    return array, "; ".join(notes)


def _partner(dataset, dim: str, missing: list[str]) -> str | None:
    """The missing dimension with a similar name, otherwise the one with as many points or one fewer."""
    fitting = [own for own in missing if abs(dataset.sizes[dim] - dataset.sizes[own]) <= 1]
    return max(fitting, key=lambda own: (_common(dim, own), dataset.sizes[dim] - dataset.sizes[own]), default=None)


def _common(a: str, b: str) -> int:
    """Number of letters that both names begin with or end with."""
    starts = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
    ends = next((i for i, (x, y) in enumerate(zip(a[::-1], b[::-1])) if x != y), min(len(a), len(b)))
    return max(starts, ends)


def _averaged(dataset, array, dim: str, own: str):
    if dataset.sizes[dim] == dataset.sizes[own] + 1:
        lower, upper = array.isel({dim: slice(None, -1)}), array.isel({dim: slice(1, None)})
        mean = 0.5 * (lower.drop_vars(dim, errors="ignore") + upper.drop_vars(dim, errors="ignore"))
        return mean.rename({dim: own}).assign_attrs(array.attrs).rename(array.name)
    if dataset.sizes[dim] == dataset.sizes[own] and not (dim in dataset.variables and own in dataset.variables):
        return array.rename({dim: own})  # full levels under another name, as ICON's height_2
    if dataset.sizes[dim] == dataset.sizes[own] - 1 and dim not in dataset.variables:
        return _between(array, dim, own)
    if dim in dataset.variables and own in dataset.variables:
        return _interpolated(dataset, array, dim, own)
    raise ValueError(f"{array.name!r} is on {dim!r}, {dataset.sizes[dim]} points, and the grid on {own!r}, {dataset.sizes[own]}: without coordinates on both, the relative "
                     "position of their points is unknown. Interpolate it first.")


def _between(array, dim: str, own: str):
    """From the points between the centres, as ROMS' u: the first and the last centre have the value of their only neighbour."""
    wide = array.pad({dim: 1}, mode="edge")
    mean = 0.5 * (wide.isel({dim: slice(None, -1)}) + wide.isel({dim: slice(1, None)}))
    return mean.rename({dim: own}).assign_attrs(array.attrs).rename(array.name)


def _interpolated(dataset, array, dim: str, own: str):
    """Interpolates linearly in the coordinate; the last half step at a border has the border's value."""
    here, there = np.asarray(dataset[dim].values, float), np.asarray(dataset[own].values, float)
    order = np.argsort(here)
    upper = np.clip(np.searchsorted(here[order], there), 1, len(here) - 1)
    share = np.clip((there - here[order][upper - 1]) / (here[order][upper] - here[order][upper - 1]), 0, 1)
    axis = array.dims.index(dim)
    values = np.asarray(array.values)
    weight = share.reshape([-1 if i == axis else 1 for i in range(values.ndim)]).astype(values.dtype)
    mixed = np.take(values, order[upper - 1], axis) * (1 - weight) + np.take(values, order[upper], axis) * weight
    return type(array)(mixed, dims=[own if d == dim else d for d in array.dims], name=array.name, attrs=array.attrs)
