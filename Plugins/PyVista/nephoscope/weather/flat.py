# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Datasets on a flat grid: x, y and z are lengths, as in large-eddy simulations and cloud-resolving models, and not positions on the Earth."""
from __future__ import annotations

import re
import warnings
from collections import Counter
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .._checks import listed
from .._pipeline import level_of_caller
from .helpers import helpers
from .horizontal import GridError, is_latitude, is_longitude
from .projections import find_lost_projection, mapping_of
from .reading import KINDS, refuse_empty
from .roles import ROLES, candidates, quantity_of
from .times import choose_time, is_member, time_dims
from .units import UNITS, in_fractions, plain, without_fill_values
from .vertical import DEPTHS, HEIGHTS, find_lengths, is_depth

LENGTHS = UNITS["height"][1]
_USUAL = re.compile(r"([xyz])[a-z]?")  # x, xt, xm, xh, xf, xc, xu, zn: names of centres and of faces
_LONGER = re.compile(r"([xyz])[a-z]?([_\d]\w*)?")  # zu_3d, x_stag
_WORDS = {"x": ("east", "easting", "eastward", "west_east", "ni", "i"), "y": ("north", "northing", "south_north", "nj", "j"),
          "z": (*HEIGHTS, "height", "altitude", "lev", "level", "levels", "depth", "bottom_top", "vertical", "nk", "k")}


@dataclass
class Axis:
    """One axis of a flat grid. `order`: the entries of the file from the lowest value to the highest, each once."""
    dim: str
    name: str  # of the coordinate, "" if there is none
    values: np.ndarray  # m
    order: np.ndarray
    note: str = ""

    @property
    def step(self) -> float | None:
        """The spacing if it is even, otherwise None."""
        if len(self.values) < 2:
            return 0.0
        step = float(self.values[-1] - self.values[0]) / (len(self.values) - 1)
        even = self.values[0] + step * np.arange(len(self.values))
        rounding = 4e-7 * np.abs(self.values).max()  # of files in single precision
        return step if np.abs(self.values - even).max() <= max(1e-3 * step, rounding) else None


def _coordinates(dataset, dim: str) -> list:
    """Numeric variables along this dimension only; that with its name comes first."""
    variables = dataset.variables  # `dataset[name]` looks at all coordinates, which takes long in files of many variables
    names = [dim] * (dim in variables) + [name for name in variables if name != dim and variables[name].dims == (dim,)]
    return [dataset[name] for name in names if variables[name].dtype.kind in "fiu"]


def _letter(dim: str, coordinate) -> str | None:
    """x, y or z; None if nothing says which."""
    attrs = {} if coordinate is None else coordinate.attrs
    if str(attrs.get("axis", "")).lower() in ("x", "y", "z"):
        return str(attrs["axis"]).lower()
    standard = str(attrs.get("standard_name", ""))
    if standard in ("projection_x_coordinate", "projection_y_coordinate"):
        return standard[11]
    if attrs.get("positive") in ("up", "down") or standard in ("height", "altitude", "depth", "height_above_mean_sea_level"):
        return "z"
    for name in (dim, "" if coordinate is None else str(coordinate.name)):
        if (found := _LONGER.fullmatch(name.lower())) is not None:
            return found[1]
    return next((letter for letter, words in _WORDS.items() if dim.lower() in words), None)


def _is_length(coordinate) -> bool:
    return plain(coordinate.attrs.get("units")) in LENGTHS


def _length_of(dataset, dim: str):
    """The letter of a dimension of lengths and its coordinate, None if it has none. None alone if it is no length."""
    found = _coordinates(dataset, dim)
    for coordinate in found:
        if _is_length(coordinate) and (letter := _letter(dim, coordinate)):
            return letter, coordinate
    usual = "z" if DEPTHS.fullmatch(dim.lower()) else _USUAL.sub(r"\1", dim.lower()) if _USUAL.fullmatch(dim.lower()) else None
    if usual is None or any(plain(coordinate.attrs.get("units")) for coordinate in found if coordinate.name == dim):
        return None
    return usual, next((coordinate for coordinate in found if coordinate.name == dim), None)


