# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes at several times, which are in memory or come from a function, as a series that `animate` draws."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
import pyvista

from .._mesh_files import are_mesh_files, expanded, one_volume, read_steps
from .identity import of_file, of_mesh
from .series import Series

ACCEPTED = "a list of PyVista datasets, one for each time, a dict {time: dataset}, or a function of one of `times`"


class MeshSeries(Series):
    """A `Series` of meshes that exist already, of files that have them, or of a function that returns the mesh of a time. They are not changed: `mesh` is a copy
    of the first that has points, and the array `name`, and gets the points and cells of each step. A mesh without points needs no arrays: nothing is drawn. Blocks become one mesh."""

    def __init__(self, meshes: Any, times: Any = None, name: str | None = None) -> None:
        self._source = meshes if callable(meshes) else [_wrapped(mesh) for mesh in (meshes.values() if isinstance(meshes, Mapping) else meshes)]
        self._labels = list(meshes) if isinstance(meshes, Mapping) else None if times is None else list(times)
        self._last: tuple[int, Any] = (-1, None)  # what has been made
        self._bounds: dict[int, tuple] = {}  # by step; of those that have been made
        self._require_meshes()
        self._sort()
        self._kind: type | None = None
        super().__init__([str(i) for i in range(len(self))] if self._labels is None else [_told(time) for time in self._labels])
        self._begin(lambda mesh: mesh.n_points and (name is None or name in mesh.array_names), copied=True)

    def _require_meshes(self) -> None:
        if self._labels is None and callable(self._source):
            raise TypeError("dataset is a function; pass times= with the values that it is called with.")
        if len(self) == 0:
            raise ValueError("dataset has no meshes; it must be " + ACCEPTED + ".")
        if callable(self._source):
            return
        if self._labels is not None and len(self._labels) != len(self._source):
            raise ValueError(f"There are {len(self._source)} meshes and {len(self._labels)} times; the numbers must be equal.")
        simple = [mesh for mesh in self._source if not isinstance(mesh, (pyvista.MultiBlock, Path))]
        for mesh in simple:
            _require_mesh(mesh, type(simple[0]))

    def _sort(self) -> None:
        """Sorts by time, if the times are numbers or dates."""
        if self._labels is None or not all(isinstance(time, (int, float, np.number, np.datetime64, date)) for time in self._labels):
            return
        undefined = [i for i, time in enumerate(self._labels) if time != time]  # NaN and NaT
        if undefined:
            raise ValueError(f"The time of mesh {undefined[0]} is {self._labels[undefined[0]]}; it must be a number or a date.")
        order = sorted(range(len(self._labels)), key=self._labels.__getitem__)
        self._labels = [self._labels[i] for i in order]
        if not callable(self._source):
            self._source = [self._source[i] for i in order]

    def __len__(self) -> int:
        return len(self._labels if callable(self._source) else self._source)

    @property
    def seconds(self) -> np.ndarray:
        """Seconds since the first step: differences of dates, or of times that are numbers; otherwise step numbers."""
        times = np.asarray(range(len(self)) if self._labels is None else self._labels)
        if times.dtype == object and hasattr(times[0], "timestamp"):  # datetime
            times = np.array([time.timestamp() for time in times])
        if times.dtype.kind == "M":
            return (times - times[0]) / np.timedelta64(1, "s")
        return times.astype(float) - float(times[0]) if times.dtype.kind in "iuf" else np.arange(len(self), dtype=float)

    @property
    def bounds(self) -> tuple[float, ...]:
        """Minimum and maximum of x, y and z over all steps, or of the sampled ones, as `pyvista.DataSet.bounds`: ``plotter.reset_camera(bounds=series.bounds)``."""
        for step in self._sampled():
            if int(step) not in self._bounds:
                self.attempt(int(step), self._read)
        found = np.array([box for box in self._bounds.values() if box[0] <= box[1]] or [self.mesh.bounds])
        return tuple(float(value) for pair in zip(found[:, ::2].min(axis=0), found[:, 1::2].max(axis=0)) for value in pair)

    @property
    def moves(self) -> bool:
        """Whether the steps have several bounds."""
        return not np.allclose(self.bounds, self.mesh.bounds, rtol=0, atol=1e-6 * max(self.mesh.length, 1e-300))

    @property
    def growth(self) -> float:
        """The diagonal of the largest step that has been read, over that of the step on display."""
        diagonals = [float(np.linalg.norm(np.subtract(box[1::2], box[::2]))) for box in self._bounds.values() if box[0] <= box[1]]
        return max([*diagonals, self.mesh.length]) / self.mesh.length if self.mesh.length else 1.0

    @property
    def moved(self) -> bool:
        """Whether the steps that have been read have several bounds."""
        return len(set(self._bounds.values())) > 1

    def identity(self) -> list:
        if callable(self._source):
            return [of_file(self._source.file)] if hasattr(self._source, "file") else []
        return [of_file(mesh) if isinstance(mesh, Path) else of_mesh(mesh) for mesh in self._source]

    def _file(self, step: int) -> str:
        source = getattr(self._source, "file", "") if callable(self._source) else self._source[step]
        return str(source) if isinstance(source, (str, Path)) else ""

    def _read(self, step: int) -> pyvista.DataSet:
        found = self._made(step)
        self._kind = self._kind or type(found)
        _require_mesh(found, self._kind)
        self._bounds[step] = tuple(found.bounds) if found.n_points else (1.0, -1.0, 1.0, -1.0, 1.0, -1.0)
        return found

    def _made(self, step: int) -> Any:
        """The mesh of a step; the last one is kept, because a function, a file or blocks take time."""
        if self._last[0] != step:
            found = _wrapped(self._source(self._labels[step]) if callable(self._source) else self._source[step])
            self._last = (step, one_volume(found, warns=self._last[0] < 0))
        return self._last[1]

    def _shape(self, found: pyvista.DataSet) -> None:
        if not _same_cells(self.mesh, found):
            self.mesh.deep_copy(found if found.n_points else _emptied(self.mesh))


