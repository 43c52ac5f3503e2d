# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Datasets of models with conventions of their own, brought to those that `Reading` knows."""
from __future__ import annotations


def prepared(dataset):
    return dataset
