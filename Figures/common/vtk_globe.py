# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures in plain VTK share: forecasts on the globe, surfaces of their clouds, the terrain, a window, a camera, a sun, text."""
import os

import globe_scene
import nephoscope
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkTexturedSphereSource
from vtkmodules.vtkIOImage import vtkJPEGReader
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderWindow, vtkTextActor, vtkTexture, vtkVolume

INK = (0.78, 0.83, 0.90)
ANALYSIS = os.path.join(globe_scene.DATA, "gfs_2p5deg_2011101100.nc")


def read_fields(file, dimensions="(lev, lat, lon)"):
    """The variables of a CF file that have these dimensions, on a grid of longitude, latitude and level."""
    reader = vtkNetCDFCFReader()
    reader.SetFileName(file)
    reader.SphericalCoordinatesOff()
    reader.UpdateMetaData()
    reader.SetDimensions(dimensions)
    return reader


def on_globe_grid(volume, exaggeration, ground=None):
    """vtkGlobeGrid of fields on levels; `ground` hides what is below it."""
    globe = nephoscope.vtkGlobeGrid()
    globe.SetInputConnection(volume.GetOutputPort())
    if ground:
        globe.SetSurfaceConnection(ground.GetOutputPort())
    globe.SetVerticalExaggeration(exaggeration)
    return globe


def analysis_grid(exaggeration):
    """The GFS file on the globe."""
    return on_globe_grid(read_fields(ANALYSIS), exaggeration, read_fields(ANALYSIS, "(lat, lon)"))


def cloud_surface(grid, cover, iterations):
    """The smoothed surface of a cloud cover, with the same reach in metres at all latitudes."""
    surface = nephoscope.vtkCloudSurface()
    surface.SetInputConnection(grid.GetOutputPort())
    surface.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "cloud_fraction")
    surface.SetValue(0, cover)
    surface.SetNumberOfSmoothingIterations(iterations)
    surface.SetIsotropic(True)
    return surface


def actor_of(mapper, ambient, diffuse):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(ambient)
    actor.GetProperty().SetDiffuse(diffuse)
    return actor


def volume(mapper, colours, opacities, unit_distance):
    """Colours as values with red, green and blue, opacities as values with opacity; the length over which an opacity of 1 gives an optical depth of 1."""
    made, colour, opacity = vtkVolume(), vtkColorTransferFunction(), vtkPiecewiseFunction()
    made.SetMapper(mapper)
    for point in colours:
        colour.AddRGBPoint(*point)
    for point in opacities:
        opacity.AddPoint(*point)
    made.GetProperty().SetColor(colour)
    made.GetProperty().SetScalarOpacity(opacity)
    made.GetProperty().SetScalarOpacityUnitDistance(unit_distance)
    return made


def sea(color, reach):
    """A level square around the origin, twice as wide as `reach`, which no light changes."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-reach, -reach, 0)
    plane.SetPoint1(reach, -reach, 0)
    plane.SetPoint2(-reach, reach, 0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = actor_of(mapper, ambient=1.0, diffuse=0.0)
    actor.GetProperty().SetColor(*color)
    return actor


def terrain(ambient=0.5, diffuse=0.5, resolution=360):
    """The planet under its satellite picture; `resolution`: cells around the equator."""
    sphere = vtkTexturedSphereSource()
    sphere.SetRadius(globe_scene.PLANET_RADIUS)
    sphere.SetThetaResolution(resolution)
    sphere.SetPhiResolution(resolution // 2)
    reader = vtkJPEGReader()
    reader.SetFileName(os.path.join(globe_scene.DATA, "blue_marble_2048.jpg"))
    texture = vtkTexture()
    texture.SetInputConnection(reader.GetOutputPort())
    texture.InterpolateOn()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = actor_of(mapper, ambient, diffuse)
    actor.SetTexture(texture)
    actor.RotateZ(180)  # the picture begins at 180 degrees west, the sphere at 0
    return actor


def make_window(size, samples=0):
    """A window that is not shown; `samples` for each pixel, more than 1 smooth the edges of opaque things."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(samples)
    window.SetSize(*size)
    return window


def add_sun(renderer, place):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(place)
    light.SetFocalPoint(0, 0, 0)
    renderer.AddLight(light)


def look(renderer, eye, focus, up, angle):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(eye)
    camera.SetFocalPoint(focus)
    camera.SetViewUp(up)
    camera.SetViewAngle(angle)


def text(words, place, font_size, color=INK, spacing=1.0):
    shown = vtkTextActor()
    shown.SetInput(words)
    shown.SetPosition(*place)
    style = shown.GetTextProperty()
    style.SetFontSize(font_size)
    style.SetLineSpacing(spacing)
    style.SetColor(*color)
    return shown
