# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter's volumes, densities and boundaries against closed forms, and the orders at which they get there.

Smoke of one second in N layers, from a triangle of n x n triangles with legs of 0.2. Linear flows are exact on any grid.
"""
import unittest

import numpy as np
from nephoscope_testing import known_flows as known
from nephoscope_testing.flow import flow_volume, radius_of, update
from nephoscope_testing.known_flows import HELIX, OBLIQUE, SADDLE, SPREADING, UNIFORM, smoke_of
from nephoscope_testing.particle_surface import hausdorff_distance, surface_of_particles
from nephoscope_testing.time_series import TimeSeries

RUNGE_KUTTA_45 = {"Integrator": 1, "Tolerance": 1e-9}


def runge_kutta_4(matrix):
    return known.series(matrix, 4)


class Quadratic:
    """v = (x² / 2, 0, 1) thins smoke most where x is largest: by 1 / (1 + x age / 2)², with the x to which it has come."""
    corners, bounds = UNIFORM.corners, (0, 1, 0, 1, -0.5, 1.5)

    def velocity(self, points):
        x, one = points[:, 0], np.ones(len(points))
        return np.column_stack([x**2 / 2, 0 * one, one])


def error(flow, steps, n, data=None):
    return smoke_of(flow, steps, n, data).volumes().sum() / flow.volume() - 1


class Volume(unittest.TestCase):
    def test_uniform_flows_are_exact(self):
        for flow in (UNIFORM, OBLIQUE):
            for steps, n in ((1, 1), (7, 3), (16, 4)):
                self.assertAlmostEqual(smoke_of(flow, steps, n).volumes().sum(), 0.02, places=15)

    def test_prisms_have_the_closed_form_of_runge_kutta_4(self):
        """The layers of the helix shrink a little with each step of 45 degrees; Euler's would grow."""
        for flow in (SADDLE, HELIX, SPREADING):
            for steps in (8, 16):
                for n in (1, 3):
                    volume = known.bilinear_volumes(smoke_of(flow, steps, n), steps).sum()
                    self.assertAlmostEqual(volume / flow.layered_volume(steps, runge_kutta_4), 1, places=12)

    def test_prisms_of_the_true_flow(self):
        """The numbers are the integral of det((1 - s) I + s exp(M / 16)), less 1."""
        for flow, expected in ((SADDLE, 6.512536e-4), (HELIX, -2.5373489e-2)):
            volume = known.bilinear_volumes(smoke_of(flow, 16, 2, **RUNGE_KUTTA_45), 16).sum()
            self.assertAlmostEqual(flow.layered_volume(16) / flow.volume() - 1, expected, places=9)
            self.assertAlmostEqual(volume / flow.volume() - 1, expected, places=8)

    def test_tetrahedra_are_of_second_order(self):
        """Sides that were all cut the same way would give the saddle 2.2e-2, 1.1e-2 and 5.5e-3 with n = 1: first order."""
        for steps, bound in ((16, 5e-3), (32, 2.5e-3), (64, 5e-4)):
            self.assertLess(abs(error(SADDLE, steps, 1)), bound)
        self.assertLess(abs(error(SADDLE, 64, 4)), 1e-4)
        for n in (1, 4):
            order = np.log2(error(HELIX, 8, n) / error(HELIX, 64, n)) / 3
            self.assertAlmostEqual(order, 2, delta=0.1)

    def test_divergence(self):
        """div v = 2: V = Q (e^2 - 1) / 2. The error falls as the step squared over 6."""
        self.assertAlmostEqual(SPREADING.volume(), 0.0638905610, places=10)
        for steps in (8, 16, 32):
            self.assertAlmostEqual(error(SPREADING, steps, 2) * 6 * steps**2, 1, delta=0.01)


