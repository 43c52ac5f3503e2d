# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The reader of weather data in scripts: ``from nephoscope.weather.paraview_reader import load; load(globals())`` in pvpython or in ParaView's Python Shell."""
from pathlib import Path

PLUGIN = Path(__file__).with_name("paraview_plugin.py")


def load(ns=None):
    """Returns the function that creates a reader; `ns` (``globals()``) gets it too, as WeatherDataReader.

    ParaView with the plugin Nephoscope has the reader already. Any other, from 5.12 on, gets it from a plugin in Python.
    """
    from paraview import simple
    names = {} if ns is None else ns
    if _made(vars(simple)) is None:
        simple.LoadPlugin(str(PLUGIN), remote=True, ns=names)
    names["WeatherDataReader"] = _made(vars(simple)) or _made(names)
    return names["WeatherDataReader"]


def read(path, time=None, **properties):
    """A reader of the file, up to date, with the properties of its panel, for example ``read("forecast.grib2", Levels=[0, 5])``.

    ParaView prints an error of a reader and continues. This function raises it as a RuntimeError.
    """
    return check(load()(FileName=str(path), **properties), time)


def check(reader, time=None):
    """Brings a reader up to date, and returns it; raises a RuntimeError if it could not read."""
    reader.UpdatePipeline(*(() if time is None else (time,)))
    reader.UpdatePropertyInformation()
    problem = reader.GetProperty("Problem").GetData()
    if problem:
        raise RuntimeError(problem)
    return reader


def _made(names):
    """The function that ParaView names by the reader's label; None if it is not there."""
    return names.get("WeatherDataReader")
