# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""NetCDF files that follow the Climate and Forecast conventions, by VTK's own reader."""
from __future__ import annotations

import re
import warnings
from datetime import datetime, timedelta
from pathlib import Path
from typing import Sequence

import numpy as np
import pyvista
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

from ._checks import listed
from ._fields import choose_active_scalars
from ._pipeline import vtk_messages


def read_cf(path: str | Path, *, dimensions: str | Sequence[str] | None = None, variables: Sequence[str] | None = None,
            time_step: int | None = None) -> pyvista.DataSet:
    """Read the variables of one shape from a NetCDF file with CF conventions.

    Parameters
    ----------
    path : str or pathlib.Path
        The file, NetCDF classic or NetCDF-4.
    dimensions : str or sequence of str, optional
        Names of the dimensions of the variables to read, slowest first, as the file has them, separated by commas or one by one:
        ``("lev", "lat", "lon")``. Default: the longest combination in the file.
    variables : sequence of str, optional
        Names of the variables to read. Default: all on these dimensions.
    time_step : int, optional
        Index of the time step, from 0; negative counts from the end. Ignored if the file has no time. Default: the first, with a
        warning that reports the range if there are several. See `cf_times`.

    Returns
    -------
    pyvista.ImageData or pyvista.RectilinearGrid or pyvista.StructuredGrid
        Points at the coordinates as the file has them: x longitude and y latitude in degrees, z the level (negated by the
        reader where the file says ``positive: down``). One point array per variable, fill values as NaN.
        The active scalars are cloud fraction, cloud water or the first variable. If the file has times, the field array
        ``TimeValue`` is the time that was read, in ``time_units``.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    RuntimeError
        If the file is not NetCDF.
    ValueError
        If the dimensions, a variable or the time step are not in the file; the message lists what is.

    Warns
    -----
    UserWarning
        If the file has several times and `time_step` is not given.

    Examples
    --------
    >>> weather = nephoscope.read_cf("Data/gfs_2p5deg_2011101100.nc")  # doctest: +SKIP
    """
    reader, path = _opened(path)
    _select_variables(reader, path, _shape(reader, path, dimensions), variables)
    times = _times(reader)
    index = _time_index(times, time_step, path)
    with vtk_messages(reader):
        reader.UpdateTimeStep(times[index]) if times else reader.Update()
    mesh = pyvista.wrap(reader.GetOutputDataObject(0))
    if mesh.active_scalars_name is None or mesh.active_scalars_name not in mesh.point_data:
        choose_active_scalars(mesh)
    if times:
        mesh.field_data["TimeValue"] = [times[index]]
    if len(times) > 1 and time_step is None:
        told = cf_dates(times, _time_units(mesh))
        warnings.warn(f"{path} has {len(times)} times, {told[0]} to {told[-1]}; the first was read. Choose one with time_step, 0 to "
                      f"{len(times) - 1}, negative from the end; nephoscope.cf_times lists them.", UserWarning, stacklevel=2)
    return mesh


def cf_times(path: str | Path, *, dimensions: str | Sequence[str] | None = None) -> list[str]:
    """The times in a NetCDF file with CF conventions, in the order of the `time_step` of `read_cf`.

    Parameters
    ----------
    path : str or pathlib.Path
        The file.
    dimensions : sequence of str, optional
        As in `read_cf`: variables of other dimensions may have other times.

    Returns
    -------
    list of str
        Dates in ISO 8601 if the file's units and calendar allow it, otherwise numbers with their units. Empty if the file has no times.

    Raises
    ------
    FileNotFoundError, RuntimeError, ValueError
        As `read_cf` does.
    """
    reader, path = _opened(path)
    _select_variables(reader, path, _shape(reader, path, dimensions), None)
    times = _times(reader)
    if not times:
        return []
    with vtk_messages(reader):
        reader.UpdateTimeStep(times[0])  # the units come with the data
    return cf_dates(times, _time_units(pyvista.wrap(reader.GetOutputDataObject(0))))


