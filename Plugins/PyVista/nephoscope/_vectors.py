# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors of a textured splat mapper, from the options `vectors` of `add_splats`."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyvista
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

from . import vtkSplatSpeedKey
from ._bars import add_bar, key_of
from ._checks import choose, listed, require_beside_scalars, require_number
from ._media import colours_of, is_drawn, media_in_view
from ._medium import array_values, lookup_table, text_colour
from ._over_time import lengths_of_vectors, step_with_greatest, values_over_time
from ._pipeline import level_of_caller
from ._typing import Numbers
from .transfer import colour_function


ALONE = 2.0  # optical depth of the fastest streaks
LONG, TOLD = 1.25, 2.0  # times the length that 99 % of the vectors do not exceed: longer ones are drawn as if they were that long, and a warning tells it


def _with_colours_of(media: list[Any]) -> vtkVolumeProperty:
    """A property with the colours of all of them, one after the other."""
    function, together = vtkColorTransferFunction(), vtkVolumeProperty()
    for i, colour in enumerate(np.concatenate([colours_of(medium) for medium in media])):
        function.AddRGBPoint(i, *colour)
    together.SetColor(function)
    return together


def _with_arrays(step: pyvista.DataSet, drawn: pyvista.DataSet) -> pyvista.DataSet:
    """The mesh of another step, with the arrays that only the drawn mesh has; the drawn mesh, if they do not fit."""
    if (step.n_points, step.n_cells) != (drawn.n_points, drawn.n_cells):
        return step if set(drawn.array_names) <= set(step.array_names) else drawn
    step = step.copy(deep=False)
    for here, there in ((step.point_data, drawn.point_data), (step.cell_data, drawn.cell_data)):
        for name in [name for name in there.keys() if name not in here]:
            here.set_array(there[name], name)
    return step


OLD_NAMES = {"vector_style": "style", "vector_placement": "placement", "vector_opacity": "opacity", "vector_color": "color", "vector_scalars": "scalars",
             "vector_cmap": "cmap", "vector_clim": "clim", "greatest_speed": "maximum_speed", "vector_share": "fraction", "vector_unit": "unit",
             **{name: name for name in ("streak_period", "streak_width", "segment_length", "segment_width", "layer_axis", "phase", "phase_cycles",
                                        "phase_steps")}}


