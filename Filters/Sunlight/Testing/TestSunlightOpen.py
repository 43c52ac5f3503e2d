#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds in boxes with open sides: cubes compared with the Monte Carlo of monte_carlo.py, the balance of energy, and what open sides do not change."""
import json
import pathlib
import sys
import unittest

import numpy as np
from nephoscope import vtkSunlight
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import monte_carlo  # noqa: E402
from lit import add, globe, image, light_of, places, unexpected, values  # noqa: E402

TABLES = json.loads(monte_carlo.TABLE.read_text())
CUBE, ENERGY = 0.05, 0.02  # demanded of fractions of the light on a cube; of the energy
ACHIEVED = {"cube 60 absorbing": 0.06, "thin cube 0": 0.23, "thick cube 0": 0.06}  # where that is less than the demand
BLACK = {"GroundAlbedo": 0, "SkyLight": 0}
SUNS = ((0, 0, 1), (1, 0.3, 1), (-1, 2, 0.5))


def lit_grid(data, sun, albedo=1.0, **options):
    """Fluxes at the points of an image with g = 0.85, as [z, y, x], without the sun's beam where it enters: horizontal fluxes, upward and downward irradiance, beam, absorbed light."""
    output, messages = light_of(data, sun, FollowCamera=True, Albedo=albedo, **options)
    assert not unexpected(messages), messages
    shape, g = data.GetDimensions()[::-1], monte_carlo.ASYMMETRY
    scaled = (1 - g * g) * albedo / (1 - albedo * g * g)
    flux = values(output, "DiffuseFlux") * 4 * (1 + g) / (3 * scaled * g)
    beam = 4 / scaled * values(output, "SingleScattering").sum(1)
    return [flux[:, axis].reshape(shape) for axis in (0, 1)] + [one.reshape(shape) for one in (values(output, "UpwardIrradiance"), values(output, "Irradiance"), beam, values(output, "AbsorbedLight"))]


def shares(data, sun, albedo=1.0, sky=0.0, **options):
    """Light that leaves the top, goes into the ground, leaves the sides and is absorbed, as fractions of the light of sun and sky on the faces. `sky`: its irradiance."""
    sun = np.array(sun) / np.linalg.norm(sun)
    spacing = data.GetSpacing()
    widths = [step * np.r_[0.5, np.ones(n - 2), 0.5] for n, step in zip(data.GetDimensions(), spacing)]
    top, lit = widths[0].sum() * widths[1].sum(), [np.multiply.outer(widths[2], widths[1 - axis]) for axis in (0, 1)]
    x, y, up, down, beam, absorbed = lit_grid(data, sun, albedo, **options)
    horizontal = np.multiply.outer(widths[1], widths[0])
    sides = 0
    for axis, flux in ((0, x), (1, y)):
        for end, outwards in ((0, -1), (-1, 1)):
            face = [np.take(one, end, 2 - axis) for one in (flux, beam)]
            sides += (lit[axis] * (outwards * face[0] + np.maximum(-outwards * sun[axis], 0) * face[1])).sum() + sky / 2 * lit[axis].sum()
    came = top * (sun[2] + sky) + sum(area.sum() * (abs(sun[axis]) + sky) for axis, area in enumerate(lit))
    return np.array(((horizontal * up[-1]).sum(), (horizontal * (down[0] - up[0])).sum(), sides, np.einsum("k,j,i,kji", widths[2], widths[1], widths[0], absorbed))) / came


def lump(x, y, z):
    """A cloud that reaches the sides of a box 2 wide, 1.5 deep and 1 high."""
    return 12 * np.maximum(1 - ((x - 0.8) / 1.3) ** 2 - ((y - 0.9) / 1.2) ** 2 - ((z - 0.6) / 0.5) ** 2, 0)


def turned(data):
    """An image turned by 90 degrees about z, as x to y."""
    nx, ny, nz = data.GetDimensions()
    other = vtkImageData()
    other.SetDimensions(ny, nx, nz)
    other.SetSpacing([data.GetSpacing()[axis] for axis in (1, 0, 2)])
    add(other, "Extinction", np.rot90(values(data, "Extinction").reshape(nz, ny, nx), 1, (2, 1)).ravel())
    return other


