# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws cells on the server that waits at the port, and prints how many ranks have drawn them."""
import sys

from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

connection = simple.Connect("localhost", int(sys.argv[1]))
view = simple.CreateRenderView(ViewSize=[100, 100])
display = simple.Show(simple.Wavelet(), view)
display.SetRepresentationType("Cell Compositing")
simple.Render(view)
picture = vtk_to_numpy(view.CaptureWindow(1).GetPointData().GetScalars())
ranks = connection.Session.GetServerInformation().GetNumberOfProcesses()
print(f"{ranks} ranks have drawn" if len(set(map(tuple, picture))) > 100 else f"{ranks} ranks have drawn nothing")
