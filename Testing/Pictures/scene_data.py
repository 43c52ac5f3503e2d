# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scenes of the mappers show: data, transfer functions, and opaque balls."""
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

WARM = [(0, 0.1, 0.3, 1), (0.5, 1, 1, 1), (1, 1, 0.3, 0.1)]
CLOUD = Transfer(WARM, [(0.1, 0), (1, 2.0)])
CLEAR = Transfer(WARM, [(0, 0)])


def values(p):
    """Two clouds, one above the other."""
    x, y, z = p.T
    return np.exp(-2.5 * (x ** 2 + y ** 2 + (z - 0.35) ** 2)) + 0.8 * np.exp(-4 * ((x - 0.4) ** 2 + (y + 0.3) ** 2 + (z + 0.5) ** 2))


def image(count=16):
    return meshes.with_field(meshes.image((count,) * 3, (2 / count,) * 3, (-1, -1, -1)), values)


def tetrahedra(count=8):
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(image(count))
    divide.Update()
    return divide.GetOutput()


def cells_of(kind, count=8):
    return meshes.with_field(meshes.Lattice(count).mesh(kind, lambda p: 2 * p - 1 + 0.06 * np.sin(6 * p[:, [1, 2, 0]])), values)


def winds(count=18):
    data = image(count)
    x, y, z = meshes.points_of(data).T
    meshes.add_array(data.GetPointData(), np.column_stack([-y, x, 0.2 * z]), "wind")
    return data


def ball(radius=0.45, color=(0.9, 0.6, 0.2), opacity=1.0):
    source, mapper, actor = vtkSphereSource(), vtkPolyDataMapper(), vtkActor()
    source.SetRadius(radius)
    source.SetThetaResolution(48)
    source.SetPhiResolution(32)
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def clip(mapper):
    plane = vtkPlane()
    plane.SetNormal(0.3, 1, 0.2)
    mapper.AddClippingPlane(plane)
