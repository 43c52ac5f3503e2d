# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestInstalled.py [pvpython|python]: the suite is there in a ParaView, or a Python, that was started with nothing set. Writes a picture.

In ParaView's window: paraview --script=TestInstalled.py
"""
import os
import sys


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
    in_paraview("paraview")
    os._exit(0)  # the window closes without asking
