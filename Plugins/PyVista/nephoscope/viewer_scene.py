# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a file for the viewer: the choices that its data allow, and each technique with its defaults."""
from __future__ import annotations

import warnings
from functools import lru_cache
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pyvista

from ._blocks import cell_dimension
from ._fields import Preset, is_helper, preset_of_field, presets
from ._globe_camera import look_at_region
from .cells import add_cells
from .cloud_texture import add_cloud_texture
from .clouds import cloud_surface
from .globe import globe_surface
from .smoke import flow_volume
from .smoke_drawing import add_smoke
from .splats import add_splats
from .terrain import add_terrain, terrain_surface
from .viewer_sources import KEPT, one_sentence, source_of
from .viewer_state import Choices, View
from .weather.bars import label_format
from .weather.ground import add_ground
from .weather.naming import UNITLESS
from .weather.units import usual

BAR = {"width": 0.25, "height": 0.08, "position_x": 0.72, "position_y": 0.02, "n_labels": 3, "fmt": "%.4g", "title_font_size": 16, "label_font_size": 14}
BESIDE = 0.05       # left edge of the second bar
STREAKS = "autumn_r"  # colours by speed: they are seen on white clouds, land and water
GLOBE_ZOOM = 1.4    # nearer than PyVista's camera, which leaves room for the corners of a box
OPTICAL_DEPTH = 3   # of a cloud surface, as add_cloud_texture has it


class Scene:
    """The data of a file, and the choices that they allow, `choices`. A file that cannot be drawn raises an error with one sentence."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        if not self.path.is_file():
            raise FileNotFoundError(f"There is no file {self.path}.")
        self._source = source_of(self.path)
        self._grid = lru_cache(KEPT)(self._source.grid)
        mesh = self.grid(View())
        fields = _fields(mesh)
        self.choices = Choices(fields, _techniques(mesh, fields), tuple(presets()), self._source.times, self._source.is_globe,
                               self._source.is_globe and self._terrain(View()) is not None)

    def grid(self, view: View) -> pyvista.DataSet:
        """The data at the time of the view: on a globe with the view's exaggeration, or unchanged from the file."""
        return self._grid(view.time, view.exaggeration)

    def title(self, name: str, view: View) -> str:
        """That of a scalar bar: the name of its array, with the unit if this is known."""
        grid, streaks = self.grid(view), view.technique == "winds" and name != view.field
        array = _speed(grid) if streaks else name
        units = "m s-1" if array == "Wind" else self._source.units(grid, array)
        text = "Streaks" if array == "Wind" else f"Streaks: {array}" if streaks else name
        return text if units.strip().lower() in UNITLESS else f"{text} [{usual(units)}]"

    def add_to(self, plotter: pyvista.BasePlotter, view: View) -> None:
        """Adds the contents of the view to an empty plotter."""
        grid = self.grid(view)
        if self.choices.globe:
            self._add_ground(plotter, view)
        _ADD[view.technique](plotter, grid, view)

    def _terrain(self, view: View) -> pyvista.DataSet | None:
        try:
            return None if self._source.ground is None else terrain_surface(self._source.ground, vertical_exaggeration=view.exaggeration)
        except ValueError:  # no height of the ground
            return None

    def _add_ground(self, plotter: pyvista.BasePlotter, view: View) -> None:
        if view.terrain and self.choices.terrain:
            add_terrain(plotter, self._terrain(view), show_scalar_bar=False, render=False)
        else:
            add_ground(plotter, globe_surface(below=self.grid(view)), render=False)


def draw(plotter: pyvista.BasePlotter, scene: Scene, view: View) -> list[str]:
    """Draws the view in a plotter, instead of its contents, and returns the sentences of the warnings. An empty camera means the usual one."""
    plotter.scalar_bars.clear()
    plotter.clear_actors()
    plotter.disable_depth_peeling()  # the cloud texture turned it on, and multi-sampling off
    plotter.render_window.SetMultiSamples(plotter.theme.multi_samples)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        scene.add_to(plotter, view)
        for number, (name, bar) in enumerate(plotter.scalar_bars.items()):
            bar.SetTitle(f"{scene.title(name, view)}\n ")  # VTK leaves no room between title and labels
            bar.SetOrientationToHorizontal()
            bar.SetPosition(BESIDE if number else BAR["position_x"], BAR["position_y"])
            bar.SetWidth(BAR["width"])
            bar.SetHeight(BAR["height"])
            bar.SetLabelFormat(label_format(*bar.GetLookupTable().GetRange(), bar.GetNumberOfLabels()))
        _look(plotter, scene, view)
        plotter.render()
    return list(dict.fromkeys(one_sentence(warning.message) for warning in caught if issubclass(warning.category, (UserWarning, RuntimeWarning))))


