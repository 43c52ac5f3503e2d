# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a field in the form in which `plot` draws it, such as its lowest level."""
from __future__ import annotations

from typing import Any, Callable

import numpy as np
import pyvista

from .dataset_series import DatasetSeries
from .series import Series


class ReducedSeries(DatasetSeries):
    """A `DatasetSeries` whose meshes are what `reduced` makes of those of the dataset."""

    def __init__(self, dataset, reduced: Callable[[pyvista.DataSet], pyvista.DataSet], **options: Any) -> None:
        self._reduced = reduced
        super().__init__(dataset, **options)

    def _read(self, step: int) -> pyvista.DataSet:
        return self._reduced(super()._read(step))

    def _values(self, step: int, name: str) -> np.ndarray:
        return Series._values(self, step, name)  # not those of all points

    def _shape(self, found: pyvista.DataSet) -> None:
        if self.mesh.n_points == found.n_points:
            super()._shape(found)
        else:  # values are missing in other places
            self.mesh.deep_copy(found)
