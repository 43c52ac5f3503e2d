# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a film as PNG files in a folder, so that an interrupted film continues where it stopped. Needs only Python: `animate` and the scripts of the figures use it."""
from __future__ import annotations

import errno
import hashlib
import json
import os
import shutil
from contextlib import suppress
from pathlib import Path
from typing import Any, Callable

PNG_END = b"\0\0\0\0IEND\xaeB`\x82"
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


class Frames:
    """Files ``00000.png``, ``00001.png`` ... in a folder. A file of such a name is a complete frame: frames are drawn into another file, which is renamed."""

    def __init__(self, folder: str | Path, count: int, settings: Any) -> None:
        """`settings`: all that the frames depend on, as something that JSON can hold; frames of other settings are drawn again."""
        self.folder = Path(folder)
        self.files = [str(self.folder / f"{i:05d}.png") for i in range(count)]
        self.part, self.record = self.folder / "unfinished.png", self.folder / "settings.txt"
        self.settings = hashlib.sha256(json.dumps(settings, sort_keys=True).encode()).hexdigest()

    def found(self) -> list[int]:
        """Numbers of the existing frames that are complete and of these settings."""
        try:
            same = self.record.read_text(encoding="utf-8") == self.settings
        except OSError:
            return []
        return [i for i, file in enumerate(self.files) if _is_whole(file)] if same else []

    def restart(self) -> None:
        """Removes the frames."""
        for file in (self.part, self.record, *self.files):
            with suppress(FileNotFoundError):
                os.remove(file)

    def make(self, draw: Callable[[int, str], Any], told: Callable[[int], Any] = lambda i: None) -> None:
        """Draws the frames that are missing: ``draw(i, file)`` draws one into a file, ``told(i)`` is called after it.

        Raises
        ------
        OSError
            If a frame cannot be written, or is incomplete. The message names the file, the free space and the space needed. Earlier frames are kept.
        KeyboardInterrupt
            If Control-C is pressed; its message says how to continue.
        """
        found = self.found()
        try:
            self._begin(found)
            for i in sorted({*range(len(self.files))} - {*found}):
                draw(i, str(self.part))
                require_whole(self.part)
                os.replace(self.part, self.files[i])
                told(i)
        except OSError as problem:
            if problem.errno not in FULL and str(problem.filename) not in (str(self.part), str(self.record), str(self.folder)):
                raise  # of what is drawn
            raise self._told(problem) from problem
        except KeyboardInterrupt:
            raise KeyboardInterrupt(self.kept()) from None

    def clear(self) -> None:
        """Removes the frames, and the folder unless others have files there."""
        self.restart()
        with suppress(OSError):
            self.folder.rmdir()

    def _begin(self, found: list[int]) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        if not found:
            self.restart()
            self.record.write_text(self.settings, encoding="utf-8")

    def kept(self) -> str:
        return f"{len(self.found())} of {len(self.files)} frames are kept in {self.folder}. The same call continues from there."

    def _told(self, problem: OSError) -> OSError:
        sizes = [os.path.getsize(self.files[i]) for i in self.found()]
        with suppress(OSError):
            sizes = sizes or [self.part.stat().st_size]
        with suppress(OSError):
            os.remove(self.part)  # it takes space, and is no frame
        return failure(problem, self.part, self.kept(), sum(sizes) / max(1, len(sizes)) * (len(self.files) - len(self.found())))


def failure(problem: OSError, file: str | Path, kept: str, needed: float) -> OSError:
    """The error to raise when a file cannot be written: with the space that is free, the bytes `needed`, and what is `kept`."""
    text = f"{file} cannot be written: {problem.strerror or problem}."
    with suppress(OSError):
        text += f" Free: {_told_bytes(shutil.disk_usage(Path(file).parent).free)}"
        text += f"; needed: about {_told_bytes(needed)}." if needed else "."
    return OSError(problem.errno or errno.EIO, f"{text} {kept}")


def _told_bytes(count: float) -> str:
    for unit in ("bytes", "kB", "MB"):
        if count < 1000:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:,.3g} GB" if count < 1000 else f"{count:,.0f} GB"


def _is_whole(file: str | Path) -> bool:
    """Whether a PNG file has its end: what was cut off, for want of space or of power, has none."""
    try:
        with open(file, "rb") as png:
            png.seek(-len(PNG_END), os.SEEK_END)
            return png.read(len(PNG_END)) == PNG_END
    except OSError:
        return False


def require_whole(file: str | Path) -> None:
    """OSError if a PNG file lacks its end."""
    if not _is_whole(file):
        raise OSError(errno.EIO, "the file is incomplete", str(file))
