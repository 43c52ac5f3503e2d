# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wind and DisplayVelocity: pointwise, at the poles, omega, missing values, and integrated along a path."""
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer

import globe_fields as gf

LAT = np.linspace(-90.0, 90.0, 37)
OMEGA = 2 * np.pi / (12 * 86400.0)  # rad/s


def solid_body(x, y, z, axis):
    """u, v of a rotation about `axis` at the physical radius, from the cross product alone."""
    east, north, up = gf.frame(x, y)
    velocity = np.cross(OMEGA * np.asarray(axis), up * (gf.RADIUS + z)[:, None])
    return {"u": (velocity * east).sum(1), "v": (velocity * north).sum(1), "w": 0 * x}, velocity


def rotated(point, axis, angle):
    axis = np.asarray(axis) / np.linalg.norm(axis)
    return (point * np.cos(angle) + np.cross(axis, point) * np.sin(angle) + axis * axis.dot(point) * (1 - np.cos(angle)))


def path_end(axis, start, exaggeration, spacing, hours=48.0):
    """Where vtkStreamTracer takes `start` (lon, lat, height) along DisplayVelocity, and where it should."""
    lon, lat, lev = np.arange(0, 360, spacing), np.arange(-90, 90.1, spacing), np.array([0.0, 10000.0, 20000.0])
    fields, _ = solid_body(*gf.mesh(lon, lat, lev), axis)
    out = gf.globe(gf.rectilinear(lon, lat, lev, fields), VerticalExaggeration=exaggeration).GetOutput()
    up = gf.frame(np.array(start[:1]), np.array(start[1:2]))[2][0]
    seed = up * (gf.RADIUS + exaggeration * start[2])
    seeds, at = vtkPolyData(), vtkPoints()
    at.SetDataTypeToDouble()
    at.InsertNextPoint(*seed)
    seeds.SetPoints(at)
    tracer = vtkStreamTracer()
    tracer.SetInputData(out)
    tracer.SetSourceData(seeds)
    tracer.SetInputArrayToProcess(0, 0, 0, 0, "DisplayVelocity")
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetIntegrationStepUnit(1)  # length
    tracer.SetInitialIntegrationStep(20000.0)
    tracer.SetMaximumPropagation(hours * 3600.0 * OMEGA * (gf.RADIUS + exaggeration * start[2]))
    tracer.SetMaximumNumberOfSteps(100000)
    tracer.Update()
    line = tracer.GetOutput()
    seconds = gf.values(line, "IntegrationTime")[-1]
    return gf.points(line)[-1], rotated(seed, axis, OMEGA * seconds), OMEGA * seconds


