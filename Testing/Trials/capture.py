# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a trial says: exceptions, Python warnings, messages of VTK objects, text on standard error, codes of OpenGL."""
import ctypes
import ctypes.util
import os
import re
import tempfile
import traceback
import warnings

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow

vtkOutputWindow.SetInstance(vtkOutputWindow())  # not PyVista's, which tells Python's logging, nor ParaView's
ACCEPTED = ("ValueError", "TypeError", "RuntimeError", "MissingDataError", "FileNotFoundError")


class Capture:
    """with Capture() as said: ...; what was raised is kept, not passed on."""

    def __init__(self):
        self.warnings, self.vtk, self.stderr, self.raised, self.accidental = [], [], "", "", False

    def __enter__(self):
        @calldata_type(VTK_STRING)
        def keep(_object, _event, text):
            self.vtk.append(text.strip())

        output = vtkOutputWindow.GetInstance()
        output.SetDisplayModeToNever()
        self._tags = output, [output.AddObserver(event, keep) for event in ("ErrorEvent", "WarningEvent")]
        self._catch = warnings.catch_warnings(record=True)
        self._caught = self._catch.__enter__()
        warnings.simplefilter("always")
        self._file = tempfile.TemporaryFile()
        self._stderr = os.dup(2)
        os.dup2(self._file.fileno(), 2)
        return self

    def __exit__(self, kind, error, trace):
        os.dup2(self._stderr, 2)
        os.close(self._stderr)
        self._file.seek(0)
        self.stderr = self._file.read().decode(errors="replace").strip()
        self._catch.__exit__(None, None, None)
        self.warnings = [str(w.message) for w in self._caught if not issubclass(w.category, (DeprecationWarning, ImportWarning))]
        output, tags = self._tags
        for tag in tags:
            output.RemoveObserver(tag)
        if error is None or not isinstance(error, Exception):
            return False
        self.raised = f"{kind.__name__}: {error}"
        last = traceback.extract_tb(trace)[-1]
        ours = f"{os.sep}nephoscope{os.sep}" in last.filename or "paraview" in last.filename
        self.accidental = not (ours and kind.__name__ in ACCEPTED)
        if self.accidental:
            self.raised += f" [{os.path.basename(last.filename)}:{last.lineno}]"
        return True


def plain(text):
    """A message of VTK without file, line and address."""
    return re.sub(r"\s+", " ", re.sub(r"^(ERROR|Warning):.*?\n", "", re.sub(r"\(0x[0-9a-f]+\)", "", text))).strip()


def opengl_errors(make_current):
    library = ctypes.CDLL(ctypes.util.find_library("GL") or "libGL.so.1")
    make_current()
    codes = []
    while len(codes) < 8 and (code := library.glGetError()):
        codes.append(hex(code))
    return codes
