# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the viewer: its side bar, the link that follows it, and drawing after changes."""
from __future__ import annotations

import asyncio
import sys
from dataclasses import asdict, replace
from typing import Any

import pyvista

from .serving import add_view
from .viewer_scene import Scene, camera_of, draw
from .viewer_sources import one_sentence
from .viewer_state import LIMITS, TECHNIQUES, View, checked, from_mapping, from_query, to_query

CHOSEN = ("field", "technique", "time", "exaggeration", "opacity", "preset", "terrain")  # by the widgets
PATIENCE = 0.3  # seconds during which changes are collected, because a slider sends many
HEIGHT = "height: 100%; width: 100%"
COPY = "utils.get('navigator').clipboard.writeText(utils.get('location').href); copied = true"
FOLLOW = "utils.get('history').replaceState(null, '', $event)"


class Page:
    """The state of trame, `server.state`, has the items of a View under their names. A change is drawn, and updates the address in the browser."""

    def __init__(self, server: Any, scene: Scene, view: View, problems: list[str]) -> None:
        self.scene, self.state, self.view = scene, server.state, view
        self.plotter = pyvista.Plotter(off_screen=True, theme=pyvista.themes.DarkTheme())
        self.waiting: asyncio.TimerHandle | None = None
        self.turning: asyncio.TimerHandle | None = None
        self.address: Any = None  # of the browsers
        self._publish(problems)
        self.state.trame__title = f"{scene.path.name} - Nephoscope"
        self.state.change(*CHOSEN)(self._on_choice)
        server.trigger("nephoscope_open")(self._on_open)
        self._draw(problems)
        self.plotter.suppress_rendering = True  # from now on the view in the page renders
        self._lay_out(server)
        server.controller.on_server_ready.add(lambda **_: self.plotter.camera.AddObserver("ModifiedEvent", self._on_camera))

    def _publish(self, problems: list[str]) -> None:
        choices = self.scene.choices
        self.state.update({**{name: value for name, value in asdict(self.view).items() if name in CHOSEN}, "problems": problems,
                           "copied": False, "time_told": (*choices.times, "")[self.view.time]})
        if self.address is not None:
            self.address.exec(to_query(self.view, choices))

    def _on_choice(self, **_: Any) -> None:
        """Handles a choice in the side bar: draws once no more changes arrive."""
        chosen, problems = from_mapping({name: self.state[name] for name in CHOSEN}, self.view)
        chosen, more = checked(replace(chosen, camera=camera_after(self.view, chosen)), self.scene.choices)
        if chosen != self.view:
            self.view = chosen
            self._publish(problems + more)
            if self.waiting is not None:
                self.waiting.cancel()
            self.waiting = asyncio.get_running_loop().call_later(PATIENCE, self._draw, problems + more)

    def _on_open(self, query: str) -> None:
        """Handles a link that a browser has opened; everyone connected to this server sees the picture."""
        opened, problems = from_query(query, self.view)
        opened, more = checked(opened, self.scene.choices)
        changed, self.view = opened != self.view, opened
        self._publish(problems + more or self.state.problems)
        if changed or problems or more:
            self._draw(problems + more)

    def _on_camera(self, *_: Any) -> None:
        """Handles a change of the camera, by the mouse or by drawing; this occurs many times."""
        if self.turning is None:
            self.turning = asyncio.get_running_loop().call_later(PATIENCE, self._on_turned)

    def _on_turned(self) -> None:
        self.turning, camera = None, camera_of(self.plotter)
        if camera != self.drawn:
            self.view, self.drawn = replace(self.view, camera=camera), camera
            with self.state:
                self._publish(self.state.problems)

    def _on_reset(self) -> None:
        self.view = replace(self.view, camera=())
        self._draw([])

    def _draw(self, problems: list[str]) -> None:
        try:
            problems = problems + draw(self.plotter, self.scene, self.view)
        except (ValueError, TypeError, RuntimeError, KeyError, MemoryError) as error:
            problems = [*problems, f"{TECHNIQUES[self.view.technique]} of {self.view.field!r} cannot be drawn: {one_sentence(error)}"]
        for problem in problems:
            print(f"Nephoscope: {problem}", file=sys.stderr, flush=True)
        self.drawn = camera_of(self.plotter)
        with self.state:
            self._publish(problems)

    def _lay_out(self, server: Any) -> None:
        from trame.ui.vuetify3 import VAppLayout
        from trame.widgets import client, vuetify3 as v
        with VAppLayout(server, full_height=True, theme="dark"):
            client.ClientTriggers(mounted="trigger('nephoscope_open', [utils.get('location').search])")
            self.address = client.JSEval(exec=FOLLOW)
            with v.VNavigationDrawer(permanent=True, width=300):
                v.VProgressLinear(indeterminate=True, active=("trame__busy",), absolute=True)
                with v.VContainer(classes="d-flex flex-column", style="gap: 12px"):
                    v.VCardTitle(self.scene.path.name, classes="pa-0 text-subtitle-1", title=str(self.scene.path))
                    self._add_choices(v)
                    self._add_buttons(v)
                    v.VAlert("{{ problem }}", v_for="problem in problems", key="problem", type="warning", density="compact", classes="text-body-2")
            with v.VMain(), v.VContainer(fluid=True, classes="pa-0 fill-height"):
                add_view(self.plotter, style=HEIGHT)

    def _add_choices(self, v: Any) -> None:
        choices, plain = self.scene.choices, {"density": "compact", "hide_details": True}
        if choices.fields:
            v.VSelect(v_model=("field",), items=("fields", list(choices.fields)), label="Field", **plain)
        techniques = [{"title": TECHNIQUES[name], "value": name} for name in choices.techniques]
        v.VSelect(v_model=("technique",), items=("techniques", techniques), label="Technique", **plain)
        presets = [{"title": "By the field", "value": ""}, *({"title": name, "value": name} for name in choices.presets)]
        v.VSelect(v_model=("preset",), items=("presets", presets), label="Colours and opacity", disabled=("['surface', 'mesh'].includes(technique)",),
                  **plain)
        if len(choices.times) > 1:
            _slider(v, "time", "Time {{ time_told }}", 0, len(choices.times) - 1, 1)
        if choices.globe:
            _slider(v, "exaggeration", "Heights × {{ exaggeration }}", *LIMITS["exaggeration"], 1)
        _slider(v, "opacity", "Opacity × {{ opacity }}", *LIMITS["opacity"], 0.1)
        if choices.terrain:
            v.VSwitch(v_model=("terrain",), label="Terrain", color="primary", **plain)

    def _add_buttons(self, v: Any) -> None:
        v.VBtn("Reset camera", prepend_icon="mdi-crop-free", click=self._on_reset, size="small")
        v.VBtn("{{ copied ? 'Copied' : 'Copy link' }}", prepend_icon="mdi-link", click=COPY, size="small",
               v_if="utils.get('navigator').clipboard")  # browsers provide it for this machine and with https


def camera_after(old: View, new: View) -> tuple[float, ...]:
    """The camera stays, except for smoke, which lies on one side of the globe."""
    return () if new.technique == "smoke" != old.technique else old.camera


def _slider(v: Any, name: str, told: str, least: float, most: float, step: float) -> None:
    from trame.widgets import html
    with html.Div():
        html.Div(told, classes="text-caption")
        v.VSlider(v_model=(name,), min=least, max=most, step=step, hide_details=True, density="compact")
