# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unsteady flow volumes against closed forms: where the smoke is, how much, how dense, and how its tetrahedra fit."""
import unittest

import numpy as np
from nephoscope_testing.flow import flow_volume, radius_of, update
from nephoscope_testing.meshes import add_array
from nephoscope_testing.time_series import TimeSeries
from vtkmodules.vtkCommonDataModel import vtkImageData

TURN = 2 * np.pi


def series(velocity, steps=11, end=1.0, **options):
    return TimeSeries(np.linspace(0, end, steps), velocity, **options)


class Blanked(TimeSeries):
    """With vtkGhostType on the cells."""

    def __init__(self, *args, flags, **options):
        super().__init__(*args, **options)
        self.flags = flags(None)

    def middle(self):
        k, j, i = np.argwhere(self.flags.reshape(self.dimensions[::-1] - 1))[0]
        low, high = self.bounds[::2], self.bounds[1::2]
        return low + (np.array([i, j, k]) + 0.5) * (high - low) / (self.dimensions - 1)

    def RequestData(self, request, inputs, outputs):
        super().RequestData(request, inputs, outputs)
        add_array(vtkImageData.GetData(outputs).GetCellData(), self.flags, "vtkGhostType")
        return 1


def circling(_points, time):
    return np.cos(TURN * time), np.sin(TURN * time), 1


def growing(points, time):
    """Shear and spread that change with time; divergence 0.6 + 0.4 t."""
    x, y, z = points.T
    return np.column_stack([0.3 * x + (1 - time) * z, 0.3 * y + 0.2 * np.sin(4 * time), 1 + 0.4 * time * z])


def follow(source, time=None, messages=(), **settings):
    made = flow_volume(source, **{"Unsteady": True, "NormalToFlow": False, "Radius": 0.2, "NumberOfSides": 6, **settings})
    smoke, told = update(made, time)
    assert [any(part in text for text in told) for part in messages] == [True] * len(messages) == [True] * len(told), told
    return smoke


class FlatCells(unittest.TestCase):
    def test_are_left_out_and_their_mass_is_lost(self):
        """All comes together at x = 1/2, until the points of a triangle have one x and its tetrahedra no volume."""
        smoke = follow(series(lambda p, t: np.column_stack([60 * (0.5 - p[:, 0]), 0 * p[:, 0], 1 + 0 * p[:, 0]])), Center=(0.5, 0, -0.4), TimeStep=0.01)
        made = smoke.made
        self.assertGreater(smoke.volumes().min(), 0)
        self.assertGreater(smoke.density.min(), 0)
        self.assertGreater(made.GetLostMass(), 0.1 * made.GetEmittedMass())
        self.assertAlmostEqual((smoke.mass() + made.GetLostMass()) / made.GetEmittedMass(), 1, places=9)


