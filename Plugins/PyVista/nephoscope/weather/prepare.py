# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts datasets of models with their own conventions to those that `Reading` knows."""
from __future__ import annotations

import re

import numpy as np

MADE_OF = "nephoscope_made_of"  # attribute of computed variables: the formula, with the names in the file
WRF_GRAVITY = 9.81  # m/s2, WRF's constant: its geopotential divided by this is its height
WRF_TEMPERATURE = 300.0  # K, the base value of WRF's T


def made_of(dataset, name: str) -> tuple[str, str] | None:
    """The variable that `prepared` has computed from the variable `name` of the file, and its formula; None if there is none."""
    formulas = {str(made): str(variable.attrs[MADE_OF]) for made, variable in dataset.variables.items() if MADE_OF in variable.attrs}
    return next(((made, formula) for made, formula in formulas.items() if name in re.findall(r"\w+", formula)), None)


def prepared(dataset):
    """`dataset` at one time, with WRF's pressure, potential temperature and height computed from perturbation and base state, CDO's coefficients on their levels, and levels that are in names as an axis."""
    dataset = _wrf(dataset) if {"PH", "PHB"} <= set(dataset.data_vars) else dataset
    return _with_levels_of_names(_with_coefficients(dataset))


_LEVEL_IN_NAME = re.compile(r"(.+?)_(\d+(?:\.\d+)?)_?(mb|hPa)")


def _with_levels_of_names(dataset):
    """TMP_1000mb, TMP_850mb, ... as wgrib2 writes them become TMP on pressure levels, if there are no variables on levels."""
    found: dict[str, dict[float, str]] = {}
    for name, variable in dataset.data_vars.items():
        told = _LEVEL_IN_NAME.fullmatch(str(name))
        if told and variable.ndim == 2 and told[1] not in dataset.variables:
            found.setdefault(told[1], {})[float(told[2])] = str(name)
    several = {stem: levels for stem, levels in found.items() if len(levels) > 1}
    if not several or "isobaricInhPa" in dataset.variables or any(variable.ndim > 2 for variable in dataset.data_vars.values()):
        return dataset
    levels = max((sorted(levels) for levels in several.values()), key=len)
    whole = {stem: [names[level] for level in levels] for stem, names in several.items() if sorted(names) == levels}
    for stem, names in whole.items():
        first = dataset[names[0]]
        stacked = first.expand_dims(isobaricInhPa=len(names)).copy(data=np.stack([dataset[name].transpose(*first.dims).values for name in names]))
        dataset = dataset.assign({stem: stacked.assign_attrs(long_name=stem)})
    return dataset.assign_coords(isobaricInhPa=("isobaricInhPa", np.array(levels), {"units": "hPa", "positive": "down", "standard_name": "air_pressure"}))


def _with_coefficients(dataset):
    """Hybrid levels of CDO and ECHAM: hyam and hybm are on a separate dimension, nhym, which has all levels of the model; the level numbers select from it."""
    a, b = (dataset.variables.get(name) for name in ("hyam", "hybm"))
    if a is None or b is None or a.ndim != 1 or a.dims != b.dims or a.dims[0] in dataset.variables:
        return dataset
    for dim in (dim for dim in dataset.dims if dim in dataset.variables and str(dataset[dim].attrs.get("standard_name", "")).endswith("hybrid_sigma_pressure")):
        numbers = np.asarray(dataset[dim].values, float)
        if np.all(numbers % 1 == 0) and 1 <= numbers.min() and numbers.max() <= a.size:
            places = numbers.astype(int) - 1
            return dataset.drop_vars(("hyam", "hybm")).assign({name: ((dim,), variable.values[places], variable.attrs) for name, variable in (("hyam", a), ("hybm", b))})
    return dataset


def _wrf(dataset):
    added = {"altitude": ((dataset["PH"] + dataset["PHB"]) / WRF_GRAVITY, "m", "altitude", f"(PH + PHB) / {WRF_GRAVITY}")}
    if {"P", "PB"} <= set(dataset.data_vars):
        added["air_pressure"] = dataset["P"] + dataset["PB"], "Pa", "air_pressure", "P + PB"
    if "T" in dataset.data_vars:
        added["theta"] = dataset["T"] + WRF_TEMPERATURE, "K", "air_potential_temperature", f"T + {WRF_TEMPERATURE:g}"
    dataset = dataset.drop_vars([name for name in ("PH", "PHB", "P", "PB", "T") if name in dataset])
    dataset = dataset.assign({name: field.assign_attrs({"units": units, "standard_name": standard, MADE_OF: made}) for name, (field, units, standard, made) in added.items()})
    for name in ("U", "V"):
        if name in dataset:
            dataset[name] = dataset[name].assign_attrs(nephoscope_along_grid=1)
    return dataset
