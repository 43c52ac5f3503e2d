# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""mesh.nephoscope.smooth and mesh.nephoscope.cloud_surface: every argument arrives; errors."""
import os
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

FILE = os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc")


def block():
    mesh = pyvista.RectilinearGrid(np.arange(12) * 30.0, np.linspace(-90, 90, 9), [0.0, 1, 3, 4])
    rng = np.random.default_rng(1)
    mesh.point_data["noise"] = rng.random(mesh.n_points)
    mesh.point_data["other"] = rng.random(mesh.n_points).astype("f4")
    mesh.point_data["weight"] = rng.uniform(1, 2, mesh.n_points)
    mesh.cell_data["number"] = np.arange(mesh.n_cells)
    mesh.set_active_scalars("noise")
    return mesh


class Smooth(unittest.TestCase):
    def test_default(self):
        mesh = block()
        noise = mesh["noise"].copy()
        smoothed = mesh.nephoscope.smooth()
        self.assertIsInstance(smoothed, pyvista.RectilinearGrid)
        self.assertLess(smoothed["noise"].std(), 0.6 * noise.std())
        np.testing.assert_array_equal(mesh["noise"], noise)
        np.testing.assert_array_equal(smoothed["other"], mesh["other"])

    def test_every_argument_arrives(self):
        mesh, plain = block(), block().nephoscope.smooth()["noise"]
        for options in ({"iterations": 2}, {"periodic": "i"}, {"periodic": (False, True, False)}, {"conservative": True},
                        {"isotropic": True, "periodic": "i"}, {"coordinates": "lonlat"}, {"conservative": True, "masses": "weight"}):
            self.assertFalse(np.array_equal(mesh.nephoscope.smooth(**options)["noise"], plain), options)
        self.assertIn("Mass", mesh.nephoscope.smooth(mass_array=True).point_data)
        both = mesh.nephoscope.smooth(scalars=["noise", "other"])
        np.testing.assert_array_equal(both["noise"], plain)
        self.assertFalse(np.array_equal(both["other"], mesh["other"]))
        self.assertFalse(np.array_equal(mesh.nephoscope.smooth(all_arrays=True)["weight"], mesh["weight"]))
        np.testing.assert_array_equal(mesh.nephoscope.smooth(0)["noise"], mesh["noise"])

    def test_errors(self):
        mesh = block()
        with self.assertRaisesRegex(TypeError, "mesh is a PolyData"):
            pyvista.Sphere().nephoscope.smooth()
        with self.assertRaisesRegex(MissingDataError, "no point array 'q'. Point arrays: 'noise'"):
            mesh.nephoscope.smooth(scalars="q")
        with self.assertRaisesRegex(MissingDataError, "cell_data_to_point_data"):
            mesh.nephoscope.smooth(scalars="number")
        with self.assertRaisesRegex(MissingDataError, "masses: no point array 'm'"):
            mesh.nephoscope.smooth(masses="m")
        with self.assertRaisesRegex(TypeError, "iterations is 'T'.*scalars='T'"):
            mesh.nephoscope.smooth("T")
        for bad in (-1, 1.5, True):
            with self.assertRaisesRegex(ValueError, "iterations is .*(at least 0|whole number, 0 to 1000)"):
                mesh.nephoscope.smooth(bad)
        with self.assertRaisesRegex(ValueError, "letters 'i', 'j' and 'k'"):
            mesh.nephoscope.smooth(periodic="x")
        with self.assertRaisesRegex(ValueError, "three values"):
            mesh.nephoscope.smooth(periodic=[True])
        with self.assertRaisesRegex(ValueError, "coordinates is 'polar'"):
            mesh.nephoscope.smooth(coordinates="polar")
        mesh["noise"][5] = np.nan
        with self.assertWarnsRegex(RuntimeWarning, "1 values of the array 'noise'"):
            mesh.nephoscope.smooth()


