# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts datasets of models with their own conventions to those that `Reading` knows."""
from __future__ import annotations

WRF_GRAVITY = 9.81  # m/s2, WRF's constant: its geopotential divided by this is its height
WRF_TEMPERATURE = 300.0  # K, the base value of WRF's T


def prepared(dataset):
    """`dataset` at one time, with WRF's pressure, potential temperature and height computed from perturbation and base state."""
    return _wrf(dataset) if {"PH", "PHB"} <= set(dataset.data_vars) else dataset


def _wrf(dataset):
    added = {"altitude": ((dataset["PH"] + dataset["PHB"]) / WRF_GRAVITY, "m", "altitude")}
    if {"P", "PB"} <= set(dataset.data_vars):
        added["air_pressure"] = dataset["P"] + dataset["PB"], "Pa", "air_pressure"
    if "T" in dataset.data_vars:
        added["theta"] = dataset["T"] + WRF_TEMPERATURE, "K", "air_potential_temperature"
    dataset = dataset.drop_vars([name for name in ("PH", "PHB", "P", "PB", "T") if name in dataset])
    dataset = dataset.assign({name: field.assign_attrs(units=units, standard_name=standard) for name, (field, units, standard) in added.items()})
    for name in ("U", "V"):
        if name in dataset:
            dataset[name] = dataset[name].assign_attrs(nephoscope_along_grid=1)
    return dataset
