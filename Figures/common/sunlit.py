# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures of sunlight share: lit clouds, and pictures of them and of the ground in floating point, with a tone curve and captions."""
import os

import nephoscope
import numpy
from nephoscope import light_image, tone
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkCamera

import air
import globe_scene

SKY_LIGHT = 0.08
SKY_COLOUR = (0.6, 0.9, 1.5)


def lit_clouds(fields, exaggeration, sun, eye, projection="globe", ground_albedo=0.1, scale=1.0):
    """Sunlight on the clouds of longitude-latitude-level fields; `sun`: a direction, or a date and time."""
    globe = nephoscope.vtkGlobeGrid()
    globe.SetInputData(fields)
    globe.SetVerticalExaggeration(exaggeration)
    globe.SetMaskBelowGround(False)
    globe.SetWindArrayNames("", "", "")
    if projection == "map":
        globe.SetProjectionToMap()
    optics = nephoscope.vtkCloudOptics()
    optics.SetInputConnection(globe.GetOutputPort())
    optics.SetTotalWaterArrayName("clwmr")
    light = nephoscope.vtkSunlight()
    light.SetInputConnection(optics.GetOutputPort())
    if isinstance(sun, str):
        light.SetDateTime(sun)
    else:
        light.SetSunDirection(*sun)
    light.SetExtinctionScale(scale)
    light.SetGroundAlbedo(ground_albedo)
    light.SetSkyLight(SKY_LIGHT)
    light.UseViewPositionOn()
    light.SetViewPosition(*eye)
    light.Update()
    return light.GetOutput()


def camera(eye, focus, up, angle):
    made = vtkCamera()
    made.SetPosition(*eye)
    made.SetFocalPoint(*focus)
    made.SetViewUp(*up)
    made.SetViewAngle(angle)
    return made


def blue_marble():
    """Its reflectances, (latitude, longitude, 3), from the north and from 180 degrees west."""
    reader = vtkJPEGReader()
    reader.SetFileName(os.path.join(globe_scene.DATA, "blue_marble_2048.jpg"))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    encoded = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)[::-1]
    return tone.decoded(encoded / 255.0)


def ground_colours(places):
    """Blue Marble at places on the globe, between its pixels."""
    picture = blue_marble()
    longitude, latitude = light_image.longitudes_latitudes(numpy.nan_to_num(places))
    height, width, _ = picture.shape
    x, y = (longitude + 180) / 360 * width - 0.5, (90 - latitude) / 180 * height - 0.5
    i, j = numpy.floor(x).astype(int), numpy.clip(numpy.floor(y).astype(int), 0, height - 2)
    a, b = (x - i)[..., None], numpy.clip(y - j, 0, 1)[..., None]
    rows = [(1 - a) * picture[j + k, i % width] + a * picture[j + k, (i + 1) % width] for k in (0, 1)]
    return (1 - b) * rows[0] + b * rows[1]


def add_colours(clouds, scattering):
    """Names of three new arrays: the light of each point in red, green and blue. The light of the sky is blue; all above it is sunlight, reddened and dimmed on its way to the point."""
    light = vtk_to_numpy(clouds.GetPointData().GetArray("Sunlight"))[:, None]
    sunlight = scattering.sunlight(vtk_to_numpy(clouds.GetPoints().GetData()).astype(float))
    of_sky = numpy.minimum(light, SKY_LIGHT)
    names = ["SunlightRed", "SunlightGreen", "SunlightBlue"]
    for name, part in zip(names, ((light - of_sky) * sunlight + of_sky * SKY_COLOUR).T):
        array = numpy_to_vtk(numpy.ascontiguousarray(part, numpy.float32), deep=1)
        array.SetName(name)
        clouds.GetPointData().AddArray(array)
    return names


def glint(places, direction, sun, wind):
    """The sun in water whose waves slope as Cox and Munk (1954) measured at a wind in m/s; Fresnel's reflection after Schlick (1994)."""
    up = numpy.nan_to_num(places / numpy.linalg.norm(places, axis=-1, keepdims=True), nan=1.0)
    half = sun - direction
    half = half / numpy.linalg.norm(half, axis=-1, keepdims=True)
    tilt, incidence = numpy.clip((half * up).sum(-1), 0.05, 1), numpy.clip((half * sun).sum(-1), 0, 1)
    variance = 0.003 + 0.00512 * wind
    slopes = numpy.exp(-(1 / tilt**2 - 1) / variance) / variance
    reflected = 0.02 + 0.98 * (1 - incidence) ** 5
    return reflected * slopes / (4 * numpy.clip(-(direction * up).sum(-1), 0.15, 1) * tilt**4) * ((up @ sun) > 0)


