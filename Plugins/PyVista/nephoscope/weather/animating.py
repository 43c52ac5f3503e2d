# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A series in a plotter: a slider of time, or a film."""
from __future__ import annotations

import re
import warnings
from inspect import signature
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

from .._checks import listed, require_number
from .._film_camera import is_framed, look_at_all_steps
from .._film_motion import motion
from .._options import refuse_unknown
from .._pipeline import level_of_caller
from .accessor import GLOBE, LOOK, WeatherAccessor
from .dataset_series import DatasetSeries
from .filled import filled
from .filming import write_film
from .forms import form_of
from .mesh_series import MeshSeries, is_meshes, mesh_series
from .naming import word
from .one_level import part_of
from .reduced_series import ReducedSeries
from .section_series import SectionSeries
from .sections import is_section
from .series import Series

LABEL = "nephoscope_time"  # name of the actor
UPPER_LEFT = 2  # vtkCornerAnnotation
MOST_FRAMES = 100.0  # in a second: a GIF counts hundredths
ROWS = (0.9, 0.74, 0.58, 0.42)  # heights of sliders in a renderer


def animate(plotter: pyvista.BasePlotter, dataset: Any, draw: str | Callable[[Any, Any], Any], *, filename: str | Path | None = None,
            times: Any = None, framerate: float = 8.0, heights: bool = False, show_time: bool = True, progress: bool = True, **options: Any) -> Series:
    """Draw the time steps of a dataset, or meshes of several times: with a slider in the window, or as a film in a file.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter to draw in, its active sub-plot; its other contents stay. Each animation has its own time and its own slider. In a plotter that is empty and has PyVista's defaults, a field is drawn as ``dataset.nephoscope.plot`` does:
        over the Earth or a map, on a dark background, with its vertical exaggeration unless you give one; flat, if x and y are lengths.
    dataset : xarray.Dataset, Series, str, sequence or dict of pyvista.DataSet, or callable
        The weather, its series (``dataset.nephoscope.series()``), or what `nephoscope.open` takes. Or PyVista meshes of one type: a list, a dict by time, or a
        function that takes one of `times` and returns the mesh. They are not changed. A mesh may be a MultiBlock, such as an OpenFOAM case: its blocks become one mesh,
        without boundary patches. A mesh may also be the path of a file that `pyvista.read` reads; files are read when they are shown. One path may be that of a
        file with several times (``"case.foam"``, ``"case.pvd"``), or a pattern (``"case_*.vtu"``), whose files are taken in the order of their names.
        A mesh without points, such as smoke at the time of its release, draws nothing; `draw` gets the first mesh with points.
        If the meshes move or grow, the camera sees all steps, unless you have set a camera.
    draw : str or callable
        A variable or a quantity to compute, as in ``dataset.nephoscope.plot``, drawn by `add_cells`; or a function ``draw(plotter, mesh)`` that is called once and adds what you
        want to draw. The values of the mesh change with the time; of PyVista meshes, points and cells too. Colours and opacities stay the same: their range covers all steps (a sample of 50 if there are more), unless
        you give limits with ``clim``. So do the ``maximum_speed`` and the ``unit`` of the `vectors` of `add_splats`, whose streaks move from step to step, even on meshes that
        do not change: the fastest by at most their distance in a second of the film, or by ``true_speed``. A ``phase`` or ``film_time`` that you set is kept.
        Data that the function derives from the mesh, such as light, slices or smoke, stay the same in all steps, and a warning says so: derive them from each mesh first.
    filename : str or pathlib.Path, optional
        A film: ``.gif`` (needs Pillow), ``.mp4`` (needs the program ffmpeg, on the path or of the package imageio-ffmpeg), or a folder for PNG pictures. Default: a slider of time.
        Until the film is complete its frames are in the folder ``<filename>.frames`` next to it, or in the folder for PNG pictures itself. After an interruption the same call continues from there. It draws the newest of these
        frames once more, and starts again if this differs from the one that was kept, or if the options, the times, the size of the window or the data differ. Files are compared by
        their size and time, meshes in memory by their values, functions only by what they draw in that frame. To start again in any case, remove the folder.
    times : sequence, optional
        Of PyVista meshes: their times as numbers, dates or words, which are written into the picture. Default: their numbers.
        Numbers and dates, also as the keys of a dict, are sorted, and the meshes with them.
    framerate : float, default: 8.0
        Time steps per second of the film, greater than 0 and at most 100.
    heights : bool, default: False
        Move the points with the heights of each step. By default they keep their positions of the first step, and only values are uploaded.
    show_time : bool, default: True
        Write the time into the picture.
    progress : bool, default: True
        Print the progress of the film in the terminal.
    **options
        Those of ``dataset.nephoscope.globe`` or ``dataset.nephoscope.grid``, and for a field ``clim``, ``cmap``, ``opacity`` and ``log_scale`` of `add_cells`.

    Returns
    -------
    Series
        The series: ``len``, ``times``, ``seconds``, ``mesh``, ``range(name)``, ``show(step)``, ``close()`` and, by index, the mesh of each step; of PyVista meshes also
        ``bounds``, those of all steps.

    Raises
    ------
    TypeError
        If `dataset` is a single mesh, its meshes are of several types, or an option does not exist.
    pyvista.core.errors.MissingDataError
        (a ValueError) If none of the meshes has the array `draw`, or if `draw` is a function and the first mesh with points lacks an array that is drawn.
    ValueError
        If there are no meshes, or the file name has any other ending. RuntimeError If ffmpeg is missing or fails.
    OSError
        If a frame or the film cannot be written, as on a full disk: the message names the file, the free space and the space needed. If none of the time steps can be read.
    KeyboardInterrupt
        If Control-C is pressed; the message says how many frames are kept.

    Warns
    -----
    RuntimeWarning
        For each time step that cannot be read, or lacks an array that is drawn, with its file: the picture of the step before is shown instead; before the first
        step that can be drawn, the picture of that step.
    """
    from .picture import darken, is_untouched
    require_number(framerate, "framerate", above=0, most=MOST_FRAMES)
    if getattr(plotter, "render_window", None) is None:
        raise ValueError("plotter has been closed; make a new one.")
    draw = draw if draw is None or callable(draw) else word(draw)
    asked = re.sub(" at 0x[0-9a-f]+", "", repr([None if callable(draw) else draw, heights, show_time, sorted(options.items())]))  # which is the same in another process
    whole = isinstance(draw, str) and is_untouched(plotter)
    look = _look(draw, options)
    series, draw = _series(plotter, dataset, draw, heights, options, whole, times, look)
    whole = whole and not isinstance(series, MeshSeries)
    before = set(plotter.renderer.actors)
    if isinstance(series, MeshSeries):
        _draw_meshes(plotter, series, draw, look, before)
    elif callable(draw):
        _drawn(plotter, series, draw)
        _warn_of_derived(plotter, series, before)
    elif whole:
        darken(plotter)
        first = _first_picture(series, draw, look)  # which has the limits of all steps, but for logarithmic colours
        _drawn(plotter, series, first) if look.get("log_scale") else first(plotter, series.mesh)
    else:
        from ..cells import add_cells
        add_cells(plotter, series.mesh, draw, **look)
    _suit_to_all_steps(plotter, series, before, framerate)
    colour = "white" if np.mean(plotter.background_color.float_rgb) < 0.5 else "black"
    if show_time:
        _add_label(plotter, series, colour)

    def turn_to(step: float) -> None:
        found = series.drawable(int(round(step)))
        if found is not None:
            series.put(int(round(step)), found)
        plotter.renderer.ResetCameraClippingRange()
        plotter.render()

    if filename is not None:
        write_film(plotter, series, turn_to, Path(filename), framerate, progress, asked)
        return series
    turn_to(0)
    if len(series) > 1:
        _add_slider(plotter, series, turn_to, colour)
    return series


