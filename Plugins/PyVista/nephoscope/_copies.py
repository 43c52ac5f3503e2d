# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copies of the objects that functions such as add_cells return. A copy gives the same picture and is independent of the original."""
from __future__ import annotations

from typing import Any

import pyvista
from vtkmodules.vtkCommonDataModel import vtkPlane

from ._pipeline import warn_when_drawing


class CopiedMapper:
    """Added to a mapper with a method `copy`: Python's own copies are that one."""

    def __copy__(self) -> Any:
        return self.copy()

    def __deepcopy__(self, _memo: dict) -> Any:
        return self.copy()

    def __reduce_ex__(self, _protocol: Any) -> Any:
        raise TypeError("The mapper of a plotter cannot be pickled. Pickle its mesh, mapper.dataset, and add it to a plotter again.")


class MediumVolume(pyvista.Volume):
    """A `pyvista.Volume` whose copies have the position of the original, and colours that follow their own mapper."""

    def copy(self, deep: bool = True) -> MediumVolume:
        """A copy of this volume, with its own mapper and property if `deep`; the data are shared."""
        volume = type(self)()
        volume.ShallowCopy(self)  # with place and visibility
        if deep:
            volume.user_matrix = self.user_matrix
            volume.prop, volume.mapper = self.prop.copy(), self.mapper.copy()
            volume.mapper.write_to(volume.prop)
        return volume

    def __copy__(self) -> MediumVolume:
        return self.copy()

    def __deepcopy__(self, _memo: dict) -> MediumVolume:
        return self.copy()

    def __reduce_ex__(self, _protocol: Any) -> Any:
        raise TypeError("A volume in a plotter cannot be pickled. Pickle its mesh, volume.mapper.dataset, and add it to a plotter again.")


def copied_mapper(mapper: Any) -> Any:
    """A new mapper with the settings and the data of `mapper`, but its own clipping planes and lookup table."""
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
    """A copy of the colours of a scalar bar or of vectors, including the additional attributes of a `pyvista.LookupTable`."""
    copy = type(table)()
    copy.DeepCopy(table)
    copy.__dict__.update(getattr(table, "__dict__", {}))
    return copy
