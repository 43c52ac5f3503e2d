# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a section of the globe, as `plot` draws it: by latitude or longitude and height."""
from __future__ import annotations

from typing import Any, Callable

import pyvista

from .reduced_series import ReducedSeries
from .sections import unrolled


class SectionSeries(ReducedSeries):
    """A `ReducedSeries` whose meshes lie in the plane y = 0; all have the `scales` of the first, as `unrolled` returns them."""

    def __init__(self, dataset, form: Callable[[pyvista.DataSet], pyvista.DataSet] | None, shape: float, **options: Any) -> None:
        """`shape`: height of the first mesh over its width."""
        self._ratio, self.scales = shape, {}
        super().__init__(dataset, form or (lambda mesh: mesh), **options)

    def _read(self, step: int) -> pyvista.DataSet:
        sheet, scales = unrolled(super()._read(step), self._ratio, self.scales or None)
        self.scales = self.scales or scales
        return sheet
