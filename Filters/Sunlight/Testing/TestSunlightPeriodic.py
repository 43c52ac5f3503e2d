#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds that repeat themselves beyond the sides of a grid: published columns, a closed form, shifted and differently stored grids."""
import pathlib
import sys
import unittest

import numpy as np
from nephoscope import vtkSunlight
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid, vtkStructuredGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from TestSunlightDiffuse import OVERHEAD, SLANTED, step_cloud  # noqa: E402
from lit import add, add_to_cells, globe, image, light_of, unexpected, values  # noqa: E402

SUNS = [(0, 0, 1), (1, 0, 1), (0, -1, 0.3), (1, 1, 1), (-1, 0, 0.02), (0.3, -0.7, 0.2), (-0.41, 0.13, 0.6)]  # along axes and diagonals, low, and others


def clouds(nx, ny, nz, seed=1):
    """Smooth random extinctions that repeat themselves, as [z, y, x]; between clear levels."""
    noise = np.random.default_rng(seed).normal(size=(nz, ny, nx))
    for axis, width in ((0, 1), (1, 2), (2, 2)):
        frequency = np.fft.fftfreq(noise.shape[axis]).reshape([-1 if a == axis else 1 for a in range(3)])
        noise = np.fft.ifft(np.fft.fft(noise, axis=axis) * np.exp(-2 * (np.pi * width * frequency) ** 2), axis=axis).real
    extinction = 20 * np.maximum(noise / noise.std(), 0)
    extinction[0] = extinction[-1] = 0
    return extinction


def grid_of(extinction, closed=False, step=1 / 16):
    if closed:
        extinction = np.pad(extinction, ((0, 0), (0, 1), (0, 1)), mode="wrap")
    data = vtkImageData()
    data.SetDimensions(extinction.shape[::-1])
    data.SetSpacing(step, step, step)
    add(data, "Extinction", extinction.ravel())
    return data


def periodic(data, sun, **options):
    output, messages = light_of(data, sun, PeriodicSides=True, **options)
    assert not unexpected(messages), messages
    return output


