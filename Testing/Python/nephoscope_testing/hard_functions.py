# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Transfer functions that are hard to integrate: many points, jumps, spikes, curves, steps, large and shifted scalars.

Each is a Case: the VTK property to draw with, and the same function as pieces for contours.render.
"""
from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkDiscretizableColorTransferFunction, vtkVolumeProperty

from .contours import Jumps

SAMPLES = 20001  # per piece of a curved function


@dataclass
class Case:
    name: str
    prop: vtkVolumeProperty
    pieces: Jumps        # what is to be drawn
    low: float = 0.0     # the scalars go from low to high
    high: float = 1.0
    curved: bool = False  # drawn from a table that follows it to 1/2000


class Curve(Jumps):
    """Samples of VTK's functions, dense between the places where they bend or jump."""

    def __init__(self, prop, places, low, high, opacity_scale=1.0):
        self.prop, self.places = prop, np.asarray(places, float)
        edges = np.unique(np.concatenate([[low], self.places[(self.places > low) & (self.places < high)], [high]]))
        at = np.concatenate([np.linspace(a + 1e-9 * (b - a), b - 1e-9 * (b - a), SAMPLES) for a, b in zip(edges, edges[1:])])
        rgb = [0.0] * 3
        color, opacity = prop.GetRGBTransferFunction(), prop.GetScalarOpacity()
        colors = np.empty((len(at), 4))
        for i, x in enumerate(at):
            color.GetColor(x, rgb)
            colors[i] = x, *rgb
        values = np.array([(x, opacity.GetValue(x)) for x in at])
        super().__init__(colors, values, prop.GetScalarOpacityUnitDistance(), opacity_scale)

    @property
    def breakpoints(self):
        """Besides the places, so many that the function is straight between them."""
        edges = np.unique(np.concatenate([self.places, self.opacities[[0, -1], 0]]))
        return np.unique(np.concatenate([np.linspace(a, b, 65) for a, b in zip(edges, edges[1:])]))


def _property(colors, opacities, unit_distance, clamping=True):
    color, opacity, prop = vtkColorTransferFunction(), vtkPiecewiseFunction(), vtkVolumeProperty()
    for function in (color, opacity):
        function.AllowDuplicateScalarsOn()
        function.SetClamping(clamping)
    for row in colors:
        color.AddRGBPoint(*row)
    for row in opacities:
        opacity.AddPoint(*row)
    assert (color.GetSize(), opacity.GetSize()) == (len(colors), len(opacities))
    prop.SetColor(color)
    prop.SetScalarOpacity(opacity)
    prop.SetScalarOpacityUnitDistance(unit_distance)
    return prop


def linear(name, colors, opacities, unit_distance, low=0.0, high=1.0):
    return Case(name, _property(colors, opacities, unit_distance), Jumps(colors, opacities, unit_distance), low, high)


def curved(name, prop, places, low=0.0, high=1.0):
    return Case(name, prop, Curve(prop, places, low, high), low, high, True)


RED_TO_BLUE = [(0, 1, 0, 0), (1, 0, 0, 1)]


def many_points(rng, count):
    x = np.linspace(0, 1, count)
    return linear(f"{count} random points", np.column_stack([x, rng.uniform(size=(count, 3))]),
                  np.column_stack([x, rng.uniform(size=count)]), 0.5)


def jumps(rng, count):
    x = np.sort(rng.uniform(0.02, 0.98, count))
    at = np.concatenate([[0], np.repeat(x, 2), [1]])
    return linear(f"{count} jumps", np.column_stack([at, rng.uniform(size=(len(at), 3))]),
                  np.column_stack([at, rng.uniform(size=len(at))]), 0.5)


def spike(width, depth=1.0, offset=0.0, scale=1.0):
    """Opacity 1 in a tent of this width (of the range) about the middle; optical depth about `depth` across it."""
    at = offset + scale * np.array([0, 0.47, 0.47 + width / 2, 0.47 + width, 1])
    colors = [(offset + scale * x, *rgb) for x, *rgb in RED_TO_BLUE]
    return linear(f"spike of width {width:g}", colors, np.column_stack([at, [0, 0, 1, 0, 0]]), width / depth, offset, offset + scale)


