# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Warns about objects missing in files that a plotter exports, and in notebooks that draw in the browser: volumes, cloud textures and haze have no geometry."""
from __future__ import annotations

import functools
import os
import warnings
import weakref
from contextlib import contextmanager
from typing import Any, Callable, Iterator

import pyvista
from vtkmodules.vtkCommonCore import vtkObject

from . import vtkCellCompositingMapper, vtkCloudTextureMapper, vtkHaze, vtkTexturedSplatMapper
from ._methods import wrap_method
from ._pipeline import level_of_caller

EXPORTS = ("export_gltf", "export_html", "export_obj", "export_vrml", "export_vtksz")
EXPORTS_OF_TRAME = ("export_html", "export_vtksz", "export_wasm_html", "export_wazex")  # methods of plotter.trame, which PyVista 0.49 has
PAGES = EXPORTS_OF_TRAME
NEED_ACTORS = ("export_obj", "export_vrml")  # which write no file without them
IN_THE_BROWSER = ("client", "html")  # notebook backends that draw there


def warn_when_exported(plotter: pyvista.BasePlotter) -> None:
    """Makes `plotter.export_gltf(...)` and similar methods, and `plotter.show()` in a notebook, warn at every call about objects that they leave out.

    So do those of `plotter.trame`, where there is one.
    """
    for name in EXPORTS:
        wrap_method(plotter, name, functools.partial(_export, name))
    wrap_method(plotter, "show", _show)
    trame = getattr(plotter, "trame", None)
    if trame is not None:
        for name in EXPORTS_OF_TRAME:
            wrap_method(trame, name, _of_part(plotter, functools.partial(_export, name)))
        wrap_method(trame, "show", _of_part(plotter, _show_by_trame))


def _of_part(plotter: pyvista.BasePlotter, around: Callable) -> Callable:
    """`around` for a method of a part of the plotter, which is not kept alive."""
    whole = weakref.ref(plotter)
    return lambda _part, method, *arguments, **options: around(whole(), method, *arguments, **options)


def _export(name: str, plotter: pyvista.BasePlotter, method: Callable, *arguments: Any, **options: Any) -> Any:
    missing = _missing(plotter)
    is_empty = bool(missing) and name in NEED_ACTORS and not any(renderer.GetActors().GetNumberOfItems() for renderer in plotter.renderers)
    if missing:
        page = ", or nephoscope.serve(plotter) for a page in the browser" * (name in PAGES)
        warnings.warn(f"{name} leaves out {' and '.join(missing)}, which have no geometry. Use screenshot for a picture of them{page}."
                      + " There is nothing else, so no file is written." * is_empty,
                      UserWarning, stacklevel=level_of_caller())
    outputs = [(mapper, mapper.GetInputConnection(0, 0)) for mapper in _mappers(plotter)]
    inputs = [(mapper, output, output.GetProducer()) for mapper, output in outputs]  # an output does not keep its producer
    try:
        with _quiet_vtk(is_empty):
            return _told(method, *arguments, **options)
    finally:
        for mapper, output, _ in inputs:  # export_gltf puts the surface of the data there
            mapper.SetInputConnection(0, output)


def _told(method: Callable, *arguments: Any, **options: Any) -> Any:
    """Calls a method that may call another export, whose warning would say the same again. PyVista's own warnings, which would name a line of this file, name the user's."""
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.filterwarnings("ignore", "export_[a-z_]* leaves out")
            return method(*arguments, **options)
    finally:
        for told in caught:
            if told.filename == __file__:
                warnings.warn(told.message, stacklevel=level_of_caller(os.path.dirname(pyvista.__file__)))
            else:
                warnings.warn_explicit(told.message, told.category, told.filename, told.lineno, source=told.source)


@contextmanager
def _quiet_vtk(quiet: bool) -> Iterator[None]:
    """Without VTK's error that there are no actors, which has just been said in other words."""
    before = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(0 if quiet else before)
    try:
        yield
    finally:
        vtkObject.SetGlobalWarningDisplay(before)


def _show(plotter: pyvista.BasePlotter, method: Callable, *arguments: Any, **options: Any) -> Any:
    backend = options.get("jupyter_backend") or plotter.theme.jupyter_backend if getattr(plotter, "notebook", False) else None
    return _show_by(backend, plotter, method, *arguments, **options)


def _show_by_trame(plotter: pyvista.BasePlotter, method: Callable, *arguments: Any, **options: Any) -> Any:
    return _show_by(options.get("mode") or plotter.theme.jupyter_backend, plotter, method, *arguments, **options)


def _show_by(backend: str | None, plotter: pyvista.BasePlotter, method: Callable, *arguments: Any, **options: Any) -> Any:
    missing = _missing(plotter) if backend in IN_THE_BROWSER else []
    if not missing:
        return method(*arguments, **options)
    warnings.warn(f"The notebook backend {backend!r} draws in the browser and leaves out {' and '.join(missing)}. Draw them on the server: "
                  "plotter.show(jupyter_backend='server'), pyvista.set_jupyter_backend('server'), or nephoscope.serve(plotter) outside a notebook.",
                  UserWarning, stacklevel=level_of_caller())
    return _told(method, *arguments, **options)


def _mappers(plotter: pyvista.BasePlotter) -> Iterator[Any]:
    for renderer in plotter.renderers:
        for actor in renderer.actors.values():
            mapper = actor.GetMapper() if hasattr(actor, "GetMapper") else None
            if isinstance(mapper, (vtkCellCompositingMapper, vtkTexturedSplatMapper, vtkCloudTextureMapper)):
                yield mapper


def _missing(plotter: pyvista.BasePlotter) -> list[str]:
    mappers = list(_mappers(plotter))
    surfaces = sum(isinstance(mapper, vtkCloudTextureMapper) for mapper in mappers)
    volumes = len(mappers) - surfaces
    missing = [f"{volumes} volume{'s' * (volumes > 1)} of cells or splats"] * (volumes > 0)
    missing += ["the textures of clouds"] * (surfaces > 0)
    return missing + ["the haze"] * any(vtkHaze.GetHaze(renderer) is not None for renderer in plotter.renderers)
