# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The vertical dimension, the meaning of its levels, and the pressures from formula terms and GRIB keys."""
from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from .._checks import listed
from .units import UNITS, converted, knows, plain

OCEAN = ("ocean_sigma_coordinate", "ocean_s_coordinate_g1", "ocean_s_coordinate_g2")
HEIGHTS = ("alt", "altitudes", "alt_km", "altitude_km", "height_km", "heights", "hgt", "msl", "amsl", "asl", "agl")  # names of axes of heights besides height and altitude
_NAMES = ("lev", "level", "levels", "plev", "pressure", "pressure_level", "model_level", "model_level_number", "bottom_top", "bottom_top_stag", "hybrid", "z", "height", "altitude",
          "isobaric", "height_2", "nvertlevels", "nvertlevelsp1", "depth", "sigma", "ilev", "lev_2", "lv_isbl0", "level_pressure", "height_above_ground", "generalverticallayer", "s_rho", "s_w", "levels_number", "half_levels", "full_levels", "model_levels", "num_metgrid_levels", *HEIGHTS)
_ACROSS = re.compile(r"[xyij]|[xyn][a-z]?\d*|[xy]_?\w{0,3}|n[ij]|(\w+_)?(east|west|north|south|row|col|lon|lat)\w*|range|distance|along|across|wavelength|diameter|radius|size|bins?")
DEPTHS = re.compile(r"depths?(_?[tuvw])?(_\d+)?|dep|depth_(below_sea|of_level)|s[tw](_edges)?_ocean|olevel|nav_lev|gdep[tw](_\w+)?|elevation_below_sea_level")  # names of axes that point downwards
_SEA = re.compile(r"sea_water|^ocean_|sea_ice")  # standard names of fields of an ocean
SEA_PRESSURES = ("sea_water_pressure", "sea_water_pressure_due_to_sea_water")
_GRIB_KINDS = {"isobaricInhPa": "pressure", "isobaricInPa": "pressure", "hybrid": "hybrid", "sigma": "sigma", "heightAboveSea": "height", "heightAboveGround": "height above ground",
               "generalVerticalLayer": "levels", "generalVertical": "levels", "hybridLayer": "hybrid", "hybridHeight": "hybrid height",
               "hybridPressure": "hybrid"}
_FORMULAS = {"atmosphere_hybrid_sigma_pressure_coordinate": "hybrid", "atmosphere_sigma_coordinate": "sigma", "atmosphere_hybrid_height_coordinate": "hybrid height", "atmosphere_sleve_coordinate": "sleve",
             "atmosphere_ln_pressure_coordinate": "log pressure", **{name: "ocean sigma" for name in OCEAN}}


_LAYERS = re.compile(r"[a-z]\w*Layer")


def is_layer(dim: str) -> bool:
    """Whether a dimension is a type of level of GRIB that has layers above the ground, in the soil and the like, which may overlap and are no vertical axis."""
    return bool(_LAYERS.fullmatch(dim)) and dim not in _GRIB_KINDS


def is_other_axis(dim: str, own: str) -> bool:
    """Whether a dimension is a type of level of GRIB with another meaning than the vertical axis `own`, however many levels both have."""
    return (dim in _GRIB_KINDS or is_layer(dim)) and _GRIB_KINDS.get(dim) != _GRIB_KINDS.get(own)


class VerticalError(ValueError):
    """Levels that cannot be placed; the message names what was looked for and what the dataset has."""


@dataclass
class Vertical:
    """`kind`: pressure, height, height above ground, depth (below the sea), hybrid, sigma, hybrid height, sleve, ocean sigma or levels (numbers unrelated to heights)."""
    dim: str
    kind: str
    name: str  # of the coordinate, "" if the dimension has none
    notes: list[str] = field(default_factory=list)
    units: str | None = None  # where the coordinate has none


def find_vertical(dataset, dims: list[str], asked: str | None) -> Vertical | None:
    """The vertical among `dims`; None if there is none."""
    if asked is not None:
        if asked not in dims:
            raise VerticalError(f"vertical: no dimension {asked!r}. There are: {listed(dims)}.")
        return _judged(dataset, asked)
    scored = sorted(((_score(dataset, dim), -dataset.sizes[dim], dim) for dim in dims if _score(dataset, dim) is not None))
    return _judged(dataset, scored[0][2]) if scored else None