def at_ground(data, places, name, otherwise):
    """The array at the lowest level of a structured globe above the positions; `otherwise` outside the grid."""
    size = [0, 0, 0]
    data.GetDimensions(size)
    lowest = vtk_to_numpy(data.GetPoints().GetData()).reshape(size[2], size[1], size[0], 3)[0].astype(float)
    values = vtk_to_numpy(data.GetPointData().GetArray(name)).reshape(size[2], size[1], size[0])[0].astype(float)
    x, y = light_image.longitudes_latitudes(lowest)
    at_x, at_y = light_image.longitudes_latitudes(places)
    x = numpy.degrees(numpy.unwrap(numpy.radians(x[size[1] // 2])))
    x, values = (x, values) if x[-1] > x[0] else (x[::-1], values[:, ::-1])
    return bilinear(x, y[:, 0], values, x[0] + (at_x - x[0]) % 360, at_y, otherwise)


def bilinear(x, y, values, at_x, at_y, otherwise):
    if y[-1] < y[0]:
        y, values = y[::-1], values[::-1]
    inside = (at_x >= x[0]) & (at_x <= x[-1]) & (at_y >= y[0]) & (at_y <= y[-1])
    i = numpy.clip(numpy.searchsorted(x, numpy.where(inside, at_x, x[0]), "right") - 1, 0, len(x) - 2)
    j = numpy.clip(numpy.searchsorted(y, numpy.where(inside, at_y, y[0]), "right") - 1, 0, len(y) - 2)
    a = numpy.where(inside, (at_x - x[i]) / (x[i + 1] - x[i]), 0)
    b = numpy.where(inside, (at_y - y[j]) / (y[j + 1] - y[j]), 0)
    mixed = (1 - b) * ((1 - a) * values[j, i] + a * values[j, i + 1]) + b * ((1 - a) * values[j + 1, i] + a * values[j + 1, i + 1])
    return numpy.where(inside, mixed, otherwise)


class View:
    """A camera and the pixels of a picture, `samples` x `samples` rays in each."""

    def __init__(self, camera, size, samples):
        self.camera, self.samples, self.size = camera, samples, [samples * length for length in size]
        self.origin, self.direction = light_image.rays(camera, self.size)

    def average(self, light):
        height, width = light.shape[0] // self.samples, light.shape[1] // self.samples
        return light.reshape(height, self.samples, width, self.samples, -1).mean(axis=(1, 3))

    def globe(self, clouds, exaggeration, flat=None, wind=None, colours=False):
        """Light of clouds, ground and air, (height, width, 3).

        `flat`: clouds that all send this light, over a ground without shadows. `wind` (m/s): water reflects the sun. `colours`: each point of the clouds has
        the colour of the sun at its height, and light of the sky is blue; otherwise all light has the colour of the sun at 6 km.
        """
        radius, sun = light_image.planet_radius(clouds), light_image.sun_of(clouds)
        scattering = air.Air(radius, exaggeration, sun)
        light, hidden = light_image.light_of_clouds(clouds, self.camera, self.size, add_colours(clouds, scattering) if colours and flat is None else ("Sunlight",))
        hidden = hidden[..., None]
        places = light_image.meet_ground(clouds, self.origin, self.direction)
        if flat is not None:
            return self.average(flat * hidden + (1 - hidden) * numpy.where(numpy.isfinite(places[..., :1]), 0.8 * ground_colours(places), 0))
        if not colours:
            light = light * self.tint(scattering, self.cloud_places(radius + 6000 * exaggeration))
        on_ground = numpy.isfinite(places[..., :1])
        cosine = light_image.zenith_cosine(clouds, places)
        arriving = at_ground(clouds, places, "Irradiance", light_image.clear_irradiance(cosine, SKY_LIGHT))
        albedo = ground_colours(places)
        ground = numpy.where(on_ground, albedo * (arriving[..., None] * self.tint(scattering, places)), 0)
        if wind is not None:
            direct = at_ground(clouds, places, "SunTransmittance", numpy.where(cosine > 0, 1.0, 0.0))[..., None] * scattering.sunlight(numpy.nan_to_num(places, nan=1.0))
            ground = ground + numpy.where(on_ground & (albedo[..., 2:] > 1.3 * albedo[..., :1]), glint(places, self.direction, sun, wind)[..., None] * direct, 0)
        stop = numpy.linalg.norm(places - self.origin, axis=-1)
        glow, passing = (self.finer(x) for x in scattering.before(*(x[::self.samples, ::self.samples] for x in (self.origin, self.direction, stop))))
        clouds_seen = light * (0.5 + 0.5 * passing)  # half of the air is below them
        return self.average(clouds_seen + (1 - hidden) * ground * passing + glow * (1 - 0.5 * hidden))

    def cloud_places(self, radius):
        """Where the rays come nearest to a sphere, or meet it."""
        middle = -(self.origin * self.direction).sum(-1)
        root = radius**2 - (self.origin**2).sum(-1) + middle**2
        return self.origin + (middle - numpy.sqrt(numpy.maximum(root, 0)))[..., None] * self.direction

    @staticmethod
    def tint(scattering, places):
        """Sunlight's colour at places, its green is 1; softened by the light of the sky, which is not reddened."""
        colour = scattering.sunlight(numpy.nan_to_num(places, nan=1.0)) + 0.2
        return colour / colour[..., 1:2]

    def finer(self, values):
        return values.repeat(self.samples, axis=0).repeat(self.samples, axis=1)


def shown(light, exposure, tone_mapping):
    """Display values, 0 to 255, of light (height, width, 3)."""
    return numpy.rint(255 * tone.toned(light, exposure, tone_mapping)).astype(numpy.uint8)


def write(light, path, exposure, tone_mapping="filmic", announce=True):
    """Light (height, width, 3), from the top, as a PNG."""
    save(shown(light, exposure, tone_mapping), path, announce)


def save(pixels, path, announce=True):
    """Display values (height, width, 3), from the top, as a PNG."""
    height, width, _ = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.ascontiguousarray(pixels[::-1]).reshape(-1, 3), deep=1))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()
    if announce:
        print("wrote", path)
