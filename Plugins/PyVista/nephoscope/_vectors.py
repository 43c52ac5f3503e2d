# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors of a textured splat mapper, from the arguments of `add_splats`."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import pyvista

from ._checks import choose, require_beside_scalars, require_number
from ._medium import array_values, lookup_table
from ._pipeline import level_of_caller
from .transfer import colour_function


ALONE = 2.0  # optical depth of the fastest streaks
COLOURS = ("black", "white", "orangered")


def is_drawn(opacity: Any) -> bool:
    node = [0.0] * 4
    return any(opacity.GetNodeValue(i, node) and node[1] > 0 for i in range(opacity.GetSize()))


def _contrasting(background: Sequence[float], colours: np.ndarray) -> tuple[float, float, float]:
    """That of `COLOURS` which stands out best, from the background and from the mean of the medium's colours."""
    others = np.array([background, colours.mean(axis=0)])
    choices = [pyvista.Color(name).float_rgb for name in COLOURS]
    return max(choices, key=lambda choice: np.linalg.norm(others - choice, axis=1).min())


@dataclass
class Vectors:
    """The arguments of `add_splats` about vectors; see there. Checked when applied."""
    name: str | None = None
    style: str = "streaks"
    placement: str = "middle"
    opacity: float | None = None
    color: Any = None
    scalars: str | None = None
    cmap: Any = None
    clim: float | Sequence[float] | None = None
    greatest_speed: float | None = None
    streak_period: float = 4.0
    phase_cycles: int = 4
    share: float | None = None
    streak_width: float = 0.1
    segment_length: float = 2.0
    segment_width: float = 1.5
    unit: float | None = None
    layer_axis: str | int = "eye"
    phase_steps: int = 0
    table: pyvista.LookupTable | None = None  # of the colours by `scalars`, found when applied

    def apply(self, mapper: Any, plotter: pyvista.BasePlotter, mesh: pyvista.DataSet, association: str) -> None:
        choose({"streaks": mapper.SetVectorStyleToStreaks, "segments": mapper.SetVectorStyleToSegments}, self.style, "vector_style")
        choose({"middle": mapper.SetVectorPlacementToMiddle, "layers": mapper.SetVectorPlacementToLayers}, self.placement,
               "vector_placement")
        mapper.SetVectorOpacity(ALONE if self.opacity is None else require_number(self.opacity, "vector_opacity", least=0))
        mapper.SetVectorFraction(1.0 if self.share is None else require_number(self.share, "vector_share", above=0, most=1))
        mapper.SetStreakPeriod(require_number(self.streak_period, "streak_period", least=0.01, most=1000))
        mapper.SetPhaseCycles(int(require_number(self.phase_cycles, "phase_cycles", least=1, most=1000)))
        mapper.SetPhaseSteps(int(require_number(self.phase_steps, "phase_steps", least=0, most=1000)))
        mapper.SetStreakWidth(require_number(self.streak_width, "streak_width", least=0.001, most=10))
        mapper.SetSegmentLength(require_number(self.segment_length, "segment_length", least=0, most=1000))
        mapper.SetSegmentWidth(require_number(self.segment_width, "segment_width", least=0.1, most=100))
        if self.layer_axis not in ("eye", 0, 1, 2):
            raise ValueError(f"layer_axis is {self.layer_axis!r}; it must be one of 'eye', 0, 1, 2.")
        on_grid = isinstance(mesh, (pyvista.ImageData, pyvista.RectilinearGrid, pyvista.StructuredGrid))
        mapper.SetLayerAxis(int(self.layer_axis) if on_grid and self.layer_axis != "eye" else -1)
        if self.name is not None and self.placement == "layers" and not on_grid:
            self._warn_of_layers(mesh)
        if self.unit is not None:
            mapper.SetVectorUnit(require_number(self.unit, "vector_unit", above=0))
        if self.greatest_speed is not None:
            mapper.SetMaximumSpeed(require_number(self.greatest_speed, "greatest_speed", above=0))
        if self.name is not None:
            self._require_vectors(mesh, association)
            mapper.SetVectorArrayName(self.name)
        elif self.color is not None or self.scalars is not None:
            raise ValueError("vector_color or vector_scalars is given without vectors; name the array of vectors.")
        if self.color is not None:
            mapper.SetVectorColor(pyvista.Color(self.color).float_rgb)
            mapper.SetUseVectorColor(True)
        self._apply_colours(mapper, plotter, mesh, association)

    def _warn_of_layers(self, mesh: pyvista.DataSet) -> None:
        ignored = "" if self.layer_axis == "eye" else "layer_axis is ignored, and "
        warnings.warn(f"vector_placement='layers': only a structured grid (ImageData, RectilinearGrid, StructuredGrid) has layers; the mesh is drawn as "
                      f"{type(mesh).__name__}. Instead, {ignored}layers at right angles to the line of sight are drawn. Pass vector_placement='middle' for "
                      "pictures that change less with the view.", UserWarning, stacklevel=level_of_caller())

    def suit(self, mapper: Any, plotter: pyvista.BasePlotter, prop: pyvista.VolumeProperty) -> None:
        """Where a medium is drawn too, and the user has not said how: so that both can be read. After everything else is set."""
        if self.name is None or not is_drawn(prop.GetScalarOpacity()):
            return
        mapper.SuitVectorsToMedium(self.opacity is None, self.share is None and self.style == "streaks")
        if self.color is None and self.scalars is None:
            mapper.SetVectorColor(_contrasting(plotter.background_color.float_rgb, np.asarray(mapper.lookup_table.values)[:, :3] / 255.0))
            mapper.SetUseVectorColor(True)

    def add_bar(self, plotter: pyvista.BasePlotter, bar_args: dict | None) -> None:
        """The colours of the vectors, where they have an array of their own. Beside a bar that lies it stands: PyVista's lie too close for their titles."""
        if self.table is None:
            return
        shown = pyvista.DataSetMapper()
        shown.lookup_table, shown.scalar_range = self.table, self.table.scalar_range
        own = {name: value for name, value in (bar_args or {}).items() if name not in ("title", "mapper", "position_x", "position_y")}
        title = self.scalars if self.scalars not in plotter.scalar_bars else f"{self.scalars} of {self.name}"
        upright = {"vertical": True, "position_y": 0.28} if len(plotter.scalar_bars) else {}
        plotter.add_scalar_bar(**{**upright, **own, "title": title, "mapper": shown})

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
        self.table = table
