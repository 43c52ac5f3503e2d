# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 14: the air over the eastern Pacific, its cells divided at four temperatures, the layers drawn apart.

Every cell that a temperature crosses is divided into convex pieces (thin lines); the others are whole. The layers fit together
without a gap: they are only moved apart here. Writes the picture (1600 x 1000).
"""
import os

from paraview import simple as pvs

DATA = os.environ["NEPHOSCOPE_DATA"]
GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
TEMPERATURES = [293.15, 273.15, 248.15, 223.15]  # kelvin
# Longitudes 232.5 to 270 E, latitudes 0 to 30 N, all levels, as indices of the file.
REGION = [93, 108, 36, 48, 0, 20]
EXAGGERATION = 120
GAP = 6e5  # metres of the display between layers
# Layer, the number of temperatures below the air: cold to warm.
COLOURS = [0, 0.29, 0.42, 0.75, 1, 0.55, 0.76, 0.88, 2, 0.95, 0.95, 0.88, 3, 0.98, 0.75, 0.45, 4, 0.84, 0.36, 0.26]


def make_view():
    view = pvs.CreateRenderView(ViewSize=[1600, 1000], OrientationAxesVisibility=0, UseColorPaletteForBackground=0)
    pvs.AssignViewToLayout(view, layout=pvs.CreateLayout("Cells in layers"))
    view.BackgroundColorMode = "Single Color"
    view.Background = [1, 1, 1]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 30
    return view


def divided_air():
    forecast = pvs.NetCDFReader(FileName=[os.path.join(DATA, "gfs_2p5deg_2011101100.nc")], SphericalCoordinates=0)
    forecast.Dimensions = "(lev, lat, lon)"
    forecast.UpdatePipeline()
    region = pvs.ExtractSubset(Input=forecast, VOI=REGION)
    air = pvs.GlobeGrid(Input=region, Projection="Map", VerticalExaggeration=EXAGGERATION)
    air.UpdatePipeline()
    layers = pvs.ContourCellSplitter(Input=air, ContourBy=["POINTS", "t"], ContourValues=TEMPERATURES, GenerateSurfaces=0)
    pvs.RenameSource("Air divided at temperatures", layers)
    return layers


def show_layer(view, layers, layer, colours):
    """Cold air is above: the higher the layer, the fewer temperatures are below its own."""
    part = pvs.Threshold(Input=layers, Scalars=["CELLS", "Layer"], LowerThreshold=layer, UpperThreshold=layer)
    moved = pvs.Transform(Input=part)
    moved.Transform.Translate = [0, 0, (len(TEMPERATURES) - layer) * GAP]
    pvs.RenameSource(f"Layer {layer}", moved)
    shown = pvs.Show(moved, view)
    shown.SetRepresentationType("Surface With Edges")
    pvs.ColorBy(shown, ("CELLS", "Layer"))
    shown.LookupTable = colours
    shown.SetScalarBarVisibility(view, False)
    shown.EdgeColor = [0.15, 0.17, 0.22]
    shown.LineWidth = 1.0
    shown.Ambient, shown.Diffuse, shown.Specular = 0.35, 0.75, 0.0
    return shown


def show_legend(view):
    celsius = ", ".join("%.0f" % (t - 273.15) for t in TEMPERATURES)
    caption = pvs.Text(Text="GFS forecast for 2011-10-11 00 UTC,\neastern Pacific. Cells divided\n"
                            f"at {celsius} \N{DEGREE SIGN}C, layers moved apart.\nHeights exaggerated {EXAGGERATION} times.")
    shown = pvs.Show(caption, view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Lower Left Corner", 18, "Left"
    shown.Color = [0.25, 0.27, 0.32]


pvs._DisableFirstRenderCameraReset()
view = make_view()
divided = divided_air()
table = pvs.GetColorTransferFunction("Layer")
table.AutomaticRescaleRangeMode = "Never"
table.ColorSpace = "RGB"
for number in range(len(TEMPERATURES) + 1):
    show_layer(view, divided, number, table)
table.RGBPoints = COLOURS  # now: a layer shown alone has set the range to its own number
show_legend(view)
view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition = [-6.5, -10.5, 4.6]  # the direction only: the camera is moved back to see everything
view.ResetCamera()
view.GetActiveCamera().Zoom(1.0)
picture = os.path.join(GALLERY, "14_cells_in_layers.png")
pvs.SaveScreenshot(picture, view, ImageResolution=[1600, 1000])
print("wrote", picture)
