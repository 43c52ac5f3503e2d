# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter against closed forms: waves, noise, the 27 weights, ends, iterations, and numpy's own convolution."""
import unittest

import cloud_grids as cg
import numpy as np

# Factor on a wave of so many points along one axis: cos^2(pi/N).
FACTORS = {2: 0.0, 3: 0.25, 4: 0.5, 8: 0.8535533905932737, 16: 0.9619397662556434, 32: 0.9903926402016152}
NOISE = 0.2296396  # (3/8)^1.5


def wave(points, axis, size=32):
    shape = [3, 3, 3]
    shape[2 - axis] = max(size, points)
    along = np.cos(2 * np.pi * np.arange(shape[2 - axis]) / points)
    return np.broadcast_to(along.reshape([-1 if d == 2 - axis else 1 for d in range(3)]), shape).copy()


class Waves(unittest.TestCase):
    def test_factor_per_axis(self):
        for axis in range(3):
            for points, factor in FACTORS.items():
                field = wave(points, axis, 96)
                out = cg.cube(cg.smooth(cg.image(field), Periodic=axis))
                self.assertLess(np.abs(out - factor * field).max(), 1e-9, (axis, points))

    def test_iterations_multiply(self):
        field = wave(8, 0)
        out = cg.cube(cg.smooth(cg.image(field), 5, Periodic=0))
        np.testing.assert_allclose(out, FACTORS[8] ** 5 * field, atol=1e-14)

    def test_axes_multiply(self):
        i, j, k = np.arange(16), np.arange(8), np.arange(4)
        field = np.cos(2 * np.pi * k / 4)[:, None, None] * np.cos(2 * np.pi * j / 8)[:, None] * np.cos(2 * np.pi * i / 16)
        out = cg.cube(cg.smooth(cg.image(field), Periodic=[0, 1, 2]))
        np.testing.assert_allclose(out, FACTORS[4] * FACTORS[8] * FACTORS[16] * field, atol=1e-14)


class Weights(unittest.TestCase):
    def test_27(self):
        field = np.zeros((5, 5, 5))
        field[2, 2, 2] = 64
        out = cg.cube(cg.smooth(cg.image(field)))
        steps = np.abs(np.indices((5, 5, 5)) - 2)
        expected = np.where(steps.max(0) <= 1, 8 / 2.0 ** steps.sum(0), 0)
        np.testing.assert_array_equal(out, expected)

    def test_against_a_convolution(self):
        field = np.random.default_rng(2).normal(size=(9, 10, 11))
        out = cg.cube(cg.smooth(cg.image(field)))
        padded = np.pad(field, 1, mode="edge")  # weights 3, 1 at the ends
        expected = np.zeros_like(field)
        for a in (-1, 0, 1):
            for b in (-1, 0, 1):
                for c in (-1, 0, 1):
                    weight = 8 / 2.0 ** (abs(a) + abs(b) + abs(c)) / 64
                    expected += weight * padded[1 + a:10 + a, 1 + b:11 + b, 1 + c:12 + c]
        np.testing.assert_allclose(out, expected, atol=1e-15)

    def test_white_noise(self):
        rng = np.random.default_rng(4)
        field = rng.normal(size=(64, 64, 64))
        out = cg.cube(cg.smooth(cg.image(field), Periodic=[0, 1, 2]))
        self.assertAlmostEqual(out.std() / field.std(), NOISE, delta=0.002)  # 262144 samples

    def test_constants_and_the_range(self):
        rng = np.random.default_rng(6)
        out = cg.cube(cg.smooth(cg.image(np.full((6, 7, 8), 0.1)), 9))
        self.assertTrue((out == 0.1).all())
        field = rng.integers(0, 2, (6, 7, 8)).astype("f4")
        out = cg.cube(cg.smooth(cg.image(field), 3))
        self.assertTrue((out >= 0).all() and (out <= 1).all())


