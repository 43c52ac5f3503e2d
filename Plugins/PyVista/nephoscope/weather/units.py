# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts units of weather data to those of this package, and masks the fill values that a variable declares."""
from __future__ import annotations

import re
import unicodedata

import numpy as np

GRAVITY = 9.80665  # m/s2, standard

# Quantity -> its unit in this package, and the conversion of other units: a factor and an offset.
_SPEED = {"ms-1": 1, "m/s": 1, "mps": 1, "meters/second": 1, "metresecond-1": 1, "kt": 0.514444, "kts": 0.514444, "knot": 0.514444, "knots": 0.514444,
          "km/h": 1 / 3.6, "kmh-1": 1 / 3.6, "kmhr-1": 1 / 3.6, "km/hr": 1 / 3.6, "kph": 1 / 3.6, "mph": 0.44704, "mi/h": 0.44704, "mih-1": 0.44704, "miles/hour": 0.44704, "mileshour-1": 0.44704, "milesperhour": 0.44704, "mile/hour": 0.44704, "mileperhour": 0.44704,
          "cm/s": 0.01, "cms-1": 0.01, "m/sec": 1, "msec-1": 1, "ms^-1": 1, "meter/second": 1, "metersecond-1": 1, "meterspersecond": 1, "metrespersecond": 1, "meterssecond-1": 1}
_MASS = {"kgkg-1": 1, "kg/kg": 1, "1": 1, "": 1, "gg-1": 1, "g/g": 1, "gkg-1": 1e-3, "g/kg": 1e-3, "mg/kg": 1e-6, "mgkg-1": 1e-6, "kg/kg(dryair)": 1, "kgofwater/kgofair": 1, "kg(kg)-1": 1, "kgkg^-1": 1, "10-3kgkg-1": 1e-3, "kilogram/kilogram": 1}
_LENGTH = {"m": 1, "meter": 1, "meters": 1, "metre": 1, "metres": 1, "gpm": 1, "geopotentialmetre": 1, "geopotentialmeters": 1, "gpdm": 10, "dam": 10, "gpdam": 10, "decametre": 10, "decameter": 10, "decametres": 10, "decameters": 10, "dekameter": 10, "dekameters": 10, "geopotentialdecametres": 10, "geopotentialdecameters": 10, "fathom": 1.8288, "fathoms": 1.8288, "km": 1000, "kilometer": 1000, "kilometre": 1000,
           "kilometers": 1000, "kilometres": 1000, "ft": 0.3048, "feet": 0.3048, "foot": 0.3048, "cm": 0.01, "centimeter": 0.01, "centimeters": 0.01, "centimetre": 0.01, "centimetres": 0.01, "mmsl": 1, "masl": 1, "mamsl": 1, "maboveground": 1, "magl": 1, "metresabovesealevel": 1, "metersabovesealevel": 1, "gpmeter": 1, "geopotentialmeter": 1, "geopotentialmetres": 1}
UNITS = {
    "temperature": ("K", {"k": 1, "kelvin": 1, "degk": 1, "degreesk": 1, "degree_kelvin": 1, "kelvins": 1, "degreekelvin": 1, "degreeskelvin": 1, "degrees_kelvin": 1, "degreecelsius": (1, 273.15), "degreescelsius": (1, 273.15), "degcelsius": (1, 273.15), "deg_celsius": (1, 273.15), "degree_c": (1, 273.15), "degrees_c": (1, 273.15), "degc": (1, 273.15), "c": (1, 273.15), "celsius": (1, 273.15),
                          "degreec": (1, 273.15), "degreesc": (1, 273.15), "deg_c": (1, 273.15), "degree_celsius": (1, 273.15), "degrees_celsius": (1, 273.15),
                          "degf": (5 / 9, 459.67 * 5 / 9), "f": (5 / 9, 459.67 * 5 / 9), "fahrenheit": (5 / 9, 459.67 * 5 / 9)}),
    "pressure": ("Pa", {"pa": 1, "pascal": 1, "pascals": 1, "nm-2": 1, "hpa": 100, "hectopascal": 100, "mb": 100, "mbar": 100, "millibar": 100, "millibars": 100, "hectopascals": 100, "hpa(mbar)": 100, "mbars": 100, "newtonmeter-2": 1, "n/m2": 1, 
                        "kpa": 1000, "bar": 1e5, "dbar": 1e4, "dbars": 1e4, "decibar": 1e4, "decibars": 1e4, "atm": 101325}),
    "height": ("m", _LENGTH),
    "geopotential": ("m2 s-2", {"m2s-2": 1, "m2/s2": 1, "m+2s-2": 1, "jkg-1": 1, "j/kg": 1, "gpm": GRAVITY, "m": GRAVITY, "gpdm": 10 * GRAVITY, "dam": 10 * GRAVITY, "gpdam": 10 * GRAVITY, "km": 1000 * GRAVITY, "geopotentialmeters": GRAVITY, "geopotentialmetres": GRAVITY}),
    "speed": ("m s-1", _SPEED),
    "omega": ("Pa s-1", {"pas-1": 1, "pa/s": 1, "hpas-1": 100, "hpa/s": 100, "mb/s": 100, "mbs-1": 100, "pascal/s": 1, "pascals-1": 1, "pascals/s": 1, "pa/sec": 1, "pasec-1": 1, "pascal/second": 1, "hpa/hour": 100 / 3600, "mb/hour": 100 / 3600, "hpah-1": 100 / 3600, "pa/hour": 1 / 3600, "hpa/h": 100 / 3600}),
    "mass fraction": ("kg kg-1", _MASS),
    "fraction": ("1", {"1": 1, "": 1, "(0-1)": 1, "0-1": 1, "fraction": 1, "proportion": 1, "dimensionless": 1, "none": 1, "-": 1, "%": 0.01, "percent": 0.01, "per_cent": 0.01,
                       "okta": 0.125, "oktas": 0.125, "octa": 0.125, "octas": 0.125, "eighths": 0.125, "eighth": 0.125, "1/8": 0.125, "tenths": 0.1, "tenth": 0.1, "1/10": 0.1, "0-8": 0.125, "0-10": 0.1}),
    "log pressure": ("1", {"1": 1, "": 1, "~": 1, "numeric": 1, "dimensionless": 1, "-": 1}),
}
# Plausible values of a quantity without units: its range on Earth, in this package's unit.
_PLAUSIBLE = {"temperature": (90, 400), "pressure": (0, 1.2e5), "height": (-1000, 2e5), "geopotential": (-1e4, 2e6), "speed": (-350, 350), "omega": (-300, 300),
              "mass fraction": (-0.01, 0.1), "fraction": (-0.1, 1.5), "log pressure": (8, 12)}


