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
SENDING = 0.7  # seconds until a picture has been compressed and sent: trame looks for it after half a second
HEIGHT = "height: 100%; width: 100%"
COPY = "utils.get('navigator').clipboard.writeText(utils.get('location').href); copied = true"
DRAWING = "Drawing ..."  # behind the first picture, and in front of the last one while the next is drawn
MIDDLE = "position: absolute; inset: 0; display: flex; align-items: center; justify-content: center; pointer-events: none"
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
        self.state.drawing = False
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
        chosen, more = checked(chosen, self.scene.choices)
        if chosen != self.view:
            camera = () if self.waiting is not None and not self.view.camera else camera_of(self.plotter)  # it is going to be the usual one
            self.view = replace(chosen, camera=camera_after(self.view, chosen, camera, self.scene.choices.globe))
            self._publish(problems + more)
            self._draw_soon(problems + more)

    def _draw_soon(self, problems: list[str]) -> None:
        """Tells it first: nothing is sent to the browsers while a picture is drawn."""
        self.state.drawing = True
        if self.waiting is not None:
            self.waiting.cancel()
        self.waiting = asyncio.get_running_loop().call_later(PATIENCE, self._on_chosen, problems)

    def _on_chosen(self, problems: list[str]) -> None:
        self.waiting = None
        if self.view.camera == self.drawn and self.view.exaggeration != self.shown.exaggeration:  # and no link has another camera
            change = self.scene.grid(self.view).length / self.scene.grid(self.shown).length
            self.view = replace(self.view, camera=moved_away(self.view.camera, change))
        self._draw(problems)
        asyncio.get_running_loop().call_later(SENDING, self._on_sent)

    def _on_sent(self) -> None:
        if self.waiting is None:
            with self.state:
                self.state.drawing = False

    def _on_open(self, query: str) -> None:
        """Handles a link that a browser has opened; everyone connected to this server sees the picture."""
        opened, problems = from_query(query, self.view)
        opened, more = checked(opened, self.scene.choices)
        changed, self.view = opened != self.view, opened
        self._publish(problems + more or self.state.problems)
        if changed or problems or more:
            self._draw_soon(problems + more)

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
        self._draw_soon([])

    def _draw(self, problems: list[str]) -> None:
        try:
            problems = problems + draw(self.plotter, self.scene, self.view)
        except (ValueError, TypeError, RuntimeError, KeyError, MemoryError) as error:
            problems = [*problems, f"{TECHNIQUES[self.view.technique]} of {self.view.field!r} cannot be drawn: {one_sentence(error)}"]
        for problem in problems:
            print(f"Nephoscope: {problem}", file=sys.stderr, flush=True)
        self.drawn, self.shown = camera_of(self.plotter), self.view
        with self.state:
            self._publish(problems)

    def _lay_out(self, server: Any) -> None:
        from trame.ui.vuetify3 import VAppLayout
        from trame.widgets import client, html, vuetify3 as v
        with VAppLayout(server, full_height=True, theme="dark"):
            client.ClientTriggers(mounted="trigger('nephoscope_open', [utils.get('location').search])")
            self.address = client.JSEval(exec=FOLLOW)
            with v.VNavigationDrawer(permanent=True, width=300):
                v.VProgressLinear(indeterminate=True, active=("drawing || trame__busy",), absolute=True)
                with v.VContainer(classes="d-flex flex-column", style="gap: 12px"):
                    v.VCardTitle(self.scene.path.name, classes="pa-0 text-subtitle-1", title=str(self.scene.path))
                    self._add_choices(v)
                    self._add_buttons(v)
                    v.VAlert("{{ problem }}", v_for="problem in problems", key="problem", type="warning", density="compact", classes="text-body-2")
            with v.VMain(), v.VContainer(fluid=True, classes="pa-0 fill-height", style="position: relative"):
                html.Div(DRAWING, style=MIDDLE)
                add_view(self.plotter, style=HEIGHT)
                with html.Div(v_show="drawing", style=f"{MIDDLE}; z-index: 2"):
                    v.VChip(DRAWING, classes="drawing", variant="elevated")

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


def camera_after(old: View, new: View, camera: tuple[float, ...], globe: bool) -> tuple[float, ...]:
    """The camera stays, except for smoke, which lies on one side of the globe."""
    return () if globe and new.technique == "smoke" != old.technique else camera


def moved_away(camera: tuple[float, ...], factor: float) -> tuple[float, ...]:
    """The camera in its direction from the focal point, at `factor` times the distance."""
    position, focus, upward = (camera[i:i + 3] for i in (0, 3, 6))
    return (*(f + factor * (p - f) for p, f in zip(position, focus)), *focus, *upward)


def _slider(v: Any, name: str, told: str, least: float, most: float, step: float) -> None:
    from trame.widgets import html
    with html.Div():
        html.Div(told, classes="text-caption")
        v.VSlider(v_model=(name,), min=least, max=most, step=step, hide_details=True, density="compact")
