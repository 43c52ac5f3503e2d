# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Datasets of models with conventions of their own, brought to those that `Reading` knows."""
from __future__ import annotations

WRF_GRAVITY = 9.81  # m/s2, the constant of WRF: its geopotential over this is its height
WRF_TEMPERATURE = 300.0  # K, what WRF's T is counted from


def prepared(dataset):
    """`dataset`, of one time, with the variables of WRF added up: pressure, potential temperature and height from perturbation and base state."""
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