def _score(dataset, dim: str) -> int | None:
    variables = [coordinate for coordinate in _coordinates(dataset, dim)]
    for variable in variables:
        if variable.attrs.get("axis") == "Z" or variable.attrs.get("positive") in ("up", "down") or variable.attrs.get("standard_name") in (*_FORMULAS, "air_pressure", "altitude", "height", "depth"):
            return 0
    if dim in _GRIB_KINDS:
        return 1
    if any(plain(variable.attrs.get("units")) in UNITS["pressure"][1] for variable in variables if variable.name == dim or variable.name in dataset.coords):
        return 2
    return 3 if str(dim).lower() in _NAMES or DEPTHS.fullmatch(str(dim).lower()) or re.fullmatch(r"z_[twli](_top|_bot|_\d+m)?", str(dim).lower()) or _is_sigma(dataset, dim) or re.fullmatch(r"(height|lev|level|plev|isobaric|z|lv_\w+)_?\d*", str(dim).lower()) else None


def find_lengths(dataset, dims: list[str]) -> list[str]:
    """The dimensions whose own coordinate is a length and has no other meaning: heights, if nothing else is vertical."""
    return [dim for dim in dims if dim in dataset.variables and dataset[dim].dtype.kind in "fiu" and plain(dataset[dim].attrs.get("units")) and knows(dataset[dim].attrs["units"], "height")
            and not dataset[dim].attrs.get("standard_name") and str(dataset[dim].attrs.get("axis", "Z")).upper() == "Z" and not _ACROSS.fullmatch(str(dim).lower())]


def _coordinates(dataset, dim: str):
    """Variables along this dimension only; the one with its name comes first."""
    names = [dim] * (dim in dataset.variables) + [name for name in dataset.variables if name != dim and dataset[name].dims == (dim,)]
    return [dataset[name] for name in names if np.issubdtype(dataset[name].dtype, np.number)]


def _judged(dataset, dim: str) -> Vertical:
    for variable in _coordinates(dataset, dim):
        standard = variable.attrs.get("standard_name", "")
        if standard in _FORMULAS and (_terms(variable) or standard == "atmosphere_sigma_coordinate"):
            return Vertical(dim, _FORMULAS[standard], str(variable.name))
    if usual_terms(dataset, dim):
        return Vertical(dim, "ocean sigma", dim)
    if dim in _GRIB_KINDS:
        return Vertical(dim, _GRIB_KINDS[dim], dim)
    if (hybrid := _by_coefficients(dataset, dim)) is not None:  # also if the axis has units of pressure, as CESM's
        return hybrid
    for variable in _coordinates(dataset, dim):
        kind = _kind(dataset, variable)
        if kind:
            return Vertical(dim, kind, str(variable.name))
    if _is_sigma(dataset, dim):
        return Vertical(dim, "sigma", dim)
    return _by_values(dataset, dim) or Vertical(dim, "levels", dim if dim in dataset.variables else "")


def _is_sigma(dataset, dim: str) -> bool:
    """Fractions of the pressure at the ground, without formula terms, by the name of the axis or its units."""
    if dim not in dataset.variables or not re.fullmatch(r"sig(ma)?(_?lev(el)?s?)?\d*", dim.lower()) and plain(dataset[dim].attrs.get("units")) not in ("sigma_level", "sigma"):
        return False
    values = np.asarray(dataset[dim].values, float)
    return bool(values.size and np.all((values > 0) & (values <= 1)))


def _counts(variable) -> bool:
    """True for the numbers of levels under the name of a height, as ICON writes them ("generalized_height")."""
    if variable.attrs.get("standard_name") != "height":
        return False
    values = np.asarray(variable.values, float)
    whole = values.size > 2 and np.all(np.abs(np.diff(values)) == 1) and np.all(2 * values % 1 == 0)
    return "generalized" in str(variable.attrs.get("long_name", "")) or bool(whole and not plain(variable.attrs.get("units")))


def is_sea_pressure(variable) -> bool:
    """Pressures in decibars are those of an ocean, where 1 dbar is a depth of about 1 m."""
    units = plain(variable.attrs.get("units"))
    return variable.attrs.get("standard_name") in SEA_PRESSURES and knows(units, "pressure") or units in ("dbar", "dbars", "decibar", "decibars")


