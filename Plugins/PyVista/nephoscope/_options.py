# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that combine several options, such as ``vectors=dict(array="wind", style="segments")``, and the single arguments that they replace."""
from __future__ import annotations

import warnings
from dataclasses import fields
from difflib import get_close_matches
from inspect import signature
from typing import Any, Callable, Mapping, Sequence

from ._checks import listed
from ._pipeline import level_of_caller


_SHADING = "Volumes are not shaded. sun=... lights them; the coefficients in the volume's `.prop` shade contour surfaces."
_MISSING = "Cells with missing values (NaN) are not drawn."
_TABLE = "Pass a pyvista.LookupTable as cmap: it has colours below and above its range, and annotations."
OF_ADD_VOLUME = {**dict.fromkeys(("shade", "ambient", "diffuse", "specular", "specular_power"), _SHADING), **dict.fromkeys(("nan_color", "nan_opacity"), _MISSING),
                 **dict.fromkeys(("above_color", "below_color", "annotations", "categories"), _TABLE), "blending": "Volumes are always composited."}


def group(argument: str, value: Any, options: type, first: str, old: dict[str, Any], renamed: Mapping[str, str]) -> Any:
    """An object of the dataclass `options`.

    `value` is None, a dict with the names of its fields, or the value of the field `first`. `old` holds arguments with earlier names.
    Arguments that `renamed` maps to the name of a field are removed from `old`, with a DeprecationWarning.
    """
    known = [field.name for field in fields(options)]
    given = dict(value) if isinstance(value, Mapping) else {} if value is None else {first: value}
    unknown = [name for name in given if name not in known]
    if unknown:
        raise TypeError(f"{argument} has no option {unknown[0]!r}; the options are {listed(known)}.")
    for name in [name for name in old if name in renamed]:
        field = renamed[name]
        if field in given:
            raise ValueError(f"{name} and {argument}[{field!r}] are both given; {name} is the old name of the latter.")
        warnings.warn(f"{name} is now an option of {argument}: {argument}=dict({field}=...).", DeprecationWarning, stacklevel=level_of_caller())
        given[field] = old.pop(name)
    return options(**given)


def refuse_unknown(function: Callable, old: Mapping[str, Any], others: Sequence[str] = ()) -> None:
    """Raises TypeError, like Python, for keyword arguments that no option uses. `others`: options that the function has besides its parameters."""
    if old:
        name = next(iter(old))
        if name in OF_ADD_VOLUME:
            raise TypeError(f"{function.__name__}() has no argument {name!r}. {OF_ADD_VOLUME[name]}")
        near = get_close_matches(name, [*signature(function).parameters, *others], 1, 0.7)
        raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}." + (f" Did you mean {near[0]!r}?" if near else ""))
