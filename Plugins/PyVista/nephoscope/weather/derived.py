# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Physical quantities computed from the variables of a dataset, ready to draw."""
from __future__ import annotations

import numpy as np

from .._cloud_water import usual_water, words_for
from . import quantities
from .air import Air
from .circulation import vorticity_of
from .columns import density
from .humidity import relative_from_specific, vapour_pressure
from .quantities import WATER, no_water, wanted
from .reading import HUMIDITY, Reading
from .units import UnitsError
from .winds import winds

CRITICAL_HUMIDITY = 0.8  # of Sundqvist's cloud fraction


def derived(names, reading: Reading, air: Air) -> dict[str, np.ndarray]:
    """{name: field}, in the dataset's order of levels."""
    return {name: _quantity(name, reading, air) for name in wanted(names, QUANTITIES)}


def _quantity(name: str, reading: Reading, air: Air) -> np.ndarray:
    try:
        return QUANTITIES[name](reading, air)
    except ValueError as problem:
        if isinstance(problem, UnitsError) or not reading.unusable:
            raise
        raise UnitsError(f"{problem} Left out: {' '.join(reading.unusable.values())}") from problem


def _need(air: Air, what: str, name: str, role: str = "") -> np.ndarray:
    """The property `what` of the air, which needs a variable with the `role`, by default of the same name."""
    value, role = getattr(air, what), role or what
    if value is None:
        raise ValueError(f"{name} needs {role.replace('_', ' ')}, which was not found{_elsewhere(air.reading, role)} Name the variable: globe({role}='...'), as describe() lists them.")
    return value


def _elsewhere(reading: Reading, role: str) -> str:
    """On which other axis the variable is."""
    roles = HUMIDITY if role in HUMIDITY else ("temperature", "potential_temperature") if role == "temperature" else ()
    name = next((reading.elsewhere[one] for one in roles if one in reading.elsewhere), None)
    if name is None:
        return "."
    dim, own = reading.axis_of_variable(name), reading.vertical.dim
    return f" on {own!r}: {name!r} is on {dim!r}. Interpolate it first, ds.assign({name}=ds[{name!r}].interp({dim}=ds[{own!r}])), or use its levels, globe(vertical={dim!r})."


def relative_humidity(reading: Reading, air: Air) -> np.ndarray:
    """1 = saturated over water (Bolton 1980)."""
    reading.refuse_unusable("relative_humidity")
    if reading.has("relative_humidity"):
        return reading.role("relative_humidity")
    specific = _need(air, "specific_humidity", "relative_humidity")
    return relative_from_specific(specific, _need(air, "temperature", "relative_humidity"), _need(air, "pressure", "relative_humidity"))


def potential_temperature(reading: Reading, air: Air) -> np.ndarray:
    """K, to 1000 hPa."""
    name = "potential_temperature"
    return quantities.potential_temperature(_need(air, "temperature", name), _need(air, "pressure", name))


def temperature(reading: Reading, air: Air) -> np.ndarray:
    """K; that of the dataset or, if it has none, from the potential temperature and the pressure."""
    return _need(air, "temperature", "temperature")


def equivalent_potential_temperature(reading: Reading, air: Air) -> np.ndarray:
    """K (Bolton 1980, equations 22, 24 and 39). Without vapour it is the potential temperature."""
    name = "equivalent_potential_temperature"
    t, p = _need(air, "temperature", name), _need(air, "pressure", name)
    specific = np.maximum(_need(air, "specific_humidity", name), 1e-9)
    ratio = specific / (1 - specific)
    humidity = np.clip(relative_from_specific(specific, t, p), 1e-6, None)
    condensation = 1 / (1 / (t - 55) - np.log(humidity) / 2840) + 55
    dry = quantities.potential_temperature(t, p - vapour_pressure(specific, p))
    return dry * (t / condensation) ** (0.28 * ratio) * np.exp((3036 / condensation - 1.78) * ratio * (1 + 0.448 * ratio))


def wind_speed(reading: Reading, air: Air) -> np.ndarray:
    """m/s, horizontal."""
    return np.hypot(*_horizontal(reading, air, "wind_speed"))