class Streakline(unittest.TestCase):
    def test_volume_and_place(self):
        """Smoke of t = 1/2 is moved by the integral of (cos, sin, 1) from 1/2 to 1: (0, -1/pi, 1/2). Between time steps the velocity
        is linear, so that 100 steps in a turn give the integrals but for a factor sinc(1/100)^2 = 1 - 3.3e-4."""
        smoke = follow(series(circling, 101), Radius=radius_of(0.02), NumberOfSides=3, TimeStep=1 / 12)
        self.assertAlmostEqual(smoke.volumes().sum(), 0.02, places=15)
        self.assertGreater(smoke.volumes().min(), 0)
        self.assertAlmostEqual(smoke.mass(), 0.02, places=15)
        self.assertAlmostEqual(smoke.made.GetEmittedMass(), 0.02, places=15)
        np.testing.assert_allclose(smoke.density, 1, rtol=1e-12)
        half = smoke.points[np.abs(smoke.age - 0.5) < 1e-9].mean(axis=0)
        np.testing.assert_allclose(half, (0, -np.sinc(0.01)**2 / np.pi, 0.5), atol=1e-14)
        self.assertEqual(set(smoke.cell_array("EmissionStep")), set(range(12)))
        np.testing.assert_allclose(smoke.cell_array("Age"), 1 - (smoke.cell_array("EmissionStep") + 0.5) / 12, atol=1e-14)
        self.assertTrue(smoke.is_one_piece())

    def test_times_between_steps_and_releases(self):
        for time in (0.03, 0.5, 0.77):
            smoke = follow(series(circling, 101), time, Radius=radius_of(0.02), NumberOfSides=3, TimeStep=1 / 12)
            self.assertAlmostEqual(smoke.volumes().sum(), 0.02 * time, places=15)
            self.assertAlmostEqual(smoke.mass(), 0.02 * time, places=15)
            oldest = smoke.points[np.abs(smoke.age - time) < 1e-9].mean(axis=0)
            expected = np.array([np.sin(TURN * time) / TURN, (1 - np.cos(TURN * time)) / TURN, time])
            np.testing.assert_allclose(oldest, expected, atol=3e-4)
            self.assertTrue(smoke.is_one_piece())

    def test_start_time_and_unit(self):
        """Hours, from hour 6 of a wind that has turned by then."""
        hourly = TimeSeries(np.linspace(0, 10, 6), lambda p, t: (0, 0, 1 / 3600) if t >= 6 else (0, 0, -1 / 3600), bounds=(-1, 1, -1, 1, -2, 9))
        smoke = follow(hourly, StartTime=6, TimeScale=3600, TimeStep=1800)
        self.assertAlmostEqual(smoke.points[:, 2].max(), 4, places=12)
        self.assertAlmostEqual(smoke.age.max(), 4 * 3600, places=8)
        self.assertEqual(len(np.unique(smoke.cell_array("EmissionStep"))), 8)
        self.assertEqual(hourly.reads, [6, 8, 10])

    def test_start_between_steps(self):
        smoke = follow(series(lambda p, t: (0, 0, t)), StartTime=0.45, TimeStep=0.1)
        self.assertAlmostEqual(smoke.points[:, 2].max(), (1 - 0.45**2) / 2, places=12)
        self.assertAlmostEqual(smoke.mass() / smoke.made.GetEmittedMass(), 1, places=12)

    def test_nothing_has_come_yet(self):
        """Which is told, with the time from which it comes and the remedy."""
        for time in (-1, 0, 0.3):
            told = f"no smoke at time {time}: unsteady smoke leaves the generating polygon from time 0.3 on, and needs time to grow. Play"
            self.assertEqual(len(follow(series(circling), time, messages=(told,), StartTime=0.3).cells), 0)

    def test_flow_that_turns_back(self):
        """Smoke that comes out on either side has positive volume and the mass of the flow."""
        smoke = follow(series(lambda p, t: (0.1, 0, 0.5 - t), 21), TimeStep=0.05)
        self.assertTrue((smoke.volumes() >= 0).all())
        self.assertAlmostEqual(smoke.mass(), smoke.made.GetEmittedMass(), places=12)
        self.assertAlmostEqual(smoke.made.GetEmittedMass(), 0.25 * 1.5 * np.sqrt(3) * 0.04, places=12)


