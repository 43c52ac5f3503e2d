# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads weather data for ParaView in a separate process: ``python -m nephoscope.weather.worker``, one request and one answer in JSON per line.

eccodes cannot run in ParaView's own process: its libraries and ParaView's have symbols with the same names, and the process would crash.
"""
from __future__ import annotations

import json
import re
import sys
import warnings

PYTHON = re.compile(r"\b(ds|dataset)\b[.,\[]|\b(globe|terrain|column|describe|open|merge)\(")  # what ParaView's panel does not have


def in_paraview(text: str, path: str) -> str:
    """A message of the package, and how a user of ParaView follows a remedy that is written in Python."""
    if not PYTHON.search(text):
        return text
    return (f"{text} (In ParaView: do that in Python, with ds = nephoscope.open({path!r}), save the result, ds.nephoscope.globe().save('globe.vtk') with the arguments that are named, "
            "and open globe.vtk.)")


class Worker:
    def __init__(self) -> None:
        self._dataset = self._level = None
        self.path, self._computed = "", []

    def open(self, path: str, mesh: str | None, grid: int | None) -> dict:
        import numpy as np

        import nephoscope
        from nephoscope.weather.derived import computable
        from nephoscope.weather.reading import Reading
        from nephoscope.weather.times import seconds_of, when
        self.path = path
        self._dataset = nephoscope.open(path, grid=grid, mesh=mesh)
        reading = Reading(self._dataset, time=0)
        self._level = reading.vertical.dim if reading.vertical else None
        dim = next((dim for dim in reading.times if self._dataset.sizes[dim] > 1), None)
        times = []
        if dim is not None:
            dates = when(self._dataset, dim)
            seconds = None if dates is None else seconds_of(dates)
            times = list(map(float, np.arange(self._dataset.sizes[dim]) if seconds is None else seconds / 3600))
        levels = self._dataset.sizes[self._level] if self._level else 1
        variables = reading.plain_variables()
        self._computed = [name for name in computable(reading) if name not in variables and name not in reading.roles]
        return {"times": times, "variables": variables, "computed": self._computed, "levels": levels}

    def mesh(self, file: str, step: int | None, levels: list[int], variables: list[str], options: dict) -> dict:
        from nephoscope._blocks import cell_dimension, outer_surface
        dataset = self._dataset
        if self._level and (levels[0] > 0 or levels[1] < dataset.sizes[self._level] - 1):
            dataset = dataset.isel({self._level: slice(max(0, levels[0]), levels[1] + 1)})
        derive = [name for name in variables if name in self._computed]
        grid = dataset.nephoscope.globe(variables=[name for name in variables if name not in derive], derive=derive, **({} if step is None else {"time": step}), **options)
        if cell_dimension(grid) < 3 and grid.GetClassName() == "vtkUnstructuredGrid":
            grid = outer_surface(grid)  # so that ParaView draws it as a surface
        grid.save(file)
        return {"kind": grid.GetClassName()}


def main() -> None:
    answers, sys.stdout = sys.stdout, sys.stderr
    worker = Worker()
    for line in sys.stdin:
        request = json.loads(line)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                answer = getattr(worker, request.pop("do"))(**request)
            except Exception as problem:  # shown in ParaView's window
                answer = {"error": in_paraview(str(problem), worker.path)}
        answer["warnings"] = [in_paraview(str(one.message), worker.path) for one in caught if one.category in (UserWarning, RuntimeWarning)]
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