def is_meshes(dataset: Any) -> bool:
    """Whether `dataset` is meant as meshes of several times: something of VTK or PyVista, files of meshes, a function, or a list or dict of these."""
    if isinstance(dataset, (list, tuple, dict)) and not dataset:
        raise ValueError(f"dataset is empty; it must be {ACCEPTED}.")
    if isinstance(dataset, Iterator):
        raise TypeError(f"dataset is a {type(dataset).__name__}, which can be read only once; pass list(dataset).")
    first = next(iter(dataset.values() if isinstance(dataset, Mapping) else dataset), None) if isinstance(dataset, (list, tuple, dict)) else dataset
    return isinstance(first, pyvista.DataObject) or hasattr(first, "GetDataObjectType") or callable(dataset) or are_mesh_files(first)


def mesh_series(dataset: Any, times: Any, name: str | None) -> MeshSeries:
    """The series, of which the array `name` is drawn; TypeError for a single mesh."""
    if are_mesh_files(dataset):
        dataset, times = read_steps(dataset, times)
    if not callable(dataset) and not isinstance(dataset, (list, tuple, dict)):
        blocks = " If its blocks are times, pass list(dataset)." if isinstance(dataset, pyvista.MultiBlock) else ""
        raise TypeError(f"dataset is a single {type(dataset).__name__}; it must be {ACCEPTED}.{blocks}")
    if isinstance(dataset, Mapping) and times is not None:
        raise TypeError("times is given, but dataset is a dict, whose keys are the times.")
    return MeshSeries(dataset, times, name)


def _wrapped(mesh: Any) -> Any:
    if are_mesh_files(mesh):
        return expanded(mesh)
    return pyvista.wrap(mesh) if hasattr(mesh, "GetDataObjectType") else mesh


def _require_mesh(mesh: Any, kind: type) -> None:
    if not isinstance(mesh, pyvista.DataSet):
        raise TypeError(f"One of the meshes is a {type(mesh).__name__}; each must be a PyVista dataset, or the path of a file of one.")
    if not isinstance(mesh, kind):
        raise TypeError(f"One of the meshes is a {type(mesh).__name__}, another a {kind.__name__}; all must be of one type, for example by "
                        "mesh.cast_to_unstructured_grid().")


def _emptied(mesh: pyvista.DataSet) -> pyvista.DataSet:
    """A mesh without points and cells that has the arrays of `mesh`, so that they are found."""
    empty = type(mesh)()
    for here, there in ((empty.GetPointData(), mesh.GetPointData()), (empty.GetCellData(), mesh.GetCellData())):
        here.CopyAllOn()
        here.CopyAllocate(there)
    empty.GetFieldData().ShallowCopy(mesh.GetFieldData())
    return empty


def _same_cells(mesh: pyvista.DataSet, other: pyvista.DataSet) -> bool:
    bare = []
    for one in (mesh, other):
        one = one.copy(deep=False)
        one.clear_data()
        bare.append(one)
    return bare[0] == bare[1]


def _told(time: Any) -> str:
    return f"{time:g}" if isinstance(time, (int, float, np.number)) and not isinstance(time, np.timedelta64) else str(time)