FILLS = ("_FillValue", "missing_value")  # attributes
PARTS = {text for text, factor in UNITS["fraction"][1].items() if factor in (0.125, 0.1)}  # of the sky


class UnitsError(ValueError):
    """Units that cannot be converted; the message names the variable and what is known."""


def simple(units: object) -> str:
    """Units in ASCII, as VTK's strings of PyVista must be: ``"degC"`` for °C, ``"ug m-3"`` for µg m⁻³, ``"W/m2"`` for W/m²."""
    text = str(units)
    if text.isascii():
        return text
    for sign, word in _SIGNS.items():
        text = text.replace(sign, word)
    text = unicodedata.normalize("NFKC", text).replace("\u2212", "-").replace("\u2044", "/")  # superscripts become digits
    parts = unicodedata.normalize("NFKD", text)
    return "".join(sign for sign in parts if not unicodedata.combining(sign)).encode("ascii", "replace").decode()


_SIGNS = {"\u2103": "degC", "\u2109": "degF", "°": "deg", "º": "deg", "\u02da": "deg", "µ": "u", "\u03bc": "u", "\u2126": "Ohm", "\u03a9": "Ohm", "·": ".", "\u22c5": ".", "×": "x", "‰": "permil",
          "\u2013": "-", "\u2011": "-", "\u2010": "-", "\u2019": "'"}


def plain(units: object) -> str:
    """``"m s**-1"``, ``"m s^-1"``, ``"m.s-1"`` and ``"m s⁻¹"`` are ``"ms-1"``."""
    text = "" if units is None else simple(units).strip().lower()
    return re.sub(r"[\s*^.{}]", "", text) if text not in ("*", ".") else ""


# Spellings of one unit, as `plain` returns them, by what is written in a picture.
_SPELLINGS = {"m": {"m", "meter", "meters", "metre", "metres"}, "m s-1": {text for text, factor in _SPEED.items() if factor == 1},
              "K": {text for text, factor in UNITS["temperature"][1].items() if factor == 1}, "\u00b0C": {text for text, factor in UNITS["temperature"][1].items() if factor == (1, 273.15)},
              "Pa": {"pa", "pascal", "pascals", "nm-2"}, "hPa": {"hpa", "hectopascal", "hectopascals", "mb", "mbar", "mbars", "millibar", "millibars"}, "%": {"%", "percent", "per_cent"}}


def usual(units: str) -> str:
    """The units in one spelling, "m s-1" for "m/s" and "meter second-1", "kg kg-1" for "kg kg**-1"; others as they are."""
    text = plain(units)
    return next((written for written, spellings in _SPELLINGS.items() if text in spellings), re.sub(r"(?<=[A-Za-z])(\*\*|\^)(?=-?\d)", "", units))


def knows(units: object, quantity: str) -> bool:
    return plain(units) in UNITS[quantity][1]


def says_fraction(units: object) -> bool:
    """Whether these are units of fractions of 1, such as "1"; False without units."""
    text = plain(units)
    return bool(text) and UNITS["fraction"][1].get(text) == 1


