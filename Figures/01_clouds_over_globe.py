# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 1: clouds of a weather forecast wrapped around the globe, coloured by altitude, over Blue Marble terrain.

After figure 1 of Max, Crawfis and Becker (1993). Heights are exaggerated 45 times. Opacity comes from the cloud fraction,
colour from the height. Writes the picture (1920 x 1080) and the ParaView state that shows it again.
"""
import math
import os

from paraview import simple as pvs

DATA = os.environ["NEPHOSCOPE_DATA"]
GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
PLANET_RADIUS = 6371000.0  # metres
EXAGGERATION = 45
# Height in metres: warm below, white in the middle, cold above.
ALTITUDE_COLOURS = [
    0, 0.96, 0.46, 0.16,
    2000, 1.00, 0.72, 0.38,
    4500, 1.00, 0.93, 0.80,
    7500, 0.98, 0.98, 0.98,
    11000, 0.80, 0.89, 1.00,
    15000, 0.45, 0.64, 1.00,
]
# Cloud fraction: little below a quarter, everything above four fifths. Value, opacity, and ParaView's midpoint and sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.12, 0.0, 0.5, 0.0, 0.45, 0.35, 0.5, 0.0, 0.8, 1.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
UNIT_DISTANCE = 2.2e5  # metres over which opacity 1 gives optical depth 1


def on_globe(longitude, latitude, radii):
    """Cartesian metres of a place given in degrees, at a distance of so many planet radii."""
    lon, lat, r = math.radians(longitude), math.radians(latitude), radii * PLANET_RADIUS
    return [r * math.cos(lat) * math.cos(lon), r * math.cos(lat) * math.sin(lon), r * math.sin(lat)]


def make_view():
    view = pvs.CreateRenderView(ViewSize=[1920, 1080], OrientationAxesVisibility=0, UseColorPaletteForBackground=0)
    pvs.AssignViewToLayout(view, layout=pvs.CreateLayout("Clouds over the globe"))  # or the window opens the state without it
    view.BackgroundColorMode = "Gradient"
    view.Background = [0.004, 0.006, 0.016]
    view.Background2 = [0.03, 0.05, 0.11]
    view.CameraPosition = on_globe(-108, 16, 3.3)  # over the eastern Pacific, where two hurricanes are
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 40
    view.UseLight = 0
    sun = pvs.AddLight(view=view)
    sun.Coords = "Scene"
    sun.Type = "Directional"
    sun.Position = on_globe(-92, 32, 10)
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
    shown.Ambient, shown.Diffuse, shown.Specular = 0.35, 0.9, 0.12
    shown.SpecularPower = 20


def show_clouds(view):
    forecast = pvs.NetCDFReader(FileName=[os.path.join(DATA, "gfs_2p5deg_2011101100.nc")], SphericalCoordinates=0)
    forecast.Dimensions = "(lev, lat, lon)"
    clouds = pvs.GlobeGrid(Input=forecast, VerticalExaggeration=EXAGGERATION)
    pvs.RenameSource("Clouds", clouds)
    shown = pvs.Show(clouds, view)
    pvs.ColorBy(shown, ("POINTS", "Height"))
    shown.SetRepresentationType("Cell Compositing")
    colours = pvs.GetColorTransferFunction("Height")
    colours.AutomaticRescaleRangeMode = "Never"
    colours.ColorSpace = "RGB"
    colours.RGBPoints = ALTITUDE_COLOURS
    shown.LookupTable = colours
    shown.CellCompositingOpacityArray = "cloud_fraction"
    opacity = pvs.GetOpacityTransferFunction("cloud_fraction")
    opacity.Points = CLOUD_OPACITY
    shown.ScalarOpacityFunction = opacity
    shown.CellCompositingAutomaticUnitDistance = 0
    shown.CellCompositingUnitDistance = UNIT_DISTANCE
    return colours


def show_legend(view, colours):
    bar = pvs.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "Altitude (m)", ""
    bar.Visibility = 1
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = [0.9, 0.30], 0.4, 14
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.UseCustomLabels, bar.CustomLabels = 1, [0, 3000, 6000, 9000, 12000, 15000]
    bar.AddRangeLabels, bar.AutomaticLabelFormat, bar.LabelFormat = 0, 0, "%.0f"
    caption = pvs.Text(Text="GFS forecast for 2011-10-11 00 UTC\nHeights exaggerated %d times" % EXAGGERATION)
    shown = pvs.Show(caption, view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Lower Left Corner", 18, "Left"
    shown.Color = bar.TitleColor = bar.LabelColor = [0.75, 0.80, 0.88]


pvs._DisableFirstRenderCameraReset()
view = make_view()
show_terrain(view)
show_legend(view, show_clouds(view))
pvs.Render(view)

picture = os.path.join(GALLERY, "01_clouds_over_globe.png")
pvs.SaveScreenshot(picture, view, ImageResolution=[1920, 1080])
print("wrote", picture)
state = os.path.join(GALLERY, "01_clouds_over_globe.pvsm")
pvs.SaveState(state)
print("wrote", state)