def _horizontal(reading: Reading, air: Air, name: str):
    found, _ = winds(reading, air)
    if not found:
        raise ValueError(f"{name} needs both horizontal winds, which were not found. Name the variables: globe(u='...', v='...').")
    return np.asarray(found[0], float), np.asarray(found[1], float)


def vorticity(reading: Reading, air: Air) -> np.ndarray:
    """1/s, relative, upward: the circulation around each point divided by its area, on any grid of rows and columns."""
    if reading.horizontal.is_list:
        raise ValueError("vorticity needs a grid of rows and columns, but this one is a list of cells.")
    u, v = _horizontal(reading, air, "vorticity")
    return vorticity_of(u, v, *reading.horizontal.places())


def cloud_content(reading: Reading, air: Air) -> np.ndarray:
    """kg/m3: the sum of the available cloud water, ice, rain, snow and graupel. Without any of these, the usual water times the model's cloud fraction (Hack 1998)."""
    if not any(reading.has(role) for role in WATER) and reading.has("cloud_fraction"):
        reading.refuse_unusable(*WATER)
        reading.warn(words_for(reading.roles["cloud_fraction"]))
        return usual_water(reading.role("cloud_fraction"), air.heights)
    return water_fraction("cloud_content", reading, air) * density_of(air, "cloud_content")


def water_fraction(name: str, reading: Reading, air: Air) -> np.ndarray:
    """kg/kg, of the cloud content or the water vapour."""
    if name == "water_vapour":
        return _need(air, "specific_humidity", "water_vapour")
    reading.refuse_unusable(*WATER)
    there = [role for role in WATER if reading.has(role)]
    if not there:
        raise no_water("Name the variable: globe(cloud_water='...').")
    reading.note(f"cloud_content of {', '.join(reading.roles[role] for role in there)}")
    return sum(reading.role(role).astype(float) for role in there)


def density_of(air: Air, name: str) -> np.ndarray:
    """kg/m3 of the air, for the quantity `name`."""
    return density(_need(air, "pressure", name), _need(air, "virtual_temperature", name, "temperature"))


def cloud_fraction(reading: Reading, air: Air) -> np.ndarray:
    """The model's own cloud fraction; if it has none, 1 - sqrt((1 - RH) / (1 - 0.8)) (Sundqvist, Berge and Kristjansson 1989)."""
    reading.refuse_unusable("cloud_fraction")
    if reading.has("cloud_fraction"):
        return reading.role("cloud_fraction")
    reading.note(f"cloud_fraction from the relative humidity, critical at {CRITICAL_HUMIDITY:g} (Sundqvist et al. 1989)")
    humidity = np.clip(relative_humidity(reading, air), CRITICAL_HUMIDITY, 1.0)
    return 1 - np.sqrt((1 - humidity) / (1 - CRITICAL_HUMIDITY))


def water_vapour(reading: Reading, air: Air) -> np.ndarray:
    """kg/m3."""
    return water_fraction("water_vapour", reading, air) * density_of(air, "water_vapour")


def computable(reading: Reading) -> list[str]:
    """The names of the quantities for which the dataset seems to have what they need."""
    has = lambda *roles: any(reading.has(role) for role in roles)  # noqa: E731
    temperature, humidity = has("temperature", "potential_temperature"), has("specific_humidity", "mixing_ratio", "relative_humidity")
    horizontal = reading.has_winds()
    there = {"temperature": has("potential_temperature") and not has("temperature"), "relative_humidity": has("relative_humidity") or temperature and humidity, "potential_temperature": temperature, "equivalent_potential_temperature": temperature and humidity,
             "wind_speed": horizontal, "vorticity": horizontal and not reading.horizontal.is_list, "cloud_content": temperature and has(*WATER) or has("cloud_fraction"), "water_vapour": temperature and humidity,
             "cloud_fraction": has("cloud_fraction", "relative_humidity") or temperature and humidity}
    return [name for name in QUANTITIES if there[name]]


QUANTITIES = {function.__name__: function for function in (temperature, relative_humidity, potential_temperature, equivalent_potential_temperature, wind_speed, vorticity, cloud_content, cloud_fraction,
                                                           water_vapour)}
