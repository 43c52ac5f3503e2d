# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Films of a series: frames that are kept until the film is whole, then a GIF, an MP4, or the frames themselves."""
from __future__ import annotations

import os
import shutil
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any, Callable

import numpy as np

from .._film_frames import Frames, failure
from .._pipeline import level_of_caller
from .series import Series

SAME = 2  # of 255: by more than that, what a plotter draws differs from a frame that was kept


def write_film(plotter: Any, series: Series, turn_to: Callable[[float], None], path: Path, framerate: float, progress: bool, settings: Any) -> None:
    """Writes all steps of the series, which `turn_to` draws, into a film. `settings`: those of the call, for JSON."""
    kind = path.suffix.lower()
    if kind not in (".gif", ".mp4", ""):
        raise ValueError(f"filename is {str(path)!r}; its ending must be .gif or .mp4, or none for a folder of pictures.")
    program = _ffmpeg() if kind == ".mp4" else ""
    frames = Frames(path if kind == "" else path.with_name(path.name + ".frames"), len(series), [settings, framerate, series.times, list(plotter.window_size), series.identity()])

    def draw(step: int, file: str) -> None:
        turn_to(step)
        if series.step == step or step == 0:
            plotter.screenshot(file)
        else:  # it cannot be read
            shutil.copyfile(frames.files[step - 1], file)

    _take_up(frames, draw, progress)
    frames.make(draw, lambda step: progress and _tell(step, series))
    if kind == "":
        frames.record.unlink()
        _warn_of_others(frames)
        return
    part = frames.folder / ("film" + kind)
    try:
        _gif(frames.files, part, framerate) if kind == ".gif" else _mp4(program, frames.folder, part, framerate)
        os.replace(part, path)
    except OSError as problem:
        raise failure(problem, path, frames.kept(), 0) from problem
    finally:
        part.unlink(missing_ok=True)
    frames.clear()


def _warn_of_others(frames: Frames) -> None:
    """Pictures of a longer film, which a program that makes a film of the folder would append."""
    others = sorted({*frames.folder.glob("[0-9]" * 5 + ".png")} - {Path(file) for file in frames.files})
    if others:
        warnings.warn(f"The folder {frames.folder} also has pictures that do not belong to this film of {len(frames.files)} frames, such as {others[0].name}. Remove them, or use a new folder.",
                      UserWarning, stacklevel=level_of_caller())


def _take_up(frames: Frames, draw: Callable[[int, str], None], progress: bool) -> None:
    """Keeps the frames that are there if the newest of them is what the plotter draws now: it may have another camera, other colours or other contents."""
    found = frames.found()
    if not found:
        return
    draw(found[-1], str(frames.part))
    same = _alike(frames.part, frames.files[found[-1]])
    if not same:
        frames.restart()
    if progress:
        print(f"{len(found)} of {len(frames.files)} frames are in {frames.folder} already" + ("." if same else ", but differ from what this call draws: all are drawn again."), file=sys.stderr, flush=True)


def _alike(one: Any, other: Any) -> bool:
    from PIL import Image
    pictures = []
    for name in (one, other):
        with Image.open(name) as picture:
            pictures.append(np.asarray(picture.convert("RGB"), int))
    return pictures[0].shape == pictures[1].shape and int(np.abs(pictures[0] - pictures[1]).max()) <= SAME


def _tell(step: int, series: Series) -> None:
    """One line that changes on a terminal, and a line for each step in a log."""
    start, end = ("\r", "\n" if step + 1 == len(series) else "") if sys.stderr.isatty() else ("", "\n")
    print(f"{start}{step + 1} of {len(series)}: {series.times[step]}", end=end, file=sys.stderr, flush=True)


def _gif(files: list[str], path: Path, framerate: float) -> None:
    """Each frame has the 256 colours that suit it, dithered: colours that change slowly, as those of clouds do, would have bands."""
    first, *others = files
    _dithered(first).save(path, save_all=True, append_images=(_dithered(name) for name in others), duration=round(1000 / framerate), loop=0)


def _dithered(name: str) -> Any:
    from PIL import Image
    with Image.open(name) as picture:
        frame = picture.convert("RGB")
    return frame.quantize(palette=frame.quantize(256, Image.Quantize.FASTOCTREE), dither=Image.Dither.FLOYDSTEINBERG)


def _ffmpeg() -> str:
    """The program on the path, otherwise that of the package imageio-ffmpeg."""
    found = shutil.which("ffmpeg")
    if found is None:
        try:
            from imageio_ffmpeg import get_ffmpeg_exe
            found = get_ffmpeg_exe()
        except (ImportError, RuntimeError):  # RuntimeError: the package has no program for this machine
            raise RuntimeError("A film in .mp4 needs the program ffmpeg, which is not on the path. Install it, or the Python package imageio-ffmpeg, or write a .gif.") from None
    return found


def _mp4(program: str, folder: Path, path: Path, framerate: float) -> None:
    told = subprocess.run([program, "-y", "-loglevel", "error", "-framerate", str(framerate), "-i", str(folder / "%05d.png"), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p",
                           str(path)], capture_output=True, text=True)
    if told.returncode:
        raise RuntimeError(f"ffmpeg could not write {path}: {told.stderr.strip()} The frames are kept in {folder}. The same call continues from there.")
