# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame of a picture of weather data: its plotter, theme, size and file, and the camera that the user wants."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import pyvista

from .._medium import readable, require_plotter


class PicturePlotter(pyvista.Plotter):
    """A plotter whose screenshots show the camera as it is: PyVista's show what was drawn last."""
    _pictured: tuple | None = None

    def screenshot(self, *args: Any, **options: Any) -> Any:
        window = self.render_window
        if self._pictured not in (None, self._cameras()) and window is not None:
            self.render()
        found = super().screenshot(*args, **options)
        self._pictured = self._cameras()
        return found

    def _repr_png_(self) -> bytes | None:
        """None in a notebook, where `show` has displayed the picture."""
        inherited = getattr(super(), "_repr_png_", None)  # not in every PyVista
        return None if self.notebook or inherited is None else inherited()

    def _cameras(self) -> tuple:
        return tuple((*one.camera.GetPosition(), *one.camera.GetFocalPoint(), *one.camera.GetViewUp(), one.camera.GetViewAngle(), one.camera.GetParallelScale()) for one in self.renderers)


def picture_theme(background: Any = None) -> pyvista.themes.Theme:
    """PyVista's dark theme or, if the user has chosen a theme whose background is not that of the default theme, the user's; with another `background`, text is readable on it."""
    theme = pyvista.themes.DarkTheme()
    if pyvista.global_theme.background != pyvista.themes.DocumentTheme().background:
        theme.load_theme(pyvista.global_theme)
    if background is not None:
        theme.background = background
        theme.font.color = readable(theme.font.color, theme.background)
    return theme


def size_of(plotter: pyvista.BasePlotter) -> tuple[float, float]:
    """Width and height of the active sub-plot in pixels."""
    left, bottom, right, top = plotter.renderer.GetViewport()
    return plotter.window_size[0] * (right - left), plotter.window_size[1] * (top - bottom)


def is_place(view: Any) -> bool:
    """Whether `view` is a longitude and a latitude, and not a camera position of PyVista."""
    return not isinstance(view, str) and hasattr(view, "__len__") and len(view) == 2 and all(np.ndim(value) == 0 for value in view)


def set_view(plotter: pyvista.BasePlotter, view: Any) -> None:
    """A camera position of PyVista."""
    if is_place(view):
        raise ValueError(f"view is {view!r}, a longitude and latitude, which are for a globe. Here it must be a camera position of PyVista, such as 'xy' or [position, focal point, upward direction].")
    try:
        plotter.camera_position = view
    except (TypeError, ValueError, AttributeError) as error:
        raise ValueError(f"view is {view!r}; it must be a longitude and latitude, for a globe, or a camera position of PyVista, such as 'xy' or [position, focal point, upward direction].") from error
    plotter.reset_camera_clipping_range()


@dataclass(frozen=True)
class Frame:
    """Where a picture goes, as the options of `plot` say: into a window, into a file, or into the active sub-plot of the user's plotter.

    Raises
    ------
    TypeError
        If `plotter` is not a plotter, or if it is given together with an option of a new picture.
    """
    screenshot: str | None = None
    window_size: Sequence[int] | None = None
    view: Any = None
    background: Any = None
    plotter: pyvista.Plotter | None = None

    def __post_init__(self) -> None:
        if self.plotter is None:
            return
        require_plotter(self.plotter)
        if self.window_size is not None or self.background is not None:
            option = "background" if self.window_size is None else "window_size"
            raise TypeError(f"{option}: an option of a new picture, but plotter is given. Set it there: plotter.background_color or plotter.window_size.")

    @property
    def is_free(self) -> bool:
        """Whether the window may take the shape of what it shows."""
        return self.plotter is None and self.window_size is None

    def begin(self) -> pyvista.Plotter:
        """The user's plotter, or an empty one; see `picture_theme`."""
        if self.plotter is not None:
            return self.plotter
        return PicturePlotter(off_screen=True if self.screenshot is not None else None, theme=picture_theme(self.background), window_size=self.window_size or (800, 800))

    def finish(self, plotter: pyvista.Plotter) -> pyvista.Plotter:
        """Shows the picture, unless the plotter is the user's, and writes it into the file."""
        if self.plotter is None:
            plotter.show(screenshot=self.screenshot or False, auto_close=False)
        elif self.screenshot:
            plotter.screenshot(self.screenshot)
        return plotter
