# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of xarray wherever a mesh is expected, and what a picture of them has besides: units, and the Earth below. This package does not import xarray."""
from __future__ import annotations

import sys
from typing import Any

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
    return accessor.mesh() if accessor._is_flat({}) else accessor.globe(derive=accessor._air_of_light())


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


def add_earth_for(plotter: pyvista.BasePlotter, data: Any, mesh: pyvista.DataSet, name: str) -> None:
    """Adds the Earth below data of xarray on a globe, if the active sub-plot is empty. A camera that is not set looks at the side on which the field `name` has most."""
    if _has_earth(plotter, data, mesh):
        from .weather.picture import add_earth, turn_to_field
        add_earth(plotter, mesh)
        if not plotter.renderer.camera.is_set:
            turn_to_field(plotter, mesh, name)
