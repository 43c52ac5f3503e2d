# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar bars of first pictures: labels with as many digits as the range needs, room for them in small windows and next to other bars, and one range for fields that are compared."""
from __future__ import annotations

import re
import textwrap
from typing import Any, Callable
from weakref import WeakKeyDictionary

import numpy as np
import pyvista
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

from .._bars import title_in
from .._fields import is_bright
from .._medium import text_colour
from .view import size_of

FONTS = {"title_font_size": 14, "label_font_size": 12}
BESIDE = {"vertical": True, "position_x": 0.885, "position_y": 0.3, "width": 0.06, "height": 0.4, "n_labels": 4, **FONTS}  # the globe
BELOW = {"vertical": False, "position_x": 0.25, "position_y": 0.02, "width": 0.5, "height": 0.09, "n_labels": 4, **FONTS}  # the map
SHARED = (0.06, 0.94)  # room for several bars, as fractions of the height of the picture (upright bars) or of its width (horizontal bars)
GAP = (0.03, 0.08)  # between upright bars, between horizontal bars; fractions likewise
ALIKE = 0.5  # fields with one title have one range if more than this fraction of the whole range is common to both
RIGHT = 0.885  # left edge of an upright bar in a window that has room beside it, as a share of the width
EDGE = 6  # pixels between text and the edge of the window
NARROWEST = 26  # pixels of a bar with its labels' gap
LONGEST_WORD = 20  # letters of a word that fits undivided above an upright bar
PAPER = 0.8  # opacity behind dark text
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


_finished: WeakKeyDictionary[vtkScalarBarActor, str | None] = WeakKeyDictionary()  # title of each finished bar; None if its range was given


def bars_in(plotter: pyvista.BasePlotter) -> list[vtkScalarBarActor]:
    """The scalar bars of the active sub-plot."""
    return [bar for bar in plotter.scalar_bars.values() if plotter.renderer.HasViewProp(bar)]


def finish_bars(plotter: pyvista.BasePlotter, before: list[vtkScalarBarActor], title: Callable[[str], str], clim: Any = None) -> None:
    """Sets titles, labels and positions of the scalar bars of a sub-plot that were not there `before`. Upright bars may take room from the picture next to them. `title`: makes a title from the name of an array.
    `clim`: the range, if one was given."""
    for key, bar in plotter.scalar_bars.items():
        if bar in before or not plotter.renderer.HasViewProp(bar):
            continue
        text = title(title_in(key))
        set_title(bar, text)
        _make_readable(plotter, bar)
        _label(bar)
        if clim is None:
            _share_range(plotter, key, bar, text)
        _finished[bar] = text if clim is None else None
    ours = [bar for bar in bars_in(plotter) if bar in _finished]
    for upright in (0, 1):
        alike = [bar for bar in bars_in(plotter) if bar.GetOrientation() == upright and (bar in ours or any(_overlap(bar, other) for other in ours))]
        if len(alike) > 1:
            _place_side_by_side(alike, upright)
        for bar in alike:
            widest = max(_width(plotter, bar.GetLabelTextProperty(), label) for label in _labels(bar, bool(bar.GetLookupTable().UsingLogScale())))
            (_fit_upright if upright else _fit_lying)(plotter, bar, widest)


def _make_readable(plotter: pyvista.BasePlotter, bar: vtkScalarBarActor) -> None:
    """Gives text a colour that stands out from the background. Dark text may lie over the dark globe, so it gets the background's colour behind it."""
    for prop in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        prop.SetColor(text_colour(plotter).float_rgb)
        if is_bright(plotter.background_color):
            prop.SetBackgroundColor(plotter.background_color.float_rgb)
            prop.SetBackgroundOpacity(PAPER)


def _label(bar: vtkScalarBarActor) -> None:
    table = bar.GetLookupTable()
    if not table.UsingLogScale():
        bar.SetLabelFormat(label_format(*table.GetRange(), bar.GetNumberOfLabels()))


def _share_range(plotter: pyvista.BasePlotter, key: str, bar: vtkScalarBarActor, text: str) -> None:
    """Gives fields with one title in several sub-plots, such as those of two times, one range if their ranges are similar. In a common range, others,
    such as temperatures at high and low levels, would have few colours."""
    alike = {key: bar, **{other: one for other, one in plotter.scalar_bars.items() if _finished.get(one) == text and _are_alike(bar.GetLookupTable(), one.GetLookupTable())}}
    ranges = np.array([one.GetLookupTable().GetRange() for one in alike.values()])
    for name, one in alike.items() if len(alike) > 1 else ():
        plotter.update_scalar_bar_range([ranges[:, 0].min(), ranges[:, 1].max()], name)
        _label(one)


def _are_alike(*tables: vtkScalarsToColors) -> bool:
    low, high = np.transpose([table.GetRange() for table in tables])
    return tables[0].UsingLogScale() == tables[1].UsingLogScale() and high.min() - low.max() > ALIKE * (high.max() - low.min())


def _overlap(*bars: vtkScalarBarActor) -> bool:
    low, size = (np.array([tuple(place(bar)) for bar in bars]) for place in (vtkScalarBarActor.GetPosition, vtkScalarBarActor.GetPosition2))
    return bool((low.max(axis=0) < (low + size).min(axis=0)).all())


def _place_side_by_side(bars: list[vtkScalarBarActor], upright: int) -> None:
    """Places upright bars from top to bottom, horizontal bars from left to right."""
    share, gap = (SHARED[1] - SHARED[0]) / len(bars), GAP[0 if upright else 1]
    for number, bar in enumerate(bars):
        if upright:
            bar.SetPosition(bar.GetPosition()[0], SHARED[1] - (number + 1) * share + 0.5 * gap)
            bar.SetHeight(share - gap)
        else:
            bar.SetPosition(SHARED[0] + number * share + 0.5 * gap, bar.GetPosition()[1])
            bar.SetWidth(share - gap)


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


def _short_lines(name: str) -> list[str]:
    """Lines of about 14 letters that end after a word or an underscore. Words are divided only if one is longer than LONGEST_WORD."""
    return [line.replace("_ ", "_") for line in textwrap.wrap(name.replace("_", "_ "), 14, break_long_words=max(map(len, re.split(r"[_\s]", name))) > LONGEST_WORD)]


def set_title(bar: vtkScalarBarActor, text: str) -> None:
    """In short lines above an upright bar, in one line above a lying one."""
    text, _, note = text.partition("\n")
    if not bar.GetOrientation():
        text = f"{text}, {note}" if note else text
        bar.SetTitle(f"{textwrap.shorten(text, 60)}\n ")
        bar.SetBarRatio(0.25)
        return
    name, bracket, units = text.partition(" [")
    bar.SetTitle("\n".join([*_short_lines(name), *["[" + units] * bool(bracket), *[note] * bool(note)]))
    bar.SetVerticalTitleSeparation(10)  # pixels: the title is not on the upper label
