# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a VTK window that has been rendered, as a file, and what is written in it."""
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def whole_number_format(present):
    """The format of labels without decimals, written as the present one is: as Python does since VTK 9.6, as C does before."""
    return "{:.0f}" if "{" in present else "%.0f"


def write(window, path, announce=True):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
    if announce:
        print("wrote", path)
