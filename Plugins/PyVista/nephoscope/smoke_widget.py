# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke from a polygon that is dragged: the polygon turns across the flow, and the smoke follows."""
from __future__ import annotations

import time
import warnings
from typing import Any

import pyvista

from ._drag_pace import DragPace
from ._checks import listed
from ._medium import require_plotter
from ._typing import Numbers
from .smoke import _NAMES, _filter, _vector, flow_volume
from .smoke_drawing import add_smoke
from ._pipeline import vtk_messages


def add_smoke_widget(plotter: pyvista.Plotter, mesh: pyvista.DataSet | pyvista.MultiBlock, *, color: Any = None,
                     polygon_color: Any = "orange", while_dragging: bool = True, **options: Any) -> SmokeWidget:
    """Add smoke whose generating polygon you drag by a ball in the window. The polygon turns to face the flow, and the smoke follows.

    If the ball is outside the data, or there is no flow, only the ball is drawn.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter; its active renderer gets smoke, polygon and ball.
    mesh : pyvista.DataSet or pyvista.MultiBlock
        Any mesh with a velocity, as for `flow_volume`.
    color : ColorLike, optional
        Colour of the smoke, see `add_smoke`.
    polygon_color : ColorLike, default: "orange"
        Colour of the polygon and of the ball.
    while_dragging : bool, default: True
        True: updates the smoke while you drag, with as many tetrahedra, from 2,000 to ``max_tetrahedra``, as allow ten updates a second. In a scene
        that is slower for other reasons, with as many as take a quarter of the rest of an update. The smoke is complete again when you release the ball. False: shows only the polygon while you drag, and updates the smoke when you release the ball.
    **options
        Arguments of `flow_volume` for a steady flow (`center`, `radius`, `duration`, ...), and of `add_smoke` (`optical_depth`, ...).

    Returns
    -------
    SmokeWidget
        With the attributes `volume`, the smoke as returned by `add_smoke`, whose ``mapper.dataset`` is the current flow volume; `polygon`, the
        actor of the polygon; and `ball`, VTK's widget.

    Raises
    ------
    TypeError, ValueError, RuntimeError
        As `flow_volume` and `add_smoke` do.

    Examples
    --------
    >>> nephoscope.add_smoke_widget(plotter, wind, radius=2e5, color="white")  # doctest: +SKIP
    """
    require_plotter(plotter)
    known = set(flow_volume.__kwdefaults__)
    flow = {name: options.pop(name) for name in list(options) if name in known}
    unsteady = [name for name in ("times", "time", "start_time", "time_scale") if flow.get(name) is not None]
    one = "pass one of the meshes, such as series[0]" if isinstance(mesh, (list, tuple)) else "pass its result for one time" if callable(mesh) else ""
    if unsteady:
        raise ValueError(f"{unsteady[0]}: the widget needs one mesh, of a steady flow. Leave {listed(unsteady)} out{one and ', and '}{one}. "
                         "For smoke of an unsteady flow call flow_volume with times, and add_smoke.")
    if one:
        raise TypeError(f"mesh is a {type(mesh).__name__}; the widget needs one mesh, of a steady flow: {one}.")
    dragged = SmokeWidget(plotter, mesh, flow, {"color": color, **options}, polygon_color)
    dragged.ball = plotter.add_sphere_widget(dragged.drag if while_dragging else dragged.move_polygon, center=dragged.filter.GetCenter(),
                                             radius=0.25 * dragged.radius, color=polygon_color, test_callback=False, interaction_event="always")
    dragged.ball.AddObserver("EndInteractionEvent", lambda widget, _: dragged.move(widget.GetCenter()))
    return dragged


class SmokeWidget:
    """Ball, polygon and smoke; `move` moves polygon and smoke to another position, `drag` does so with a coarser volume where that saves time."""

    ball: Any = None

    def __init__(self, plotter: pyvista.Plotter, mesh: Any, flow: dict[str, Any], drawing: dict[str, Any], polygon_color: Any) -> None:
        self.filter = _filter(mesh, **{**flow_volume.__kwdefaults__, **flow})[0]
        with vtk_messages(self.filter, _NAMES):
            self.filter.Update()
        self.mesh, self.plotter = mesh, plotter
        self._full = self.filter.GetMaximumNumberOfTetrahedra()
        self._pace, self._update_seconds, self._start = DragPace(self._full), 0.0, 0.0
        plotter.render_window.AddObserver("StartEvent", self._before_picture)
        plotter.render_window.AddObserver("EndEvent", self._after_picture)
        self.radius = self.filter.GetRadius() or pyvista.wrap(mesh).length / 50
        self.volume = add_smoke(plotter, pyvista.wrap(self.filter.GetOutput()).copy(deep=False), **drawing)
        self.outline = self._across(self.filter.GetNormalUsed())
        self.polygon = plotter.add_mesh(self.outline, color=polygon_color, style="wireframe", line_width=3, lighting=False, pickable=False,
                                     reset_camera=False)

    def drag(self, center: Numbers) -> None:
        start = time.perf_counter()
        self._move(center, self._pace.number)
        self._update_seconds = time.perf_counter() - start

    def _before_picture(self, *_: Any) -> None:
        self._start = time.perf_counter()

    def _after_picture(self, window: Any, _: str) -> None:
        """The first picture after an update of a drag tells its pace."""
        if self._update_seconds > 0:
            window.WaitForCompletion()
            self._pace.note(self.filter.GetOutput().GetNumberOfCells(), self._update_seconds + time.perf_counter() - self._start)
            self._update_seconds = 0.0

    def move(self, center: Numbers) -> None:
        self._move(center, self._full)
        if self.ball is not None:
            self.ball.SetCenter(center)

    def _move(self, center: Numbers, tetrahedra: int) -> None:
        self.filter.SetMaximumNumberOfTetrahedra(tetrahedra)
        self.filter.SetCenter(_vector(center, "center"))
        found = self._update()
        if found:
            self.volume.mapper.SetInputDataObject(pyvista.wrap(self.filter.GetOutput()).copy(deep=False))
        self._show(found)
        self.volume.SetVisibility(found)

    def move_polygon(self, center: Numbers) -> None:
        """Moves the polygon only; a volume with one short step gives its orientation."""
        duration, step = self.filter.GetDuration(), self.filter.GetTimeStep()
        self.filter.SetCenter(*center)
        self.filter.SetDuration(1e-3 * self.filter.GetDurationUsed())
        self.filter.SetTimeStep(self.filter.GetDuration())
        self._show(self._update())
        self.filter.SetDuration(duration)
        self.filter.SetTimeStep(step)

    def _update(self) -> bool:
        """False if there is no smoke; a polygon partly outside the data gives the smoke of its inner part."""
        try:
            with warnings.catch_warnings(), vtk_messages(self.filter, _NAMES):
                warnings.simplefilter("ignore")
                self.filter.Update()
        except (RuntimeError, ValueError):
            return False
        return self.filter.GetOutput().GetNumberOfCells() > 0

    def _show(self, found: bool) -> None:
        if found:
            self.outline.copy_from(self._across(self.filter.GetNormalUsed()))
        self.polygon.SetVisibility(found)

    def _across(self, normal: Numbers) -> pyvista.PolyData:
        return pyvista.Polygon(center=self.filter.GetCenter(), radius=self.radius, normal=normal, n_sides=self.filter.GetNumberOfSides())
