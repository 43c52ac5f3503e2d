# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Piecewise-linear transfer functions, evaluated here by numpy and handed to VTK as a volume property."""
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty


class Transfer:
    """colors: rows (scalar, r, g, b); opacities: rows (scalar, extinction per unit distance).

    Extinction per unit world length = opacity(s) * opacity_scale / unit_distance.
    """

    def __init__(self, colors, opacities, unit_distance=1.0, opacity_scale=1.0):
        self.colors = np.asarray(colors, float).reshape(-1, 4)
        self.opacities = np.asarray(opacities, float).reshape(-1, 2)
        self.unit_distance = unit_distance
        self.opacity_scale = opacity_scale

    @property
    def breakpoints(self):
        return np.unique(np.concatenate([self.colors[:, 0], self.opacities[:, 0]]))

    def extinction(self, s):
        rate = np.interp(s, self.opacities[:, 0], self.opacities[:, 1])
        return rate * (self.opacity_scale / self.unit_distance)

    def color(self, s):
        return np.stack([np.interp(s, self.colors[:, 0], self.colors[:, 1 + k]) for k in range(3)], axis=-1)

    def volume_property(self):
        color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
        for row in self.colors:
            color.AddRGBPoint(*row)
        for row in self.opacities:
            opacity.AddPoint(*row)
        prop = vtkVolumeProperty()
        prop.SetColor(color)
        prop.SetScalarOpacity(opacity)
        prop.SetScalarOpacityUnitDistance(self.unit_distance)
        prop.SetInterpolationTypeToLinear()
        prop.ShadeOff()
        return prop


def constant(extinction=1.0, color=(1.0, 1.0, 1.0)):
    return Transfer([(0.0, *color), (1.0, *color)], [(0.0, extinction), (1.0, extinction)])


def random_transfer(rng, points=5, low=0.0, high=1.0, max_extinction=1.0):
    """Several control points; the first and last lie on the range, opacity and colour at different scalars."""
    inner = lambda n: np.sort(rng.uniform(low, high, n - 2))
    colors_at = np.concatenate([[low], inner(points), [high]])
    opacities_at = np.concatenate([[low], inner(points), [high]])
    return Transfer(np.column_stack([colors_at, rng.uniform(0, 1, (points, 3))]),
                    np.column_stack([opacities_at, rng.uniform(0, max_extinction, points)]))
