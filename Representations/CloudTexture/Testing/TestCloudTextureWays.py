# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ways of the paper: colour from the texture, thickness before the threshold, thresholds, waves that are set, altitude as third coordinate."""
import math
import unittest

import nephoscope
import numpy as np
from cloud_bodies import BodyTestCase, box, opacity, sphere
from cloud_sheets import TextureTestCase, coordinates_of_pixels, sheet
from nephoscope_testing import meshes
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import vtk_to_numpy

CORNERS = ((0.2, 0.3, 0.4), (0.5, 0.6, 0.55))
ONE_SET = [((0, 0, 0), 1.0)]
PIXELS = 128
erf = np.vectorize(math.erf)


def normal_share(x):
    return (1 + erf(x / math.sqrt(2))) / 2


def normal_density(x):
    return np.exp(-0.5 * x * x) / math.sqrt(2 * math.pi)


def texture(waves, p):
    """Waves as rows of 9 numbers, of any scale: the sum over its standard deviation."""
    total, square = 0, 0
    for a, b, c, d, s, e, g, h, phase in waves:
        theta = 2 * np.pi * (p @ (b, c, d) + phase)
        total = total + a * np.cos(theta + s * np.sin(2 * np.pi * (p @ (e, g, h))))
        square += a * a / 2
    return total / math.sqrt(square)


def used(mapper):
    values, waves = [0.0] * 9, []
    for i in range(mapper.GetNumberOfWavesUsed()):
        mapper.GetWaveUsed(i, values)
        waves.append(tuple(values))
    return waves


def one_wave(mapper, *frequencies, phase=0.0):
    """sqrt(2) cos(x): its share above t is arccos(t / sqrt(2)) / pi."""
    mapper.SetWavesToCustom()
    mapper.SetNumberOfCustomWaves(1)
    mapper.SetCustomWave(0, 3.0, *frequencies, 0, 0, 0, 0, phase)


def share_of_one_wave(threshold):
    return np.arccos(np.clip(np.asarray(threshold) / math.sqrt(2), -1, 1)) / np.pi


class Thresholds(TextureTestCase):
    def test_of_one_wave(self):
        """The cover that a threshold has, the threshold that a cover has, and what is drawn: by the closed form."""
        window, mapper, _ = self.scene(sheet(((0, 0, 0), (1, 1, 1)), ONE_SET), (500, 16))
        one_wave(mapper, 5, 0, 0)  # 5 waves: 500 pixels are whole ones, and the picture is periodic
        wave = [-1.0] * 9
        mapper.GetCustomWave(0, wave)
        self.assertEqual(wave, [3, 5, 0, 0, 0, 0, 0, 0, 0])
        mapper.SetSoftness(0)
        for threshold in (-1.3, -0.6, 0, 0.4, 1.1):
            mapper.UseThresholdOn()
            mapper.SetThreshold(threshold)
            expected = float(share_of_one_wave(threshold))
            self.assertAlmostEqual(mapper.GetCoverageUsed(), expected, delta=0.01)
            self.assertEqual(mapper.GetThresholdUsed(), threshold)
            mapper.UseThresholdOff()
            mapper.SetCoverage(expected)
            self.assertAlmostEqual(mapper.GetThresholdUsed(), threshold, delta=0.03)
            self.assertEqual(mapper.GetCoverageUsed(), expected)

    def test_drawn(self):
        """A sheet with many waves has the share of the texture that lies above; edges have their softness."""
        corners = ((0, 0, 0), (6, 7, 5))
        p = np.random.default_rng(2).uniform(0, 50, (300000, 3))
        for preset in range(4):
            window, mapper, _ = self.scene(sheet(corners, ONE_SET), (512, 512))
            mapper.SetWaves(preset)
            mapper.UseThresholdOn()
            mapper.SetCoverage(0.01)  # not used
            for threshold, softness in ((-0.7, 0.0), (0.5, 0.4), (1.2, 0.15)):
                mapper.SetThreshold(threshold)
                mapper.SetSoftness(softness)
                drawn = self.draw(window).mean()
                values = texture(used(mapper), p)
                expected = normal_share((values - threshold) / max(softness, 1e-9)).mean()
                self.assertAlmostEqual(mapper.GetCoverageUsed(), expected, delta=0.006, msg=f"preset {preset}, {threshold}")
                self.assertAlmostEqual(drawn, expected, delta=0.02, msg=f"preset {preset}, {threshold}")


