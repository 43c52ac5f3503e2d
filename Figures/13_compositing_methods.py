# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 13: one small cloud of tetrahedra drawn by every method of vtkCellCompositingMapper, and what each gets wrong.

Above the pictures, below their largest error over the channels against quadrature along the ray of each pixel, on a
logarithmic scale. Numbers under the maps: largest error and root mean square over the pixels that show anything, those left
out whose centre is within 1/100 pixel of an edge of a tetrahedron, where a rasteriser may take the neighbour.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "Testing", "Python"))

from nephoscope_testing import meshes, reference  # noqa: E402
from nephoscope_testing.checks import cells_of, mapper  # noqa: E402
from nephoscope_testing.compare import edge_mask  # noqa: E402
from nephoscope_testing.offscreen import Window, float_image  # noqa: E402
from nephoscope_testing.pictures import image_data  # noqa: E402
from nephoscope_testing.transfer import Transfer  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: E402
from vtkmodules.vtkRenderingCore import (vtkActor2D, vtkImageMapper, vtkRenderer, vtkRenderWindow,  # noqa: E402
                                         vtkTextActor, vtkWindowToImageFilter)

GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
METHODS = {"TrianglesLinear": "Triangles, linear opacity", "TrianglesTable": "Triangles, table",
           "Faces": "Faces", "Cells": "Cells"}
TILE, MARGIN, WIDTH, HEIGHT = 456, 16, 1920, 1080
BACKGROUND = np.array([0.012, 0.02, 0.045])
DECADES = 6  # of the error scale: from 1 down to 1e-6
SCALE = np.array([[0, 0, 0], [0.20, 0.05, 0.45], [0.65, 0.10, 0.45], [0.95, 0.40, 0.15], [1, 0.85, 0.3], [1, 1, 1]])


def cloud():
    """Random points in a flat ball; the density of three puffs."""
    rng = np.random.default_rng(20)
    points = rng.normal(size=(160, 3))
    points *= (rng.uniform(0.05, 1, len(points)) ** (1 / 3) / np.linalg.norm(points, axis=1))[:, None]
    data = meshes.delaunay(rng, 0, points * [1.25, 0.8, 1.0])
    puffs = (((-0.55, -0.1, 0.1), 0.45), ((0.1, 0.15, 0.0), 0.5), ((0.65, -0.15, -0.1), 0.38))
    density = lambda p: sum(np.exp(-((p - c) ** 2).sum(axis=1) / r ** 2) for c, r in puffs)
    return meshes.with_field(data, lambda p: density(p) / density(p).max())


TRANSFER = Transfer([(0, 0.1, 0.3, 1.0), (0.5, 1.0, 0.92, 0.8), (1, 1.0, 0.3, 0.05)], [(0, 0), (0.1, 0), (1, 9)])


def draw(data, method):
    """Float image, view and cells of the scene."""
    window = Window((TILE, TILE))
    scene = window.add_scene()
    ours = mapper()
    getattr(ours, "SetMethodTo" + method)()
    scene.add_volume(ours, data, TRANSFER)
    scene.look((0.9, 1.1, 4.2), (0, 0, 0), angle=32, near=1, far=9)
    window.render()
    return float_image(ours), scene.view()


def error_colors(error):
    place = np.clip((np.log10(np.maximum(error, 1e-12)) + DECADES) / DECADES, 0, 1) * (len(SCALE) - 1)
    low = np.minimum(place.astype(int), len(SCALE) - 2)
    t = (place - low)[..., None]
    return (1 - t) * SCALE[low] + t * SCALE[low + 1]


def text(renderer, words, x, y, size, color=(0.85, 0.89, 0.95), justify="Centered"):
    actor = vtkTextActor()
    actor.SetInput(words)
    prop = actor.GetTextProperty()
    prop.SetFontSize(size)
    prop.SetColor(*color)
    getattr(prop, "SetJustificationTo" + justify)()
    actor.SetPosition(x, y)
    renderer.AddViewProp(actor)


def show(canvas, labels, name):
    """Writes the canvas (bottom row first) with text over it."""
    mapper2d, actor, renderer, window = vtkImageMapper(), vtkActor2D(), vtkRenderer(), vtkRenderWindow()
    mapper2d.SetInputData(image_data(canvas))
    mapper2d.SetColorWindow(255)
    mapper2d.SetColorLevel(127.5)
    actor.SetMapper(mapper2d)
    renderer.AddViewProp(actor)
    for label in labels:
        text(renderer, *label)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(WIDTH, HEIGHT)
    window.AddRenderer(renderer)
    window.Render()
    grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()


def main():
    data = cloud()
    cells = cells_of(data)
    pictures = {method: draw(data, method) for method in METHODS}
    view = next(iter(pictures.values()))[1]
    exact = reference.render(cells, view, TRANSFER)
    mask = edge_mask(cells.drawn_edges(), view)
    canvas = np.broadcast_to(BACKGROUND, (HEIGHT, WIDTH, 3)).copy()
    labels = []
    for column, (method, label) in enumerate(METHODS.items()):
        image = pictures[method][0]
        error = np.abs(image - exact).max(axis=2)
        x, low, high = MARGIN + column * (TILE + MARGIN), 92, 92 + TILE + MARGIN
        canvas[high:high + TILE, x:x + TILE] = reference.over(image, BACKGROUND)
        canvas[low:low + TILE, x:x + TILE] = error_colors(error)
        counted = error[(exact[..., 3] > 0) & ~mask]
        labels.append((label, x + TILE / 2, HEIGHT - 36, 24))
        labels.append((f"largest {counted.max():.2g}, rms {np.sqrt((counted ** 2).mean()):.2g}", x + TILE / 2, 58, 18))
    bar = np.linspace(0, 1, 600)
    canvas[28:40, 660:1260] = error_colors(10 ** (DECADES * bar - DECADES))
    labels += [(f"1e-{DECADES - i}" if i < DECADES else "1", 660 + 600 * i / DECADES, 6, 14) for i in range(DECADES + 1)]
    labels.append(("error", 640, 24, 18, (0.85, 0.89, 0.95), "Right"))
    name = os.path.join(GALLERY, "13_compositing_methods.png")
    show(np.clip(canvas, 0, 1), labels, name)
    print("wrote", name)


main()