def _series(plotter: pyvista.BasePlotter, dataset: Any, draw: Any, heights: bool, options: dict, whole: bool, times: Any, look: dict) -> tuple[Series, Any]:
    """The series, and the array that is drawn. `whole`: of the whole picture; heights are exaggerated as suits it, unless the options say how, and a section lies in the plane of the picture."""
    if is_meshes(dataset):
        _refuse(options, heights, "the meshes exist already, so they cannot take these options.")
        return mesh_series(dataset, times, draw if isinstance(draw, str) else None), draw
    if times is not None:
        raise TypeError("times is given, but dataset is weather, which has its own times.")
    if isinstance(dataset, Series):
        _refuse(options, heights, "the series exists already, so it cannot take these options. Give them to dataset.nephoscope.series(...).")
        return dataset, draw
    from .opening import open as opened
    found = opened(dataset)
    part = part_of(found.nephoscope._dataset, draw if isinstance(draw, str) else None, 0, options)
    if isinstance(draw, str):
        draw, options = part.nephoscope._of_field(draw, 0, options)
    if whole and "vertical_exaggeration" not in options:
        options = {"vertical_exaggeration": part.nephoscope._exaggeration(options), **options}
    options = {"heights": heights, "owned": found is not dataset, **options}
    series = DatasetSeries(part, **options)
    if isinstance(draw, str) and (levels := _on_levels_of(draw, part, series.mesh, options)) is not None:
        series.stop()
        part, series = levels, DatasetSeries(levels, **options)
    if not whole:
        return series, draw
    form = form_of(series.mesh, draw, look)
    if is_section(series.mesh):
        series.stop()
        from .flat_picture import shape_of_section
        return SectionSeries(part, form, shape_of_section(plotter), **options), draw
    if form is not None:
        series.stop()
        return ReducedSeries(part, form, **options), draw
    return series, draw


