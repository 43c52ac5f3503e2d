# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is written to a .vdb file is what is read from it."""
import os
import unittest

import numpy as np
import vdb_files as vf
from vdb_files import VdbTestCase

DIMENSIONS = (13, 9, 11)
COUNT = int(np.prod(DIMENSIONS))
ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


def sparse_values(seed, shape=COUNT, kind="f4"):
    random = np.random.default_rng(seed)
    values = random.normal(size=shape).astype(kind)
    values[random.random(COUNT) < 0.7] = 0
    return values


@unittest.skipUnless(vf.HAS_OPENVDB, "this build has no OpenVDB")
class RoundTrip(VdbTestCase):
    lattice = dict(dimensions=DIMENSIONS, first=(-7, 3, -4), origin=(1, -2, 30), spacing=(0.5, 0.25, 2), direction=ROTATION)

    def scene(self, **arrays):
        return vf.image(arrays, **self.lattice)

    def check_points(self, data, points, name):
        """The points are those of the image with a value, each with that value."""
        values = vf.values_of(data, name)
        kept = values != 0 if values.ndim == 1 else (values != 0).any(axis=1)
        order = lambda places: np.lexsort(np.round(places, 6).T)
        places, expected = vf.places_of(points), vf.places_of(data)[kept]
        self.assertEqual(len(places), kept.sum())
        np.testing.assert_allclose(places[order(places)], expected[order(expected)], atol=2e-6)
        np.testing.assert_array_equal(vf.values_of(points, name)[order(places)], values[kept][order(expected)])

    def test_points_are_the_voxels_with_values(self):
        for kind in ("f4", "f8", "i4", "i8"):
            data = self.scene(s=(10 * sparse_values(1)).astype(kind))
            self.write(data)
            points = self.read()
            self.assertEqual(vf.values_of(points, "s").dtype, np.dtype(kind))
            self.check_points(data, points, "s")

    def test_vectors(self):
        for kind in ("f4", "f8"):
            data = self.scene(vel=sparse_values(2, (COUNT, 3), kind))
            self.write(data)
            self.check_points(data, self.read(), "vel")

    def test_image_is_the_same_where_there_are_values(self):
        data = self.scene(density=sparse_values(3, kind="f8"), vel=sparse_values(4, (COUNT, 3)))
        self.write(data)
        again = self.read(as_image=True)
        np.testing.assert_allclose(again.GetSpacing(), (0.5, 0.25, 2))
        for name in ("density", "vel"):
            lookup = {tuple(np.round(p, 5)): v for p, v in zip(vf.places_of(again), vf.values_of(again, name))}
            for place, value in zip(vf.places_of(data), vf.values_of(data, name)):
                found = lookup.get(tuple(np.round(place, 5)), np.zeros_like(value))
                np.testing.assert_array_equal(found, value)

    def test_voxels_that_were_read_are_written_again(self):
        self.write(self.scene(s=sparse_values(5)))
        first = self.read()
        self.write(first)
        second = self.read()
        np.testing.assert_array_equal(vf.places_of(first), vf.places_of(second))
        np.testing.assert_array_equal(vf.values_of(first, "s"), vf.values_of(second, "s"))

    def test_half(self):
        data = self.scene(s=sparse_values(6))
        self.write(data, lambda w: w.SetPrecisionToHalf())
        values, again = vf.values_of(data, "s"), vf.values_of(self.read(), "s")
        kept = np.sort(values[values != 0])
        np.testing.assert_allclose(np.sort(again), kept, rtol=1e-3, atol=1e-7)
        self.assertFalse(np.array_equal(np.sort(again), kept), "half must round")
        self.assertIn("saved as half", self.reader.GetGridDescription(0))

    def test_single(self):
        self.write(self.scene(s=sparse_values(7, kind="f8")), lambda w: w.SetPrecisionToSingle())
        self.assertEqual(vf.values_of(self.read(), "s").dtype, np.float32)

    def test_compressions_keep_values_and_differ_in_size(self):
        alternating = (1 + np.arange(40 ** 3) % 2).astype("i4")  # OpenVDB zips no fog volumes
        sizes, outputs = [], []
        for name in ("None", "Zip", "Blosc"):
            self.write(vf.image({"s": alternating}, (40, 40, 40)), lambda w: getattr(w, "SetCompressionTo" + name)())
            sizes.append(os.path.getsize(self.path))
            outputs.append(vf.values_of(self.read(), "s"))
        np.testing.assert_array_equal(outputs[0], outputs[1])
        np.testing.assert_array_equal(outputs[0], outputs[2])
        self.assertLess(max(sizes[1:]), sizes[0] / 2)

    def test_cell_values_are_at_the_centres(self):
        data = vf.image({}, (3, 4, 5), spacing=(1, 2, 3), cells={"c": np.arange(1, 25, dtype="f4")})
        self.write(data)
        points = self.read()
        self.assertEqual(points.GetNumberOfPoints(), 24)
        np.testing.assert_allclose(vf.places_of(points).min(axis=0), (0.5, 1, 1.5))
        np.testing.assert_allclose(vf.places_of(points).max(axis=0), (1.5, 5, 10.5))
        i, j, k = (vf.places_of(points) / (1, 2, 3) - 0.5).round().astype(int).T
        np.testing.assert_array_equal(vf.values_of(points, "c"), 1 + i + 2 * j + 6 * k)

    def test_tolerance(self):
        data = self.scene(s=sparse_values(8))
        self.write(data, lambda w: w.SetTolerance(0.5))
        values = vf.values_of(data, "s")
        np.testing.assert_array_equal(np.sort(vf.values_of(self.read(), "s")), np.sort(values[np.abs(values) > 0.5]))

    def test_tiles(self):
        values = np.zeros((24, 24, 24), "f4")
        values[8:16, 8:16, 8:24] = 3  # two leaves of one value
        values[0, 0, 0] = 1
        self.write(vf.image({"s": values.ravel()}, (24, 24, 24), spacing=(0.5, 0.5, 0.5)))
        self.assertEqual(self.read().GetNumberOfPoints(), 2 * 512 + 1)
        tiles = self.read(lambda r: r.SplitTilesOff())
        self.assertEqual(tiles.GetNumberOfPoints(), 3)
        np.testing.assert_array_equal(np.sort(vf.values_of(tiles, "VoxelScale")), (1, 8, 8))
        centres = vf.places_of(tiles)[vf.values_of(tiles, "VoxelScale") == 8]
        np.testing.assert_allclose(centres[np.argsort(centres[:, 0])], ((5.75, 5.75, 5.75), (9.75, 5.75, 5.75)))
        self.write(tiles)
        self.assertEqual(self.read().GetNumberOfPoints(), 2 * 512 + 1)

    def test_grids_and_names(self):
        data = self.scene(cloud=sparse_values(9), wind=sparse_values(10, (COUNT, 3)), other=sparse_values(11))

        def setup(writer):
            writer.AddArrayName("cloud")
            writer.AddArrayName("wind")
            writer.SetGridName("cloud", "density")
            writer.SetGridName("wind", "velocity")

        self.write(data, setup)
        both = self.read()
        self.assertEqual(both.GetPointData().GetScalars().GetName(), "density")
        self.assertEqual([self.reader.GetGridName(i) for i in range(self.reader.GetNumberOfGrids())], ["density", "velocity"])
        self.assertEqual([self.reader.GetGridType(i) for i in range(2)], ["float", "vec3s"])
        self.assertEqual(self.reader.GetGridClass(0), "fog volume")
        self.assertEqual(self.reader.GetGridRefusal(0), "")
        self.assertEqual(self.reader.GetGridNumberOfActiveVoxels(0), (vf.values_of(data, "cloud") != 0).sum())
        extent, spacing = [0] * 6, [0.0] * 3
        self.reader.GetGridExtent(0, extent)
        self.reader.GetGridSpacing(0, spacing)
        np.testing.assert_allclose(spacing, (0.5, 0.25, 2))
        self.assertLessEqual(-7, extent[0])
        active = (vf.values_of(data, "cloud") != 0) | (vf.values_of(data, "wind") != 0).any(axis=1)
        self.assertEqual(both.GetNumberOfPoints(), active.sum())

        def one(reader):
            reader.UpdateInformation()
            reader.GetGridSelection().DisableArray("velocity")

        self.assertEqual(self.read(one).GetPointData().GetNumberOfArrays(), 1)