class Mass(unittest.TestCase):
    def check_sum(self, smoke):
        made = smoke.made
        total = made.GetEmittedMass() - made.GetLostMass() - made.GetExpiredMass()
        self.assertLess(abs(smoke.mass() - total), 1e-12 * made.GetEmittedMass())

    def test_bisected(self):
        smoke = follow(series(growing), MaximumEdgeLength=0.12, TimeStep=0.05, InitialDensity=3)
        self.assertGreater(len(smoke.cells), 2000)
        self.check_sum(smoke)
        self.assertGreater(smoke.made.GetEmittedMass(), 0)

    def test_leaving_and_expiring(self):
        box = dict(bounds=(-1, 1, -1, 1, -0.5, 0.6))
        smoke = follow(series(growing, **box), MaximumEdgeLength=0.12, TimeStep=0.05)
        self.assertGreater(smoke.made.GetLostMass(), 0.1 * smoke.made.GetEmittedMass())
        self.check_sum(smoke)
        smoke = follow(series(growing, **box), MaximumEdgeLength=0.12, TimeStep=0.05, Duration=0.25)
        self.assertGreater(smoke.made.GetExpiredMass(), 0.1 * smoke.made.GetEmittedMass())
        self.assertEqual(smoke.made.GetLostMass(), 0)
        self.check_sum(smoke)
        self.assertLess(smoke.age.max(), 0.25 + 1e-9)

    def test_all_has_left(self):
        smoke = follow(series(lambda p, t: (0, 0, 3 if t < 0.3 else 0), bounds=(-1, 1, -1, 1, -0.1, 0.1)), TimeStep=0.1,
                       messages=["All smoke has left the data"])
        self.assertAlmostEqual(smoke.made.GetLostMass() / smoke.made.GetEmittedMass(), 1, places=12)

    def test_spreading_smoke_thins(self):
        """v = (x, y, 1): at age a the density is exp(-2 a). A layer of thickness h has exp(-2 a) h / sinh(h), which is h²/6 less, and
        the volume between its straight edges is h²/6 too large."""
        errors = []
        for steps in (16, 32):
            smoke = follow(series(lambda p, t: np.column_stack([p[:, 0], p[:, 1], np.ones(len(p))]), 3, bounds=(-3, 3, -3, 3, -0.5, 1.5)),
                           TimeStep=1 / steps, MaximumEdgeLength=10)
            step, volumes = smoke.cell_array("EmissionStep"), smoke.volumes()
            mass = np.bincount(step, smoke.density * volumes)
            density = mass / np.bincount(step, volumes)
            errors.append(np.abs(density * np.exp(2 * (1 - (np.arange(steps) + 0.5) / steps)) - 1).max())
        np.testing.assert_allclose(errors, [1 / (3 * 16**2), 1 / (3 * 32**2)], rtol=0.02)


class Bisection(unittest.TestCase):
    LIMIT = 0.07

    def test_fits_and_is_short(self):
        smoke = follow(series(growing), MaximumEdgeLength=self.LIMIT, TimeStep=0.05, Radius=0.1)
        coarse = follow(series(growing), MaximumEdgeLength=10, TimeStep=0.05, Radius=0.1)
        self.assertTrue(coarse.is_one_piece())
        self.assertTrue(smoke.is_one_piece())
        self.assertGreater(len(smoke.cells), 3 * len(coarse.cells))
        self.assertGreater(coarse.edge_lengths().max(), 1.4 * self.LIMIT)
        self.assertLessEqual(smoke.edge_lengths().max(), self.LIMIT)
        self.assertGreater(smoke.volumes().min(), 0)
        self.assertEqual(set(smoke.cell_array("EmissionStep")), set(range(20)))

    def test_with_the_layer_that_is_being_released(self):
        smoke = follow(series(growing), 0.93, MaximumEdgeLength=self.LIMIT, TimeStep=0.1, Radius=0.1)
        self.assertTrue(smoke.is_one_piece())

    def test_stretched_along_the_flow(self):
        """Layers that stay parallel have plane sides, so bisection changes the volume by rounding only."""
        stretching = lambda p, t: np.column_stack([0 * p[:, 0], 0 * p[:, 1], 1 + p[:, 2]])
        wide = dict(bounds=(-1, 1, -1, 1, -0.5, 2.5), dimensions=(3, 3, 3))
        volumes = [follow(series(stretching, 3, **wide), MaximumEdgeLength=length, TimeStep=1 / 16, Radius=0.1).volumes()
                   for length in (10, 0.1)]
        self.assertGreater(len(volumes[1]), 2 * len(volumes[0]))
        self.assertAlmostEqual(volumes[1].sum() / volumes[0].sum(), 1, places=12)

    def test_limit(self):
        smoke = follow(series(growing), MaximumEdgeLength=self.LIMIT, TimeStep=0.05, Radius=0.1, MaximumNumberOfTetrahedra=500,
                       messages=["MaximumNumberOfTetrahedra (500)"])
        self.assertLessEqual(len(smoke.cells), 500)
        self.assertGreater(len(smoke.cells), 150)
        self.assertAlmostEqual(smoke.age.max(), smoke.made.GetDurationUsed(), places=9, msg="smoke of the start is missing")
        self.assertAlmostEqual(smoke.age.min(), 0, places=9, msg="smoke of the end is missing")
        self.assertAlmostEqual(smoke.mass() / smoke.made.GetEmittedMass(), 1, places=12)


    def test_at_any_age_and_time(self):
        """Between two releases, at time steps of the data and beside them, the newest layer too is divided."""
        for time in (0.15, 0.45, 0.93, 1.0):
            smoke = follow(series(growing), time, MaximumEdgeLength=self.LIMIT, TimeStep=0.4, Radius=0.1)
            self.assertLessEqual(smoke.edge_lengths().max(), self.LIMIT)
            self.assertTrue(smoke.is_one_piece())
            self.assertAlmostEqual(smoke.mass() / smoke.made.GetEmittedMass(), 1, places=12)


