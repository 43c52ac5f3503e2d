# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes an unstructured grid as XML with raw appended data, and prints how many cells VTK reads of it."""
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

source = vtkRTAnalyticSource()
source.SetWholeExtent(0, 10, 0, 10, 0, 2)
tetrahedra = vtkDataSetTriangleFilter()
tetrahedra.SetInputConnection(source.GetOutputPort())
writer = vtkXMLUnstructuredGridWriter()
writer.SetInputConnection(tetrahedra.GetOutputPort())
writer.SetDataModeToAppended()
writer.EncodeAppendedDataOff()
writer.WriteToOutputStringOn()
writer.Write()
reader = vtkXMLUnstructuredGridReader()
reader.ReadFromInputStringOn()
reader.SetInputString(writer.GetOutputString())
reader.Update()
print(reader.GetOutput().GetNumberOfCells(), "cells")
