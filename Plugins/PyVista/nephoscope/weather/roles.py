# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The roles of variables: identified by CF standard names, by GRIB keys, then by the usual names of models and archives."""
from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Iterable

from .units import knows


@dataclass(frozen=True)
class Role:
    """What a variable can be. `quantities`: the first one whose units match is the variable's quantity."""
    name: str
    meaning: str
    quantities: tuple[str, ...]
    standard: tuple[str, ...]
    grib: tuple[str, ...]
    names: tuple[str, ...]


def _role(name, meaning, quantities, standard, grib, names=""):
    return Role(name, meaning, tuple(quantities.split(",")), tuple(standard.split()), tuple(grib.split()), tuple(names.lower().split()))


# On levels.
FIELDS = [
    _role("altitude", "height above sea level", "height", "altitude height_above_mean_sea_level geometric_height_at_full_level_center geometric_height_at_half_level_center height_above_reference_ellipsoid mid_layer_heights",
          "h HHL", "altitude z_mc height_msl z_ifc hhl zgrid z_agl_msl h z_rho"),
    _role("thickness", "thickness of the layers", "height", "", "", "delz"),
    _role("geopotential_height", "geopotential height", "height,geopotential", "geopotential_height", "gh", "gh zg hgt ght geopotential_height z3 height"),
    _role("geopotential", "geopotential", "geopotential", "geopotential", "z", "z geopotential phi fi geopot"),
    _role("temperature", "temperature", "temperature", "air_temperature", "t", "t ta tk tmp temp temperature air air_temperature tc tabs st"),
    _role("potential_temperature", "potential temperature", "temperature", "air_potential_temperature", "pt", "theta th pt pot potential_temperature air_potential_temperature"),
    _role("pressure", "pressure", "pressure", "air_pressure mid_level_pressure", "pres", "p pres pressure air_pressure pfull p_full pressure_full pl prs hyp"),
    _role("pressure_thickness", "pressure thickness of the layers", "pressure", "pressure_thickness", "", "dpres delp"),
    _role("u", "wind along x", "speed", "eastward_wind x_wind grid_eastward_wind eastward_sea_water_velocity sea_water_x_velocity", "u", "u ua uwnd ugrd u-component_of_wind u_component_of_wind eastward_wind ureconstructzonal u_wind uu x_wind wind_east uo uvel vozocrtx ubar u10 10u u10m"),
    _role("v", "wind along y", "speed", "northward_wind y_wind grid_northward_wind northward_sea_water_velocity sea_water_y_velocity", "v", "v va vwnd vgrd v-component_of_wind v_component_of_wind northward_wind ureconstructmeridional v_wind vv y_wind wind_north vo vvel vomecrty vbar v10 10v v10m"),
    _role("w", "vertical wind", "speed,omega", "upward_air_velocity lagrangian_tendency_of_air_pressure", "w wz omega",
          "w wa wap omega vvel dzdt vertical_velocity vertical_velocity_pressure vertical_velocity_geometric upward_air_velocity ww"),
    _role("specific_humidity", "specific humidity", "mass fraction", "specific_humidity", "q", "q hus qv spfh shum specific_humidity"),
    _role("mixing_ratio", "water vapour mixing ratio", "mass fraction", "humidity_mixing_ratio", "mixr", "qvapor mixr mixing_ratio rv"),
    _role("relative_humidity", "relative humidity", "fraction", "relative_humidity", "r", "r rh hur relhum relative_humidity"),
    _role("cloud_fraction", "cloud fraction", "fraction", "cloud_area_fraction_in_atmosphere_layer cloud_area_fraction cloud_volume_fraction_in_atmosphere_layer cloud_fraction_for_radiation", "cc tcc ccl",
          "cc cl clc cldfra cloud_fraction cloud fcloud cfrac tcdc fraction_of_cloud_cover cld_amt cloud_cover total_cloud_cover"),
    _role("cloud_water", "cloud liquid water", "mass fraction", "mass_fraction_of_cloud_liquid_water_in_air mass_fraction_of_cloud_liquid_water cloud_liquid_water_mixing_ratio specific_cloud_liquid_water_content", "clwc clwmr qc",
          "clwc clw qc qcloud cldliq clwmr ql cloud_mixing_ratio specific_cloud_liquid_water_content"),
    _role("cloud_ice", "cloud ice", "mass fraction", "mass_fraction_of_cloud_ice_in_air mass_fraction_of_cloud_ice_water cloud_ice_mixing_ratio specific_cloud_ice_water_content", "ciwc icmr qi",
          "ciwc cli qi qice cldice icmr ice_water_mixing_ratio specific_cloud_ice_water_content"),
    _role("rain", "rain", "mass fraction", "mass_fraction_of_rain_in_air rain_mixing_ratio", "crwc rwmr qr", "crwc qr qrain rwmr rain_mixing_ratio specific_rain_water_content"),
    _role("snow", "snow", "mass fraction", "mass_fraction_of_snow_in_air snow_mixing_ratio", "cswc snmr qs", "cswc qs qsnow snmr snow_mixing_ratio specific_snow_water_content"),
    _role("graupel", "graupel", "mass fraction", "mass_fraction_of_graupel_in_air", "grle qg", "qg qgraup qgraupel grle graupel_snow_pellets"),
]
# On the ground.
SURFACE = [
    _role("surface_pressure", "pressure at the ground", "pressure", "surface_air_pressure", "sp", "sp ps aps aps_ave psfc pressfc surface_pressure pres_surface surface_air_pressure pressure_surface pres"),
    _role("log_surface_pressure", "logarithm of the pressure at the ground", "log pressure", "", "lnsp", "lnsp"),
    _role("terrain", "height of the ground", "height", "surface_altitude height_above_mean_sea_level", "orog h HSURF mterh", "orog oro hgt hsurf hgtsfc hsfc hgt_surface zsfc topography_c zs zsurf ter topo orography surface_altitude topography geopotential_height_surface"),
    _role("surface_geopotential", "geopotential of the ground", "geopotential", "surface_geopotential geopotential", "z", "z phis fis z_sfc geosp geopotential_at_surface surface_geopotential geopotential_at"),
    _role("land", "land fraction", "fraction", "land_binary_mask land_area_fraction", "lsm", "lsm landmask land_area_fraction sftlf fr_land landfrac land land_binary_mask land_cover_0__sea_1__land"),
]
ROLES = {role.name: role for role in FIELDS + SURFACE}
_OF_LEVELS = re.compile(r"_(isobaric|hybrid\d*|sigma|height_above_ground|pl|ml|pressure|surface|gds\d+_\w+|p\d+_l\d+_g\w+)$")
UNKNOWN_GRIB = ("unknown", "~", "")
_DESCRIPTIONS = ("long_name", "description", "desc", "title")  # attributes that say in words what a variable is
_SHORTEST = 4  # letters; shorter names are not words


