# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The media that are in a view already: their colours and extinctions, to which what is added is suited."""
from __future__ import annotations

from typing import Any

import numpy as np
import pyvista

SAMPLES = 64  # of the colours and opacities of a medium


def is_drawn(opacity: Any) -> bool:
    node = [0.0] * 4
    return any(opacity.GetNodeValue(i, node) and node[1] > 0 for i in range(opacity.GetSize()))


def media_in_view(plotter: pyvista.BasePlotter) -> list[Any]:
    """The visible volumes of the active renderer that are not transparent everywhere."""
    return [volume for volume in plotter.renderer.GetVolumes() if volume.GetVisibility() and is_drawn(volume.GetProperty().GetScalarOpacity())]


def colours_of(medium: Any) -> np.ndarray:
    """Even samples of the colours of a volume property, shape (64, 3)."""
    function = medium.GetRGBTransferFunction() if medium.GetColorChannels() == 3 else None
    values = np.linspace(*(function or medium.GetGrayTransferFunction()).GetRange(), SAMPLES)
    return np.array([function.GetColor(value) if function else [medium.GetGrayTransferFunction().GetValue(value)] * 3 for value in values])


def vector_colours(plotter: pyvista.BasePlotter) -> list[Any]:
    """The colour of the vectors of each visible volume of splats in the active renderer that has one for them."""
    mappers = [volume.GetMapper() for volume in plotter.renderer.GetVolumes() if volume.GetVisibility()]
    return [mapper.GetVectorColor() for mapper in mappers if getattr(mapper, "GetVectorArrayName", bool)() and mapper.GetUseVectorColor()]


def extinction_at(media: list[Any], bounds: Any) -> float:
    """The greatest extinctions of those volumes whose bounds overlap with `bounds`, together, per unit of length."""
    low, high = np.reshape(bounds, (3, 2)).T
    total = 0.0
    for volume in media:
        least, most = np.reshape(volume.GetBounds(), (3, 2)).T
        if np.all(least < high) and np.all(low < most):
            medium, scale = volume.GetProperty(), getattr(volume.GetMapper(), "GetOpacityScale", lambda: 1.0)()
            function = medium.GetScalarOpacity()
            total += scale * max(function.GetValue(value) for value in np.linspace(*function.GetRange(), SAMPLES)) / medium.GetScalarOpacityUnitDistance()
    return total