def region(data, radius=1000.0):
    """The points of an image on a planet, around longitude and latitude 0."""
    at = places(data) - np.array(data.GetCenter()) * (1, 1, 0)
    longitude, latitude, r = at[:, 0] / radius, at[:, 1] / radius, radius + at[:, 2]
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([r * np.cos(latitude) * np.cos(longitude), r * np.cos(latitude) * np.sin(longitude), r * np.sin(latitude)], -1), deep=1))
    grid = vtkStructuredGrid()
    grid.SetDimensions(data.GetDimensions())
    grid.SetPoints(points)
    add(grid, "Extinction", values(data, "Extinction"))
    for name, value in (("GlobeGridProjection", 0), ("PlanetRadius", radius), ("VerticalExaggeration", 1)):
        array = numpy_to_vtk(np.array([float(value)]), deep=1)
        array.SetName(name)
        grid.GetFieldData().AddArray(array)
    return grid


class Cubes(unittest.TestCase):
    def check(self, name, points):
        depth, zenith, azimuth, albedo = monte_carlo.CUBES[name]
        data = image((points,) * 3, (1 / (points - 1),) * 3, lambda x, y, z: 0 * x + depth)
        table = np.array([TABLES[name][kind] for kind in ("top", "base", "sides", "absorbed")])
        found = shares(data, monte_carlo.sun_of(zenith, azimuth), albedo, OpenSides=True, **BLACK)
        print(f"{name}, {points} points along each edge: top {found[0]:.4f} for {table[0]:.4f}, base {found[1]:.4f} for {table[1]:.4f}, sides {found[2]:.4f} for {table[2]:.4f}, "
              f"absorbed {found[3]:.4f} for {table[3]:.4f}; sum {found.sum():.4f}")
        self.assertLess(TABLES[name]["error"], 0.005)
        self.assertLess(abs(found.sum() - 1), ENERGY)
        np.testing.assert_allclose(found, table, rtol=ACHIEVED.get(name, CUBE), atol=1e-4)

    def test_mirrors(self):
        """The same cube without open sides reflects several times as much."""
        data = image((15,) * 3, (1 / 14,) * 3, lambda x, y, z: 0 * x + 10)
        self.assertGreater(shares(data, (0, 0, 1), **BLACK)[0], 3 * TABLES["cube 0"]["top"])


def cube_test(name, points):
    return lambda self: self.check(name, points)


for one in monte_carlo.CUBES:
    for points in (15, 27):
        setattr(Cubes, f"test_{one}_{points}".replace(" ", "_"), cube_test(one, points))


