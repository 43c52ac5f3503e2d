# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The dataset accessor ``mesh.nephoscope``: one method per technique that takes a mesh and returns one."""
from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Callable

import pyvista

from .advection import advect_texture
from .clouds import cloud_surface, smooth
from .globe import to_globe
from .light import sunlight
from .optics import cloud_optics
from .polyhedra import divide_polyhedra
from .smoke import flow_volume, smoke_puffs
from .sparse import write_vdb
from .splitting import split_cells
from .terrain import terrain_surface

if TYPE_CHECKING:
    from typing import Concatenate, ParamSpec, TypeVar  # since Python 3.10
    Arguments = ParamSpec("Arguments")
    Result = TypeVar("Result")


def _method(function: Callable[Concatenate[Any, Arguments], Result]) -> Callable[Concatenate[NephoscopeAccessor, Arguments], Result]:
    """`function(mesh, ...)` as a method of the accessor, with its signature and documentation."""

    @functools.wraps(function)
    def method(self: NephoscopeAccessor, *args: Arguments.args, **options: Arguments.kwargs) -> Result:
        return function(self._mesh, *args, **options)

    return method


def _instead(name: str) -> str:
    """What draws a mesh, for the error about a method that only data of xarray have, or about a function of the package."""
    from . import PYVISTA_FUNCTIONS
    if name == "plot":
        return ". It is a method of data of xarray. A mesh is drawn by nephoscope.add_cells(plotter, mesh, ...), one of surfaces by mesh.plot()."
    if name.startswith("add_") and name in PYVISTA_FUNCTIONS:
        return f". It is a function of the package: nephoscope.{name}(plotter, mesh, ...)."
    return ""


class NephoscopeAccessor:
    """Nephoscope's filters as methods of a PyVista dataset or MultiBlock.

    Parameters
    ----------
    mesh : pyvista.DataSet or pyvista.MultiBlock
        The dataset that the methods process; it is not changed.
    """

    def __init__(self, mesh: pyvista.DataSet) -> None:
        self._mesh = mesh

    if not TYPE_CHECKING:  # for which there is nothing but the methods
        def __getattr__(self, name):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}" + _instead(name))

    globe = _method(to_globe)
    terrain = _method(terrain_surface)
    split_cells = _method(split_cells)
    divide_polyhedra = _method(divide_polyhedra)
    smooth = _method(smooth)
    cloud_surface = _method(cloud_surface)
    advect_texture = _method(advect_texture)
    flow_volume = _method(flow_volume)
    smoke_puffs = _method(smoke_puffs)
    cloud_optics = _method(cloud_optics)
    sunlight = _method(sunlight)
    write_vdb = _method(write_vdb)


# Before 0.48 PyVista has no accessors; the functions of the package work without them.
if hasattr(pyvista, "register_dataset_accessor"):
    pyvista.register_dataset_accessor("nephoscope", pyvista.DataSet)(NephoscopeAccessor)
    pyvista.register_dataset_accessor("nephoscope", pyvista.MultiBlock)(NephoscopeAccessor)
