# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A file in the browser: the function `viewer`, and the command `nephoscope-viewer`."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any, Sequence

from .serving import PORT, make_server, run
from .viewer_scene import Scene
from .viewer_state import TECHNIQUES, View, checked, from_mapping


def viewer(path: str | Path, *, field: str | None = None, technique: str | None = None, time: int | None = None,
           exaggeration: float | None = None, opacity: float | None = None, preset: str | None = None, terrain: bool | None = None,
           port: int = PORT, host: str = "127.0.0.1", open_browser: bool = True) -> None:
    """Show a file in the browser until Ctrl-C, with a side bar to choose what is drawn, and a link that shows the same again.

    Parameters
    ----------
    path : str or pathlib.Path
        NetCDF with CF conventions, drawn on a globe where it has longitudes and latitudes; or any file that PyVista reads, drawn as it is.
    field : str, optional
        Array to draw. Default: the active one, as `read_cf` chooses it.
    technique : {"cells", "splats", "surface", "winds", "smoke", "mesh"}, optional
        How it is drawn. Default: the first that the data allow.
    time : int, optional
        Time step, from 0. Default: 0.
    exaggeration : float, optional
        Vertical exaggeration on a globe, 1 to 100. Default: 30.
    opacity : float, optional
        Factor on the opacity of the medium, 0.1 to 5. Default: 1.
    preset : str, optional
        Colours and opacities of a preset of `add_cells`. Default: by the field.
    terrain : bool, optional
        The ground with its mountains, where the file has their heights; else a smooth globe. Default: True.
    port, host, open_browser
        As in `serve`.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ModuleNotFoundError
        If trame is not installed; the message has the line that installs it.
    ValueError
        If the file cannot be drawn, or an argument is not what the data allow.
    RuntimeError
        If an event loop is running already, as in a notebook.
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


def main(arguments: Sequence[str] | None = None) -> int:
    """The command; its exit status."""
    given = vars(_parser().parse_args(arguments))
    try:
        viewer(given.pop("file"), **given)
    except (ImportError, OSError, TypeError, ValueError, RuntimeError) as error:
        print(f"nephoscope-viewer: {error}", file=sys.stderr)
        return 1
    return 0


def _parser() -> Any:
    parser = argparse.ArgumentParser(prog="nephoscope-viewer", description="Shows a file in the browser, with a side bar to choose what is drawn.")
    parser.add_argument("file", help="NetCDF with CF conventions, or any file that PyVista reads")
    parser.add_argument("--field", help="array to draw")
    parser.add_argument("--technique", choices=list(TECHNIQUES), help="default: the first that the data allow")
    parser.add_argument("--time", metavar="STEP", help="time step, from 0 (default: 0)")
    parser.add_argument("--exaggeration", metavar="FACTOR", help="of heights on a globe, 1 to 100 (default: 30)")
    parser.add_argument("--opacity", metavar="FACTOR", help="0.1 to 5 (default: 1)")
    parser.add_argument("--preset", help="colours and opacities, 'wind speed' for example (default: by the field)")
    parser.add_argument("--no-terrain", dest="terrain", action="store_const", const="0", help="a smooth globe")
    parser.add_argument("--port", type=int, default=PORT, help=f"of the web server, 0: any that is free (default: {PORT})")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen at (default: 127.0.0.1, this machine alone)")
    parser.add_argument("--no-browser", dest="open_browser", action="store_false", help="do not open the page in a browser")
    return parser


if __name__ == "__main__":
    sys.exit(main())
