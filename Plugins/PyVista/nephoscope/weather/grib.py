# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""GRIB files, editions 1 and 2, as one lazy xarray.Dataset: the headers are read once, a field is decoded when it is used.

Names, dimensions and attributes are those of cfgrib (``GRIB_shortName``, ``isobaricInhPa``, ...), but all types of level are in one dataset, and no index file is
written next to the data.
"""
from __future__ import annotations

import threading
import warnings
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Iterator

import numpy as np

from .._pipeline import level_of_caller
from .extras import need

MISSING = 9.999e35
ELSEWHERE = ("unstructured_grid", "healpix")  # grids whose places are in a file of the mesh, or follow from their numbers
LISTED_GRIDS = 8  # in a message
COMPARED_GRIDS = 32  # more are not compared point by point
LEVEL_UNITS = {"isobaricInhPa": ("hPa", "down"), "isobaricInPa": ("Pa", "down"), "heightAboveGround": ("m", "up"), "heightAboveSea": ("m", "up"), "hybrid": ("1", "down"),
               "sigma": ("1", "down"), "generalVerticalLayer": ("1", "down"), "generalVertical": ("1", "down"), "depthBelowLand": ("m", "down"), "hybridHeight": ("1", "up"),
               "hybridPressure": ("1", "up")}
# Read from every message; then from the first of each variable.
_HEADER = ("shortName", "typeOfLevel", "level", "md5GridSection", "gridType", "validityDate", "validityTime", "dataDate", "dataTime", "stepType", "paramId")
_GRID = ("gridType", "uvRelativeToGrid", "resolutionAndComponentFlags", "Latin1InDegrees", "Latin2InDegrees", "LaDInDegrees", "LoVInDegrees", "orientationOfTheGridInDegrees", "projectionCentreFlag",
         "southPoleOnProjectionPlane", "latitudeOfSouthernPoleInDegrees", "longitudeOfSouthernPoleInDegrees", "angleOfRotationInDegrees", "radius", "earthIsOblate",
         "earthMajorAxisInMetres", "earthMinorAxisInMetres", "N", "isOctahedral", "Nside", "orderingConvention", "numberOfGridInReference")
_ABOUT = ("shortName", "name", "units", "cfName", "cfVarName", "paramId", "typeOfLevel", "stepType", "edition", "centre")


class GribError(ValueError):
    """A GRIB file that cannot be read as one dataset; the message names the file, what is wrong and the remedy."""


@dataclass(frozen=True)
class Message:
    offset: int
    part: int  # among the fields of one message, which share its offset
    variable: tuple  # short name, parameter, type of level, kind of step
    level: float
    time: np.datetime64
    start: np.datetime64
    number: int
    grid: str
    grid_type: str


def open_grib(path: Path, grid: int | None):
    xarray = need("xarray", "reading GRIB")
    messages = _of_grid(path, scan(path), grid)
    layout = Layout(path, messages)
    dataset = xarray.Dataset(attrs={"Conventions": "CF-1.8", "source": str(path)}, coords=layout.coordinates())
    for name, variable in _named(messages).items():
        dataset[name] = layout.variable(xarray, variable)
    return dataset


# Headers

_READING = threading.RLock()


@contextmanager
def _every_field(ec, path: Path) -> Iterator[Any]:
    """The file, open for reading all fields of each message. eccodes has one switch for that in a process, so one thread reads at a time; cfgrib turns the switch off
    whenever it has read, and eccodes then returns the next message instead of a second field."""
    with _READING, path.open("rb") as file:
        ec.codes_grib_multi_support_on()
        try:
            yield file
        finally:
            ec.codes_grib_multi_support_reset_file(file)
            ec.codes_grib_multi_support_off()


def scan(path: Path) -> list[Message]:
    ec = need("eccodes", "reading GRIB")
    found: list[Message] = []
    with _every_field(ec, path) as file:
        try:
            while (handle := ec.codes_grib_new_from_file(file)) is not None:
                found.append(_message(ec, handle, found))
                ec.codes_release(handle)
        except ec.CodesInternalError as problem:
            raise GribError(f"{path}: after {len(found)} complete fields, the file ends early or is damaged ({problem}). Fetch it again"
                            + (f", or keep the complete fields: grib_copy -w count<{len(found) + 1} {path.name} OUT." if found else ".")) from problem
    if not found:
        raise GribError(f"{path} has no GRIB message.")
    return found


def _get(ec, handle, key: str, default=None):
    try:
        return ec.codes_get(handle, key)
    except ec.CodesInternalError:
        return default


def _message(ec, handle, before: list[Message]) -> Message:
    name, kind, level, grid, grid_type, date, hour, start_date, start_hour, step, parameter = (_get(ec, handle, key) for key in _HEADER)
    offset = int(_get(ec, handle, "offset", 0))
    part = before[-1].part + 1 if before and before[-1].offset == offset else 0
    return Message(offset, part, (str(name), int(parameter or 0), str(kind), str(step)), float(level or 0), _date(date, hour), _date(start_date, start_hour),
                   int(_get(ec, handle, "number", 0) or 0), str(grid), str(grid_type))


def _date(date: int | None, hour: int | None) -> np.datetime64:
    text = f"{int(date or 0):08d}"
    try:
        return np.datetime64(f"{text[:4]}-{text[4:6]}-{text[6:]}T{int(hour or 0) // 100:02d}:{int(hour or 0) % 100:02d}", "ns")
    except ValueError:
        return np.datetime64("NaT", "ns")


def _on_same_points(path: Path, messages: list[Message]) -> list[Message]:
    """Grids with the same points are one grid, also if their headers differ, for example in the shape of the Earth or in a list of levels."""
    first = {message.grid: message for message in reversed(messages)}
    if not 1 < len(first) <= COMPARED_GRIDS:
        return messages
    known: list[tuple] = []
    same = {}
    for key, message in first.items():
        places = message.grid_type, *_places(path, message)
        same[key] = next((grid for grid, other in known if places[0] == other[0] and places[1] is not None and all(map(np.array_equal, places[1:], other[1:]))), key)
        known.append((same[key], places))
    return [replace(message, grid=same[message.grid]) for message in messages]


def _places(path: Path, message: Message):
    ec = need("eccodes", "reading GRIB")
    with _handle(path, message) as handle:
        try:
            return tuple(ec.codes_get_array(handle, key) for key in ("latitudes", "longitudes"))
        except ec.CodesInternalError:
            return None, None


def _of_grid(path: Path, messages: list[Message], grid: int | None) -> list[Message]:
    messages = _on_same_points(path, messages)
    grids = list(dict.fromkeys(message.grid for message in messages))
    if grid is not None and not 0 <= grid < len(grids):
        raise GribError(f"grid is {grid}; {path} has {len(grids)} grids, from 0.")
    if len(grids) > 1 and grid is None:
        told = "; ".join(f"{i}: {_told(messages, key)}" for i, key in enumerate(grids[:LISTED_GRIDS])) + ("; ..." if len(grids) > LISTED_GRIDS else "")
        raise GribError(f"{path} has fields on {len(grids)} grids. Choose one with grid: {told}.")
    return [message for message in messages if message.grid == grids[grid or 0]]


def _told(messages: list[Message], grid: str) -> str:
    here = [message for message in messages if message.grid == grid]
    names = list(dict.fromkeys(message.variable[0] for message in here))
    return f"{here[0].grid_type}, {len(here)} fields ({', '.join(names[:6])}{', ...' if len(names) > 6 else ''})"


# Variables

def _named(messages: list[Message]) -> dict[str, list[Message]]:
    """Name -> messages. The type of level with the most fields gets the plain names. A level that stands apart from the others of its type becomes a separate variable."""
    groups: dict[tuple, list[Message]] = {}
    for message in messages:
        groups.setdefault(message.variable, []).append(message)
    by_kind: dict[str, int] = {}
    for variable, found in groups.items():
        by_kind[variable[2]] = by_kind.get(variable[2], 0) + len(found)
    order = sorted(groups, key=lambda variable: (-_several(groups[variable]), -by_kind[variable[2]], variable[2] not in ("surface", "meanSea")))
    named: dict[str, list[Message]] = {}
    for variable in order:
        named[_free_name(named, variable, groups[variable])] = groups[variable]
    return named


def _several(messages: list[Message]) -> bool:
    return len({message.level for message in messages}) > 1


def _free_name(taken, variable: tuple, messages: list[Message]) -> str:
    short = f"param{variable[1]}" if variable[0] in ("unknown", "~") else variable[0]
    level = f"{messages[0].level:g}"
    usual = {"2t": "t2m", "2d": "d2m", "2r": "r2", "2sh": "sh2"}.get(short) or (f"{short[2:]}10" if short[:2] == "10" else short)
    for name in (usual, f"{usual}_{variable[2]}", f"{usual}_{variable[2]}_{level}", f"{usual}_{variable[2]}_{level}_{variable[3]}"):
        if name not in taken:
            return name
    return f"{usual}_{variable[2]}_{variable[1]}_{len(taken)}"


class Layout:
    """Dimensions and coordinates that the variables of a file share."""

    def __init__(self, path: Path, messages: list[Message]) -> None:
        self.path = path
        self.times = sorted({message.time for message in messages})
        self.numbers = sorted({message.number for message in messages})
        self.levels: dict[str, list[float]] = {}
        for found in _named(messages).values():
            if _several(found):
                self.levels[found[0].variable[2]] = sorted({*self.levels.get(found[0].variable[2], []), *(message.level for message in found)})
        self.start = messages[0].start
        self.grid = Grid(path, messages[0])

    def coordinates(self) -> dict:
        found = {"time": (("time",) if len(self.times) > 1 else (), np.array(self.times) if len(self.times) > 1 else self.times[0], {"standard_name": "time"})}
        if len(self.numbers) > 1:
            found["number"] = (("number",), np.array(self.numbers), {"standard_name": "realization"})
        for kind, values in self.levels.items():
            units, positive = LEVEL_UNITS.get(kind, ("1", ""))
            found[kind] = ((kind,), np.array(values), {"units": units, **({"positive": positive} if positive else {})})
        return {**found, **self.grid.coordinates()}

    def variable(self, xarray, messages: list[Message]):
        axes = [("time", self.times, lambda m: m.time)] if len(self.times) > 1 else []
        axes += [("number", self.numbers, lambda m: m.number)] if len(self.numbers) > 1 else []
        kind = messages[0].variable[2]
        axes += [(kind, self.levels[kind], lambda m: m.level)] if _several(messages) else []
        table = np.full([len(values) for _, values, _ in axes], -1)
        twice = 0
        for i, message in enumerate(messages):
            place = tuple(values.index(of(message)) for _, values, of in axes)
            twice += table[place] >= 0
            table[place] = i if table[place] < 0 else table[place]
        if twice:
            warnings.warn(f"{self.path}: {twice} fields of {messages[0].variable[0]!r} ({kind}) have the same time and level, for example because they come from forecasts with "
                          "different start times; the first of each was taken.", UserWarning, stacklevel=level_of_caller())
        array = _lazy(self.path, messages, table, self.grid)
        attributes = attributes_of(self.path, messages[0])
        if not _several(messages):
            attributes["GRIB_level"] = messages[0].level
        return xarray.Variable([name for name, _, _ in axes] + list(self.grid.dims), array, attributes)


class Grid:
    """Coordinates of the fields on one grid, and the layout of their values in a message."""

    def __init__(self, path: Path, message: Message) -> None:
        if message.grid_type in ("sh", "lambert_bf", "bifourier"):
            raise GribError(f"{path}: the fields are spectral coefficients (gridType {message.grid_type}). Transform them to a grid first: cdo sp2gpl IN OUT.")
        ec = need("eccodes", "reading GRIB")
        with _handle(path, message) as handle:
            self.kind = message.grid_type
            size = int(_get(ec, handle, "numberOfPoints", 0) or _get(ec, handle, "numberOfDataPoints", 0))
            rows, columns = int(_get(ec, handle, "Nj", 0) or 0), int(_get(ec, handle, "Ni", 0) or 0)
            self.is_list = rows * columns != size or rows * columns == 0
            self.by_columns = bool(_get(ec, handle, "jPointsAreConsecutive", 0))
            self.alternates = bool(_get(ec, handle, "alternativeRowScanning", 0))
            self.shape = (size,) if self.is_list else (rows, columns)
        self.latitude, self.longitude = (None if values is None else self._rows(np.asarray(values)) for values in _places(path, message))
        if self.latitude is None and self.kind not in ELSEWHERE:
            raise GribError(f"{path}: eccodes finds no longitudes and latitudes of this grid (gridType {self.kind}): it does not know the type, or the header contradicts itself. "
                            f"Interpolate the fields to another grid, for example wgrib2 {path.name} -new_grid_winds earth -new_grid latlon 0:360:1 -90:181:1 OUT.")
        self.is_regular = self.kind in ("regular_ll", "regular_gg", "mercator") and not self.is_list
        self.dims = ("values",) if self.is_list else ("latitude", "longitude") if self.is_regular else ("y", "x")

    def arranged(self, values: np.ndarray) -> np.ndarray:
        """Values in rows and columns. Where the rows of a message alternate in direction, eccodes turns neither values nor positions, which have one direction."""
        if self.alternates and not self.is_list:
            values = values.reshape(self.shape[::-1] if self.by_columns else self.shape).copy()
            values[1::2] = values[1::2, ::-1]
        return self._rows(values)

    def _rows(self, values: np.ndarray) -> np.ndarray:
        if self.is_list:
            return values
        return values.reshape(self.shape[::-1]).T if self.by_columns else values.reshape(self.shape)

    def coordinates(self) -> dict:
        if self.latitude is None:
            return {}
        degrees = {"latitude": {"units": "degrees_north", "standard_name": "latitude"}, "longitude": {"units": "degrees_east", "standard_name": "longitude"}}
        if self.is_regular:
            return {"latitude": (("latitude",), self._even(self.latitude[:, 0]), degrees["latitude"]), "longitude": (("longitude",), self.longitude[0], degrees["longitude"])}
        return {name: (self.dims, getattr(self, name), degrees[name]) for name in degrees}

    def _even(self, latitudes: np.ndarray) -> np.ndarray:
        """Evenly spaced from the first to the last, if the increment in the header contradicts these."""
        even = np.linspace(latitudes[0], latitudes[-1], len(latitudes))
        if self.kind != "regular_ll" or len(even) < 3 or np.abs(latitudes - even).max() < 0.5 * abs(even[1] - even[0]):
            return latitudes
        warnings.warn(f"The increment of latitudes in the header is not that of {len(even)} rows from {even[0]:g} to {even[-1]:g}: they are taken as evenly spaced.", UserWarning, stacklevel=level_of_caller())
        return even


# Fields

@contextmanager
def _handle(path: Path, message: Message) -> Iterator[Any]:
    """The handle of one field, released at the end."""
    ec = need("eccodes", "reading GRIB")
    with ExitStack() as ends:
        file = ends.enter_context(_every_field(ec, path))
        file.seek(message.offset)
        for _ in range(message.part + 1):
            handle = ec.codes_grib_new_from_file(file)
            if handle is None or _get(ec, handle, "offset", 0) != message.offset:
                raise GribError(f"{path}: there is no field {message.variable[0]!r} at byte {message.offset}. The file has changed since it was opened: open it again.")
            ends.callback(ec.codes_release, handle)
        yield handle


def attributes_of(path: Path, message: Message) -> dict:
    ec = need("eccodes", "reading GRIB")
    with _handle(path, message) as handle:
        keys = {key: _get(ec, handle, key) for key in (*_ABOUT, *_GRID)}
        for key in ("pl", "pv"):
            if _get(ec, handle, {"pl": "PLPresent", "pv": "NV"}[key], 0) and ec.codes_is_defined(handle, key):  # ICON's levels have NV and no pv
                keys[key] = np.asarray(ec.codes_get_array(handle, key))
    if keys["uvRelativeToGrid"] is None and keys["resolutionAndComponentFlags"] is not None:  # polar stereographic grids of edition 2 have no key of this name
        keys["uvRelativeToGrid"] = int(keys["resolutionAndComponentFlags"] & 8 > 0)
    attributes = {f"GRIB_{key}": value for key, value in keys.items() if value is not None}
    attributes |= {"long_name": keys["name"], "units": keys["units"]}
    if keys["cfName"] not in (None, "unknown"):
        attributes["standard_name"] = keys["cfName"]
    return {key: value for key, value in attributes.items() if value is not None}


def decode(path: Path, message: Message) -> np.ndarray:
    ec = need("eccodes", "reading GRIB")
    with _handle(path, message) as handle:
        ec.codes_set(handle, "missingValue", MISSING)
        try:
            values = np.asarray(ec.codes_get_array(handle, "values"), dtype=np.float32)
        except ec.CodesInternalError as problem:
            raise GribError(f"{path}: the field {message.variable[0]!r} ({message.variable[2]} {message.level:g}) at byte {message.offset} cannot be decoded: {problem}") from problem
    return np.where(values == np.float32(MISSING), np.float32(np.nan), values)


def _lazy(path: Path, messages: list[Message], table: np.ndarray, grid: Grid):
    """An array for xarray that decodes only the indexed fields."""
    from xarray.backends import BackendArray
    from xarray.core import indexing

    class Fields(BackendArray):
        shape = (*table.shape, *grid.shape)
        dtype = np.dtype(np.float32)

        def __getitem__(self, key):
            return indexing.explicit_indexing_adapter(key, self.shape, indexing.IndexingSupport.BASIC, self._read)

        def _read(self, key):
            wanted = table[key[:table.ndim]]
            inside = key[table.ndim:]
            fields = [self._field(i)[inside] for i in np.ravel(wanted)]
            return np.stack(fields).reshape((*np.shape(wanted), *fields[0].shape)) if fields else np.empty((*np.shape(wanted), *np.empty(grid.shape)[inside].shape), np.float32)

        def _field(self, i: int) -> np.ndarray:
            return grid.arranged(decode(path, messages[i])) if i >= 0 else np.full(grid.shape, np.nan, np.float32)

    return indexing.LazilyIndexedArray(Fields())
