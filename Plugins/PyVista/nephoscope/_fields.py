# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of weather fields, and the presets of colour, opacity and range that suit them.

The presets are those that ParaView lists: `nephoscope_presets.json`.
"""
from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import pyvista

from ._checks import listed

SAMPLES = 256
BRIGHT = 0.6  # luminance of a background on which white clouds would be invisible
PRESET_ENDING = "_preset"  # of field data that name the preset of an array, where its name does not tell
FLAT_GRID = "FlatGrid"  # field data that mark the meshes of dataset.nephoscope.grid()
HELPERS = {"belowground", "globegridprojection", "planetradius", "verticalexaggeration", "time", "timevalue", "crs", "lat", "latitude",
           "lon", "longitude", "lev", "level", "plev", "normals", "tcoords", "texturecoordinates", "texture coordinates"}


@dataclass(frozen=True)
class Preset:
    """Colours (n, 4) and opacities (m, 2) at fractions of the range, and the rule that derives the range from the values."""
    name: str
    range_rule: str
    colours: np.ndarray
    colours_on_bright: np.ndarray
    opacities: np.ndarray

    def colour_map(self, bright: bool, samples: int = SAMPLES) -> list[str]:
        """Colours at equal steps, in the form that `pyvista.LookupTable.apply_cmap` accepts."""
        points = self.colours_on_bright if bright else self.colours
        steps = np.linspace(0, 1, samples)
        rgb = np.stack([np.interp(steps, points[:, 0], points[:, c]) for c in (1, 2, 3)], axis=1)
        return [pyvista.Color(row).hex_rgb for row in rgb]

    def opacity_values(self) -> np.ndarray:
        """Opacities at equal steps."""
        return np.interp(np.linspace(0, 1, SAMPLES + 1), self.opacities[:, 0], self.opacities[:, 1])

    def clim(self, values: np.ndarray) -> tuple[float, float] | None:
        """The range for these values; None: the range of the values themselves."""
        finite = values[np.isfinite(values)]
        low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
        if self.range_rule in ("fraction", "from zero") and finite.size and low == high == 0:
            return 0.0, 1.0  # a clear sky
        if self.range_rule == "fraction" and low >= -0.01 and 0 < high <= 100.5:
            return 0.0, 1.0 if high <= 1.01 else 100.0
        if self.range_rule in ("fraction", "from zero") and low >= 0 and high > 0:
            return 0.0, high
        if self.range_rule == "symmetric" and max(-low, high) > 0:
            greatest = _greatest_but_spikes(finite)
            return -greatest, greatest
        return None


def _greatest_but_spikes(values: np.ndarray) -> float:
    """Greatest magnitude, at most 3 sum(v^2)/sum|v|: a Gaussian peak of any width keeps its maximum (the limit is 1.06 times that), and a few spikes do not make the rest pale."""
    magnitudes = np.abs(values.astype(float)).ravel()
    greatest = magnitudes.max()
    shares = magnitudes / greatest  # squares that fit
    return greatest * min(1.0, 3 * np.sum(shares * shares) / np.sum(shares))


@lru_cache(maxsize=None)
def presets() -> dict[str, Preset]:
    """Presets by their names in Python: "clouds", "wind speed", ..."""
    return {entry["NephoscopeName"]: _preset(entry) for entry in _entries() if "NephoscopeName" in entry}


def terrain_preset(count: int) -> tuple[tuple[float, float], list[str]]:
    """First and last height of the terrain colours, in metres, and that number of colours between them."""
    entry = next(entry for entry in _entries() if entry["Name"] == "Nephoscope Terrain")
    points = np.reshape(entry["RGBPoints"], (-1, 4))
    heights = np.linspace(points[0, 0], points[-1, 0], count)
    rgb = np.stack([np.interp(heights, points[:, 0], points[:, c]) for c in (1, 2, 3)], axis=1)
    return (float(points[0, 0]), float(points[-1, 0])), [pyvista.Color(row).hex_rgb for row in rgb]


@lru_cache(maxsize=None)
def _entries() -> list[dict[str, Any]]:
    return json.loads((Path(__file__).parent / "nephoscope_presets.json").read_text(encoding="utf-8"))


def _preset(entry: dict[str, Any]) -> Preset:
    colours = np.reshape(entry["RGBPoints"], (-1, 4))
    bright = np.reshape(entry.get("NephoscopeColorsOnBright", entry["RGBPoints"]), (-1, 4))
    return Preset(entry["NephoscopeName"], entry["NephoscopeRange"], colours, bright, np.reshape(entry["Points"], (-1, 4))[:, :2])


@lru_cache(maxsize=None)
def _names(key: str) -> dict[str, str]:
    return {array: entry["NephoscopeName"] for entry in _entries() for array in entry.get(key, ())}


def _is_weather(mesh: pyvista.DataSet, name: str) -> bool:
    """True for output of Globe Grid, flat grids of xarray's data, and output of the NetCDF reader, which records the units of every array."""
    return "GlobeGridProjection" in mesh.field_data or FLAT_GRID in mesh.field_data or f"{name}_units" in mesh.field_data


def preset_of_field(name: str, mesh: pyvista.DataSet | None = None) -> Preset | None:
    """The preset of the array `name`: its own, or that of its CF standard name or usual name; None if there is none.

    Names that other fields use too, such as "t", "u" and "Density", count only in a `mesh` that is marked as weather.
    """
    found = _names("NephoscopeArrays").get(name) or (_names("NephoscopeArrays").get(name.lower()) if len(name) > 2 else None)
    if not found and mesh is not None and _is_weather(mesh, name):
        found = _names("NephoscopeWeatherArrays").get(name)
    if not found and mesh is not None and name + PRESET_ENDING in mesh.field_data:
        found = str(mesh.field_data[name + PRESET_ENDING][0])
    return presets().get(found) if found else None


def find_preset(preset: str | bool | None, name: str, mesh: pyvista.DataSet) -> Preset | None:
    """The preset that the argument `preset` of a plotter function selects for the array `name` of `mesh`."""
    if preset is False:
        return None
    if preset is None or preset is True:
        return preset_of_field(name, mesh)
    if not isinstance(preset, str) or preset not in presets():
        raise ValueError(f"preset is {preset!r}; it must be False or one of {listed(list(presets()))}.")
    return presets()[preset]


def is_bright(background: Any) -> bool:
    red, green, blue = pyvista.Color(background).float_rgb
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue > BRIGHT


def is_helper(name: str) -> bool:
    """True for coordinates, masks and numbers, which are not weather fields."""
    lower = name.lower()
    return lower in HELPERS or lower.startswith("vtk") or lower.endswith(("_units", "_bnds", "_bounds", "ids"))


def choose_active_scalars(mesh: pyvista.DataSet) -> None:
    """Make cloud fraction, cloud water or the first point array with one component the active scalars."""
    fields = [name for name in mesh.point_data if mesh.point_data[name].ndim == 1 and not is_helper(name)]
    order = ("clouds", "cloud water")
    for wanted in order:
        for name in fields:
            found = preset_of_field(name, mesh)
            if found and found.name == wanted:
                mesh.set_active_scalars(name)
                return
    if fields:
        mesh.set_active_scalars(fields[0])
