# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copies of what the functions that add to a plotter return: the same picture, and independent of the original."""
from __future__ import annotations

from typing import Any

import pyvista
from vtkmodules.vtkCommonDataModel import vtkPlane

from ._pipeline import warn_when_drawing


class MediumVolume(pyvista.Volume):
    """A `pyvista.Volume` whose copies have the place of the original, and colours that follow their own mapper."""

    def copy(self, deep: bool = True) -> MediumVolume:
        """A copy of this volume, with a mapper and a property of its own if `deep`; the data are shared."""
        volume = type(self)()
        volume.ShallowCopy(self)  # with place and visibility
        if deep:
            volume.user_matrix = self.user_matrix
            volume.prop, volume.mapper = self.prop.copy(), self.mapper.copy()
            volume.mapper.write_to(volume.prop)
        return volume


def copied_mapper(mapper: Any) -> Any:
    """A new mapper with the settings of `mapper`, clipping planes and lookup table of its own, and the same data."""
    copy = type(mapper)()
    copy.ShallowCopy(mapper)
    planes = mapper.GetClippingPlanes()
    copy.RemoveAllClippingPlanes()
    for i in range(planes.GetNumberOfItems() if planes is not None else 0):
        copy.AddClippingPlane(_copied_plane(planes.GetItemAsObject(i)))
    if mapper.lookup_table is not None:
        copy.lookup_table = copied_table(mapper.lookup_table)
    warn_when_drawing(copy)
    return copy


def _copied_plane(plane: vtkPlane) -> vtkPlane:
    copy = vtkPlane()
    copy.SetOrigin(plane.GetOrigin())
    copy.SetNormal(plane.GetNormal())
    copy.SetTransform(plane.GetTransform())
    return copy


def copied_table(table: Any) -> Any:
    """The colours of a scalar bar or of vectors; of a `pyvista.LookupTable` with what it knows beside."""
    copy = type(table)()
    copy.DeepCopy(table)
    copy.__dict__.update(getattr(table, "__dict__", {}))
    return copy
