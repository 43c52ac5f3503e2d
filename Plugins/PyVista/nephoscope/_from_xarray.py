# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of xarray wherever a mesh is expected, and what a picture of them has besides: units, and the Earth below. This package does not import xarray."""
from __future__ import annotations

import sys
import warnings
from typing import Any

import numpy as np
import pyvista
from vtkmodules.vtkRenderingCore import vtkProp3D


def is_weather(data: Any) -> bool:
    """Whether the data are an xarray.Dataset or an xarray.DataArray."""
    xarray = sys.modules.get("xarray")
    return isinstance(data, (getattr(xarray, "Dataset", ()), getattr(xarray, "DataArray", ())))


def meshed(data: Any) -> Any:
    """The mesh of an xarray.Dataset or xarray.DataArray, flat or on a globe, with the temperature that light in clouds needs; all other data unchanged."""
    if not is_weather(data):
        return data
    accessor = _accessor(data)
    return accessor.mesh() if accessor._is_flat({}) else accessor.globe(derive=accessor._air_for_light())


def _accessor(data: Any) -> Any:
    from .weather.accessor import ArrayAccessor, WeatherAccessor
    return (WeatherAccessor if hasattr(data, "data_vars") else ArrayAccessor)(data)


def title_with_units(data: Any, mesh: pyvista.DataSet, name: str, title: str) -> str:
    """The title of the scalar bar of the array `name`, as ``dataset.nephoscope.plot`` writes it, for data of xarray; `title` for others. A title that tells a component stays, with units."""
    if not is_weather(data):
        return title
    from .weather.naming import title as of_field
    words, bracket, units = of_field(_accessor(data)._dataset, mesh, name).partition(" [")
    return (words if title == name else title) + bracket + units


def _has_earth(plotter: pyvista.BasePlotter, data: Any, mesh: pyvista.DataSet) -> bool:
    return is_weather(data) and "GlobeGridProjection" in mesh.field_data and not any(isinstance(actor, vtkProp3D) for actor in plotter.renderer.actors.values())


def darken_for(plotter: pyvista.BasePlotter, data: Any, mesh: pyvista.DataSet) -> None:
    """Gives a plotter that is empty and has PyVista's defaults a dark background, for data of xarray on a globe. One with contents in other sub-plots gets it behind the active one."""
    if _has_earth(plotter, data, mesh):
        from .weather.picture import darken, has_defaults
        if all(has_defaults(plotter, renderer) for renderer in plotter.renderers):
            darken(plotter)
        elif has_defaults(plotter, plotter.renderer):
            darken(plotter, alone=True)


def sun_for(data: Any, mesh: pyvista.DataSet, sun: Any) -> Any:
    """The argument `sun` of `add_cells`. For data of xarray on a globe, it includes what ``dataset.nephoscope.plot`` adds: the date and the names of the water arrays."""
    if not is_weather(data) or "GlobeGridProjection" not in mesh.field_data:
        return sun
    from .weather.in_the_sun import sun_of
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the mesh has given these warnings
        reading = _accessor(data)._reading(None, {})
    return sun_of(sun, reading, mesh)


def add_earth_for(plotter: pyvista.BasePlotter, data: Any, mesh: pyvista.DataSet, name: Any, is_lit: bool = False) -> None:
    """Adds the Earth below data of xarray on a globe, if the active sub-plot is empty, with the shadows of lit clouds. A camera that is not set looks at the side that has most of the field.
    `name`: the name of the field or, in the sun, the argument `scalars`."""
    if not _has_earth(plotter, data, mesh):
        return
    from .weather.picture import add_earth, turn_to_field
    earth, sun = add_earth(plotter, mesh), None
    if is_lit:
        from ._medium import default_scalars
        from .weather.shadows import shade
        name = name if isinstance(name, str) and name in mesh.array_names else default_scalars(mesh)[1]
        sun = np.ravel(mesh.field_data["SunDirection"])[:3]
        if earth is not None:
            shade(earth, mesh)
    if not plotter.renderer.camera.is_set:
        turn_to_field(plotter, mesh, name, sun)
