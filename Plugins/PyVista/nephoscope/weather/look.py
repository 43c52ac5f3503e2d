# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours that suit a quantity: the preset of a variable by its name, its standard name, its role or its units, and how a surface has them."""
from __future__ import annotations

import re
import warnings
from typing import Any, Callable

import numpy as np
import pyvista

from .._fields import PRESET_ENDING, find_preset, is_bright, preset_of_field, presets
from .._outliers import is_mostly_zero, share_outside, skewed_range, warn_of_fill_values
from .._over_time import follows, values_over_time
from .._pipeline import level_of_caller
from .roles import ROLES, candidates
from .units import knows, plain

CODES = "_is_codes"  # ending of the name of a field array
STRATIFIED = "_is_stratified"  # likewise
SHEER = ("clouds", "cloud water", "rain", "smoke")  # presets of what is not everywhere: where there is none of it, the ground is seen
WHITE = ("clouds", "cloud water")  # among them: thin ones show more of the ground, and are not darker
_OF_ROLES = {"temperature": "temperature", "potential_temperature": "temperature", "u": "wind component", "v": "wind component", "w": "wind component", "specific_humidity": "humidity",
             "mixing_ratio": "humidity", "relative_humidity": "humidity", "cloud_fraction": "clouds", "cloud_water": "cloud water", "cloud_ice": "cloud water", "rain": "rain",
             "snow": "rain", "graupel": "rain"}
# Words of standard and long names; the first that fits decides.
_OF_WORDS = ((r"vorticity|divergence|anomaly|tendency|increment", "wind component"), (r"temperature", "temperature"), (r"wind[ _]speed|speed[ _]of|gust", "wind speed"),
             (r"wind|velocity|flux", "wind component"), (r"cloud.*(fraction|cover)|(fraction|cover).*cloud", "clouds"), (r"humidity|water[ _]vapou?r|dew[ _]point", "humidity"),
             (r"rain|snow|precipitation|reflectivity|graupel|hail", "rain"), (r"cloud|condensate|liquid[ _]water|ice[ _]water", "cloud water"), (r"smoke|dust|aerosol|soot|ash\b", "smoke"))
_OF_QUANTITIES = {"equivalent_potential_temperature": "temperature", "water_vapour": "humidity", "cloud_content": "cloud water"}
_IN_LEVELS = ("geopotential_height", "geopotential", "altitude", "pressure")  # roles of fields that vary little within a level
_NEVER = re.compile(r"time|altitude|height|(?<!optical[ _])thickness|pressure|geopotential|cell[ _]area|mask")  # whatever else the name says


def note_look(mesh: pyvista.DataSet, dataset, name: str) -> None:
    """Writes into `mesh` which preset suits its array `name`, if the name alone does not say so, and whether its values are codes, as CF's ``flag_values`` say."""
    if name in dataset.variables and "flag_values" in dataset[name].attrs:
        mesh.field_data[name + CODES] = [1]
    if name in dataset.variables and (dataset[name].attrs.get("standard_name") == "air_density" or any(candidates(ROLES[role], [(name, dataset[name])]) for role in _IN_LEVELS)):
        mesh.field_data[name + STRATIFIED] = [1]
    found = suited(dataset, name)
    if found and preset_of_field(name, mesh) is None:
        mesh.field_data[name + PRESET_ENDING] = [found]


def suited(dataset, name: str) -> str | None:
    """The name of the preset; None if no preset suits the variable or the computed quantity."""
    if name not in dataset.variables:
        return _OF_QUANTITIES.get(name)
    attrs = dataset[name].attrs
    standard = str(attrs.get("standard_name", "")).lower()
    if standard and (found := preset_of_field(standard)):
        return found.name
    role = next((role for role in _OF_ROLES if candidates(ROLES[role], [(name, dataset[name])])), None)
    if role:
        return _OF_ROLES[role]
    for text in (standard, *(str(attrs.get(key, "")).lower() for key in ("long_name", "GRIB_name", "description"))):
        if text and not _NEVER.search(text):
            found = next((preset for words, preset in _OF_WORDS if re.search(words, text)), None)
            if found:
                return found
    return "temperature" if plain(attrs.get("units")) and knows(attrs["units"], "temperature") else "rain" if plain(attrs.get("units")) == "dbz" else None


