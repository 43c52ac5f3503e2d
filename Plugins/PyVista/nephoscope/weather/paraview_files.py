# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's reader of weather data looks at before it starts Python: whether a file can be read, its format, and the packages that this format needs.

Uses the standard library alone, and VTK's NetCDF for `own_reader`.
"""
from __future__ import annotations

import glob
import os
from pathlib import Path

from .foreign import MESH, TABLE_FILE, first_bytes, format_of, identified, inside

EVERY = ("nephoscope", "pyvista", "xarray")
PACKAGES = {"NetCDF": "netCDF4|h5netcdf", "classic NetCDF": "netCDF4|scipy", "GRIB": "eccodes", "Zarr": "zarr"}  # format: the packages of which it needs one
ZARR = (".zgroup", ".zmetadata", ".zarray", "zarr.json")
HERE = ("Unpack", "Make the file", "The download")  # remedies that hold in ParaView as well
REMEDIES = {MESH: "Open it with one of ParaView's own readers.", TABLE_FILE: "Open it with ParaView's reader of delimited text."}


def packages(path: str) -> tuple[str, ...]:
    """The Python packages that a file needs; ``a|b`` is one of two. Raises a RuntimeError for what is no weather data."""
    return *EVERY, PACKAGES[file_format(path)]


def file_format(path: str) -> str:
    """A key of `PACKAGES`; a RuntimeError, in one or two sentences, if the file is missing, cannot be read, or is no weather data. A pattern stands for its first file."""
    found = Path(next(iter(sorted(glob.glob(path))), path))
    try:
        return _format(found)
    except FileNotFoundError:
        raise RuntimeError(f"There is no file {path}.") from None
    except PermissionError:
        raise RuntimeError(f"{found} may not be read by the user that runs ParaView: change its permissions, chmod u+r {found.name}.") from None
    except OSError as problem:
        raise RuntimeError(f"{found} cannot be read: {problem.strerror}.") from None


def _format(path: Path) -> str:
    if path.is_dir():
        if any(name in ZARR for name in os.listdir(path)):
            return "Zarr"
        raise RuntimeError(f"{path} is a folder, and no Zarr store: choose a file in it.")
    start = first_bytes(path)
    if not start and path.suffix.lower() != ".foam":
        raise RuntimeError(f"{path} is empty: copy or download it again.")
    if path.suffix.lower() == ".zip":
        if told := inside(path):
            raise RuntimeError(told)
        return "Zarr"
    found = format_of(start)
    if found:
        return "classic NetCDF" if start.startswith((b"CDF\1", b"CDF\2")) else found
    raise RuntimeError(_refusal(path, start))


def _refusal(path: Path, start: bytes) -> str:
    what, remedy = identified(path, start)
    if not what:
        return f"{path} is neither GRIB nor NetCDF nor Zarr: it begins with {start[:8]!r}. If it should be, it is damaged: copy or download it again."
    remedy = remedy if remedy.startswith(HERE) else REMEDIES.get(what, "Convert it to NetCDF, and open that file.")
    return f"{path} {what}. {remedy}"


def own_reader(path: str) -> str:
    """How ParaView draws a NetCDF file of longitudes and latitudes without any package; empty if it cannot."""
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
    warned = vtkObject.GetGlobalWarningDisplay()
    vtkObject.GlobalWarningDisplayOff()
    try:
        reader = vtkNetCDFCFReader()
        if not reader.CanReadFile(path):
            return ""
        reader.SetFileName(path)
        reader.UpdateInformation()
        sizes = reader.GetAllDimensions()
        spans = [sizes.GetValue(i).lower() for i in range(sizes.GetNumberOfValues())]
    finally:
        vtkObject.SetGlobalWarningDisplay(warned)
    if not any("lat" in span and "lon" in span for span in spans):
        return ""
    return ("ParaView can draw this file without them: open it with the reader 'netCDF files generic and CF conventions', turn Spherical Coordinates off, "
            "and choose Filters > Nephoscope > Globe Grid.")