def grib_name(variable) -> str:
    name = str(variable.attrs.get("GRIB_shortName", ""))
    return "" if name in UNKNOWN_GRIB else name


def quantity_of(role: Role, variable) -> str | None:
    """The quantity that matches the variable's units; None if none matches. Without units, the first quantity."""
    units = variable.attrs.get("units")
    if units is None or str(units).strip() == "":
        return role.quantities[0]
    return next((quantity for quantity in role.quantities if knows(units, quantity)), None)


def _rank(role: Role, name: str, variable) -> int | None:
    """How well `variable` fits the role, 0 best; None if not at all."""
    standard = str(variable.attrs.get("standard_name", ""))
    short = grib_name(variable)
    if standard and standard in role.standard:
        return role.standard.index(standard)
    if short and short in role.grib:
        return 100 + role.grib.index(short)
    if standard and standard not in UNKNOWN_GRIB and not short and _is_of_another_role(role, standard):
        return None
    plain = next((plain for plain in (name.lower(), _OF_LEVELS.sub("", name.lower())) if plain in role.names), None)
    if plain is None:
        return 400 if not short and _is_described(role, variable) else None
    return 200 + role.names.index(plain)


def _is_described(role: Role, variable) -> bool:
    """Whether the words of a long name or a description are exactly those of the role, and its units are right."""
    known = {word.replace("_", " ") for word in (role.meaning, *role.standard, *role.names) if len(word) >= _SHORTEST}
    told = {re.sub(r"[\s_]+", " ", str(variable.attrs[key]).strip().lower()) for key in _DESCRIPTIONS if key in variable.attrs}
    return bool(told & known) and bool(str(variable.attrs.get("units", "")).strip()) and quantity_of(role, variable) is not None


def _is_of_another_role(role: Role, standard: str) -> bool:
    return any(standard in other.standard for other in ROLES.values() if other is not role)


def candidates(role: Role, variables: Iterable[tuple[str, object]]) -> list[str]:
    """The names of the variables that fit, best first."""
    ranked = [(rank, name) for name, variable in variables if (rank := _rank(role, name, variable)) is not None]
    return [name for rank, name in sorted(ranked, key=lambda pair: pair[0])]
