# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The state of the viewer, and the link that restores it: plain data, without trame, PyVista and VTK."""
from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any, Mapping, Sequence
from urllib.parse import parse_qsl, urlencode

TECHNIQUES = {"cells": "Cells (volume)", "splats": "Splats", "surface": "Cloud surface", "winds": "Wind streaks", "smoke": "Smoke",
              "mesh": "Plain surface"}
PORT = 8080
LIMITS = {"exaggeration": (1.0, 100.0), "opacity": (0.1, 5.0)}
CAMERA_DIGITS = 6  # precision of the numbers in a link: 1 m in 1000 km


@dataclass(frozen=True)
class View:
    """The displayed state; an empty camera means the usual one. The names are those of the link and of the options of the command."""
    field: str = ""
    technique: str = ""
    time: int = 0
    exaggeration: float = 10.0
    opacity: float = 1.0
    preset: str = ""
    terrain: bool = True
    camera: tuple[float, ...] = ()  # position, focal point, view up


@dataclass(frozen=True)
class Choices:
    """The choices that the data allow. The first field and technique are the initial ones."""
    fields: tuple[str, ...]
    techniques: tuple[str, ...]
    presets: tuple[str, ...] = ()
    times: tuple[str, ...] = ()
    globe: bool = False
    terrain: bool = False


def checked(view: View, choices: Choices) -> tuple[View, list[str]]:
    """The view, with items that the data do not allow replaced by the initial ones, and a sentence for each replacement."""
    problems: list[str] = []
    for name, there in (("field", choices.fields), ("technique", choices.techniques), ("preset", choices.presets)):
        value = getattr(view, name)
        if value and value not in there:
            problems.append(f"There is no {name} {value!r}. There are: {', '.join(there) or 'none'}.")
            value = ""
        view = replace(view, **{name: value or ("" if name == "preset" else (*there, "")[0])})
    if not 0 <= view.time < max(1, len(choices.times)):
        problems.append(f"There is no time step {view.time}. There are {max(1, len(choices.times))}, from 0.")
        view = replace(view, time=0)
    for name, (least, most) in LIMITS.items():
        value = getattr(view, name)
        if not least <= value <= most:  # and NaN is ignored
            problems.append(f"{name} is {value:g}. It must be {least:g} to {most:g}.")
            view = replace(view, **{name: getattr(View, name)})
    return view, problems


def to_query(view: View, choices: Choices) -> str:
    """The query of the link, with the items that the data allow."""
    items = {"field": view.field, "technique": view.technique, "opacity": f"{view.opacity:g}"}
    items.update({"time": view.time} if len(choices.times) > 1 else {})
    items.update({"exaggeration": f"{view.exaggeration:g}"} if choices.globe else {})
    items.update({"terrain": int(view.terrain)} if choices.terrain else {})
    items.update({"preset": view.preset} if view.preset else {})
    items.update({"camera": " ".join(f"{number:.{CAMERA_DIGITS}g}" for number in view.camera)} if view.camera else {})
    return "?" + urlencode(items)


def from_query(query: str, start: View) -> tuple[View, list[str]]:
    """`start` updated by the query of a link, and a sentence for each part that cannot be read. Unknown parameters are ignored."""
    return from_mapping(dict(parse_qsl(query.lstrip("?"), keep_blank_values=True)), start)


def from_mapping(items: Mapping[str, Any], start: View) -> tuple[View, list[str]]:
    """`start` updated by the items that belong to a view, as texts or values."""
    problems: list[str] = []
    for one in fields(View):
        if items.get(one.name) is None:
            continue
        try:
            start = replace(start, **{one.name: _READERS[one.name](items[one.name])})
        except (TypeError, ValueError, OverflowError):
            problems.append(f"{one.name} cannot be {items[one.name]!r}: {_EXPECTED.get(one.name, 'a number is expected')}.")
    return start, problems


def _number(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(value)
    return number


def _truth(value: Any) -> bool:
    if str(value).lower() not in ("0", "1", "false", "true"):
        raise ValueError(value)
    return str(value).lower() in ("1", "true")


def _camera(value: str | Sequence[float]) -> tuple[float, ...]:
    numbers = tuple(_number(part) for part in (value.split() if isinstance(value, str) else value))
    if numbers and (len(numbers) != 9 or numbers[:3] == numbers[3:6] or not any(numbers[6:])):
        raise ValueError(value)
    return numbers


_READERS = {"field": str, "technique": str, "preset": str, "time": int, "exaggeration": _number, "opacity": _number,
            "terrain": _truth, "camera": _camera}
_EXPECTED = {"time": "a whole number is expected", "terrain": "0 or 1 is expected",
             "camera": "nine numbers are expected: the position, the focal point and the upward direction"}
