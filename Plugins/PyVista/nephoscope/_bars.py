# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scalar bars of sub-plots. PyVista has one bar for each title, in the sub-plot that had it first, and its range is that of all sub-plots; here each sub-plot has its own."""
from __future__ import annotations

from typing import Any

import pyvista

SEPARATE = "_UNIQUE_ID_"  # between title and number of the sub-plot, as PyVista's option unique_bar writes it


def key_of(plotter: pyvista.BasePlotter, title: str) -> str:
    """The key in ``plotter.scalar_bars`` of the active sub-plot's bar with this title: the title, if no other sub-plot has such a bar."""
    bars = plotter.scalar_bars
    return title if title not in bars or plotter.renderer.HasViewProp(bars[title]) else f"{title}{SEPARATE}{plotter.renderers.active_index}"


def title_in(key: str) -> str:
    """The title that a key begins with."""
    return key.partition(SEPARATE)[0]


def add_bar(plotter: pyvista.BasePlotter, title: str, **options: Any) -> Any:
    """`pyvista.Plotter.add_scalar_bar`: the bar, or None if the sub-plot has one of this title, which then has the range of both."""
    bar = plotter.add_scalar_bar(title=key_of(plotter, title), **options)
    if bar is not None:
        bar.SetTitle(title)
        _fit(plotter, bar, options)
    return bar


def _fit(plotter: pyvista.BasePlotter, bar: Any, options: dict[str, Any]) -> None:
    """Labels that stand side by side in a sub-plot, unless the user has placed or counted them."""
    if plotter.shape != (1, 1) and not {"n_labels", "position_x", "width"} & set(options):
        from .weather.bars import fit_in_subplot
        fit_in_subplot(plotter, bar)


def add_mesh(plotter: pyvista.BasePlotter, mesh: Any, title: str, **options: Any) -> pyvista.Actor:
    """`pyvista.Plotter.add_mesh`. `title`: that of the scalar bar, unless ``scalar_bar_args`` has one."""
    arguments = {"title": title, **(options.pop("scalar_bar_args", None) or {})}
    told, before = arguments["title"], set(plotter.scalar_bars.keys())
    arguments["title"] = key = key_of(plotter, told)
    actor = plotter.add_mesh(mesh, **options, scalar_bar_args=arguments)
    if key not in before and key in plotter.scalar_bars:
        plotter.scalar_bars[key].SetTitle(told)
        _fit(plotter, plotter.scalar_bars[key], arguments)
    return actor