def surface_look(plotter: pyvista.BasePlotter, grid: pyvista.DataSet, name: str, association: str, options: dict[str, Any], over_ground: bool = True) -> dict[str, Any]:
    """Colours, range and opacity of the preset of the array for `add_mesh`, unless the `options` have others."""
    if options.get("clim") is None:
        warn_of_fill_values(values_over_time(grid, name, association), name, grid, "clim")
    preset = find_preset(options.pop("preset", None), name, grid) if not options.get("log_scale") else None
    if isinstance(options.get("cmap"), str) and options["cmap"] in presets():
        preset = presets()[options.pop("cmap")]
    values = values_over_time(grid, name, association)
    bulk = skewed_range(values) if options.get("clim") is None and not options.get("log_scale") else None
    over_time = _range_of(values, follows(grid))
    if preset is None or "cmap" in options:
        sheer = preset is None and options.get("clim") is None and not options.get("log_scale") and name + CODES not in grid.field_data and is_mostly_zero(values)
        clim = None if options.get("log_scale") else bulk or over_time
        if sheer and isinstance(options.get("cmap"), (list, tuple)):
            options["cmap"] = [options["cmap"][i * len(options["cmap"]) // 256] for i in range(256)]  # as many as PyVista's "linear" has opacities
        return {**({"opacity": "linear"} if sheer else {}), **options, **({} if clim is None or options.get("clim") is not None else {"clim": clim})}
    clim = options.get("clim") or preset.clim(values) or (None if preset.name in SHEER else bulk) or over_time
    colours = preset.colour_map(is_bright(plotter.background_color))
    if preset.name in SHEER:
        if "opacity" not in options:
            _warn_of_empty_picture(values, name, clim)
        options = {"opacity": "linear", **options}
        if preset.name == "smoke" and over_ground:  # its browns are those of deserts
            return {**({} if clim is None else {"clim": clim}), **options}
        colours = len(colours) * ["white"] if preset.name in WHITE and over_ground else colours
    return {"cmap": colours, **({} if clim is None else {"clim": clim}), **options}


def _range_of(values: np.ndarray, moves: bool) -> tuple[float, float] | None:
    """The range of values that are all equal, widened as in `add_cells`, or of the values of all times; None for others, whose range PyVista finds."""
    finite = values[np.isfinite(values)]
    if not finite.size or not moves and np.ptp(finite) > 0:
        return None
    low, high = float(finite.min()), float(finite.max())
    return (low - 0.5, high + 0.5) if low == high else (low, high)


def _warn_of_empty_picture(values: np.ndarray, name: str, clim: tuple[float, float] | None) -> None:
    """Warns if a surface is transparent at all its values."""
    finite = values[np.isfinite(values)]
    if clim is not None and finite.size and finite.max() <= clim[0]:
        told = f"is {finite.max():g} everywhere" if np.ptp(finite) == 0 else f"is {finite.min():g} to {finite.max():g}"
        warnings.warn(f"Nothing will be visible: the array {name!r} {told}, where its colours are transparent. Choose another time or clim, or opacity=1.", UserWarning, stacklevel=level_of_caller())


def with_share(title: Callable[[str], str], grid: pyvista.DataSet, name: str, association: str, asked: dict[str, Any], look: dict[str, Any]) -> Callable[[str], str]:
    """`title` for scalar bars, with a second line that says how many values are beyond the colours of the array `name`, unless a range was asked for."""
    told = "" if asked.get("clim") is not None else share_outside(values_over_time(grid, name, association), look.get("clim"))
    return lambda array: title(array) + (f"\n{told}" if told and array == name else "")
