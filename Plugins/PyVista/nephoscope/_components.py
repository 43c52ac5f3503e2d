# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors as scalars: their magnitude or one of their components, as `pyvista.Plotter.add_mesh` draws them."""
from __future__ import annotations

import operator
from typing import Any

import numpy as np


def are_colours(values: np.ndarray) -> bool:
    """Whether the values are red, green and blue, perhaps with an opacity, of 8 bits each."""
    return values.ndim == 2 and values.shape[1] in (3, 4) and values.dtype == np.uint8


def reduced(values: np.ndarray, component: int | None) -> np.ndarray:
    """Scalars unchanged; of vectors the component or, without one, the magnitude."""
    if values.ndim == 1:
        return values
    return np.linalg.norm(values, axis=1) if component is None else values[:, component]


def title_of(name: str, values: np.ndarray, component: int | None) -> str:
    """The title of the scalar bar."""
    if values.ndim == 1:
        return name
    return f"{name} magnitude" if component is None else f"{name} component {component}"


def require_component(values: np.ndarray, name: str, component: Any, remedy: str = "For colours of points call plotter.add_mesh(mesh, rgb=True).") -> None:
    """Raises TypeError or ValueError if `component` is not one of the values, or if they are colours and it is not given. `remedy`: how to draw colours."""
    if component is None:
        if are_colours(values):
            raise ValueError(f"scalars: the array {name!r} holds colours ({'RGB' if values.shape[1] == 3 else 'RGBA'}, uint8), but numbers and a colour map (cmap) are drawn. Name another array, or pass "
                             f"component=0 for the red, 1 for the green or 2 for the blue. {remedy}")
        return
    try:
        index = operator.index(component)
    except TypeError:
        raise TypeError(f"component is {component!r}; it must be the number of a component, from 0, or None for the magnitude.") from None
    if values.ndim == 2 and not 0 <= index < values.shape[1]:
        raise ValueError(f"component is {index}; the array {name!r} has the components 0 to {values.shape[1] - 1}. None is the magnitude.")


def choose_component(function: Any, vectors: bool, component: int | None) -> None:
    """Makes the colour function read the component or the magnitude of vectors, of which the mapper also takes the opacities."""
    if not vectors:
        return
    if component is None:
        function.SetVectorModeToMagnitude()
    else:
        function.SetVectorModeToComponent()
        function.SetVectorComponent(operator.index(component))
