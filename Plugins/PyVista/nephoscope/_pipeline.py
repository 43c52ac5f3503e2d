# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a VTK algorithm so that its errors are Python exceptions and its warnings Python warnings."""
from __future__ import annotations

import os
import sys
import warnings
from contextlib import contextmanager
from typing import Iterator

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


def _text(message: str) -> str:
    """The sentence in VTK's "ERROR: In file, line n\\nclass (address): sentence"."""
    return message.split("): ", 1)[-1].strip()


def _level_of_caller() -> int:
    """Number of frames from here to the code that called into this package, as `warnings.warn` counts them."""
    package = os.path.dirname(__file__)
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == package:
        frame, level = frame.f_back, level + 1
    return level


@contextmanager
def vtk_messages(algorithm: vtkAlgorithm) -> Iterator[None]:
    """Collects what `algorithm` reports inside the block.

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
        errors.append(_text(message))

    @calldata_type(VTK_STRING)
    def on_warning(_caller: object, _event: str, message: str) -> None:
        warnings.warn(f"{algorithm.GetClassName()}: {_text(message)}", RuntimeWarning,
                      stacklevel=_level_of_caller())

    subjects = (algorithm, algorithm.GetExecutive())
    tags = [(subject, subject.AddObserver(event, observer)) for subject in subjects
            for event, observer in (("ErrorEvent", on_error), ("WarningEvent", on_warning))]
    try:
        yield
    finally:
        for subject, tag in tags:
            subject.RemoveObserver(tag)
    if errors:
        raise RuntimeError(f"{algorithm.GetClassName()}: " + "\n".join(errors))
