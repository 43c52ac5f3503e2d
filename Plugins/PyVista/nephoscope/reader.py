# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads NetCDF files that follow the Climate and Forecast conventions, with VTK's own reader."""
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
from ._typing import Mesh, Numbers
from .weather.foreign import first_bytes, format_of, refusal


_REMEDY = ("VTK's reader accepts three dimensions, preceded by time if time has a coordinate with units. If time is not the first dimension: "
           "ncpdq -a time,lev,lat,lon IN OUT, or .transpose('time', ...) in xarray. If there are more dimensions, first write a file without the others: "
           "ncks -d Time,0 IN OUT for the first index of the dimension Time, or xarray.open_dataset(IN).isel(Time=0).to_netcdf(OUT). "
           "The variable is")
_WORDS = {"More than 3 dims without time not supported in variable": _REMEDY, "More than 3 dims + time not supported in variable": _REMEDY}


def read_cf(path: str | Path, *, dimensions: str | Sequence[str] | None = None, variables: Sequence[str] | None = None,
            time_step: int | None = None, missing_values: Numbers | None = None) -> Mesh:
    """Read the variables of one shape from a NetCDF file with CF conventions.

    Parameters
    ----------
    path : str or pathlib.Path
        The file, NetCDF classic or NetCDF-4.
    dimensions : str or sequence of str, optional
        Names of the dimensions of the variables to read, slowest first as in the file, in one string with commas or as a sequence: ``("lev",
        "lat", "lon")``. Default: the longest combination in the file.
    variables : sequence of str, optional
        Names of the variables to read. Default: all variables on these dimensions.
    time_step : int, optional
        Index of the time step, from 0; negative indices count from the end. Ignored if the file has no time. Default: the first time step, with
        a warning that reports the range if there are several. See `cf_times`.
    missing_values : sequence of float, optional
        Values that mean "missing" and become NaN, in addition to the ``_FillValue`` of the file. An empty sequence: no such values. Default:
        values such as -999, -9999 or 1e20 that are the minimum or maximum of a variable and far from all other values, with a warning.

    Returns
    -------
    pyvista.ImageData or pyvista.RectilinearGrid or pyvista.StructuredGrid
        Points at the coordinates of the file: x longitude and y latitude in degrees, z the level (negated if the file has ``positive: down``),
        whatever the order of the dimensions in the file. One point array per variable, with fill values as NaN. The active scalars are cloud
        fraction, cloud water or the first variable. If the file has times, the field array ``TimeValue`` is the time that was read, in
        ``time_units``.

    Raises
    ------
    FileNotFoundError
        If the file does not exist.
    ValueError
        If the file is not NetCDF; the message says what it is. If the dimensions, a variable or the time step are not in the file; the message lists what the file has. If the unlimited dimension of a
        NetCDF classic file has length 0.

    Warns
    -----
    UserWarning
        If the file has several times and `time_step` is not given, or if values are treated as missing.

    Examples
    --------
    >>> weather = nephoscope.read_cf(nephoscope.sample_data("gfs_2p5deg_2011101100.nc"))  # doctest: +SKIP
    """
    reader, path = _opened(path)
    shape = _shape(reader, path, dimensions)
    _select_variables(reader, path, shape, variables)
    times = _times(reader)
    index = _time_index(times, time_step, path)
    with vtk_messages(reader, _WORDS):
        reader.UpdateTimeStep(times[index]) if times else reader.Update()
    mesh = pyvista.wrap(reader.GetOutputDataObject(0))
    mesh = _axes_in_order(_with_spacing(mesh), shape)
    _mark_missing(mesh, missing_values)
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
    """List the times in a NetCDF file with CF conventions, in the order of `time_step` of `read_cf`.

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
    with vtk_messages(reader, _WORDS):
        reader.UpdateTimeStep(times[0])  # the units come with the data
    return cf_dates(times, _time_units(pyvista.wrap(reader.GetOutputDataObject(0))))


def cf_dates(times: Numbers, units: str) -> list[str]:
    """`times` in `units` ("hours since 2011-01-01 00:00:00") as ISO dates, or as numbers with units if that is impossible."""
    steps = {"d": 86400.0, "h": 3600.0, "m": 60.0, "s": 1.0}
    found = re.fullmatch(r"\s*(days?|d|hours?|hrs?|h|minutes?|mins?|seconds?|secs?|s) since (.+?)\s*", units, re.IGNORECASE)
    try:
        start = _date(found[2])
        return [(start + timedelta(seconds=steps[found[1][0].lower()] * t)).isoformat(sep=" ", timespec="minutes") for t in times]
    except (TypeError, ValueError, OverflowError):
        return [f"{t:g} {units}".strip() for t in times]


def _date(text: str) -> datetime:
    """A date such as 2011-1-1, 2011-01-01T06:00Z or 2011-1-1 0:0:0.0 UTC; ValueError for other forms."""
    parts = re.fullmatch(r"(\d{1,4})-(\d{1,2})-(\d{1,2})(?:[ T]+(\d{1,2})(?::(\d{1,2}))?(?::(\d{1,2})(?:\.\d*)?)?)?\s*(?:Z|UTC|GMT|[+-]?0?0:?00)?", text)
    if parts is None:
        raise ValueError(text)
    return datetime(*(int(part or 0) for part in parts.groups()))


def _opened(path: str | Path) -> tuple[vtkNetCDFCFReader, Path]:
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"No such file: {path}" + ", which is a folder" * path.is_dir())
    _require_records(path)
    reader = vtkNetCDFCFReader()
    reader.SetFileName(str(path))
    reader.SphericalCoordinatesOff()
    reader.ReplaceFillValueWithNanOn()
    try:
        with vtk_messages(reader, _WORDS):
            reader.UpdateInformation()
    except RuntimeError as problem:
        if "netCDF Error" not in str(problem):
            raise
        raise ValueError(_unreadable(path, problem)) from problem
    return reader, path


def _unreadable(path: Path, problem: RuntimeError) -> str:
    start = first_bytes(path)
    found = format_of(start)
    if found == "GRIB":
        return f"{path} is GRIB. Open it by nephoscope.open({str(path)!r})."
    if found == "NetCDF":
        return f"{path} cannot be read, probably because it is incomplete or damaged ({problem}). Fetch it again."
    return refusal(path, start, "`read_cf` reads NetCDF.")


def _require_records(path: Path) -> None:
    """Raises an error if the unlimited dimension of a NetCDF classic file has length 0, because VTK's reader would end the process."""
    with path.open("rb") as file:
        version = file.read(4)
        width = {b"CDF\x01": 4, b"CDF\x02": 4, b"CDF\x05": 8}.get(version, 0)  # of a count
        if not width:
            return
        number = lambda size=width: int.from_bytes(file.read(size), "big")
        records, tag, dimensions = number(), number(4), number()
        for _ in range(dimensions if tag == 10 and records == 0 else 0):
            length = number()
            name = file.read(length + -length % 4)[:length].decode(errors="replace")
            if number() == 0:
                raise ValueError(f"{path}: the unlimited dimension {name!r} has length 0, so there are no data along it. Write at least one "
                                 "record, or remove the dimension.")


