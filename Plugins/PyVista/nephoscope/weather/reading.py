# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The meaning of a dataset: which dimensions are time, levels and horizontal, and which variable has which role."""
from __future__ import annotations

import warnings
from collections import Counter
from functools import cached_property

import numpy as np

from .._checks import listed
from .._pipeline import level_of_caller
from .dates import date_of
from .horizontal import GridError, find_horizontal, is_latitude, is_longitude
from .helpers import helpers
from .land import SEA_MASKS, zeros_of_land
from .prepare import prepared
from .roles import FIELDS, ROLES, SURFACE, candidates, quantity_of
from .stagger import centres_of, is_staggered, shares_axes, to_centres
from .times import choose_time, is_member, time_dims
from .units import CHECKED, UnitsError, better_units, converted, in_fractions, knows, plain, says_fraction, without_fill_values
from .vertical import VerticalError, find_lengths, find_vertical, is_layer, is_other_axis, level_values, pressure_of_level

OTHER_HORIZONTAL = ("surface", "hybrid", "sigma", "unknown")  # typeOfLevel of variables on the ground; lnsp is said to be on a hybrid level

UNDECLARED = np.array([-9999.0, -99999.0, -999.0, -32767.0, -32768.0])  # fill values that a file does not declare, impossible in the air
LEAST_PERCENT, MOST_PERCENT = 1.5, 101.0  # greatest values of cloud fractions that are percent
PLACING = {"altitude", "thickness", "geopotential_height", "geopotential", "pressure", "pressure_thickness", "surface_pressure", "log_surface_pressure", "terrain",
           "surface_geopotential", "w"}  # roles whose units must be right in any picture; the wind along z says itself when it is left out
HUMIDITY = ("specific_humidity", "mixing_ratio", "relative_humidity")
KINDS = "fiubm"  # of arrays that can be fields: numbers, booleans and durations


def _numbers(values: np.ndarray) -> np.ndarray:
    """Values as floating-point numbers; durations, such as wave periods, in seconds."""
    values = np.asarray(values)
    if values.dtype.kind == "m":
        return np.where(np.isnat(values), np.nan, values / np.timedelta64(1, "s"))
    return values if values.dtype.kind == "f" and values.dtype.itemsize >= 4 else values.astype(np.float32)


def _are_apart(here: np.ndarray, there: np.ndarray) -> bool:
    """Whether two sorted axes are different selections of levels; see `_is_apart`."""
    if here.size == there.size and np.allclose(here, there, 1e-5, 0):
        return False
    return bool(np.isclose(here[:, None], there, 1e-5, 0).any() or np.any(np.diff(np.searchsorted(here, there)) != 1))


def refuse_empty(dataset) -> None:
    largest = max(dataset.data_vars.values(), key=lambda variable: variable.ndim, default=None)
    empty = [str(dim) for dim in dataset.sizes if dataset.sizes[dim] == 0 and largest is not None and dim in largest.dims]
    if empty:
        raise GridError(f"The selection is empty: {listed(empty)} {'has' if len(empty) == 1 else 'have'} no entry. A slice must run in the direction of its axis: "
                        "from the smaller to the greater value where the axis increases, and the other way where it decreases, as latitudes and pressures often do.")


