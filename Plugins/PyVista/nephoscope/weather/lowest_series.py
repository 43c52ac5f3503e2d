# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a field that fills all of the air, as `plot` draws it: in its lowest level."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

from .dataset_series import DatasetSeries
from .lowest import lowest_level
from .series import Series


class LowestSeries(DatasetSeries):
    """A `DatasetSeries` whose meshes are those of `lowest_level`, of the array `name`."""

    def __init__(self, dataset, name: str, **options: Any) -> None:
        self._name = name
        super().__init__(dataset, **options)

    def _read(self, step: int) -> pyvista.DataSet:
        return lowest_level(super()._read(step), self._name)

    def _values(self, step: int, name: str) -> np.ndarray:
        return Series._values(self, step, name)  # not those of all levels
