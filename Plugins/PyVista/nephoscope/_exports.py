# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Warns about objects missing in files that a plotter exports: the files hold geometry, but volumes, cloud textures and haze have none."""
from __future__ import annotations

import functools
import warnings
import weakref
from typing import Any, Iterator

import pyvista

from . import vtkCellCompositingMapper, vtkCloudTextureMapper, vtkHaze, vtkTexturedSplatMapper
from ._pipeline import level_of_caller

EXPORTS = ("export_gltf", "export_html", "export_obj", "export_vrml", "export_vtksz")


def warn_when_exported(plotter: pyvista.BasePlotter) -> None:
    """Makes `plotter.export_gltf(...)` and similar methods warn at every call about objects that they leave out."""
    for name in EXPORTS:
        if callable(getattr(plotter, name, None)) and name not in vars(plotter):
            setattr(plotter, name, _warning(weakref.ref(plotter), name))


def _warning(reference: weakref.ref, name: str) -> Any:
    @functools.wraps(getattr(type(reference()), name))
    def export(*arguments: Any, **options: Any) -> Any:
        plotter = reference()
        missing = _missing(plotter)
        if missing:
            warnings.warn(f"{name} leaves out {' and '.join(missing)}, which have no geometry. Use screenshot for a picture of them.",
                          UserWarning, stacklevel=level_of_caller())
        outputs = [(mapper, mapper.GetInputConnection(0, 0)) for mapper in _mappers(plotter)]
        inputs = [(mapper, output, output.GetProducer()) for mapper, output in outputs]  # an output does not keep its producer
        try:
            return getattr(type(plotter), name)(plotter, *arguments, **options)
        finally:
            for mapper, output, _ in inputs:  # export_gltf puts the surface of the data there
                mapper.SetInputConnection(0, output)
    return export


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