def _look(plotter: pyvista.BasePlotter, scene: Scene, view: View) -> None:
    """The camera of the view, or the usual one: above a region, at a whole globe from the side with the smoke."""
    if view.camera:
        plotter.camera_position = np.reshape(view.camera, (3, 3)).tolist()
    elif scene.choices.globe:
        smoke = [actor for actor in plotter.actors.values() if isinstance(actor, pyvista.Volume)] if view.technique == "smoke" else []
        plotter.view_vector(smoke[0].center if smoke else (1, 1, 0.6), viewup=(0, 0, 1))
        plotter.camera.Dolly(GLOBE_ZOOM)  # a zoom would change the view angle, which a link does not contain
        look_at_region(plotter, scene.grid(view))
    else:
        plotter.view_isometric()
    plotter.reset_camera_clipping_range()


def camera_of(plotter: pyvista.BasePlotter) -> tuple[float, ...]:
    """As View has it."""
    return tuple(float(number) for vector in plotter.camera_position for number in vector)


def _fields(mesh: pyvista.DataSet) -> tuple[str, ...]:
    """Arrays with one component, the active one first."""
    names = [name for data in (mesh.point_data, mesh.cell_data) for name in data
             if data[name].ndim == 1 and np.issubdtype(data[name].dtype, np.number) and not is_helper(name)]
    return tuple(dict.fromkeys(sorted(names, key=lambda name: name != mesh.active_scalars_name)))


def _vectors(mesh: pyvista.DataSet) -> str | None:
    """The winds of a globe, the active vectors, or the first array of three components."""
    names = [name for data in (mesh.point_data, mesh.cell_data) for name in data if data[name].ndim == 2 and data[name].shape[1] == 3
             and not is_helper(name)]
    wanted = ("DisplayVelocity", mesh.active_vectors_name)
    return next((name for name in wanted if name in names), names[0] if names else None)


def _speed(mesh: pyvista.DataSet) -> str | None:
    """The vectors that colour the streaks by their length: winds in m/s, not as they are drawn with exaggerated heights."""
    name = _vectors(mesh)
    return "Wind" if name == "DisplayVelocity" and "Wind" in mesh.point_data else name


def _techniques(mesh: pyvista.DataSet, fields: tuple[str, ...]) -> tuple[str, ...]:
    solid = cell_dimension(mesh) == 3
    structured = isinstance(mesh, (pyvista.ImageData, pyvista.RectilinearGrid, pyvista.StructuredGrid))
    wind = _vectors(mesh) is not None
    there = {"mesh": not solid and cell_dimension(mesh) > 0 or not fields, "cells": solid, "splats": True, "surface": solid and structured,
             "winds": wind, "smoke": solid and wind}
    return tuple(name for name, fits in there.items() if fits and (fields or name == "mesh"))


def _medium(view: View) -> dict[str, Any]:
    return {"scalars": view.field, "opacity_scale": view.opacity, "preset": view.preset or None, "scalar_bar_args": dict(BAR), "render": False, "reset_camera": False}


def _add_surface(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, view: View) -> None:
    if view.field not in grid.point_data:
        grid = grid.cell_data_to_point_data()
    add_cloud_texture(plotter, cloud_surface(grid, scalars=view.field), optical_depth=OPTICAL_DEPTH * view.opacity, render=False)


def _add_smoke(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, view: View) -> None:
    smoke = flow_volume(grid, vectors=_vectors(grid))
    preset = view.preset or (None if _has_colours(preset_of_field(view.field, smoke)) else False)
    add_smoke(plotter, smoke, view.field, optical_depth=view.opacity, preset=preset, scalar_bar_args=dict(BAR), render=False)


def _has_colours(preset: Preset | None) -> bool:
    """Whether its colours show values on smoke: those of clouds are all nearly white."""
    return preset is None or float(np.ptp(preset.colours[:, 1:], axis=0).max()) > 0.3


def _add_winds(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, view: View) -> None:
    add_splats(plotter, grid, vectors={"array": _vectors(grid), "scalars": _speed(grid), "cmap": STREAKS}, **_medium(view))


_ADD: dict[str, Callable[[pyvista.BasePlotter, pyvista.DataSet, View], Any]] = {
    "cells": lambda plotter, grid, view: add_cells(plotter, grid, **_medium(view)),
    "splats": lambda plotter, grid, view: add_splats(plotter, grid, **_medium(view)),
    "winds": _add_winds,
    "surface": _add_surface,
    "smoke": _add_smoke,
    "mesh": lambda plotter, grid, view: plotter.add_mesh(grid, scalars=view.field or None, scalar_bar_args=dict(BAR), render=False),
}
