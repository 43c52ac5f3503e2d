# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 16: the surface of 15 % cloud cover of a weather forecast over the globe, rough (left) and smoothed (right).

After Max, Crawfis and Becker (1993), section 4. Left as the model has it, right after the 3 x 3 x 3 filter, with the same
reach in metres at all latitudes. Colour is the altitude, an array that comes with the surface. Writes the picture (1800 x 960).
"""
import math
import os
import sys

import nephoscope
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersSources import vtkTexturedSphereSource
from vtkmodules.vtkIOImage import vtkJPEGReader
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkTexture)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import pictures  # noqa: E402

DATA = os.environ["NEPHOSCOPE_DATA"]
GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
SIZE = (1800, 960)
PLANET_RADIUS = 6371000.0  # metres
EXAGGERATION = 30
COVER = 0.15
ITERATIONS = 1
# Height in metres: warm below, white in the middle, cold above.
ALTITUDE_COLOURS = ((0, 0.96, 0.55, 0.25), (2000, 1.00, 0.76, 0.47), (4500, 1.00, 0.94, 0.84), (7500, 0.98, 0.98, 0.98),
                    (11000, 0.80, 0.89, 1.00), (15000, 0.50, 0.68, 1.00))


def on_globe(longitude, latitude, radii):
    """Cartesian metres of a place given in degrees, at a distance of so many planet radii."""
    lon, lat, r = math.radians(longitude), math.radians(latitude), radii * PLANET_RADIUS
    return r * math.cos(lat) * math.cos(lon), r * math.cos(lat) * math.sin(lon), r * math.sin(lat)


def fields(dimensions):
    reader = vtkNetCDFCFReader()
    reader.SetFileName(os.path.join(DATA, "gfs_2p5deg_2011101100.nc"))
    reader.SphericalCoordinatesOff()
    reader.UpdateMetaData()
    reader.SetDimensions(dimensions)
    return reader


def forecast():
    volume, ground = fields("(lev, lat, lon)"), fields("(lat, lon)")
    globe = nephoscope.vtkGlobeGrid()
    globe.SetInputConnection(volume.GetOutputPort())
    globe.SetSurfaceConnection(ground.GetOutputPort())
    globe.SetVerticalExaggeration(EXAGGERATION)
    return globe


def cloud_actor(globe, iterations):
    surface = nephoscope.vtkCloudSurface()
    surface.SetInputConnection(globe.GetOutputPort())
    surface.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "cloud_fraction")
    surface.SetValue(0, COVER)
    surface.SetNumberOfSmoothingIterations(iterations)
    surface.SetIsotropic(True)
    colours = vtkColorTransferFunction()
    for point in ALTITUDE_COLOURS:
        colours.AddRGBPoint(*point)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Height")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.22)
    actor.GetProperty().SetDiffuse(0.85)
    return actor


def terrain_actor():
    sphere = vtkTexturedSphereSource()
    sphere.SetRadius(PLANET_RADIUS)
    sphere.SetThetaResolution(180)
    sphere.SetPhiResolution(90)
    reader = vtkJPEGReader()
    reader.SetFileName(os.path.join(DATA, "blue_marble_2048.jpg"))
    texture = vtkTexture()
    texture.SetInputConnection(reader.GetOutputPort())
    texture.InterpolateOn()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.RotateZ(180)  # the picture begins at 180 degrees west, the sphere at 0
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.8)
    return actor


def caption(text):
    shown = vtkTextActor()
    shown.SetInput(text)
    shown.SetPosition(24, 20)
    shown.GetTextProperty().SetFontSize(24)
    shown.GetTextProperty().SetColor(0.75, 0.80, 0.88)
    return shown


def add_globe(window, column, clouds, text):
    renderer = vtkRenderer()
    renderer.SetViewport(column / 2, 0, (column + 1) / 2, 1)
    renderer.SetBackground(0.01, 0.015, 0.035)
    for actor in (terrain_actor(), clouds):
        renderer.AddActor(actor)
    renderer.AddViewProp(caption(text))
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(on_globe(-55, 40, 10))
    sun.SetFocalPoint(0, 0, 0)
    renderer.AddLight(sun)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(on_globe(-108, 22, 3.95))  # over the eastern Pacific, where two hurricanes are
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(36)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()


def main():
    globe = forecast()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*SIZE)
    add_globe(window, 0, cloud_actor(globe, 0), "15 % cloud cover as the model has it\nGFS forecast for 2011-10-11 00 UTC")
    add_globe(window, 1, cloud_actor(globe, ITERATIONS), "The same, smoothed once. Orange: below 2 km; white: near 7 km;\n"
              f"blue: above 11 km. Heights exaggerated {EXAGGERATION} times")
    window.Render()
    pictures.write(window, os.path.join(GALLERY, "16_smoothed_clouds.png"))


main()
