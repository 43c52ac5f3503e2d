# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors on splats: segments against their coverage, motion of streaks, order of the input, placement in layers."""
import math
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData

PIXELS = 128
SCALE = 6.0  # half the height of the view
TRANSPARENT = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (1, 0)])
CLOUDY = Transfer([(0, 0.2, 0.4, 1), (1, 1, 1, 1)], [(0, 0.1), (1, 0.6)])


def grid(wind, size=24, layers=0):
    data = meshes.image((size, size, layers), origin=(-size / 2, -size / 2, 0))
    points = meshes.points_of(data)
    meshes.with_field(data, lambda p: 0.5 + 0.5 * np.sin(p[:, 0]) * np.cos(p[:, 1]))
    meshes.add_array(data.GetPointData(), wind(points), "v")
    return data


def start_phase(place):
    """SplatSeed.h: 24 bits of a hash of the place."""
    mask = (1 << 64) - 1

    def mix(x):
        for shift, factor in ((30, 0xbf58476d1ce4e5b9), (27, 0x94d049bb133111eb)):
            x = ((x ^ (x >> shift)) * factor) & mask
        return x ^ (x >> 31)
    total = 0x9e3779b97f4a7c15
    for coordinate in place:
        total = (mix(total ^ int(np.float64(coordinate).view(np.uint64))) + 0x9e3779b97f4a7c15) & mask
    return (mix(total) >> 40) / (1 << 24)


def uniform(vector):
    return lambda points: np.tile(np.asarray(vector, float), (len(points), 1))