class CloudSurface(unittest.TestCase):
    def test_clouds_over_the_globe(self):
        globe = nephoscope.read_cf(FILE).nephoscope.globe(vertical_exaggeration=30)
        clouds = globe.nephoscope.cloud_surface(0.15, "cloud_fraction")
        self.assertIsInstance(clouds, pyvista.PolyData)
        self.assertLessEqual(set(globe.point_data) - {"vtkGhostType"}, set(clouds.point_data))
        self.assertTrue((clouds["cloud_fraction"] == np.float32(0.15)).all())
        np.testing.assert_allclose(np.linalg.norm(clouds["Normals"], axis=1), 1, atol=1e-6)
        rough = globe.nephoscope.cloud_surface(0.15, "cloud_fraction", smoothing=0, normals=False)
        self.assertGreater(rough.area, 1.2 * clouds.area)
        self.assertNotIn("Normals", rough.point_data)

    def test_arguments(self):
        mesh = block()
        plain = mesh.nephoscope.cloud_surface(0.5)
        self.assertEqual(set(mesh.nephoscope.cloud_surface([0.6, 0.5])["ContourIndex"]), {0, 1})
        self.assertEqual(set(mesh.nephoscope.cloud_surface(3, rng=(0.4, 0.6))["ContourIndex"]), {0, 1, 2})
        self.assertEqual(set(mesh.nephoscope.cloud_surface(3, smoothing=0)["ContourIndex"]), {0, 1, 2})  # none at an end of the range
        for options in ({"smoothing": 2}, {"periodic": "i"}, {"conservative": True}, {"isotropic": True}, {"scalars": "other"},
                        {"coordinates": "lonlat"}, {"conservative": True, "masses": "weight"}):
            made = mesh.nephoscope.cloud_surface(0.5, **options)
            self.assertFalse(np.array_equal(made.points, plain.points), options)

    def test_usual_value(self):
        """0.15 of cloud fractions, else the middle of what there is: a surface wherever the array varies."""
        mesh = pyvista.ImageData(dimensions=(9, 9, 9))
        near = np.exp(-0.2 * np.linalg.norm(mesh.points - 4.0, axis=1) ** 2)
        spike = (mesh.points == 4.0).all(axis=1)
        for name, values, low, high in (("cloud_fraction", near, 0.15, 0.15), ("cloud_fraction", 100 * near, 15, 15), ("cloud_fraction", 0.1 * near, 0.01, 0.09),
                                        ("clwmr", 1e-4 * near, 3e-5, 6e-5), ("rho", 1e21 * near, 3e20, 6e20), ("T", 290 + near, 290.3, 290.6),
                                        ("T", -near, -0.6, -0.3), ("one", spike.astype(np.uint8), 0.05, 0.1)):
            grid = pyvista.ImageData(dimensions=(9, 9, 9))
            grid["U"] = grid.points  # active
            grid[name] = values
            for smoothing in (0, 1):
                surface = grid.nephoscope.cloud_surface(smoothing=smoothing)
                self.assertGreater(surface.n_cells, 0, name)
            self.assertTrue(low - 1e-6 <= surface[name][0] <= high + 1e-6, (name, surface[name][0]))
        self.assertIs(grid.nephoscope.smooth()["U"].ndim, 2)

    def test_usual_value_of_what_is_visible(self):
        grid = pyvista.ImageData(dimensions=(12, 9, 9))
        grid["q"] = np.where(grid.points[:, 0] > 8, 1000.0, np.sin(grid.points[:, 0]))
        grid["q"][:3] = (np.nan, 1e35, -1e35)
        grid.cell_data["vtkGhostType"] = np.where(grid.cell_centers().points[:, 0] > 8, 32, 0).astype(np.uint8)
        self.assertTrue(grid.point_data.active_scalars_name == "q")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertGreater(grid.nephoscope.cloud_surface(smoothing=0).n_cells, 0)

    def test_seams(self):
        globe = nephoscope.read_cf(FILE).nephoscope.globe(vertical_exaggeration=30, mask_below_ground=False)
        edges = lambda **options: globe.nephoscope.cloud_surface(0.15, "cloud_fraction", **options).n_open_edges
        self.assertGreater(edges(join_seams=False), edges() + 500)
        self.assertGreater(edges(find_seam=False), edges() + 500)

    def test_errors(self):
        mesh = block()
        for kind, told in ((mesh.cast_to_unstructured_grid(), r"mesh is a UnstructuredGrid.* image\.sample\(mesh\)"), (pyvista.Sphere(), r"mesh is a PolyData.*StructuredGrid\.$")):
            with self.assertRaisesRegex(TypeError, told):
                kind.nephoscope.cloud_surface(0.5, "noise")
        image = pyvista.ImageData(dimensions=(30, 30, 9), spacing=(10, 6, 0.5), origin=(5, -88, 0)).sample(mesh.cast_to_unstructured_grid())
        self.assertGreater(image.nephoscope.cloud_surface(0.5, "noise").n_cells, 0)
        with self.assertRaisesRegex(MissingDataError, "no point array 'q'"):
            mesh.nephoscope.cloud_surface(0.5, "q")
        with self.assertRaisesRegex(ValueError, "finite"):
            mesh.nephoscope.cloud_surface([0.5, np.nan])
        with self.assertRaisesRegex(ValueError, "smoothing is -1"):
            mesh.nephoscope.cloud_surface(0.5, smoothing=-1)
        mesh["vector"] = np.zeros((mesh.n_points, 3))
        with self.assertRaisesRegex(ValueError, "3 components.*one component: 'noise', 'other', 'weight'"):
            mesh.nephoscope.cloud_surface(0.5, "vector")


if __name__ == "__main__":
    unittest.main()
