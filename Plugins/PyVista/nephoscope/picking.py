# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clicks that pick what is visible in volumes of cells."""
from __future__ import annotations

import math
import os
import textwrap
import warnings
from typing import Any, Callable, NamedTuple
from weakref import WeakKeyDictionary

import pyvista

from . import vtkCellCompositingMapper
from ._medium import require_plotter, text_colour
from ._pipeline import level_of_caller

NOTHING_TO_PICK = ("There is nothing to pick in this view: a click picks in the visible volumes of add_cells that have pickable=True. To pick in splats, draw their data by add_cells. "
                   "To pick on surfaces, call plotter.enable_point_picking().")

_observers: WeakKeyDictionary = WeakKeyDictionary()  # of a plotter: the numbers of its observers, by side


class Picked(NamedTuple):
    """What is visible at a pixel."""

    position: tuple[float, float, float]  # world coordinates
    cell: int
    point: int  # of the cell, nearest to the position
    scalar: float  # of the coloured array, at the position
    actor: Any  # the volume; its mesh is actor.mapper.dataset


def enable_picking(plotter: pyvista.Plotter, callback: Callable[[Picked], Any] | None = None, *, side: str = "left") -> None:
    """Pick with a click what is visible in the volumes of `add_cells`: the medium, or a contour surface. Splats and surfaces are not picked.

    The position is where the accumulated opacity along the ray reaches that of ``mapper.SetPickOpacity``, 0.1 by default. If several volumes are
    visible, the nearest position counts. Behind an opaque surface nothing is picked, nor are volumes with ``pickable=False``. Dragging still turns the view.
    A second call for the same button replaces the first; `disable_picking` ends both.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; clicks in all its renderers pick.
    callback : callable, optional
        Called with the result: `position` (world coordinates), `cell` and `point` (numbers in ``actor.mapper.dataset``), `scalar` (of the coloured
        array, at the position) and `actor` (the volume). Default: the window shows these values until the next click.
    side : {"left", "right"}, default: "left"
        The button of the mouse.

    Raises
    ------
    TypeError
        If `plotter` is not a plotter, or `callback` not a function.
    ValueError
        If `side` is neither of the two.

    Warns
    -----
    UserWarning
        At the first click into a view without volumes of `add_cells`, for example one with splats only. By default the window shows these words.

    Examples
    --------
    >>> nephoscope.enable_picking(plotter, lambda picked: print(picked.cell, picked.scalar))  # doctest: +SKIP
    """
    require_plotter(plotter)
    if callback is not None and not callable(callback):
        raise TypeError(f"callback is a {type(callback).__name__}; it must be a function that takes what is picked.")
    events = {"left": "LeftButtonPressEvent", "right": "RightButtonPressEvent"}
    if side not in events:
        raise ValueError(f"side is {side!r}; it must be 'left' or 'right'.")

    def write(text: str) -> None:
        plotter.add_text(text, font_size=10, color=text_colour(plotter), name="picked")

    def show(picked: Picked) -> None:
        place = ", ".join(f"{x:.5g}" for x in picked.position)
        write(f"{picked.scalar:.5g} at ({place}), cell {picked.cell}")

    told: list[str] = []

    def tell_of_nothing() -> None:
        if callback is None:
            write("\n".join(textwrap.wrap(NOTHING_TO_PICK, 60)))
        if not told:
            told.append(NOTHING_TO_PICK)
            warnings.warn(NOTHING_TO_PICK, UserWarning, stacklevel=level_of_caller(os.path.dirname(pyvista.__file__)))

    def pick(*_: Any) -> None:
        pixel = plotter.iren.interactor.GetEventPosition()
        renderer = plotter.iren.interactor.FindPokedRenderer(*pixel)
        eye = renderer.GetActiveCamera().GetPosition()
        volumes = [volume for volume in renderer.GetVolumes() if _can_be_picked(volume)]  # a list, because Pick makes the collection anew
        if not volumes:
            tell_of_nothing()
        found = [_picked(volume, renderer, pixel) for volume in volumes]
        seen = sorted((picked for picked in found if picked), key=lambda picked: math.dist(picked.position, eye))
        if seen:
            (callback or show)(seen[0])
        elif volumes and callback is None:
            plotter.remove_actor("picked")  # the text of an earlier click

    observers = _observers.setdefault(plotter, {})
    if side in observers:
        plotter.iren.remove_observer(observers.pop(side))
    observers[side] = plotter.iren.add_observer(events[side], pick)


def disable_picking(plotter: pyvista.Plotter) -> None:
    """End what `enable_picking` began, for both buttons. ``plotter.disable_picking()`` ends PyVista's own picking only.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter. Nothing happens if its picking is not enabled.

    Raises
    ------
    TypeError
        If `plotter` is not a plotter.

    Examples
    --------
    >>> nephoscope.disable_picking(plotter)  # doctest: +SKIP
    """
    require_plotter(plotter)
    for observer in _observers.pop(plotter, {}).values():
        if getattr(plotter, "iren", None) is not None:  # a closed plotter has none
            plotter.iren.remove_observer(observer)


def _can_be_picked(volume: Any) -> bool:
    return bool(isinstance(volume.GetMapper(), vtkCellCompositingMapper) and volume.GetVisibility() and volume.GetPickable())


def _picked(volume: Any, renderer: Any, pixel: tuple[int, int]) -> Picked | None:
    mapper = volume.GetMapper()
    if not mapper.Pick(renderer, *pixel):
        return None
    return Picked(mapper.GetPickPosition(), mapper.GetPickedCell(), mapper.GetPickedPoint(), mapper.GetPickedScalar(), volume)