def is_depth(dataset, variable) -> bool:
    """Lengths that are counted downwards without the attribute positive: by their name or by what is on them, if none is negative."""
    units, dims = plain(variable.attrs.get("units")), set(variable.dims)
    if variable.attrs.get("positive") == "up" or units and not knows(units, "height") or not np.min(variable.values, initial=0) >= 0:
        return False
    if DEPTHS.fullmatch(str(variable.name).lower()) or units and re.search(r"\bdepth\b", str(variable.attrs.get("long_name", "")).lower()):
        return True
    if str(variable.name).lower().startswith(("z_t", "z_w")) and units.startswith(("cm", "centim")):  # the Parallel Ocean Program
        return True
    of_sea = any(dims <= set(field.dims) and _SEA.search(str(field.attrs.get("standard_name", ""))) for field in dataset.data_vars.values())
    return bool(units and of_sea and dims)


def _may_be_depth(variable) -> bool:
    """Whether nothing says that lengths are counted upwards."""
    told = " ".join(str(variable.attrs.get(key, "")) for key in ("standard_name", "long_name")) + f" {variable.name}"
    return "positive" not in variable.attrs and not re.search(r"height|altitude|elevation|\b(alt|hgt|agl|msl)", told.lower())


def _kind(dataset, variable) -> str | None:
    standard, units = variable.attrs.get("standard_name", ""), variable.attrs.get("units")
    if _counts(variable) or _is_reference(variable):
        return None
    if is_sea_pressure(variable) or is_depth(dataset, variable):
        return "depth"
    if standard == "air_pressure" or (units is not None and plain(units) and knows(units, "pressure")):
        return "pressure"
    if standard == "depth" or (variable.attrs.get("positive") == "down" and units is not None and plain(units) and knows(units, "height")):
        return "depth"
    if units is not None and plain(units) and knows(units, "height") and np.max(variable.values, initial=-np.inf) <= 0 and np.min(variable.values, initial=0) < 0:
        return "depth"  # of an ocean, upwards
    if standard == "height" or not standard and str(variable.name).lower() == "agl" and plain(units) and knows(units, "height"):
        return "height above ground"
    if standard in ("altitude", "height_above_mean_sea_level"):
        return "height"
    if units is not None and plain(units) and knows(units, "height"):
        return "height"
    return None


def _is_reference(variable) -> bool:
    """True for pressures that hybrid levels have where the pressure at the ground is a reference (FV3's pfull)."""
    return str(variable.attrs.get("long_name", "")).startswith(("ref full pressure", "reference pressure"))


def runs_down(dataset, vertical: Vertical) -> bool | None:
    """Whether the levels run downwards, by the attribute positive of their axis or by its reference pressures; None if nothing says so."""
    for variable in _coordinates(dataset, vertical.dim):
        way = {"up": 1, "down": -1}.get(variable.attrs.get("positive")) or (-1 if _is_reference(variable) else 0)
        values = np.asarray(variable.values, float)
        if way and values.size > 1 and values[0] != values[-1]:
            return bool((values[-1] - values[0]) * way < 0)
    return None


def _by_coefficients(dataset, dim: str) -> Vertical | None:
    """Hybrid levels without formula terms whose coefficients have the usual names."""
    return Vertical(dim, "hybrid", "") if usual_coefficients(dataset, dim) else None


_PRESSURES = {"hPa": (400, 1100), "Pa": (4e4, 1.1e5)}  # of the lowest level


def _by_values(dataset, dim: str) -> Vertical | None:
    """Levels without units whose values look like pressures: the lowest fits the lower atmosphere, and the values do not merely count levels."""
    if dim not in dataset.variables or not re.fullmatch(r"p|p?lev(el)?s?|pressure|isobaric\d*", str(dim).lower()) or plain(dataset[dim].attrs.get("units")) or dataset[dim].dtype.kind not in "fiu":
        return None
    values = np.asarray(dataset[dim].values, float)
    units = next((units for units, (least, most) in _PRESSURES.items() if values.size > 1 and least <= np.nanmax(values) <= most and np.nanmin(values) > 0), None)
    if units is None or np.ptp(np.diff(values)) == 0 and abs(values[1] - values[0]) == 1:
        return None
    return Vertical(dim, "pressure", dim, [f"{dim!r} has no units: its values are taken as pressures in {units}"], units)


def usual_coefficients(dataset, dim: str) -> dict[str, str] | None:
    for a, b in (("hyam", "hybm"), ("ap", "b"), ("a", "b"), ("hyai", "hybi"), ("akm", "bkm")):
        if a in dataset.variables and b in dataset.variables and dataset[a].dims == (dim,):
            return {"a": a, "b": b}
    return None