class Open(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cloud = image((21, 17, 13), (0.1, 1.5 / 16, 1 / 12), lump)

    def test_energy(self):
        """With light of the sky, a bright ground and absorption."""
        for sun in SUNS:
            for albedo, ground, light in ((1, 0, 0), (0.95, 0, 0), (1, 0.3, 0), (0.95, 0.3, 0.3)):
                sky = light * (sun[2] / np.linalg.norm(sun) + 0.1) / 1.1
                found = shares(self.cloud, sun, albedo, sky, GroundAlbedo=ground, SkyLight=light, OpenSides=True)
                with self.subTest(sun, albedo=albedo, ground=ground, sky=sky, found=found):
                    self.assertLess(abs(found.sum() - 1), ENERGY)
                    self.assertGreater(found[2], 0.1)

    def test_tight_box(self):
        """A ball that touches the sides of its box is lit as in a wide box of clear air, but between mirrors far too brightly."""
        def ball(x, y, z):
            return 0.02 * np.clip(5 * (1.02 - np.sqrt(x * x + y * y + (z - 600) ** 2) / 500), 0, 1)
        tight, wide = image((21, 21, 25), (50,) * 3, ball, (-500, -500, 0)), image((61, 61, 25), (50,) * 3, ball, (-1500, -1500, 0))
        for sun in ((0, 0, 1), (1, 0, 1)):
            light = {name: values(light_of(data, sun, ZenithAngles=4, AzimuthAngles=8, **BLACK, **options)[0], "Sunlight")[values(data, "Extinction") > 0].mean()
                     for name, data, options in (("open", tight, {"OpenSides": True}), ("mirrors", tight, {}), ("wide", wide, {"OpenSides": True}), ("wide mirrors", wide, {}))}
            with self.subTest(sun, **light):
                self.assertAlmostEqual(light["open"] / light["wide"], 1, delta=0.02)
                self.assertAlmostEqual(light["open"] / light["wide mirrors"], 1, delta=0.05)
                self.assertGreater(light["mirrors"], 1.2 * light["wide"])

    def test_middle_of_wide_cloud(self):
        data = image((41, 41, 21), (0.5, 0.5, 0.05), lambda x, y, z: 0 * x + 10)
        for sun in ((0, 0, 1), (1, 0, 1)):
            mirrors, opened = (values(light_of(data, sun, OpenSides=on)[0], "Sunlight").reshape(21, 41, 41) for on in (False, True))
            np.testing.assert_allclose(opened[:, 20, 20], mirrors[:, 20, 20], rtol=0.01)
            self.assertGreater(np.abs(opened[:, 20, 0] / mirrors[:, 20, 0] - 1).max(), 0.1)

    def test_turned(self):
        for sun in SUNS:
            light, other = (values(light_of(data, towards, OpenSides=True)[0], "Sunlight") for data, towards in ((self.cloud, sun), (turned(self.cloud), (-sun[1], sun[0], sun[2]))))
            np.testing.assert_allclose(other.reshape(13, 21, 17), np.rot90(light.reshape(13, 17, 21), 1, (2, 1)), atol=2e-3)

    def test_clear_air(self):
        """The light of the sky is the same everywhere, as if there were no sides."""
        clear = image((7, 7, 7), (1, 1, 1), lambda x, y, z: 0 * x)
        output, _ = light_of(clear, (0, 3, 4), OpenSides=True, GroundAlbedo=0, SkyLight=0.1)
        np.testing.assert_allclose(values(output, "Irradiance"), 0.8 + 0.1 * (0.8 + 0.1) / 1.1, rtol=1e-4)
        np.testing.assert_allclose(values(output, "UpwardIrradiance"), 0, atol=1e-4)

    def test_globe(self):
        """All longitudes: there are no sides. A region of a globe has the light of flat ground."""
        ring = globe(3.0)
        np.testing.assert_array_equal(*(values(light_of(ring, (1, 0.4, 0.3), OpenSides=on)[0], "Sunlight") for on in (False, True)))
        for sun in SUNS:
            flat, curved = (values(light_of(data, towards, OpenSides=True)[0], "Sunlight") for data, towards in ((self.cloud, sun), (region(self.cloud), (sun[2], sun[0], sun[1]))))
            np.testing.assert_allclose(curved, flat, atol=0.01)

    def test_hexahedra(self):
        """Unstructured data, whose light is computed on an image: the sides of that are open."""
        append = vtkAppendFilter()
        append.AddInputData(self.cloud)
        append.Update()
        cells, grid = (light_of(data, (1, 0.3, 1), OpenSides=True, **BLACK)[0] for data in (append.GetOutput(), self.cloud))
        self.assertAlmostEqual(values(cells, "Sunlight").mean() / values(grid, "Sunlight").mean(), 1, delta=0.05)

    def test_again(self):
        """The light that is kept for another eye is computed again."""
        light = vtkSunlight()
        light.SetInputData(self.cloud)
        light.UseViewPositionOn()
        light.Update()
        light.OpenSidesOn()
        light.Update()
        fresh = light_of(self.cloud, light.GetSunDirection(), OpenSides=True, UseViewPosition=True)[0]
        np.testing.assert_array_equal(values(light.GetOutput(), "Sunlight"), values(fresh, "Sunlight"))


class Messages(unittest.TestCase):
    def test_periodic(self):
        """Clouds that repeat have no sides."""
        data = image((9, 9, 9), (0.1,) * 3, lambda x, y, z: 5 + 5 * np.sin(7 * x))
        alone, both = (light_of(data, (1, 0, 1), PeriodicSides=True, OpenSides=on) for on in (False, True))
        self.assertEqual(alone[1], [])
        self.assertEqual(len(both[1]), 1)
        self.assertIn("PeriodicSides and OpenSides are both on", both[1][0])
        np.testing.assert_array_equal(values(both[0], "Sunlight"), values(alone[0], "Sunlight"))

    def test_remedy(self):
        tall = image((5, 5, 31), (100, 100, 100), lambda x, y, z: 0 * x + 0.02)
        self.assertIn("Turn OpenSides on", light_of(tall, (1, 0, 1))[1][0])
        self.assertEqual(light_of(tall, (1, 0, 1), OpenSides=True)[1], [])


if __name__ == "__main__":
    unittest.main()
