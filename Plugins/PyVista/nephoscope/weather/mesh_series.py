# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes at several times, which are in memory or come from a function, as a series that `animate` draws."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from typing import Any

import numpy as np
import pyvista

from .series import Series

ACCEPTED = "a list of PyVista datasets, one for each time, a dict {time: dataset}, or a function of one of `times`"


class MeshSeries(Series):
    """A `Series` of meshes that exist already, or of a function that returns the mesh of a time. They are not changed: `mesh` is a copy of the first."""

    def __init__(self, meshes: Any, times: Any = None) -> None:
        self._kept = None if callable(meshes) else [_wrapped(mesh) for mesh in (meshes.values() if isinstance(meshes, Mapping) else meshes)]
        self._labels = list(meshes) if isinstance(meshes, Mapping) else None if times is None else list(times)
        self._source: Any = meshes if callable(meshes) else None
        self._heights, self._owned, self._dim, self._coming, self._samples, self._listeners = False, False, None, {}, {}, []
        self._last: tuple[int, Any] = (-1, None)  # what the function has returned
        self._require_meshes()
        self.times = [str(i) for i in range(len(self))] if self._labels is None else [_told(time) for time in self._labels]
        self.step = -1  # of no values yet
        self.mesh = self[0].copy()
        self._follow()

    def _require_meshes(self) -> None:
        if self._labels is None and self._kept is None:
            raise TypeError("dataset is a function; pass times= with the values that it is called with.")
        if len(self) == 0:
            raise ValueError("dataset has no meshes; it must be " + ACCEPTED + ".")
        if self._kept is not None and self._labels is not None and len(self._labels) != len(self._kept):
            raise ValueError(f"There are {len(self._kept)} meshes and {len(self._labels)} times; the numbers must be equal.")
        for mesh in self._kept or ():
            _require_mesh(mesh, type(self._kept[0]))

    def __len__(self) -> int:
        return len(self._labels if self._kept is None else self._kept)

    def close(self) -> None:
        """Nothing has to be closed."""

    @property
    def seconds(self) -> np.ndarray:
        """Seconds since the first step: differences of dates, or of times that are numbers; otherwise step numbers."""
        times = np.asarray(range(len(self)) if self._labels is None else self._labels)
        if times.dtype == object and hasattr(times[0], "timestamp"):  # datetime
            times = np.array([time.timestamp() for time in times])
        if times.dtype.kind == "M":
            return (times - times[0]) / np.timedelta64(1, "s")
        return times.astype(float) - float(times[0]) if times.dtype.kind in "iuf" else np.arange(len(self), dtype=float)

    def _submit(self, *call: Any) -> Future:
        done: Future = Future()
        done.set_result(call[0](*call[1:]))
        return done

    def _prefetch(self, step: int) -> None:
        pass

    def _read(self, step: int) -> pyvista.DataSet:
        if self._kept is not None:
            return self._kept[step]
        if self._last[0] != step:
            found = _wrapped(self._source(self._labels[step]))
            _require_mesh(found, type(getattr(self, "mesh", found)))
            self._last = (step, found)
        return self._last[1]

    def _values(self, step: int, name: str) -> np.ndarray:
        return np.asarray((self.mesh if step == self.step else self._read(step))[name])

    def show(self, step: int) -> None:
        """Gives `mesh` the values of a step and, where they differ, its points and cells; the time and the slider of `animate` follow."""
        found = self[step]
        if not _same_cells(self.mesh, found):
            self.mesh.deep_copy(found)
        super().show(step)


def is_meshes(dataset: Any) -> bool:
    """Whether `dataset` is meant as meshes of several times: something of VTK or PyVista, a function, or a list or dict of the former."""
    first = next(iter(dataset.values() if isinstance(dataset, Mapping) else dataset), None) if isinstance(dataset, (list, tuple, dict)) else dataset
    return isinstance(first, pyvista.DataObject) or hasattr(first, "GetDataObjectType") or callable(dataset)


def mesh_series(dataset: Any, times: Any) -> MeshSeries:
    """The series; TypeError for a single mesh."""
    if not callable(dataset) and not isinstance(dataset, (list, tuple, dict)):
        blocks = " If its blocks are times, pass list(dataset)." if isinstance(dataset, pyvista.MultiBlock) else ""
        raise TypeError(f"dataset is a single {type(dataset).__name__}; it must be {ACCEPTED}.{blocks}")
    if isinstance(dataset, Mapping) and times is not None:
        raise TypeError("times is given, but dataset is a dict, whose keys are the times.")
    return MeshSeries(dataset, times)


def _wrapped(mesh: Any) -> Any:
    return pyvista.wrap(mesh) if hasattr(mesh, "GetDataObjectType") else mesh


def _require_mesh(mesh: Any, kind: type) -> None:
    if not isinstance(mesh, pyvista.DataSet):
        remedy = " Combine its blocks: mesh.combine()." if isinstance(mesh, pyvista.MultiBlock) else ""
        raise TypeError(f"One of the meshes is a {type(mesh).__name__}; each must be a PyVista dataset.{remedy}")
    if not isinstance(mesh, kind):
        raise TypeError(f"One of the meshes is a {type(mesh).__name__}, another a {kind.__name__}; all must be of one type, for example by "
                        "mesh.cast_to_unstructured_grid().")


def _same_cells(mesh: pyvista.DataSet, other: pyvista.DataSet) -> bool:
    bare = []
    for one in (mesh, other):
        one = one.copy(deep=False)
        one.clear_data()
        bare.append(one)
    return bare[0] == bare[1]


def _told(time: Any) -> str:
    return f"{time:g}" if isinstance(time, (int, float, np.number)) and not isinstance(time, np.timedelta64) else str(time)
