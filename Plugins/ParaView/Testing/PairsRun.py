# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that PairsRanks.py compares, of two things in one view.

Usage: PairsRun.py PREFIX [0 NAMES]. A name is FIRST-SECOND-PLACE; NAMES, separated by commas, are those to draw.
"""
import sys

import numpy as np
from Pairs import names
from PluginTesting import clear, compose, empty_view, image, load_plugin, look, passed, pvs, set_background, solid

SIZE = (160, 120)


def block(at, halves=(5, 5, 4)):
    """An image about a place, of which each rank has a part."""
    extent = [c + side * half for c, half in zip(at, halves) for side in (-1, 1)]
    return pvs.Wavelet(WholeExtent=extent, Center=at)


def tilted(at, normal):
    """A surface through a block, of which each rank has a part. No edge is along an axis: where the border between ranks is in line with edges, ParaView
    draws cells beside it twice."""
    cut = pvs.Slice(Input=block([0, 0, 0], (3, 4, 4)), SliceType="Plane")
    cut.SliceType.Normal = normal
    turned = pvs.Transform(Input=cut)
    turned.Transform.Translate, turned.Transform.Rotate = at, [3, 5, 7]
    return turned


def surface(view, at, color, normal, opacity=1.0):
    display = pvs.Show(tilted(at, normal), view)
    solid(display, color)
    display.Ambient, display.Diffuse, display.Opacity = 1.0, 0.0, opacity


def terrain(view, at):
    surface(view, at, [0.5, 0.35, 0.2], [0.3, 0.2, 1])


def sheet(view, at):
    surface(view, at, [0.1, 0.8, 0.2], [0.3, -0.2, 1], 0.5)


def tops(view, at):
    display = pvs.Show(tilted(at, [-0.2, 0.3, 1]), view)
    display.SetRepresentationType("Cloud Texture")
    solid(display, [0.9, 0.9, 1])
    display.CloudTextureTextureLength = 20


def thin(display):
    """What lies behind is to be seen."""
    display.CellCompositingOpacityScale = display.TexturedSplatsOpacityScale = 0.4
    return display


def cells(view, at):
    thin(compose(block(at), view))


def tetrahedra(view, at):
    thin(compose(pvs.Tetrahedralize(Input=block(at)), view))


def splats(view, at):
    thin(compose(block(at), view, representation="Textured Splats"))


def flow(at):
    return pvs.Calculator(Input=block(at), ResultArrayName="Flow", Function="2*iHat+0.4*sin(0.5*coordsX)*jHat+0.3*cos(0.5*coordsX)*kHat")


def smoke(view, at):
    made = pvs.FlowVolume(Input=flow(at), Duration=5, TimeStep=0.25)
    made.Center, made.Radius = [at[0] - 4, at[1] + 0.2, at[2]], 1.5
    display = pvs.Show(made, view)
    display.SetRepresentationType("Cell Compositing")
    solid(display, [0.9, 0.3, 0.1])


def winds(view, at):
    display = thin(compose(flow(at), view, representation="Textured Splats"))
    solid(display, [0.2, 0.2, 0.2])
    display.TexturedSplatsVectorArray, display.TexturedSplatsUseVectorColor = "Flow", 1
    display.TexturedSplatsMoveWithTime, display.TexturedSplatsPhase = 0, 0.3


def haze(view, at):
    air = pvs.Show(pvs.Haze(), view)
    air.Projection, air.VisualRange = "Map", 150


THINGS = {make.__name__: make for make in (terrain, sheet, tops, cells, tetrahedra, splats, smoke, winds, haze)}
NEAR, FAR = [5, 4, 6], [-5, -4, -6]  # along the view
PLACES = {"before": (NEAR, FAR), "behind": (FAR, NEAR), "within": ([1, 0, 1], [-1, 0, 0])}


load_plugin()
view = empty_view(SIZE)
set_background(view, (0.25, 0.1, 0.05))
pvs._DisableFirstRenderCameraReset()
look(view, [33, 25, 38])
for name in sys.argv[3].split(",") if len(sys.argv) > 3 else names():
    first, second, place = name.split("-")
    for thing, at in zip((first, second), PLACES[place]):
        THINGS[thing](view, at)
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    clear(view)
    print(name, flush=True)
passed()
