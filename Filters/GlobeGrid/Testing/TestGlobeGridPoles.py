# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids without a row at the poles are closed there, as if the file had that row."""
import unittest

import numpy as np
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkFiltersParallel import vtkPieceRequestFilter

import globe_fields as gf
import nephoscope
from nephoscope_testing.texture import advection, of_place, turned, update

OMEGA = 1e-5  # rad/s
LEV = np.array([0.0, 6000.0, 14000.0])


def gaussian(rows):
    """Latitudes of a Gaussian grid, south to north."""
    return np.degrees(np.arcsin(np.polynomial.legendre.leggauss(rows)[0]))


def rotation(x, y, axis):
    """u, v of a solid body that turns about `axis`."""
    east, north, up = gf.frame(x, y)
    velocity = gf.RADIUS * OMEGA * np.cross(axis, up)
    return (velocity * east).sum(1), (velocity * north).sum(1)


def weather(lon, lat, lev=LEV, seed=0):
    """Random fields; u and v are of any direction at each point."""
    shape = (len(lev), len(lat), len(lon))
    rng = np.random.default_rng(seed)
    fields = {name: rng.normal(size=shape) for name in ("q", "u", "v", "w")}
    fields["gh"] = lev[:, None, None] + rng.uniform(-200, 200, shape)
    fields["code"] = rng.integers(0, 5, shape).astype(np.uint8)
    fields["pair"] = rng.normal(size=shape + (2,))
    return fields


def with_poles(lon, lat, fields):
    """The same input as a file that has rows at the poles: means, medians, and the mean wind seen from each meridian."""
    longer = {}
    for name, values in fields.items():
        mean = (lambda row: np.median(row, axis=1, keepdims=True)) if name == "code" else (lambda row: row.mean(1, keepdims=True))
        ends = [np.repeat(mean(values[:, j]), len(lon), axis=1)[:, None] for j in (0, -1)]
        longer[name] = np.concatenate([ends[0], values, ends[1]], axis=1).astype(values.dtype)
    turn = np.radians(lon)
    for j, sign in ((0, -1), (-1, 1)):  # at a pole north is along -sign * (cos, sin), east is (-sin, cos)
        u, v = fields["u"][:, j], fields["v"][:, j]
        a = (-np.sin(turn) * u - sign * np.cos(turn) * v).mean(1, keepdims=True)
        b = (np.cos(turn) * u - sign * np.sin(turn) * v).mean(1, keepdims=True)
        longer["u"][:, j] = -np.sin(turn) * a + np.cos(turn) * b
        longer["v"][:, j] = -sign * (np.cos(turn) * a + np.sin(turn) * b)
    return np.r_[-90.0, lat, 90.0], longer


def ravelled(fields):
    return {name: values.reshape(-1, *values.shape[3:]) for name, values in fields.items()}


def grid(lon, lat, fields, lev=LEV):
    return gf.rectilinear(lon, lat, lev, ravelled(fields))


def curvilinear(lon, lat, fields, lev=LEV):
    return gf.structured(*gf.mesh(lon, lat, lev), (len(lon), len(lat), len(lev)), ravelled(fields))


def made(data, **settings):
    return gf.globe(data, VerticalWindIsOmega=False, LevelUnits=3, **settings).GetOutput()


