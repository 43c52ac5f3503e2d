# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Methods of one plotter, or of a part of it, that do something more than those of its class."""
from __future__ import annotations

import functools
import weakref
from typing import Any, Callable


def wrap_method(plotter: Any, name: str, around: Callable[..., Any]) -> None:
    """Makes `plotter.name(...)` call `around(plotter, method, ...)`, where `method` is that of the class. `plotter` may be another object.

    Nothing happens if the class has no such method, or if that of this object has been replaced before. The object is not kept alive.
    """
    if name in vars(plotter) or not callable(getattr(plotter, name, None)):
        return
    reference = weakref.ref(plotter)

    @functools.wraps(getattr(type(plotter), name))
    def method(*arguments: Any, **options: Any) -> Any:
        wrapped = reference()
        return around(wrapped, functools.partial(getattr(type(wrapped), name), wrapped), *arguments, **options)

    setattr(plotter, name, method)