class Merging(unittest.TestCase):
    def test_short_edges(self):
        """Smoke that converges: fewer tetrahedra in one piece, of the same mass, and almost the same volume."""
        converging = lambda p, t: np.column_stack([-1.5 * p[:, 0], -1.5 * p[:, 1] + 0.1 * t, np.ones(len(p))])
        all_edges, merged = (follow(series(converging), MinimumEdgeLength=length, MaximumEdgeLength=1, TimeStep=0.05, PolygonEdgeLength=0.05)
                             for length in (0, 0.04))
        self.assertLess(len(merged.cells), 0.6 * len(all_edges.cells))
        self.assertTrue(merged.is_one_piece())
        self.assertGreater(merged.volumes().min(), 0)
        self.assertAlmostEqual(merged.volumes().sum() / all_edges.volumes().sum(), 1, delta=2e-3)
        self.assertAlmostEqual(merged.mass() / all_edges.mass(), 1, places=12)


class Turning(unittest.TestCase):
    """Once around the z axis in a second, in steps of 45 degrees."""
    SETTINGS = dict(Center=(0.5, 0, 0), Radius=0.1, TimeStep=1 / 8)

    def smoke(self, angle, **settings):
        turning = lambda p, t: np.column_stack([-TURN * p[:, 1], TURN * p[:, 0], np.full(len(p), 0.3)])
        return follow(series(turning, 3), MaximumTurnAngle=angle, MaximumEdgeLength=5, **{**self.SETTINGS, **settings})

    def error(self, smoke):
        """Distance of the smoke of the start, which has come round, from where it was."""
        oldest = smoke.points[smoke.age > 1 - 1e-9].mean(axis=0)
        return np.linalg.norm(oldest - (0.5, 0, 0.3))

    def test_paths(self):
        """Runge-Kutta 4 has an error of h^4: steps of less than 45 / 3 degrees."""
        errors = [self.error(self.smoke(angle)) for angle in (0, 15)]
        self.assertGreater(errors[0], 1e-3)
        self.assertLess(errors[1], errors[0] / 81)

    def test_layers(self):
        """The sag of a chord falls with the square of its angle, and with it the error of the volume."""
        smokes = [self.smoke(angle) for angle in (0, 15)]
        errors = [abs(smoke.volumes().sum() / smoke.made.GetEmittedMass() - 1) for smoke in smokes]
        self.assertGreater(errors[0], 0.05)
        self.assertLess(errors[1], 0.25 * errors[0])
        for smoke in smokes:
            self.assertTrue(smoke.is_one_piece())
            self.assertEqual(set(smoke.cell_array("EmissionStep")), set(range(8)))
            self.assertAlmostEqual(smoke.mass() / smoke.made.GetEmittedMass(), 1, places=12)
        self.assertEqual(len(self.smoke(15, MaximumHalvings=0).cells), len(smokes[0].cells))


