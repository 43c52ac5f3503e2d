# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a dataset as meshes, and one mesh whose values follow the time."""
from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import numpy as np
import pyvista

from .identity import of_dataset
from .reading import Reading
from .roles import ROLES
from .series import Series
from .times import listed_times, seconds_of, time_dims, when


class DatasetSeries(Series):
    """A `Series` of the time steps of a dataset.

    A worker thread reads the next step while one is on display. The cells of `mesh` and, unless `heights` is True, its points stay those of the first
    step. ``with dataset.nephoscope.series() as series`` ends the worker, as `close` does.
    """

    def __init__(self, dataset, *, heights: bool = False, owned: bool = False, **options: Any) -> None:
        self._dataset, self._options, self._heights, self._owned = dataset, options, heights, owned
        self._dim = next((dim for dim in time_dims(dataset) if dataset.sizes[dim] > 1), None)
        self._worker = ThreadPoolExecutor(1)
        self._coming: dict[int, Future] = {}
        super().__init__(listed_times(dataset) or [""])
        self._begin()
        self._prefetch(self.step + 1)

    def __len__(self) -> int:
        return 1 if self._dim is None else self._dataset.sizes[self._dim]

    def close(self) -> None:
        """End the worker, and close the dataset if `animate` opened it. `mesh` keeps its values; no other step can be read."""
        self.stop()
        if self._owned:
            self._dataset.close()

    def stop(self) -> None:
        """End the worker."""
        self._worker.shutdown(cancel_futures=True)
        self._coming = {}

    @property
    def seconds(self) -> np.ndarray:
        """Seconds since the first step; step numbers if the dataset has no dates."""
        seconds = seconds_of(times) if self._dim and (times := when(self._dataset, self._dim)) is not None else None
        return np.arange(len(self), dtype=float) if seconds is None else seconds

    def identity(self) -> list:
        return of_dataset(self._dataset)

    def _file(self, step: int) -> str:
        return str(self._dataset.encoding.get("source", ""))

    def _mesh(self, step: int) -> pyvista.DataSet:
        return (self._coming.pop(step, None) or self._submit(self._read, step)).result()

    def _submit(self, *call: Any) -> Future:
        try:
            return self._worker.submit(*call)
        except RuntimeError as closed:
            raise ValueError("The series has been closed, so no more steps can be read. Make another one, dataset.nephoscope.series().") from closed

    def _read(self, step: int) -> pyvista.DataSet:
        return self._dataset.nephoscope.mesh(**self._time(step), **self._options)

    def _time(self, step: int) -> dict[str, int]:
        return {"time": step} if self._dim else {}

    def _prefetch(self, step: int) -> None:
        if step < len(self) and step not in self._coming:
            self._coming = {step: self._submit(self._read, step)}

    def _sample(self, step: int, name: str, component: int | None) -> np.ndarray:
        return self._submit(super()._sample, step, name, component).result()

    def _values(self, step: int, name: str) -> np.ndarray:
        """The values at a step. If the mesh has the variable unchanged from the file, only the variable is read."""
        if step == self.step:
            return super()._values(step, name)
        if self._dataset.nephoscope._is_flat(self._options):
            return np.asarray(self._dataset.nephoscope.mesh(**self._time(step), **{**self._options, **self._alone(name)})[name])
        reading = Reading(self._dataset, **self._time(step), vertical=self._options.get("vertical"), names={k: v for k, v in self._options.items() if k in ROLES})
        winds = {reading.roles.get(role) for role in "uvw"}
        return np.ravel(reading.values(name)).astype(np.float32) if name in set(reading.plain_variables()) - winds else super()._values(step, name)

    def _alone(self, name: str) -> dict[str, list[str]]:
        """The option of `grid` that reads this variable only."""
        return {"variables": [name]} if name in self._dataset.data_vars else {}

    def put(self, step: int, found: pyvista.DataSet) -> None:
        super().put(step, found)
        self._prefetch(self.step + 1)

    def _shape(self, found: pyvista.DataSet) -> None:
        if self._heights:
            self.mesh.points[...] = found.points  # in place: what is drawn may share them
            self.mesh.GetPoints().Modified()
