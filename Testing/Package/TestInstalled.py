# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestInstalled.py [pvpython|python]: the suite is there in a ParaView, or a Python, that was started with nothing set. Writes a picture.

In ParaView's window: paraview --script=TestInstalled.py
"""
import glob
import os
import re
import sys
import traceback


def has_help():
    """The "?" of ParaView's window opens pages only if its Qt has the driver for SQLite."""
    with open("/proc/self/maps") as libraries:
        qt = re.search("libQt([56])Help", libraries.read())[1]
    return bool(glob.glob(f"/usr/lib/*/qt{qt}/plugins/sqldrivers/libqsqlite.so"))


def in_paraview(name):
    from paraview import simple as pvs
    assert hasattr(pvs, "GlobeGrid"), "the plugin is not loaded"
    wavelet = pvs.Wavelet()
    display = pvs.Show(wavelet)
    offered = list(display.GetProperty("Representation").Available)
    assert {"Cell Compositing", "Textured Splats"} <= set(offered), offered
    display.SetRepresentationType("Cell Compositing")
    view = pvs.Render()
    pvs.SaveScreenshot(name + ".png", view, ImageResolution=[400, 300])
    print("wrote", name + ".png", flush=True)


def in_python(name):
    import nephoscope
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
    source, smoothing = vtkRTAnalyticSource(), nephoscope.vtkStructuredSmoothing()
    smoothing.SetInputConnection(source.GetOutputPort())
    smoothing.Update()
    assert smoothing.GetOutput().GetNumberOfPoints() == 21 ** 3
    assert nephoscope.__file__.startswith("/usr/lib/python3/dist-packages/"), nephoscope.__file__
    print(name, nephoscope.__file__)


if len(sys.argv) > 1 and sys.argv[-1] == "python":
    in_python("python")
elif len(sys.argv) > 1 and sys.argv[-1] == "pvpython":
    in_paraview("pvpython")
else:
    status = 1
    try:
        assert has_help(), "Qt's driver for SQLite is not there"
        in_paraview("paraview")
        status = 0
    except BaseException:
        os.write(2, traceback.format_exc().encode())  # ParaView keeps what Python prints
    os._exit(status)  # the window closes without asking
