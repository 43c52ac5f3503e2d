# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a VTK window that has been rendered, as a file, and what is written in it."""
import errno

from film_frames import require_whole
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def whole_number_format(present):
    """The format of labels without decimals, written as the present one is: as Python does since VTK 9.6, as C does before."""
    return "{:.0f}" if "{" in present else "%.0f"


def write(window, path, announce=True):
    """As PNG. OSError if that fails, as on a full disk."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(errno.EIO, vtkErrorCode.GetStringFromErrorCode(writer.GetErrorCode()), path)
    require_whole(path)  # since the last bytes are written when the file is closed, where the writer looks for no error
    if announce:
        print("wrote", path)