class Poles(unittest.TestCase):
    def same(self, one, other):
        self.assertEqual(one.GetExtent(), other.GetExtent())
        np.testing.assert_allclose(gf.points(one), gf.points(other), atol=1e-6)
        for a in range(other.GetPointData().GetNumberOfArrays()):
            name = other.GetPointData().GetArrayName(a)
            np.testing.assert_allclose(gf.values(one, name), gf.values(other, name), atol=2e-6, err_msg=name)

    def test_as_if_the_file_had_them(self):
        rng = np.random.default_rng(5)
        for rows, build in ((8, grid), (33, curvilinear), (64, grid)):
            lon = np.arange(int(rng.integers(7, 40)))
            lon = 360.0 * lon / len(lon) + rng.uniform(-180, 180)
            lat = gaussian(rows)
            fields = weather(lon, lat, seed=rows)
            full_lat, full = with_poles(lon, lat, fields)
            for settings in ({}, {"Projection": 1}, {"Projection": 1, "UseCentralMeridian": True, "CentralMeridian": 77.0},
                             {"CloseSeam": False}, {"VerticalExaggeration": 30.0}):
                with self.subTest(rows=rows, **settings):
                    self.same(made(build(lon, lat, fields), **settings), made(build(lon, full_lat, full), **settings))

    def test_north_to_south_and_closed_already(self):
        lon, lat = np.linspace(0, 360, 13), gaussian(12)
        fields = {name: np.concatenate([v[:, :, :12], v[:, :, :1]], axis=2) for name, v in weather(lon, lat).items()}
        closed = made(grid(lon, lat, fields))
        self.same(closed, made(grid(lon[:-1], lat, {n: v[:, :, :-1] for n, v in fields.items()})))
        self.same(made(grid(lon, lat[::-1], {n: v[:, ::-1] for n, v in fields.items()})), closed)

    def test_one_pole_missing(self):
        lon, lat = np.arange(12) * 30.0, np.linspace(-90, 80, 18)
        out = made(grid(lon, lat, weather(lon, lat)))
        self.assertEqual(gf.dimensions(out), (13, 19, 3))
        self.assertAlmostEqual(gf.points(out)[:, 2].max(), gf.points(out)[-1, 2])

    def test_left_alone(self):
        lon = np.arange(12) * 30.0
        for what, lon, lat, settings in (("regional", lon[:6], gaussian(16), {}), ("a band", lon, np.linspace(-60, 60, 9), {}),
                                         ("has them", lon, np.linspace(-90, 90, 7), {}), ("off", lon, gaussian(16), {"ClosePoles": False})):
            with self.subTest(what):
                out = made(grid(lon, lat, weather(lon, lat)), **settings)
                self.assertEqual(gf.dimensions(out)[1], len(lat))

    def test_solid_body(self):
        """The mean of a ring's horizontal winds is (1 + |sin latitude|)/2 of the wind at the pole, if that is crossed."""
        lon, lat = np.arange(36) * 10.0, gaussian(48)
        x, y, z = gf.mesh(lon, lat, LEV)
        u, v = rotation(x, y, [1.0, 0.0, 0.0])
        out = made(gf.rectilinear(lon, lat, LEV, {"u": u, "v": v, "w": 0 * u}))
        wind = gf.cube(out, gf.values(out, "Wind"))
        share = 0.5 * (1 + np.sin(np.radians(lat[-1])))
        for j, pole in ((0, -1.0), (-1, 1.0)):
            exact = gf.RADIUS * OMEGA * np.cross([1.0, 0.0, 0.0], [0.0, 0.0, pole])
            np.testing.assert_allclose(wind[:, j] / np.linalg.norm(exact), np.broadcast_to(share * exact / np.linalg.norm(exact),
                                                                                           wind[:, j].shape), atol=1e-6)

    def test_missing_values(self):
        lon, lat = np.arange(12) * 30.0, gaussian(10)
        fields = weather(lon, lat)
        fields["q"][0, -1, :] = np.nan       # the whole ring
        fields["q"][1, -1, 3] = np.nan       # one of it
        fields["q"][2, -1, 4] = 9.96921e36
        out = made(grid(lon, lat, fields))
        q = gf.cube(out, gf.values(out, "q"))[:, -1]
        self.assertTrue(np.isnan(q[0]).all())
        np.testing.assert_allclose(q[1], np.nanmean(fields["q"][1, -1]))
        np.testing.assert_allclose(q[2], np.delete(fields["q"][2, -1], 4).mean())

    def test_cell_centres(self):
        """Fields on the cells of a grid from pole to pole become points off the poles, and are closed."""
        edges = np.linspace(-90, 90, 13)
        cells = gf.rectilinear(np.arange(13) * 30.0, edges, np.array([0.0, 1000.0, 3000.0]))
        gf.add(cells, {"q": np.random.default_rng(1).normal(size=12 * 12 * 2)}, cells=True)
        self.assertEqual(gf.dimensions(made(cells)), (13, 14, 2))

    def test_ground(self):
        """The South Pole is under 680 hPa: the added row is hidden as one."""
        lon, lat, lev = np.arange(12) * 30.0, gaussian(12), np.array([1000.0, 700.0, 500.0])
        surface = gf.rectilinear(lon, lat, [0.0], {"sp": np.where(np.repeat(lat, 12) < -60, 68000.0, 101300.0)
                                                   + np.random.default_rng(2).uniform(-500, 500, 144)})
        out = gf.globe(gf.rectilinear(lon, lat, lev, {"q": np.zeros(3 * 144)}), SurfaceData=surface).GetOutput()
        below = gf.cube(out, gf.values(out, "BelowGround"))
        np.testing.assert_array_equal(below[:, 0], [[1] * 13, [1] * 13, [0] * 13])
        np.testing.assert_array_equal(below[:, -1], 0)

    def test_pieces_and_threads(self):
        lon, lat = np.arange(24) * 15.0, gaussian(20)
        whole = made(grid(lon, lat, weather(lon, lat)))
        pieces = nephoscope.vtkGlobeGrid()
        pieces.SetInputData(grid(lon, lat, weather(lon, lat)))
        pieces.SetVerticalWindIsOmega(False)
        pieces.SetLevelUnitsToHeightMetre()
        request = vtkPieceRequestFilter()
        request.SetInputConnection(pieces.GetOutputPort())
        request.SetNumberOfPieces(4)
        seen = set()
        for piece in range(4):
            request.SetPiece(piece)
            request.Update()
            out = request.GetOutput()
            e = out.GetExtent()
            for name in ("q", "u", "Wind", "DisplayVelocity", "Height", "code"):
                expected = gf.cube(whole, gf.values(whole, name))[e[4]:e[5] + 1, e[2]:e[3] + 1, e[0]:e[1] + 1]
                np.testing.assert_array_equal(gf.cube(out, gf.values(out, name)), expected)
            seen |= {e[2], e[3]}
        self.assertTrue({0, 21} <= seen, seen)