class Waves(TextureTestCase):
    def close_up(self, configure, waves=None):
        window, mapper, _ = self.scene(sheet(CORNERS, ONE_SET), (PIXELS, PIXELS))
        mapper.UseThresholdOn()
        mapper.SetThreshold(0.2)
        mapper.SetSoftness(0.8)
        configure(mapper)
        drawn = self.draw(window)
        values = texture(used(mapper) if waves is None else waves, coordinates_of_pixels(CORNERS, PIXELS))
        difference = np.abs(drawn - normal_share((values - 0.2) / 0.8))
        self.assertGreater(np.ptp(drawn), 0.3)
        return difference, mapper

    def test_presets(self):
        for preset, count in enumerate((12, 7, 7, 10)):
            difference, mapper = self.close_up(lambda m, preset=preset: m.SetWaves(preset))
            print(f"  preset {preset}: mean difference {difference.mean():.4f}")
            self.assertEqual(mapper.GetNumberOfWavesUsed(), count)
            self.assertLess(difference.mean(), 0.012)  # the pixel's filter takes some of the smallest waves

    def test_custom(self):
        """In proportion: amplitudes of the sum are those of standard deviation 1."""
        waves = [(2, 3, 1, 2, 1.5, 1, -2, 0.5, 0.1), (1.4, -4, 5, 0.5, 0, 0, 0, 0, 0.6), (-0.5, 2, 7, 3, 3, 2, 1, 1, 0)]

        def configure(mapper):
            for i, wave in enumerate(waves):
                mapper.SetCustomWave(i, *wave)
            mapper.SetNumberOfCustomWaves(3)
            mapper.SetWavesToCustom()
        self.assertLess(self.close_up(configure, waves)[0].max(), 0.02)

    def test_default_is_custom_at_first(self):
        """Who changes one wave starts from those of Clouds."""
        mapper = nephoscope.vtkCloudTextureMapper()
        clouds = (mapper.GetCoverageUsed(), used(mapper))[1]
        mapper.SetWavesToCustom()
        mapper.GetCoverageUsed()
        self.assertEqual(used(mapper), clouds)

    def test_unusable(self):
        for wave, text in (((1, 0, 0, 0, 0, 0, 0, 0, 0), "wave 0 has no frequency"), ((0, 1, 0, 0, 0, 0, 0, 0, 0), "amplitude that is not 0"),
                           ((math.nan, 1, 0, 0, 0, 0, 0, 0, 0), "not finite")):
            window, mapper, _ = self.scene(sheet(CORNERS, ONE_SET), (32, 32))
            mapper.SetNumberOfCustomWaves(1)
            mapper.SetCustomWave(0, *wave)
            mapper.SetWavesToCustom()
            window.render()
            window.render()
            self.assertEqual(len(window.messages.all), 1)
            self.assertIn(text, window.messages.all[0])
            self.assertGreater(window.rgba().max(), 0.5)

    def test_no_such_wave(self):
        with Messages() as messages:
            nephoscope.vtkCloudTextureMapper().SetCustomWave(16, 1, 1, 0, 0, 0, 0, 0, 0, 0)
        self.assertIn("16 at most", messages.all[0])