def converted(values: np.ndarray, units: object, quantity: str, name: str) -> tuple[np.ndarray, str]:
    """`values` in this package's unit of `quantity`, and a note about the conversion ("" if there was none).

    Values without units are used unchanged if they are plausible on Earth; otherwise an error is raised.
    """
    target, table = UNITS[quantity]
    text = plain(units)
    if units is None or (text == "" and "" not in table):
        _require_plausible(values, quantity, name)
        return values, f"{name!r} has no units and is used as {target}"
    if text not in table:
        raise UnitsError(f"The units of {name!r} are {str(units)!r}, which is not one of the known units of {quantity}: {', '.join(sorted(k for k in table if k))}. "
                         f"Set them: ds[{name!r}].attrs['units'] = {target!r}, after converting the values.")
    factor, added = table[text] if isinstance(table[text], tuple) else (table[text], 0)
    if factor == 1 and added == 0:
        return values, ""
    return values * values.dtype.type(factor) + values.dtype.type(added), f"{name!r}: {units} converted to {target}"


# Role -> quantity, range of possible values on a planet, range of usual values on Earth, units to try.
_RANGES = {"temperature": ("temperature", (90, 400), (150, 345), ("K", "degC")), "potential_temperature": ("temperature", (150, np.inf), (200, 600), ("K", "degC")),
           "surface_pressure": ("pressure", (2e4, 1.2e5), (7e4, 1.1e5), ("Pa", "hPa", "kPa")), "pressure": ("pressure", (0, 2e5), (0, 1.1e5), ("Pa", "hPa", "kPa")),
           "relative_humidity": ("fraction", (-1, 5), (-0.05, 1.6), ("1", "%")),
           **{role: ("mass fraction", (-1, 1), (-1e-3, 0.05), ("kg kg-1", "g kg-1")) for role in ("specific_humidity", "mixing_ratio")}}
CHECKED = tuple(_RANGES)
_SAMPLE = 20000  # values that are looked at
_LEAST_RANGE = 60.0  # K: temperatures in a column of air vary more; differences of temperatures, also in K, vary less
_MOST = (2, 98)  # percentiles: a few odd values do not count


def better_units(values: np.ndarray, units: object, role: str) -> str | None:
    """The units in which the values of a role are usual, if they are impossible in the stated units; None otherwise."""
    quantity, possible, usual_ones, others = _RANGES.get(role, ("", (0, 0), (0, 0), ()))
    if not quantity or not plain(units) or not knows(units, quantity):
        return None
    sample = np.ravel(values)[::max(1, values.size // _SAMPLE)].astype(float)
    sample = sample[np.isfinite(sample)]
    if not sample.size:
        return None
    most = np.percentile(sample, _MOST)
    fits = lambda told, limits: bool(limits[0] <= (found := converted(most, told, quantity, "")[0])[0] and found[1] <= limits[1])  # noqa: E731
    if fits(units, possible) or quantity == "temperature" and most[0] < 100 and np.ptp(most) < _LEAST_RANGE:
        return None
    return next((told for told in others if fits(told, usual_ones)), None)


def without_fill_values(variable):
    """`variable` with NaN for the values that its attributes call _FillValue and missing_value. xarray does this when it decodes a file, but not for attributes that were set later."""
    declared = [np.ravel(variable.attrs[key]) for key in FILLS if key in variable.attrs]
    numbers = [values.astype(float) for values in declared if values.dtype.kind in "fiu"]
    if not numbers or variable.dtype.kind not in "fiu":
        return variable
    fills = np.concatenate(numbers)
    if variable.dtype.kind == "f":
        fills = fills[np.isfinite(fills)].astype(variable.dtype)
    return variable.where(~variable.isin(fills))


def in_fractions(dataset):
    """`dataset` with amounts of cloud in oktas or tenths as fractions, and notes about them."""
    notes = []
    for name, variable in dataset.data_vars.items():
        if plain(variable.attrs.get("units")) in PARTS and variable.dtype.kind in "fiu":
            factor = UNITS["fraction"][1][plain(variable.attrs["units"])]
            notes.append(f"{str(name)!r}: {variable.attrs['units']} converted to fractions of 1")
            dataset = dataset.assign({name: (without_fill_values(variable) * np.float32(factor)).assign_attrs({**{key: value for key, value in variable.attrs.items() if key not in FILLS}, "units": "1"})})
    return dataset, notes


def _require_plausible(values: np.ndarray, quantity: str, name: str) -> None:
    finite = values[np.isfinite(values)]
    least, most = _PLAUSIBLE[quantity]
    if finite.size and not (least <= finite.min() and finite.max() <= most):
        raise UnitsError(f"{name!r} has no units, and its values, {finite.min():g} to {finite.max():g}, are not plausible for {quantity} in {UNITS[quantity][0]}. "
                         f"Set them: ds[{name!r}].attrs['units'] = {'degC' if quantity == 'temperature' and -120 <= finite.min() and finite.max() <= 70 else '...'!r}.")
