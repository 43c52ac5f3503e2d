# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the viewer draws: a file that VTK's readers read, or weather that `nephoscope.open` reads."""
from __future__ import annotations

import logging
import warnings
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any, Callable, Iterator

import pyvista

from ._medium import wrapped
from ._mesh_files import complete
from .globe import to_globe
from .reader import cf_shapes, cf_times, read_cf
from .sparse import read_vdb
from .viewer_state import View
from .weather.foreign import ENDINGS, first_bytes, format_of, refusal

NETCDF = (".nc", ".nc4", ".cdf", ".netcdf")
READS = "The viewer draws NetCDF, GRIB, .vdb, and the files of meshes that pyvista.read reads, such as .vtu and .vti."
KEPT = 3  # number of meshes kept for the last times


def source_of(path: Path) -> MeshFile | WeatherFile:
    """The file by VTK's readers or, if they reject a NetCDF or GRIB file, by `nephoscope.open`. ValueError with one sentence if neither reads it."""
    try:
        return MeshFile(path)
    except Exception as refused:  # readers raise errors of any type
        start = first_bytes(path)
        if not format_of(start):
            raise ValueError(_unreadable(path, start, refused)) from refused
    try:
        with _silence():
            return WeatherFile(path)
    except Exception as problem:
        raise ValueError(f"{path} cannot be read: {one_sentence(problem)}") from problem


class MeshFile:
    """A file that VTK's readers or those of this package read. `times`: labels of its time steps; `ground`: its fields without levels, of a globe."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._read = lru_cache(KEPT)(self._read_file)
        self.is_globe = _is_on_a_globe(path, self._read(0))
        self.ground = _ground_of(path)
        self.times = tuple(cf_times(path)) if _is_netcdf(path) else ()

    def grid(self, time: int, exaggeration: float) -> pyvista.DataSet:
        """The mesh of a time step, on a globe with its heights multiplied by `exaggeration`, or unchanged from the file."""
        mesh = self._read(time)
        return to_globe(mesh, vertical_exaggeration=exaggeration, surface=self.ground) if self.is_globe else mesh

    def units(self, mesh: pyvista.DataSet, name: str) -> str:
        """The unit of an array of the mesh; "" if it is not known."""
        return str(mesh.field_data[f"{name}_units"][0]) if f"{name}_units" in mesh.field_data else ""

    def _read_file(self, time: int) -> pyvista.DataSet:
        with _silence():
            mesh = wrapped(_reader(self._path)(time), merge_points=False)
        if not isinstance(mesh, pyvista.DataSet) or mesh.n_points == 0:
            raise ValueError(f"{self._path} cannot be read, or has no points to draw.")
        return mesh


class WeatherFile:
    """Like `MeshFile`, for weather in a NetCDF or GRIB file, read by `nephoscope.open`."""
    ground = None

    def __init__(self, path: Path) -> None:
        from .weather.opening import open
        from .weather.times import listed_times
        self._dataset = open(path)
        self.times = tuple(listed_times(self._dataset))
        self.grid = lru_cache(KEPT)(self._grid)
        self.is_globe = "GlobeGridProjection" in self.grid(0, View().exaggeration).field_data  # as the first picture has it

    def _grid(self, time: int, exaggeration: float) -> pyvista.DataSet:
        """Like `MeshFile.grid`; heights of a flat grid are not exaggerated."""
        accessor = self._dataset.nephoscope
        return accessor.mesh(**({"time": time} if self.times else {}), vertical_exaggeration=1.0 if accessor._is_flat({}) else exaggeration)

    def units(self, mesh: pyvista.DataSet, name: str) -> str:
        """Like `MeshFile.units`."""
        from .weather.naming import UNITS
        told = self._dataset.variables[name].attrs.get("units", "") if name in self._dataset.variables else UNITS.get(name, "")
        return str(mesh.field_data[f"{name}_units"][0]) if f"{name}_units" in mesh.field_data else str(told)


def one_sentence(message: object) -> str:
    """The message on one line."""
    return " ".join(str(message).split())


@contextmanager
def _silence() -> Iterator[None]:
    """Suppresses the output of VTK's readers; the error is reported in one sentence."""
    with warnings.catch_warnings(), pyvista.vtk_verbosity("off"):
        warnings.simplefilter("ignore")
        disabled = logging.root.manager.disable
        logging.disable(logging.CRITICAL)
        try:
            yield
        finally:
            logging.disable(disabled)


def _reader(path: Path) -> Callable[[int], Any]:
    """Reads the file at a time step."""
    if _is_netcdf(path):
        return lambda time: read_cf(path, time_step=time)
    if path.suffix.lower() == ".vdb":
        return lambda time: read_vdb(path)
    return lambda time: complete(lambda: pyvista.read(path))


def _unreadable(path: Path, start: bytes, error: Exception) -> str:
    """What a file is that is not drawn, by its first bytes, or what its reader says of it."""
    if path.suffix.lower() in (*ENDINGS, *NETCDF, ".vdb"):
        told = one_sentence(error)
        return told if str(path) in told else f"{path} cannot be read: {told}"
    return refusal(path, start, READS)


def _is_netcdf(path: Path) -> bool:
    return path.suffix.lower() in NETCDF


def _dimensions(path: Path) -> list[list[str]]:
    """Dimensions of the variables of a NetCDF file, the longest first."""
    shapes = [shape.strip("()").replace(" ", "").split(",") for shape in cf_shapes(path)]
    return sorted(shapes, key=len, reverse=True)


def _is_on_a_globe(path: Path, mesh: pyvista.DataSet) -> bool:
    """True for longitudes and latitudes: axes with these names, or curvilinear rows, whose coordinates the reader takes from two variables."""
    if not _is_netcdf(path) or not isinstance(mesh, (pyvista.ImageData, pyvista.RectilinearGrid, pyvista.StructuredGrid)):
        return False
    named = any(name.lower().startswith("lat") for name in _dimensions(path)[0])
    low, high = mesh.bounds[2:4]
    return (named or isinstance(mesh, pyvista.StructuredGrid)) and -90.1 <= low <= high <= 90.1


def _ground_of(path: Path) -> pyvista.DataSet | None:
    """The fields without levels, on the last two dimensions of the others; None if there are none."""
    shapes = _dimensions(path) if _is_netcdf(path) else []
    if not shapes or len(shapes[0]) < 3 or shapes[0][-2:] not in shapes:
        return None
    return read_cf(path, dimensions=shapes[0][-2:], time_step=0)
