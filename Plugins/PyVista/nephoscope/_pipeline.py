# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK algorithms report, as Python exceptions and warnings."""
from __future__ import annotations

import os
import re
import sys
import warnings
from contextlib import contextmanager
from typing import Iterator, Mapping

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


def _text(message: str) -> str:
    """The sentence in VTK's "ERROR: In file, line n\\nclass (address): sentence"."""
    return message.split("): ", 1)[-1].strip()


def _is_echo(message: str) -> bool:
    """True for what the executive says of every failure: that the request failed, and a dump of it."""
    return "returned failure for request" in message


def _renamed(message: str, names: Mapping[str, str]) -> str:
    """The message with the words of VTK that are keys of `names` replaced; longer ones first."""
    keys = "|".join(re.escape(key) for key in sorted(names, key=len, reverse=True))
    return re.sub(rf"\b({keys})\b", lambda match: names[match[1]], message) if keys else message


def level_of_caller(*others: str) -> int:
    """Number of frames from here to the code that called into this package, or those in the folders `others`, as `warnings.warn` counts
    them."""
    folders = tuple(os.path.join(folder, "") for folder in (os.path.dirname(__file__), *others))
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(folders):
        frame, level = frame.f_back, level + 1
    return level


def warn_when_drawing(mapper: vtkAlgorithm) -> None:
    """From now on whatever `mapper` reports, which it does when it draws, is a RuntimeWarning at the line that made the plotter draw.

    Errors are warnings too: an exception cannot pass through VTK's rendering.
    """
    name = mapper.GetClassName()

    @calldata_type(VTK_STRING)
    def on_message(_caller: object, _event: str, message: str) -> None:
        warnings.warn(f"{name}: {_text(message)}", RuntimeWarning, stacklevel=level_of_caller(*_drawing_folders()))

    for event in ("ErrorEvent", "WarningEvent"):
        mapper.AddObserver(event, on_message)


def _drawing_folders() -> list[str]:
    return [os.path.dirname(module.__file__) for module in map(sys.modules.get, ("pyvista", "vtkmodules")) if module and module.__file__]


@contextmanager
def vtk_messages(algorithm: vtkAlgorithm, names: Mapping[str, str] = {}) -> Iterator[None]:
    """Collects what `algorithm` reports inside the block. `names`: its words for properties, and what they are called here.

    Raises
    ------
    RuntimeError
        At the end of the block, with the text of every error reported.

    Warns
    -----
    RuntimeWarning
        One for each warning reported.
    """
    errors: list[str] = []

    @calldata_type(VTK_STRING)
    def on_error(_caller: object, _event: str, message: str) -> None:
        errors.append(_renamed(_text(message), names))

    @calldata_type(VTK_STRING)
    def on_warning(_caller: object, _event: str, message: str) -> None:
        warnings.warn(f"{algorithm.GetClassName()}: {_renamed(_text(message), names)}", RuntimeWarning,
                      stacklevel=level_of_caller())

    subjects = (algorithm, algorithm.GetExecutive())
    tags = [(subject, subject.AddObserver(event, observer)) for subject in subjects
            for event, observer in (("ErrorEvent", on_error), ("WarningEvent", on_warning))]
    try:
        yield
    finally:
        for subject, tag in tags:
            subject.RemoveObserver(tag)
    if errors:
        causes = list(dict.fromkeys(text for text in errors if not _is_echo(text)))
        raise RuntimeError(f"{algorithm.GetClassName()}: " + ("\n".join(causes) or "the request failed without a reason."))