class Equivalences(unittest.TestCase):
    def test_grids_of_all_kinds_agree(self):
        rng = np.random.default_rng(3)
        field = rng.normal(size=(5, 6, 7))
        z, y, x = np.meshgrid(np.arange(5.0), np.arange(6.0), np.arange(7.0), indexing="ij")
        expected = cg.cube(cg.smooth(cg.image(field), 2))
        np.testing.assert_array_equal(cg.cube(cg.smooth(cg.rectilinear(np.arange(7), np.arange(6), np.arange(5), {"f": field}), 2)),
                                      expected)
        made = cg.structured(np.stack([x, y, z], -1), {"f": field})
        np.testing.assert_array_equal(cg.cube(cg.smooth(made, 2)), expected)

    def test_mirrored_and_permuted_axes(self):
        field = np.random.default_rng(5).normal(size=(5, 6, 7))
        expected = cg.cube(cg.smooth(cg.image(field), 2))
        np.testing.assert_allclose(cg.cube(cg.smooth(cg.image(field[::-1, :, ::-1]), 2)), expected[::-1, :, ::-1], atol=1e-15)
        np.testing.assert_allclose(cg.cube(cg.smooth(cg.image(field.transpose(2, 0, 1)), 2)), expected.transpose(2, 0, 1), atol=1e-15)

    def test_a_rolled_ring(self):
        field = np.random.default_rng(5).normal(size=(4, 6, 12))
        expected = cg.cube(cg.smooth(cg.image(field), 2, Periodic=0))
        np.testing.assert_array_equal(cg.cube(cg.smooth(cg.image(np.roll(field, 5, 2)), 2, Periodic=0)), np.roll(expected, 5, 2))

    def test_flat_grids(self):
        field = np.random.default_rng(7).normal(size=(1, 6, 9))
        thick = np.repeat(field, 5, axis=0)
        np.testing.assert_allclose(cg.cube(cg.smooth(cg.image(field)))[0], cg.cube(cg.smooth(cg.image(thick)))[2], atol=1e-15)
        one = cg.image(np.full((1, 1, 1), 3.0))
        self.assertEqual(cg.cube(cg.smooth(one, 4)).item(), 3.0)


class Arrays(unittest.TestCase):
    def fields(self):
        rng = np.random.default_rng(9)
        return {"f": rng.normal(size=(4, 5, 6)).astype("f4"), "d": rng.normal(size=(4, 5, 6)), "v": rng.normal(size=(4, 5, 6, 3)),
                "n": rng.integers(0, 9, (4, 5, 6))}

    def test_choice(self):
        fields = self.fields()
        data = cg.rectilinear(range(6), range(5), range(4), fields)
        changed = lambda out: {n for n in fields if not np.array_equal(cg.values(out, n), cg.values(data, n))}
        self.assertEqual(changed(cg.smooth(data)), {"f"})
        self.assertEqual(changed(cg.smooth(data, AllFloatArrays=True)), {"f", "d", "v"})
        self.assertEqual(changed(cg.smooth(data, setup=lambda m: [m.AddArrayName(n) for n in ("d", "n", "d")])), {"d", "n"})
        self.assertEqual(changed(cg.smooth(data, setup=lambda m: m.SetInputArrayToProcess(0, 0, 0, 0, "v"))), {"v"})
        self.assertEqual(changed(cg.smooth(data, 0, AllFloatArrays=True)), set())

    def test_types_components_and_parts(self):
        fields = self.fields()
        data = cg.rectilinear(range(6), range(5), range(4), fields)
        data.GetPointData().SetActiveVectors("v")
        out = cg.smooth(data, setup=lambda m: [m.AddArrayName(n) for n in fields])
        types = [out.GetPointData().GetArray(n).GetDataTypeAsString() for n in fields]
        self.assertEqual(types, ["float", "double", "double", "double"])
        self.assertEqual(out.GetPointData().GetScalars().GetName(), "f")
        self.assertEqual(out.GetPointData().GetVectors().GetName(), "v")
        self.assertEqual([out.GetPointData().GetArrayName(i) for i in range(4)], list(fields))
        for c in range(3):
            alone = cg.cube(cg.smooth(cg.image(fields["v"][..., c])))
            np.testing.assert_array_equal(cg.cube(out, "v")[..., c], alone)
        np.testing.assert_array_equal(cg.values(data, "f"), fields["f"].ravel())  # the input stays


if __name__ == "__main__":
    unittest.main()
