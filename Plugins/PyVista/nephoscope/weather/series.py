# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a dataset as meshes, and one mesh whose values follow the time."""
from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Callable

import numpy as np
import pyvista

from .._over_time import follow
from .reading import Reading
from .roles import ROLES
from .times import listed_times, seconds_of, time_dims, when

SAMPLED_STEPS = 50  # sampled for the range of colours and opacities if no limits are given
SAMPLED_VALUES = 4096  # per step, including its least and greatest


class Series(Sequence):
    """The meshes of all time steps, each made on demand, and `mesh`, whose values `show` replaces.

    A worker thread reads the next step while one is on display. The cells of `mesh` and, unless `heights` is True, its points stay those of the first
    step. If a function draws an array of `mesh` without limits of its own, colours and opacities cover the range of all steps; of more than 50 steps, 50
    evenly spaced ones are sampled, including the first and the last. ``with dataset.nephoscope.series() as series`` ends the worker, as `close` does.
    """

    def __init__(self, dataset, *, heights: bool = False, owned: bool = False, **options: Any) -> None:
        self._dataset, self._options, self._heights, self._owned = dataset, options, heights, owned
        self._dim = next((dim for dim in time_dims(dataset) if dataset.sizes[dim] > 1), None)
        self._worker, self._coming, self._samples, self._listeners = ThreadPoolExecutor(1), {}, {}, []
        self.times = listed_times(dataset) or [""]
        self.mesh = self[0]
        self._follow()

    def _follow(self) -> None:
        """Lets colours and opacities of `mesh`, which has the values of the first step, suit all steps."""
        follow(self.mesh, self)
        self.step = 0
        self._prefetch(1)

    def __len__(self) -> int:
        return 1 if self._dim is None else self._dataset.sizes[self._dim]

    def __enter__(self) -> Series:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        """End the worker, and close the dataset if `animate` opened it. `mesh` keeps its values; no other step can be read."""
        self._worker.shutdown(cancel_futures=True)
        self._coming = {}
        if self._owned:
            self._dataset.close()

    @property
    def seconds(self) -> np.ndarray:
        """Seconds since the first step; step numbers if the dataset has no dates."""
        seconds = seconds_of(times) if self._dim and (times := when(self._dataset, self._dim)) is not None else None
        return np.arange(len(self), dtype=float) if seconds is None else seconds

    def __getitem__(self, step):
        if isinstance(step, slice):
            return [self[i] for i in range(*step.indices(len(self)))]
        if not -len(self) <= step < len(self):
            raise IndexError(f"step is {step}; there are {len(self)}.")
        return self._future(step % len(self)).result()

    def at(self, seconds: float) -> pyvista.DataSet:
        """The mesh of the step at `seconds`, as `advect_texture` and `flow_volume` ask for it: ``flow_volume(series.at, times=series.seconds, time=...)``."""
        return self[int(np.argmin(np.abs(self.seconds - seconds)))]

    def _future(self, step: int) -> Future:
        return self._coming.pop(step, None) or self._submit(self._read, step)

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

    # All steps

    def range(self, name: str) -> tuple[float, float]:
        """Least and greatest value of an array in all steps (for vectors, of their length), for use as colour limits: ``clim=series.range("cc")``."""
        values = np.concatenate(self.samples(name))
        return float(values.min()), float(values.max())

    def samples(self, name: str) -> list[np.ndarray]:
        """Finite values of an array for each sampled step, including its least and greatest; they are read once."""
        if name not in self._samples:
            self._samples[name] = [self._submit(self._sample, step, name).result() for step in self._sampled()]
        return self._samples[name]

    def greatest(self, name: str, measure: Callable[[np.ndarray], float]) -> pyvista.DataSet:
        """The mesh of the sampled step whose values have the greatest `measure`."""
        measures = [measure(values) if len(values) else -np.inf for values in self.samples(name)]
        step = int(self._sampled()[int(np.argmax(measures))])
        return self.mesh if step == self.step else self[step]

    def _sampled(self) -> np.ndarray:
        return np.unique(np.linspace(0, len(self) - 1, min(len(self), SAMPLED_STEPS)).round().astype(int))

    def _sample(self, step: int, name: str) -> np.ndarray:
        values = self._values(step, name)
        values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
        finite = values[np.isfinite(values)]
        if finite.size <= SAMPLED_VALUES:
            return finite
        places = np.arange(SAMPLED_VALUES) * 0.6180339887498949 % 1 * finite.size  # not at a step in which rows or levels repeat
        return np.append(finite[places.astype(int)], [finite.min(), finite.max()])

    def _values(self, step: int, name: str) -> np.ndarray:
        """The values at a step. If the mesh has the variable unchanged from the file, only the variable is read."""
        if step == self.step:
            return np.asarray(self.mesh[name])
        if self._dataset.nephoscope._is_flat(self._options):
            return np.asarray(self._dataset.nephoscope.mesh(**self._time(step), **{**self._options, **self._alone(name)})[name])
        reading = Reading(self._dataset, **self._time(step), vertical=self._options.get("vertical"), names={k: v for k, v in self._options.items() if k in ROLES})
        winds = {reading.roles.get(role) for role in "uvw"}
        return np.ravel(reading.values(name)).astype(np.float32) if name in set(reading.plain_variables()) - winds else np.asarray(self._read(step)[name])

    def _alone(self, name: str) -> dict[str, list[str]]:
        """The option of `grid` that reads this variable only."""
        return {"variables": [name]} if name in self._dataset.data_vars else {}

    # The step that is shown

    def listen(self, told: Callable[[int], Any]) -> None:
        """Registers `told`, which `show` calls with the step after it has updated `mesh`."""
        self._listeners.append(told)

    def show(self, step: int) -> None:
        """Gives `mesh` the values of a step; the time and the slider of `animate` follow. Draw it by ``plotter.render()``."""
        found = self[step]
        for here, there in ((self.mesh.point_data, found.point_data), (self.mesh.cell_data, found.cell_data)):
            for name in here.keys():
                if name in there and here[name].shape == there[name].shape:
                    here[name][...] = there[name]
                    here.VTKObject.GetAbstractArray(name).Modified()
        if self._heights:
            self.mesh.points = found.points
        self.mesh.Modified()
        self.step = step % len(self)
        for told in self._listeners:
            told(self.step)
        self._prefetch(self.step + 1)
