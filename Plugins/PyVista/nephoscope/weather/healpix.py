# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""HEALPix (Gorski et al. 2005): the positions of its pixels, which are (x, y) of a face of nside x nside; the whole sphere, or the pixels whose numbers a coordinate has."""
from __future__ import annotations

import numpy as np


def healpix_of(dataset, dim: str) -> tuple[int, bool, np.ndarray | None] | None:
    """nside, True if nested, and the numbers of the pixels (None: all, in order), by a grid mapping healpix, or by GRIB's keys; None if the points are no pixels."""
    size = dataset.sizes[dim]
    whole = round(np.sqrt(size / 12))
    whole = whole if 12 * whole ** 2 == size else 0
    for variable in dataset.variables.values():
        keys = variable.attrs
        if "healpix" in (keys.get("grid_mapping_name"), keys.get("grid_name")) or "healpix_nside" in keys:
            order = str(keys.get("healpix_order", keys.get("indexing_scheme", "nest")))
            return _with_numbers(dataset, dim, _resolution(keys) or whole, order.startswith("nest"))
        if keys.get("GRIB_gridType") == "healpix":
            return (whole, str(keys.get("GRIB_orderingConvention", "ring")).startswith("nest"), None) if whole else None
    return None


def _resolution(keys: dict) -> int:
    """nside; 0 if the keys do not have it."""
    if "healpix_nside" in keys or "nside" in keys:
        return int(keys.get("healpix_nside", keys.get("nside")))
    return 2 ** int(keys["refinement_level"]) if "refinement_level" in keys else 0


def _with_numbers(dataset, dim: str, nside: int, nested: bool) -> tuple[int, bool, np.ndarray | None] | None:
    count = 12 * nside ** 2
    for name, variable in dataset.variables.items():
        named = str(name) in (dim, "cell", "cell_ids", "healpix_index", "pixel", "ipix") or variable.attrs.get("standard_name") == "healpix_index"
        if named and variable.dims == (dim,) and variable.dtype.kind in "iuf":
            numbers = np.asarray(variable.values)
            if np.isfinite(numbers).all() and np.all(numbers % 1 == 0) and len(np.unique(numbers)) == len(numbers) and 0 <= numbers.min() and numbers.max() < count:
                return nside, nested, None if len(numbers) == count and np.all(np.diff(numbers) == 1) else numbers.astype(int)
    return (nside, nested, None) if count == dataset.sizes[dim] else None


def _interleaved(index: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    x, y = np.zeros_like(index), np.zeros_like(index)
    for bit in range(30):
        x |= ((index >> (2 * bit)) & 1) << bit
        y |= ((index >> (2 * bit + 1)) & 1) << bit
    return x, y


def _on_sphere(face: np.ndarray, x: np.ndarray, y: np.ndarray, nside: int) -> np.ndarray:
    """Unit vectors of positions x, y on the faces, real numbers from 0 to nside."""
    row, column = np.array([2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4])[face], np.array([1, 3, 5, 7, 0, 2, 4, 6, 1, 3, 5, 7])[face]
    ring = row - (x + y) / nside
    north, south = ring < 1, ring > 3
    width = np.where(north, ring, np.where(south, 4 - ring, 1.0))
    z = np.where(north, 1 - width ** 2 / 3, np.where(south, width ** 2 / 3 - 1, (2 - ring) * 2 / 3))
    with np.errstate(divide="ignore", invalid="ignore"):
        turn = np.pi / 4 * np.where(width > 0, (column * width + (x - y) / nside) / width, 0.0)
    flat = np.sqrt(np.maximum(0, 1 - z ** 2))
    return np.stack([flat * np.cos(turn), flat * np.sin(turn), z], -1)


def _pixels(nside: int, nested: bool, numbers: np.ndarray | None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    index = numbers if nested and numbers is not None else np.arange(12 * nside ** 2)
    face, (x, y) = index // nside ** 2, _interleaved(index % nside ** 2)
    if not nested:  # rings from north to south, each eastward from longitude 0
        centre = _on_sphere(face, x + 0.5, y + 0.5, nside)
        ring = (np.array([2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4])[face] * nside - x - y)
        order = np.lexsort((np.round(np.mod(np.arctan2(centre[:, 1], centre[:, 0]), 2 * np.pi), 9) % round(2 * np.pi, 9), ring))
        order = order if numbers is None else order[numbers]
        face, x, y = face[order], x[order], y[order]
    return face, x, y


def healpix_corners(nside: int, nested: bool, numbers: np.ndarray | None = None) -> np.ndarray:
    face, x, y = _pixels(nside, nested, numbers)
    return np.stack([_on_sphere(face, x + dx, y + dy, nside) for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1))], 1)


def healpix_centres(nside: int, nested: bool, numbers: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Longitudes and latitudes in degrees."""
    face, x, y = _pixels(nside, nested, numbers)
    centre = _on_sphere(face, x + 0.5, y + 0.5, nside)
    return np.mod(np.degrees(np.arctan2(centre[:, 1], centre[:, 0])), 360), np.degrees(np.arcsin(centre[:, 2]))