def cf_dates(times: Sequence[float], units: str) -> list[str]:
    """`times` in `units` ("hours since 2011-01-01 00:00:00") as ISO dates; as numbers with units where that cannot be."""
    steps = {"d": 86400.0, "h": 3600.0, "m": 60.0, "s": 1.0}
    found = re.fullmatch(r"\s*(days?|d|hours?|hrs?|h|minutes?|mins?|seconds?|secs?|s) since (.+?)\s*", units, re.IGNORECASE)
    try:
        start = _date(found[2])
        return [(start + timedelta(seconds=steps[found[1][0].lower()] * t)).isoformat(sep=" ", timespec="minutes") for t in times]
    except (TypeError, ValueError, OverflowError):
        return [f"{t:g} {units}".strip() for t in times]


def _date(text: str) -> datetime:
    """2011-1-1, 2011-01-01T06:00Z, 2011-1-1 0:0:0.0 UTC; ValueError for another."""
    parts = re.fullmatch(r"(\d{1,4})-(\d{1,2})-(\d{1,2})(?:[ T]+(\d{1,2})(?::(\d{1,2}))?(?::(\d{1,2})(?:\.\d*)?)?)?\s*(?:Z|UTC|GMT|[+-]?0?0:?00)?", text)
    if parts is None:
        raise ValueError(text)
    return datetime(*(int(part or 0) for part in parts.groups()))


def _opened(path: str | Path) -> tuple[vtkNetCDFCFReader, Path]:
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"No such file: {path}")
    reader = vtkNetCDFCFReader()
    reader.SetFileName(str(path))
    reader.SphericalCoordinatesOff()
    reader.ReplaceFillValueWithNanOn()
    with vtk_messages(reader):
        reader.UpdateInformation()
    return reader, path


def _times(reader: vtkNetCDFCFReader) -> tuple[float, ...]:
    reader.UpdateInformation()
    return tuple(reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ())


def _time_units(mesh: pyvista.DataSet) -> str:
    """Empty for a calendar whose years are not those of the world: its dates are not told."""
    fields = {name: str(np.ravel(mesh.field_data[name])[0]) for name in ("time_units", "time_calendar") if name in mesh.field_data}
    units, calendar = fields.get("time_units", ""), fields.get("time_calendar", "standard").lower()
    return units if calendar in ("standard", "gregorian", "proleptic_gregorian", "") else f"{units} ({calendar})"


def _time_index(times: tuple[float, ...], time_step: int | None, path: Path) -> int:
    if times and time_step is not None and not -len(times) <= time_step < len(times):
        raise ValueError(f"time_step is {time_step}; {path} has {len(times)} time steps, from 0.")
    return time_step or 0


def _strings(array: object) -> list[str]:
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def _shape(reader: vtkNetCDFCFReader, path: Path, dimensions: str | Sequence[str] | None) -> str:
    available = _strings(reader.GetAllDimensions())
    if not available:
        raise ValueError(f"{path} has no variable with dimensions.")
    if dimensions is None:
        return max(available, key=lambda text: text.count(","))
    names = dimensions.strip(" ()").split(",") if isinstance(dimensions, str) else dimensions
    shape = "(" + ", ".join(name.strip() for name in names) + ")"
    if shape not in available:
        raise ValueError(f"dimensions: no variable of {path} has {shape}. There are: {'; '.join(available)}.")
    return shape


def _select_variables(reader: vtkNetCDFCFReader, path: Path, shape: str, variables: Sequence[str] | None) -> None:
    names, shapes = _strings(reader.GetAllVariableArrayNames()), _strings(reader.GetVariableDimensions())
    here = [name for name, its_shape in zip(names, shapes) if its_shape == shape]
    wanted = here if variables is None else [variables] if isinstance(variables, str) else list(variables)
    missing = [name for name in wanted if name not in here]
    if missing:
        raise ValueError(f"variables: {listed(missing)} not in {path} on {shape}. There are: {listed(here)}.")
    for name in names:  # SetDimensions() is left alone: it would undo the choice at the next update
        reader.SetVariableArrayStatus(name, int(name in wanted))

