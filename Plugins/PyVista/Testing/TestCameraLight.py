# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light that follows the camera (eye='camera'): single scattering against closed forms from any side, and the same picture as light computed for one eye."""
import unittest

import nephoscope
import numpy as np
import pyvista
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume

pyvista.OFF_SCREEN = True
G = 0.6
BRIGHTEST = 64.0  # that is drawn


def slab(depth, across=1000.0, cells=(5, 5, 41)):
    """Level cloud of thickness 1 from z = 0, so wide that no ray leaves it through a side."""
    grid = pyvista.ImageData(dimensions=cells, spacing=(across / (cells[0] - 1), across / (cells[1] - 1), 1 / (cells[2] - 1)), origin=(-across / 2, -across / 2, 0))
    grid["Extinction"] = np.full(grid.n_points, float(depth))
    return grid


def phase(cosine, g=G):
    return (1 - g**2) / (1 + g**2 - 2 * g * cosine) ** 1.5


def unit(vector):
    return np.array(vector, float) / np.linalg.norm(vector)


def single(depth, sun, along, start=None, albedo=0.9):
    """pi times the radiance from a slab seen in the direction `along`, by one scattering; from outside, or from a height within."""
    sun, along = unit(sun), unit(along)
    z0 = (1.0 if along[2] < 0 else 0.0) if start is None else start
    length = (z0 if along[2] < 0 else 1 - z0) / abs(along[2])
    t = np.linspace(0, length, 20001)
    z = z0 + t * along[2]
    source = depth * np.exp(-depth * t - depth * (1 - z) / sun[2])
    return albedo / 4 * phase(along @ sun) * np.sum((source[1:] + source[:-1]) / 2) * (t[1] - t[0])


def light_seen(mesh, eye, middle, size=(21, 21), up=(0.1, 1, 0.2), parallel=None, angle=20):
    """The light in every pixel, in floating point; `mesh` has light."""
    window, renderer, volume, mapper = vtkRenderWindow(), vtkRenderer(), vtkVolume(), nephoscope.vtkCellCompositingMapper()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    mapper.SetInputData(mesh)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("Sunlight")
    mapper.SetOpacityArrayName("ScaledExtinction")
    volume.SetMapper(mapper)
    densest = float(mesh["ScaledExtinction"].max())
    colours = vtkColorTransferFunction()
    colours.AddRGBPoint(0, 0, 0, 0)
    colours.AddRGBPoint(BRIGHTEST, 1, 1, 1)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(densest, 1)
    volume.GetProperty().SetColor(colours)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(1 / densest)
    renderer.AddVolume(volume)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*middle)
    camera.SetViewUp(*up)
    camera.SetViewAngle(angle)
    if parallel:
        camera.SetParallelProjection(True)
        camera.SetParallelScale(parallel)
    camera.SetClippingRange(1e-3, 1e4)
    window.Render()
    image = vtkImageData()
    assert mapper.CopyFloatImage(image)
    light = BRIGHTEST * vtk_to_numpy(image.GetPointData().GetArray("RGBA")).reshape(size[1], size[0], 4)[..., 0].astype(float)
    window.Finalize()
    return light


class SingleScattering(unittest.TestCase):
    def lit(self, depth, sun, **options):
        return slab(depth).nephoscope.sunlight(sun, **{"multiple_scattering": False, "sky_light": 0, "albedo": 0.9, "asymmetry": G, "eye": "camera", **options})

    def test_slab_from_any_side(self):
        """Above and below, along the sun and against it, perspective and parallel."""
        sun = (0.6, 0, 0.8)
        lit = self.lit(0.8, sun)
        for towards in ((0, 0, 1), (0.6, 0, 0.8), (-0.6, 0, 0.8), (0, 0.8, 0.6), (0, 0, -1), (-0.6, 0, -0.8), (0.6, 0.3, -0.8), (0.8, 0, -0.6)):
            eye = 5 * unit(towards) + (0, 0, 0.5)
            expected = single(0.8, sun, -unit(towards))
            for parallel in (None, 0.5):
                with self.subTest(towards=towards, parallel=parallel):
                    found = light_seen(lit, eye, (0, 0, 0.5), parallel=parallel)[10, 10]
                    self.assertAlmostEqual(found, expected, delta=5e-3 * expected)


if __name__ == "__main__":
    unittest.main()
