# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a section of the globe, as `plot` draws it: by latitude or longitude and height."""
from __future__ import annotations

from typing import Any

import pyvista

from .dataset_series import DatasetSeries
from .sections import unrolled


class SectionSeries(DatasetSeries):
    """A `DatasetSeries` whose meshes lie in the plane y = 0; all have the `scales` of the first, as `unrolled` returns them."""

    def __init__(self, dataset, shape: float, **options: Any) -> None:
        """`shape`: height of the first mesh over its width."""
        self._ratio, self.scales = shape, {}
        super().__init__(dataset, **options)

    def _read(self, step: int) -> pyvista.DataSet:
        sheet, scales = unrolled(super()._read(step), self._ratio, self.scales or None)
        self.scales = self.scales or scales
        return sheet
