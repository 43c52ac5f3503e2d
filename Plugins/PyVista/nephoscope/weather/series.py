# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The time steps of a dataset as meshes, and one mesh whose values follow the time: slider, film."""
from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pyvista

from .times import listed_times, seconds_of, time_dims


class Series(Sequence):
    """The meshes of all time steps, each made when it is asked for, and `mesh`, whose values `show` exchanges.

    One worker reads; while a step is looked at it reads the next. Cells and, unless `heights` is True, points of `mesh` stay those of the first step.
    """

    def __init__(self, dataset, *, heights: bool = False, **options: Any) -> None:
        self._dataset, self._options, self._heights = dataset, options, heights
        self._dim = next((dim for dim in time_dims(dataset) if dataset.sizes[dim] > 1), None)
        self._worker, self._coming = ThreadPoolExecutor(1), {}
        self.times = listed_times(dataset) if self._dim in dataset.variables else [str(i) for i in range(len(self))]
        self.mesh = self[0]
        self.step = 0
        self._prefetch(1)

    def __len__(self) -> int:
        return 1 if self._dim is None else self._dataset.sizes[self._dim]

    @property
    def seconds(self) -> np.ndarray:
        """Since the first step; numbers of steps where the dataset has no dates."""
        seconds = seconds_of(self._dataset[self._dim].values) if self._dim in self._dataset.variables else None
        return np.arange(len(self), dtype=float) if seconds is None else seconds

    def __getitem__(self, step):
        if isinstance(step, slice):
            return [self[i] for i in range(*step.indices(len(self)))]
        if not -len(self) <= step < len(self):
            raise IndexError(f"step is {step}; there are {len(self)}.")
        return self._future(step % len(self)).result()

    def at(self, seconds: float) -> pyvista.DataSet:
        """The mesh of the step at `seconds`, as `advect_texture` and `flow_volume` ask for it: ``flow_volume(series.at, times=series.seconds, time=...)``."""
        return self[int(np.argmin(np.abs(self.seconds - seconds)))]

    def _future(self, step: int) -> Future:
        return self._coming.pop(step, None) or self._worker.submit(self._read, step)

    def _read(self, step: int) -> pyvista.DataSet:
        return self._dataset.nephoscope.globe(**({"time": step} if self._dim else {}), **self._options)

    def _prefetch(self, step: int) -> None:
        if step < len(self) and step not in self._coming:
            self._coming = {step: self._worker.submit(self._read, step)}

    def show(self, step: int) -> None:
        """Gives `mesh` the values of a step."""
        found = self[step]
        for here, there in ((self.mesh.point_data, found.point_data), (self.mesh.cell_data, found.cell_data)):
            for name in here.keys():
                if name in there and here[name].shape == there[name].shape:
                    here[name][...] = there[name]
                    here.VTKObject.GetAbstractArray(name).Modified()
        if self._heights:
            self.mesh.points = found.points
        self.mesh.Modified()
        self.step = step % len(self)
        self._prefetch(self.step + 1)


def animate(plotter: pyvista.BasePlotter, dataset: Any, draw: str | Callable[[pyvista.BasePlotter, pyvista.DataSet], Any], *, filename: str | Path | None = None,
            framerate: float = 8.0, heights: bool = False, show_time: bool = True, progress: bool = True, **options: Any) -> Series:
    """Draw the time steps of a dataset: with a slider in the window, or as a film in a file.

    Parameters
    ----------
    plotter : pyvista.Plotter
        The plotter to draw in; what else it shows stays.
    dataset : xarray.Dataset or str
        The weather, or what `nephoscope.open` takes.
    draw : str or callable
        A variable, which is drawn by `add_cells`, or a function ``draw(plotter, mesh)`` that adds what it likes once. The values of the mesh change with the time.
    filename : str or pathlib.Path, optional
        A film: ``.gif`` (needs Pillow), ``.mp4`` (needs the program ffmpeg), or a folder for PNG pictures. Default: a slider of time.
    framerate : float, default: 8.0
        Time steps per second of the film.
    heights : bool, default: False
        Move the points with the heights of each step. By default they stay where they are in the first step, and only values are uploaded.
    show_time : bool, default: True
        Write the time into the picture.
    progress : bool, default: True
        Tell on the terminal how far the film is.
    **options
        Those of ``dataset.nephoscope.globe``.

    Returns
    -------
    Series
        The series: ``len``, ``times``, ``seconds``, ``mesh``, ``show(step)`` and, by index, the mesh of each step.

    Raises
    ------
    ValueError
        If the film's name has another ending. RuntimeError If ffmpeg is missing or fails.
    """
    from .opening import open as opened
    series = Series(opened(dataset), heights=heights, **options)
    if callable(draw):
        draw(plotter, series.mesh)
    else:
        from ..cells import add_cells
        add_cells(plotter, series.mesh, draw)

    readable = "white" if np.mean(plotter.background_color.float_rgb) < 0.5 else "black"

    def turn_to(step: float) -> None:
        series.show(int(round(step)))
        if show_time:
            plotter.add_text(series.times[series.step], name="nephoscope_time", font_size=10, position="upper_left", color=readable, render=False)
        plotter.render()

    if filename is not None:
        _film(plotter, series, turn_to, Path(filename), framerate, progress)
        return series
    turn_to(0)
    if len(series) > 1:
        plotter.add_slider_widget(turn_to, [0, len(series) - 1], value=0, title="time step", fmt="%.0f", color=readable, interaction_event="end")
    return series


def _film(plotter, series: Series, turn_to: Callable[[float], None], path: Path, framerate: float, progress: bool) -> None:
    kind = path.suffix.lower()
    if kind not in (".gif", ".mp4", ""):
        raise ValueError(f"filename is {str(path)!r}; its ending must be .gif or .mp4, or none for a folder of pictures.")
    if kind == ".mp4" and shutil.which("ffmpeg") is None:
        raise RuntimeError("A film in .mp4 needs the program ffmpeg, which is not on the path. Install it, or write a .gif.")
    with tempfile.TemporaryDirectory() as work:
        folder = path if kind == "" else Path(work)
        folder.mkdir(parents=True, exist_ok=True)
        for step in range(len(series)):
            turn_to(step)
            plotter.screenshot(folder / f"{step:05d}.png")
            if progress:
                print(f"\r{step + 1} of {len(series)}: {series.times[step]}", end="\n" if step + 1 == len(series) else "", file=sys.stderr, flush=True)
        if kind == ".gif":
            _gif(folder, path, framerate)
        elif kind == ".mp4":
            _mp4(folder, path, framerate)


def _gif(folder: Path, path: Path, framerate: float) -> None:
    from PIL import Image
    frames = [Image.open(name).convert("RGB").quantize(128) for name in sorted(folder.glob("*.png"))]
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=round(1000 / framerate), loop=0)


def _mp4(folder: Path, path: Path, framerate: float) -> None:
    told = subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(framerate), "-i", str(folder / "%05d.png"), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p",
                           str(path)], capture_output=True, text=True)
    if told.returncode:
        raise RuntimeError(f"ffmpeg could not write {path}: {told.stderr.strip()}")