@dataclass
class Vectors:
    """The options `vectors` of `add_splats`; see there. Checked when applied."""
    array: str | None = None
    style: str = "streaks"
    placement: str = "middle"
    opacity: float | None = None
    color: Any = None
    scalars: str | None = None
    cmap: Any = None
    clim: float | Numbers | None = None
    maximum_speed: float | None = None
    fraction: float | None = None
    unit: float | None = None
    streak_period: float = 4.0
    streak_width: float = 0.1
    segment_length: float = 2.0
    segment_width: float = 1.5
    layer_axis: str | int = "eye"
    phase: float | None = None
    phase_cycles: int = 4
    phase_steps: int = 0
    true_speed: bool = False
    time_scale: float | None = None
    film_time: float | None = None
    speed_key: bool | None = None
    speed_unit: str | None = None
    length_unit: float = 1.0

    def __post_init__(self) -> None:
        self.table: pyvista.LookupTable | None = None  # range of the colours from `scalars`, found when applied

    def _number(self, name: str, **limits: float) -> float:
        return require_number(getattr(self, name), f"vectors[{name!r}]", **limits)

    def apply(self, mapper: Any, plotter: pyvista.BasePlotter, mesh: pyvista.DataSet, association: str) -> None:
        choose({"streaks": mapper.SetVectorStyleToStreaks, "segments": mapper.SetVectorStyleToSegments}, self.style, "vectors['style']")
        mapper.SetVectorOpacity(ALONE if self.opacity is None else self._number("opacity", least=0))
        mapper.SetVectorFraction(1.0 if self.fraction is None else self._number("fraction", above=0, most=1))
        mapper.SetStreakPeriod(self._number("streak_period", least=0.01, most=1000))
        mapper.SetPhaseCycles(int(self._number("phase_cycles", least=1, most=1000)))
        mapper.SetPhaseSteps(int(self._number("phase_steps", least=0, most=1000)))
        mapper.SetStreakWidth(self._number("streak_width", least=0.001, most=10))
        mapper.SetSegmentLength(self._number("segment_length", least=0, most=1000))
        mapper.SetSegmentWidth(self._number("segment_width", least=0.1, most=100))
        if self.unit is not None:
            mapper.SetVectorUnit(self._number("unit", above=0))
        if self.maximum_speed is not None:
            mapper.SetMaximumSpeed(self._number("maximum_speed", above=0))
        if self.phase is not None:
            mapper.phase = self._number("phase")
        self._apply_speed(mapper)
        self._apply_placement(mapper, mesh)
        self._apply_array(mapper, mesh, association)
        self._apply_colours(mapper, plotter, mesh, association)

    def _apply_speed(self, mapper: Any) -> None:
        mapper.SetTrueSpeed(bool(self.true_speed))
        length = self._number("length_unit", above=0)
        if not self.true_speed and (self.time_scale is not None or self.film_time not in (None, 0)):
            raise ValueError("vectors has the option 'time_scale' or 'film_time', but true_speed is not True.")
        if length != 1 and not self.true_speed:
            raise ValueError("vectors has the option 'length_unit', but true_speed is not True.")
        if length != 1 and self.time_scale is None and not self._speed_unit():
            raise ValueError("vectors has the option 'length_unit', but no 'speed_unit'; name the unit of the vectors, for example 'm/s'.")
        if self.time_scale is not None:
            mapper.SetTimeScale(self._number("time_scale", above=0) / length)
        if self.film_time is not None:
            mapper.film_time = self._number("film_time")

    def _speed_unit(self) -> str:
        return ("m/s" if self.array == "DisplayVelocity" else "") if self.speed_unit is None else str(self.speed_unit)

    def _apply_placement(self, mapper: Any, mesh: pyvista.DataSet) -> None:
        choose({"middle": mapper.SetVectorPlacementToMiddle, "layers": mapper.SetVectorPlacementToLayers}, self.placement, "vectors['placement']")
        if self.layer_axis not in ("eye", 0, 1, 2):
            raise ValueError(f"vectors['layer_axis'] is {self.layer_axis!r}; it must be one of 'eye', 0, 1, 2.")
        on_grid = isinstance(mesh, (pyvista.ImageData, pyvista.RectilinearGrid, pyvista.StructuredGrid))
        mapper.SetLayerAxis(int(self.layer_axis) if on_grid and self.layer_axis != "eye" else -1)
        if self.array is not None and self.placement == "layers" and not on_grid:
            self._warn_of_layers(mesh)

    def _apply_array(self, mapper: Any, mesh: pyvista.DataSet, association: str) -> None:
        if self.array is not None:
            if not isinstance(self.array, str):
                known = [name for data in (mesh.point_data, mesh.cell_data) for name in data.keys() if data[name].ndim == 2 and data[name].shape[1] == 3]
                raise TypeError(f"vectors is {self.array!r}; it must be the name of an array of vectors, or a dict of options with the name under 'array'. Arrays of vectors: {listed(known)}.")
            self._require_vectors(mesh, association)
            mapper.SetVectorArrayName(self.array)
        elif self.color is not None or self.scalars is not None:
            raise ValueError("vectors has the option 'color' or 'scalars', but no 'array'; name the array of vectors.")
        if self.color is not None:
            mapper.SetVectorColor(pyvista.Color(self.color).float_rgb)
            mapper.SetUseVectorColor(True)

    def _warn_of_layers(self, mesh: pyvista.DataSet) -> None:
        ignored = "" if self.layer_axis == "eye" else "layer_axis is ignored, and "
        warnings.warn(f"vectors['placement'] is 'layers': only a structured grid (ImageData, RectilinearGrid, StructuredGrid) has layers; the mesh is drawn as "
                      f"{type(mesh).__name__}. Instead, {ignored}layers at right angles to the line of sight are drawn. Use 'middle' for "
                      "pictures that change less with the view.", UserWarning, stacklevel=level_of_caller())

    def suit(self, mapper: Any, plotter: pyvista.BasePlotter, prop: pyvista.VolumeProperty, given: pyvista.DataSet, coloured: bool) -> None:
        """Draws as many streaks as are readable, adjusts them to the media that are drawn too, and to all steps of a series, unless the user has set them. `given`: the
        mesh of the user. `coloured`: the user has chosen colours of the medium. Call it after everything else is set."""
        if self.array is None:
            return
        drawn, speed = mapper.dataset, self._full_length(lengths_of_vectors(given, self.array))
        if speed is not None:
            mapper.SetInputData(_with_arrays(step_with_greatest(given, self.array), drawn))
            if self.maximum_speed is None:
                mapper.SetMaximumSpeed(speed)
        self._suit_to_medium(mapper, plotter, prop, coloured)
        if speed is not None:
            mapper.SetVectorUnit(mapper.FindVectorUnit())
            mapper.SetInputData(drawn)

    def _full_length(self, lengths: np.ndarray) -> float | None:
        """The length at which vectors are fully drawn, found as by the mapper; None if there are no lengths."""
        if not lengths.size:
            return None
        usual, greatest = np.percentile(lengths, 99), lengths.max()
        full = float(min(greatest, LONG * usual))
        if greatest > TOLD * usual and self.maximum_speed is None:
            warnings.warn(f"The array {self.array!r} has vectors of a length of up to {greatest:.3g}, but 99 % are not longer than {usual:.3g}: vectors longer than {full:.3g} "
                          "are clamped to this length. Replace wrong values, or pass vectors['maximum_speed'].", UserWarning, stacklevel=level_of_caller())
        return full

    def _suit_to_medium(self, mapper: Any, plotter: pyvista.BasePlotter, prop: pyvista.VolumeProperty, coloured: bool) -> None:
        in_medium = is_drawn(prop.GetScalarOpacity())
        mapper.SuitVectorsToMedium(in_medium and self.opacity is None, self.fraction is None and self.style == "streaks")
        media = [volume.GetProperty() for volume in media_in_view(plotter)] + [prop] * in_medium
        if media and (in_medium or not coloured) and self.color is None and self.scalars is None:
            mapper.SuitVectorColor(_with_colours_of(media), plotter.background_color.float_rgb)

    def add_bar(self, plotter: pyvista.BasePlotter, bar_args: dict | None) -> None:
        """Adds a scalar bar for vectors with their own colour array. It is vertical if there is a horizontal bar, because PyVista places horizontal bars too close for
        their titles."""
        if self.table is None:
            return
        shown = pyvista.DataSetMapper()
        shown.lookup_table, shown.scalar_range = self.table, self.table.scalar_range
        own = {name: value for name, value in (bar_args or {}).items() if name not in ("title", "mapper", "position_x", "position_y")}
        title = self.scalars if key_of(plotter, self.scalars) not in plotter.scalar_bars else f"{self.scalars} of {self.array}"
        upright = {"vertical": True, "position_y": 0.28} if any(map(plotter.renderer.HasViewProp, plotter.scalar_bars.values())) else {}
        add_bar(plotter, **{"color": text_colour(plotter), **upright, **own, "title": title, "mapper": shown})

    def add_key(self, plotter: pyvista.BasePlotter, volume: pyvista.Volume, shows_bars: bool) -> None:
        """Adds the legend of the motion, which is drawn as long as the volume is."""
        shown = self.true_speed and shows_bars if self.speed_key is None else self.speed_key
        if self.array is None or not shown:
            return
        key = vtkSplatSpeedKey()
        key.SetVolume(volume)
        key.SetSpeedUnit(self._speed_unit())
        key.SetLengthUnit(self.length_unit)
        plotter.add_actor(key, name=f"{getattr(volume, 'name', '') or 'splats'}-speed-key", reset_camera=False, pickable=False, render=False)

    def _require_vectors(self, mesh: pyvista.DataSet, association: str) -> None:
        require_beside_scalars(mesh, self.array, association, "vectors")
        values = array_values(mesh, self.array, association)
        if values.ndim != 2 or values.shape[1] != 3:
            components = 1 if values.ndim == 1 else values.shape[1]
            raise ValueError(f"vectors: the array {self.array!r} has {components} components; three are needed.")

    def _apply_colours(self, mapper: Any, plotter: pyvista.BasePlotter, mesh: pyvista.DataSet, association: str) -> None:
        if self.scalars is None:
            if self.cmap is not None or self.clim is not None:
                raise ValueError("vectors has the option 'cmap' or 'clim', but no 'scalars', the array that they colour.")
            return
        if self.color is not None:
            raise ValueError("vectors has the options 'color' and 'scalars'; vectors have one colour, or that of an array.")
        require_beside_scalars(mesh, self.scalars, association, "vectors['scalars']")
        values = np.asarray(values_over_time(mesh, self.scalars, association), float)
        values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
        table = self.cmap if isinstance(self.cmap, pyvista.LookupTable) else lookup_table(
            plotter, values, self.scalars, self.cmap, self.clim)
        mapper.SetVectorColorArrayName(self.scalars)
        mapper.SetVectorColorFunction(colour_function(table))
        self.table = table
