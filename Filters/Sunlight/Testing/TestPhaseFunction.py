#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Phase functions: Mie's series against published values, the table of cloud droplets against the series, means of 1 over the sphere, fogbow and glory."""
import pathlib
import re
import sys
import unittest

import numpy as np
from nephoscope import vtkSunlight
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import mie  # noqa: E402

# Size parameter, refractive index; efficiencies of extinction and scattering: Wiscombe 1980. The last from Bohren and Huffman 1983, appendix A, with backscattering.
PUBLISHED = ((10, 0.75, 2.232265, 2.232265), (100, 1.33 + 1e-5j, 2.101321, 2.096594), (100, 1.5 + 1j, 2.097502, 1.283697), (1, 10 + 10j, 2.532993, 2.049405))
KINDS = ("HenyeyGreenstein", "DoubleHenyeyGreenstein", "CloudDroplets")


def factors(kind, asymmetry=0.85, **options):
    """Scattering angles in degrees, and the two factors of the field array PhaseFunction."""
    cloud = vtkImageData()
    cloud.SetDimensions(3, 3, 3)
    extinction = numpy_to_vtk(np.ones(27), deep=1)
    extinction.SetName("Extinction")
    cloud.GetPointData().AddArray(extinction)
    light = vtkSunlight()
    light.SetInputData(cloud)
    light.SetAsymmetry(asymmetry)
    light.SetFollowCamera(True)
    getattr(light, f"SetPhaseFunctionTo{kind}")()
    for name, value in options.items():
        getattr(light, "Set" + name)(value)
    light.Update()
    table = vtk_to_numpy(light.GetOutput().GetFieldData().GetArray("PhaseFunction")).astype(float)
    return np.linspace(0, 180, len(table)), table.T


def henyey_greenstein(g, angles):
    return (1 - g**2) / (1 + g**2 - 2 * g * np.cos(np.radians(angles))) ** 1.5


def mean(angles, values):
    return mie.integral(values, np.cos(np.radians(angles))) / 2


class Mie(unittest.TestCase):
    def test_published_efficiencies(self):
        for x, index, extinction, scattering in PUBLISHED:
            found = mie.efficiencies(x, complex(index))
            self.assertAlmostEqual(found[0], extinction, delta=1e-6)
            self.assertAlmostEqual(found[1], scattering, delta=1e-6)
        found = mie.efficiencies(2 * np.pi * 0.525 / 0.6328, 1.55 + 0j)
        np.testing.assert_allclose(np.take(found, (0, 1, 3)), (3.10543, 3.10543, 2.92534), atol=1e-5)

    def test_angles_and_efficiencies_agree(self):
        x = 12.5
        angles = np.linspace(0, 180, 7201)
        intensity = mie.intensity(x, 1.33 + 0.01j, np.cos(np.radians(angles)))
        _, scattering, asymmetry, back = mie.efficiencies(x, 1.33 + 0.01j)
        self.assertAlmostEqual(4 * mean(angles, intensity) / x**2, scattering, delta=1e-5 * scattering)
        self.assertAlmostEqual(mean(angles, intensity * np.cos(np.radians(angles))) / mean(angles, intensity), asymmetry, delta=1e-5)
        self.assertAlmostEqual(4 * intensity[-1] / x**2, back, delta=1e-6)

    def test_table_is_that_of_the_series(self):
        """With fewer sizes: the ripple of single sizes is left."""
        _, phase = mie.droplet_phase_function(sizes=150, step=1.0)
        text = (pathlib.Path(__file__).parent.parent / "PhaseFunctions" / "DropletPhaseFunction.h").read_text()
        table = np.array([float(value) for value in re.findall(r"([\d.e+-]+)f,?", text[text.index("[] = {"):text.index("};")])])
        self.assertEqual(len(table), 721)
        self.assertLess(np.median(np.abs(table[16::4] / phase[4:] - 1)), 0.02)
        self.assertLess(np.percentile(np.abs(table[16::4] / phase[4:] - 1), 90), 0.1)


class Tables(unittest.TestCase):
    def test_mean_over_the_sphere(self):
        for kind in KINDS:
            angles, (phase, _) = factors(kind, MultipleScattering=False)
            self.assertAlmostEqual(mean(angles, phase), 1, delta=2e-4)
            asymmetry = mean(angles, phase * np.cos(np.radians(angles)))
            self.assertAlmostEqual(asymmetry, 0.85 if kind == KINDS[0] else 0.866, delta=2e-3)
            angles, (scaled, smooth) = factors(kind)
            np.testing.assert_allclose(scaled * (1 - asymmetry**2), phase, rtol=1e-3)
            self.assertGreater(smooth.min(), 0)

    def test_henyey_greenstein(self):
        for g in (-0.5, 0.0, 0.6):
            angles, (phase, _) = factors(KINDS[0], g, MultipleScattering=False)
            np.testing.assert_allclose(phase, henyey_greenstein(g, angles), rtol=1e-5)

    def test_after_light_that_went_straight_on(self):
        """The mean of the scaled function and the one that makes double scattering exact. Scattering twice multiplies the asymmetry parameters of each pair of functions."""
        for kind, g, parts in ((KINDS[0], 0.85, {0.85: 1}), (KINDS[0], 0.3, {0.3: 1}), (KINDS[0], 0.0, {0.0: 1}), (KINDS[1], 0.0, {0.9017: 0.975, -0.6: 0.025})):
            angles, (once, found) = factors(kind, g)
            mean_cosine = sum(one * weight for one, weight in parts.items())
            scaled, forward = mean_cosine / (1 + mean_cosine), mean_cosine**2
            twice = sum(a * b * henyey_greenstein(g * h, angles) for g, a in parts.items() for h, b in parts.items())
            exact = henyey_greenstein(scaled, angles)
            if forward > 0:
                exact = (twice - forward * once * (1 - forward) - (1 - forward) ** 2 * henyey_greenstein(scaled**2, angles)) / (forward * (1 - forward))
            np.testing.assert_allclose(found, (henyey_greenstein(scaled, angles) + np.maximum(exact, 0)) / 2, rtol=0.01, atol=0.01)

    def test_fogbow_and_glory(self):
        """A broad bow 30 to 45 degrees from the point opposite the sun, and rings within 5 degrees of it, which the fitted functions lack."""
        angles, (phase, _) = factors(KINDS[2], MultipleScattering=False)
        bow = (angles > 130) & (angles < 155)
        brightest = angles[bow][np.argmax(phase[bow])]
        self.assertTrue(135 < brightest < 150, brightest)
        self.assertGreater(phase[bow].max(), 3 * phase[(angles > 110) & (angles < 130)].max())
        self.assertGreater(phase[angles > 176].max(), 2.5 * phase[(angles > 165) & (angles < 172)].mean())
        rings = np.diff(np.sign(np.diff(phase[angles > 174])))
        self.assertGreaterEqual(np.count_nonzero(rings < 0), 1)


if __name__ == "__main__":
    unittest.main()
