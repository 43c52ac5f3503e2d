# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings of all VTK objects, kept instead of printed."""
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow
from vtkmodules.util.misc import calldata_type


class Messages:
    """with Messages() as m: ...; then m.errors, m.warnings: the texts."""

    def __init__(self):
        self.errors, self.warnings = [], []

    @property
    def all(self):
        return self.errors + self.warnings

    def clear(self):
        self.errors.clear()
        self.warnings.clear()

    def __enter__(self):
        @calldata_type(VTK_STRING)
        def error(_object, _event, text):
            self.errors.append(text)

        @calldata_type(VTK_STRING)
        def warning(_object, _event, text):
            self.warnings.append(text)

        self._output = vtkOutputWindow.GetInstance()
        self._mode = self._output.GetDisplayMode()
        self._output.SetDisplayModeToNever()
        self._tags = [self._output.AddObserver("ErrorEvent", error), self._output.AddObserver("WarningEvent", warning)]
        return self

    def __exit__(self, *_):
        for tag in self._tags:
            self._output.RemoveObserver(tag)
        self._output.SetDisplayMode(self._mode)
        return False