def _times(reader: vtkNetCDFCFReader) -> tuple[float, ...]:
    reader.UpdateInformation()
    return tuple(reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ())


def _time_units(mesh: pyvista.DataSet) -> str:
    """The units of the time; empty for a calendar with artificial years, whose times are not shown as dates."""
    fields = {name: str(np.ravel(mesh.field_data[name])[0]) for name in ("time_units", "time_calendar") if name in mesh.field_data}
    units, calendar = fields.get("time_units", ""), fields.get("time_calendar", "standard").lower()
    return units if calendar in ("standard", "gregorian", "proleptic_gregorian", "") else f"{units} ({calendar})"


def _time_index(times: tuple[float, ...], time_step: int | None, path: Path) -> int:
    if times and time_step is not None and not -len(times) <= time_step < len(times):
        raise ValueError(f"time_step is {time_step}; {path} has {len(times)} time steps, from 0.")
    return time_step or 0


def _strings(array: object) -> list[str]:
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def cf_shapes(path: str | Path) -> list[str]:
    """The distinct dimensions of the variables of a file, without time, such as ``"(lev, lat, lon)"``."""
    return _strings(_opened(path)[0].GetAllDimensions())


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
    for name in names:  # SetDimensions() is not called: it would undo the choice at the next update
        reader.SetVariableArrayStatus(name, int(name in wanted))


