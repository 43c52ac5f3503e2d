# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TrueSpeed: patterns travel at the speed of their vectors, measured in rendered frames of uniform and sheared flow and of a globe.

Streaks are drawn on splats that do not move. Their correlation in space would be biased by that, so the time is measured in which brightness
gets from one place to another. Segments are isolated, and their centres are followed.
"""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid

PIXELS = 240
SCALE = 10.0  # half the height of the view, in parallel projection
FRONT = {"position": (0, 0, 40), "parallel_scale": SCALE, "near": 5, "far": 90}
DISTANCE, ANGLE = 4.0, 34.0  # of the eye from the middle of the globe, of radius 1, and of its view
GLOBE = {"position": (0, 0, DISTANCE), "angle": ANGLE}
SPIN = np.array([0.1, 0.3, 0.0])
VECTORS_ALONE = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (1, 0)])
TIME_SCALE = 3.0
LIMIT = 0.02


def sheet(size=24):
    return meshes.image((size, size, 0), origin=(-size / 2, -size / 2, 0))


def on_globe(longitudes, latitudes):
    longitude, latitude = (angle.ravel() for angle in np.meshgrid(np.radians(longitudes), np.radians(latitudes)))
    return np.column_stack([np.cos(latitude) * np.sin(longitude), np.sin(latitude), np.cos(latitude) * np.cos(longitude)])


def cap(longitudes, latitudes):
    """The part of a globe that faces the eye, as a bent sheet."""
    grid = vtkStructuredGrid()
    grid.SetDimensions(len(longitudes), len(latitudes), 1)
    grid.SetPoints(meshes.vtk_points(on_globe(longitudes, latitudes)))
    return grid


def with_wind(data, wind):
    points = meshes.points_of(data)
    meshes.with_field(data, lambda p: 0 * p[:, 0])
    meshes.add_array(data.GetPointData(), wind(points), "v")
    return data


def uniform(vector):
    return lambda points: np.tile(np.asarray(vector, float), (len(points), 1))


def sheared(points):
    return np.column_stack([1 + 0.05 * points[:, 1], 0 * points[:, 0], 0 * points[:, 0]])


def turning(points):
    return np.cross(SPIN, points)


def flat(points):
    """Pixels at which points are seen in the parallel view."""
    return points[:, :2] * (PIXELS / (2 * SCALE)) + PIXELS / 2


def seen(points):
    """The same for the globe."""
    scale = PIXELS / 2 / np.tan(np.radians(ANGLE / 2)) / (DISTANCE - points[:, 2])
    return points[:, :2] * scale[:, None] + PIXELS / 2


def motion(points, wind, project):
    """Pixels by which points move in a second of film."""
    step = 1e-3
    return TIME_SCALE * (project(points + step * wind(points)) - project(points - step * wind(points))) / (2 * step)


def at(frames, places):
    """Brightness of all frames at places (x, y) in pixels, between pixels linearly."""
    x, y = places.T - 0.5
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    a, b = x - i, y - j
    return ((1 - a) * (1 - b) * frames[:, j, i] + a * (1 - b) * frames[:, j, i + 1] +
            (1 - a) * b * frames[:, j + 1, i] + a * b * frames[:, j + 1, i + 1])


def flight_time(frames, before, after, expected):
    """Frames in which brightness gets from places to others: the lag of the greatest correlation, between frames by a parabola."""
    f, g = at(frames, before), at(frames, after)
    f, g = f - f.mean(axis=0), g - g.mean(axis=0)
    lags = np.arange(int(0.6 * expected), int(1.4 * expected) + 2)
    sums = np.array([np.mean(f[:len(f) - lag] * g[lag:]) for lag in lags])
    best = int(np.clip(np.argmax(sums), 1, len(sums) - 2))
    low, middle, high = sums[best - 1:best + 2]
    return lags[best] + 0.5 * (low - high) / (low - 2 * middle + high)


class Speed(ImageTestCase):
    def scene(self, data, look=None, **settings):
        self.window = Window((PIXELS, PIXELS))
        scene = self.window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetVectorArrayName("v")
        mapper.SetVectorOpacity(0.5)
        mapper.TrueSpeedOn()
        mapper.SetTimeScale(TIME_SCALE)
        for name, value in settings.items():
            getattr(mapper, "Set" + name)(value)
        scene.add_volume(mapper, data, VECTORS_ALONE)
        scene.look(**(look or FRONT))
        return mapper

    def picture(self, mapper, time):
        mapper.SetFilmTime(time)
        self.window.render()
        return -np.log1p(-float_image(mapper)[..., 3])

    def frames(self, mapper, step, count):
        pictures = np.array([self.picture(mapper, i * step) for i in range(count)])
        self.fail_on_messages(self.window)
        return pictures

    def check_ratio(self, what, ratio):
        print(f"  {what}: {ratio:.4f} of the speed of the wind")
        self.assertLess(abs(ratio - 1), LIMIT, what)

    def check_streaks(self, name, mapper, points, wind, project, pixels=1.5, lag=8, count=64):
        """Between points half of `lag` steps before and after; the mean step is so many pixels."""
        velocities = motion(points, wind, project)
        step = pixels / np.linalg.norm(velocities, axis=1).mean()
        frames = self.frames(mapper, step, count)
        way = 0.5 * lag * step * velocities
        self.check_ratio(f"streaks, {name}", lag / flight_time(frames, project(points) - way, project(points) + way, lag))

    def check_segments(self, name, wind, places, project, look=None, frames=24, **settings):
        """Median over frames of the displacement of each segment's centre, in a window of its own: seldom it fades into the next one."""
        data = meshes.particles(places)
        meshes.add_array(data.GetPointData(), np.zeros(len(places)))
        meshes.add_array(data.GetPointData(), wind(places), "v")
        mapper = self.scene(data, look, **{"VectorStyle": 1, "VectorUnit": 1.0, "CellSize": 0.01, **settings})
        velocities = motion(places, wind, project)
        step = 1.2 / np.linalg.norm(velocities, axis=1).max()
        pictures = self.frames(mapper, step, frames)
        half = 22
        ratios = []
        for middle, velocity in zip(np.round(project(places)).astype(int), velocities):
            window = pictures[:, middle[1] - half:middle[1] + half, middle[0] - half:middle[0] + half]
            axis = np.arange(2 * half)
            centre = np.stack([(window * axis).sum(axis=(1, 2)), (window * axis[:, None]).sum(axis=(1, 2))], 1) / window.sum(axis=(1, 2))[:, None]
            moved = np.median(np.diff(centre, axis=0), axis=0)
            ratios.append(moved @ velocity / step / (velocity @ velocity))
        self.check_ratio(f"segments, {name}, slowest", min(ratios))
        self.check_ratio(f"segments, {name}, fastest", max(ratios))

    def test_streaks_in_uniform_flow(self):
        points = np.insert(np.stack(np.meshgrid(*(np.arange(-7, 7, 0.25),) * 2), -1).reshape(-1, 2), 2, 0, axis=1)
        for vector in ((2, 0, 0), (-0.6, 0.8, 0)):
            wind = uniform(vector)
            self.check_streaks(f"wind {vector}", self.scene(with_wind(sheet(), wind)), points, wind, flat)

    def test_streaks_in_sheared_flow(self):
        mapper = self.scene(with_wind(sheet(), sheared))
        x, y = np.meshgrid(np.arange(-7, 7, 0.25), np.arange(-2, 2, 0.25))
        for middle in (-5, 0, 5):
            points = np.column_stack([x.ravel(), y.ravel() + middle, 0 * x.ravel()])
            self.check_streaks(f"shear, {1 + 0.05 * middle}", mapper, points, sheared, flat)

    def test_streaks_on_a_globe(self):
        degrees = np.linspace(-63, 63, 37)
        mapper = self.scene(with_wind(cap(degrees, degrees), turning), GLOBE)
        fine = np.arange(-35, 35, 0.7)
        points = on_globe(fine, fine)
        self.check_streaks("globe", mapper, points, turning, seen, pixels=1.2)

    def test_segments(self):
        x, y = np.meshgrid(np.arange(-6, 7, 4.0), np.arange(-6, 7, 4.0))
        places = np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()])
        self.check_segments("uniform", uniform((-0.6, 0.8, 0)), places, flat)
        self.check_segments("shear", sheared, places, flat)
        degrees = (-30.0, -10.0, 10.0, 30.0)
        globe = on_globe(degrees, degrees)
        self.check_segments("globe", turning, globe, seen, GLOBE, VectorUnit=0.05)

    def test_blocks_move_at_their_mean_speed(self):
        data = with_wind(sheet(), lambda p: np.column_stack([2 + (-1) ** (p[:, 0] + p[:, 1]), 0 * p[:, 0], 0 * p[:, 0]]))
        mapper = self.scene(data, ErrorTolerance=1.0, ErrorToleranceUnit=1, LevelBlending=0.0)
        points = np.insert(np.stack(np.meshgrid(*(np.arange(-7, 7, 0.25),) * 2), -1).reshape(-1, 2), 2, 0, axis=1)
        self.check_streaks("blocks", mapper, points, uniform((2, 0, 0)), flat)
        self.assertLess(mapper.GetNumberOfDrawnSplats(), mapper.GetNumberOfSamples() / 2)

    def test_patterns_go_on_when_vectors_change(self):
        data = meshes.particles(np.zeros((1, 3)))
        mapper = self.scene(with_wind(data, uniform((1, 0, 0))), VectorUnit=1.0, CellSize=2.0)
        first = self.picture(mapper, 0)
        self.picture(mapper, 0.7)
        data = meshes.particles(np.zeros((1, 3)))
        mapper.SetInputData(with_wind(data, uniform((2.5, 0, 0))))
        moved = self.picture(mapper, 0.9)
        other = self.scene(data, VectorUnit=1.0, CellSize=2.0, TrueSpeed=False)
        self.picture(other, 0)
        other.AdvancePhases(TIME_SCALE * (0.7 + 2.5 * 0.2) / 2.5)
        self.window.render()
        self.assertGreater(np.abs(moved - first).max(), 0.1)
        np.testing.assert_allclose(moved, -np.log1p(-float_image(other)[..., 3]), atol=1e-4)

    def test_time_scale_that_is_found(self):
        """The fastest streaks, of period 4, move by at most one in a second, and by more than a third."""
        for speed, expected in ((2, 2), (1e-3, 3600), (0.3, 10), (1e-6, 20 * 86400)):
            mapper = self.scene(with_wind(sheet(4), uniform((speed, 0, 0))), TimeScale=0.0)
            self.assertEqual(mapper.GetDrawnTimeScale(), 0)
            self.picture(mapper, 0.5)
            self.assertAlmostEqual(mapper.GetDrawnTimeScale() / expected, 1, places=6)

    def test_film_time_must_be_finite(self):
        mapper = self.scene(with_wind(sheet(4), uniform((1, 0, 0))))
        mapper.SetFilmTime(1.5)
        with self.window.messages:
            mapper.SetFilmTime(float("nan"))
        self.assertIn("must be finite", self.window.messages.errors[0])
        self.assertEqual(mapper.GetFilmTime(), 1.5)


if __name__ == "__main__":
    unittest.main()
