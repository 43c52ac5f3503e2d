# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors of a textured splat mapper, from the arguments of `add_splats`."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import pyvista

from ._checks import choose, require_beside_scalars, require_number
from ._medium import array_values, lookup_table
from .transfer import colour_function


@dataclass
class Vectors:
    """The arguments of `add_splats` about vectors; see there. Checked when applied."""
    name: str | None = None
    style: str = "streaks"
    placement: str = "middle"
    opacity: float = 2.0
    color: Any = None
    scalars: str | None = None
    cmap: Any = None
    clim: float | Sequence[float] | None = None
    greatest_speed: float | None = None
    streak_period: float = 4.0
    phase_cycles: int = 4

    def apply(self, mapper: Any, plotter: pyvista.BasePlotter, mesh: pyvista.DataSet, association: str) -> None:
        choose({"streaks": mapper.SetVectorStyleToStreaks, "segments": mapper.SetVectorStyleToSegments}, self.style, "vector_style")
        choose({"middle": mapper.SetVectorPlacementToMiddle, "layers": mapper.SetVectorPlacementToLayers}, self.placement,
               "vector_placement")
        mapper.SetVectorOpacity(require_number(self.opacity, "vector_opacity", least=0))
        mapper.SetStreakPeriod(require_number(self.streak_period, "streak_period", least=0.01, most=1000))
        mapper.SetPhaseCycles(int(require_number(self.phase_cycles, "phase_cycles", least=1, most=1000)))
        if self.greatest_speed is not None:
            mapper.SetGreatestSpeed(require_number(self.greatest_speed, "greatest_speed", above=0))
        if self.name is not None:
            self._require_vectors(mesh, association)
            mapper.SetVectorArrayName(self.name)
        elif self.color is not None or self.scalars is not None:
            raise ValueError("vector_color or vector_scalars is given without vectors; name the array of vectors.")
        if self.color is not None:
            mapper.SetVectorColor(pyvista.Color(self.color).float_rgb)
            mapper.SetUseVectorColor(True)
        self._apply_colours(mapper, plotter, mesh, association)

    def _require_vectors(self, mesh: pyvista.DataSet, association: str) -> None:
        require_beside_scalars(mesh, self.name, association, "vectors")
        values = array_values(mesh, self.name, association)
        if values.ndim != 2 or values.shape[1] != 3:
            components = 1 if values.ndim == 1 else values.shape[1]
            raise ValueError(f"vectors: the array {self.name!r} has {components} components; three are needed.")

    def _apply_colours(self, mapper: Any, plotter: pyvista.BasePlotter, mesh: pyvista.DataSet, association: str) -> None:
        if self.scalars is None:
            if self.cmap is not None or self.clim is not None:
                raise ValueError("vector_cmap or vector_clim is given without vector_scalars, the array that they colour.")
            return
        if self.color is not None:
            raise ValueError("vector_color and vector_scalars are both given; vectors have one colour, or that of an array.")
        require_beside_scalars(mesh, self.scalars, association, "vector_scalars")
        values = np.asarray(array_values(mesh, self.scalars, association), float)
        values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
        table = self.cmap if isinstance(self.cmap, pyvista.LookupTable) else lookup_table(
            plotter, values, self.scalars, self.cmap, self.clim)
        mapper.SetVectorColorArrayName(self.scalars)
        mapper.SetVectorColorFunction(colour_function(table))
