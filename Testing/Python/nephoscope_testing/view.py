# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rays of a camera, from its parameters alone (no projection matrix of VTK is used)."""
import copy

import numpy as np


def _unit(v):
    return v / np.linalg.norm(v)


class View:
    """One ray per pixel centre of a viewport of width x height pixels; row 0 is the bottom row.

    Along a ray, t is world length from the origin (the eye, or a point of the eye's plane when parallel).
    """

    def __init__(self, camera, size):
        self.width, self.height = size
        self.eye = np.array(camera.GetPosition())
        self.forward = _unit(np.array(camera.GetFocalPoint()) - self.eye)
        self.right = _unit(np.cross(self.forward, np.array(camera.GetViewUp())))
        self.up = np.cross(self.right, self.forward)
        self.near, self.far = camera.GetClippingRange()
        self.parallel = bool(camera.GetParallelProjection())
        self.center = np.array(camera.GetWindowCenter())
        half = camera.GetParallelScale() if self.parallel else np.tan(np.radians(camera.GetViewAngle()) / 2)
        if not self.parallel and camera.GetUseHorizontalViewAngle():
            half *= self.height / self.width
        self.half = np.array([half * self.width / self.height, half])

    def rays(self):
        """origins (n,3), unit directions (n,3), t at the near plane (n,), t at the far plane (n,)."""
        x = (2 * (np.arange(self.width) + 0.5) / self.width - 1 + self.center[0]) * self.half[0]
        y = (2 * (np.arange(self.height) + 0.5) / self.height - 1 + self.center[1]) * self.half[1]
        x, y = (a.ravel() for a in np.meshgrid(x, y))
        offset = x[:, None] * self.right + y[:, None] * self.up
        if self.parallel:
            directions = np.broadcast_to(self.forward, offset.shape)
            return self.eye + offset, directions, np.full(len(x), self.near), np.full(len(x), self.far)
        stretch = np.sqrt(1 + x * x + y * y)
        directions = (self.forward + offset) / stretch[:, None]
        return np.broadcast_to(self.eye, offset.shape), directions, self.near * stretch, self.far * stretch

    def shifted(self, x, y):
        """The same view with its pixel centres moved by a fraction of a pixel."""
        other = copy.copy(self)
        other.center = self.center + 2 * np.array([x / self.width, y / self.height])
        return other

    def depth(self, points):
        return (np.asarray(points) - self.eye) @ self.forward

    def pixels(self, points):
        """Continuous pixel coordinates (x, y): pixel i covers [i, i+1]. Points must lie in front of the eye."""
        p = np.asarray(points) - self.eye
        xy = np.stack([p @ self.right, p @ self.up], axis=-1)
        if not self.parallel:
            xy = xy / (p @ self.forward)[..., None]
        return (xy / self.half - self.center + 1) / 2 * (self.width, self.height)
