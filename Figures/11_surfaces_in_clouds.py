# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 11: the jet streams among the clouds of a weather forecast.

Two translucent surfaces, one inside the other, stand in the volume: surfaces of equal wind speed. Clouds in front of a surface
veil it, clouds inside and behind it are tinted, at every pixel in the right order. Heights are exaggerated 45 times. Writes the
picture (1920 x 1080) and the ParaView state that shows it again.
"""
import math
import os

from paraview import simple as pvs

DATA = os.environ["NEPHOSCOPE_DATA"]
GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
SIZE = [1920, 1080]
PLANET_RADIUS = 6371000.0  # metres
EXAGGERATION = 45
# Wind speed (m/s), colour, opacity
JETS = ((30.0, [1.0, 0.72, 0.20], 0.30), (50.0, [1.0, 0.27, 0.18], 0.65))
# Cloud fraction: little below a quarter, everything above four fifths. Value, opacity, and ParaView's midpoint and sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.15, 0.0, 0.5, 0.0, 0.5, 0.3, 0.5, 0.0, 0.85, 1.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
CLOUD_COLOURS = [0.0, 0.80, 0.83, 0.88, 1.0, 1.0, 1.0, 1.0]
UNIT_DISTANCE = 3.5e5  # metres over which opacity 1 gives optical depth 1


def on_globe(longitude, latitude, radii):
    """Cartesian metres of a place given in degrees, at a distance of so many planet radii."""
    lon, lat, r = math.radians(longitude), math.radians(latitude), radii * PLANET_RADIUS
    return [r * math.cos(lat) * math.cos(lon), r * math.cos(lat) * math.sin(lon), r * math.sin(lat)]


def make_view():
    view = pvs.CreateRenderView(ViewSize=SIZE, OrientationAxesVisibility=0, UseColorPaletteForBackground=0)
    pvs.AssignViewToLayout(view, layout=pvs.CreateLayout("Surfaces in clouds"))  # or the window opens the state without it
    view.BackgroundColorMode = "Gradient"
    view.Background = [0.004, 0.006, 0.016]
    view.Background2 = [0.03, 0.05, 0.11]
    view.CameraPosition = on_globe(-24, 28, 2.3)  # over the Atlantic; the strongest jet blows past Scotland
    view.CameraFocalPoint = on_globe(-14, 47, 0.86)
    view.CameraViewUp = on_globe(-12, 89, 1)
    view.CameraViewAngle = 36
    view.UseLight = 0
    sun = pvs.AddLight(view=view)
    sun.Coords = "Scene"
    sun.Type = "Directional"
    sun.Position = on_globe(-60, 32, 10)
    sun.FocalPoint = [0, 0, 0]
    return view


def show_terrain(view):
    """A plate carree plane bent into a sphere; its texture coordinates come along."""
    plane = pvs.Plane(Origin=[-180, -90, 0], Point1=[180, -90, 0], Point2=[-180, 90, 0], XResolution=360, YResolution=180)
    lon, lat = "(coordsX*{0})".format(math.pi / 180), "(coordsY*{0})".format(math.pi / 180)
    sphere = pvs.Calculator(
        Input=plane, CoordinateResults=1,
        Function=f"{PLANET_RADIUS}*(cos({lat})*cos({lon})*iHat + cos({lat})*sin({lon})*jHat + sin({lat})*kHat)")
    globe = pvs.Calculator(Input=sphere, ResultNormals=1, ResultArrayName="Up", Function=f"coords/{PLANET_RADIUS}")
    pvs.RenameSource("Terrain", globe)
    shown = pvs.Show(globe, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.Texture = pvs.CreateTexture(os.path.join(DATA, "blue_marble_2048.jpg"))
    shown.Ambient, shown.Diffuse, shown.Specular = 0.45, 0.8, 0.12
    shown.SpecularPower = 20


def read_forecast():
    forecast = pvs.NetCDFReader(FileName=[os.path.join(DATA, "gfs_2p5deg_2011101100.nc")], SphericalCoordinates=0)
    forecast.Dimensions = "(lev, lat, lon)"
    globe = pvs.GlobeGrid(Input=forecast, VerticalExaggeration=EXAGGERATION)
    pvs.RenameSource("Forecast", globe)
    return globe


def show_clouds(forecast, view):
    shown = pvs.Show(forecast, view)
    pvs.ColorBy(shown, ("POINTS", "cloud_fraction"))
    shown.SetRepresentationType("Cell Compositing")
    colours = pvs.GetColorTransferFunction("cloud_fraction")
    colours.AutomaticRescaleRangeMode = "Never"
    colours.ColorSpace = "RGB"
    colours.RGBPoints = CLOUD_COLOURS
    pvs.GetOpacityTransferFunction("cloud_fraction").Points = CLOUD_OPACITY
    shown.CellCompositingAutomaticUnitDistance = 0
    shown.CellCompositingUnitDistance = UNIT_DISTANCE


def show_jets(forecast, view):
    """Translucent contour surfaces, lit."""
    wind = pvs.Calculator(Input=forecast, ResultArrayName="Wind speed", Function="mag(Wind)")
    for speed, colour, opacity in JETS:
        surface = pvs.Contour(Input=wind, ContourBy=["POINTS", "Wind speed"], Isosurfaces=[speed], ComputeNormals=1)
        pvs.RenameSource("Wind of %.0f metres per second" % speed, surface)
        shown = pvs.Show(surface, view)
        shown.Representation = "Surface"
        shown.ColorArrayName = ["POINTS", ""]
        shown.DiffuseColor = shown.AmbientColor = colour
        shown.Opacity = opacity
        shown.Ambient, shown.Diffuse, shown.Specular, shown.SpecularPower = 0.3, 0.75, 0.25, 25


def show_caption(view):
    lines = [("GFS forecast for 2011-10-11 00 UTC, clouds in white\nHeights exaggerated %d times" % EXAGGERATION,
              [0.012, 0.915], [0.75, 0.80, 0.88])]
    lines += [("Wind of %.0f m/s and more inside" % speed, [0.012, 0.87 - 0.035 * i], colour)
              for i, (speed, colour, _) in enumerate(JETS)]
    for text, place, colour in lines:
        shown = pvs.Show(pvs.Text(Text=text), view)
        shown.WindowLocation, shown.Position = "Any Location", place
        shown.FontSize, shown.Justification, shown.Color = 18, "Left", colour


pvs._DisableFirstRenderCameraReset()
view = make_view()
show_terrain(view)
forecast = read_forecast()
show_clouds(forecast, view)
show_jets(forecast, view)
show_caption(view)
pvs.Render(view)

picture = os.path.join(GALLERY, "11_surfaces_in_clouds.png")
pvs.SaveScreenshot(picture, view, ImageResolution=SIZE)
print("wrote", picture)
state = os.path.join(GALLERY, "11_surfaces_in_clouds.pvsm")
pvs.SaveState(state)
print("wrote", state)