class Reading:
    """One time of a dataset. Values are loaded on demand and converted to the units of `units.py`."""

    def __init__(self, dataset, *, time=None, vertical: str | None = None, names: dict | None = None) -> None:
        self.notes: list[str] = []
        self._apart: dict[str, bool] = {}  # see _is_apart
        self._checked: set[str] = set()  # names whose units have been looked at
        self.unusable: dict[str, str] = {}  # role -> the problem with the units of its variable
        refuse_empty(dataset)
        self.times = time_dims(dataset)
        self.dataset, self.time_text = choose_time(dataset, self.times, time)
        self._of_one_time = self.dataset
        self.dataset, fractions = in_fractions(prepared(self._one_member(self._without_single(self.dataset))))
        self.notes += fractions
        self.helpers = helpers(self.dataset)
        self._asked = {role: name for role, name in (names or {}).items() if name is not None}
        self._check_asked()
        self._find_levels(vertical)
        self._find_grid()
        self._remove_levels_of_the_ground()
        self.roles = {role.name: found for role in FIELDS + SURFACE if (found := self._find(role))}
        self.elsewhere = {role: name for role in HUMIDITY + ("temperature", "potential_temperature") if role not in self.roles and (name := self._on_another_axis(ROLES[role]))}
        self._use_common_levels()
        self._air_roles = {name for role, name in self.roles.items() if not {"height", "geopotential"} & set(ROLES[role].quantities)}

    # Dimensions

    def _without_single(self, dataset):
        """Removes dimensions of length one that carry no information, such as a single member; columns and rows of one point stay."""
        alone = [dim for dim, size in dataset.sizes.items() if size == 1 and dim in ("number", "realization", "ensemble", "member", "step", "time", "Time", "valid_time",
                                                                                      "forecast_reference_time", "surface", "expver")]
        return dataset.isel({dim: 0 for dim in alone})

    def _one_member(self, dataset):
        """The first of several forecasts, with a warning, as for several times."""
        several = [dim for dim in dataset.sizes if is_member(dataset, str(dim))]
        for dim in (dim for dim in several if dataset.sizes[dim] > 1):
            self.warn(f"{dim!r} has {dataset.sizes[dim]} entries; the first was taken. Choose one: ds.isel({dim}=0).")
        return dataset.isel({dim: 0 for dim in several})

    def _numbers(self, variables):
        """Those that can be fields, without those that only describe the cells."""
        return [(str(name), variable) for name, variable in variables.items() if variable.dtype.kind in KINDS and variable.ndim and name not in self.helpers]

    def _find_levels(self, asked: str | None) -> None:
        several = [variable for _, variable in self._numbers(self.dataset.data_vars) if variable.ndim > 1]
        dims = Counter(dim for variable in several or [variable for _, variable in self._numbers(self.dataset.data_vars)] for dim in variable.dims)
        if not dims:
            raise GridError(f"No variable of the dataset is a numeric field. The variables are: {listed([str(name) for name in self.dataset.variables])}.")
        self.vertical = None
        ranked = sorted(dims, key=lambda dim: (-dims[dim], -self.dataset.sizes[dim]))
        scored = [dim for dim in ranked if find_vertical(self.dataset, [dim], None) and not self._is_horizontal(dim)]
        if asked is not None:
            self.vertical = find_vertical(self.dataset, list(map(str, dims)), asked)
        elif scored:
            best = max(scored, key=lambda dim: (self.dataset.sizes[dim] > 1, dims[dim], self.dataset.sizes[dim]))
            full = [dim for dim in scored if self.dataset.sizes[dim] == self.dataset.sizes[best] - 1 and dims[dim] == dims[best]]  # between half levels
            self.vertical = find_vertical(self.dataset, full[:1] or [best], None)
            if self.vertical.kind == "levels" and self.dataset.sizes[self.vertical.dim] == 1:  # a level without information
                self.dataset, self.vertical = self.dataset.isel({self.vertical.dim: 0}), None
        elif len(lengths := find_lengths(self.dataset, [str(dim) for dim in dims if not self._is_horizontal(dim)])) == 1:
            self.vertical = find_vertical(self.dataset, lengths, lengths[0])
        elif (dim := self._dim_of_heights(list(map(str, dims)))) is not None:
            self.vertical = find_vertical(self.dataset, [dim], dim)
        elif layers := [str(dim) for dim in dims if is_layer(str(dim)) and not self._is_horizontal(dim)]:
            for dim in layers:
                self._take_layer(dim)
        elif any(variable.ndim > 2 and not all(map(self._is_horizontal, variable.dims)) for _, variable in self._numbers(self.dataset.data_vars)):
            raise VerticalError(f"No vertical axis was found among the dimensions {listed([str(dim) for dim in dims])}: none has axis 'Z', positive up or down, a standard_name of "
                                "levels, units of pressure or length, a GRIB type of level or a usual name. Name it, globe(vertical='...'), or choose one index along the "
                                "dimension that is not vertical: "
                                f"ds.isel({self._unplaced(dims)}=0). If the axes are lengths, the data are flat: ds.nephoscope.grid(x='...', y='...', z='...').")

    def _take_layer(self, dim: str) -> None:
        """Takes the first layer that has values. Layers of this kind may overlap, so they are no axis."""
        size, axis = self.dataset.sizes[dim], self.dataset.variables.get(dim)
        fields = [variable for _, variable in self._numbers(self.dataset.data_vars) if dim in variable.dims]
        first = next((i for i in range(size) if any(np.isfinite(_numbers(field.isel({dim: i}).values)).any() for field in fields)), 0)
        value = None if axis is None else axis.values[first]
        told = "" if axis is None else f" ({value:g})" if axis.dtype.kind in "iuf" else f" ({value})"
        if size > 1:
            self.warn(f"{dim!r} has {size} layers, which may overlap. The first with values is used, number {first}{told}. Choose one: ds.isel({dim}={first}).")
        self.dataset = self.dataset.isel({dim: first})

    def _dim_of_heights(self, dims: list[str]) -> str | None:
        """The dimension along which the heights or pressures of all points increase, or all decrease; None if there is none."""
        for role in ("altitude", "geopotential_height", "pressure"):
            for name in candidates(ROLES[role], ((str(name), variable) for name, variable in self.dataset.variables.items() if variable.ndim > 1 and variable.dtype.kind in "fiu")):
                others = [dim for dim in self.dataset[name].dims if dim in dims and not self._is_horizontal(dim)]
                if len(others) == 1 and self.dataset.sizes[others[0]] > 1:
                    steps = np.diff(np.asarray(self.dataset[name].values, float), axis=self.dataset[name].get_axis_num(others[0]))
                    steps = steps[np.isfinite(steps)]
                    if steps.size and ((steps > 0).all() or (steps < 0).all()):
                        self.note(f"{others[0]!r} is vertical: {name!r} {'increases' if steps[0] > 0 else 'decreases'} along it")
                        return others[0]
        return None

    def _unplaced(self, dims) -> str:
        return next((str(dim) for dim in dims if not self._is_horizontal(dim)), "level")

    def _is_horizontal(self, dim: str) -> bool:
        return any(dim in variable.dims for name, variable in self.dataset.variables.items()
                   if variable.attrs.get("cf_role") == "face_node_connectivity" or is_longitude(str(name), variable) or is_latitude(str(name), variable))

    def _find_grid(self) -> None:
        level = {self.vertical.dim} if self.vertical else set()
        shapes = Counter(tuple(dim for dim in variable.dims if dim not in level) for _, variable in self._numbers(self.dataset.data_vars) if level <= set(variable.dims))
        if not level and any(len(dims) > 1 for dims in shapes):
            shapes = Counter({dims: count for dims, count in shapes.items() if len(dims) > 1})
        shapes = Counter({dims: count for dims, count in shapes.items() if dims}) or shapes
        centres = centres_of(self.dataset, shapes)
        if centres is not None:
            self.horizontal, self.example = find_horizontal(self.dataset, self.dataset[centres], level), centres
            return
        dims = max(shapes, key=lambda dims: (shapes[dims], -sum(is_staggered(dim) for dim in dims)))
        name = next(name for name, variable in self._numbers(self.dataset.data_vars) if level <= set(variable.dims) and tuple(dim for dim in variable.dims if dim not in level) == dims)
        self.horizontal = find_horizontal(self.dataset, self.dataset[name], level)
        self.example = name

    def _remove_levels_of_the_ground(self) -> None:
        """Removes the separate levels that fields at the ground have in some files, such as height0 of length one."""
        kept = {*self.horizontal.dims, *([self.vertical.dim] if self.vertical else [])}
        alone = [dim for dim, size in self.dataset.sizes.items() if size == 1 and dim not in kept]
        found = {dim: find_vertical(self.dataset, [dim], None) for dim in alone}
        self.dataset = self.dataset.isel({dim: 0 for dim, vertical in found.items() if vertical is None or vertical.kind.startswith(("height", "depth", "levels"))})

    # Roles

    def _check_asked(self) -> None:
        for role, name in self._asked.items():
            if name is not False and name not in self.dataset.variables:
                raise ValueError(f"{role}: no variable {name!r}. There are: {listed([str(known) for known in self.dataset.data_vars])}.")

    def _find(self, role) -> str | None:
        if role.name in self._asked:
            return self._asked[role.name] or None
        pool = self.field_variables() if role in FIELDS else self.ground_variables()
        names = candidates(role, pool)
        return next((name for name in names if quantity_of(role, self.dataset[name])), names[0] if names else None)

    def _on_another_axis(self, role) -> str | None:
        """The variable with the role that has its own levels."""
        if self.vertical is None or role.name in self._asked:
            return None
        wanted = {*self.horizontal.dims}
        pool = [(name, variable) for name, variable in self._numbers(self.dataset.variables) if variable.ndim == len(wanted) + 1 and wanted < set(variable.dims) and not self._is_field(variable)]
        return next(iter(candidates(role, pool)), None)

    def axis_of_variable(self, name: str) -> str:
        """The first dimension of a variable that does not belong to the horizontal grid."""
        return next(str(dim) for dim in self.dataset[name].dims if dim not in self.horizontal.dims)

    def _use_common_levels(self) -> None:
        """Humidity on another axis of the same kind, as on fewer pressures, is used at the levels that both axes have. The variable itself stays as it is."""
        for role, name in self.elsewhere.items():
            dim = self.axis_of_variable(name)
            other = find_vertical(self.dataset, [dim], None)
            if role not in HUMIDITY or other is None or other.kind != self.vertical.kind or not other.kind.startswith(("pressure", "height")):
                continue
            here, there = self.levels(), level_values(self.dataset, other)
            near = np.abs(here[:, None] - there).argmin(axis=1)
            common = np.isclose(here, there[near], 1e-5, 0)
            if not common.any():
                continue
            field = self.dataset[name].isel({dim: near}).drop_vars(dim, errors="ignore").rename({dim: self.vertical.dim})
            levels = type(field)(common, dims=[self.vertical.dim])
            made = f"{name} on {self.vertical.dim}"
            self.dataset = self.dataset.assign({made: field.where(levels).assign_attrs(self.dataset[name].attrs)})
            self.helpers.add(made)
            self.roles[role] = made
            self.note(f"{name!r} is on {dim!r}, and most variables are on {self.vertical.dim!r}: it is used at the levels that both have, {common.sum()} of {common.size}")

    def field_variables(self):
        """Variables on levels, including staggered ones."""
        return [(name, variable) for name, variable in self._numbers(self.dataset.variables) if self._is_field(variable)]

    def _is_field(self, variable) -> bool:
        if self.vertical is None:
            rest = [dim for dim in variable.dims if dim not in self.horizontal.dims]
            return set(self.horizontal.dims) <= set(variable.dims) or (
                variable.ndim == len(self.horizontal.dims) and shares_axes(variable.dims, self.horizontal.dims) and all(is_staggered(dim) and self._staggers(dim, variable.dims) for dim in rest))
        rest = [dim for dim in variable.dims if dim not in self.horizontal.dims and dim != self.vertical.dim]
        return variable.ndim == 1 + len(self.horizontal.dims) and len(rest) < variable.ndim and all(
            self._staggers(dim, variable.dims) for dim in rest) and (self.vertical.dim in variable.dims or any(self._near(dim, self.vertical.dim) for dim in rest))

    def _staggers(self, dim, dims) -> bool:
        """True if `dim` can stand for a grid dimension that is missing in `dims`."""
        missing = [own for own in (*self.horizontal.dims, *([self.vertical.dim] if self.vertical else [])) if own not in dims]
        return any(self._near(dim, own) for own in missing)

    def _near(self, dim, own) -> bool:
        if abs(self.dataset.sizes[dim] - self.dataset.sizes[own]) > 1:
            return False
        return self.vertical is None or own != self.vertical.dim or dim == own or not (is_other_axis(str(dim), str(own)) or self._is_apart(str(dim)))

    def _is_apart(self, dim: str) -> bool:
        """Whether an axis of pressures or heights is another selection of levels: neither those of the vertical axis nor, like half levels, one between each two of them."""
        if dim not in self._apart:
            other = find_vertical(self.dataset, [dim], None) if dim in self.dataset.variables else None
            alike = other is not None and other.kind == self.vertical.kind and other.kind.startswith(("pressure", "height"))
            self._apart[dim] = alike and _are_apart(np.sort(self.levels()), np.sort(level_values(self.dataset, other)))
        return self._apart[dim]

    def ground_variables(self):
        return [(name, variable) for name, variable in self._numbers(self.dataset.variables) if set(variable.dims) == set(self.horizontal.dims)
                and variable.attrs.get("GRIB_typeOfLevel", "surface") in OTHER_HORIZONTAL]

    def plain_variables(self) -> list[str]:
        """Variables exactly on the grid's points, which are used unchanged; staggered ones where there are no others and no winds of both."""
        wanted = set(self.horizontal.dims) | ({self.vertical.dim} if self.vertical else set())
        coordinates = {*self.horizontal.names, *self.dataset.dims}
        found = [name for name, variable in self._numbers(self.dataset.variables) if set(variable.dims) == wanted and name not in coordinates]
        return found or [name for name, _ in self.field_variables() if name not in self.dataset.coords and not self.has_winds()]

    # Values

    def has(self, role: str) -> bool:
        """True if a variable has this role. One that was found, not asked for, is left out with a note if its units cannot be converted."""
        if role not in self.roles or role in self.unusable:
            return False
        problem = "" if role in PLACING or self._asked.get(role) else self._problem(role)
        if problem:
            self.unusable[role] = problem
            self.note(f"{self.roles[role]!r} is left out. {problem}")
        return not problem

    def has_winds(self) -> bool:
        """True if there is a wind along the ground. A single component is drawn like any other field."""
        return {"u", "v"} <= set(self.roles) and all([self.has("u"), self.has("v")])

    def _problem(self, role: str) -> str:
        """What is wrong with the units of a role, "" if they can be converted. Values are loaded only where there are no units."""
        variable = self.dataset[self.roles[role]]
        if plain(variable.attrs.get("units")) and knows(variable.attrs["units"], quantity_of(ROLES[role], variable) or ROLES[role].quantities[0]):
            return ""
        try:
            self.role_as(role)
        except UnitsError as problem:
            return str(problem)
        return ""

    def refuse_unusable(self, *roles: str) -> None:
        """Raises UnitsError for the first of these roles whose variable is left out."""
        problem = next((self.unusable[role] for role in roles if role in self.roles and not self.has(role)), None)
        if problem:
            raise UnitsError(problem)

    def values(self, name: str) -> np.ndarray:
        """Values with the available dimensions of (levels, rows, columns), at the centres, in the units of the file."""
        array = without_fill_values(self.dataset[name])
        wanted = [dim for dim in ((self.vertical.dim,) if self.vertical else ()) + self.horizontal.dims]
        array, note = to_centres(self.dataset, array, wanted)
        self.note(note)
        order = [dim for dim in wanted if dim in array.dims]
        found = self._placed(_numbers(array.transpose(*order).values), order)
        gone = np.abs(found) > 1e30
        if name in self._air_roles:
            undeclared = np.isin(found, UNDECLARED)
            self.note(f"{name!r}: {undeclared.sum()} values of {found[undeclared][0]:g} are taken as missing" if undeclared.any() else "")
            gone |= undeclared
        self._look_at_units(name, found[~gone])
        land = self._land_of_mask(name, found)
        return self._in_fractions(name, np.where(gone | (self._zeros_of_land(name, found) if land is None else land), np.nan, found))

    def _look_at_units(self, name: str, found: np.ndarray) -> None:
        """Warns once of units that the values contradict. They are used as they are stated."""
        units = self.dataset[name].attrs.get("units")
        role = next((role for role in CHECKED if self.roles.get(role) == name and name not in self._checked), None)
        if role is None:
            return
        self._checked.add(name)
        if (better := better_units(found, units, role)) is not None:
            self.warn(f"{name!r} has the units {units!r}, but values from {np.nanmin(found):.4g} to {np.nanmax(found):.4g}, which are not plausible for {ROLES[role].meaning} in these units: they seem to be in {better}. "
                      f"Set its units: ds[{name!r}].attrs['units'] = {better!r}.")

    @cached_property
    def fractions(self) -> list[str]:
        """Cloud fractions whose units say that they are fractions of 1."""
        return [name for name in candidates(ROLES["cloud_fraction"], self._numbers(self.dataset.variables)) if says_fraction(self.dataset[name].attrs.get("units"))]

    def _in_fractions(self, name: str, found: np.ndarray) -> np.ndarray:
        """Cloud fractions that are percent in spite of their units are divided by 100, with a warning."""
        if name not in self.fractions or not LEAST_PERCENT < (most := float(np.nanmax(found, initial=0))) < MOST_PERCENT:
            return found
        text = f"{name!r} has the units {self.dataset[name].attrs['units']!r}, but values up to {most:.4g}: they are taken as percent. Set its units: ds[{name!r}].attrs['units'] = '%'."
        if text not in self.notes:
            self.warn(text)
        return found * found.dtype.type(0.01)

    def _land_of_mask(self, name: str, found: np.ndarray) -> np.ndarray | None:
        """Where the model's own mask of the sea is 0, in fields on levels that do not show where the sea is; None without a mask."""
        mask = next((mask for mask in SEA_MASKS if mask in self.dataset.variables and mask != name), None)
        if mask is None or self.vertical is None or found.ndim != 1 + len(self.horizontal.shape) or set(self.dataset[mask].dims) != set(self.horizontal.dims):
            return None
        if name in {self.roles.get(role) for role in PLACING - {"w"}}:
            return None
        land = self.values(mask) == 0
        self.note(f"land is where {mask!r} is 0: nothing is drawn there" if land.any() else "")
        return np.broadcast_to(land, found.shape)

    def _zeros_of_land(self, name: str, found: np.ndarray) -> np.ndarray | bool:
        on_levels = self.vertical is not None and self.vertical.dim in self.dataset[name].dims
        zeros = zeros_of_land(name, self.dataset[name], found, on_levels, top_first=on_levels and self._top_first())
        if zeros is None:
            return False
        self.warn(f"{name!r}: {zeros.sum()} values of exactly 0, {100 * zeros.mean():.0f} % of all, are taken as land and sea floor, and are missing. If they are values, "
                  f"declare a fill value that does not occur: ds[{name!r}].attrs['_FillValue'] = 1e20.")
        return zeros

    def _top_first(self) -> bool:
        """Whether the levels run downwards from the surface."""
        levels = self.levels()
        return bool(levels[0] > levels[-1] or self.vertical.kind == "levels")

    def _placed(self, found: np.ndarray, order: list[str]) -> np.ndarray:
        """Values of the file, arranged in the rows and columns that `horizontal` made from its points."""
        grid = self.horizontal
        if grid.rows is not None and grid.dims[0] in order:
            return grid.rows(found)
        if len(grid.dims) == 3 and grid.dims[0] in order:
            return found.reshape(*found.shape[:-3], -1)
        if grid.lines is not None and grid.dims[0] in order:
            found = found.take(grid.lines, order.index(grid.dims[0]))
        found = found.take(grid.columns, -1) if grid.columns is not None and grid.dims[-1] in order else found
        found = grid.fold(found) if grid.fold and set(grid.dims) <= set(order) else found
        found = grid.caps(found) if grid.caps and set(grid.dims) <= set(order) else found
        return np.where(grid.missing, np.nan, found) if grid.gaps and set(grid.dims) <= set(order) else found

    def role(self, role: str) -> np.ndarray:
        return self.role_as(role)[0]

    def role_as(self, role: str) -> tuple[np.ndarray, str]:
        """The values of a role, and the quantity that they have."""
        name = self.roles[role]
        quantity = quantity_of(ROLES[role], self.dataset[name]) or ROLES[role].quantities[0]
        values, note = converted(self.values(name), self.dataset[name].attrs.get("units"), quantity, name)
        self.note(note)
        return values, quantity

    @cached_property
    def date(self) -> str | None:
        """``YYYY-MM-DD HH:MM`` (UTC) of the time step; None if the dataset has no dates."""
        return date_of(self._of_one_time, self.times)

    @cached_property
    def level_pressure(self) -> float | None:
        """Pa, of fields of one level without a vertical axis; None if it is unknown."""
        return pressure_of_level(self.dataset) if self.vertical is None else None

    def levels(self) -> np.ndarray:
        found = level_values(self.dataset, self.vertical)
        return found

    def note(self, text: str) -> None:
        if text and text not in self.notes:
            self.notes.append(text)

    def warn(self, text: str) -> None:
        self.note(text)
        warnings.warn(text, UserWarning, stacklevel=level_of_caller())
