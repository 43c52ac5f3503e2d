# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the ParaView plugin share: loading it, views that compare, images as arrays."""
import functools
import os
import sys
import weakref

import nephoscope_testing.quick_paraview  # noqa: F401
import numpy as np
from paraview import servermanager
from paraview import simple as pvs
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkOutputWindow

DATA = os.environ["NEPHOSCOPE_DATA"]
OUTPUT = os.environ["NEPHOSCOPE_TEST_OUTPUT"]
GFS = os.path.join(DATA, "gfs_2p5deg_2011101100.nc")
SIZE = (300, 300)
NAME = "Cell Compositing"
RENDERED = weakref.WeakSet()  # proxies of views


def load_plugin():
    """PV_PLUGIN_PATH loads the plugin where a session starts, here or on a server; else it is loaded by its path."""
    manager = servermanager.ProxyManager().GetProxyDefinitionManager()
    if not manager.HasDefinition("filters", "GlobeGrid"):
        path = os.path.join(os.environ["PV_PLUGIN_PATH"], "Nephoscope.so")
        pvs.LoadPlugin(path, remote=False, ns=vars(pvs))


def new_view(size=SIZE, background=(0, 0, 0)):
    """A render view without anything that differs between hosts: axes, palettes, antialiasing."""
    view = pvs.CreateRenderView(ViewSize=list(size), OrientationAxesVisibility=0)
    view.UseColorPaletteForBackground = 0
    view.UseFXAA = 0
    view.MultiSamples = 1
    set_background(view, background)
    return view


@functools.cache
def empty_view(size=SIZE):
    """One view of each size for many pictures, each of which is followed by `clear`: in a third less time than views of their own."""
    return new_view(size)


def clear(view):
    """Leaves a view without anything that it showed."""
    for display in list(view.Representations):
        pvs.Delete(display)


def set_background(view, color):
    if hasattr(view, "BackgroundColorMode"):
        view.BackgroundColorMode = "Single Color"
    view.Background = list(color)


def wanted(name):
    """Whether a script that saves pictures, SCRIPT.py PREFIX [PORT NAMES], shall draw this one: all of them without NAMES, which commas separate."""
    return len(sys.argv) < 4 or name in sys.argv[3].split(",")


def look(view, position=(60, 45, 70), focal_point=(0, 0, 0)):
    view.CameraPosition = list(position)
    view.CameraFocalPoint = list(focal_point)
    view.CameraViewUp = [0, 1, 0]
    view.CameraViewAngle = 30


def show_twice(source, representation=None, **settings):
    """Two pictures, with these settings of the display; for what is told of them."""
    view = empty_view((40, 40))
    display = pvs.Show(source, view)
    if representation:
        display.SetRepresentationType(representation)
    for name, value in settings.items():
        setattr(display, name, value)
    pvs.Render(view)
    pvs.Render(view)
    clear(view)


def compose(source, view, array=("POINTS", "RTData"), representation=NAME):
    """Shows a source as a user would: display, colour by, pick the representation."""
    display = pvs.Show(source, view)
    pvs.ColorBy(display, array)
    display.SetRepresentationType(representation)
    return display


def solid(display, color):
    """Solid Color, the same for surfaces and volumes."""
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = list(color)


def render(view):
    pvs.Render(view)
    RENDERED.add(view.SMProxy)


def image(view):
    """The picture of the view as floats in [0, 255], height x width x 3."""
    if view.SMProxy not in RENDERED:
        render(view)  # the first of a session looks at its data; after it, capturing is rendering
    captured = view.SMProxy.CaptureWindow(1)
    width, height, _ = captured.GetDimensions()
    values = vtk_to_numpy(captured.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[:, :, :3].astype(float)


def color_and_alpha(view):
    """Premultiplied colour and alpha of all that is drawn, from a black and a white background."""
    set_background(view, (0, 0, 0))
    on_black = image(view)
    set_background(view, (1, 1, 1))
    on_white = image(view)
    set_background(view, (0, 0, 0))
    return on_black, 1.0 - (on_white - on_black).mean(axis=2) / 255.0


def inside_mean_alpha(alpha):
    """Mean alpha over the pixels that show anything."""
    shown = alpha > 0.02
    check(shown.mean() > 0.02, f"only {shown.mean():.3%} of the picture shows anything")
    return alpha[shown].mean()


def save_image(values, name):
    """Keeps a picture for whoever looks into a failure."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkPNGWriter

    height, width, components = values.shape
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(np.clip(np.rint(values), 0, 255).astype(np.uint8).reshape(-1, components))
    data.GetPointData().SetScalars(numpy_to_vtk(flat, deep=1))
    writer = vtkPNGWriter()
    writer.SetFileName(os.path.join(OUTPUT, name + ".png"))
    writer.SetInputData(data)
    writer.Write()


def check(condition, message):
    if not condition:
        print("FAILED:", message, flush=True)
        sys.exit(1)


def check_same(first, second, name, largest=0.0, mean=0.0):
    """Two pictures agree: largest and mean difference of a channel, of 255."""
    difference = np.abs(first - second)
    print(f"{name}: max {difference.max():.0f}, mean {difference.mean():.4f} of 255", flush=True)
    if difference.max() > largest or difference.mean() > max(mean, 1e-12 if largest == 0 else mean):
        for values, suffix in ((first, "first"), (second, "second"), (difference * 20, "difference")):
            save_image(values, f"{name}.{suffix}".replace(" ", "_"))
        check(False, f"{name}: more than max {largest}, mean {mean}; pictures in {OUTPUT}")


def listen():
    """A list that gets the text of every error and warning from now on."""
    messages = []

    @calldata_type(VTK_STRING)
    def hear(_, __, text):
        messages.append(text)
    for event in ("ErrorEvent", "WarningEvent"):
        vtkOutputWindow.GetInstance().AddObserver(event, hear)
    return messages


def passed():
    """The token that ctest waits for: a script that did not run to its end does not pass."""
    print("NEPHOSCOPE" + "-PASSED", flush=True)
