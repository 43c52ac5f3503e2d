# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds in the winds of the small time series, at any hour: a layer of the air on a map of the world, or clouds on a globe."""
import os

import nephoscope
import numpy as np
from nephoscope_testing.offscreen import Window
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkFiltersExtraction import vtkExtractGrid
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkRenderingCore import vtkActor

SERIES = os.path.join(os.environ["NEPHOSCOPE_DATA"], "forecast_10deg_6h.nc")
FIRST = 6792.0  # the hour of its first field; after its last one the winds stay
COLUMNS, ROWS = 36, 19
LAYER = 2  # 500 hPa


class Turned(VTKPythonAlgorithmBase):
    """The fields of a place are those of the place that lies so many columns to the west."""

    def __init__(self, reader, columns):
        VTKPythonAlgorithmBase.__init__(self, inputType="vtkRectilinearGrid", outputType="vtkRectilinearGrid")
        self.SetInputConnection(reader.GetOutputPort())
        self.columns = columns

    def RequestData(self, request, inputs, outputs):
        output = vtkRectilinearGrid.GetData(outputs)
        output.DeepCopy(vtkRectilinearGrid.GetData(inputs[0]))
        points = dataset_adapter.WrapDataObject(output).PointData
        for name in points.keys():
            rows = np.asarray(points[name]).reshape(-1, COLUMNS)
            points[name][:] = np.roll(rows, self.columns, axis=1).ravel()
        return 1


class Pipeline:
    """Reader, grid and texture; kept, since what follows holds their outputs only."""

    def __init__(self, columns=0, **settings):
        self.reader = vtkNetCDFCFReader()
        self.reader.SetFileName(SERIES)
        self.reader.SphericalCoordinatesOff()
        self.reader.UpdateMetaData()
        self.reader.SetDimensions("(lev, lat, lon)")
        self.turned = Turned(self.reader, columns)
        self.grid = nephoscope.vtkGlobeGrid()
        self.grid.SetInputConnection(self.turned.GetOutputPort())
        self.texture = nephoscope.vtkTextureCoordinateAdvection()
        self.texture.SetInputConnection(self.grid.GetOutputPort())
        self.texture.SetTimeScale(3600)
        for name, value in settings.items():
            getattr(self.texture, "Set" + name)(value)
        self.mapper = nephoscope.vtkCloudTextureMapper()
        self.mapper.ScalarVisibilityOff()
        self.mapper.SetOpticalDepth(1e6)  # opaque where there is cloud
        self.mapper.SetTextureScale(3)
        self.mapper.SetSoftness(0.15)
        self.mapper.SetThinColor(1, 1, 1)
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        actor.GetProperty().LightingOff()
        self.actor = actor

    def show(self, last, size):
        """Draws the output of a filter, in white on black."""
        self.last = last
        self.mapper.SetInputConnection(last.GetOutputPort())
        self.window = Window(size)
        self.scene = self.window.add_scene()
        self.scene.renderer.AddActor(self.actor)

    def update(self, hour):
        self.last.UpdateTimeStep(FIRST + hour)
        return self.last.GetOutput()

    def draw(self, hour):
        """Brightness of the pixels: the share of each that is cloud."""
        self.update(hour)
        self.window.render()
        return self.window.rgba()[..., 0]


class Layer(Pipeline):
    """A layer of the air, all of it, on a map that fills the window."""

    def __init__(self, size=(128, 64), **settings):
        Pipeline.__init__(self, **settings)
        self.grid.SetProjectionToMap()
        self.layer = vtkExtractGrid()
        self.layer.SetInputConnection(self.texture.GetOutputPort())
        self.layer.SetVOI(0, COLUMNS, 0, ROWS - 1, LAYER, LAYER)
        sheet = vtkGeometryFilter()
        sheet.SetInputConnection(self.layer.GetOutputPort())
        self.show(sheet, size)
        west, east, south, north, _, top = self.update(0).GetBounds()
        center = (west + east) / 2, (south + north) / 2
        self.scene.look((*center, top + 1e7), (*center, top), near=1e6, far=1e8, parallel_scale=(north - south) / 2)


class Clouds(Pipeline):
    """The surface of 15 % cover on a globe, seen from above the equator."""

    def __init__(self, size, columns, **settings):
        Pipeline.__init__(self, columns, **settings)
        self.grid.SetVerticalExaggeration(20)
        surface = nephoscope.vtkCloudSurface()
        surface.SetInputConnection(self.texture.GetOutputPort())
        surface.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
        surface.SetValue(0, 0.15)
        surface.SetIsotropic(True)
        self.show(surface, size)
        self.scene.renderer.UseDepthPeelingOn()
        angle = np.radians(360 / COLUMNS * columns)
        self.scene.look((2.5e7 * np.cos(angle), 2.5e7 * np.sin(angle), 0), up=(0, 0, 1), near=1e7, far=3.2e7)