class Layers(unittest.TestCase):
    def test_drift_in_flows_without_divergence(self):
        """Layers as thick as Q t, to second order in steps and edges together."""
        for flow, bound in ((SADDLE, 4e-3), (HELIX, 5e-2)):
            coarse, fine = (known.drift(smoke_of(flow, steps, steps // 4), flow, steps) for steps in (16, 32))
            self.assertLess(coarse, bound)
            self.assertGreater(coarse / fine, 3.5)

    def test_density_of_spreading_smoke(self):
        """exp(-2 age). A layer of thickness h has that times h / sinh(h), its volume is h²/6 too large: h²/3 in all."""
        smoke = smoke_of(SPREADING, 16, 2, InitialDensity=3)
        self.assertAlmostEqual(smoke.density[-1] / smoke.density[0], np.exp(-2 * (1 - 1 / 16)), places=6)
        self.assertAlmostEqual(smoke.mass(), 3 * 0.02, places=15)
        self.assertAlmostEqual(smoke.made.GetEmittedMass(), 3 * 0.02, places=15)
        thin = smoke.density * np.exp(2 * smoke.cell_array("Age")) / 3
        np.testing.assert_allclose(1 - thin, 1 / (3 * 16**2), rtol=0.02)

    def test_density_across_a_layer(self):
        """0.56 to 0.72 in the last one; x and age are those in the middle between left and right, bottom and top of a prism, which three tetrahedra
        in a row fill: between x = a and b the chord of the map has the slope at the (harmonic) middle, not at the centre of the corners."""
        smoke = smoke_of(Quadratic(), 16, 4, known.sampled(Quadratic(), 48))
        corners = smoke.points[smoke.cells.reshape(-1, 12), 0]
        x = (corners.min(axis=1) + corners.max(axis=1)) / 2
        density, age = smoke.density[::3], smoke.cell_array("Age")[::3]
        np.testing.assert_allclose(density * (1 + x * age / 2)**2, 1, atol=2e-3)
        self.assertGreater(np.ptp(density[-16:]), 0.1)

    def test_density_stays_without_divergence(self):
        for flow in (UNIFORM, OBLIQUE):
            np.testing.assert_allclose(smoke_of(flow, 8, 2).density, 1, rtol=1e-12)
        smoke = smoke_of(HELIX, 64, 8, **RUNGE_KUTTA_45)
        np.testing.assert_allclose(smoke.density, 1, atol=2e-2)
        self.assertAlmostEqual(smoke.mass(), 0.02, places=15)


class Particles(unittest.TestCase):
    def test_points_are_of_fourth_order(self):
        for flow in (SADDLE, HELIX):
            errors = [known.furthest_particle(smoke_of(flow, steps, 1), flow, steps) for steps in (8, 16, 32)]
            np.testing.assert_allclose(np.log2(errors[:-1]) - np.log2(errors[1:]), 4, atol=0.15)
            self.assertLess(known.furthest_particle(smoke_of(flow, 8, 1, **RUNGE_KUTTA_45), flow, 8), 2e-9)

    def test_boundary_is_of_second_order(self):
        """At most the sag of a chord, acceleration times h²/8, and how far a diagonal is from the skew side it cuts, |M edge| h / 4;
        no less than half the sag."""
        cases = ((SADDLE, 8, np.hypot(0.5 * np.e, 0.3), np.hypot(0.2 * np.e, 0.2)),
                 (HELIX, 16, known.TURN**2 * np.hypot(0.5, 0.3), known.TURN * np.hypot(0.2, 0.2)))
        for flow, steps, acceleration, shear in cases:
            particles = surface_of_particles(flow, 8, 256)
            distances = []
            for count in (steps, 2 * steps):
                distances.append(hausdorff_distance(smoke_of(flow, count, count // 4), particles, 1))
                sag, skew = acceleration / (8 * count**2), shear / (count // 4) / (4 * count)
                self.assertLess(distances[-1], sag + skew)
                self.assertGreater(distances[-1], 0.5 * sag)
            self.assertAlmostEqual(distances[0] / distances[1], 4, delta=0.4)


class Sampled(unittest.TestCase):
    """The flow of Arnold, Beltrami and Childress is not linear: its grid of 48 cells adds an error of about 3e-4."""

    @classmethod
    def setUpClass(cls):
        cls.flow = known.ABC()
        cls.data = known.sampled(cls.flow, 48)

    def test_volume(self):
        """Beside prisms between true particles: without the error of the straight edges, which is 1.9e-2 / n²."""
        errors = []
        for n in (1, 2):
            smoke = smoke_of(self.flow, 32, n, self.data)
            fronts = known.fronts_of(smoke, 32)
            true = self.flow.paths(fronts[0], np.arange(33) / 32)
            expected = known.prism_volumes(true, known.triangles_of(smoke, fronts.shape[1])).sum()
            volume = known.bilinear_volumes(smoke, 32).sum()
            self.assertAlmostEqual(volume / expected, 1, delta=5e-4)
            errors.append(volume / self.flow.volume() - 1)
        self.assertAlmostEqual(errors[0] / errors[1], 4, delta=0.4)
        self.assertLess(abs(error(self.flow, 32, 8, self.data)), 1e-3)

    def test_flux(self):
        smoke = smoke_of(self.flow, 4, 8, self.data)
        self.assertAlmostEqual(self.flow.flux, 0.0311400221, places=10)
        self.assertAlmostEqual(smoke.made.GetEmittedMass() / self.flow.flux, 1, delta=5e-4)

    def test_boundary(self):
        particles = surface_of_particles(self.flow, 16, 128)
        distances = [hausdorff_distance(smoke_of(self.flow, steps, steps // 4, self.data), particles, 1) for steps in (8, 16)]
        self.assertAlmostEqual(distances[0] / distances[1], 4, delta=0.4)
        self.assertLess(distances[1], 3e-3)


class Streak(unittest.TestCase):
    def test_error_of_the_time_steps_of_the_data(self):
        """(cos, sin, 1) that turns once: smoke of t = 1/2 is moved by (0, -1 / pi, 1/2). Linear between
        time steps of length h the wind has the integrals of the trapezoidal rule, which are pi h / tan(pi h) of that."""
        errors = []
        for count in (16, 32):
            source = TimeSeries(np.linspace(0, 1, count + 1), lambda p, t: (np.cos(known.TURN * t), np.sin(known.TURN * t), 1))
            smoke = update(flow_volume(source, Unsteady=True, NormalToFlow=False, Radius=radius_of(0.02), NumberOfSides=3,
                                       TimeStep=1 / 12, MaximumEdgeLength=10))[0]
            self.assertAlmostEqual(smoke.volumes().sum(), 0.02, places=15)
            place = smoke.points[np.abs(smoke.age - 0.5) < 1e-9].mean(axis=0)
            errors.append(np.linalg.norm(place - (0, -1 / np.pi, 0.5)))
            self.assertAlmostEqual(errors[-1], 1 / np.pi - 1 / np.tan(np.pi / count) / count, delta=1e-12)
        self.assertAlmostEqual(errors[0] / errors[1], 4, delta=0.1)


if __name__ == "__main__":
    unittest.main()
