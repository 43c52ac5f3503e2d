#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Diffuse light: the I3RC step cloud, energy, plane-parallel slabs, day and night, all orders of indices, structured and unstructured meshes."""
import collections
import itertools
import pathlib
import sys
import unittest

import numpy as np
from nephoscope import vtkSunlight
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter, vtkTransformFilter

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import doubling  # noqa: E402
from lit import add, beside_sides, globe, image, light_of, places, unexpected, values  # noqa: E402

# I3RC phase 1 case 1, sun overhead: consensus of the codes that took part (public results of the Intercomparison of 3D Radiation Codes, Cahalan et al.
# 2005). Columns of 15.625 m, periodic; 0.25 km thick; optical depth 2 in the first half, 18 in the second; Henyey-Greenstein, g = 0.85; no absorption.
OVERHEAD = np.array([
    0.27859, 0.26712, 0.25531, 0.24542, 0.23761, 0.23207, 0.22805, 0.22592, 0.22597, 0.22796, 0.23176, 0.23787, 0.24578, 0.25563, 0.26676, 0.27939,
    0.32332, 0.36758, 0.39589, 0.41544, 0.43034, 0.44028, 0.44675, 0.45022, 0.44978, 0.44676, 0.44118, 0.43032, 0.41623, 0.39624, 0.36826, 0.32325])
# The same with the sun 60 degrees from the zenith, from -x: a plain Monte Carlo of 300,000 photons, whose noise is 1 % in a column. It agrees with the
# consensus above to 0.1 % of the mean with the sun overhead.
SLANTED = np.array([
    0.4686, 0.4208, 0.3841, 0.365, 0.3515, 0.3409, 0.3456, 0.3445, 0.3325, 0.3472, 0.3629, 0.3831, 0.3968, 0.4213, 0.4465, 0.4772,
    0.5934, 0.7445, 0.8095, 0.8527, 0.8686, 0.8823, 0.8647, 0.847, 0.8481, 0.8194, 0.794, 0.7625, 0.7293, 0.7075, 0.6687, 0.5997])


