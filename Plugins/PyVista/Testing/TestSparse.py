# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.read_vdb and write_vdb: round trips, choices, errors."""
import tempfile
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

HAS_OPENVDB = nephoscope.vtkSparseVolumeReader.HasOpenVDB()


def cloud():
    """Nothing but a ball in the middle of an image."""
    image = pyvista.ImageData(dimensions=(16, 12, 10), spacing=(0.5, 1, 2), origin=(1, 2, 3))
    near = np.linalg.norm((image.points - image.center) / image.spacing, axis=1)
    image.point_data["fraction"] = np.maximum(4 - near, 0).astype(np.float32)
    image.point_data["wind"] = np.where(near[:, None] < 4, image.points, 0).astype(np.float32)
    return image


class Sparse(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "cloud.vdb"


@unittest.skipUnless(HAS_OPENVDB, "this build has no OpenVDB")
class RoundTrip(Sparse):
    def test_image(self):
        image = cloud()
        image.nephoscope.write_vdb(self.path, names={"fraction": "density"})
        points = nephoscope.read_vdb(self.path)
        self.assertIsInstance(points, pyvista.PolyData)
        self.assertEqual(set(points.point_data.keys()), {"density", "wind"})
        inside = image["fraction"] > 0
        self.assertEqual(points.n_points, inside.sum())
        order = np.lexsort(image.points[inside].T), np.lexsort(points.points.T)
        np.testing.assert_allclose(points.points[order[1]], image.points[inside][order[0]], rtol=1e-6)
        np.testing.assert_array_equal(points["density"][order[1]], image["fraction"][inside][order[0]])
        dense = nephoscope.read_vdb(self.path, "wind", image=True)
        self.assertIsInstance(dense, pyvista.ImageData)
        self.assertEqual(dense.point_data.keys(), ["wind"])
        np.testing.assert_allclose(dense.spacing, image.spacing)

    def test_choices(self):
        image = cloud()
        nephoscope.write_vdb(image, self.path, "fraction", tolerance=2, precision="half", compression="none")
        points = nephoscope.read_vdb(str(self.path), ["fraction"])
        self.assertEqual(points.active_scalars_name, "fraction")
        self.assertEqual(points.n_points, (image["fraction"] > 2).sum())
        np.testing.assert_allclose(points["fraction"].min(), image["fraction"][image["fraction"] > 2].min(), rtol=1e-3)

    def test_particles(self):
        particles = pyvista.PolyData(np.random.default_rng(2).uniform(0, 10, (500, 3)))
        particles["mass"] = np.linspace(1, 2, 500)
        particles.nephoscope.write_vdb(self.path, masses="mass", voxel_size=2)
        density = nephoscope.read_vdb(self.path, "density")["density"]
        self.assertAlmostEqual(density.sum() * 2 ** 3 / 750, 1, places=5)

    def test_splats_have_the_shape_of_voxels(self):
        cloud().nephoscope.write_vdb(self.path)
        plotter = pyvista.Plotter(off_screen=True, window_size=(50, 50))
        self.addCleanup(plotter.close)
        volume = nephoscope.add_splats(plotter, nephoscope.read_vdb(self.path), "fraction", vectors="wind", color="white")
        plotter.background_color = "black"
        plotter.view_isometric()
        image = plotter.screenshot()
        self.assertGreater(image.max() - image.min(), 50)
        plain = nephoscope.add_splats(plotter, volume.mapper.dataset, "fraction")  # streaks would reach farther
        reach = np.subtract(plain.bounds, plain.mapper.dataset.bounds)[1::2]
        np.testing.assert_allclose(reach, 1.556228 * np.array([0.5, 1, 2]), rtol=1e-4)


@unittest.skipUnless(HAS_OPENVDB, "this build has no OpenVDB")
class Refused(Sparse):
    def test_reading(self):
        with self.assertRaisesRegex(FileNotFoundError, "No such file: .*cloud.vdb"):
            nephoscope.read_vdb(self.path)
        self.path.write_text("no voxels")
        with self.assertRaisesRegex(RuntimeError, "is not a .vdb file"):
            nephoscope.read_vdb(self.path)
        cloud().nephoscope.write_vdb(self.path)
        with self.assertRaisesRegex(ValueError, "grids: 'smoke' not in .*There are: 'fraction', 'wind'"):
            nephoscope.read_vdb(self.path, ["fraction", "smoke"])
        with self.assertRaisesRegex(RuntimeError, "memory|Memory"):
            nephoscope.read_vdb(self.path, memory_limit=1e-7)
        with self.assertRaisesRegex(ValueError, "memory_limit is 0"):
            nephoscope.read_vdb(self.path, memory_limit=0)

    def test_writing(self):
        for error, pattern, options in ((MissingDataError, "arrays: no array 'rain'", {"arrays": "rain"}),
                                        (MissingDataError, "names: no array 'rain'", {"names": {"rain": "density"}}),
                                        (MissingDataError, "masses: no point array 'm'", {"masses": "m"}),
                                        (ValueError, "precision is 'double'", {"precision": "double"}),
                                        (ValueError, "tolerance is -1", {"tolerance": -1}),
                                        (ValueError, "voxel_size is 0", {"voxel_size": 0})):
            with self.assertRaisesRegex(error, pattern):
                cloud().nephoscope.write_vdb(self.path, **options)
            self.assertFalse(self.path.exists())
        with self.assertRaisesRegex(RuntimeError, r"resample it to an image first \(image.sample\(mesh\)"):
            cloud().cast_to_structured_grid().nephoscope.write_vdb(self.path)
        with self.assertRaisesRegex(TypeError, "mesh is a str"):
            nephoscope.write_vdb("cloud", self.path)


@unittest.skipIf(HAS_OPENVDB, "this build has OpenVDB")
class Without(Sparse):
    def test_message_has_the_remedy(self):
        with self.assertRaisesRegex(RuntimeError, "OpenVDB"):
            cloud().nephoscope.write_vdb(self.path)


if __name__ == "__main__":
    unittest.main()
