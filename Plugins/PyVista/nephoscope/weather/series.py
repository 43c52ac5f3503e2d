# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of several times, and one mesh whose values follow the time."""
from __future__ import annotations

import os
import warnings
import zlib
from abc import abstractmethod
from collections.abc import Sequence
from contextlib import contextmanager
from typing import Any, Callable, Iterator

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

from .._checks import arrays_of
from .._components import reduced
from .._over_time import follow
from .._pipeline import level_of_caller

SAMPLED_STEPS = 50  # sampled for the range of colours and opacities if no limits are given
SAMPLED_VALUES = 4096  # per step, including its least and greatest
UNREADABLE = (OSError, RuntimeError, EOFError, zlib.error)  # what libraries raise of damaged files
PACKAGE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "")


class UnreadableStep(OSError):
    """A time step cannot be read, because its file is damaged, incomplete or gone."""


class LackingStep(UnreadableStep):
    """A time step has no such array as is drawn."""


class Series(Sequence):
    """The meshes of all time steps, each made on demand, and `mesh`, whose values `show` replaces.

    The cells of `mesh` stay those of the first step, unless a kind of series says otherwise. If a function draws an array of `mesh` without limits, colours
    and opacities cover the range of all steps. If there are more than 50, 50 evenly spaced steps are sampled, including the first and the last.
    """

    def __init__(self, times: list[str]) -> None:
        self.times, self.step = times, 0
        self._samples: dict[tuple[str, int | None], list[np.ndarray]] = {}
        self._listeners: list[Callable[[int], Any]] = []
        self._unreadable: dict[int, UnreadableStep] = {}

    def _begin(self, wanted: Callable[[pyvista.DataSet], Any] = lambda mesh: True, copied: bool = False) -> None:
        """Makes `mesh`, with the values of the first step that can be read and is `wanted`, otherwise of the first that can be read. Colours and opacities are to suit all steps."""
        first = None
        for step in range(len(self)):
            found = self.attempt(step, self.__getitem__)
            if found is not None and (first is None or wanted(found)):
                first = step, found
                if wanted(found):
                    break
        if first is None:
            if len(self) == 1:
                raise self._unreadable[0]
            raise UnreadableStep(f"None of the {len(self)} time steps can be read. {self._unreadable[0]}") from self._unreadable[0]
        self.step, self.mesh = first[0], first[1].copy() if copied else first[1]
        follow(self.mesh, self)

    def __repr__(self) -> str:
        return f"<Series of {len(self)} steps, {self.times[0]} to {self.times[-1]}; at step {self.step}>"

    def __enter__(self) -> Series:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        """Ends the reading of steps; `mesh` keeps its values."""

    @property
    @abstractmethod
    def seconds(self) -> np.ndarray:
        """Seconds since the first step; step numbers if there are no times."""

    @abstractmethod
    def identity(self) -> Any:
        """What distinguishes the data from others, for JSON."""

    @abstractmethod
    def _file(self, step: int) -> str:
        """The file of a step; empty if it has none."""

    @abstractmethod
    def _read(self, step: int) -> pyvista.DataSet:
        """The mesh of a step, from 0."""

    def _mesh(self, step: int) -> pyvista.DataSet:
        """The mesh of a step, which may have been read before it was asked for."""
        return self._read(step)

    def __getitem__(self, step):
        if isinstance(step, slice):
            return [self[i] for i in range(*step.indices(len(self)))]
        if not -len(self) <= step < len(self):
            raise IndexError(f"step is {step}; there are {len(self)}.")
        with self._reading(step % len(self)):
            return self._mesh(step % len(self))

    def at(self, seconds: float) -> pyvista.DataSet:
        """The mesh of the step at `seconds`, as `advect_texture` and `flow_volume` ask for it: ``flow_volume(series.at, times=series.seconds, time=...)``."""
        return self[int(np.argmin(np.abs(self.seconds - seconds)))]

    def drawable(self, step: int) -> pyvista.DataSet | None:
        """The mesh of a step. If it cannot be read, or lacks an array that is drawn: None, and for each step one warning."""
        return self.attempt(step, self._drawable)

    def _drawable(self, step: int) -> pyvista.DataSet:
        found = self[step]
        for name in {name for name, _ in self._samples} & {*self.mesh.array_names}:
            self._require(step, found, name)
        return found

    def attempt(self, step: int, read: Callable[[int], Any]) -> Any:
        """What ``read(step)`` returns. If the step cannot be read: None, and for each step one warning."""
        try:
            with self._reading(step):
                return read(step)
        except UnreadableStep as problem:
            if step not in self._unreadable and len(self) > 1:
                warnings.warn(f"{problem} Another step is shown in its place.", RuntimeWarning, stacklevel=level_of_caller())
            self._unreadable[step] = problem
            return None

    @contextmanager
    def _reading(self, step: int) -> Iterator[None]:
        """Tells what libraries raise about a damaged file by an `UnreadableStep`. A RuntimeError of this package is about other things."""
        try:
            yield
        except UnreadableStep:
            raise
        except UNREADABLE as problem:
            if isinstance(problem, RuntimeError) and _raised_in(problem).startswith(PACKAGE):
                raise
            raise UnreadableStep(f"{self.told(step)} cannot be read: {str(problem).rstrip('.')}.") from problem

    def told(self, step: int) -> str:
        """A step in messages: with its time and its file."""
        file, time = self._file(step), self.times[step]
        return f"Time step {step}{f' ({time})' if time else ''}{f' of {file}' if file else ''}"

    # All steps

    def range(self, name: str) -> tuple[float, float]:
        """Minimum and maximum of an array in all steps (for vectors, of their length), for use as colour limits: ``clim=series.range("cc")``."""
        values = np.concatenate(self.samples(name))
        return float(values.min()), float(values.max())

    def samples(self, name: str, component: int | None = None) -> list[np.ndarray]:
        """Finite values of an array (for vectors, of their length or of a component) for each sampled step, including the minimum and maximum; they are read once."""
        if (name, component) not in self._samples:
            self._samples[name, component] = [self._sample_of(int(step), name, component) for step in self._sampled()]
        return self._samples[name, component]

    def step_with_greatest(self, name: str, measure: Callable[[np.ndarray], float], component: int | None = None) -> pyvista.DataSet:
        """The mesh of the sampled step whose values, as in `samples`, have the largest `measure`."""
        measures = [measure(values) if len(values) else -np.inf for values in self.samples(name, component)]
        step = int(self._sampled()[int(np.argmax(measures))])
        return self.mesh if step == self.step else self[step]

    def _sampled(self) -> np.ndarray:
        return np.unique(np.linspace(0, len(self) - 1, min(len(self), SAMPLED_STEPS)).round().astype(int))

    def _sample_of(self, step: int, name: str, component: int | None) -> np.ndarray:
        found = self.attempt(step, lambda step: self._sample(step, name, component))
        return np.zeros(0) if found is None else found

    def _sample(self, step: int, name: str, component: int | None) -> np.ndarray:
        values = reduced(self._values(step, name), component)
        finite = values[np.isfinite(values)]
        if finite.size <= SAMPLED_VALUES:
            return finite
        places = np.arange(SAMPLED_VALUES) * 0.6180339887498949 % 1 * finite.size  # not at a step in which rows or levels repeat
        return np.append(finite[places.astype(int)], [finite.min(), finite.max()])

    def _values(self, step: int, name: str) -> np.ndarray:
        found = self.mesh if step == self.step else self._read(step)
        if not found.n_points:
            return np.zeros(0)
        self._require(step, found, name)
        return np.asarray(found[name])

    def _require(self, step: int, found: pyvista.DataSet, name: str) -> None:
        """LackingStep unless `found`, the mesh of a step, has the array where `mesh` has it, or has no points. MissingDataError if `mesh` itself has none."""
        if not found.n_points:
            return
        if name not in found.array_names:
            words = f"{self.told(step)} has no array {name!r}. {arrays_of(found)}"
            raise MissingDataError(words) if name not in self.mesh.array_names else LackingStep(words)
        if (name in found.point_data) != (name in self.mesh.point_data):
            here, there = ("points", "cells") if name in found.point_data else ("cells", "points")
            raise LackingStep(f"{self.told(step)} has the array {name!r} on its {here}, others have it on their {there}. "
                              "Convert one of them, with mesh.cell_data_to_point_data() or mesh.point_data_to_cell_data().")

    # The step that is shown

    def listen(self, told: Callable[[int], Any]) -> None:
        """Registers `told`, which `show` calls with the step after it has updated `mesh`."""
        self._listeners.append(told)

    def show(self, step: int) -> None:
        """Gives `mesh` the values of a step; the time and the slider of `animate` follow. Draw it by ``plotter.render()``. An OSError that names the step and its file, if the file is damaged or gone,
        or lacks an array that is drawn."""
        if not -len(self) <= step < len(self):
            raise IndexError(f"step is {step}; there are {len(self)}.")
        self.put(step % len(self), self._drawable(step % len(self)))

    def put(self, step: int, found: pyvista.DataSet) -> None:
        """Gives `mesh` the values of `found`, the mesh of a step."""
        self._shape(found)
        for here, there in ((self.mesh.point_data, found.point_data), (self.mesh.cell_data, found.cell_data)):
            for name in here.keys():
                if name in there and here[name].shape == there[name].shape:
                    here[name][...] = there[name]
                    here.VTKObject.GetAbstractArray(name).Modified()
        self.mesh.Modified()
        self.step = step
        for told in self._listeners:
            told(self.step)

    def _shape(self, found: pyvista.DataSet) -> None:
        """Gives `mesh` what `found` has other than values."""


def _raised_in(problem: BaseException) -> str:
    """The file of the code that raised an exception."""
    place = problem.__traceback__
    while place is not None and place.tb_next is not None:
        place = place.tb_next
    return "" if place is None else os.path.abspath(place.tb_frame.f_code.co_filename)
