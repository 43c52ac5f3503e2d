# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What distinguishes data from others, without reading files: an interrupted film continues only with the same data."""
from __future__ import annotations

import os
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pyvista


def of_file(path: str | Path) -> list:
    """Path, size and time of the last change; the path alone of what is not on this machine."""
    try:
        about = os.stat(path)
    except OSError:
        return [str(path)]
    return [os.path.abspath(path), about.st_size, about.st_mtime_ns]


def of_mesh(mesh: pyvista.DataObject) -> Any:
    """Kind, sizes, and a checksum of points and arrays."""
    if isinstance(mesh, pyvista.MultiBlock):
        return [None if block is None else of_mesh(block) for block in mesh]
    arrays = [(name, values) for data in (mesh.point_data, mesh.cell_data) for name, values in sorted(data.items())]
    points = [("", mesh.points)] if mesh.IsA("vtkPointSet") else []
    return [mesh.GetClassName(), mesh.n_points, mesh.n_cells, *map(float, mesh.bounds), *([name, _checksum(values)] for name, values in points + arrays)]


def of_dataset(dataset: Any) -> list:
    """The files, and of each variable that has none its form and, if it is in memory, a checksum."""
    files = {str(one.encoding["source"]) for one in (dataset, *dataset.variables.values()) if "source" in one.encoding}
    return [[of_file(file) for file in sorted(files)], *([str(name), *_of_variable(variable)] for name, variable in sorted(dataset.variables.items(), key=lambda item: str(item[0])))]


def _of_variable(variable: Any) -> list:
    about = [list(map(str, variable.dims)), list(map(int, variable.shape)), str(variable.dtype)]
    in_memory = "source" not in variable.encoding and getattr(variable, "_in_memory", False)  # one with a file may be read meanwhile
    return [*about, _checksum(variable.values)] if in_memory else about


def _checksum(values: Any) -> int:
    values = np.asarray(values)
    return zlib.crc32(repr(values.tolist()).encode() if values.dtype.hasobject else np.ascontiguousarray(values).tobytes())
