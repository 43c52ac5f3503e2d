# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The packages that only weather data need, imported when they are needed."""
import contextlib
import importlib
import importlib.util
import sys

from .._libraries import INTRUDER, own_symbols
from .._modules import FROM_PYPI
from ..samples import requirements

REMEDY = {"eccodes": "eccodes eccodeslib"}


def need(module: str, purpose: str):
    """The module, or one error with the command that installs it."""
    try:
        return importlib.import_module(module)
    except ImportError as missing:
        raise _told(module, purpose, missing) from missing


def need_elsewhere(module: str, purpose: str) -> None:
    """The same error for a module that only another process imports."""
    if importlib.util.find_spec(module) is None:
        raise _told(module, purpose, "no such module")


def load_netcdf_of_vtk() -> None:
    """Loads VTK's NetCDF with the libraries of the system before eccodes, which xarray imports when it opens a file, or with its own symbols after eccodes: `_libraries` says why."""
    with contextlib.suppress(ImportError), own_symbols():
        importlib.import_module("vtkmodules.vtkIONetCDF")


def load_proj() -> None:
    """Loads pyproj, if it is installed, before eccodes or with its own symbols: xarray imports eccodes, and then others' readers import pyproj, which would find PROJ's symbols in eckitlib and end the
    process when Python ends. Only beside VTK of the Python package index: Debian's has another PROJ (see `proj.py`)."""
    if FROM_PYPI and importlib.util.find_spec(INTRUDER) is not None:
        with contextlib.suppress(ImportError), own_symbols():
            importlib.import_module("pyproj")


def _told(module: str, purpose: str, missing) -> ModuleNotFoundError:
    """The error with the command that installs the package."""
    packages = REMEDY.get(module, module)
    return ModuleNotFoundError(
        f"{purpose[0].upper()}{purpose[1:]} needs the Python package {module!r}, which {sys.executable} does not have: {missing}. Install it with the other packages for weather "
        f"data: {_command()}. Or alone, beside the numpy that is there: {sys.executable} -m pip install {packages} \"numpy=={_numpy()}\"", name=module)


def _command() -> str:
    if FROM_PYPI:
        return f"{sys.executable} -m pip install 'nephoscope[data]'"
    return requirements("requirements.txt", "requirements-data.txt", options="--no-deps ")


def _numpy() -> str:
    import numpy
    return numpy.__version__
