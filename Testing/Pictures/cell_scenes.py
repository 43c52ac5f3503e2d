# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of cell compositing."""
import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.transfer import Transfer
from scene_book import scene
from scene_data import CLEAR, CLOUD, WARM, ball, cells_of, clip, image, tetrahedra, values
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkCellCenters
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter


def cells(made, data, configure=None, transfer=CLOUD, **options):
    mapper = nephoscope.vtkCellCompositingMapper()
    if configure:
        configure(mapper)
    made.add_volume(mapper, data, transfer, **options)
    return mapper


@scene("cells-image")
def _(made):
    cells(made, image())


@scene("cells-tetrahedra")
def _(made):
    cells(made, tetrahedra())


@scene("cells-mixed")
def _(made):
    cells(made, cells_of("mixed"))


@scene("cells-of-cell-data")
def _(made):
    cells(made, meshes.with_field(meshes.image((10,) * 3, (0.2,) * 3, (-1, -1, -1)), values, "cell"), association="cell")


@scene("cells-projection")
def _(made):
    cells(made, cells_of("wedge"), lambda m: m.SetMethodToProjection())


@scene("cells-triangles")
def _(made):
    cells(made, tetrahedra(), lambda m: m.SetMethodToTrianglesTable())


@scene("cells-faces")
def _(made):
    cells(made, tetrahedra(6), lambda m: m.SetMethodToFaces())


def contours(mapper, opacity=0.6):
    mapper.SetNumberOfContourValues(2)
    for i, value in enumerate((0.3, 0.7)):
        mapper.SetContourValue(i, value)
        mapper.SetContourOpacity(i, opacity)


@scene("cells-average-integration")
def _(made):
    cells(made, tetrahedra(), lambda m: m.SetIntegrationToAverage())


@scene("cells-contours")
def _(made):
    cells(made, image(), contours)


@scene("cells-contours-alone")
def _(made):
    """So thin that 2 % more opacity is 2 % more light."""
    cells(made, image(), lambda m: contours(m, 0.15), CLEAR)


@scene("cells-layers")
def _(made):
    thin, thick = Transfer([(0, 0.2, 0.9, 0.4), (1, 0.2, 0.9, 0.4)], [(0, 0.4), (1, 0.4)]), CLOUD

    def layered(mapper):
        contours(mapper)
        mapper.SetLayersFromContours(True)
        mapper.SetLayerProperty(1, thin.volume_property())
    cells(made, image(), layered, thick)


@scene("cells-layers-alone")
def _(made):
    def layered(mapper):
        contours(mapper, 0)
        mapper.SetLayersFromContours(True)
        mapper.SetLayerProperty(1, Transfer([(0, 0.2, 0.9, 0.4)], [(0, 0.2)]).volume_property())
    cells(made, image(), layered, Transfer(WARM, [(0, 0), (1, 0.3)]))


def pieces():
    """Pieces of cells, and the surfaces between them."""
    splitter = nephoscope.vtkContourCellSplitter()
    splitter.SetInputData(cells_of("tetra", 6))
    splitter.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "s")
    splitter.SetNumberOfContours(2)
    splitter.SetValue(0, 0.3)
    splitter.SetValue(1, 0.7)
    splitter.Update()
    return splitter.GetOutput()


@scene("cells-polygons")
def _(made):
    def polygons(mapper):
        mapper.SetPolygonOpacity(0, 0.4)
        mapper.SetPolygonOpacity(1, 0.8)
        mapper.SetPolygonColor(1, 1, 0.9, 0.3)
    cells(made, pieces(), polygons)


@scene("cells-polygons-alone")
def _(made):
    cells(made, pieces(), lambda m: m.SetPolygonOpacity(0.15), CLEAR)


@scene("cells-smoke")
def _(made):
    """Opacity from an array of the cells, as of smoke; colour from another of the points."""
    data = cells_of("tetra", 6)
    centers = vtkCellCenters()
    centers.SetInputData(data)
    centers.Update()
    meshes.add_array(data.GetCellData(), values(meshes.points_of(centers.GetOutput())), "density")
    cells(made, data, lambda m: m.SetOpacityArrayName("density"))


@scene("cells-from-inside", zoom=8.0, direction=(-1, 0, 0))
def _(made):
    cells(made, image(), transfer=Transfer(WARM, [(0, 0.05), (1, 1.5)]))


@scene("cells-clipped")
def _(made):
    cells(made, image(), clip)


@scene("cells-around-a-ball")
def _(made):
    cells(made, image(), transfer=Transfer(WARM, [(0, 0.3), (1, 1.0)]))
    made.renderer.AddActor(ball())


@scene("cells-of-two-media")
def _(made):
    """A plume of unstructured cells in and behind a cloud on a grid."""
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(meshes.image((6, 6, 12), (1 / 6,) * 3, (-0.5, -0.1, -1)))
    divide.Update()
    plume = meshes.with_field(divide.GetOutput(), lambda p: np.exp(-9 * ((p[:, 0] - 0.2 * p[:, 2]) ** 2 + (p[:, 1] - 0.4) ** 2)))
    cells(made, image(), transfer=Transfer([(0, 1, 1, 1)], [(0.1, 0), (1, 2.0)]))
    cells(made, plume, transfer=Transfer([(0, 1, 0.3, 0)], [(0.2, 0), (1, 5.0)]))


@scene("cells-among-peels")
def _(made):
    made.renderer.SetUseDepthPeeling(1)
    made.renderer.SetUseDepthPeelingForVolumes(1)
    cells(made, image(), transfer=Transfer(WARM, [(0, 0.3), (1, 1.0)]))
    made.renderer.AddActor(ball(0.6, (0.2, 0.9, 0.3), 0.5))
