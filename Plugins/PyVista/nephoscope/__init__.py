# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds, smoke and wind for VTK, PyVista and ParaView.

``import nephoscope`` provides every wrapped class (``nephoscope.vtkGlobeGrid()``) and needs only the ``vtkmodules`` for which the project was
built. The functions listed in `VTK_FUNCTIONS` need nothing else. The functions in `PYVISTA_FUNCTIONS` and the dataset accessor ``mesh.nephoscope`` need PyVista, and
import it on first use.
"""
import functools as _functools
import importlib as _importlib
import sys as _sys
import warnings as _warnings
from importlib.util import find_spec as _find_spec
from typing import TYPE_CHECKING as _TYPE_CHECKING

from . import _modules
from ._libraries import own_symbols as _own_symbols
from ._libraries import warn_of_order as _warn_of_order
from ._modules import MODULES as _MODULES
from ._modules import VERSION as __version__
from ._vtk import pyvista_version as _pyvista_version
from ._vtk import require_backend as _require_backend
from ._vtk import require_pyvista as _require_pyvista
from ._vtk import require_wheel as _require_wheel

if _TYPE_CHECKING:
    from .advection import advect_texture
    from .cells import add_cells
    from .cloud_texture import add_cloud_texture
    from .clouds import cloud_surface, smooth
    from .globe import globe_surface, to_globe
    from .haze import add_haze
    from .light import sunlight
    from .optics import cloud_optics
    from .override import override_vtk
    from .picking import disable_picking, enable_picking
    from .polyhedra import divide_polyhedra
    from .reader import cf_times, read_cf
    from .samples import sample_data
    from .satellite import satellite_image
    from .serving import serve
    from .smoke import flow_volume, smoke_puffs
    from .smoke_drawing import add_smoke
    from .smoke_widget import add_smoke_widget
    from .sparse import read_vdb, write_vdb
    from .splats import add_splats
    from .splitting import split_cells
    from .terrain import add_terrain, terrain_surface
    from .viewing import viewer
    from .weather.opening import open  # noqa: A004
    from .weather.animating import animate

VTK_FUNCTIONS = {"override_vtk": "override", "sample_data": "samples"}  # functions that need only VTK

# Function -> the file of its technique. A new technique adds its line here and its method in accessor.py.
PYVISTA_FUNCTIONS = {
    "read_cf": "reader",
    "cf_times": "reader",
    "to_globe": "globe",
    "globe_surface": "globe",
    "terrain_surface": "terrain",
    "add_terrain": "terrain",
    "add_cells": "cells",
    "add_haze": "haze",
    "disable_picking": "picking",
    "enable_picking": "picking",
    "add_splats": "splats",
    "split_cells": "splitting",
    "divide_polyhedra": "polyhedra",
    "cloud_optics": "optics",
    "sunlight": "light",
    "satellite_image": "satellite",
    "smooth": "clouds",
    "cloud_surface": "clouds",
    "advect_texture": "advection",
    "add_cloud_texture": "cloud_texture",
    "flow_volume": "smoke",
    "smoke_puffs": "smoke",
    "add_smoke": "smoke_drawing",
    "add_smoke_widget": "smoke_widget",
    "read_vdb": "sparse",
    "write_vdb": "sparse",
    "serve": "serving",
    "viewer": "viewing",
    "open": "weather.opening",
    "animate": "weather.animating",
}


def _wrapped_classes():
    if _modules.FROM_PYPI:
        _warn_of_order()
        _require_wheel(_modules.VTK_VERSION, _modules.VTK_MODULES)
    classes = {}
    for name in _MODULES:
        module = _importlib.import_module("." + name, __name__)
        classes.update({k: v for k, v in vars(module).items() if k.startswith("vtk")})
    return classes


with _own_symbols():
    _CLASSES = _wrapped_classes()
globals().update(_CLASSES)


def _has_pyvista():
    try:
        return _find_spec("pyvista") is not None
    except (ImportError, ValueError):
        return False


# `import *` must not need PyVista, and must leave Python's own `open` alone.
__all__ = sorted([*_CLASSES, *VTK_FUNCTIONS, *(name for name in PYVISTA_FUNCTIONS if _has_pyvista() and name != "open")])


def _pyvista_remedy():
    if _modules.FROM_PYPI:
        return f"Run: {_sys.executable} -m pip install pyvista"
    command = _importlib.import_module(".samples", __name__).requirements("requirements.txt", options="--no-deps ")
    return f"PyVista must use this VTK and not its own. Run: {command}."


@_functools.cache
def _warn_once_about_accessors(version):
    _warnings.warn(f"PyVista {version} has no accessors: mesh.nephoscope does not exist. Install pyvista>=0.48, or call the functions, for example "
                   "nephoscope.to_globe(mesh, ...).", stacklevel=3)


_INSTEAD = {name: f". Data of xarray are drawn by nephoscope.open(path).nephoscope.plot(...){more}, a mesh by nephoscope.add_cells(plotter, mesh, ...)."
            for name, more in (("plot", ""), ("describe", " and described by nephoscope.open(path).nephoscope.describe()"))}


def __getattr__(name):
    if name in VTK_FUNCTIONS:
        return getattr(_importlib.import_module("." + VTK_FUNCTIONS[name], __name__), name)
    if name not in PYVISTA_FUNCTIONS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}" + _INSTEAD.get(name, ""))
    if _modules.FROM_PYPI:
        _require_pyvista(_modules.VTK_VERSION)
    try:
        import pyvista  # noqa: F401
    except ImportError as missing:
        if not isinstance(missing, ModuleNotFoundError) or str(missing.name).startswith("vtkmodules"):
            raise ImportError(f"PyVista {_pyvista_version()} does not work with this VTK: {missing}. {_pyvista_remedy()}", name="pyvista") from None
        raise ModuleNotFoundError(
            f"nephoscope.{name} needs PyVista, and {missing.name!r} is not installed for {_sys.executable}. "
            + _pyvista_remedy(), name=missing.name) from missing
    _require_backend()
    if not hasattr(pyvista, "register_dataset_accessor"):
        _warn_once_about_accessors(pyvista.__version__)
    _importlib.import_module(".accessor", __name__)
    function = getattr(_importlib.import_module("." + PYVISTA_FUNCTIONS[name], __name__), name)
    globals()[name] = function
    return function


def __dir__():
    return sorted({*globals(), *VTK_FUNCTIONS, *PYVISTA_FUNCTIONS})


_importlib.import_module(".override", __name__).read_environment()

# PyVista imported first: attach the accessor now. PyVista imported later: it finds the accessor by the
# entry point `pyvista.accessors` of this package.
if hasattr(_sys.modules.get("pyvista"), "register_dataset_accessor"):
    _require_backend()
    _importlib.import_module(".accessor", __name__)

# The accessor of xarray.Dataset, now or when xarray is imported: this package does not import it.
_importlib.import_module("._later", __name__).when_imported("xarray", ".weather.accessor", "register")