def usual_terms(dataset, dim: str) -> tuple[str, dict[str, str]] | None:
    """Standard name and terms of the terrain-following levels of ROMS without formula terms, by the usual names and the number of the transformation; None if these are not there."""
    terms = {"s": dim, "C": "Cs_r" if dim == "s_rho" else "Cs_w", "eta": "zeta", "depth": "h", "depth_c": "hc"}
    number = dataset.variables.get("Vtransform", dataset.attrs.get("Vtransform"))
    if dim not in ("s_rho", "s_w") or number is None or not set(terms.values()) <= set(dataset.variables) or np.ravel(number)[0] not in (1, 2):
        return None
    return f"ocean_s_coordinate_g{int(np.ravel(number)[0])}", terms


def axis_of(reading, name: str) -> str | None:
    """The vertical dimension of a variable that has another one than `reading`, such as fewer pressure levels; None if it has the same one, or none."""
    if reading.vertical is None or name not in reading.dataset.data_vars or name in [field for field, _ in reading.field_variables()]:
        return None
    rest = [str(dim) for dim in reading.dataset[name].dims if dim not in reading.horizontal.dims]
    on_grid = set(reading.horizontal.dims) <= set(reading.dataset[name].dims)
    return rest[0] if on_grid and len(rest) == 1 and find_vertical(reading.dataset, rest, None) and reading.dataset.sizes[rest[0]] > 1 else None


def level_values(dataset, vertical: Vertical) -> np.ndarray:
    """Pressures in Pa, heights in m, or the numbers of the levels."""
    if not vertical.name:
        return np.arange(dataset.sizes[vertical.dim], dtype=float)
    variable = dataset[vertical.name]
    values = np.asarray(variable.values, dtype=float)
    quantity = "pressure" if vertical.kind == "pressure" else "height" if vertical.kind.startswith(("height", "depth")) else None
    if quantity is None:
        return values
    units = variable.attrs.get("units") or vertical.units or {"isobaricInhPa": "hPa", "isobaricInPa": "Pa"}.get(vertical.dim)
    if vertical.kind == "depth" and is_sea_pressure(variable):
        _note_once(vertical, f"{vertical.name!r}: depths from the pressure of sea water ({units}, without that of the air), as at a latitude of 45 degrees")
        return -depth_of_sea_pressure(converted(values, units, "pressure", vertical.name)[0] / 1e4)
    found, note = converted(values, units, quantity, vertical.name)
    _note_once(vertical, note)
    if vertical.kind == "height" and _may_be_depth(variable):
        _note_once(vertical, f"{vertical.name!r} has no attribute 'positive': its values are taken as heights. For depths set ds[{vertical.name!r}].attrs['positive'] = 'down'")
    return -found if vertical.kind == "depth" and np.nanmax(found) > 0 else found


def depth_of_sea_pressure(pressure: np.ndarray) -> np.ndarray:
    """Metres, of the pressure of sea water in dbar without that of the air, at a latitude of 45 degrees (Fofonoff and Millard 1983, UNESCO Technical Papers in Marine Science 44)."""
    gravity = 9.780318 * (1 + (5.2788e-3 + 2.36e-5 * 0.5) * 0.5) + 1.092e-6 * pressure
    return (((-1.82e-15 * pressure + 2.279e-10) * pressure - 2.2512e-5) * pressure + 9.72659) * pressure / gravity


def _note_once(vertical: Vertical, note: str) -> None:
    vertical.notes += [note] if note and note not in vertical.notes else []


def pressure_of_level(dataset) -> float | None:
    """The pressure in Pa of the one level that a selection leaves, ``ds.sel(plev=850)``, from its coordinate without a dimension; None if there is none."""
    for name, coordinate in dataset.coords.items():
        if coordinate.ndim == 0 and coordinate.dtype.kind in "fiu":
            alone = type(dataset)(coords={name: ((name,), np.ravel(coordinate.values), coordinate.attrs)})
            found = find_vertical(alone, [str(name)], None)
            if found is not None and found.kind == "pressure":
                return float(level_values(alone, found)[0])
    return None


def _terms(variable) -> str:
    return str(variable.attrs.get("formula_terms", variable.attrs.get("formula_term", "")))  # GFDL's files of CMIP6 omit the s


def formula_terms(dataset, vertical: Vertical) -> dict[str, str]:
    """Term -> variable."""
    if not vertical.name:
        return {}
    return dict(re.findall(r"(\w+)\s*:\s*(\S+)", _terms(dataset[vertical.name])))
