# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestInstalled.py [pvpython|pvbatch|python]: the suite is there in a ParaView, or a Python, that was started with nothing set. Writes a picture.

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


def save(view, name):
    """The view as a picture, which must show more than a background."""
    from paraview import simple as pvs
    from vtkmodules.vtkIOImage import vtkPNGReader
    pvs.SaveScreenshot(name, view, ImageResolution=[400, 300])
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    colors = reader.GetOutput().GetPointData().GetScalars()
    seen = {colors.GetTuple(pixel) for pixel in range(colors.GetNumberOfTuples())}
    assert len(seen) > 500, f"{name} has {len(seen)} colours"
    print("wrote", name, flush=True)


def in_paraview(name):
    from paraview import simple as pvs
    assert hasattr(pvs, "GlobeGrid"), "the plugin is not loaded"
    wavelet = pvs.Wavelet()
    display = pvs.Show(wavelet)
    offered = list(display.GetProperty("Representation").Available)
    assert {"Cell Compositing", "Textured Splats"} <= set(offered), offered
    display.SetRepresentationType("Cell Compositing")
    save(pvs.Render(), name + ".png")


def both_halves():
    """Unstructured data that each of two ranks has a part of fill the picture on both sides."""
    from paraview import simple as pvs
    from vtkmodules.util.numpy_support import vtk_to_numpy
    view = pvs.CreateRenderView()
    view.ViewSize, view.OrientationAxesVisibility = [200, 200], 0
    display = pvs.Show(pvs.Tetrahedralize(Input=pvs.Wavelet()), view)
    display.SetRepresentationType("Cell Compositing")
    pvs.ColorBy(display, ("POINTS", "RTData"))
    for position in ([0, 0, 60], [60, 0, 0], [0, 60, 0]):
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = position, [0, 0, 0], [0, 1, 0] if position[1] == 0 else [0, 0, 1]
        pvs.Render(view)
        picture = vtk_to_numpy(view.CaptureWindow(1).GetPointData().GetScalars()).reshape(200, 200, -1).astype(int)
        seen = abs(picture - picture[0, 0]).max(axis=2) > 8
        sides = [seen[:, :100].sum(), seen[:, 100:].sum(), seen[:100].sum(), seen[100:].sum()]
        assert min(sides) > 0.9 * max(sides) > 0, f"ranks have lost cells: {sides} pixels from {position}"
    print("both halves", sides)


def first_picture(name):
    """What the documentation promises: the source alone draws the forecast over the Earth."""
    from paraview import simple as pvs
    view = pvs.CreateRenderView()
    example = pvs.CloudsovertheGlobe()
    for port in range(2):
        pvs.Show(pvs.OutputPort(example, port), view)
    pvs.ResetCamera(view)
    save(view, name)


def in_python(name):
    import nephoscope
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
    source, smoothing = vtkRTAnalyticSource(), nephoscope.vtkStructuredSmoothing()
    smoothing.SetInputConnection(source.GetOutputPort())
    smoothing.Update()
    assert smoothing.GetOutput().GetNumberOfPoints() == 21 ** 3
    assert nephoscope.__file__.startswith("/usr/lib/python3/dist-packages/"), nephoscope.__file__
    print(name, nephoscope.__file__)
    no_dead_links("/usr/share/doc/nephoscope-paraview")


def no_dead_links(documents):
    """Every file that an installed page links to is installed."""
    pages = glob.glob(f"{documents}/**/*.md", recursive=True)
    dead = []
    for page in pages:
        with open(page, encoding="utf-8") as text:
            links = re.findall(r"\]\(([^)#\s]+)", text.read())
        dead += [f"{page}: {link}" for link in links if "://" not in link and not os.path.exists(os.path.join(os.path.dirname(page), link))]
    assert pages and not dead, "dead links in the installed pages:\n" + "\n".join(dead)
    print(len(pages), "pages without dead links")


if len(sys.argv) > 1 and sys.argv[-1] == "python":
    in_python("python")
elif len(sys.argv) > 1 and sys.argv[-1] in ("pvpython", "pvbatch"):
    in_paraview(sys.argv[-1])
    if sys.argv[-1] == "pvpython":
        first_picture("globe.png")
    else:
        both_halves()
else:
    status = 1
    try:
        assert has_help(), "Qt's driver for SQLite is not there"
        in_paraview("paraview")
        status = 0
    except BaseException:
        os.write(2, traceback.format_exc().encode())  # ParaView keeps what Python prints
    os._exit(status)  # the window closes without asking
