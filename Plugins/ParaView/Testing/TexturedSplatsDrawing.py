# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts share whose pictures of splats are compared between numbers of ranks.

Usage of such a script: SCRIPT.py PREFIX [PORT NAMES]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from PluginTesting import GFS, clear, compose, empty_view, image, load_plugin, look, pvs, wanted


def begin():
    if len(sys.argv) > 2:
        pvs.Connect("localhost", int(sys.argv[2]))
    load_plugin()


def draw(name, source, array=("POINTS", "RTData"), distance=1, place=None, time=0.0, **settings):
    """Unless others alone are wanted, saves the picture of a source at a time, with these properties of Textured Splats and of the display."""
    if not wanted(name):
        return
    view = empty_view()
    view.ViewTime = time
    display = compose(source, view, array, "Textured Splats")
    for key, value in (place or {}).items():
        setattr(display, key, value)
    for key, value in settings.items():
        setattr(display, "TexturedSplats" + key, value)
    look(view, position=[distance * c for c in (60, 45, 70)])
    picture = image(view)
    clear(view)
    np.save(f"{sys.argv[1]}-{name}.npy", picture)


def particles_of(source):
    return pvs.MaskPoints(Input=source, OnRatio=1, MaximumNumberofPoints=10**6, GenerateVertices=1, SingleVertexPerCell=1)


def draw_globe(name, stride=2, **settings):
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0),
                                VOI=[0, 10**6] * 3, SampleRateI=stride, SampleRateJ=stride)
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=50)
    globe.UpdatePipeline()
    distance = max(abs(b) for b in globe.GetDataInformation().GetBounds()) / 20
    draw(name, globe, ("POINTS", "r"), distance=distance, **settings)
