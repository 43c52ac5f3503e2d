# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 24: light that follows the camera. Above, a cloud in front of the sun; below, a layer of cloud with the sun behind the camera.

On the left every part of a cloud sends the same light to all sides. On the right vtkSunlight has kept single scattering apart, and the mapper multiplies it by the phase function of
cloud droplets (Mie) along every ray: the edges of the upper cloud are bright, the lower one has a fogbow, and a glory around the point opposite the sun. The clouds are made up of
spheres and waves. Writes the picture (1200 x 800).
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import nephoscope  # noqa: E402
import numpy  # noqa: E402
import sunlit  # noqa: E402
from nephoscope import light_image  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402

NAME = "24_silver_lining_and_fogbow"
SKY = numpy.array([0.16, 0.24, 0.40])
GAP = 4  # pixels between the pictures


def cloud(size, spacing, origin, extinction):
    """An image with an extinction (1/m), a function of the positions."""
    data = vtkImageData()
    data.SetDimensions(size)
    data.SetSpacing(spacing)
    data.SetOrigin(origin)
    z, y, x = numpy.meshgrid(*(origin[k] + spacing[k] * numpy.arange(size[k]) for k in (2, 1, 0)), indexing="ij")
    array = numpy_to_vtk(extinction(x, y, z).ravel(), deep=1)
    array.SetName("Extinction")
    data.GetPointData().AddArray(array)
    return data


def cumulus(x, y, z):
    random = numpy.random.default_rng(7)
    inside = numpy.full(x.shape, -1.0)
    for _ in range(90):
        angle, far = random.uniform(0, 2 * numpy.pi), numpy.sqrt(random.uniform())
        height = random.uniform(1250, 1400 + 1100 * (1 - far))
        radius = random.uniform(160, 380) * (1 - (height - 1250) / 3000)
        inside = numpy.maximum(inside, 1 - numpy.sqrt((x - 1000 * far * numpy.cos(angle)) ** 2 + (y - 700 * far * numpy.sin(angle)) ** 2 + (z - height) ** 2) / radius)
    for k, phase in ((0.011, 0.3), (0.019, 1.1), (0.031, 2.2)):
        inside += 0.0015 / k * numpy.sin(k * x + phase) * numpy.sin(k * y + 2 * phase) * numpy.sin(k * z + 3 * phase)
    return 0.04 * numpy.clip(3 * inside, 0, 1) * numpy.clip((z - 1150) / 60, 0, 1)


def deck(x, y, z):
    top = 300 + 40 * numpy.sin(x / 310) * numpy.sin(y / 290 + 1) + 25 * numpy.sin(x / 170 + y / 400) * numpy.sin(y / 150)
    return 0.03 * numpy.clip((top - z) / 60, 0, 1) * numpy.clip((z - 40) / 40, 0, 1)


def seen(data, sun, camera, size, exposure, follows):
    """Display values of the cloud in front of the sky."""
    light = nephoscope.vtkSunlight()
    light.SetInputData(data)
    light.SetSunDirection(sun)
    light.SetFollowCamera(follows)
    light.SetPhaseFunctionToCloudDroplets()
    light.Update()
    towards_eye, opacity = light_image.light_of_clouds(light.GetOutput(), camera, size)
    assert numpy.isfinite(vtk_to_numpy(light.GetOutput().GetPointData().GetArray("Sunlight"))).all()
    return sunlit.shown(towards_eye + (1 - opacity[..., None]) * SKY, exposure, "contrast")


options = argparse.ArgumentParser(description="Clouds with the same light from all sides, and with light that follows the camera: a picture.")
options.add_argument("--size", type=int, nargs=2, default=[1200, 800], help="width and height, pixels")
wanted = options.parse_args()
size = [(length - GAP) // 2 for length in wanted.size]
against = cloud((121, 101, 61), (26, 26, 26), (-1560, -1300, 1100), cumulus), (0.12, 1, 0.22), sunlit.camera((0, -4600, 1250), (0, 0, 1800), (0, 0, 1), 26), size, 0.9
along = cloud((121, 121, 13), (100, 100, 40), (-6000, -6000, 0), deck), (0, -0.77, 0.64), sunlit.camera((0, -1500, 1500), (0, 420, 0), (0, 0, 1), 95), size, 1.9
rows = [numpy.hstack([seen(*scene, False), numpy.zeros((size[1], GAP, 3), numpy.uint8), seen(*scene, True)]) for scene in (against, along)]
gap = numpy.zeros((GAP, rows[0].shape[1], 3), numpy.uint8)
sunlit.save(numpy.vstack([rows[0], gap, rows[1]]), os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"))
