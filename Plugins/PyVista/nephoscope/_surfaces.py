# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contour surfaces and polygons of a cell compositing mapper, from the arguments of `add_cells`."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

from ._checks import arrays_of, as_array, choose, require_number
from ._medium import require_scalars
from ._over_time import values_over_time
from ._pipeline import level_of_caller
from ._typing import Numbers


def _require_opacity(opacity: Any, argument: str) -> None:
    require_number(opacity, argument, least=0)
    if opacity > 1:
        raise ValueError(f"{argument} is {opacity:g}; it must be from 0 to 1.")


def _is_one_color(color: Any) -> bool:
    return color is None or isinstance(color, str) or (len(color) > 2 and np.isscalar(color[0]) and not isinstance(color[0], str))


POLYGON_NAMES = {"polygon_opacity": "opacity", "polygon_color": "color"}


@dataclass
class Polygons:
    """The options `polygons` of `add_cells`; see there. Checked when applied."""
    which: str = "contours"
    opacity: float | Numbers = 0.3
    color: Any = None

    def apply(self, mapper: Any) -> None:
        """One opacity and colour for all polygons, or one for each contour."""
        choose({"contours": mapper.SetPolygonsToContours, "all": mapper.SetPolygonsToAll, "none": mapper.SetPolygonsToNone}, self.which, "polygons")
        one_opacity, one_color = np.isscalar(self.opacity), _is_one_color(self.color)
        opacities, colors = [self.opacity] if one_opacity else list(self.opacity), [self.color] if one_color else list(self.color)
        for value in opacities:
            _require_opacity(value, "polygons['opacity']")
        rgb = [None if value is None else pyvista.Color(value).float_rgb for value in colors]
        if one_opacity:
            mapper.SetPolygonOpacity(-1, float(opacities[0]))
        if one_color and rgb[0]:
            mapper.SetPolygonColor(-1, *rgb[0])
        for i, value in enumerate([] if one_opacity else opacities):
            mapper.SetPolygonOpacity(i, float(value))
        for i, value in enumerate([] if one_color else rgb):
            mapper.SetPolygonColor(i, *value) if value else mapper.SetPolygonColorToFunction(i)


CONTOUR_NAMES = {"contour_opacity": "opacity", "contour_color": "color", "contour_scalars": "scalars", "contour_lighting": "lighting",
                 "smooth_contours": "smooth"}


@dataclass
class Contours:
    """The options `contours` of `add_cells`; see there. Checked when applied."""
    values: int | Numbers | None = None
    opacity: float | Numbers = 0.3
    color: Any = None
    scalars: str | None = None
    lighting: bool = True
    smooth: bool = True

    def apply(self, mapper: Any, grid: pyvista.DataSet, array_name: str, association: str, component: int | None) -> int:
        """Applies the contours and returns their number."""
        values = self._values(grid, array_name, association, component)
        opacities, colors = self._opacities(len(values)), self._colors(len(values))
        for i, value in enumerate(values):
            mapper.SetContourValue(i, value)
            mapper.SetContourOpacity(i, opacities[i])
            if colors[i] is not None:
                mapper.SetContourColor(i, *pyvista.Color(colors[i]).float_rgb)
        mapper.SetContourArrayName(self.scalars or "")
        mapper.SetContourLighting(self.lighting)
        mapper.SetSmoothContourNormals(self.smooth)
        return len(values)

    def _values(self, grid: pyvista.DataSet, array_name: str, association: str, component: int | None) -> list[float]:
        if self.values is None:
            if self.scalars is not None:
                raise ValueError("contours has the option 'scalars', but no 'values'; name the values.")
            return []
        if self.scalars is not None and self.scalars not in grid.point_data:
            raise MissingDataError(f"contours['scalars']: no point array {self.scalars!r}. {arrays_of(grid)}")
        if self.scalars is not None:
            require_scalars(grid, grid.point_data[self.scalars], self.scalars, "contours['scalars']")
        if self.scalars is None and association == "cell":
            raise ValueError(f"contours: {array_name!r} is a cell array, which has no surfaces inside its cells. "
                             "Use grid.cell_data_to_point_data(), or name a point array as contours['scalars'].")
        if isinstance(self.values, (int, np.integer)) and not isinstance(self.values, bool):
            if self.values < 1:
                raise ValueError(f"contours is {self.values}; a number of contours must be 1 or more.")
            return list(np.linspace(*self._range(grid, array_name, component), self.values + 2)[1:-1])
        try:
            values = np.atleast_1d(as_array(self.values))
            values = values.astype(float) if values.dtype.kind in "iuf" else np.array([np.nan])
        except ValueError:  # lists of different lengths
            values = np.array([np.nan])
        if values.ndim != 1 or not np.isfinite(values).all():
            raise ValueError(f"contours is {self.values!r}; it must be finite values, or a number of contours.")
        low, high = self._range(grid, array_name, component)
        if values.size and not ((values >= low) & (values <= high)).any():
            warnings.warn(f"contours: no value is within the range of {self.scalars or array_name!r}, {low:g} to {high:g}, so that no surface is drawn.", UserWarning,
                          stacklevel=level_of_caller())
        return [float(v) for v in values]

    def _range(self, grid: pyvista.DataSet, array_name: str, component: int | None) -> tuple[float, float]:
        scalars = np.asarray(values_over_time(grid, self.scalars or array_name, "point", component), float)  # a surface may come later
        scalars = scalars[np.isfinite(scalars)]
        return float(scalars.min(initial=np.inf)), float(scalars.max(initial=-np.inf))

    def _opacities(self, count: int) -> list[float]:
        opacities = [self.opacity] * count if np.isscalar(self.opacity) else list(self.opacity)
        if len(opacities) != count:
            raise ValueError(f"contours['opacity'] has {len(opacities)} values for {count} contours.")
        for opacity in opacities:
            _require_opacity(opacity, "contours['opacity']")
        return opacities

    def _colors(self, count: int) -> list[Any]:
        colors = [self.color] * count if _is_one_color(self.color) else list(self.color)
        if len(colors) != count:
            raise ValueError(f"contours['color'] has {len(colors)} colours for {count} contours.")
        return colors