class Periodic(unittest.TestCase):
    def test_one_period_of_the_step_cloud(self):
        """The I3RC step cloud without copies beside it: as in the middle of several, and as published."""
        for sun, told, periods in (((0, 0, 1), OVERHEAD, 5), ((-np.sqrt(3), 0, 1), SLANTED, 7)):
            with self.subTest(sun=sun):
                up, down = step_cloud(1, 33, sun, PeriodicSides=True)
                tiled_up, tiled_down = step_cloud(periods, 33, sun)
                self.assertLess(np.abs(up - tiled_up).max(), 1e-3)
                self.assertLess(np.abs(down - tiled_down).max(), 1e-3)
                self.assertLess(np.abs(up / told - 1).max(), 0.10)
                self.assertLess(abs(up.mean() + down.mean() - 1), 0.005)
                self.assertGreater(np.abs(step_cloud(1, 33, sun)[0] - up).max(), 0.01)  # mirrors are not the same

    def test_uniform_cloud(self):
        """The sun's beam is that of a slab without sides, exp(-depth / cosine), everywhere, also for a sun so low that rays go around several times."""
        data = image((5, 4, 9), (0.25, 0.25, 0.125), lambda x, y, z: 0 * x + 2)
        for sun in SUNS:
            with self.subTest(sun=sun):
                cosine = sun[2] / np.linalg.norm(sun)
                found = values(periodic(data, sun), "SunTransmittance").reshape(9, -1)
                expected = np.exp(-2 * (1 - np.linspace(0, 1, 9)) / cosine)
                self.assertLess(np.abs(found - expected[:, None]).max(), 1e-6)

    def test_shifted_clouds_have_shifted_light(self):
        """A shift that keeps the division into tetrahedra: the beam is the same; diffuse light is, to what the iteration leaves."""
        extinction = clouds(16, 12, 10)
        for sun in SUNS:
            with self.subTest(sun=sun):
                one = periodic(grid_of(extinction), sun)
                for shift in ((4, 6), (3, 5)):
                    other = periodic(grid_of(np.roll(extinction, shift, (1, 2))), sun)
                    for name, tolerance in (("SunTransmittance", 1e-6), ("Sunlight", 0.005), ("Irradiance", 0.03)):
                        expected = np.roll(values(one, name).reshape(extinction.shape), shift, (1, 2)).ravel()
                        self.assertLess(np.abs(values(other, name) - expected).max(), tolerance, name)

    def test_sides_that_meet(self):
        """Grids with and without the points that close them, with even and odd numbers of cells; stored as rectilinear or structured grids."""
        for shape in ((16, 12, 9), (15, 13, 8)):
            extinction = clouds(*shape)
            for sun in SUNS[1:4]:
                with self.subTest(shape=shape, sun=sun):
                    expected = {name: values(periodic(grid_of(extinction), sun), name).reshape(extinction.shape) for name in ("SunTransmittance", "Sunlight")}
                    for name, values_ in expected.items():
                        closed = values(periodic(grid_of(extinction, closed=True), sun), name).reshape(np.add(extinction.shape, (0, 1, 1)))
                        self.assertLess(np.abs(closed[:, :-1, :-1] - values_).max(), 1e-6, name)
                        self.assertLess(np.abs(closed[:, -1] - closed[:, 0]).max(), 1e-6, name)
                        for other in (rectilinear(extinction), structured(extinction)):
                            self.assertLess(np.abs(values(periodic(other, sun), name) - values_.ravel()).max(), 1e-5, name)

    def test_up_along_another_axis(self):
        extinction = clouds(16, 12, 10)
        expected = values(periodic(grid_of(extinction), (1, -0.4, 0.5)), "Sunlight").reshape(extinction.shape)
        turned = periodic(grid_of(np.ascontiguousarray(extinction.transpose(1, 2, 0))), (0.5, 1, -0.4), Up=(1, 0, 0))  # [y, x, z]: x is up, y was x, z was y
        self.assertLess(np.abs(values(turned, "Sunlight").reshape(12, 16, 10).transpose(2, 0, 1) - expected).max(), 0.005)

    def test_cells(self):
        """The extinction of cells: points on opposite sides have the mean of the cells on both."""
        extinction = clouds(16, 12, 10)
        data = vtkImageData()
        data.SetDimensions(17, 13, 11)
        data.SetSpacing(1 / 16, 1 / 16, 1 / 16)
        add_to_cells(data, "Extinction", extinction.ravel())
        light = values(periodic(data, (1, -0.4, 0.5)), "SunTransmittance").reshape(11, 13, 17)
        self.assertLess(np.abs(light[:, 0] - light[:, -1]).max(), 1e-6)
        self.assertLess(np.abs(light[:, :, 0] - light[:, :, -1]).max(), 1e-6)
        around = np.pad(extinction, ((0, 0), (1, 0), (1, 0)), mode="wrap")
        around = np.pad(around, ((1, 1), (0, 0), (0, 0)), mode="edge")
        points = sum(around[a:a + 11, b:b + 12, c:c + 16] for a in (0, 1) for b in (0, 1) for c in (0, 1)) / 8
        expected = values(periodic(grid_of(points), (1, -0.4, 0.5)), "SunTransmittance").reshape(points.shape)
        self.assertLess(np.abs(light[:, :-1, :-1] - expected).max(), 1e-5)

    def test_what_has_no_sides(self):
        divider = vtkDataSetTriangleFilter()
        divider.SetInputData(grid_of(clouds(6, 6, 5)))
        divider.Update()
        for data in (divider.GetOutput(), globe()):
            _, messages = light_of(data, (1, 0, 1), PeriodicSides=True)
            self.assertTrue(any("PeriodicSides needs an image" in message for message in messages), messages)

    def test_computed_again_when_it_changes(self):
        light = vtkSunlight()
        light.SetInputData(grid_of(clouds(16, 12, 10)))
        light.SetSunDirection(1, 0, 0.5)
        found = []
        for on in (False, True, False):
            light.SetPeriodicSides(on)
            light.Update()
            found.append(values(light.GetOutput(), "SunTransmittance"))
        self.assertGreater(np.abs(found[1] - found[0]).max(), 0.1)
        self.assertEqual(np.abs(found[2] - found[0]).max(), 0)


def rectilinear(extinction, step=1 / 16):
    data = vtkRectilinearGrid()
    data.SetDimensions(extinction.shape[::-1])
    for axis, name in enumerate("XYZ"):
        getattr(data, f"Set{name}Coordinates")(numpy_to_vtk(step * np.arange(extinction.shape[2 - axis]), deep=1))
    add(data, "Extinction", extinction.ravel())
    return data


def structured(extinction, step=1 / 16):
    z, y, x = (step * index for index in np.indices(extinction.shape))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x, y, z], -1).reshape(-1, 3), deep=1))
    data = vtkStructuredGrid()
    data.SetDimensions(extinction.shape[::-1])
    data.SetPoints(points)
    add(data, "Extinction", extinction.ravel())
    return data


if __name__ == "__main__":
    unittest.main()