class Vectors(ImageTestCase):
    def scene(self, data, configure=None, transfer=TRANSPARENT, direction=(0, 0, 1)):
        self.window = Window((PIXELS, PIXELS))
        scene = self.window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        mapper.SetVectorArrayName("v")
        mapper.UseVectorColorOn()
        mapper.SetVectorUnit(1)
        if configure:
            configure(mapper)
        scene.add_volume(mapper, data, transfer)
        scene.look(40 * np.asarray(direction), (0, 0, 0), (0, 1, 0), parallel_scale=SCALE, near=5, far=90)
        return mapper

    def picture(self, mapper):
        self.window.render()
        self.fail_on_messages(self.window)
        return float_image(mapper)

    def test_range_that_cells_have_from_points(self):
        """VTK hands the known range of the points' vectors on to the means in the cells, which are slower."""
        points = grid(lambda p: np.column_stack([-p[:, 1], p[:, 0], 0 * p[:, 0]]), size=6, layers=6)
        shares = []
        for known in (True, False):
            vectors = points.GetPointData().GetArray("v")
            vectors.Modified()
            if known:
                vectors.GetFiniteRange([0, 0], -1)
            cells = vtkPointDataToCellData()
            cells.SetInputData(points)
            cells.Update()
            cells.GetOutput().GetCellData().SetActiveScalars("s")
            mapper = nephoscope.vtkTexturedSplatMapper()
            mapper.SetInputData(cells.GetOutput())
            mapper.SetScalarModeToUseCellData()
            mapper.SetVectorArrayName("v")
            mapper.SuitVectorsToMedium()
            shares.append((mapper.GetVectorShare(), mapper.GetVectorOpacity()))
        self.assertEqual(*shares)

    def outlying(self, factor):
        """The picture of 576 winds in a disc, of which one is `factor` times as long; the length at which streaks are fully drawn; what is told."""
        data = grid(lambda p: np.column_stack([-p[:, 1], p[:, 0], 0 * p[:, 0]]))
        vectors = vtk_to_numpy(data.GetPointData().GetArray("v"))
        vectors[0] *= factor
        usual = np.percentile(np.linalg.norm(vectors, axis=1), 99)
        mapper = self.scene(data)
        self.window.render()
        self.window.render()
        return float_image(mapper)[..., 3], mapper.GetDrawnMaximumSpeed() / usual, self.window.messages.all

    def test_one_long_vector_does_not_hide_the_others(self):
        usual = self.outlying(1)
        self.assertLess(usual[1], 1.2)
        self.assertEqual(usual[2], [])
        for factor in (10, 1000):
            alpha, full, told = self.outlying(factor)
            self.assertAlmostEqual(full, 1.25, delta=0.02)
            self.assertGreater(alpha.mean(), (usual[1] / 1.25)**2 * 0.95 * usual[0].mean())  # shorter and fainter by as much as that
            self.assertEqual(len(told), 1, told)
            self.assertIn("Array 'v' has vectors of a length of up to", told[0])

    def test_number_of_streaks(self):
        """A sheet has at most 6000, and shows as many of the same winds on a finer grid; a small one shows all."""
        shares = {}
        for size in (60, 150, 300):
            mapper = nephoscope.vtkTexturedSplatMapper()
            data = grid(uniform((1, 0, 0)), size)
            data.GetPointData().SetActiveScalars("s")
            mapper.SetInputData(data)
            mapper.SetVectorArrayName("v")
            mapper.SuitVectorsToMedium(False, True)
            self.assertEqual(mapper.GetVectorOpacity(), 2)
            shares[size] = mapper.GetVectorFraction() * (size + 1)**2
        self.assertEqual(shares[60], 61**2)
        self.assertAlmostEqual(shares[150], 6000, delta=1e-6)
        self.assertAlmostEqual(shares[300], 6000, delta=1e-6)

    def velocity(self, frames, window, step):
        """Least squares of the brightness that is constant along the motion; the window, which stands still, is divided out."""
        pixel = 2 * SCALE / PIXELS
        seen = window > 0.2 * window.max()
        normal, right = np.zeros((2, 2)), np.zeros(2)
        for before, after in zip(frames[:-1], frames[1:]):
            f, g = before / np.maximum(window, 1e-9), after / np.maximum(window, 1e-9)
            dy, dx = np.gradient(0.5 * (f + g), pixel)
            inside = seen & (np.abs(g - f) < 1.0)  # not where a streak's end is cut off by the next period
            d = np.stack([dx[inside], dy[inside]])
            normal += d @ d.T
            right -= d @ (g - f)[inside] / step
        return np.linalg.solve(normal, right)

    def motion(self, wind, direction, steps=200):
        """Velocity on the screen of the pattern of one splat, over one period of it."""
        data = meshes.particles(np.zeros((1, 3)))
        meshes.add_array(data.GetPointData(), np.zeros(1))
        meshes.add_array(data.GetPointData(), np.array([wind], float), "v")
        mapper = self.scene(data, lambda m: (m.SetStreakWidth(0.3), m.SetVectorOpacity(0.5), m.SetCellSize(1.5)), direction=direction)
        step = 4 / np.linalg.norm(wind) / steps  # the period is 4 units
        frames = [-np.log1p(-self.picture(mapper)[..., 3])]
        for _ in range(steps):
            mapper.AdvancePhases(step)
            frames.append(-np.log1p(-self.picture(mapper)[..., 3]))
        return self.velocity(frames, np.mean(frames, axis=0), step)

    def test_streaks_move_at_the_projected_speed(self):
        for wind, direction in (((1, 0, 0), (0, 0, 1)), ((-0.6, 0.8, 0), (0, 0, 1)), ((0, -2, 0), (0, 0, 1)),
                                ((1, 0.3, 0), (0.6, 0, 0.8)), ((0.5, 0.5, 0.7), (0, 0, 1))):
            found = self.motion(wind, direction)
            ahead = np.array([direction[2], 0, -direction[0]])  # to the right on the screen; y is up
            expected = np.array([np.dot(wind, ahead), wind[1]])
            angle = math.degrees(math.atan2(found[1], found[0]) - math.atan2(expected[1], expected[0]))
            angle = (angle + 180) % 360 - 180
            ratio = np.linalg.norm(found) / np.linalg.norm(expected)
            print(f"  wind {wind} from {direction}: {angle:+.2f} degrees, speed {ratio:.3f}")
            self.assertLess(abs(angle), 2)
            self.assertLess(abs(ratio - 1), 0.05)

    def segment(self, length=2.5, width=1.7):
        """One segment, of the greatest speed, in a cell of a thousandth."""
        data = meshes.particles(np.zeros((1, 3)))
        meshes.add_array(data.GetPointData(), np.zeros(1))
        meshes.add_array(data.GetPointData(), np.array([[3.0, 4.0, 0.0]]), "v")
        return self.scene(data, lambda m: (m.SetVectorStyleToSegments(), m.SetSegmentLength(length), m.SetSegmentWidth(width),
                                           m.SetVectorOpacity(50), m.SetCellSize(1e-3), m.SetPhaseCycles(1)))

    def test_a_segment_is_its_coverage_and_moves_by_its_length(self):
        length, width = 2.5 * PIXELS / (2 * SCALE), 1.7
        x, y = np.meshgrid(*(np.arange(PIXELS) + 0.5 - PIXELS / 2,) * 2)
        along, across = 0.6 * x + 0.8 * y, -0.8 * x + 0.6 * y
        erf, fade = np.vectorize(math.erf), 0.25

        def covered(at, size):
            s = 1 / (0.5 * math.sqrt(2))
            return 0.5 * (erf((at + size / 2) * s) - erf((at - size / 2) * s))
        mapper = self.segment()
        for phase in np.arange(0, 1, 0.09):
            mapper.SetPhase(phase)
            alpha = self.picture(mapper)[..., 3]
            place = (start_phase((0, 0, 0)) + phase) % 1
            weight, at = min(place / fade, 1), (place - (1 + fade) / 2) * length
            one, other = covered(along - at, length), covered(along - at - length, length)
            expected = 1 - (1 - weight * covered(across, width) * one) * (1 - (1 - weight) * covered(across, width) * other)
            self.assertLess(np.abs(alpha - expected).max(), 0.01)  # the place in the cell, of a thousandth, is random
            self.assertAlmostEqual(alpha.sum() / (length * width), 1, delta=4e-3)  # as opaque at every phase

    def test_a_segment_after_a_loop_is_where_it_was(self):
        mapper = self.segment()
        pictures = []
        for phase in (0, 0.3, 1, 1 - 1e-4):
            mapper.SetPhase(phase)
            pictures.append(self.picture(mapper))
        np.testing.assert_array_equal(pictures[0], pictures[2])
        self.assertGreater(np.abs(pictures[1] - pictures[0]).max(), 0.4)
        self.assertLess(np.abs(pictures[3] - pictures[0]).max(), 2e-3)

    def test_segments_move_at_the_speed_of_their_vector(self):
        """AdvancePhases by the time in which the wind, 5, crosses a tenth of the segment is a phase of a tenth."""
        mapper = self.segment()
        self.picture(mapper)  # the vectors are those of the last render
        mapper.AdvancePhases(0.1 * 2.5 / 5)
        moved = self.picture(mapper)
        mapper = self.segment()
        mapper.SetPhase(0.1)
        self.assertLess(np.abs(moved - self.picture(mapper)).max(), 1e-4)

    def test_picture_does_not_depend_on_the_order_of_the_input(self):
        rng = np.random.default_rng(7)
        points = rng.uniform(-4, 4, (150, 3))
        winds, values = rng.normal(size=(150, 3)), rng.uniform(0, 1, 150)
        for style in (0, 1):
            for placement in (0, 1):
                pictures = []
                for order in (np.arange(150), rng.permutation(150)):
                    data = meshes.particles(points[order])
                    meshes.add_array(data.GetPointData(), values[order])
                    meshes.add_array(data.GetPointData(), winds[order], "v")
                    mapper = self.scene(data, lambda m: (m.SetVectorStyle(style), m.SetVectorPlacement(placement)), CLOUDY)
                    pictures.append(self.picture(mapper))
                self.assertGreater(pictures[0][..., 3].max(), 0.3)
                np.testing.assert_array_equal(pictures[0], pictures[1])

    def test_sixteenth_frame_is_the_first(self):
        data = grid(lambda p: np.stack([1 + 0 * p[:, 0], 0.1 * p[:, 0], 0 * p[:, 0]], 1))
        mapper = self.scene(data, lambda m: (m.SetPhaseSteps(16), m.SetPhaseCycles(1)))
        pictures = []
        for frame in range(17):
            mapper.SetPhase(frame / 16)
            pictures.append(self.picture(mapper))
        np.testing.assert_array_equal(pictures[0], pictures[16])
        self.assertGreater(np.abs(pictures[8] - pictures[0]).max(), 0.2)

    def test_layers_have_scalars_behind_vectors(self):
        """In one layer all vectors lie over all media; in the middle half of each medium lies over them."""
        data = grid(uniform((1, 0, 0)))
        light = []
        for placement in (0, 1):
            mapper = self.scene(data, lambda m: (m.SetVectorPlacement(placement), m.SetVectorColor(1, 0, 0)), CLOUDY)
            image = self.picture(mapper)
            light.append(image[..., 0].sum() - image[..., 2].sum())
        self.assertGreater(light[1], light[0])


if __name__ == "__main__":
    unittest.main()