def step_cloud(periods, levels, sun, **options):
    """Reflectance and transmittance of the 32 columns of the middle period."""
    def extinction(x, y, z):
        return np.where(np.floor(x / 0.015625 + 0.5) % 32 < 16, 2.0, 18.0) / 0.25
    data = image((32 * periods, 2, levels), (0.015625, 0.25, 0.25 / (levels - 1)), extinction)
    output, messages = light_of(data, sun, GroundAlbedo=0, SkyLight=0, **options)
    assert beside_sides(messages) == [], messages
    cosine = sun[2] / np.linalg.norm(sun)
    middle = slice(32 * (periods // 2), 32 * (periods // 2) + 32)
    up = values(output, "UpwardIrradiance").reshape(levels, 2, -1)[-1, 0, middle] / cosine
    down = values(output, "Irradiance").reshape(levels, 2, -1)[0, 0, middle] / cosine
    return up, down


class StepCloud(unittest.TestCase):
    def check(self, sun, told, periods, most_mean, most_column):
        up, down = step_cloud(periods, 33, sun)
        error = up / told - 1
        print(f"sun {sun}: mean {up.mean():.4f} for {told.mean():.4f}, worst column {100 * np.abs(error).max():.1f} %, rms {100 * np.sqrt((error ** 2).mean()):.1f} %, "
              f"energy {up.mean() + down.mean():.4f}")
        self.assertLess(abs(up.mean() / told.mean() - 1), most_mean)
        self.assertLess(np.abs(error).max(), most_column)
        self.assertLess(abs(up.mean() + down.mean() - 1), 0.02)

    def test_overhead(self):
        self.check((0, 0, 1), OVERHEAD, 5, 0.05, 0.10)

    def test_slanted(self):
        self.check((-np.sqrt(3), 0, 1), SLANTED, 7, 0.05, 0.10)


class Slab(unittest.TestCase):
    def slab(self, depth, albedo=1.0, asymmetry=0.85, sun=(0, 0, 1), **options):
        """Upward flux at the top and downward flux at the bottom, far from the sides."""
        data = image((3, 3, 41), (1000, 1000, 1 / 40), lambda x, y, z: 0 * x + depth)
        output, _ = light_of(data, sun, **{"Albedo": albedo, "Asymmetry": asymmetry, "GroundAlbedo": 0, "SkyLight": 0, "ZenithAngles": 4, **options})
        return values(output, "UpwardIrradiance")[40 * 9 + 4], values(output, "Irradiance")[4]

    def test_isotropic_conservative(self):
        """Optical depth 1, the sun overhead: 0.34133 (van de Hulst, Multiple Light Scattering, 1980, table 9)."""
        self.assertAlmostEqual(self.slab(1.0, asymmetry=0.0)[0], 0.34133, delta=0.01)

    def test_eddington(self):
        """Thick conservative clouds, the sun overhead: 1 - 5 / (4 + 3 (1 - g) tau) of Eddington's approximation (Joseph, Wiscombe and Weinman 1976)."""
        for depth in (10, 20, 25, 60, 100, 1000):
            self.assertAlmostEqual(self.slab(depth)[0], 1 - 5 / (4 + 3 * 0.15 * depth), delta=0.02)

    def test_ground_reflects(self):
        """Without a cloud, the upward light is what the ground reflects. A black cloud absorbs nearly all light."""
        self.assertAlmostEqual(self.slab(0.0, GroundAlbedo=0.5)[0], 0.5, delta=1e-3)
        self.assertLess(self.slab(50, albedo=0.0)[0], 1e-3)

    def test_snow_below_thick_clouds(self):
        """Bright ground absorbs what is not reflected. The light on it is that of Eddington's approximation, R = R0 + A T0^2 / (1 - A R0)."""
        for depth in (50, 100, 200, 300):
            for white in (0.6, 0.8, 0.9):
                with self.subTest(depth, white=white):
                    reflected, arriving = self.slab(depth, sun=(0.7, 0, 0.714), GroundAlbedo=white)
                    reflected, arriving = (x / 0.714 * np.hypot(0.7, 0.714) for x in (reflected, arriving))
                    self.assertAlmostEqual(reflected + (1 - white) * arriving, 1, delta=5e-3)
                    through = eddington(depth, 1.0, 0.85, 0.714 / np.hypot(0.7, 0.714))[1]
                    self.assertAlmostEqual(arriving, through / (1 - white * (1 - 4 / (4 + 3 * 0.15 * depth))), delta=0.04)

    def test_single_scattering_of_a_thin_slab(self):
        """For an eye overhead its radiance is that of the unscaled phase function, tau P / 4, although the solver scales it."""
        asymmetry, depth, mu = 0.85, 0.02, 0.8
        data = image((3, 3, 41), (1000, 1000, 1 / 40), lambda x, y, z: 0 * x + depth)
        output, _ = light_of(data, (0.6, 0, mu), UseViewPosition=True, ParallelView=True, ViewPosition=(0, 0, 1), GroundAlbedo=0, SkyLight=0, Asymmetry=asymmetry)
        emitted = (values(output, "Sunlight") * values(output, "ScaledExtinction")).reshape(41, 9)[:, 4]
        radiance = 0.5 * (emitted[1:] + emitted[:-1]).sum() / 40
        phase = (1 - asymmetry ** 2) / (1 + asymmetry ** 2 + 2 * asymmetry * mu) ** 1.5
        self.assertAlmostEqual(radiance / (0.25 * phase * depth), 1, delta=0.1)

    def test_unstructured_is_near(self):
        data = image((9, 9, 9), (0.125,) * 3, lambda x, y, z: 8 * np.exp(-20 * ((x - 0.5) ** 2 + (y - 0.5) ** 2 + (z - 0.5) ** 2)))
        divider = vtkDataSetTriangleFilter()
        divider.SetInputData(data)
        divider.Update()
        a, b = (values(light_of(d, (1, 0, 1), GroundAlbedo=0.2)[0], "Sunlight") for d in (data, divider.GetOutput()))
        self.assertLess(np.abs(a - b).mean(), 0.06 * a.mean())


def eddington(depth, albedo, asymmetry, cosine):
    """Reflected and transmitted fractions (the latter with the beam) of a cloud above black ground: delta-Eddington in closed form (Joseph, Wiscombe and Weinman 1976),
    with the forward peak that the filter takes away from its diffuse light."""
    forward = asymmetry ** 3
    depth, w, g = (1 - albedo * forward) * depth, min((1 - forward) * albedo / (1 - albedo * forward), 1 - 1e-9), (asymmetry - forward) / (1 - forward)
    k, transport, beam = np.sqrt(3 * (1 - w) * (1 - w * g)), 1 - w * g, np.exp(-depth / cosine)
    fluence = 3 * w * (transport + g) / (k ** 2 - cosine ** -2)  # the part proportional to the beam, and its flux
    flux = (fluence / (3 * cosine) + w * g * cosine) / transport
    slope, far = k / (3 * transport), np.exp(-k * depth)
    down, up = 0.25 + 0.5 * slope, 0.25 - 0.5 * slope
    a, b = np.linalg.solve([[down, up * far], [up * far, down]], [-(0.25 * fluence + 0.5 * flux), -(0.25 * fluence - 0.5 * flux) * beam])
    at_top, at_ground = slope * (a - b * far) + flux, slope * (a * far - b) + flux * beam
    return -at_top / cosine, at_ground / cosine + beam


class Angles(unittest.TestCase):
    def light(self, size, **angles):
        return values(light_of(image(size, (0.1,) * 3, lambda x, y, z: 10 * np.exp(-4 * ((x - 0.7) ** 2 + (y - 0.7) ** 2 + (z - 0.7) ** 2))), (1, 0, 1), **angles)[0], "Sunlight")

    def test_automatic(self):
        """Few points get more directions than many."""
        for size, zenith, azimuth in (((15, 15, 15), 6, 8), ((28, 28, 28), 4, 6)):
            automatic = self.light(size)
            np.testing.assert_array_equal(automatic, self.light(size, ZenithAngles=zenith, AzimuthAngles=azimuth))
            self.assertGreater(np.abs(automatic - self.light(size, ZenithAngles=3, AzimuthAngles=4)).max(), 1e-4)

    def test_range(self):
        light = vtkSunlight()
        for asked, used in ((-1, 0), (0, 0), (2, 4), (8, 8), (100, 64)):
            light.SetAzimuthAngles(asked)
            self.assertEqual(light.GetAzimuthAngles(), used)


class ThickCells(unittest.TestCase):
    """Clouds whose layers have any optical depth."""

    def budget(self, data, sun, levels, size=3, **options):
        """Reflected, transmitted and absorbed fractions in a column of a slab, far from its sides."""
        output, messages = light_of(data, sun, **{"GroundAlbedo": 0, "SkyLight": 0, **options})
        self.assertEqual(unexpected(messages), [])
        cosine = sun[2] / np.linalg.norm(sun)
        up, down, absorbed = (values(output, name).reshape(levels, *2 * (size,))[:, size // 2, size // 2] / cosine for name in ("UpwardIrradiance", "Irradiance", "AbsorbedLight"))
        return up[-1], down[0], (absorbed.sum() - 0.5 * (absorbed[0] + absorbed[-1])) / (levels - 1)

    def test_slabs(self):
        """Energy is conserved to 0.5 %. Thick layers meet Eddington's approximation to 0.001, others reflect what is exact to 0.02, and to 0.07 with a sun 6 degrees high."""
        worst = collections.defaultdict(float)
        for layer in (0.01, 0.1, 1, 5, 25, 100, 1000):
            for albedo in (1, 0.99, 0.9):
                for sun in ((0, 0, 1), (1, 0.3, 1), (3, -1, 1), (8, 6, 1)):
                    layers = 10 if layer > 1 else 40
                    cosine = 1 / np.linalg.norm(sun)
                    data = image((7, 7, layers + 1), (1e4, 1e4, 1 / layers), lambda x, y, z: 0 * x + layer * layers)
                    up, down, absorbed = self.budget(data, sun, layers + 1, 7, Albedo=albedo)
                    self.assertLess(abs(up + down + absorbed - 1), 0.005, (layer, albedo, sun, up, down, absorbed))
                    kind = "thick" if layer >= 100 else "grazing" if cosine < 0.2 else "thin"
                    told = eddington(layer * layers, albedo, 0.85, cosine) if kind == "thick" else (doubling.reflected_fraction(layer * layers, 0.85, cosine, albedo), down)
                    error = max(abs(up - told[0]), abs(down - told[1]))
                    worst[kind] = max(worst[kind], error)
                    self.assertLess(error, {"thick": 0.001, "thin": 0.02, "grazing": 0.07}[kind], (layer, albedo, sun, up, down, told))
        print(dict(worst))

    def test_meshes(self):
        """The same slab as an image, as hexahedra and as tetrahedra, with only 5 levels."""
        for layer in (1, 100):
            data = image((3, 3, 5), (1e3, 1e3, 0.25), lambda x, y, z: 0 * x + 4 * layer)
            hexahedra, tetrahedra = vtkAppendFilter(), vtkDataSetTriangleFilter()
            for one in (hexahedra, tetrahedra):
                one.SetInputData(data)
                one.Update()
            told = eddington(4 * layer, 1, 0.85, 0.8)
            for mesh in (data, hexahedra.GetOutput(), tetrahedra.GetOutput()):
                up, down, absorbed = self.budget(mesh, (3, 0, 4), 5)
                self.assertLess(abs(up + down - 1), 0.005, (layer, mesh.GetClassName(), up, down))
                self.assertLess(abs(up - told[0]), 0.03, (layer, mesh.GetClassName(), up, told))

    def test_lumps(self):
        """Lumps whose cells have optical depths up to 300, and whose whole shadow falls on the ground: outgoing and absorbed light add up to the incoming light."""
        def lumps(x, y, z):
            inside = (np.abs(x) < 5.5) & (np.abs(y) < 4.5) & (z > 1.5) & (z < 6.5)
            return np.where(inside, 10.0 ** (1.5 + np.sin(0.6 * x + 0.7 * y + 0.8 * z)), 0)
        for albedo in (1, 0.97):
            for sun in ((0, 0, 1), (1, 0, 1), (1, -1, 1.2)):
                data = image((33, 29, 9), (1, 1, 1), lumps, (-16, -14, 0))
                output, _ = light_of(data, sun, GroundAlbedo=0, SkyLight=0, Albedo=albedo)
                weights = [np.r_[0.5, np.ones(n - 2), 0.5] for n in (9, 29, 33)]
                area = np.multiply.outer(weights[1], weights[2])
                up, down, absorbed = (values(output, name).reshape(9, 29, 33) for name in ("UpwardIrradiance", "Irradiance", "AbsorbedLight"))
                out = (area * (up[-1] + down[0])).sum() + (np.multiply.outer(weights[0], area) * absorbed).sum()
                came = area.sum() * sun[2] / np.linalg.norm(sun)
                lost = came - (area * values(output, "SunTransmittance").reshape(9, 29, 33)[0]).sum() * sun[2] / np.linalg.norm(sun)
                print(f"lumps, albedo {albedo}, sun {sun}: {out - came:+.3f} of {lost:.3f}")
                self.assertLess(abs(out - came), 0.02 * lost, (albedo, sun))


class Globe(unittest.TestCase):
    def test_night(self):
        sun = np.array([1, 0.4, 0.3]) / np.linalg.norm([1, 0.4, 0.3])
        output, messages = light_of(globe(), sun)
        x, t = places(output), values(output, "SunTransmittance")
        height = x @ sun
        shadow = (height < 0) & (np.linalg.norm(x - height[:, None] * sun, axis=1) < 1)
        self.assertEqual(unexpected(messages), [])
        np.testing.assert_allclose(t, np.where(shadow, 0, 1), atol=1e-5)
        self.assertLess(values(output, "Sunlight")[height < -0.8].max(), 1e-3)

    def test_seam_and_poles_have_one_light(self):
        light = values(light_of(globe(2.0), (1, 0.4, 0.3))[0], "Sunlight").reshape(4, 13, 25)
        np.testing.assert_allclose(light[:, :, 0], light[:, :, -1], rtol=0.02, atol=1e-3)
        self.assertTrue(np.isfinite(light).all())

    def test_date(self):
        """Subsolar point at an equinox and two solstices: latitude to 0.1 degrees, longitude by the equation of time."""
        for date, lon, lat in (("2011-03-20 23:21", 15 * -11.35 + 1.9, 0.0), ("2011-06-21T12:00:00Z", 0.45, 23.43), ("2011-12-22 00:00", 179.5, -23.43)):
            output, messages = light_of(globe(), DateTime=date)
            self.assertEqual(unexpected(messages), [])
            sun = vtk_to_numpy(output.GetFieldData().GetArray("SunDirection"))[0]
            self.assertAlmostEqual(np.degrees(np.arcsin(sun[2])), lat, delta=0.1)
            self.assertAlmostEqual(np.remainder(np.degrees(np.arctan2(sun[1], sun[0])) - lon + 180, 360) - 180, 0, delta=0.5)


class Orientation(unittest.TestCase):
    """Light depends neither on the order of a grid's points nor on which axis is up."""

    SIZE = (11, 9, 7)  # along x, y and z; an even number of cells has the same diagonals from both ends

    @classmethod
    def setUpClass(cls):
        cls.cloud = image(cls.SIZE, (100, 100, 100), lambda x, y, z: 0.01 * np.maximum(1 - ((x - 500) / 450) ** 2 - ((y - 400) / 350) ** 2 - ((z - 400) / 250) ** 2, 0)
                          + 0.003 * (z < 250))
        cls.light = values(light_of(cls.cloud, (1, -1, 1))[0], "Sunlight").reshape(cls.SIZE[::-1])

    def stored(self, order, backwards):
        """The grid with its axes (z, y, x: 0, 1, 2) in another order, the slowest one backwards or not; and a function that restores the order of values."""
        def there(a):
            a = np.moveaxis(a.reshape(self.SIZE[::-1] + a.shape[1:]), order, (0, 1, 2))
            return a[::-1] if backwards else a
        grid = vtkStructuredGrid()
        at = there(places(self.cloud))
        grid.SetDimensions(at.shape[2::-1])
        grid.SetPoints(vtkPoints())
        grid.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(at).reshape(-1, 3), deep=1))
        add(grid, "Extinction", there(values(self.cloud, "Extinction")).ravel())
        return grid, lambda a: np.moveaxis((a.reshape(at.shape[:3])[::-1] if backwards else a.reshape(at.shape[:3])), (0, 1, 2), order)

    def test_order_of_indices(self):
        for order in itertools.permutations(range(3)):
            for backwards in (False, True):
                with self.subTest(order, backwards=backwards):
                    grid, back = self.stored(order, backwards)
                    np.testing.assert_allclose(back(values(light_of(grid, (1, -1, 1))[0], "Sunlight")), self.light, atol=2e-3)

    def test_closed_axis(self):
        """A globe whose second or third index goes around."""
        data = globe(3.0)
        n = (25, 13, 4)
        expected = values(light_of(data, (1, 0.4, 0.3))[0], "Sunlight").reshape(n[::-1])
        for order in ((0, 2, 1), (2, 1, 0), (1, 2, 0)):
            def there(a, order=order):
                return np.ascontiguousarray(a.reshape(n[::-1] + a.shape[1:]).transpose(*order, *range(3, 2 + a.ndim)))
            grid = vtkStructuredGrid()
            grid.SetDimensions([n[::-1][axis] for axis in order][::-1])
            grid.SetPoints(vtkPoints())
            grid.GetPoints().SetData(numpy_to_vtk(there(places(data)).reshape(-1, 3), deep=1))
            grid.SetFieldData(data.GetFieldData())
            add(grid, "Extinction", there(values(data, "Extinction")).ravel())
            with self.subTest(order):
                np.testing.assert_allclose(values(light_of(grid, (1, 0.4, 0.3))[0], "Sunlight"), there(expected.ravel()).ravel(), atol=0.02)

    def test_up(self):
        """The same cloud lying on its side. A date gives the sun relative to the horizon, which is turned with the cloud."""
        for turn, up in (((0, 2, 1), (0, 2, 0)), ((2, 1, 0), (0.5, 0, 0))):  # y up, with north along -z; x up, with east along -z
            signs = np.where(np.array(turn) == np.arange(3), 1, np.where(np.array(turn) == 2, 1, -1))
            grid = vtkStructuredGrid()
            grid.SetDimensions(self.SIZE)
            grid.SetPoints(vtkPoints())
            grid.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(places(self.cloud)[:, turn] * signs), deep=1))
            add(grid, "Extinction", values(self.cloud, "Extinction"))
            for options in ({"DateTime": "2020-06-21 10:00", "Longitude": 10, "Latitude": 45}, {"sun": (1, -1, 1)}):
                turned = dict(options, Up=up)
                if "sun" in options:
                    turned["sun"] = np.array(options["sun"])[list(turn)] * signs
                with self.subTest(up, **options):
                    for name in ("Sunlight", "Irradiance"):
                        expected, found = (values(light_of(data, **its)[0], name) for data, its in ((self.cloud, options), (grid, turned)))
                        np.testing.assert_allclose(found, expected, atol=1e-4)

    def test_up_of_unstructured_data(self):
        turned = vtkTransformFilter()
        turned.SetTransform(vtkTransform())
        turned.GetTransform().RotateX(-90)  # z becomes y
        divider = vtkDataSetTriangleFilter()
        divider.SetInputData(self.cloud)
        divider.Update()
        turned.SetInputData(divider.GetOutput())
        turned.Update()
        expected = values(light_of(divider.GetOutput(), (1, -1, 1))[0], "Sunlight")
        np.testing.assert_allclose(values(light_of(turned.GetOutput(), (1, 1, 1), Up=(0, 1, 0))[0], "Sunlight"), expected, atol=2e-3)

    def test_no_direction(self):
        output, messages = light_of(self.cloud, Up=(0, 0, 0))
        self.assertEqual(len(messages), 1)
        self.assertIn("Up is 0, 0, 0", messages[0])
        self.assertEqual(output.GetNumberOfPoints(), 0)
        self.assertIn("Up is (0, -1, 0)", light_of(self.cloud, (0, 1, 0), Up=(0, -3, 0))[1][0])