class Pointwise(unittest.TestCase):
    def test_solid_body_is_itself(self):
        axis = np.array([0.6, 0.0, 0.8])
        lon, lev = np.arange(24) * 15.0, np.array([0.0, 8000.0])
        x, y, z = gf.mesh(np.append(lon, 360.0), LAT, lev)
        fields, _ = solid_body(*gf.mesh(lon, LAT, lev), axis)
        out = gf.globe(gf.rectilinear(lon, LAT, lev, fields), VerticalExaggeration=25.0, VerticalWindIsOmega=False).GetOutput()
        _, wind = solid_body(x, y, z, axis)
        np.testing.assert_allclose(gf.values(out, "Wind"), wind, atol=1e-5)
        np.testing.assert_allclose(gf.values(out, "DisplayVelocity"), np.cross(OMEGA * axis, gf.points(out)), atol=1e-5)
        self.assertEqual(out.GetPointData().GetVectors().GetName(), "DisplayVelocity")

    def test_map(self):
        lon, lat, lev = np.arange(0, 50.0, 5), np.arange(-60, 61.0, 5), np.array([0.0, 8000.0])
        x, y, z = gf.mesh(lon, lat, lev)
        rng = np.random.default_rng(7)
        u, v, w = rng.normal(0, 20, (3, len(x)))
        grid = gf.rectilinear(lon, lat, lev, {"u": u, "v": v, "w": w})
        out = gf.globe(grid, Projection=1, VerticalExaggeration=10.0, VerticalWindIsOmega=False).GetOutput()
        np.testing.assert_allclose(gf.values(out, "Wind"), np.column_stack([u, v, w]), atol=1e-5)
        ratio = gf.RADIUS / (gf.RADIUS + z)
        expected = np.column_stack([ratio * u / np.cos(np.radians(y)), ratio * v, 10.0 * w])
        np.testing.assert_allclose(gf.values(out, "DisplayVelocity"), expected, rtol=1e-5, atol=1e-5)

    def test_pole_has_the_cartesian_mean(self):
        lon = np.arange(36) * 10.0
        x, y, z = gf.mesh(lon, LAT, [0.0, 1000.0])
        noise = np.random.default_rng(3).normal(0, 5, (2, len(x)))
        grid = gf.rectilinear(lon, LAT, [0.0, 1000.0], {"u": noise[0], "v": noise[1], "w": 0 * x})
        out = gf.globe(grid).GetOutput()
        east, north, _ = gf.frame(x, y)
        wind = east * noise[0][:, None] + north * noise[1][:, None]
        for j in (0, -1):
            mean = wind.reshape(2, 37, 36, 3)[:, j].mean(axis=1)
            got = gf.cube(out, gf.values(out, "Wind"))[:, j]
            np.testing.assert_allclose(got, np.repeat(mean[:, None], 37, axis=1), atol=1e-5)

    def test_omega_by_hand(self):
        """-1 Pa/s at 500 hPa and 250 K: 287.0529 * 250 / (50000 * 9.80665) = 0.146356 m/s."""
        lon, lat = [0.0, 10.0, 20.0], [0.0, 10.0]
        x, _, _ = gf.mesh(lon, lat, [500.0, 400.0])
        arrays = {"u": 0 * x, "v": 0 * x, "w": 0 * x - 1.0, "t": 0 * x + 250.0}
        out = gf.globe(gf.rectilinear(lon, lat, [500.0, 400.0], arrays)).GetOutput()
        speed = np.linalg.norm(gf.values(out, "Wind"), axis=1)
        np.testing.assert_allclose(speed, np.repeat([0.146356, 0.182945], 6), atol=2e-6)
        del arrays["t"]  # the standard atmosphere has 252.00 K at 5574.4 m
        out = gf.globe(gf.rectilinear(lon, lat, [500.0, 400.0], arrays)).GetOutput()
        self.assertAlmostEqual(np.linalg.norm(gf.values(out, "Wind")[0]), 0.146356 * 251.92 / 250.0, 5)

    def test_usual_names(self):
        """Winds of CMIP and of other models, where there are no u and v: the same vectors; omega or m/s by its name."""
        lon, lat = [0.0, 10.0, 20.0], [0.0, 10.0]
        x, y, _ = gf.mesh(lon, lat, [500.0, 400.0])
        for names, lift in ((("u", "v", "w"), -1.0), (("ua", "va", "wap"), -1.0), (("U", "V", "OMEGA"), -1.0), (("ua", "va", "wa"), 0.146356),
                            (("U", "V", "W"), 0.146356)):
            arrays = dict(zip(names, (5 + 0 * x, y, lift + 0 * x)))
            out = gf.globe(gf.rectilinear(lon, lat, [500.0, 400.0], {**arrays, "ta": 0 * x + 250.0})).GetOutput()
            wind = gf.values(out, "Wind")[0]  # at 0, 0: up is x, east is y, north is z
            np.testing.assert_allclose(wind, (0.146356, 5, 0), atol=2e-6, err_msg=str(names))
        out = gf.globe(gf.rectilinear(lon, lat, [500.0, 400.0], {"u": 0 * x, "v": 0 * x, "w": 0 * x, "ua": 0 * x + 9, "va": 0 * x})).GetOutput()
        self.assertEqual(np.abs(gf.values(out, "Wind")).max(), 0)  # its own names come first

    def test_missing_values_are_hidden_and_counted_once(self):
        lon = np.arange(12) * 30.0
        x, _, z = gf.mesh(lon, LAT, [100.0, 1000.0])
        u, gh = 0 * x + 5.0, z.copy()
        u[200], u[201], gh[301] = np.nan, 9.96921e36, np.nan
        grid = gf.rectilinear(lon, LAT, [100.0, 1000.0], {"u": u, "v": 0 * x, "w": 0 * x, "gh": gh})
        made = gf.globe(grid, quiet=False, LevelUnits=3)
        self.assertEqual(len(made.messages), 2, made.messages)
        self.assertIn("'gh'", " ".join(made.messages))
        hidden = gf.values(made.GetOutput(), "vtkGhostType")
        self.assertEqual((hidden > 0).sum(), 3)
        self.assertTrue(np.isfinite(gf.values(made.GetOutput(), "Wind")).all())
        self.assertTrue(np.isfinite(gf.points(made.GetOutput())).all())


class Integrated(unittest.TestCase):
    def check(self, axis, start, exaggeration):
        end, expected, angle = path_end(axis, start, exaggeration, 5.0)
        self.assertGreater(angle, 0.9)  # it got there: 48 h of a 12-day turn is 1.05 rad
        # A rotation's velocity is linear in the position, and the cells interpolate both alike: exact but
        # for the single precision of DisplayVelocity.
        self.assertLess(np.linalg.norm(end - expected) / np.linalg.norm(expected), 1e-6)

    def test_across_the_pole(self):
        self.check([0.0, -1.0, 0.0], [1.0, 70.0, 11000.0], 50.0)

    def test_across_the_seam(self):
        self.check([0.0, 0.0, 1.0], [340.0, 31.0, 9000.0], 50.0)

    def test_tilted(self):
        self.check([0.6, 0.0, 0.8], [100.0, 20.0, 9000.0], 1.0)


if __name__ == "__main__":
    unittest.main()