# Usual names of the dimensions along x and y; z is the remaining dimension.
_X = ("lon", "longitude", "lons", "long", "rlon", "x", "west_east", "xc", "nlon", "ni")
_Y = ("lat", "latitude", "lats", "rlat", "y", "south_north", "yc", "nlat", "nj")


def _with_spacing(mesh: pyvista.DataSet) -> pyvista.DataSet:
    """Sets the spacing of axes with one value, for which the reader divides by 0."""
    if isinstance(mesh, pyvista.ImageData):
        mesh.spacing = [step if np.isfinite(step) else 1.0 for step in mesh.spacing]
        mesh.origin = [start if np.isfinite(start) else 0.0 for start in mesh.origin]
    return mesh


def _axes_in_order(mesh: pyvista.DataSet, shape: str) -> pyvista.DataSet:
    """Puts longitudes along x and latitudes along y if the names of the dimensions show that they are not."""
    names = [name.strip().lower() for name in shape.strip("()").split(",")][::-1]  # fastest first, without time
    along_x = next((axis for axis, name in enumerate(names) if name in _X), None)
    along_y = next((axis for axis, name in enumerate(names) if name in _Y), None)
    if along_x is None or along_y is None or (along_x, along_y) == (0, 1) or len(names) > 3 or isinstance(mesh, pyvista.StructuredGrid):
        return mesh
    order = [along_x, along_y] + [axis for axis in range(3) if axis not in (along_x, along_y)]
    grid = mesh if isinstance(mesh, pyvista.RectilinearGrid) else mesh.cast_to_rectilinear_grid()
    axes = (grid.x, grid.y, grid.z)
    turned = pyvista.RectilinearGrid(*(np.array(axes[axis]) for axis in order))
    for kind, sizes in (("point_data", grid.dimensions), ("cell_data", [max(1, size - 1) for size in grid.dimensions])):
        for name, values in getattr(grid, kind).items():
            values = np.asarray(values).reshape((*sizes[::-1], *np.shape(values)[1:]))
            order_back = [2 - axis for axis in order[::-1]]
            getattr(turned, kind)[name] = np.ascontiguousarray(values.transpose(order_back + list(range(3, values.ndim)))).reshape(
                -1, *values.shape[3:])
    turned.GetFieldData().PassData(grid.GetFieldData())  # PyVista does not take strings that are not ASCII
    if mesh.active_scalars_name in turned.point_data:
        turned.set_active_scalars(mesh.active_scalars_name)
    return turned


# Values that files without a _FillValue write for missing data.
_USUAL_MISSING = tuple(sign * value for value in (999, 999.9, 9999, 9999.9, 99999, 999999, 32767, 32768, 1e20, 1e30, 9.96921e36) for sign in (1, -1))


def _mark_missing(mesh: pyvista.DataSet, missing: Numbers | None) -> None:
    """NaN for values that mean "missing"."""
    taken = []
    for data in (mesh.point_data, mesh.cell_data):
        for name, values in data.items():
            if not np.issubdtype(values.dtype, np.floating):
                continue
            for value in _missing_of(values) if missing is None else missing:
                here = np.isclose(values, value, rtol=1e-6, atol=0)
                if here.any():
                    data[name] = np.where(here, np.nan, values)
                    values = data[name]
                    taken.append(f"{int(here.sum())} of {name!r} are {value:g}")
    if taken and missing is None:
        warnings.warn(f"Values treated as missing: {'; '.join(taken)}. Choose others with missing_values, or () for none.", UserWarning,
                      stacklevel=3)


def _missing_of(values: np.ndarray) -> list[float]:
    """Usual missing values at an end of the range and far from all other values: negative ones by half their size, positive ones by more than the range of the others."""
    found = []
    finite = values[np.isfinite(values)]
    for end, others in ((np.min, np.greater), (np.max, np.less)):
        if finite.size == 0:
            break
        value = float(end(finite))
        rest = finite[others(finite, value)]
        if rest.size == 0 or not any(np.isclose(value, usual, rtol=1e-6, atol=0) for usual in _USUAL_MISSING):
            continue
        nearest = np.abs(rest - value).min()
        if nearest > (0.5 * abs(value) if value < 0 else np.ptp(rest)):
            found.append(value)
            finite = rest
    return found
