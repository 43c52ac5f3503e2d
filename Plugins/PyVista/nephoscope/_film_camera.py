# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The camera of a film: it sees all steps of meshes that move, unless the user has set a camera."""
from __future__ import annotations

import weakref
from itertools import product
from typing import Any, Iterator

import numpy as np
import pyvista

from ._over_time import follows

_framed: weakref.WeakKeyDictionary[Any, tuple] = weakref.WeakKeyDictionary()  # renderer: the camera that was set here, and what it sees


def look_at_all_steps(plotter: pyvista.BasePlotter, bounds: Any, growth: float = 1.0) -> None:
    """Sets the camera so that everything in the active renderer is seen, and the meshes of the series, whose `bounds` these are. A camera of the user stays.
    `growth`: of the largest mesh, over that on display."""
    renderer = plotter.renderer
    before, others = _framed.get(renderer, (None, None))
    if renderer.camera.is_set and before != _place(renderer):
        return
    seen = list(_boxes(renderer, np.array(bounds), growth)) + ([others] if before else [])
    if not seen:
        return
    low, high = np.min([box[::2] for box in seen], axis=0), np.max([box[1::2] for box in seen], axis=0)
    together = np.column_stack([low, high]).ravel()
    if not before:
        plotter.camera_position = renderer.get_default_cam_pos()
    renderer.ResetCamera(tuple(float(value) for value in together))
    renderer.camera.is_set = True
    _framed[renderer] = (_place(renderer), together)


def is_framed(plotter: pyvista.BasePlotter) -> bool:
    """Whether `look_at_all_steps` has set the camera of the active renderer."""
    return plotter.renderer in _framed


def _place(renderer: Any) -> tuple:
    return (*renderer.camera.position, *renderer.camera.focal_point, *renderer.camera.up)


def _boxes(renderer: Any, bounds: np.ndarray, growth: float) -> Iterator[np.ndarray]:
    """Bounds of the actors that are visible now and, of those that draw the mesh of a series, the bounds with all steps."""
    for actor in renderer.actors.values():
        box = actor.GetBounds() if actor.GetVisibility() and actor.GetUseBounds() else None
        if box is not None and box[0] <= box[1]:
            yield np.array(box)
    yield bounds
    for actor in renderer.actors.values():
        mapper = getattr(actor, "mapper", None)
        mesh = getattr(mapper, "dataset", None)
        if isinstance(mesh, pyvista.DataSet) and mesh.n_points and follows(mesh):
            yield _moved(bounds, growth * (np.array(mapper.GetBounds()) - mesh.bounds), pyvista.array_from_vtkmatrix(actor.GetMatrix()))


def _moved(bounds: np.ndarray, margins: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """The bounds, with the margins by which what is drawn is larger than the mesh, as the matrix of the actor places them."""
    signs = np.tile([-1.0, 1.0], 3)
    wider = bounds + signs * np.maximum(signs * margins, 0.0)
    corners = np.array([[*corner, 1.0] for corner in product(*wider.reshape(3, 2))]) @ matrix.T
    return np.column_stack([corners[:, :3].min(axis=0), corners[:, :3].max(axis=0)]).ravel()