class Colours(TextureTestCase):
    def test_mix(self):
        """Over black: the red of what is thin, the blue of what is thick, each with its share; a multiple of the surface's own colour."""
        for weights, width, range_ in (((1, 0), 0.3, 1.5), ((0.7, 0.3), 0.5, 0.8)):
            data = sheet(CORNERS, 2 * ONE_SET, weights=weights)
            window, mapper, scene = self.scene(data, (PIXELS, PIXELS), color=(0.8, 1, 0.6))
            mapper.UseThresholdOn()
            mapper.SetThreshold(0.1)
            mapper.SetSoftness(width)
            mapper.SetThinColor(1, 0.2, 0)
            mapper.SetThickColor(0, 0.2, 1)
            mapper.SetColorRange(range_)
            self.draw(window)
            red, green, blue = np.moveaxis(window.rgba()[..., :3], -1, 0)
            p = coordinates_of_pixels(CORNERS, PIXELS)
            q = np.stack([p[..., 0] + 0.37, 0.61 - p[..., 1], p[..., 2] + 0.29], -1)
            waves = used(mapper)
            excess = (weights[0] * texture(waves, p) + weights[1] * texture(waves, q)) / math.hypot(*weights) - 0.1
            low, high = excess / width, (excess - range_) / width
            share = normal_share(low)
            thick = (excess * (share - normal_share(high)) + width * (normal_density(low) - normal_density(high))) / range_ + normal_share(high)
            for drawn, expected in ((red, 0.8 * (share - thick)), (green, 0.2 * share), (blue, 0.6 * thick)):
                self.assertLess(np.abs(drawn - expected).mean(), 0.01)
            self.assertGreater(blue.max(), 0.5)
            self.assertGreater(red.max(), 0.15)

    def test_all_is_thick_where_cover_is_whole(self):
        window, mapper, _ = self.scene(sheet(CORNERS, ONE_SET), (16, 16))
        mapper.SetCoverage(1)
        mapper.SetThinColor(1, 0, 0)
        mapper.SetThickColor(0, 0.5, 1)
        self.draw(window)
        np.testing.assert_allclose(window.rgba()[..., :3], np.broadcast_to((0, 0.5, 1), (16, 16, 3)), atol=1.5 / 255)


class AddedThickness(BodyTestCase):
    def slab(self, thickness, weight, parallel=True):
        window, scene, mapper, _ = self.bodies(box((-1, -1, -thickness), (1, 1, 0)), size=(400, 40), extinction=0.5, parallel_scale=1 / 10,
                                               position=(0, 0, 5))
        mapper.SetThicknessEffectToAddToTexture()
        mapper.SetThicknessWeight(weight)
        mapper.SetTextureLength(1)
        mapper.SetTextureScale(1)
        mapper.SetSoftness(0)
        one_wave(mapper, 4, 0, 0)  # the view is 2 wide: 8 waves
        mapper.UseThresholdOn()
        mapper.SetThreshold(1.2)
        return window, mapper

    def test_share_against_thickness(self):
        """P(sqrt(2) cos > threshold - weight * optical depth), in closed form; all of it opaque."""
        for thickness in (0.1, 1, 2, 4, 8):
            for weight in (0, 0.3, 1):
                window, mapper = self.slab(thickness, weight)
                expected = share_of_one_wave(1.2 - weight * 0.5 * thickness)
                drawn = self.draw(window)
                self.assertAlmostEqual(drawn.mean(), float(expected), delta=0.012, msg=f"{thickness} {weight}")
                if expected == 1:
                    np.testing.assert_array_equal(drawn, 1)

    def test_opacity_is_that_of_a_layer(self):
        window, mapper = self.slab(8, 1)
        mapper.SetOpticalDepth(0.4)
        self.assertAlmostEqual(self.draw(window)[20, 200], opacity(0.4), delta=1.5 / 255)

    def test_the_other_way_stays(self):
        """Multiplied: the share is that of the threshold at every thickness."""
        for thickness in (0.5, 4):
            window, mapper = self.slab(thickness, 1)
            mapper.SetThicknessEffectToMultiplyOpacity()
            expected = float(share_of_one_wave(1.2)) * opacity(0.5 * thickness)
            self.assertAlmostEqual(self.draw(window).mean(), expected, delta=0.012)

    def test_rim_of_a_ball_breaks_up(self):
        """In rings about the middle, by the distribution of the texture: near the rim there is the cover asked for, in the middle all is cloud."""
        window, scene, mapper, _ = self.bodies(sphere(1.0), size=(400, 400), extinction=1.5, parallel_scale=1.0, position=(0, 0, 5))
        mapper.SetCoverage(0.1)
        mapper.SetWavesToClouds()
        mapper.SetTextureScale(40)
        mapper.SetThicknessEffectToAddToTexture()
        drawn = self.draw(window)
        x, y = np.meshgrid(*2 * [(np.arange(400) + 0.5) / 200 - 1])
        radius = np.hypot(x, y)
        p = np.random.default_rng(2).uniform(0, 50, (100000, 3))
        values = texture(used(mapper), p)
        for inner, outer in ((0, 0.4), (0.7, 0.75), (0.85, 0.9), (0.93, 0.95)):
            ring = (radius >= inner) & (radius < outer)
            depth = 1.5 * 2 * np.sqrt(1 - radius[ring] ** 2)
            excess = values[:, None] + np.quantile(depth, np.linspace(0.05, 0.95, 10)) - mapper.GetThresholdUsed()
            expected = normal_share(excess[::50] / 0.15).mean()
            print(f"  radius {inner} to {outer}: {drawn[ring].mean():.3f}, expected {expected:.3f}")
            self.assertAlmostEqual(drawn[ring].mean(), expected, delta=0.06)  # a ring is a small sample