def comb(width, count):
    """Spikes of alternating colour."""
    middle = (np.arange(count) + 0.5) / count
    at = np.sort(np.concatenate([middle - width / 2, middle, middle + width / 2]))
    colors = [(x, i % 2, 0, 1 - i % 2) for i, m in enumerate(middle) for x in (m - 0.4 / count, m + 0.4 / count)]
    return linear(f"{count} spikes of width {width:g}", colors, np.column_stack([at, np.tile([0, 1, 0], count)]), 4 * width)


def dense(scale):
    """A ramp whose optical depth is about `scale`."""
    return linear(f"ramp of optical depth {scale:g}", RED_TO_BLUE, [(0, 0), (0.3, 0), (1, 1)], 1 / scale)


def shifted(offset, scale):
    at = np.array([0, 0.2, 0.2, 0.45, 0.5, 0.55, 1])
    name = f"scalars from {offset:g} to {offset + scale:.12g}"
    colors = [(offset + scale * x, r, g, b) for x, r, g, b in [(0, 1, 0, 0), (0.4, 0, 1, 0), (0.4, 0, 0, 1), (1, 1, 1, 0)]]
    opacities = np.column_stack([offset + scale * at, [0.1, 0.1, 0.6, 0.0, 1.0, 0.0, 0.4]])
    return linear(name, colors, opacities, 0.3, offset, offset + scale)


def outliers(window):
    """All of the function within a small part of the range of the data."""
    at = 0.4 + window * np.array([0, 0.5, 1])
    return linear(f"function over {window:g} of the range", [(at[0], 1, 0, 0), (at[2], 0, 0, 1)], np.column_stack([at, [0, 1, 0]]), window)


def logarithmic():
    prop = _property([(0.01, 0, 0, 1), (1, 0, 1, 0), (100, 1, 0, 0)], [(0.01, 0.3), (100, 0.6)], 0.5)
    prop.GetRGBTransferFunction().SetScaleToLog10()
    return curved("colours on a logarithmic scale", prop, (0.01, 1, 100), 0.01, 100)


def sharp(sharpness, midpoint, scale):
    prop = _property(RED_TO_BLUE, [(0, 0), (1, 1)], 1 / scale)
    opacity = prop.GetScalarOpacity()
    opacity.RemoveAllPoints()
    opacity.AddPoint(0, 0, midpoint, sharpness)
    opacity.AddPoint(1, 1)
    return curved(f"sharpness {sharpness:g}, midpoint {midpoint:g}, optical depth {scale:g}", prop, (0, midpoint, 1))


def unclamped():
    rows = [(0.3, 0.7), (0.6, 0.2)]
    colors = [(0.2, 1, 0.5, 0), (0.7, 0, 0.5, 1)]
    zero = lambda table: [(table[0][0], *[0] * (len(table[0]) - 1))] + table + [(table[-1][0], *[0] * (len(table[0]) - 1))]
    return Case("clamping off", _property(colors, rows, 0.3, False), Jumps(zero(colors), zero(rows), 0.3))


def discretized(count):
    prop = _property(RED_TO_BLUE, [(0, 0.2), (1, 1)], 0.3)
    color = vtkDiscretizableColorTransferFunction()
    for row in RED_TO_BLUE:
        color.AddRGBPoint(*row)
    color.DiscretizeOn()
    color.SetNumberOfValues(count)
    color.Build()
    prop.SetColor(color)
    return curved(f"{count} discrete colours", prop, np.linspace(0, 1, count + 1))


def cases():
    rng = np.random.default_rng(51)
    yield many_points(rng, 16)
    yield many_points(rng, 200)
    yield jumps(rng, 4)
    yield jumps(rng, 40)
    for width in (1e-2, 1e-4, 1e-6, 1e-8):
        yield spike(width)
    yield comb(1e-3, 10)
    for scale in (1e2, 1e4, 1e6):
        yield dense(scale)
    for offset, scale in ((1e6, 1.0), (1e9, 1.0), (-1e12, 1.0), (0.0, 1e30), (0.0, 1e-30), (0.0, 1e300)):
        yield shifted(offset, scale)
    yield outliers(1e-3)
    yield outliers(1e-5)
    yield logarithmic()
    for sharpness, midpoint, scale in ((0.0, 0.2, 1), (0.5, 0.5, 1), (0.9, 0.3, 10), (0.5, 0.5, 1e4)):
        yield sharp(sharpness, midpoint, scale)
    yield unclamped()
    yield discretized(5)