def _on_levels_of(name: str, dataset: Any, grid: pyvista.DataSet, options: dict) -> Any:
    """The dataset on the levels where the field has values at the first step with any values, as `plot` draws it. None if these are all levels. `grid`: the mesh of the first step."""
    found = filled(dataset, grid, name, None, options) if "GlobeGridProjection" in grid.field_data else None
    if found is not None and found.time is not None:
        found = filled(dataset, grid, name, found.time, options)
    return None if found is None else found.dataset


def _refuse(options: dict, heights: bool, reason: str) -> None:
    """Raises TypeError for options of a mesh that is made, of `add_cells`, or of nothing."""
    from ..globe import to_globe
    from .roles import ROLES
    known = {*GLOBE, *ROLES, *signature(to_globe).parameters, *signature(WeatherAccessor.grid).parameters}
    making = [name for name in options if name in known]
    if making or heights:
        raise TypeError(f"{', '.join([*making, *['heights'] * heights])}: {reason}")
    from ..cells import add_cells
    from ..splats import add_splats
    for function in (add_cells, add_splats):
        drawing = [name for name in options if name in signature(function).parameters]
        if drawing:
            name = function.__name__
            takes = f"; of those of add_cells it takes {listed(LOOK)}" if function is add_cells else f", which belongs to {name}"
            raise TypeError(f"animate() has no option {drawing[0]!r}{takes}. Pass a function as draw: "
                            f"lambda plotter, mesh: nephoscope.{name}(plotter, mesh, ..., {drawing[0]}=...).")
    refuse_unknown(animate, options, LOOK)


def _look(draw: Any, options: dict) -> dict:
    """Takes the options of `add_cells` for the look of a field out of `options`."""
    look = {name: options.pop(name) for name in LOOK if name in options}
    if look and callable(draw):
        raise TypeError(f"{next(iter(look))}: an option for the field that animate draws, but draw is a function. Use it there.")
    if "sun" in options:
        raise TypeError("animate() has no option 'sun': the light would stay that of the first step. Draw the steps one by one: for mesh in dataset.nephoscope.series(): ...")
    return look


def _first_picture(series: Series, name: str, look: dict) -> Callable:
    from .naming import title
    from .flat_picture import draw_flat, draw_section
    from .picture import draw as draw_globe
    from .picture import refuse_sections
    on_earth = "GlobeGridProjection" in series.mesh.field_data
    if isinstance(series, SectionSeries):
        return lambda plotter, mesh: draw_section(plotter, mesh, series.scales, name, look, lambda array: title(series._dataset, mesh, array))
    if on_earth:
        refuse_sections(series.mesh)
    draw = draw_globe if on_earth else draw_flat
    return lambda plotter, mesh: draw(plotter, mesh, name, look, lambda array: title(series._dataset, mesh, array))


def _drawn(plotter: pyvista.BasePlotter, series: Series, draw: Callable) -> None:
    """Calls `draw`. Without limits, PyVista's own mappers use the range of the step on display; this gives them the range of all steps."""
    before = set(plotter.renderer.actors)
    draw(plotter, series.mesh)
    for name in set(plotter.renderer.actors) - before:
        mapper = getattr(plotter.renderer.actors[name], "mapper", None)
        array = getattr(mapper, "array_name", None)
        if isinstance(mapper, pyvista.DataSetMapper) and array in series.mesh.array_names and np.allclose(mapper.scalar_range, series.mesh.get_data_range(array)):
            mapper.scalar_range = series.range(array)