class Altitude(TextureTestCase):
    def wall(self, low, high, **options):
        """Upright, with waves along the altitude only: rows of the picture, from below."""
        points = np.array([(x, 0, z) for z in np.linspace(low, high, 9) for x in (0, 100 * (high - low))], float)
        cells = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(8)]
        window, mapper, scene = self.scene(meshes.surface(points, cells), (32, 240))
        mapper.SetTextureScale(7)
        one_wave(mapper, 0, 0, 3, phase=-0.25)
        mapper.UseAltitudeOn()
        mapper.SetSoftness(0.5)
        mapper.SetThreshold(0)
        mapper.UseThresholdOn()
        middle = (low + high) / 2
        scene.look((50 * (high - low), -1000 * (high - low), middle), (50 * (high - low), 0, middle), up=(0, 0, 1), near=1e-9 + 100 * (high - low),
                   far=2000 * (high - low), parallel_scale=(high - low) / 2)
        for name, value in options.items():
            getattr(mapper, "Set" + name)(value)
        return self.draw(window)[:, 16]

    def expected(self, altitude):
        return normal_share(math.sqrt(2) * np.sin(6 * np.pi * altitude) / 0.5)

    def test_from_0_to_1_in_any_unit(self):
        altitude = (np.arange(240) + 0.5) / 240
        for low, high in ((0, 1), (5e3, 1.2e4), (-3e-4, 1e-3), (1e6, 3e6)):
            np.testing.assert_allclose(self.wall(low, high), self.expected(altitude), atol=0.02)

    def test_range_that_is_given(self):
        altitude = 5e3 + 7e3 * (np.arange(240) + 0.5) / 240
        drawn = self.wall(5e3, 1.2e4, AltitudeRange=(0, 2e4))
        np.testing.assert_allclose(drawn, self.expected(altitude / 2e4), atol=0.02)

    def test_of_coordinates(self):
        """The third component of the arrays, whatever its unit, also with longitudes."""
        pictures = []
        for factor, on in ((1, False), (4000, True)):
            data = sheet(((0, 0, 0), (1, 1, 1)), ONE_SET, frame=0)
            p = vtk_to_numpy(data.GetPointData().GetArray("TextureCoordinates1"))
            p[:, 2] = factor * p[:, 2] + (700 if on else 0)
            window, mapper, _ = self.scene(data, (PIXELS, PIXELS))
            mapper.SetWavesToClouds()
            mapper.SetSoftness(0.5)
            mapper.SetUseAltitude(on)
            pictures.append(self.draw(window))
        np.testing.assert_allclose(pictures[0], pictures[1], atol=0.02)

    def test_longitudes_of_a_globe(self):
        """Seen from the pole: stripes along meridians, twice as many with twice the scale, without a seam."""
        for scale in (1, 2):
            window, mapper, scene = self.scene(sphere(2.0, 96), (201, 201))
            one_wave(mapper, 3, 0, 0)
            mapper.SetTextureScale(scale)
            mapper.SetSoftness(0.5)
            mapper.UseAltitudeOn()
            mapper.UseThresholdOn()
            scene.look((0, 0, 10), parallel_scale=2.0)
            drawn = self.draw(window)
            angle = 2 * np.pi * (np.arange(720) + 0.5) / 720
            rows, columns = ((100.5 + 80 * f(angle)).astype(int) for f in (np.sin, np.cos))
            lon = np.arctan2(rows - 100, columns - 100)
            front = normal_share(math.sqrt(2) * np.cos(3 * scale * lon) / 0.5)  # both hemispheres are the same; behind one another
            self.assertLess(np.abs(drawn[rows, columns] - (1 - (1 - front) ** 2)).mean(), 0.06)


if __name__ == "__main__":
    unittest.main()
