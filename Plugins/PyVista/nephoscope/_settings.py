# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The properties of mappers that PyVista knows. As with PyVista's own objects, other names cannot be set, because nothing would happen."""
from __future__ import annotations

from difflib import get_close_matches
from typing import Any

import numpy as np
import pyvista

from ._components import choose_component
from ._copies import CopiedMapper, copied_mapper
from ._typing import Numbers
from .transfer import beyond, colour_function, opacity_function

USUAL = {"clim": "scalar_range", "cmap": "lookup_table"}  # names of arguments


class KnownSettings(CopiedMapper):
    """Added to a mapper of VTK: raises AttributeError for a new attribute. Names that begin with an underscore are free."""

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and not hasattr(type(self), name):
            raise AttributeError(f"A {type(self).__name__} has no attribute {name!r} that can be set.{_hint(type(self), name)}")
        super().__setattr__(name, value)


def _hint(kind: type, name: str) -> str:
    settings = [known for known in dir(kind) if not known.startswith("_") and isinstance(getattr(kind, known), property) and getattr(kind, known).fset]
    setter = "Set" + "".join(word[:1].upper() + word[1:] for word in name.split("_"))
    if hasattr(kind, setter):
        return f" Call {setter}(...)."
    near = [USUAL[name]] if hasattr(kind, USUAL.get(name, "_")) else get_close_matches(name, settings, 1)
    return f" Set {near[0]}." if near else f" There are: {', '.join(settings)}." if settings else ""


class MediumMapper(KnownSettings):
    """Added to a volume mapper of VTK: the properties that PyVista's plotters and scalar bars read and write.

    Attributes
    ----------
    dataset : pyvista.DataSet
        The grid drawn.
    lookup_table : pyvista.LookupTable
        Colours of the scalar bar and, over its range, of the volume. Setting it changes the colours of the volume.
    scalar_range : tuple of float
        Range of the transfer functions. Setting it (`Plotter.update_scalar_bar_range` does) moves colours and opacities.
    """

    _prop: pyvista.VolumeProperty | None = None
    _table: Any = None
    _vectors: bool = False  # whether the scalars are vectors,
    _component: int | None = None  # of which this component, or else the magnitude, is drawn

    def attach(self, prop: pyvista.VolumeProperty, table: pyvista.LookupTable, opacities: np.ndarray,
               opacity_clim: tuple[float, float] | None) -> None:
        """Write colours and opacities to `prop`, now and whenever the scalar range changes.

        `opacity_clim` is the range of the opacities if they come from another array than the colours.
        """
        self.lookup_table = table
        self._opacities, self._opacity_clim = opacities, opacity_clim
        self.write_to(prop)

    def write_to(self, prop: pyvista.VolumeProperty) -> None:
        """Write colours and opacities to `prop` from now on."""
        self._prop = prop
        self.scalar_range = self.lookup_table.scalar_range

    def copy(self) -> MediumMapper:
        """A mapper with the same settings, independent of this one except for the shared data."""
        mapper = copied_mapper(self)
        mapper._prop, mapper._opacities, mapper._opacity_clim = self._prop, self._opacities, self._opacity_clim
        mapper._vectors, mapper._component = self._vectors, self._component
        return mapper

    @property
    def dataset(self) -> pyvista.DataSet:
        return pyvista.wrap(self.GetInputDataObject(0, 0))

    @property
    def lookup_table(self) -> Any:
        return self._table

    @lookup_table.setter
    def lookup_table(self, table: Any) -> None:
        self._table = table
        if self._prop is not None:
            self.scalar_range = table.scalar_range

    @property
    def scalar_range(self) -> tuple[float, float]:
        return self.lookup_table.scalar_range

    @scalar_range.setter
    def scalar_range(self, clim: Numbers) -> None:
        table = self.lookup_table
        low, high = clim
        table.scalar_range = (low if low > 0 or not table.log_scale else table.scalar_range[0], high)
        colours = colour_function(table)
        choose_component(colours, self._vectors, self._component)
        self._prop.SetColor(colours)
        if self._opacity_clim is None:
            opacity = opacity_function(self._opacities, table.scalar_range, table.log_scale)
            for scalar, colour in beyond(table):
                opacity.AddPoint(scalar, colour.float_rgba[3])
        else:
            opacity = opacity_function(self._opacities, self._opacity_clim, False)
        self._prop.GetScalarOpacity().DeepCopy(opacity)  # layers may share it
