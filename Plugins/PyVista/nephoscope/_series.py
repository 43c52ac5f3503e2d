# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes at several times as the source of a pipeline."""
from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Sequence, Union

import pyvista
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP

from ._checks import require_number
from ._typing import Numbers

Grids = Union[pyvista.DataSet, Sequence[pyvista.DataSet], Callable[[float], pyvista.DataSet]]


def dataset(mesh: Any, argument: str) -> pyvista.DataSet:
    if not isinstance(mesh, vtkDataSet):
        raise TypeError(f"{argument} is a {type(mesh).__name__}; it must be a dataset, not blocks of datasets.")
    return pyvista.wrap(mesh)


class Series(VTKPythonAlgorithmBase):
    """The grids as a source with time steps. `failure`: the exception of the user's function."""

    def __init__(self, mesh: Any, times: Numbers | None) -> None:
        self.times = [0.0] if times is None else [require_number(one, "times") for one in times]
        self.failure: BaseException | None = None
        if not self.times:
            raise ValueError("times is empty; it must name the time of each grid.")
        if callable(mesh):
            self._read = mesh
        else:
            # A MultiBlock is a sequence too, but for a single time.
            is_series = isinstance(mesh, Sequence) and not isinstance(mesh, vtkDataObject)
            grids = list(mesh) if is_series else [mesh]
            if len(grids) != len(self.times):
                raise ValueError(f"There are {len(grids)} grids and {len(self.times)} times; the numbers must be equal.")
            times = self.times
            self._read = lambda time: grids[times.index(time)]  # without a reference to this: Python does not collect cycles through objects of VTK
        self.first = dataset(self._read(self.times[0]), "mesh")
        self._waiting = self.first
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=self.first.GetClassName())
        self.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)  # the failure is raised

    def meshes(self) -> Iterator[pyvista.DataSet]:
        """Yields the mesh of each time in order, each read on demand."""
        yield self.first
        yield from (dataset(self._read(time), "mesh") for time in self.times[1:])

    @contextmanager
    def raising(self) -> Iterator[None]:
        """Raises the exception of the user's function at the end of the block."""
        try:
            yield
        finally:
            if self.failure is not None:
                failure, self.failure = self.failure, None
                raise failure

    def RequestInformation(self, _request: Any, _inputs: Any, outputs: Any) -> int:
        info = outputs.GetInformationObject(0)
        if hasattr(self.first, "GetExtent"):
            info.Set(SDDP.WHOLE_EXTENT(), self.first.GetExtent(), 6)
        if len(self.times) > 1:
            info.Set(SDDP.TIME_STEPS(), self.times, len(self.times))
            info.Set(SDDP.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, _request: Any, _inputs: Any, outputs: Any) -> int:
        info = outputs.GetInformationObject(0)
        time = self.times[0]
        if len(self.times) > 1 and info.Has(SDDP.UPDATE_TIME_STEP()):
            asked = info.Get(SDDP.UPDATE_TIME_STEP())
            time = min(self.times, key=lambda one: abs(one - asked))
        try:
            read, self._waiting = self._waiting if time == self.times[0] else None, None
            read = dataset(self._read(time), "mesh") if read is None else read
        except Exception as failure:  # raised again by the caller of the pipeline
            self.failure = failure
            return 0
        output = vtkDataSet.GetData(outputs)
        output.ShallowCopy(read)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1
