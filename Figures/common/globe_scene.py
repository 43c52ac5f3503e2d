# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures over the globe share: places, a view in the dark with a sun, the terrain, the forecast."""
import math
import os

from paraview import simple as pvs

DATA = os.environ["NEPHOSCOPE_DATA"]
PLANET_RADIUS = 6371000.0  # metres
NIGHT = ([0.004, 0.006, 0.016], [0.03, 0.05, 0.11])  # colours of the background, below and above


def on_globe(longitude, latitude, radii=1.0, height=0.0):
    """Cartesian metres of a place in degrees: so many metres of the display above the ground, and then so many times as far from
    the planet's centre."""
    lon, lat, r = math.radians(longitude), math.radians(latitude), radii * (PLANET_RADIUS + height)
    return [r * math.cos(lat) * math.cos(lon), r * math.cos(lat) * math.sin(lon), r * math.sin(lat)]


def make_view(name, position, focus, up, angle, sun, size=(1920, 1080), background=NIGHT, sunshine=1.0):
    """A view lit by one sun; `name` is that of its layout, without which a window opens the state without the view."""
    view = pvs.CreateRenderView(ViewSize=list(size), OrientationAxesVisibility=0, UseColorPaletteForBackground=0)
    pvs.AssignViewToLayout(view, layout=pvs.CreateLayout(name))
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = background
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp, view.CameraViewAngle = position, focus, up, angle
    view.UseLight = 0
    light = pvs.AddLight(view=view)
    light.Coords, light.Type, light.Position, light.FocalPoint = "Scene", "Directional", sun, [0, 0, 0]
    light.Intensity = sunshine
    return view


def load_texture(path):
    """A texture that has its image: ParaView 5.13 does not read the file when it makes the texture, but when all is sent once more."""
    texture = pvs.CreateTexture(path)
    texture.SMProxy.MarkAllPropertiesAsModified()
    texture.SMProxy.UpdateVTKObjects()
    image = texture.SMProxy.GetClientSideObject().GetInputAlgorithm()
    image.Update()
    if image.GetOutput().GetNumberOfPoints() == 0:
        raise RuntimeError(f"ParaView has not read the texture {path}")
    return texture


def show_terrain(view, ambient, diffuse, specular=0.12):
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
    shown.Texture = load_texture(os.path.join(DATA, "blue_marble_2048.jpg"))
    shown.InterpolateTextures = 1  # near the ground the pixels of the texture would be seen
    shown.Ambient, shown.Diffuse, shown.Specular, shown.SpecularPower = ambient, diffuse, specular, 20
    return shown


def show_ground(view, exaggeration, ambient, diffuse, **projection):
    """Mountains at their height, coloured by it; returns what is shown."""
    fields = pvs.NetCDFReader(FileName=[os.path.join(DATA, "gfs_2p5deg_2011101100.nc")], SphericalCoordinates=0, Dimensions="(lat, lon)")
    ground = pvs.GlobeTerrain(Input=fields, VerticalExaggeration=exaggeration, **projection)
    pvs.RenameSource("Terrain", ground)
    shown = pvs.Show(ground, view)
    pvs.ColorBy(shown, ("POINTS", "Terrain"))
    shown.LookupTable.ApplyPreset("Nephoscope Terrain", False)
    shown.LookupTable.AutomaticRescaleRangeMode = "Never"
    shown.LookupTable.NumberOfTableValues = 2048  # the coast is a jump in it
    shown.InterpolateScalarsBeforeMapping = 1
    shown.Ambient, shown.Diffuse, shown.Specular = ambient, diffuse, 0.05
    return shown


def drape_picture(shown):
    """Shows terrain under the satellite picture, whose coasts are finer than those of the forecast, in place of its colours by height."""
    shown.ColorArrayName = ["POINTS", ""]
    shown.Texture = load_texture(os.path.join(DATA, "blue_marble_2048.jpg"))
    shown.InterpolateTextures = shown.RepeatTextures = 1


def read_forecast(exaggeration, name="Forecast", **projection):
    forecast = pvs.NetCDFReader(FileName=[os.path.join(DATA, "gfs_2p5deg_2011101100.nc")], SphericalCoordinates=0)
    forecast.Dimensions = "(lev, lat, lon)"
    grid = pvs.GlobeGrid(Input=forecast, VerticalExaggeration=exaggeration, **projection)
    pvs.RenameSource(name, grid)
    return grid


def colour_table(array, points):
    table = pvs.GetColorTransferFunction(array)
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace = "RGB"
    table.RGBPoints = points
    return table


def show_clouds(grid, view, opacity_points, unit_distance, colour_array, colours, representation="Cell Compositing"):
    """The cloud fraction as a volume of cells or splats, coloured by an array; returns what is shown and its colour table."""
    shown = show_volume(grid, view, colour_array, colours, opacity_points, unit_distance, representation, "cloud_fraction")
    return shown, shown.LookupTable


def show_volume(data, view, colour_array, colours, opacity_points, unit_distance, representation="Cell Compositing", opacity_array=None):
    shown = pvs.Show(data, view)
    pvs.ColorBy(shown, ("POINTS", colour_array))
    shown.SetRepresentationType(representation)
    shown.LookupTable = colour_table(colour_array, colours)
    shown.SetScalarBarVisibility(view, False)
    prefix = representation.replace(" ", "")  # of its properties
    if opacity_array not in (None, colour_array):
        setattr(shown, prefix + "OpacityArray", opacity_array)
    opacity = pvs.GetOpacityTransferFunction(opacity_array or colour_array)
    opacity.Points = opacity_points
    shown.ScalarOpacityFunction = opacity
    setattr(shown, prefix + "AutomaticUnitDistance", 0)
    setattr(shown, prefix + "UnitDistance", unit_distance)
    return shown


def save_small(picture, view, size, shrink):
    """With captions and scalar bars, whose sizes are in pixels, as much smaller."""
    sizes = [(shown, name, getattr(shown, name)) for shown in view.Representations
             for name in ("FontSize", "TitleFontSize", "LabelFontSize", "ScalarBarThickness") if hasattr(shown, name)]
    for shown, name, value in sizes:
        setattr(shown, name, max(1, value // shrink))
    pvs.SaveScreenshot(picture, view, ImageResolution=[pixels // shrink for pixels in size])
    for shown, name, value in sizes:
        setattr(shown, name, value)


def save(name, view, size=(1920, 1080)):
    """The picture, and the ParaView state that shows it again. NEPHOSCOPE_FIGURE_SHRINK, by which tests divide the size, shrinks text too."""
    folder = os.environ["NEPHOSCOPE_GALLERY"]
    picture, state = os.path.join(folder, name + ".png"), os.path.join(folder, name + ".pvsm")
    shrink = int(os.environ.get("NEPHOSCOPE_FIGURE_SHRINK", "1"))
    save_small(picture, view, size, shrink)
    print("wrote", picture)
    pvs.SaveState(state)
    print("wrote", state)
