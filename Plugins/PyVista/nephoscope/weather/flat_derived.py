# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quantities computed from the variables of a flat grid, and their integrals over height."""
from __future__ import annotations

import numpy as np

from .._checks import listed
from . import quantities
from .columns import density
from .flat import Flat
from .flat_air import FlatAir
from .humidity import relative_from_specific
from .quantities import PER_VOLUME, VOLUME_UNITS, WATER, no_column, no_water, wanted
from .roles import ROLES, candidates, quantity_of
from .units import converted, plain

class FlatQuantities:
    """Arrays in the order z, y, x of the grid. `air`: temperature in K and pressure in Pa, in the same order; those that are unknown are missing."""

    def __init__(self, flat: Flat, air: dict[str, np.ndarray]) -> None:
        self.flat, self.air = flat, air

    def wind_speed(self) -> np.ndarray:
        """m/s, horizontal."""
        u, v, _ = self._winds("wind_speed")
        return np.hypot(u, v)

    def wind_magnitude(self) -> np.ndarray:
        """m/s, of the wind with its vertical part."""
        return np.sqrt(sum(part.astype(float) ** 2 for part in self._winds("Wind")))

    def vorticity(self) -> np.ndarray:
        """1/s, relative, upward."""
        if min(len(self.flat.axes[letter].values) if letter in self.flat.axes else 1 for letter in "xy") < 2:
            raise ValueError("vorticity needs several points along x and along y.")
        u, v, _ = self._winds("vorticity")
        x, y = (self.flat.axes[letter].values for letter in "xy")
        return np.gradient(v, x, axis=2, edge_order=min(2, len(x) - 1)) - np.gradient(u, y, axis=1, edge_order=min(2, len(y) - 1))

    def potential_temperature(self) -> np.ndarray:
        """K, to 1000 hPa."""
        return quantities.potential_temperature(self._need("temperature", "potential_temperature"), self._need("pressure", "potential_temperature"))

    def relative_humidity(self) -> np.ndarray:
        """1 = saturated over water (Bolton 1980)."""
        return relative_from_specific(self._vapour("relative_humidity"), self._need("temperature", "relative_humidity"), self._need("pressure", "relative_humidity"))

    def cloud_content(self) -> np.ndarray:
        """kg/m3: the sum of the available cloud water, ice, rain, snow and graupel."""
        there = [name for role in WATER if (name := self._named(role, any_units=True))]
        if not there:
            raise no_water(f"The variables are: {listed(self.flat.names())}.")
        return sum(self.content(name) for name in there)

    def water_vapour(self) -> np.ndarray:
        """kg/m3."""
        return self._vapour("water_vapour") * self._density("water_vapour")

    def content(self, name: str) -> np.ndarray:
        """kg/m3, of a variable that is a content or a mass fraction."""
        values, units = self.flat.values(name).astype(float), self.flat.dataset[name].attrs.get("units")
        if plain(units) in VOLUME_UNITS:
            return values * VOLUME_UNITS[plain(units)]
        return converted(values, units, "mass fraction", name)[0] * self._density(name)

    def _named(self, role: str, any_units: bool = False) -> str | None:
        fields = [(name, self.flat.dataset[name]) for name in self.flat.names()]
        return next((name for name in candidates(ROLES[role], fields) if any_units or quantity_of(ROLES[role], self.flat.dataset[name])), None)

    def _winds(self, needed_by: str) -> list[np.ndarray]:
        names = self.flat.winds()
        if not names:
            raise ValueError(f"{needed_by} needs the wind along x and along y, in m/s, which was not found. The variables are: {listed(self.flat.names())}.")
        shape = [len(self.flat.axes[letter].values) if letter in self.flat.axes else 1 for letter in "zyx"]
        return [np.zeros(shape, np.float32) if name is None else converted(self.flat.values(name), self.flat.dataset[name].attrs.get("units"), "speed", name)[0] for name in names]

    def _vapour(self, needed_by: str) -> np.ndarray:
        specific, ratio = self._named("specific_humidity"), self._named("mixing_ratio")
        name = specific or ratio
        if name is None:
            raise ValueError(f"{needed_by} needs specific humidity or a mixing ratio of water vapour, which was not found. The variables are: {listed(self.flat.names())}.")
        values = converted(self.flat.values(name).astype(float), self.flat.dataset[name].attrs.get("units"), "mass fraction", name)[0]
        return values if specific else values / (1 + values)

    def _density(self, needed_by: str) -> np.ndarray:
        return density(self._need("pressure", needed_by), self._need("temperature", needed_by))

    def _need(self, role: str, needed_by: str) -> np.ndarray:
        if role not in self.air:
            raise ValueError(f"{needed_by} needs {role}, which was not found. It may be a profile along z; describe() lists what has been found.")
        return self.air[role]


QUANTITIES = ("wind_speed", "wind_magnitude", "vorticity", "potential_temperature", "relative_humidity", "cloud_content", "water_vapour")


def derived_flat(names, flat: Flat, air_mesh) -> dict[str, np.ndarray]:
    """{name: values}. `air_mesh`: a function that makes the mesh with the variables of the air."""
    asked = wanted(names, QUANTITIES, " on a flat grid")
    if not asked:
        return {}
    computed = FlatQuantities(flat, _shaped(flat, FlatAir(air_mesh()).arrays(False, set())))
    return {name: getattr(computed, name)() for name in asked}


def _shaped(flat: Flat, arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    shape = [len(flat.axes[letter].values) if letter in flat.axes else 1 for letter in "zyx"]
    return {name: values.reshape(shape) for name, values in arrays.items()}


def column_of(quantity: str, flat: Flat, air_mesh) -> np.ndarray:
    """kg/m2 in the order y, x: the integral over z by the trapezoidal rule."""
    missing = [letter for letter in "zyx" if letter not in flat.axes]
    if missing:
        raise ValueError(f"column integrates over z and leaves x and y, but the grid has no axis {missing[0]}. Its axes are: {', '.join(flat.axes)}.")
    if quantity not in PER_VOLUME and quantity not in flat.names():
        raise no_column(quantity, "grid", flat.names())
    air = FlatAir(air_mesh())
    known = air.arrays(False, set())
    try:
        field = _content(quantity, FlatQuantities(flat, _shaped(flat, known)))
    except ValueError as problem:
        gone = [role for role in ("temperature", "pressure") if role not in known and f"needs {role}, which" in str(problem)]
        if not gone:
            raise
        field = _content(quantity, FlatQuantities(flat, _shaped(flat, {"temperature": air.standard_temperature, "pressure": air.standard_pressure, **known})))
        air.warn("; ".join(f"There is no {role}" for role in ("temperature", "pressure") if role not in known))
    return quantities.column(field, np.diff(flat.axes["z"].values).reshape(-1, 1, 1))


def _content(quantity: str, computed: FlatQuantities) -> np.ndarray:
    return getattr(computed, quantity)() if quantity in PER_VOLUME else computed.content(quantity)
