# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trials in ParaView: every representation and every filter of the plugin with its defaults, one line each."""
import os
import tempfile

import numpy as np

SIZE = 80
FUNCTIONS = {}


class Function:
    def __init__(self, name, needs, show):
        self.name, self.needs, self.show, self.few = name, set(needs), show, False


def add(name, needs, show):
    """needs: see datasets.py. show(simple, source, view): returns nothing."""
    FUNCTIONS[name] = Function(name, needs, show)


def represented(representation):
    def show(simple, source, view):
        display = simple.Show(source, view)
        display.SetRepresentationType(representation)
    return show


def filtered(*names):
    def show(simple, source, view):
        for name in names:
            source = getattr(simple, name)(Input=source)
        simple.Show(source, view)
    return show


add("pv-Surface", "", represented("Surface"))  # to compare with
for name, needs in (("Cell Compositing", "c"), ("Textured Splats", "p"), ("Cloud Texture", "s")):
    add("pv-" + name.replace(" ", ""), needs, represented(name))
for name, needs in (("GlobeGrid", "l"), ("ContourCellSplitter", "f"), ("PolyhedrontoTetrahedra", "c"), ("StructuredSmoothing", "g"),
                    ("CloudSurface", "g"), ("FlowVolume", "v"), ("TextureCoordinateAdvection", "v")):
    add("pv-" + name, needs, filtered(name))
add("pv-SmokePuffs", "v", filtered("FlowVolume", "SmokePuffs"))


def picture(simple, view):
    from PIL import Image
    name = os.path.join(tempfile.gettempdir(), f"trial-{os.getpid()}.png")
    simple.SaveScreenshot(name, view, ImageResolution=[SIZE, SIZE])
    image = np.asarray(Image.open(name).convert("RGB"))
    os.remove(name)
    return image


def trial(function, dataset):
    """(verdict, picture or None)"""
    from capture import Capture
    from judge import Verdict
    from paraview import simple
    function, verdict, image = FUNCTIONS[function], Verdict(), None
    data = dataset.make()
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateRenderView(ViewSize=[SIZE, SIZE], OrientationAxesVisibility=0, UseColorPaletteForBackground=0, Background=[0, 0, 0])
    with Capture() as said:
        if not hasattr(data, "IsA"):
            raise ValueError("no data object: a file or a source has to be there in ParaView")
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(data)
        source.UpdatePipeline()
        function.show(simple, source, view)
        view.ResetActiveCameraToIsometricView() if hasattr(view, "ResetActiveCameraToIsometricView") else None
        simple.ResetCamera(view)
        image = picture(simple, view)
    told = verdict.words(said, True) or not getattr(data, "n_points", 1) or not getattr(data, "n_blocks", 1)
    visible = verdict.picture(function.needs <= dataset.shows, told, bool(said.raised), np.zeros_like(image) if image is not None else None, image, may_draw=True)
    if visible and image is not None:
        verdict.same("unsteady", image, picture(simple, view), exact=True)
    for proxy in [*simple.GetSources().values(), view]:
        simple.Delete(proxy)
    return verdict, image
