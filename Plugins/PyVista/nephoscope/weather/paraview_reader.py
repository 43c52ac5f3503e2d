# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loads the reader of weather data into ParaView: ``from nephoscope.weather.paraview_reader import load; load()`` in pvpython or in ParaView's Python Shell."""
import inspect
from pathlib import Path

PLUGIN = Path(__file__).with_name("paraview_plugin.py")


def _with_getargspec():
    """What ParaView 5.11 imports for every plugin in Python, and Python 3.11 no longer has: here, and by a source that runs on every rank and on a server."""
    from paraview import servermanager
    inspect.getargspec = inspect.getfullargspec
    source = servermanager.sources.ProgrammableSource(Script="import inspect\ninspect.getargspec = inspect.getfullargspec")
    source.UpdatePipeline()


def load(ns=None):
    """Adds the reader to File > Open. Returns the function that creates a reader; `ns` (``globals()``) gets it too, as WeatherDataReader."""
    from paraview.simple import LoadPlugin
    if not hasattr(inspect, "getargspec"):
        _with_getargspec()
    names = {} if ns is None else ns
    LoadPlugin(str(PLUGIN), remote=True, ns=names)
    made = next(name for name in names if name.lower().startswith("weatherdata"))  # ParaView makes the name of the label
    names["WeatherDataReader"] = names[made]
    return names[made]
