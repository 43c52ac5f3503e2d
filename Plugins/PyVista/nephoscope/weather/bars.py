# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar bars of first pictures: labels with as many digits as the range needs, and room for them in small windows."""
from __future__ import annotations

import textwrap

import numpy as np
import pyvista
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

from .._bars import title_in
from .view import size_of

RIGHT = 0.885  # left edge of an upright bar in a window that has room beside it, as a share of the width
EDGE = 6  # pixels between text and the edge of the window
NARROWEST = 26  # pixels of a bar with its labels' gap
PARTS = 0.05  # of the distance between labels: the greatest rounding of a label


def label_format(low: float, high: float, count: int) -> str:
    """The format (of C) with the fewest digits that round `count` even values from `low` to `high` by less than a twentieth of their distance."""
    values = np.linspace(low, high, max(count, 2))
    step, greatest = abs(high - low) / (len(values) - 1), float(np.abs(values).max())
    if not np.isfinite(step) or step == 0:
        return "%-#6.3g"  # PyVista's
    kind, least = ("f", 0) if 1e-3 <= greatest < 1e6 else ("e", 1)
    formats = [f"%.{digits}{kind}" for digits in range(least, 12)]
    return next((text for text in formats if np.abs([float(text % value) - value for value in values]).max() <= PARTS * step), formats[-1])


def finish_bars(plotter: pyvista.BasePlotter, title) -> None:
    """Titles, labels and places of all scalar bars; upright ones may take room from the picture beside them. `title`: of the name of an array."""
    for key, bar in plotter.scalar_bars.items():
        if bar.GetTitle() != title_in(key) or not plotter.renderer.HasViewProp(bar):  # it is finished, or another sub-plot's
            continue
        set_title(bar, title(title_in(key)))
        table = bar.GetLookupTable()
        count, logarithmic = bar.GetNumberOfLabels(), bool(table.UsingLogScale())
        if not logarithmic:
            bar.SetLabelFormat(label_format(*table.GetRange(), count))
        widest = max(_width(plotter, bar.GetLabelTextProperty(), text) for text in _labels(bar, logarithmic))
        (_fit_upright if bar.GetOrientation() else _fit_lying)(plotter, bar, widest)


def _labels(bar: vtkScalarBarActor, logarithmic: bool) -> list[str]:
    low, high = bar.GetLookupTable().GetRange()
    values = (np.geomspace if logarithmic and low > 0 else np.linspace)(low, high, max(bar.GetNumberOfLabels(), 2))
    return [bar.GetLabelFormat() % value for value in values]


def _fit_upright(plotter: pyvista.BasePlotter, bar: vtkScalarBarActor, widest: float) -> None:
    """Moves the bar to the left as far as its labels and its title need."""
    across = size_of(plotter)[0]
    width = max(bar.GetWidth(), NARROWEST / across)
    title = max(_width(plotter, bar.GetTitleTextProperty(), line) for line in bar.GetTitle().split("\n"))
    needed = 0.5 * width * across + max(widest + 4, 0.5 * title) + EDGE
    left = min(RIGHT, 1 - needed / across)
    bar.SetWidth(width)
    bar.SetPosition(max(left, 0.3), bar.GetPosition()[1])


def _fit_lying(plotter: pyvista.BasePlotter, bar: vtkScalarBarActor, widest: float) -> None:
    """As few labels as stand side by side."""
    room = bar.GetWidth() * size_of(plotter)[0]
    most = 1 + int(room / (1.3 * widest + 1))
    if most < bar.GetNumberOfLabels():
        bar.SetNumberOfLabels(max(2, most))


def fit_in_subplot(plotter: pyvista.BasePlotter, bar: vtkScalarBarActor) -> None:
    """As few labels of a lying bar as stand side by side in a sub-plot, and the last one inside it."""
    if bar.GetOrientation() or bar.GetLookupTable() is None:
        return
    widest = max(_width(plotter, bar.GetLabelTextProperty(), text.strip()) for text in _labels(bar, bool(bar.GetLookupTable().UsingLogScale())))
    _fit_lying(plotter, bar, widest)
    left, bottom = bar.GetPosition()
    beyond = left + bar.GetWidth() - 1 + (0.5 * widest + EDGE) / size_of(plotter)[0]
    if beyond > 0:
        bar.SetPosition(max(left - beyond, 0.0), bottom)


def _width(plotter: pyvista.BasePlotter, prop: vtkTextProperty, text: str) -> float:
    """Pixels."""
    box = [0, 0, 0, 0]
    vtkTextRenderer.GetInstance().GetBoundingBox(prop, text, box, plotter.render_window.GetDPI())
    return float(box[1] - box[0])


def make_room(plotter: pyvista.BasePlotter, as_high: bool) -> None:
    """Moves the picture to the left of the upright bars, and makes it smaller, if they have taken its room. `as_high`: it is as wide as it is high, whatever the window is."""
    left = min((bar.GetPosition()[0] for bar in plotter.scalar_bars.values() if bar.GetOrientation() and plotter.renderer.HasViewProp(bar)), default=RIGHT)
    across, high = size_of(plotter)
    if left < RIGHT - 0.005:
        plotter.camera.SetWindowCenter(max(1 - left, plotter.camera.GetWindowCenter()[0]), 0)
    share = left / RIGHT * (across / high if as_high else 1.0)
    if share < 0.99:
        plotter.camera.zoom(0.96 * share)
        plotter.reset_camera_clipping_range()


def set_title(bar: vtkScalarBarActor, text: str) -> None:
    """In short lines above an upright bar, in one line above a lying one."""
    text, _, note = text.partition("\n")
    if not bar.GetOrientation():
        text = f"{text}, {note}" if note else text
        bar.SetTitle(f"{textwrap.shorten(text, 60)}\n ")
        bar.SetBarRatio(0.25)
        return
    name, bracket, units = text.partition(" [")
    bar.SetTitle("\n".join([*textwrap.wrap(name, 14), *["[" + units] * bool(bracket), *[note] * bool(note)]))
    bar.SetVerticalTitleSeparation(10)  # pixels: the title is not on the upper label
