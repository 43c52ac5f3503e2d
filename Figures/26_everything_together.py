# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 26: everything in one view, an island with a volcano in the trade wind.

The ground is a surface. Cumulus over its slopes is drawn cell by cell in the light that vtkSunlight computes; the smoke of the volcano is a flow volume in the same medium. A
layer of stratocumulus is a textured surface, the wind over the sea is textured splats, and a translucent surface bounds the air that rises faster than 1.2 m/s. One
vtkHaze lies over all of it, with the shadows of the clouds. Ground, wind and clouds are made of formulas and random waves; lengths are in metres. Writes the picture (1600 x 900).
"""
import argparse
import os
import sys

import numpy
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  the factory
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataNormals, vtkProbeFilter
from vtkmodules.vtkFiltersGeneral import vtkWarpScalar
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkRenderingCore import vtkBillboardTextActor3D, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import nephoscope  # noqa: E402
import pictures  # noqa: E402
import splat_scene  # noqa: E402
import vtk_globe  # noqa: E402

NAME = "26_everything_together"
ELEVATION, AZIMUTH = numpy.radians((22, 168))  # of the sun
SUN = (numpy.cos(ELEVATION) * numpy.cos(AZIMUTH), numpy.cos(ELEVATION) * numpy.sin(AZIMUTH), numpy.sin(ELEVATION))
SUMMIT, RADIUS, CRATER = 2500.0, 8000.0, 450.0
SPEED = 8.0            # of the wind, m/s, towards +x
MOST = 0.02            # extinction of the clouds, 1/m
WHITE = 0.62           # light that is shown as white
WATER = (0.03, 0.11, 0.19)
LABELS = (("smoke, 40 minutes old", (8000, 0, 4500)), ("air that rises faster than 1.2 m/s", (-4200, 3500, 3300)), ("wind at 60 m", (-9800, -10200, 500)))
GROUND = ((0, 0.72, 0.66, 0.50), (40, 0.16, 0.24, 0.09), (700, 0.11, 0.19, 0.07), (1400, 0.28, 0.24, 0.15), (1900, 0.24, 0.20, 0.18), (2300, 0.16, 0.13, 0.12))


def noise(shape, smallest, largest, seed, slope=-2.0):
    """Random waves of some numbers of periods along the second axis, of mean 0 and standard deviation 1."""
    frequencies = numpy.meshgrid(*(numpy.fft.fftfreq(n) * n for n in shape), indexing="ij")
    number = numpy.sqrt(sum(f ** 2 for f in frequencies))
    spectrum = numpy.where((number >= smallest) & (number <= largest), (number + 1) ** slope, 0)
    field = numpy.fft.ifftn(spectrum * numpy.fft.fftn(numpy.random.default_rng(seed).standard_normal(shape))).real
    return field / field.std()


def height(x, y):
    """Height of the ground, m: a cone with a crater, gullies and a rough coast."""
    distance, bearing = numpy.hypot(x, y), numpy.arctan2(y, x)
    coast = RADIUS * (1 + 0.10 * numpy.sin(3 * bearing + 1) + 0.06 * numpy.sin(7 * bearing) + 0.25 * numpy.cos(bearing - 2.6) ** 2)
    share = numpy.clip(1 - distance / coast, -0.2, 1)
    cone = SUMMIT * numpy.sign(share) * numpy.abs(share) ** 1.35
    gullies = 1 - 0.10 * (0.5 + 0.5 * numpy.sin(23 * bearing + 3 * numpy.sin(distance / 900))) * numpy.clip(4 * share * (1 - share), 0, 1)
    return numpy.where(distance < CRATER, cone - 260 * (1 - (distance / CRATER) ** 2), cone) * gullies - 5


def image(low, high, points):
    """An image and the coordinates of its points, the first index last."""
    low, high, points = numpy.array(low, float), numpy.array(high, float), numpy.array(points)
    made = vtkImageData()
    made.SetDimensions(*points)
    made.SetOrigin(*low)
    made.SetSpacing(*((high - low) / numpy.maximum(points - 1, 1)))
    z, y, x = numpy.meshgrid(*(numpy.linspace(low[a], high[a], points[a]) for a in (2, 1, 0)), indexing="ij")
    return made, x, y, z


def add_array(data, name, values):
    array = numpy_to_vtk(numpy.ascontiguousarray(values, numpy.float32).reshape(-1, *values.shape[3:]), deep=1)
    array.SetName(name)
    data.GetPointData().AddArray(array)


def ground():
    data, x, y, _ = image((-12000, -12000, 0), (12000, 12000, 0), (481, 481, 1))
    rough = noise((481, 481), 12, 120, 5, -1.3)[None]
    values = height(x, y)
    add_array(data, "Height", values + 45 * rough * numpy.clip(values / 300, 0, 1))
    data.GetPointData().SetActiveScalars("Height")
    surface, warp, normals = vtkImageDataGeometryFilter(), vtkWarpScalar(), vtkPolyDataNormals()
    surface.SetInputData(data)
    warp.SetInputConnection(surface.GetOutputPort())
    normals.SetInputConnection(warp.GetOutputPort())
    normals.SetFeatureAngle(80)
    mapper, colours = vtkPolyDataMapper(), vtkColorTransferFunction()
    for point in GROUND:
        colours.AddRGBPoint(*point)
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetLookupTable(colours)
    return vtk_globe.actor_of(mapper, ambient=0.30, diffuse=1.1)


def cell_mapper(scalars, opacity=None):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(scalars)
    if opacity:
        mapper.SetOpacityArrayName(opacity)
    return mapper


def clouds():
    """Cumulus with a flat base over the slopes and in the lee, and a few over the sea, in the sun."""
    shape = (37, 151, 181)
    data, x, y, z = image((-11000, -9000, 1020), (19000, 16000, 3720), shape[::-1])
    place, rough = noise(shape[1:], 4, 40, 21, -1.6)[None], noise(shape, 9, 70, 3, -1.2)
    over = numpy.exp(-((x - 2500) ** 2 / 8500 ** 2 + (y - 500) ** 2 / 7000 ** 2))
    seaward = numpy.clip(1 - (x + y + 7000) / 4000, 0, 1)  # few between the eye and the island
    tops = 1420.0 * numpy.clip(place - 1.35 + 1.25 * over - 1.5 * seaward, 0, None) ** 0.5
    free = numpy.clip(numpy.hypot(x + 300, y) / 2300 - 0.8, 0, 1)  # above the crater it is clear
    inside = numpy.clip((tops * free + 210 * rough - (z - 1250)) / 220, 0, 1) * numpy.clip((z - 1050) / 120, 0, 1) * (tops * free > 0)
    add_array(data, "Extinction", MOST * inside)
    light = nephoscope.vtkSunlight()
    light.SetInputData(data)
    light.SetSunDirection(SUN)
    light.Update()
    mapper = cell_mapper("Sunlight", "ScaledExtinction")
    mapper.SetInputData(light.GetOutput())
    return vtk_globe.volume(mapper, ((0, 0.04, 0.05, 0.08), (0.3, 0.52, 0.50, 0.52), (WHITE, 1.0, 0.95, 0.86)), ((0, 0), (MOST, 1)), 1 / MOST)


def wind():
    """The trade wind parts around the volcano and rises over it; gas rises from the crater."""
    data, x, y, z = image((-20000, -16000, 0), (30000, 16000, 6000), (126, 81, 41))
    land, bearing, distance = height(x, y), numpy.arctan2(y, x), numpy.maximum(numpy.hypot(x, y), 1.0)
    obstacle = 0.8 * RADIUS * (1 - numpy.clip(z / SUMMIT, 0, 1) ** 0.65)  # its radius at this height
    around = numpy.minimum((obstacle / distance) ** 2, 1)
    speed = SPEED * (0.6 + 0.4 * z / 2500)
    u, v = speed * (1 - around * numpy.cos(2 * bearing)), -speed * around * numpy.sin(2 * bearing)
    slope = numpy.gradient(land, data.GetSpacing()[0], axis=2)
    lift = u * slope * numpy.exp(-numpy.clip(z - land, 0, None) / 600)
    lee = numpy.clip(x / 8000, 0, 1)
    w = lift + 14 * numpy.exp(-distance ** 2 / 700 ** 2 - (numpy.clip(z - SUMMIT, 0, None) / 1500) ** 2)
    v += lee * (1.2 * numpy.sin(x / 1300) + 1.3e-3 * numpy.clip(y, -3000, 3000))  # eddies and turbulence widen the plume
    w += lee * (0.9 * numpy.sin(x / 900 + 1) + 1.1e-3 * numpy.clip(z - 3900, -900, 900))
    add_array(data, "Wind", numpy.stack((u, v, w), axis=-1) * (z > land - 200)[..., None])
    add_array(data, "Lift", lift)
    data.GetPointData().SetActiveVectors("Wind")
    return data


def smoke(data):
    flow = nephoscope.vtkFlowVolume()
    flow.SetInputData(data)
    flow.SetCenter(0, 0, SUMMIT + 60)
    flow.SetRadius(330)
    flow.SetNormal(0, 0, 1)
    flow.SetNormalToFlow(0)
    flow.SetDuration(2400)
    flow.SetTimeStep(30)
    mapper = cell_mapper("SmoothDensity")
    mapper.SetInputConnection(flow.GetOutputPort())
    return vtk_globe.volume(mapper, ((0, 0.34, 0.27, 0.24), (1, 0.26, 0.18, 0.15)), ((0, 0), (1, 1)), 200)


def streaks(data):
    """The wind 60 m above the sea, at random places. Below the clouds: volumes that overlap take longer to draw."""
    random = numpy.random.default_rng(2)
    places = numpy.column_stack((random.uniform(-17000, 20000, 2000), random.uniform(-15000, 15000, 2000), numpy.full(2000, 60.0)))
    places = places[height(places[:, 0], places[:, 1]) < 0]
    points, probe, at = vtkPoints(), vtkProbeFilter(), vtkPolyData()
    points.SetData(numpy_to_vtk(places, deep=1))
    at.SetPoints(points)
    probe.SetInputData(at)
    probe.SetSourceData(data)
    probe.Update()
    mapper = nephoscope.vtkTexturedSplatMapper()
    mapper.SetInputData(probe.GetOutput())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("Lift")
    made = vtk_globe.volume(mapper, ((0, 1, 1, 1),), ((0, 0), (1, 0)), 1e3)
    splat_scene.show_winds(mapper, 1.5 * SPEED, opacity=5, width=0.06, unit=240)
    mapper.SetRadiusFactor(0.6)
    mapper.SetVectorArrayName("Wind")
    mapper.SetVectorColorArrayName("Lift")
    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(0, 0.75, 0.95, 1.0)
    mapper.SetVectorColorFunction(colour)
    return made


def rising_air(data):
    contour, mapper = vtkContourFilter(), vtkPolyDataMapper()
    contour.SetInputData(data)
    contour.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Lift")
    contour.SetValue(0, 1.2)
    mapper.SetInputConnection(contour.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk_globe.actor_of(mapper, 0.4, 0.7)
    actor.GetProperty().SetColor(0.35, 0.95, 0.85)
    actor.GetProperty().SetOpacity(0.28)
    return actor


def stratocumulus():
    """A layer over the sea beyond the island, with a ragged edge."""
    data, x, y, _ = image((-70000, 9000, 0), (70000, 103000, 0), (201, 141, 1))
    add_array(data, "Cover", numpy.clip((y - 12000) / 10000 + 0.35 * noise((141, 201), 4, 30, 8)[None], 0, 1))
    add_array(data, "Top", 900 + 60 * noise((141, 201), 8, 70, 9, -1.5)[None])
    data.GetPointData().SetActiveScalars("Top")
    surface, warp = vtkImageDataGeometryFilter(), vtkWarpScalar()
    surface.SetInputData(data)
    warp.SetInputConnection(surface.GetOutputPort())
    mapper = nephoscope.vtkCloudTextureMapper()
    mapper.SetInputConnection(warp.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetCoverageArrayName("Cover")
    mapper.SetTextureLength(6000)
    mapper.SetThinColor(0.60, 0.58, 0.60)
    mapper.SetThickColor(1.0, 0.95, 0.88)
    return vtk_globe.actor_of(mapper, ambient=0.6, diffuse=0.6)


def label(words, place):
    made = vtkBillboardTextActor3D()
    made.SetInput(words)
    made.SetPosition(*place)
    style = made.GetTextProperty()
    style.SetFontSize(max(10, wanted.size[0] // 70))
    style.SetColor(1, 1, 1)
    style.ShadowOn()
    return made


def everything(renderer):
    air = wind()
    for actor in (vtk_globe.sea(WATER, 3e5), ground(), rising_air(air), stratocumulus()):
        renderer.AddActor(actor)
    for drawn in (clouds(), smoke(air), streaks(air)):
        renderer.AddVolume(drawn)
    for words, place in LABELS:
        renderer.AddActor(label(words, place))


def haze():
    made = nephoscope.vtkHaze()
    made.SetProjectionToMap()
    made.SetVisibility(90e3)
    made.SetScaleHeight(2500)
    made.SetVerticalExaggeration(1)
    made.SetColor(0.70, 0.72, 0.76)
    made.SetSunDirection(SUN)
    return made


options = argparse.ArgumentParser(description="Everything in one view: a picture.")
options.add_argument("--size", type=int, nargs=2, default=[1600, 900], help="width and height, pixels")
wanted = options.parse_args()
window, renderer = vtk_globe.make_window(wanted.size, samples=0), vtkRenderer()
window.AddRenderer(renderer)
renderer.SetBackground(0.20, 0.36, 0.62)
renderer.AutomaticLightCreationOff()
vtk_globe.add_sun(renderer, [1e6 * c for c in SUN])
renderer.UseDepthPeelingOn()  # the surface of rising air is translucent, and cuts clouds
renderer.UseDepthPeelingForVolumesOn()
renderer.SetOcclusionRatio(0)
renderer.SetMaximumNumberOfPeels(8)
everything(renderer)
vtk_globe.look(renderer, eye=(-15500, -17000, 3700), focus=(1900, 1500, 1500), up=(0, 0, 1), angle=32)
renderer.ResetCameraClippingRange()
nephoscope.vtkHaze.SetHaze(renderer, haze())
window.Render()
pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"))
