# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A file in the browser: the function `viewer`."""
from __future__ import annotations

import sys
from pathlib import Path

from .__main__ import main
from .serving import make_server, run
from .viewer_scene import Scene
from .viewer_state import PORT, View, checked, from_mapping


def viewer(path: str | Path, *, field: str | None = None, technique: str | None = None, time: int | None = None,
           exaggeration: float | None = None, opacity: float | None = None, preset: str | None = None, terrain: bool | None = None,
           port: int = PORT, host: str = "127.0.0.1", open_browser: bool = True) -> None:
    """Show a file in the browser until Ctrl-C, with a side bar for choosing what is drawn, and a link that reproduces the picture.

    Parameters
    ----------
    path : str or pathlib.Path
        NetCDF with CF conventions, drawn on a globe if it has longitudes and latitudes; or any file that PyVista reads, drawn unchanged.
    field : str, optional
        Array to draw. Default: the active one, as chosen by `read_cf`.
    technique : {"cells", "splats", "surface", "winds", "smoke", "mesh"}, optional
        How it is drawn. Default: the first that the data allow.
    time : int, optional
        Time step, from 0. Default: 0.
    exaggeration : float, optional
        Vertical exaggeration on a globe, 1 to 100. Default: 10.
    opacity : float, optional
        Factor that multiplies the opacity of the medium, 0.1 to 5. Default: 1.
    preset : str, optional
        Colours and opacities of a preset of `add_cells`. Default: chosen by the field.
    terrain : bool, optional
        Draw the ground with its mountains, if the file has terrain heights; otherwise a smooth globe. Default: True.
    port, host, open_browser
        As in `serve`.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ModuleNotFoundError
        If trame is not installed; the message has the command that installs it.
    ValueError
        If the file cannot be drawn, or the data do not allow an argument.
    RuntimeError
        If an event loop is already running, as in a notebook.
    """
    server = make_server("nephoscope-viewer")
    scene = Scene(path)
    view, problems = from_mapping({"field": field, "technique": technique, "time": time, "exaggeration": exaggeration, "opacity": opacity,
                                   "preset": preset, "terrain": terrain}, View())
    view, more = checked(view, scene.choices)
    if problems or more:
        raise ValueError(" ".join(problems + more))
    from .viewer_page import Page
    Page(server, scene, view, [])
    run(server, port, host, open_browser)


if __name__ == "__main__":
    sys.exit(main())
