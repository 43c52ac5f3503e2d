# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 12: the jet streams as nested translucent surfaces of equal wind speed, in the clouds of the same forecast.

After section 2 of Max, Crawfis and Becker (1993): contour surfaces composited with the cells in one order. No surface is made as
geometry. A map in plate carree, heights exaggerated 130 times; clouds are coloured by altitude. Writes the picture (1920 x 1080) and
the ParaView state that shows it again.
"""
import os

from paraview import simple as pvs

DATA = os.environ["NEPHOSCOPE_DATA"]
GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
PLANET_RADIUS = 6371000.0  # metres
DEGREE = PLANET_RADIUS * 3.14159265358979 / 180
EXAGGERATION = 130
SPEEDS = [30.0, 42.0, 54.0]  # m/s
SPEED_COLOURS = [1.00, 0.93, 0.70, 1.00, 0.58, 0.16, 0.92, 0.10, 0.26]
SPEED_OPACITIES = [0.2, 0.45, 0.9]
CLOUD_COLOURS = [0, 0.72, 0.80, 0.92, 16000, 1.0, 1.0, 1.0]
# Cloud fraction: value, opacity, midpoint, sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.2, 0.0, 0.5, 0.0, 0.6, 0.3, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
UNIT_DISTANCE = 5.0e5  # metres over which opacity 1 gives optical depth 1


def make_view():
    view = pvs.CreateRenderView(ViewSize=[1920, 1080], OrientationAxesVisibility=0, UseColorPaletteForBackground=0)
    pvs.AssignViewToLayout(view, layout=pvs.CreateLayout("Contours in clouds"))
    view.BackgroundColorMode = "Gradient"
    view.Background = [0.008, 0.012, 0.03]
    view.Background2 = [0.05, 0.09, 0.17]
    view.CameraPosition = [4 * DEGREE, -140 * DEGREE, 92 * DEGREE]
    view.CameraFocalPoint = [42 * DEGREE, -24 * DEGREE, 0]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 42
    view.UseLight = 0
    sun = pvs.AddLight(view=view)
    sun.Coords = "Scene"
    sun.Type = "Directional"
    sun.Position = [-60 * DEGREE, -150 * DEGREE, 190 * DEGREE]
    sun.FocalPoint = [0, 0, 0]
    sun.Intensity = 1.15
    return view


def show_terrain(view):
    half = [180 * DEGREE, 90 * DEGREE]
    plane = pvs.Plane(Origin=[-half[0], -half[1], 0], Point1=[half[0], -half[1], 0], Point2=[-half[0], half[1], 0])
    pvs.RenameSource("Terrain", plane)
    shown = pvs.Show(plane, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.Texture = pvs.CreateTexture(os.path.join(DATA, "blue_marble_2048.jpg"))
    shown.Ambient, shown.Diffuse = 0.4, 0.45


def show_clouds_and_jets(view):
    forecast = pvs.NetCDFReader(FileName=[os.path.join(DATA, "gfs_2p5deg_2011101100.nc")], SphericalCoordinates=0)
    forecast.Dimensions = "(lev, lat, lon)"
    clouds = pvs.GlobeGrid(Input=forecast, Projection="Map", VerticalExaggeration=EXAGGERATION,
                           UseCentralMeridian=1)  # Greenwich
    pvs.RenameSource("Clouds and winds", clouds)
    shown = pvs.Show(clouds, view)
    pvs.ColorBy(shown, ("POINTS", "Height"))
    shown.SetRepresentationType("Cell Compositing")
    colours = pvs.GetColorTransferFunction("Height")
    colours.AutomaticRescaleRangeMode = "Never"
    colours.ColorSpace = "RGB"
    colours.RGBPoints = CLOUD_COLOURS
    shown.LookupTable = colours
    shown.CellCompositingOpacityArray = "cloud_fraction"
    opacity = pvs.GetOpacityTransferFunction("cloud_fraction")
    opacity.Points = CLOUD_OPACITY
    shown.ScalarOpacityFunction = opacity
    shown.CellCompositingAutomaticUnitDistance = 0
    shown.CellCompositingUnitDistance = UNIT_DISTANCE
    shown.CellCompositingContourArray = "Wind"  # the magnitude of a vector
    shown.CellCompositingContourValues = SPEEDS
    shown.CellCompositingContourColors = SPEED_COLOURS
    shown.CellCompositingContourOpacities = SPEED_OPACITIES
    pvs.GetScalarBar(colours, view).Visibility = 0


def show_caption(view):
    text = "GFS forecast for 2011-10-11 00 UTC, heights exaggerated %d times\nWind speed %s m/s" % (
        EXAGGERATION, ", ".join("%g" % s for s in SPEEDS))
    shown = pvs.Show(pvs.Text(Text=text), view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Upper Left Corner", 18, "Left"
    shown.Color = [0.75, 0.80, 0.88]


pvs._DisableFirstRenderCameraReset()
view = make_view()
show_terrain(view)
show_clouds_and_jets(view)
show_caption(view)
pvs.Render(view)

picture = os.path.join(GALLERY, "12_contours_in_clouds.png")
pvs.SaveScreenshot(picture, view, ImageResolution=[1920, 1080])
print("wrote", picture)
state = os.path.join(GALLERY, "12_contours_in_clouds.pvsm")
pvs.SaveState(state)
print("wrote", state)
