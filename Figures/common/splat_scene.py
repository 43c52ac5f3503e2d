# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures of textured splats share, in plain VTK: the forecast on the globe, its winds at some levels and its clouds as
splats, the terrain, a window with a sun, colours of altitude, caption and colour bar.

    forecast, pressures = read_forecast(30)
    choose_winds(forecast, level_numbers(pressures, (850, 500, 250)), eye)
    window, renderer = make_window((1920, 1080), eye, focus, up, angle, sun)
    renderer.AddActor(vtk_globe.terrain())
    clouds = splats(forecast, CLOUD_OPACITY, 2e5)
    show_winds(clouds.GetMapper(), greatest_speed=40)
    renderer.AddVolume(clouds)
"""
import globe_scene
import nephoscope
import numpy
import pictures
import vtk_globe
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer

# Height in metres: warm below, cold above, all bright enough to be told apart over dark sea and over cloud.
ALTITUDE_COLOURS = ((0, 1.00, 0.30, 0.12), (1500, 1.00, 0.52, 0.10), (3500, 1.00, 0.85, 0.20), (6000, 0.62, 0.95, 0.45),
                    (8500, 0.25, 0.90, 0.90), (11000, 0.45, 0.62, 1.00), (15000, 0.80, 0.52, 1.00))


def read_forecast(exaggeration):
    """The forecast as a curvilinear grid on the globe, with Wind in metres per second and Height in metres; and the pressures of its
    levels in hPa."""
    globe = vtk_globe.analysis_grid(exaggeration)
    globe.Update()
    volume = globe.GetInputDataObject(0, 0)
    # The reader counts pressure, which is positive downwards, as a negative height.
    return globe.GetOutput(), numpy.abs(vtk_to_numpy(volume.GetZCoordinates()))


def level_numbers(pressures, wanted):
    """Which levels are nearest to some pressures in hPa."""
    return [int(numpy.argmin(numpy.abs(pressures - value))) for value in wanted]


def shape(grid):
    """Numbers of levels, latitudes and longitudes."""
    i0, i1, j0, j1, k0, k1 = grid.GetExtent()
    return k1 - k0 + 1, j1 - j0 + 1, i1 - i0 + 1


def field(grid, name):
    """A point array as NumPy's, by level, latitude and longitude."""
    flat = vtk_to_numpy(grid.GetPointData().GetArray(name))
    return flat.reshape(shape(grid) + flat.shape[1:])


def add_field(grid, name, values):
    array = numpy_to_vtk(numpy.ascontiguousarray(values.reshape(grid.GetNumberOfPoints(), -1), dtype=numpy.float32), deep=1)
    array.SetName(name)
    grid.GetPointData().AddArray(array)


def positions(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()).reshape(shape(grid) + (3,))


def choose_winds(grid, levels, eye, horizon=0.0):
    """Adds the array Shown, the wind at some levels and zero elsewhere: behind the planet too, where `horizon` is the least cosine
    between the vertical and the direction of the eye. Towards the poles, where meridians crowd, longitudes are left out."""
    wind, shown = field(grid, "Wind"), facing(grid, eye) > horizon
    shown &= numpy.isin(numpy.arange(shape(grid)[0]), levels)[:, None, None]
    shown &= spread_over_longitudes(grid)
    shown &= field(grid, "BelowGround") == 0
    add_field(grid, "Shown", numpy.where(shown[..., None], wind, 0))


def hide_clouds(grid, eye, horizon=0.0):
    """Sets the cloud fraction to zero behind the planet."""
    add_field(grid, "cloud_fraction", numpy.where(facing(grid, eye) > horizon, field(grid, "cloud_fraction"), 0))


def facing(grid, eye):
    """Cosine between the vertical and the direction of the eye."""
    place = positions(grid)
    up = place / numpy.linalg.norm(place, axis=-1, keepdims=True)
    to_eye = numpy.asarray(eye) - place
    return (up * to_eye).sum(axis=-1) / numpy.linalg.norm(to_eye, axis=-1)


