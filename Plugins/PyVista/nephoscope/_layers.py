# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers of a cell compositing mapper and their scalar bar, from the arguments of `add_cells`."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

from ._checks import arrays_of
from .transfer import colour_function


MOST_NAMED = 12  # layers with their number beside a scalar bar


def _colours_of(look: Any, bar: pyvista.LookupTable, argument: str) -> vtkColorTransferFunction:
    """One colour, or a colour map over the range of the volume's `bar`; a name that is both is a colour."""
    function = vtkColorTransferFunction()
    try:
        function.AddRGBPoint(0.0, *pyvista.Color(look).float_rgb)
        return function
    except (ValueError, TypeError):
        pass
    table = look
    if not isinstance(look, pyvista.LookupTable):
        try:
            table = pyvista.LookupTable()
            table.apply_cmap(look, 256)
        except (ValueError, TypeError, AttributeError) as error:
            raise TypeError(f"{argument} is {look!r}; it must be a colour, the name of a colour map or a volume property.") from error
        table.scalar_range, table.log_scale = bar.scalar_range, bar.log_scale
    return colour_function(table)


def _layer_property(look: Any, mapper: Any, volume: vtkVolumeProperty, argument: str) -> vtkVolumeProperty:
    """`look` if it is a property; otherwise a property with these colours and with the opacities and unit distance of the volume."""
    if isinstance(look, vtkVolumeProperty):
        return look
    prop = pyvista.VolumeProperty()
    prop.SetColor(_colours_of(look, mapper.lookup_table, argument))
    prop.SetScalarOpacity(volume.GetScalarOpacity())
    return prop


def _is_plain(look: vtkVolumeProperty) -> bool:
    """Whether a layer has one colour."""
    colours = look.GetRGBTransferFunction()
    nodes = np.zeros((colours.GetSize(), 6))
    for i, node in enumerate(nodes):
        colours.GetNodeValue(i, node)
    return bool(np.ptp(nodes[:, 1:4], axis=0).max(initial=0) == 0)


def _bytes(colour: Any, alpha: float) -> np.ndarray:
    return np.rint(255 * np.array([*colour, alpha]))


@dataclass
class Layers:
    """The arguments `layers` and `layer_scalars` of `add_cells`; see there. Checked when applied."""
    looks: Mapping[int, Any] | Sequence[Any] | None
    scalars: str | None

    def apply(self, mapper: Any, grid: pyvista.DataSet, count: int, volume: vtkVolumeProperty) -> None:
        """`count` contours divide the volume into layers."""
        if self.looks is None:
            if self.scalars is not None:
                raise ValueError("layer_scalars is given without layers, the colours or volume properties of the layers.")
            return
        if self.scalars is not None and self.scalars not in grid.cell_data:
            raise MissingDataError(f"layer_scalars: no cell array {self.scalars!r}. {arrays_of(grid)}")
        if self.scalars is None and count == 0:
            raise ValueError("layers need contours or layer_scalars: give one of the two.")
        looks = self._looks()
        beyond = [number for number in looks if not 0 <= number <= count] if self.scalars is None else []
        if beyond:
            raise ValueError(f"layers: there is no layer {beyond[0]}; contours at {count} value{'s' * (count > 1)} divide the volume into the layers "
                             f"0 to {count}.")
        for number, look in looks.items():
            if look is not None:
                mapper.SetLayerProperty(int(number), _layer_property(look, mapper, volume, f"layers[{number}]"))
        mapper.SetLayerArrayName(self.scalars or "")
        mapper.SetLayersFromContours(self.scalars is None)

    def bar(self, mapper: Any, grid: pyvista.DataSet, array_name: str, contoured: str, title: str) -> tuple[pyvista.LookupTable, str] | None:
        """The table and the title of a scalar bar with the colours of the layers; None if no bar can have them. `title`: that of the volume's bar.

        Layers of the coloured array have the range of the volume. If another array divides the volume (`contoured`, or `layer_scalars`), the bar is that of this array, and each layer needs one colour.
        """
        looks = {int(number): mapper.GetLayerProperty(int(number)) for number, look in self._looks().items() if look is not None}
        if self.scalars is not None:
            return self._bar_of_numbers(looks, np.asarray(grid.cell_data[self.scalars]))
        bounds = np.array([mapper.GetContourValue(i) for i in range(mapper.GetNumberOfContourValues())])
        table = pyvista.LookupTable()
        table.DeepCopy(mapper.lookup_table)
        own = contoured == array_name
        if not own:
            if set(looks) != set(range(len(bounds) + 1)) or not all(map(_is_plain, looks.values())):
                return None
            values = np.asarray(grid.point_data[contoured], float)
            table.log_scale, table.scalar_range = False, (np.nanmin(values), np.nanmax(values))
        low, high = table.scalar_range
        values = (np.geomspace if table.log_scale else np.linspace)(low, high, table.n_values)
        numbers = np.searchsorted(np.sort(bounds), values, side="right")
        for i, (value, number) in enumerate(zip(values, numbers)):
            if number in looks:
                alpha = looks[number].GetScalarOpacity().GetValue(value) if own else 1.0
                table.values[i] = _bytes(looks[number].GetRGBTransferFunction().GetColor(value), alpha)
        return table, title if own else contoured

    def _bar_of_numbers(self, looks: dict[int, vtkVolumeProperty], numbers: np.ndarray) -> tuple[pyvista.LookupTable, str] | None:
        """One colour for each layer number, with the number next to it."""
        present = np.unique(numbers[np.isfinite(numbers)]).astype(int)
        if not len(present) or not set(present) <= set(looks) or not all(_is_plain(looks[number]) for number in present):
            return None
        low, high = int(present[0]), int(present[-1])
        table = pyvista.LookupTable(n_values=high - low + 1, scalar_range=(low - 0.5, high + 0.5), annotations={float(number): str(number) for number in present[::1 + (len(present) - 1) // MOST_NAMED]})
        for number in range(low, high + 1):
            table.values[number - low] = _bytes(looks[number].GetRGBTransferFunction().GetColor(0.0), 1.0) if number in looks else (0, 0, 0, 0)
        return table, self.scalars

    def _looks(self) -> dict[int, Any]:
        """How to draw each layer, by number."""
        if isinstance(self.looks, (str, pyvista.Color, vtkVolumeProperty)) or not isinstance(self.looks, (Mapping, Sequence, np.ndarray)):
            raise TypeError(f"layers is {self.looks!r}; it must be a sequence, or a dict by layer number, of colours or volume properties: one for "
                            "each layer.")
        looks = dict(self.looks) if isinstance(self.looks, Mapping) else dict(enumerate(self.looks))
        for number in looks:
            if not isinstance(number, (int, np.integer)) or isinstance(number, bool):
                raise TypeError(f"layers has the key {number!r}; keys are the numbers of layers: 0, 1, ...")
        return looks