def fields_of(dataset) -> list[tuple[str, object]]:
    """Numeric variables of two or three dimensions besides times and members."""
    other = _other_dims(dataset)
    known = helpers(dataset)
    return [(str(name), variable) for name, variable in dataset.data_vars.items()
            if variable.dtype.kind in KINDS and name not in known and len(set(variable.dims) - other) >= 2]


def _other_dims(dataset) -> set[str]:
    return {*time_dims(dataset), *(str(dim) for dim in dataset.sizes if is_member(dataset, str(dim)))}


def is_flat(dataset) -> bool:
    """True if the horizontal axes of the fields are lengths, and no longitude, latitude or projection places them on the Earth."""
    other = _other_dims(dataset)
    lengths = {str(dim): _length_of(dataset, str(dim)) for dim in dataset.sizes if dim not in other}
    for name, variable in fields_of(dataset):
        dims = [str(dim) for dim in variable.dims if dim not in other]
        letters = [found[0] for dim in dims if (found := lengths[dim])]
        if len(set(letters)) < 2 or len(set(letters)) < len(letters):
            continue
        if mapping_of(dataset, variable) or variable.attrs.get("grid_mapping") or find_lost_projection(dataset, variable, dims)[0]:
            return False
        on_earth = any(is_longitude(str(its), coordinate) or is_latitude(str(its), coordinate) for its, coordinate in dataset.variables.items()
                       if set(coordinate.dims) & set(dims))
        return not on_earth and not any(str(coordinate.attrs.get("standard_name", "")).startswith(("projection_", "grid_l"))
                                        for dim in dims for coordinate in _coordinates(dataset, dim))
    return False


