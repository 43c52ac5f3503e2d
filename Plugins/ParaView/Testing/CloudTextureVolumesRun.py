# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that CloudTextureVolumesRanks.py compares.

Usage: CloudTextureVolumesRun.py PREFIX
"""
import sys

import numpy as np
from CloudTextureScenes import CLOUDS
from PluginTesting import clear, empty_view, image, load_plugin, look, passed, pvs, solid

# Each rank has some of the faces of a cube: four points each, with the normal of the face.
FACES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
information = self.GetOutputInformation(0)
piece, pieces = information.Get(Pipeline.UPDATE_PIECE_NUMBER()), information.Get(Pipeline.UPDATE_NUMBER_OF_PIECES())
output = self.GetPolyDataOutput()
output.SetPoints(vtk.vtkPoints())
output.AllocateEstimate(6, 4)
normals = vtk.vtkFloatArray()
normals.SetNumberOfComponents(3)
normals.SetName("Normals")
for face in range(piece, 6, pieces):
    axis, sign = face // 2, face % 2 * 2 - 1
    corners = vtk.vtkIdList()
    for a, b in ((-1, -1), (sign, -sign), (1, 1), (-sign, sign)):
        place, normal = [0.0] * 3, [0.0] * 3
        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = sign, a, b
        normal[axis] = sign
        corners.InsertNextId(output.GetPoints().InsertNextPoint(place))
        normals.InsertNextTuple(normal)
    output.InsertNextCell(9, corners)  # VTK_QUAD
output.GetPointData().SetNormals(normals)
"""


def faces_of_cube():
    source = pvs.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=FACES)
    source.ScriptRequestInformation = "self.GetOutputInformation(0).Set(vtk.vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)"
    return source


def draw(name, source):
    view = empty_view()
    display = pvs.Show(source, view)
    solid(display, [1, 1, 1])
    display.SetRepresentationType(CLOUDS)
    look(view)
    pvs.ResetCamera(view)
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    clear(view)


def hexahedra():
    return pvs.CleantoGrid(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3))


def distributed(mode="Assign to one region"):
    """Without the cells of other ranks, whatever is asked for."""
    return pvs.RedistributeDataSet(Input=hexahedra(), BoundaryMode=mode)


load_plugin()
draw("tetrahedra", pvs.Tetrahedralize(Input=pvs.Wavelet(WholeExtent=[-5, 5] * 3)))  # two ranks divide cells along other diagonals
draw("hexahedra", hexahedra())
draw("appended", pvs.AppendDatasets(Input=[hexahedra()]))
draw("distributed", distributed())
draw("split", distributed("Split cells"))
draw("group", pvs.GroupDatasets(Input=[distributed()]))
# Some ranks have nothing.
height = pvs.Elevation(Input=distributed(), LowPoint=[0, 0, -4], HighPoint=[0, 0, 4])
draw("top", pvs.Threshold(Input=height, Scalars=["POINTS", "Elevation"], LowerThreshold=0.8, UpperThreshold=1.0))
draw("numbered", pvs.GenerateGlobalIds(Input=distributed()))
draw("cylinder", pvs.Cylinder(Resolution=30))  # with polygons of 30 corners
draw("faces", faces_of_cube())
passed()
