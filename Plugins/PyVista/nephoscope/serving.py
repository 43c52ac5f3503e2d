# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plotters in a browser, drawn by Python on the server (trame): the mappers of this package cannot run in a browser's WebGL."""
from __future__ import annotations

import asyncio
import importlib.util
import logging
import sys
import webbrowser
from typing import Any

import pyvista

from . import _modules
from ._checks import require_number
from ._medium import require_plotter
from .samples import requirements, shared
from .viewer_state import PORT

PACKAGES = ("trame", "trame_vtk", "trame_vuetify")
MOVING = 1.0  # pictures a second that a window is asked for while the mouse turns it, at least; at rest 0.0001


def serve(plotter: pyvista.Plotter, *, port: int = PORT, host: str = "127.0.0.1", open_browser: bool = True, title: str = "Nephoscope") -> None:
    """Show a plotter in the browser until Ctrl-C. Python draws it and sends the pictures to the browser.

    In a notebook use ``plotter.show(jupyter_backend="server")``.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter, before it is shown. With ``off_screen=True`` it opens no window.
    port : int, default: 8080
        Port of the web server, 0 to 65535. 0: any free port.
    host : str, default: "127.0.0.1"
        Address on which the server listens; ``"0.0.0.0"`` for all addresses of this machine. Everyone who can reach the address can see and turn the picture.
    open_browser : bool, default: True
        Open the page in the default browser, if there is one.
    title : str, default: "Nephoscope"
        Title of the page.

    Raises
    ------
    ModuleNotFoundError
        If trame is not installed; the message has the command that installs it.
    TypeError, ValueError
        If an argument has a wrong type or value.
    RuntimeError
        If an event loop is already running, as in a notebook.
    """
    require_plotter(plotter)
    server = make_server("nephoscope-serve")
    from trame.ui.vuetify3 import VAppLayout
    with VAppLayout(server, full_height=True):
        add_view(plotter, style="height: 100vh")
    server.state.trame__title = title
    run(server, port, host, open_browser)


def require_packages() -> None:
    """Raises ModuleNotFoundError with the command that installs the missing packages."""
    missing = [name for name in PACKAGES if importlib.util.find_spec(name) is None]
    if missing:
        command = _web_command()
        raise ModuleNotFoundError(f"Pictures in the browser need {', '.join(missing)}, not installed for {sys.executable}. "
                                  f"Run: {command}", name=missing[0])


def _web_command() -> str:
    """The command that installs the packages. With a Debian package they go into a separate environment, because they would bring a second VTK."""
    if _modules.FROM_PYPI:
        return f"{sys.executable} -m pip install 'nephoscope[web]'"
    if shared("requirements.txt"):
        return "python3 -m venv clouds && clouds/bin/python -m pip install 'nephoscope[web]', and use clouds/bin/python"
    return requirements("requirements-web.txt")


def make_server(name: str) -> Any:
    """A stand-alone trame server with Vue 3."""
    require_packages()
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        from trame.app import get_server
        return get_server(name, client_type="vue3")
    raise RuntimeError('An event loop is already running, as in a notebook. Use plotter.show(jupyter_backend="server").')


def add_view(plotter: pyvista.Plotter, **options: Any) -> Any:
    """Adds the view of a plotter to the current layout."""
    from trame.widgets import client
    from trame.widgets.vtk import VtkRemoteView  # PyVista's own class has another name in 0.49
    for renderer in plotter.renderers:
        if not renderer.camera.is_set:
            renderer.camera_position = renderer.get_default_cam_pos()
            renderer.ResetCamera()
    client.Style("html { overflow-y: auto }")  # Vuetify's pages have a scroll bar even if everything is visible
    save_time_while_moving(plotter)
    view = VtkRemoteView(plotter.render_window, interactive_ratio=1, **options)
    view.server.controller.on_server_ready.add(view.update)
    plotter.add_on_render_callback(lambda *_: view.update() if view.server.running else None, render_event=False)
    return view


def save_time_while_moving(plotter: pyvista.Plotter) -> None:
    """Leaves out what makes a moving picture slow in software OpenGL: the pictures that the interactor draws at each mouse event besides those that are sent, and multi-sampling."""
    window, interactor = plotter.render_window, plotter.iren.interactor
    samples: list[int] = []  # while a moving picture is drawn

    def start(*_: Any) -> None:
        if window.GetDesiredUpdateRate() >= MOVING and window.GetMultiSamples() > 1:
            samples.append(window.GetMultiSamples())
            window.SetMultiSamples(0)

    def end(*_: Any) -> None:
        if samples:
            window.SetMultiSamples(samples.pop())

    window.AddObserver("StartEvent", start)
    window.AddObserver("EndEvent", end)
    interactor.EnableRenderOff()
    interactor.AddObserver("RenderEvent", lambda *_: window.Modified())  # in place of drawing: what is sent next has to be drawn


def run(server: Any, port: int, host: str, open_browser: bool) -> None:
    """Serves until Ctrl-C, and prints the address."""
    port = int(require_number(port, "port", least=0, most=65535))

    @server.controller.add("on_server_ready")
    def say(**_: Any) -> None:
        address = f"http://{host}:{server.port}/"
        print(f"Nephoscope: {address} (Ctrl-C stops it)", flush=True)
        if open_browser:  # trame would recommend an option that this command does not have
            asyncio.get_running_loop().call_later(0.1, webbrowser.open, address)

    for name in ("wslink", "aiohttp.server"):  # they report browsers that disconnect while a picture is drawn
        logging.getLogger(name).setLevel(logging.CRITICAL)
    logging.getLogger("asyncio").addFilter(lambda record: not (record.exc_info and isinstance(record.exc_info[1], ConnectionError)))
    arguments, sys.argv = sys.argv, sys.argv[:1]  # trame reads them too
    try:
        server.start(port=port, host=host, open_browser=False, show_connection_info=False, disable_logging=True, timeout=0, exec_mode="main")
    except OSError as error:
        raise OSError(f"Port {port} of {host} cannot be used: {error.strerror or error}. Choose another one, or 0 for any free port.") from error
    except KeyboardInterrupt:
        pass
    finally:
        sys.argv = arguments
