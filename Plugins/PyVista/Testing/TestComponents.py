# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors as scalars: the picture is that of an array of the magnitudes, or of the component, as in PyVista's add_mesh."""
import unittest

import nephoscope
import numpy as np
import pyvista
from nephoscope.weather.mesh_series import mesh_series
from pyvista.core.errors import MissingDataError

ADDERS = (nephoscope.add_cells, nephoscope.add_splats)


def grid(size=8):
    mesh = pyvista.ImageData(dimensions=(size, size, size))
    x, y, z = mesh.points.T
    mesh["wind"] = np.column_stack((x - 2, 3 * np.sin(y), 0.5 * z))
    mesh["speed"] = np.linalg.norm(mesh["wind"], axis=1)
    for component in range(3):
        mesh[f"w{component}"] = mesh["wind"][:, component].copy()
    mesh["rgb"] = (30 * mesh.points).astype(np.uint8)
    mesh["rgba"] = np.column_stack((mesh["rgb"], mesh["rgb"][:, 0]))
    mesh.cell_data["flux"] = mesh.point_data_to_cell_data()["wind"]
    mesh.cell_data["flux size"] = np.linalg.norm(mesh.cell_data["flux"], axis=1)
    return mesh


class Components(unittest.TestCase):
    def picture(self, add, mesh, scalars, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100))
        self.volume = add(plotter, mesh, scalars, **options)
        self.titles = list(plotter.scalar_bars.keys())
        plotter.remove_scalar_bar(self.titles[0])
        found = plotter.screenshot(return_img=True).astype(int)
        plotter.close()
        return found

    def check_alike(self, found, expected):
        self.assertGreater(expected.std(), 20)
        self.assertLessEqual(np.abs(found - expected).max(), 1)

    def test_magnitude(self):
        for add in ADDERS:
            for vectors, lengths in (("wind", "speed"), ("flux", "flux size")):
                expected = self.picture(add, grid(), lengths)
                limits, distance = self.volume.mapper.scalar_range, self.volume.prop.opacity_unit_distance
                self.check_alike(self.picture(add, grid(), vectors), expected)
                np.testing.assert_allclose(self.volume.mapper.scalar_range, limits, rtol=1e-6)
                self.assertAlmostEqual(self.volume.prop.opacity_unit_distance / distance, 1, 5)
                self.assertEqual(self.titles, [f"{vectors} magnitude"])

    def test_component(self):
        for add in ADDERS:
            for component in (0, 1, np.int64(2)):
                expected = self.picture(add, grid(), f"w{component}")
                self.check_alike(self.picture(add, grid(), "wind", component=component), expected)
                self.assertEqual(self.titles, [f"wind component {component}"])

    def test_values(self):
        mesh = grid()
        expected = self.picture(nephoscope.add_cells, mesh, "speed")
        self.check_alike(self.picture(nephoscope.add_cells, mesh, np.asarray(mesh["wind"])), expected)
        self.assertEqual((self.titles, "Data" in mesh.array_names), (["Data magnitude"], False))

    def test_new_ranges_copies_and_layers_keep_the_component(self):
        expected = self.picture(nephoscope.add_cells, grid(), "w1", clim=(-1, 3))
        plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100))
        self.addCleanup(plotter.close)
        volume = nephoscope.add_cells(plotter, grid(), "wind", component=1, opacity_unit_distance=self.volume.prop.opacity_unit_distance, show_scalar_bar=False)
        volume.mapper.scalar_range = (-1, 3)
        self.check_alike(plotter.screenshot(return_img=True).astype(int), expected)
        copied = volume.mapper.copy()
        copied.scalar_range = (-1, 3)
        self.assertEqual(volume.prop.GetRGBTransferFunction().GetVectorComponent(), 1)

    def test_contours_of_the_magnitude(self):
        for contours in (3, [2.5]):
            expected = self.picture(nephoscope.add_cells, grid(), "speed", contours=contours)
            self.check_alike(self.picture(nephoscope.add_cells, grid(), "wind", contours=contours), expected)
        with self.assertRaisesRegex(ValueError, r"contours\['scalars'\]: the array 'wind' has 3 components"):
            self.picture(nephoscope.add_cells, grid(), "speed", contours={"values": 3, "scalars": "wind"})

    def test_colours_are_refused_by_name(self):
        for add in ADDERS:
            for name, kind in (("rgb", "RGB"), ("rgba", "RGBA")):
                with self.assertRaisesRegex(ValueError, rf"'{name}' holds colours \({kind}, uint8\).*component=0 for the red.*rgb=True"):
                    self.picture(add, grid(), name)
                self.picture(add, grid(), name, component=1)
        mesh = pyvista.ImageData(dimensions=(4, 4, 4))
        mesh["rgb"] = (60 * mesh.points).astype(np.uint8)
        with self.assertRaises(MissingDataError):
            self.picture(nephoscope.add_cells, mesh, None)

    def test_wrong_components(self):
        for wrong, error in ((3, ValueError), (-1, ValueError), ("x", TypeError), (0.5, TypeError)):
            with self.assertRaisesRegex(error, "^component is "):
                self.picture(nephoscope.add_cells, grid(), "wind", component=wrong)

    def test_series(self):
        """Ranges cover all steps, and the picture follows them."""
        meshes = []
        for factor in (1, 2, 4):
            meshes.append(grid())
            for name in ("wind", "speed", "w0"):
                meshes[-1][name] *= factor
        for name, component, expected in (("wind", None, "speed"), ("wind", 0, "w0")):
            series = mesh_series(meshes, None, None)
            pictures = []
            for scalars, options in ((name, {"component": component}), (expected, {})):
                plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100))
                self.addCleanup(plotter.close)
                volume = nephoscope.add_cells(plotter, series.mesh, scalars, show_scalar_bar=False, preset=False, **options)
                series.show(2)
                pictures.append((plotter.screenshot(return_img=True).astype(int), volume.mapper.scalar_range))
                series.show(0)
            np.testing.assert_allclose(pictures[0][1], series.range("speed") if component is None else (-8, 20), rtol=1e-6)
            self.check_alike(pictures[0][0], pictures[1][0])

    def test_smoke_and_cloud_texture(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100))
        self.addCleanup(plotter.close)
        mesh = grid().cast_to_unstructured_grid()
        mesh.cell_data["Density"] = np.ones(mesh.n_cells)
        nephoscope.add_smoke(plotter, mesh, "wind", show_scalar_bar=True)
        nephoscope.add_smoke(plotter, mesh, "wind", component=2, show_scalar_bar=True)
        self.assertEqual(list(plotter.scalar_bars.keys()), ["wind magnitude", "wind component 2"])
        surface = grid().extract_surface(algorithm="dataset_surface")
        for colours in ("rgb", surface["rgba"]):
            with self.assertRaisesRegex(ValueError, "holds colours.*pass rgb=True"):
                nephoscope.add_cloud_texture(plotter, surface, colours)
        nephoscope.add_cloud_texture(plotter, surface, "rgb", rgb=True)
        actor = nephoscope.add_cloud_texture(plotter, surface, "wind", component=1)
        self.assertEqual(list(plotter.scalar_bars.keys())[2:], ["wind component 1"])
        np.testing.assert_allclose(actor.mapper.scalar_range, (grid()["w1"].min(), grid()["w1"].max()), rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
