# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls of the setters of a wrapped class with arguments at random, by the signatures in their docstrings."""
import re

import nephoscope
import random_data

FLOATS = (0.0, 1.0, -1.0, 0.5, 2.0, 10.0, 0.01, 1e-30, 1e30, float("nan"), float("inf"), float("-inf"))
INTEGERS = (-1, 0, 0, 1, 1, 2, 3, 5, 17)
SIGNATURE = re.compile(r"^(Set\w+|\w+(?:On|Off)|Add\w+|RemoveAll\w+|Generate\w+)\(self(?:, (.*))?\) -> (?:None|bool|int)$", re.MULTILINE)
NOT_CALLED = re.compile(r"SetInput|SetController|SetSurface(Data|Connection)|SetPolygon(Data|Connection)|SetPoints(Data|Connection)|SetFileName|"
                        r"SetAbort|SetProgress|AddObserver|SetDensityVolume|SetGeodesyTables")


def split(arguments):
    """The types of a signature's arguments; a tuple is one."""
    return [part.split(":", 1)[-1].split("=")[0].strip() for part in re.split(r",\s*(?![^(]*\))", arguments or "") if part]


def argument(dice, kind, data):
    if kind.startswith("("):
        return [argument(dice, part.strip(), data) for part in kind.strip("()").split(",") if part.strip()]
    if kind == "float":
        return dice.pick(FLOATS) if dice.odd(0.5) else float(abs(dice.rng.normal()))
    if kind == "int":
        return dice.pick(INTEGERS)
    if kind == "bool":
        return bool(dice.rng.random() < 0.5)
    if kind == "str":
        return random_data.array_name(dice, data)
    return LookupError


def setters(cls):
    """[(method, kinds of arguments)] of the classes of this project."""
    found = []
    for one in cls.__mro__:
        if one.__name__ in vars(nephoscope):
            for name, method in vars(one).items():
                for match in SIGNATURE.finditer(getattr(method, "__doc__", None) or ""):
                    if match[1] == name and not NOT_CALLED.match(name):
                        found.append((name, split(match[2])))
    return sorted(found)


def call(dice, target, data, most):
    """Up to `most` calls, which are returned as text."""
    available, made = setters(type(target)), []
    for _ in range(dice.rng.integers(most + 1) if available else 0):
        name, kinds = dice.pick(available)
        arguments = [argument(dice, kind, data) for kind in kinds]
        if LookupError in arguments:
            continue
        made.append(f"{name}({', '.join(map(repr, arguments))})")
        try:
            getattr(target, name)(*arguments)
        except (TypeError, ValueError, OverflowError):
            pass  # refused by the wrapping
    return made
