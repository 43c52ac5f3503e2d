# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent surfaces among the cells: the reference cuts every ray at every surface it meets."""
import numpy as np
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

from . import reference

SAME = 1e-6  # hits this near to each other, relative to the distance, are one hit on the edge between two triangles


def triangulated(source):
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def plane(center, size=1.5, normal=(0, 0, 1)):
    """A square; `size` is half its edge."""
    source = vtkPlaneSource()
    source.SetOrigin(-size, -size, 0)
    source.SetPoint1(size, -size, 0)
    source.SetPoint2(-size, size, 0)
    source.SetCenter(*center)
    source.SetNormal(*normal)
    return triangulated(source)


def sphere(center, radius):
    source = vtkSphereSource()
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetThetaResolution(14)
    source.SetPhiResolution(10)
    return triangulated(source)


class Layer:
    """A surface: (n,3,3) triangles, a colour (one, or one per pixel as (height, width, 3)) and an opacity."""

    def __init__(self, triangles, color, opacity):
        self.triangles, self.color, self.opacity = np.asarray(triangles, float), np.asarray(color, float), opacity

    def hits(self, view):
        """(rays, number of hits) world lengths, ascending, inf where there are no more."""
        pixel, found = reference.triangle_hits(self.triangles, view)
        order = np.lexsort((found, pixel))
        pixel, found = pixel[order], found[order]
        number = np.arange(len(pixel)) - np.searchsorted(pixel, pixel)
        t = np.full((view.width * view.height, number.max(initial=0) + 1), np.inf)
        t[pixel, number] = found
        with np.errstate(invalid="ignore"):
            t[:, 1:][np.diff(t, axis=1) < SAME * t[:, 1:]] = np.inf
        t = np.sort(t, axis=1)
        return t[:, :max(1, int(np.isfinite(t).sum(axis=1).max()))]

    def rgba(self, view):
        """Premultiplied, one per ray."""
        color = np.broadcast_to(self.color, (view.height, view.width, 3)).reshape(-1, 3)
        return np.concatenate([color, np.ones((len(color), 1))], axis=1) * self.opacity


def composite(volumes, view, layers, opaque=None, background=(0, 0, 0)):
    """The picture (height, width, 3). volumes: (cells, transfer) pairs, or functions of (view, begin, end) that return light, each laid over
    those before it; opaque: (triangles, colour)."""
    end, under = np.full(view.width * view.height, np.inf), np.asarray(background, float)
    if opaque:
        end = reference.opaque_distance(opaque[0], view)
        under = np.where(np.isfinite(end)[:, None], opaque[1], background)
    hits = [layer.hits(view) for layer in layers]
    t = np.concatenate(hits + [np.full((len(end), 1), np.inf)], axis=1)
    owner = np.concatenate([np.full(h.shape[1], i) for i, h in enumerate(hits)] + [[-1]]).astype(int)
    order = np.argsort(t, axis=1, kind="stable")
    t, owner = np.minimum(np.take_along_axis(t, order, 1), end[:, None]), owner[order]
    colors = [layer.rgba(view) for layer in layers]
    total, begin = np.zeros((len(end), 4)), np.full(len(end), -np.inf)
    for k in range(t.shape[1]):
        total = _under(total, _between(volumes, view, begin, t[:, k]))
        surface = np.zeros((len(end), 4))
        for i, color in enumerate(colors):
            surface = np.where(((owner[:, k] == i) & (t[:, k] < end))[:, None], color, surface)
        total, begin = _under(total, surface), t[:, k]
    return (total[:, :3] + (1 - total[:, 3:]) * under).reshape(view.height, view.width, 3)


def _between(volumes, view, begin, end):
    total = np.zeros((view.width * view.height, 4))
    if not (begin < end).any():
        return total
    for volume in volumes:
        light = volume(view, begin, end) if callable(volume) else reference.render(volume[0], view, volume[1], end, begin=begin)
        light = light.reshape(-1, 4)
        total = light + (1 - light[:, 3:]) * total
    return total


def _under(upper, lower):
    return upper + (1 - upper[:, 3:]) * lower