class Obstacles(unittest.TestCase):
    def test_mass_that_ends_at_them(self):
        """A box without velocities or cells in a uniform wind: what does not get past it has met it. At the end of the data nothing is met."""
        def holed(points, _time):
            v = np.tile((0.0, 0.0, 1.0), (len(points), 1))
            v[(np.abs(points[:, :2]) < 0.15).all(axis=1) & (np.abs(points[:, 2]) < 0.2)] = np.nan
            return v

        def blanked(_points):
            flags = np.zeros((24, 24, 24), np.uint8)
            flags[10:14, 10:14, 10:14] = 32
            return flags.ravel()
        missing, ended = "is not a finite number at", "% of it ended at"
        box = dict(dimensions=(25, 25, 25), bounds=(-1, 1, -1, 1, -1, 1))
        settings = dict(Center=(0, 0, -0.8), TimeStep=0.05)
        for source, messages in ((series(holed, 3, end=1.5, **box), (missing, ended)),
                                 (Blanked(np.linspace(0, 1.5, 3), lambda p, t: (0, 0, 1), flags=blanked, **box), (ended,)),
                                 (series(lambda p, t: (0, 0, 1), 3, end=2.5, **box), ())):
            smoke = follow(source, messages=messages, **settings)
            made = smoke.made
            self.assertGreater(made.GetLostMass(), 0.1 * made.GetEmittedMass())
            self.assertAlmostEqual(made.GetObstacleMass() / made.GetLostMass(), 1 if messages else 0, delta=0.02 if messages else 0)
            self.assertEqual(smoke.output.GetFieldData().GetArray("ObstacleMass").GetTuple1(0), made.GetObstacleMass())

    def blanked(self, points):
        """One cell of 24³, around (0.04, 0.04, 0.29)."""
        flags = np.zeros((24, 24, 24), np.uint8)
        flags[9, 12, 12] = 32
        return flags.ravel()

    def test_smaller_than_a_triangle(self):
        """The blanked cell is between the corners of the smoke: no tetrahedron covers its centre, and mass and volume stay true."""
        for size, covered in ((0, False), (10, True)):
            source = Blanked(np.linspace(0, 1, 3), lambda p, t: (0, 0, 1), dimensions=(25, 25, 25), flags=self.blanked)
            smoke = follow(source, Radius=0.3, NumberOfSides=4, PolygonEdgeLength=1, TimeStep=0.25, ObstacleSize=size,
                           messages=() if covered else ("% of it ended at obstacles inside the data",))
            p = smoke.points[smoke.cells]
            weights = np.linalg.solve(np.moveaxis(p[:, 1:] - p[:, :1], 1, 2), (source.middle() - p[:, 0])[..., None])[..., 0]
            self.assertEqual(bool(((weights >= 0).all(axis=1) & (weights.sum(axis=1) <= 1)).any()), covered)
            self.assertEqual(smoke.made.GetLostMass() > 0, not covered)
            self.assertAlmostEqual((smoke.mass() + smoke.made.GetLostMass()) / smoke.made.GetEmittedMass(), 1, places=12)
            self.assertLess(smoke.made.GetLostMass(), 0.5 * smoke.made.GetEmittedMass())


class Arrays(unittest.TestCase):
    def test_linear_arrays_are_exact(self):
        """Also between time steps."""
        linear = lambda p, t: 2 * p[:, 0] - p[:, 1] + 3 * p[:, 2] + 5 * t
        for time in (1.0, 0.87):
            smoke = follow(series(growing, arrays={"linear": linear}), time, TimeStep=0.05)
            np.testing.assert_allclose(smoke.point_array("linear"), linear(smoke.points, time), atol=1e-12)

    def test_name_of_our_own(self):
        source = series(circling, arrays={"Age": lambda p, t: np.full(len(p), 7.0)})
        smoke = follow(source, messages=["'Age' of the input has been replaced"])
        self.assertLessEqual(smoke.age.max(), 1)

    def test_initial_density(self):
        """By which drawing makes the pictures of different times comparable."""
        for time in (0.3, 1.0):
            smoke = follow(series(growing), time, InitialDensity=3.0)
            self.assertEqual(smoke.output.GetFieldData().GetArray("InitialDensity").GetTuple1(0), 3)
        steady = flow_volume(series(growing), InitialDensity=3.0)
        update(steady)
        self.assertFalse(steady.GetOutput().GetFieldData().HasArray("InitialDensity"))


if __name__ == "__main__":
    unittest.main()
