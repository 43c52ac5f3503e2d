# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Haze in front of everything that a plotter draws (`vtkHaze`)."""
from __future__ import annotations

from typing import Any, Callable, Literal

import pyvista

from . import vtkHaze
from ._checks import choose, require_number
from ._exports import warn_when_exported
from ._fields import FLAT_GRID
from ._methods import wrap_method
from ._pipeline import warn_when_drawing
from ._typing import Numbers
from .light import PROJECTIONS, direction_of


def add_haze(plotter: pyvista.Plotter, mesh: pyvista.DataSet | None = None, *, visibility: float | None = None, scale_height: float | None = None,
             color: str | Numbers | None = None, background: bool = True,
             vertical_exaggeration: float | None = None, projection: Literal["globe", "map"] | None = None,
             radius: float | None = None, center: Numbers = (0, 0, 0), up: Numbers = (0, 0, 1),
             base_level: float = 0.0, sun: Any = None, asymmetry: float = 0.5, cloud_shadows: bool = True,
             render: bool = True) -> vtkHaze:
    """Add haze, less dense with altitude, in front of everything in the active renderer of a plotter. It replaces earlier haze.

    Defaults come from the scene: the ground and exaggeration of `mesh.nephoscope.globe(...)`; without it a globe if the scene lies around the
    origin and is as large as the Earth, otherwise flat ground under the scene.

    ``plotter.clear()`` removes the haze with everything else, and ``nephoscope.vtkHaze.SetHaze(plotter.renderer, None)`` the haze alone.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets the haze.
    mesh : pyvista.DataSet, optional
        A result of ``mesh.nephoscope.globe(...)``, or of filters that keep its field data. It provides the position of the ground and the
        vertical exaggeration.
    visibility : float, optional
        Meteorological visibility: the distance, along the ground at altitude 0, at which 2 % of the contrast is left, in units of the scene, >
        0. Real air has 1e4 to 3e5 m. Default: 24.5 displayed scale heights; without a globe
        or map, at least 5.7 widths of the scene.
    scale_height : float, optional
        Height, before exaggeration, over which the haze density falls to 1/e, > 0. Default: 8000 m with a result of
        ``mesh.nephoscope.globe(...)``, 0.5 % of the radius on any other globe, otherwise a third of the height of the scene, at
        least a tenth of its width.
    color : color_like, optional
        Colour of opaque haze. Default: a pale blue, (0.72, 0.8, 0.9).
    background : bool, default: True
        Draws haze over the background too.
    vertical_exaggeration : float, optional
        Vertical exaggeration of the scene, > 0. Default: that of `mesh` or of the scene, otherwise 1.
    projection : {"globe", "map"}, optional
        Altitude is the height above a sphere, or above flat ground. Default: the projection of `mesh` or of the scene.
    radius : float, optional
        Globe: radius at altitude 0, > 0. Default: that of `mesh` or of the scene, otherwise 6371000.
    center : sequence of 3 float, default: (0, 0, 0)
        Globe: centre of the globe.
    up : sequence of 3 float, default: (0, 0, 1)
        Map: the upward direction.
    base_level : float, default: 0.0
        Map: coordinate along `up` at altitude 0. If the ground is found from the scene, it is measured from the lowest point of the scene.
    sun : sequence of 3 float, str, dict or True, optional
        Lights the haze by the sun, given as in `add_cells`: haze is brightest around the sun and dark at night, and has `color` where the phase function is
        1. True: the sun of `mesh`, or of a lit mesh in the scene. A date and time needs `mesh` or ``{'place':
        (longitude, latitude)}``. Default: none; haze has the same colour everywhere.
    asymmetry : float, default: 0.5
        With `sun`: asymmetry parameter of the haze, -0.95 to 0.95; 0 for air, 0.7 for particles.
    cloud_shadows : bool, default: True
        With `sun`: clouds lit by the same sun, as by ``add_cells(..., sun=...)``, cast shadows in the haze, with shafts of light between them.
    render : bool, default: True
        Renders again if the plotter has rendered before.

    Returns
    -------
    vtkHaze
        The haze. You can change its settings at any time.

    Raises
    ------
    ValueError
        If a number or a choice is out of range.
    """
    told = _told_by(mesh)
    if mesh is not None and FLAT_GRID in mesh.field_data and scale_height is None:
        told.pop("exaggeration", None)  # the default is a share of the scene as it is displayed
    haze = vtkHaze()
    projection = told.get("projection") if projection is None else projection
    if projection is not None:
        choose({"globe": haze.SetProjectionToGlobe, "map": haze.SetProjectionToMap}, projection, "projection")
    lengths = {"visibility": (haze.SetVisibility, visibility),
               "scale_height": (haze.SetScaleHeight, scale_height),
               "vertical_exaggeration": (haze.SetVerticalExaggeration,
                                         told.get("exaggeration") if vertical_exaggeration is None else vertical_exaggeration),
               "radius": (haze.SetPlanetRadius, told.get("radius") if radius is None else radius)}
    for name, (set_value, value) in lengths.items():
        if value is not None:
            set_value(require_number(value, name, above=0))
    if color is not None:
        haze.SetColor(*pyvista.Color(color).float_rgb)
    haze.SetBackground(bool(background))
    haze.SetCenter(*_vector(center, "center"))
    up = _vector(up, "up")
    if not any(up):
        raise ValueError("up is (0, 0, 0); it must have a length.")
    haze.SetUpDirection(*up)
    haze.SetBaseLevel(require_number(base_level, "base_level"))
    haze.SetAsymmetry(require_number(asymmetry, "asymmetry", least=-0.95, most=0.95))
    haze.SetCloudShadows(bool(cloud_shadows))
    if sun is not None:
        told_by = _mesh_of_scene(plotter) if mesh is None else mesh
        haze.SetSunDirection(*direction_of(sun, told_by.field_data, told_by.center))
    warn_when_drawing(haze)
    vtkHaze.SetHaze(plotter.renderer, haze)
    wrap_method(plotter, "clear", _clear)  # removes the haze as well as the actors
    warn_when_exported(plotter)
    if render:
        plotter.render()
    return haze


