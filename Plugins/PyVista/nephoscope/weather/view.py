# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plotter of a picture of weather data: its theme, its size, the camera that the user wants, and what it shows at the end."""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np
import pyvista

from .._medium import readable


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


def picture_plotter(off_screen: bool, window_size: Sequence[int], background: Any) -> PicturePlotter:
    """An empty plotter for a picture; see `picture_theme`."""
    return PicturePlotter(off_screen=off_screen, theme=picture_theme(background), window_size=window_size)


def size_of(plotter: pyvista.BasePlotter) -> tuple[float, float]:
    """Width and height of the active sub-plot in pixels."""
    left, bottom, right, top = plotter.renderer.GetViewport()
    return plotter.window_size[0] * (right - left), plotter.window_size[1] * (top - bottom)


def finish(plotter: pyvista.Plotter, screenshot: str | None, shown: bool) -> pyvista.Plotter:
    """Shows the picture, unless the plotter is that of the user, and writes it into the file."""
    if shown:
        plotter.show(screenshot=screenshot or False, auto_close=False)
    elif screenshot:
        plotter.screenshot(screenshot)
    return plotter


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