def spread_over_longitudes(grid):
    """True for points that are about as far apart on every parallel as on the equator; the seam's second meridian is left out."""
    _, latitudes, longitudes = shape(grid)
    cosines = numpy.cos(numpy.radians(numpy.linspace(-90, 90, latitudes)))
    steps = [max(1, round(1 / max(cosine, 1e-3))) for cosine in cosines]
    kept = numpy.array([[i % step == 0 for i in range(longitudes)] for step in steps])
    kept[:, -1] = False
    return kept[None]


def splats(grid, opacity, unit_distance, color=(1.0, 1.0, 1.0)):
    """Cloud fraction as splats of one colour: opacity as pairs of fraction and opacity, metres over which 1 gives optical depth 1."""
    mapper = nephoscope.vtkTexturedSplatMapper()
    mapper.SetInputData(grid)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    return vtk_globe.volume(mapper, [(0, *color)], opacity, unit_distance)


def altitude_colors():
    colors = vtkColorTransferFunction()
    for point in ALTITUDE_COLOURS:
        colors.AddRGBPoint(*point)
    return colors


def show_segments(mapper, greatest_speed, opacity, length, pixels, unit):
    """The array Shown as line segments, coloured by altitude; `length` in units, `pixels` wide."""
    show_winds(mapper, greatest_speed, opacity, unit=unit)
    mapper.SetVectorStyleToSegments()
    mapper.SetSegmentLength(length)
    mapper.SetSegmentWidth(pixels)


def show_winds(mapper, greatest_speed, opacity=4.0, width=0.08, period=4.0, unit=0.0):
    """The array Shown as streaks, coloured by altitude."""
    mapper.SetVectorArrayName("Shown")
    mapper.SetVectorColorArrayName("Height")
    mapper.SetVectorColorFunction(altitude_colors())
    mapper.SetMaximumSpeed(greatest_speed)
    mapper.SetVectorOpacity(opacity)
    mapper.SetStreakWidth(width)
    mapper.SetStreakPeriod(period)
    mapper.SetVectorUnit(unit)


def make_window(size, eye, focus, up, angle, sun):
    """A window that is not shown, and its renderer: dark, with one sun."""
    window, renderer = vtk_globe.make_window(size), vtkRenderer()
    window.AddRenderer(renderer)
    renderer.GradientBackgroundOn()
    renderer.SetBackground(globe_scene.NIGHT[0])
    renderer.SetBackground2(globe_scene.NIGHT[1])
    vtk_globe.add_sun(renderer, sun)
    vtk_globe.look(renderer, eye, focus, up, angle)
    return window, renderer


def add_caption(renderer, text, font_size=24, place=(28, 24)):
    caption = vtk_globe.text(text, place, font_size, spacing=1.15)
    renderer.AddViewProp(caption)
    return caption


def add_altitude_bar(renderer, top=12000, labels=5, place=(0.905, 0.28), size=(0.08, 0.44), font_size=22):
    """A bar of altitude in kilometres, from the ground up."""
    colors = vtkColorTransferFunction()
    for height, *color in ALTITUDE_COLOURS:
        colors.AddRGBPoint(height / 1000, *color)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(range_of(colors, top / 1000))
    bar.SetTitle("Altitude (km)\n ")
    bar.SetNumberOfLabels(labels)
    bar.SetLabelFormat(pictures.whole_number_format(bar.GetLabelFormat()))
    bar.UnconstrainedFontSizeOn()
    bar.SetPosition(*place)
    bar.SetPosition2(*size)
    bar.SetBarRatio(0.22)
    for style, points in ((bar.GetTitleTextProperty(), font_size), (bar.GetLabelTextProperty(), font_size)):
        style.SetFontSize(points)
        style.SetColor(*vtk_globe.INK)
        style.BoldOff()
        style.ItalicOff()
        style.ShadowOff()
    renderer.AddViewProp(bar)


def range_of(colors, top):
    """The colours from 0 to a top value as a table."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetRange(0, top)
    for i in range(256):
        table.SetTableValue(i, *colors.GetColor(top * i / 255), 1.0)
    return table
