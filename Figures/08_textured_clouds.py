# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8: the smoothed surface of 15 % cloud cover with a texture of broken cloud, moved by the wind of the last 24 hours.

After figure 8 of Max, Crawfis and Becker (1993), without its haze. Uses the time series of `./nephoscope forecast` (NEPHOSCOPE_FORECAST).
"""
import math
import os
import sys

import nephoscope
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersSources import vtkTexturedSphereSource
from vtkmodules.vtkIOImage import vtkJPEGReader
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import pictures  # noqa: E402

PLANET_RADIUS = 6371000.0  # metres
EXAGGERATION = 20
HOUR = 6792.0 + 24  # of the series


def on_globe(longitude, latitude, radii):
    lon, lat, r = math.radians(longitude), math.radians(latitude), radii * PLANET_RADIUS
    return r * math.cos(lat) * math.cos(lon), r * math.cos(lat) * math.sin(lon), r * math.sin(lat)


def clouds():
    reader = vtkNetCDFCFReader()
    reader.SetFileName(os.environ["NEPHOSCOPE_FORECAST"])
    reader.UpdateMetaData()
    reader.SphericalCoordinatesOff()
    reader.SetDimensions("(lev, lat, lon)")
    globe = nephoscope.vtkGlobeGrid()
    globe.SetInputConnection(reader.GetOutputPort())
    globe.SetVerticalExaggeration(EXAGGERATION)
    texture = nephoscope.vtkTextureCoordinateAdvection()
    texture.SetInputConnection(globe.GetOutputPort())
    texture.SetTimeScale(3600)
    surface = nephoscope.vtkCloudSurface()
    surface.SetInputConnection(texture.GetOutputPort())
    surface.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "cloud_fraction")
    surface.SetValue(0, 0.15)
    surface.SetNumberOfSmoothingIterations(1)
    surface.SetIsotropic(True)
    surface.UpdateTimeStep(HOUR)
    mapper = nephoscope.vtkCloudTextureMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetCoverage(0.55)
    mapper.SetTextureScale(9)
    mapper.SetSoftness(0.5)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.ForceTranslucentOn()
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


def terrain():
    sphere = vtkTexturedSphereSource()
    sphere.SetRadius(PLANET_RADIUS)
    sphere.SetThetaResolution(360)
    sphere.SetPhiResolution(180)
    reader = vtkJPEGReader()
    reader.SetFileName(os.path.join(os.environ["NEPHOSCOPE_DATA"], "blue_marble_2048.jpg"))
    texture = vtkTexture()
    texture.SetInputConnection(reader.GetOutputPort())
    texture.InterpolateOn()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.RotateZ(180)  # the picture begins at 180 degrees west, the sphere at 0
    actor.GetProperty().SetAmbient(0.5)
    return actor


def main():
    renderer, window = vtkRenderer(), vtkRenderWindow()
    for actor in (terrain(), clouds()):
        renderer.AddActor(actor)
    renderer.SetBackground(0.01, 0.015, 0.035)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(8)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(on_globe(-150, 34, 10))
    renderer.AddLight(sun)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(on_globe(-118, -12, 2.6))
    camera.SetFocalPoint(on_globe(-110, 6, 0.9))
    camera.SetViewUp(on_globe(-110, 15, 1))
    camera.SetViewAngle(31)
    window.SetOffScreenRendering(1)
    window.SetAlphaBitPlanes(1)
    window.SetMultiSamples(0)
    window.SetSize(1280, 720)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "08_textured_clouds.png"))


main()