class Flat:
    """One time of a dataset on a flat grid: its axes x, y and z, and its fields. Values are loaded on demand.

    `names`: coordinates or dimensions that the caller says are x, y and z.
    """

    def __init__(self, dataset, *, time=None, variables=None, names: dict[str, str | None] | None = None) -> None:
        self.notes: list[str] = []
        refuse_empty(dataset)
        self.dataset, self.time_text = choose_time(dataset, time_dims(dataset), time)
        for dim in [str(dim) for dim in self.dataset.sizes if is_member(self.dataset, str(dim))]:
            if self.dataset.sizes[dim] > 1:
                self.warn(f"{dim!r} has {self.dataset.sizes[dim]} entries; the first was taken. Choose one: ds.isel({dim}=0).")
            self.dataset = self.dataset.isel({dim: 0})
        self.dataset = self.dataset.isel({dim: 0 for dim, size in self.dataset.sizes.items() if size == 1 and not _length_of(self.dataset, str(dim))})
        self.dataset, fractions = in_fractions(self.dataset)
        self.notes += fractions
        self._asked = {letter: name for letter, name in (names or {}).items() if name is not None}
        dims = self._dims([variables] if isinstance(variables, str) else variables)
        self.axes = {letter: self._axis(letter, *found) for letter, found in dims.items()}
        self._warn_of_degrees()

    def warn(self, text: str) -> None:
        self.notes.append(text)
        warnings.warn(text, UserWarning, stacklevel=level_of_caller())

    def _dims(self, wanted) -> dict[str, tuple[str, object]]:
        """The dimensions of the `wanted` variables, otherwise those that most fields of the highest dimension have, by their letters."""
        fields = fields_of(self.dataset)
        missing = [name for i, name in enumerate(wanted or []) if name not in dict(fields) and (i == 0 or name not in self.dataset.variables)]
        if missing:
            raise ValueError(f"variables: {listed(missing)} not among the fields of two or three dimensions: {listed([name for name, _ in fields])}.")
        fields = [(name, variable) for name, variable in fields if not wanted or name == wanted[0]]
        if not fields:
            raise GridError(f"No variable of the dataset is a numeric field of two or three dimensions. The variables are: {listed([str(name) for name in self.dataset.variables])}.")
        counts = Counter(frozenset(map(str, variable.dims)) for _, variable in fields)
        best = max(counts, key=lambda dims: (min(len(dims), 3), counts[dims]))
        name, variable = next((name, variable) for name, variable in fields if set(variable.dims) == best)
        return self._lettered(name, [str(dim) for dim in variable.dims])

    def _lettered(self, name: str, dims: list[str]) -> dict[str, tuple[str, object]]:
        found, rest = {}, []
        for letter, asked in self._asked.items():
            dim = self._dim_named(letter, asked, dims)
            found[letter] = dim, self.dataset[asked] if asked in self.dataset.variables else None
        taken = {dim for dim, _ in found.values()}
        for dim in [dim for dim in dims if dim not in taken]:
            letter, coordinate = _length_of(self.dataset, dim) or (None, None)
            if letter is None or letter in found:
                rest.append(dim)
            else:
                found[letter] = dim, coordinate
        if "z" not in found and {"x", "y"} <= set(found) and find_lengths(self.dataset, rest) == rest and len(rest) == 1:
            found["z"], rest = (rest[0], self.dataset[rest[0]]), []
        if rest:
            raise GridError(self._no_length(name, rest, found))
        return {letter: found[letter] for letter in "xyz" if letter in found}

    def _dim_named(self, letter: str, asked: str, dims: list[str]) -> str:
        dim = asked if asked in dims else next(iter(self.dataset[asked].dims), "") if asked in self.dataset.variables and self.dataset[asked].ndim == 1 else ""
        if dim not in dims:
            raise ValueError(f"{letter}: {asked!r} is neither one of the dimensions {listed(dims)} nor a coordinate along one of them.")
        return dim

    def _no_length(self, name: str, rest: list[str], found: dict) -> str:
        dim = rest[0]
        if len(found) == 3:
            axes = listed([dim for dim, _ in found.values()])
            return f"{name!r} has the dimension {dim!r} besides the axes {axes}. Choose an index along it, ds.isel({dim}=0), or say which three are axes, grid(x='...', y='...', z='...')."
        units = [f"{coordinate.name!r} ({coordinate.attrs['units']})" for coordinate in _coordinates(self.dataset, dim) if coordinate.attrs.get("units")]
        has = f", whose coordinate is {', '.join(units)}" if units else ""
        return (f"{name!r} has the dimension {dim!r}{has}, which is not known to be a length along x, y or z. Give a coordinate along it in metres, "
                f"ds.assign_coords({dim}=('{dim}', METRES, {{'units': 'm'}})), say which axis it is, grid(x='...', y='...', z='...'), or choose an index, ds.isel({dim}=0).")

    def _axis(self, letter: str, dim: str, coordinate) -> Axis:
        if coordinate is None:
            count = self.dataset.sizes[dim]
            return Axis(dim, "", np.arange(count, dtype=float), np.arange(count), f"{dim!r} has no coordinate: its points are 1 m apart")
        name, values, units = str(coordinate.name), np.asarray(coordinate.values, float), coordinate.attrs.get("units")
        if not np.isfinite(values).all():
            raise GridError(f"The coordinate {name!r} has missing values. Leave them out: ds.isel({dim}=numpy.isfinite(ds[{name!r}].values)).")
        if plain(units) and plain(units) not in LENGTHS:
            raise GridError(f"The coordinate {name!r} is in {units!r}, which is not a length. Give it in metres: ds[{name!r}].attrs['units'] = 'm', after converting the values.")
        note = "" if plain(units) else f"{name!r} has no units: its values are taken as metres"
        values = values * LENGTHS.get(plain(units), 1)
        down = letter == "z" and (coordinate.attrs.get("positive") == "down" or np.min(values, initial=0) >= 0 and (coordinate.attrs.get("standard_name") == "depth" or is_depth(self.dataset, coordinate)))
        values = -values if down else values
        values, order = np.unique(values, return_index=True)
        if len(order) < coordinate.size:
            self.warn(f"The coordinate {name!r} repeats values: each is used once, with the first of its entries, and {coordinate.size - len(order)} are left out.")
        return Axis(dim, name, values, order, note)

    def _warn_of_degrees(self) -> None:
        """Warns if x and y without units could be longitudes and latitudes."""
        x, y = self.axes.get("x"), self.axes.get("y")
        if x is None or y is None or not (x.note and y.note and x.name and y.name):
            return
        whole = all(np.array_equal(axis.values, np.arange(len(axis.values))) for axis in (x, y))
        if not whole and np.abs(y.values).max() <= 90 and -180 <= x.values[0] and x.values[-1] <= 360 and max(np.ptp(x.values), np.ptp(y.values)) > 2:
            self.warn(f"{x.name!r} and {y.name!r} have no units: their values are taken as metres. If they are kilometres or degrees, say so: "
                       f"ds[{x.name!r}].attrs['units'] = 'km' or 'degrees_east', ds[{y.name!r}].attrs['units'] = 'km' or 'degrees_north'.")

    def names(self) -> list[str]:
        """The fields on the grid, including those that are averaged to it from faces."""
        return [name for name, variable in fields_of(self.dataset) if self._fits(variable)]

    def winds(self) -> list[str | None]:
        """The variables of the wind along x, y and z; empty if one along the ground is missing."""
        fields = [(name, self.dataset[name]) for name in self.names()]
        found = [next((name for name in candidates(ROLES[role], fields) if quantity_of(ROLES[role], self.dataset[name]) == "speed"), None) for role in "uvw"]
        along = [name for letter, name in zip("xyz", found) if letter in self.axes and (letter != "z" or len(self.axes) == 2)]
        return found if None not in along else []

    @cached_property
    def profiles(self) -> dict[str, str]:
        """Role -> variable along z alone: the air of a base state, the same in every column."""
        if "z" not in self.axes or len(self.axes) < 2:
            return {}
        from .flat_air import air_roles
        own = {axis.name for axis in self.axes.values()} | helpers(self.dataset)
        along = [(str(name), variable) for name, variable in self.dataset.variables.items() if variable.dtype.kind in KINDS and name not in own and variable.ndim == 1
                 and (variable.dims[0] == self.axes["z"].dim or variable.dims[0] not in self._own() and self._of_faces(str(variable.dims[0])) == "z")]
        return air_roles(along)

    def left_out(self) -> list[str]:
        """Numeric variables that are neither on the grid nor profiles of its air."""
        used = {*self.names(), *self.profiles.values(), *(axis.name for axis in self.axes.values()), *helpers(self.dataset), *self.dataset.dims}
        return [str(name) for name, variable in self.dataset.data_vars.items() if variable.dtype.kind in KINDS and name not in used]

    def _own(self) -> set[str]:
        return {axis.dim for axis in self.axes.values()}

    def _fits(self, variable) -> bool:
        own = {axis.dim: letter for letter, axis in self.axes.items()}
        letters = [own.get(dim) or self._of_faces(str(dim)) for dim in variable.dims]
        return sorted(map(str, letters)) == sorted(self.axes)

    def _of_faces(self, dim: str) -> str | None:
        found = _length_of(self.dataset, dim)
        letter = found[0] if found else None
        return letter if letter in self.axes and abs(self.dataset.sizes[dim] - self.dataset.sizes[self.axes[letter].dim]) <= 1 else None

    def values(self, name: str) -> np.ndarray:
        """Values in the order z, y, x of the grid, upwards and with missing axes of length one."""
        from .stagger import to_centres
        if name in self.profiles.values():
            return self._profile(name)
        dims = [self.axes[letter].dim for letter in "zyx" if letter in self.axes]
        array, note = to_centres(self.dataset, without_fill_values(self.dataset[name]), dims)
        if note and note not in self.notes:
            self.notes.append(note)
        found = np.asarray(array.transpose(*dims).values)
        for place, letter in enumerate(letter for letter in "zyx" if letter in self.axes):
            found = found.take(self.axes[letter].order, place)
        return found.reshape([len(self.axes[letter].values) if letter in self.axes else 1 for letter in "zyx"])

    def _profile(self, name: str) -> np.ndarray:
        from .stagger import to_centres
        array, _ = to_centres(self.dataset, without_fill_values(self.dataset[name]), [self.axes["z"].dim])
        shape = [len(self.axes[letter].values) if letter in self.axes else 1 for letter in "zyx"]
        return np.broadcast_to(np.asarray(array.values)[self.axes["z"].order].reshape(-1, 1, 1), shape)