def _clear(plotter: pyvista.Plotter, method: Callable, *arguments: Any, **options: Any) -> None:
    for renderer in plotter.renderers:
        vtkHaze.SetHaze(renderer, None)
    method(*arguments, **options)


def _vector(values: Numbers, argument: str) -> list[float]:
    if len(values) != 3:
        raise ValueError(f"{argument} is {values!r}; it must have 3 numbers.")
    return [require_number(value, argument) for value in values]


def _mesh_of_scene(plotter: pyvista.Plotter) -> Any:
    """A mesh in the active renderer with the field data of a sun, otherwise of a globe; an empty one if there is none."""
    found: Any = pyvista.PolyData()
    for actor in plotter.renderer.actors.values():
        mapper = actor.GetMapper() if hasattr(actor, "GetMapper") else None
        mesh = mapper.GetInputDataObject(0, 0) if mapper and mapper.GetNumberOfInputConnections(0) else None
        mesh = pyvista.wrap(mesh) if mesh is not None else pyvista.PolyData()
        if "SunDirection" in mesh.field_data:
            return mesh
        found = mesh if "GlobeGridProjection" in mesh.field_data and "GlobeGridProjection" not in found.field_data else found
    return found


def _told_by(mesh: pyvista.DataSet | None) -> dict:
    """The values that `vtkGlobeGrid` wrote into the field data."""
    if mesh is None:
        return {}
    names = {"GlobeGridProjection": "projection", "PlanetRadius": "radius", "VerticalExaggeration": "exaggeration"}
    told = {ours: float(mesh.field_data[theirs][0]) for theirs, ours in names.items() if theirs in mesh.field_data}
    if "projection" in told:
        told["projection"] = PROJECTIONS[int(told["projection"])]
    return told