def _draw_meshes(plotter: pyvista.BasePlotter, series: MeshSeries, draw: Any, look: dict, before: set[str]) -> None:
    """Draws the mesh of a step, and says of which if it lacks an array."""
    from ..cells import add_cells
    try:
        if not callable(draw):
            add_cells(plotter, series.mesh, draw, **look)
            return
        _drawn(plotter, series, draw)
    except MissingDataError as problem:
        raise MissingDataError(f"{problem} The mesh is that of {_lower(series.told(series.step))}.") from problem
    _warn_of_derived(plotter, series, before)


def _lower(words: str) -> str:
    return words[:1].lower() + words[1:]


def _warn_of_derived(plotter: pyvista.BasePlotter, series: Series, before: set[str]) -> None:
    """What `draw` has derived from the mesh of one step stays as it is in all steps: light, slices, smoke."""
    for name in set(plotter.renderer.actors) - before:
        data = getattr(getattr(plotter.renderer.actors[name], "mapper", None), "dataset", None)
        if isinstance(data, pyvista.DataSet) and _is_derived(data, series.mesh):
            lit = "Sunlight" in data.point_data
            remedy = ("Light each mesh first, mesh.nephoscope.sunlight(...), animate these meshes, and draw them with sun=True." if lit else
                      "Derive it from each mesh first, and animate the results.")
            warnings.warn(f"draw shows {'the light of' if lit else 'data that it derives from'} one step, {name!r}, which stays the same in all steps. {remedy}",
                          UserWarning, stacklevel=level_of_caller())
            return


def _is_derived(data: pyvista.DataSet, mesh: pyvista.DataSet) -> bool:
    """Whether data that have arrays of a mesh do not change with it."""
    if "Sunlight" in data.point_data and "Sunlight" not in mesh.point_data:
        return True
    pairs = [(here[name], there[name]) for here, there in ((data.point_data, mesh.point_data), (data.cell_data, mesh.cell_data)) for name in here.keys() if name in there]
    return bool(pairs) and not any(np.may_share_memory(*pair) for pair in pairs)


def _suit_to_all_steps(plotter: pyvista.BasePlotter, series: Series, before: set[str], framerate: float) -> None:
    """The camera sees the meshes of all steps, and the vectors that have been drawn, those of no actor in `before`, move from step to step."""
    renderer = plotter.renderer
    of_meshes = isinstance(series, MeshSeries)
    if not renderer.camera.is_set and (series.step > 0 or of_meshes and series.moves) or is_framed(plotter):
        look_at_all_steps(plotter, *((series.bounds, series.growth) if of_meshes else (series.mesh.bounds,)))
    if of_meshes:
        series.listen(lambda _: series.moved and renderer.ResetCameraClippingRange())
    move = motion([actor for name, actor in renderer.actors.items() if name not in before], framerate)
    if move is not None:
        series.listen(move)


def _add_label(plotter: pyvista.BasePlotter, series: Series, colour: str) -> None:
    """Writes the time into the active renderer, below the times of other animations there."""
    above = 0
    while (name := f"{LABEL}_{above + 1}" if above else LABEL) in plotter.renderer.actors:
        above += 1
    told = ["\n" * above + time for time in series.times]
    text = plotter.add_text(told[series.step], name=name, font_size=10, position="upper_left", color=colour, render=False)
    series.listen(lambda step: text.SetText(UPPER_LEFT, told[step]))


def _row(plotter: pyvista.BasePlotter) -> float:
    """The height of a slider in the active renderer, as a fraction of its height: at the top, or below other sliders there."""
    _, bottom, _, top = plotter.renderer.GetViewport()
    sliders = getattr(plotter, "widgets", plotter).slider_widgets
    others = [one.GetRepresentation().GetPoint1Coordinate().GetValue()[1] / (top - bottom) for one in sliders if one.GetCurrentRenderer() is plotter.renderer]
    return next((row for row in ROWS if all(abs(row - other) > 0.05 for other in others)), ROWS[0])


def _add_slider(plotter: pyvista.BasePlotter, series: Series, turn_to: Callable[[float], None], colour: str) -> None:
    """Adds the slider, whose label is the date, also while you drag it."""
    height = _row(plotter)
    slider = plotter.add_slider_widget(turn_to, [0, len(series) - 1], value=series.step, title="time", fmt=series.times[series.step], color=colour, interaction_event="end",
                                       pointa=(0.4, height), pointb=(0.9, height))
    shown = slider.GetRepresentation()

    def label(*_: Any) -> None:
        shown.SetLabelFormat(series.times[int(round(shown.GetValue()))])

    def move(step: int) -> None:
        shown.SetValue(step)
        label()

    slider.AddObserver("InteractionEvent", label)
    series.listen(move)