class Across(unittest.TestCase):
    """What the suite does with a grid goes on across a closed pole."""

    def setUp(self):
        self.lon, self.lat = np.arange(36) * 10.0, gaussian(36)

    def cap(self, pole):
        levels = np.array([0.0, 2000.0, 4000.0, 6000.0, 8000.0, 11000.0, 14000.0])
        x, y, z = gf.mesh(self.lon, self.lat, levels)
        up = gf.frame(x, y)[2]
        u, v = rotation(x, y, [1.0, 0.0, 0.0])
        cloud = np.exp(-((1 - pole * up[:, 2]) / 0.05) ** 2 - ((z - 6000.0) / 2500.0) ** 2)
        return made(gf.rectilinear(self.lon, self.lat, levels, {"cloud": cloud, "u": u, "v": v, "w": 0 * u}), VerticalExaggeration=50.0)

    def test_cloud_surface_has_no_hole(self):
        for pole in (-1, 1):
            surface = nephoscope.vtkCloudSurface()
            surface.SetInputData(self.cap(pole))
            surface.SetInputArrayToProcess(0, 0, 0, 0, "cloud")
            surface.SetValue(0, 0.3)
            surface.SetNumberOfSmoothingIterations(1)
            surface.Update()
            edges = vtkFeatureEdges()
            edges.SetInputData(surface.GetOutput())
            edges.FeatureEdgesOff()
            edges.ManifoldEdgesOff()
            edges.Update()
            self.assertGreater(surface.GetOutput().GetNumberOfCells(), 50)
            self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)

    def test_smoothing_is_the_same_for_the_row_of_a_file(self):
        fields = weather(self.lon, self.lat)
        outputs = []
        for lat, these in ((self.lat, fields), with_poles(self.lon, self.lat, fields)):
            smoothing = nephoscope.vtkStructuredSmoothing()
            smoothing.SetInputData(made(grid(self.lon, lat, these)))
            smoothing.AddArrayName("q")
            smoothing.SetNumberOfIterations(2)
            smoothing.Update()
            outputs.append(gf.values(smoothing.GetOutput(), "q"))
        np.testing.assert_allclose(*outputs, atol=1e-12)
        pole = gf.cube(made(grid(self.lon, self.lat, fields)), outputs[0])[:, -1]
        np.testing.assert_allclose(pole, np.broadcast_to(pole[:, :1], pole.shape), atol=1e-12)

    def farthest_from_the_turn(self):
        """Kilometres between advected and exact coordinates, at most, after half a day of a turn about the x axis."""
        texture, messages = update(advection(self.cap(1)), 43200.0)
        self.assertEqual(messages, [])
        points = gf.points(texture.output)
        start = points / np.linalg.norm(points, axis=1)[:, None]
        return max(gf.RADIUS / 1000 * np.linalg.norm(of_place(coordinates) - turned(start, (1.0, 0.0, 0.0), -OMEGA * age), axis=1).max()
                   for coordinates, age in zip(texture.sets, texture.ages))

    def test_texture_moves_over_the_pole(self):
        """The wind at the added pole is too weak by a part of (1 - sin latitude)/2; the path is no farther off than that."""
        closed = self.farthest_from_the_turn()
        weak = 0.5 * (1 - np.sin(np.radians(self.lat[-1])))
        self.lat = np.r_[-90.0, self.lat, 90.0]
        self.assertLess(closed, self.farthest_from_the_turn() + weak * OMEGA * 43200.0 * gf.RADIUS / 1000)


if __name__ == "__main__":
    unittest.main()