@unittest.skipUnless(vf.HAS_OPENVDB, "this build has no OpenVDB")
class Particles(VdbTestCase):
    def test_mass_momentum_and_centre_are_kept(self):
        random = np.random.default_rng(12)
        places, masses = random.normal(size=(500, 3)), random.random(500)
        velocities = random.normal(size=(500, 3))
        self.write(vf.particles(places, {"m": masses, "v": velocities}),
                   lambda w: (w.SetMassArrayName("m"), w.SetVoxelSize(0.1), w.SetPrecisionToInput()))
        points = self.read()
        mass = vf.values_of(points, "density").astype(float) * 0.1 ** 3
        self.assertAlmostEqual(mass.sum(), masses.sum(), delta=1e-5 * masses.sum())
        np.testing.assert_allclose(mass @ vf.places_of(points), masses @ places, atol=1e-4)
        np.testing.assert_allclose(mass @ vf.values_of(points, "v"), masses @ velocities, atol=1e-4)

    def test_one_particle(self):
        self.write(vf.particles([[0.25, 0, 0]]), lambda w: w.SetVoxelSize(1))
        points = self.read()
        np.testing.assert_allclose(vf.places_of(points), ((0, 0, 0), (1, 0, 0)))
        np.testing.assert_allclose(vf.values_of(points, "density"), (0.75, 0.25))


if __name__ == "__main__":
    unittest.main()
