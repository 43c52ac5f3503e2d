# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loads the reader of weather data into ParaView: ``from nephoscope.weather.paraview_reader import load; load()`` in pvpython or in ParaView's Python Shell."""
import inspect
from pathlib import Path

PLUGIN = Path(__file__).with_name("paraview_plugin.py")


def _has_ranks_without_python():
    """True on the first of several ranks, where only this one runs the script."""
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    process = vtkProcessModule.GetProcessModule()
    return process.GetNumberOfLocalPartitions() > 1 and not process.GetSymmetricMPIMode()


def load(ns=None):
    """After this the reader is in File > Open. Returns the function that makes one, which `ns` (``globals()``) has too, as WeatherDataReader."""
    if not hasattr(inspect, "getargspec") and _has_ranks_without_python():
        raise RuntimeError("On several MPI ranks this ParaView needs the reader loaded on every rank: start pvbatch with --symmetric.")
    if not hasattr(inspect, "getargspec"):  # gone since Python 3.11; ParaView 5.11 imports it for every plugin in Python
        inspect.getargspec = inspect.getfullargspec
    from paraview.simple import LoadPlugin
    names = {} if ns is None else ns
    LoadPlugin(str(PLUGIN), remote=False, ns=names)
    made = next(name for name in names if name.lower().startswith("weatherdata"))  # ParaView makes the name of the label
    names["WeatherDataReader"] = names[made]
    return names[made]
