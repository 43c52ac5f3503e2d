# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What `animate` takes besides datasets: files of meshes, and blocks, each of which becomes one mesh."""
from __future__ import annotations

import glob
import logging
import re
import warnings
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Callable, Iterator

import pyvista
from vtkmodules.vtkCommonCore import vtkLogger

from ._blocks import cell_dimension, matching_arrays, named_blocks
from ._checks import listed
from ._pipeline import level_of_caller
from .weather.foreign import ENDINGS

_PART = re.compile("Error reading (ascii|binary|cell|polygons)|Cannot read (point|cell) data")  # what VTK's reader of .vtk files says of one that ends early, and goes on


def are_mesh_files(path: Any) -> bool:
    """Whether `path` is the path of a file of a mesh, or a pattern of such paths."""
    return isinstance(path, (str, Path)) and Path(path).suffix.lower() in ENDINGS


def expanded(path: str | Path) -> Path:
    """The path of a file that exists; FileNotFoundError otherwise."""
    if not Path(path).exists():
        raise FileNotFoundError(f"No such file: {path}")
    return Path(path)


def read_steps(path: str | Path, times: Any) -> tuple[Any, Any]:
    """The files of a pattern, or a function of the times that one file has; and the times."""
    text = str(path)
    if any(sign in text for sign in "*?[") and not Path(text).exists():
        found = sorted(glob.glob(text))
        if not found:
            raise FileNotFoundError(f"No such file: {text}")
        return found, times
    with _quiet():  # a damaged file is told below
        reader = pyvista.get_reader(str(expanded(path)))
        steps = list(getattr(reader, "time_values", []))
    if len(steps) < 2:
        try:
            complete(lambda: pyvista.read(text))
        except OSError as problem:
            raise OSError(f"The file {text!r} cannot be read: {str(problem).rstrip('.')}.") from problem
        raise TypeError(f"dataset is the single file {text!r}, which has one time; pass a list of files, one for each time, or a pattern such as 'case_*.vtu'.")
    if times is not None:
        raise TypeError(f"times is given, but the file {text!r} has its own times.")

    def read(time: float) -> Any:
        reader.set_active_time_value(time)
        return complete(reader.read)
    read.file = str(path)  # type: ignore[attr-defined]
    return read, steps


@contextmanager
def _quiet() -> Iterator[None]:
    """VTK's reports, and what pyvista's observers make of them, are not written inside the block."""
    verbosity, disabled = vtkLogger.GetCurrentVerbosityCutoff(), logging.root.manager.disable
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    logging.disable(logging.ERROR)
    try:
        yield
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
        logging.disable(disabled)


def complete(read: Callable[[], Any]) -> Any:
    """What `read` returns. OSError if VTK reports errors and it returns nothing, or only a part because a file ends early; the error stands for the reports."""
    mesh, failed = None, None
    with _quiet(), pyvista.VtkErrorCatcher(send_to_logging=False) as told, warnings.catch_warnings(record=True) as warned:
        try:
            mesh = read()
        except RuntimeError as problem:  # pyvista's, of what VTK reports last
            failed = problem
    texts = [event.alert for event in told.events] or ([str(failed)] if failed else [])
    nothing = mesh is None or not (mesh.n_blocks if isinstance(mesh, pyvista.MultiBlock) else mesh.n_points)
    if texts and (nothing or any(map(_PART.search, texts))):
        raise OSError(texts[0].split("): ", 1)[-1].split("\n")[-1].strip()) from failed
    for one in warned:
        warnings.warn(one.message, one.category, stacklevel=level_of_caller())
    return mesh


def one_volume(mesh: Any, warns: bool) -> Any:
    """The mesh of a file, and the blocks of a mesh as one dataset: those of the highest dimension, so that the boundary patches of a volume are left out."""
    mesh = complete(lambda: pyvista.read(mesh)) if isinstance(mesh, Path) else mesh
    if not isinstance(mesh, pyvista.MultiBlock):
        return mesh
    blocks = [(name, block) for name, block in named_blocks(mesh) if block.n_points]
    dimensions = [cell_dimension(block) for _, block in blocks]
    used = [block for (_, block), dimension in zip(blocks, dimensions) if dimension == max(dimensions)]
    others = [name for (name, _), dimension in zip(blocks, dimensions) if dimension < max(dimensions)]
    if others and warns:
        warnings.warn(f"Blocks that are not drawn, because others have cells of a higher dimension: {listed(others)}.", UserWarning, stacklevel=level_of_caller())
    return pyvista.MultiBlock(matching_arrays(used)).combine(merge_points=max(dimensions) == 3) if used else pyvista.UnstructuredGrid()
