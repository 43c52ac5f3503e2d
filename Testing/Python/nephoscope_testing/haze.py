# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Haze by quadrature along every ray, in double precision: density exp(-h / H), nothing analytic."""
from dataclasses import dataclass

import numpy as np


@dataclass
class Haze:
    """radius None: flat ground at 0 along up. Lengths are those of the scene; scale_height is that of the scene too."""
    extinction: float
    scale_height: float
    radius: float = None
    center: tuple = (0, 0, 0)
    up: tuple = (0, 0, 1)
    base: float = 0.0
    color: tuple = (0.72, 0.8, 0.9)

    def altitude(self, points):
        if self.radius is None:
            return points @ (np.asarray(self.up, float) / np.linalg.norm(self.up)) - self.base
        return np.linalg.norm(points - np.asarray(self.center, float), axis=-1) - self.radius

    def transparency(self, origins, directions, lengths, pieces=120):
        """T from the origins over lengths along unit directions: Gauss-Legendre of 4 points in pieces that are finer near both ends."""
        nodes, weights = np.polynomial.legendre.leggauss(4)
        edges = 0.5 - 0.5 * np.cos(np.pi * np.linspace(0, 1, pieces + 1))
        lengths = np.nan_to_num(np.asarray(lengths, float), posinf=0)
        total = np.zeros(len(lengths))
        for low, high in zip(edges[:-1], edges[1:]):
            for node, weight in zip(nodes, weights):
                t = 0.5 * (low + high) + 0.5 * (high - low) * node
                h = self.altitude(origins + (t * lengths)[:, None] * directions)
                total += 0.5 * (high - low) * weight * np.exp(np.minimum(-h / self.scale_height, 20))
        return np.exp(-self.extinction * lengths * total)

    def over(self, colors, transparency):
        """What is left of colours (n, 3) behind the air, and the air's own light."""
        t = np.asarray(transparency)[..., None]
        return t * colors + (1 - t) * np.asarray(self.color)

    def make(self, cls):
        """The same as a vtkHaze (cls)."""
        haze = cls()
        haze.SetExtinction(self.extinction)
        haze.SetScaleHeight(self.scale_height)
        haze.SetColor(*self.color)
        if self.radius is None:
            haze.SetProjectionToMap()
            haze.SetUpDirection(*self.up)
            haze.SetBaseLevel(self.base)
        else:
            haze.SetPlanetRadius(self.radius)
            haze.SetCenter(*self.center)
        return haze