class Unstructured(unittest.TestCase):
    def test_globe(self):
        """The same cells as an unstructured grid: up is away from the centre there too. Near the poles points are coarser."""
        structured = globe(3.0)
        radii = np.linalg.norm(places(globe()), axis=1)
        add(structured, "Extinction", np.where((radii > 1.02) & (radii < 1.08), 12.0, 0.0))
        append = vtkAppendFilter()
        append.AddInputData(structured)
        append.Update()
        unstructured = append.GetOutput()
        unstructured.SetFieldData(structured.GetFieldData())
        sun = np.array([1, 0.4, 0.3]) / np.linalg.norm([1, 0.4, 0.3])
        expected, found = light_of(structured, sun)[0], light_of(unstructured, sun)[0]
        x = places(expected)
        day = (x @ sun > 0.5) & (abs(x[:, 2]) < 0.8)
        for name, share in (("Sunlight", 0.1), ("UpwardIrradiance", 0.12)):
            a, b = values(expected, name), values(found, name)
            self.assertLess(abs(a - b)[day].mean(), share * a[day].mean(), name)

    def test_clouds_cut_out_of_clear_air(self):
        """A cloud cut out by a threshold has the same light as in clear air: its sides are no mirrors."""
        def cloud(x, y, z):
            r = np.sqrt((x / 500)**2 + (y / 500)**2 + ((z - 1000) / 450)**2) + 0.12 * np.sin(x / 90) * np.sin(y / 70) * np.sin(z / 80)
            return np.where(r < 1, 0.03 * np.minimum(1, 6 * (1 - r)), 0)
        wide = image((65, 65, 31), (2500 / 64, 2500 / 64, 1000 / 30), cloud, origin=(-1250, -1250, 500))
        cut = vtkThreshold()
        cut.SetInputData(wide)
        cut.SetInputArrayToProcess(0, 0, 0, 0, "Extinction")
        cut.SetUpperThreshold(1e-6)
        cut.SetThresholdFunction(cut.THRESHOLD_UPPER)
        cut.Update()
        for sun in ((0, 0, 1), (1, 0, 1)):
            expected, found = (light_of(data, sun)[0] for data in (wide, cut.GetOutput()))
            expected, found = (values(data, "Sunlight")[values(data, "Extinction") > 1e-3].mean() for data in (expected, found))
            self.assertAlmostEqual(found, expected, delta=0.05 * expected)

    def test_residues_of_sampling_are_no_cloud(self):
        """Tetrahedra are sampled. Where interpolation left a rounding error in place of 0, the light was up to 3e8."""
        noise = np.random.default_rng(3).normal(size=(24, 20, 20))
        for axis, width in ((0, 2.5), (1, 2), (2, 2)):
            f = np.fft.fftfreq(noise.shape[axis]).reshape([-1 if a == axis else 1 for a in range(3)])
            noise = np.fft.ifft(np.fft.fft(noise, axis=axis) * np.exp(-2 * (np.pi * width * f) ** 2), axis=axis).real
        data = image((20, 20, 24), (300, 300, 83), lambda x, y, z: np.maximum(noise / noise.std() - 1.2, 0).ravel() * 0.05)
        split = vtkDataSetTriangleFilter()
        split.SetInputData(data)
        split.Update()
        light, expected = (values(light_of(x, (1, -1, 1))[0], "Sunlight") for x in (split.GetOutput(), data))
        self.assertLess(light.max(), 1.5 * expected.max())
        self.assertLess(abs(light - expected).mean(), 0.1 * expected.mean())


if __name__ == "__main__":
    unittest.main()
