# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a dataset, in one line: which of its parts is drawn, how much heights are exaggerated, and which kind of picture suits it."""
from __future__ import annotations

import warnings
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Callable, Sequence

import numpy as np
import pyvista

from .._medium import default_scalars
from .._pipeline import level_of_caller
from .accessor import FLAT, GLOBE, LOOK_OF_PLOT, WeatherAccessor
from .exaggeration import USUAL, suited
from .filled import filled
from .flat_picture import plotted_flat, plotted_section
from .in_the_sun import missing_air, sun_of
from .naming import refuse_unknown, title
from .one_level import part_of
from .picture import plotted as plotted_globe
from .sections import is_section
from .view import Frame

if TYPE_CHECKING:
    import xarray

OF_PICTURE = ("scalars", "screenshot", "view", "window_size", "background", "plotter")


@dataclass(frozen=True)
class Plot:
    """What `WeatherAccessor.plot` was asked for; `look` and `options` are its options for the picture and for the mesh."""
    dataset: xarray.Dataset
    scalars: str | None
    time: int | str | np.datetime64 | None
    exaggeration: float | None
    look: dict[str, Any]
    frame: Frame
    options: dict[str, Any]

    @property
    def is_lit(self) -> bool:
        """Whether the sun shines, which needs all water and the air."""
        return "sun" in self.look

    @property
    def accessor(self) -> WeatherAccessor:
        return WeatherAccessor(self.dataset)

    def title(self, grid: pyvista.DataSet) -> Callable[[str], str]:
        """The title of the scalar bar, for the name of an array."""
        return lambda name: title(self.dataset, grid, name)


def plotted(asked: Plot) -> pyvista.Plotter:
    """Draws the picture."""
    if asked.accessor._is_flat(asked.options):
        return _plotted_flat(asked)
    refuse_unknown("plot", asked.options, (*GLOBE, *OF_PICTURE, *LOOK_OF_PLOT))
    return _plotted_globe(replace(asked, dataset=part_of(asked.dataset, asked.scalars, asked.time, asked.options, asked.is_lit)))


def _suited(make: Callable[[float], pyvista.DataSet], usual: float, exaggeration: float | None) -> pyvista.DataSet:
    """The mesh that `make` returns for the factor that the user wants, or for one that suits it."""
    return suited(make, usual) if exaggeration is None else make(exaggeration)


def _plotted_globe(asked: Plot) -> pyvista.Plotter:
    found, options = asked.accessor._of_field(asked.scalars, asked.time, asked.options)
    if asked.is_lit:  # all water and the air, and what was asked for if it must be computed, such as a cloud fraction from the humidity
        reading = asked.accessor._reading(asked.time, asked.options)
        options = {**asked.options, "derive": list(dict.fromkeys([*_several(options.get("derive", ())), *missing_air(reading)]))}
    grid = _suited(lambda factor: asked.accessor.globe(time=asked.time, vertical_exaggeration=factor, **options), USUAL, asked.exaggeration)
    name = default_scalars(grid)[1] if found is None else found
    if not asked.is_lit and (parts := filled(asked.dataset, grid, name, asked.time, options)) is not None:
        if parts.time != asked.time:
            warnings.warn(f"{name!r} has no values at the first time: step {parts.time} is drawn, the first step with values.", UserWarning, stacklevel=level_of_caller())
        return plotted(replace(asked, scalars=name, dataset=parts.dataset, time=parts.time))
    look = asked.look
    if asked.is_lit:
        if found in grid.point_data or found in grid.cell_data:
            grid.set_active_scalars(found)  # what the camera looks at
        look, found = {**look, "sun": sun_of(look["sun"], reading, grid)}, None
    draw = plotted_section if is_section(grid) else plotted_globe
    return draw(grid, found, asked.frame, look, asked.title(grid))


def _several(names: str | Sequence[str]) -> Sequence[str]:
    return [names] if isinstance(names, str) else names


def _plotted_flat(asked: Plot) -> pyvista.Plotter:
    options = {"time": asked.time, **asked.options}
    unknown = [name for name in options if name not in FLAT]
    if unknown:
        raise TypeError(f"plot() has no option {unknown[0]!r} for this dataset, whose x and y are lengths. It takes {', '.join((*FLAT, *OF_PICTURE, *LOOK_OF_PLOT))}.")
    found, of_field = asked.accessor._of_field(asked.scalars, None, options)
    found, options = (None, options) if asked.is_lit else (found, of_field)
    grid = _suited(lambda factor: asked.accessor.grid(vertical_exaggeration=factor, **options), 1.0, asked.exaggeration)
    return plotted_flat(grid, found, asked.frame, asked.look, asked.title(grid))
