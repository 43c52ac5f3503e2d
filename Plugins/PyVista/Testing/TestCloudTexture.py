# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_cloud_texture: the cover drawn, colours of add_mesh, arguments that arrive, and errors."""
import math
import os
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
SIZE = 200
SEEN = 1 - np.exp(-3)  # opacity of a layer of optical depth 3, from above


class Picture(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
        self.plotter.background_color = "black"
        self.addCleanup(self.plotter.close)

    def add(self, mesh=None, *args, **options):
        mesh = pyvista.Plane(i_resolution=30, j_resolution=30) if mesh is None else mesh
        return nephoscope.add_cloud_texture(self.plotter, mesh, *args, **{"texture_scale": 40, "lighting": False, "thin_color": "white", **options})

    def picture(self):
        """The sheet fills it, 0 to 1, row 0 at the top."""
        self.plotter.enable_parallel_projection()
        self.plotter.view_xy()
        self.plotter.camera.parallel_scale = 0.5
        self.plotter.render()
        return self.plotter.screenshot(str(OUTPUT / f"{self.id().split('.', 1)[1]}.png")).astype(float)[..., :3] / 255


class Cover(Picture):
    def test_number(self):
        for cover in (0.15, 0.5, 0.85):
            self.plotter.clear()
            self.add(coverage=cover)
            drawn = self.picture().mean() / SEEN
            print(f"  cover {cover}: drawn {drawn:.4f}")
            self.assertAlmostEqual(drawn, cover, delta=0.015)

    def test_array(self):
        sheet = pyvista.Plane(i_resolution=30, j_resolution=30)
        sheet.point_data["share"] = sheet.points[:, 0] + 0.5
        self.add(sheet, coverage="share")
        columns = self.picture()[..., 0].mean(axis=0) / SEEN
        slope = np.polyfit((np.arange(SIZE) + 0.5) / SIZE, columns, 1)
        np.testing.assert_allclose(slope, (1, 0), atol=0.05)


    def test_threshold(self):
        """Above 0 lies one half, above the standard deviation about one sixth: as with edges, whose variance adds up."""
        for threshold, cover in ((0, 0.5), (1, 0.5 * math.erfc(1 / np.sqrt(2 * 1.16)))):
            self.plotter.clear()
            actor = self.add(threshold=threshold)
            self.assertAlmostEqual(self.picture().mean() / SEEN, cover, delta=0.02)
            self.assertAlmostEqual(actor.mapper.GetCoverageUsed(), cover, delta=0.01)

    def test_waves(self):
        """Stripes, four on the sheet."""
        self.add(waves=[[1, 4, 0, 0, 0, 0, 0, 0, 0.25]], texture_scale=1, softness=0, coverage=0.5)
        row = self.picture()[SIZE // 2, :, 0] > 0.5 * SEEN
        self.assertEqual(np.count_nonzero(np.diff(row.astype(int)) == 1) + row[0], 4)


class Colours(Picture):
    def test_of_the_texture(self):
        """Red where it is thin, blue where it is thick, nothing else."""
        self.add(thin_color="red", thick_color=(0.0, 0.0, 1.0), color_range=0.5)
        picture = self.picture()
        self.assertLess(picture[..., 1].max(), 0.01)
        self.assertGreater(picture[..., 2].mean(), 0.1)
        self.assertGreater(picture[..., 0].mean(), 0.02)

    def test_one_colour(self):
        self.add(color="lime", coverage=1.0, thin_color=None)
        np.testing.assert_allclose(self.picture().mean(axis=(0, 1)), (0, SEEN, 0), atol=0.02)

    def test_array_with_a_map(self):
        sheet = pyvista.Plane(i_resolution=30, j_resolution=30)
        sheet.point_data["east"] = sheet.points[:, 0]
        actor = self.add(sheet, "east", cmap=["red", "blue"], clim=(-0.01, 0.01), coverage=1.0, show_scalar_bar=True)
        picture = self.picture()
        self.assertGreater(picture[:150, 110:, 2].mean(), 0.8 * SEEN)
        self.assertGreater(picture[:150, :90, 0].mean(), 0.8 * SEEN)
        self.assertEqual(actor.mapper.scalar_range, (-0.01, 0.01))

    def test_opacity_is_a_factor(self):
        self.add(coverage=1.0, opacity=0.5)
        np.testing.assert_allclose(self.picture().mean(), 0.5 * SEEN, atol=0.02)


class AmongVolumes(Picture):
    def test_order(self):
        """A green sheet behind, inside and in front of a red cube, whichever is added first: the clearer the red, the less of it is in front."""
        for sheet_first in (False, True):
            seen = []
            for z in (-1, 0, 1):
                self.plotter.clear()
                self.plotter.renderer.UseDepthPeelingForVolumesOff()
                cube = pyvista.ImageData(dimensions=(5, 5, 5), spacing=(0.25,) * 3, origin=(-0.5,) * 3)
                cube["density"] = np.ones(125)
                add = [lambda: nephoscope.add_cells(self.plotter, cube, color="red", opacity=[0.5, 0.5], clim=(0, 2), opacity_unit_distance=0.3),
                       lambda: self.add(pyvista.Plane(center=(0, 0, z), i_size=2, j_size=2), color="lime", coverage=1)]
                for one in add[::-1] if sheet_first else add:
                    one()
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    seen.append(self.picture()[SIZE // 2, SIZE // 2, :2])
            through, half = np.exp(-0.5 / 0.3), np.exp(-0.25 / 0.3)
            expected = [(1 - through, through * SEEN), (1 - half + half * (1 - SEEN) * (1 - half), half * SEEN), ((1 - SEEN) * (1 - through), SEEN)]
            np.testing.assert_allclose(seen, expected, atol=5 / 255)


class Shading(Picture):
    def test_smooth_with_normals(self):
        """A coarse sphere: with normals no edges, unless the user wants them; without normals facets."""
        sphere = pyvista.Sphere(radius=0.45, theta_resolution=8, phi_resolution=8)
        bare = sphere.copy()
        bare.clear_data()
        for mesh, options, is_smooth in ((sphere, {}, True), (bare, {}, False), (sphere, {"smooth_shading": False}, False)):
            self.plotter.clear_actors()
            self.add(mesh, color=(0.4, 0.4, 0.4), coverage=1, lighting=True, relief=0, softness=0, **options)
            edges = np.abs(np.diff(self.picture()[50:150, 50:150], axis=1)).max()
            print(f"  largest step {255 * edges:.0f}")
            self.assertEqual(edges < 4 / 255, is_smooth, options)


class Background(Picture):
    def test_seen_before_any(self):
        for background in ("white", "lightyellow", "black", pyvista.themes.Theme().background, pyvista.themes.DarkTheme().background):
            self.plotter.clear()
            self.plotter.background_color = background
            self.add(pyvista.Sphere(radius=0.45), coverage=1.0, lighting=True)
            middle = self.picture()[SIZE // 2 - 20:SIZE // 2 + 20, SIZE // 2 - 20:SIZE // 2 + 20].mean(axis=(0, 1))
            self.assertGreater(np.abs(middle - pyvista.Color(background).float_rgb).max(), 0.3, background)

    def test_clouds_on_white_are_light(self):
        """Bluish, mostly lighter than the middle between black and white, nowhere black, with few steep edges; what the user sets stays."""
        self.plotter.background_color = "white"
        actor = self.add(pyvista.Sphere(radius=0.45), lighting=True, thin_color=None, texture_scale=0)
        self.assertEqual((actor.mapper.GetSoftness(), actor.prop.ambient), (0.8, 0.4))
        picture = self.picture()
        middle = picture[SIZE // 2 - 40:SIZE // 2 + 40, SIZE // 2 - 40:SIZE // 2 + 40]
        self.assertGreater(np.median(middle), 0.5)
        self.assertGreater(np.percentile(middle, 1), 0.3)
        self.assertGreater((middle[..., 2] - middle[..., 0]).mean(), 0.02)
        self.plotter.clear()
        actor = self.add(softness=0.1, ambient=0.2, lighting=True)
        self.assertEqual((actor.mapper.GetSoftness(), actor.prop.ambient), (0.1, 0.2))
        for options in ({"color": "red"}, {"scalars": np.arange(4.0)}):
            self.assertEqual(self.add(pyvista.Plane(i_resolution=1, j_resolution=1), **options).mapper.GetSoftness(), 0.4)
        self.plotter.background_color = "black"
        self.assertEqual(self.add().mapper.GetSoftness(), 0.4)

    def test_white_before_ground(self):
        self.plotter.background_color = "white"
        grey = self.add().prop.color.float_rgb
        self.assertEqual(self.add().prop.color.float_rgb, grey)  # others of ours are no ground
        self.plotter.add_mesh(pyvista.Line())
        self.assertEqual(self.add().prop.color.float_rgb, grey)
        self.plotter.add_mesh(pyvista.Plane(), color="navy")
        self.assertEqual(self.add().prop.color.float_rgb, (1, 1, 1))
        self.assertEqual(self.add(color="red").prop.color.float_rgb, (1, 0, 0))


class Arguments(Picture):
    def test_they_arrive(self):
        actor = self.add(coverage=0.3, texture_scale=7, texture_length=2, softness=0.3, relief=0.1, threshold=0.2, waves="gardner", use_altitude=True,
                         altitude_range=(2, 3), thin_color="red", thick_color="blue", color_range=2, thickness_effect="threshold", thickness_weight=0.5, optical_depth=5, use_thickness=True, extinction=0.1, layers=4,
                         coordinates=("a", "b"), name="clouds", specular=0.5)
        mapper = actor.mapper
        self.assertIsInstance(mapper, nephoscope.vtkCloudTextureMapper)
        for name, value in (("Coverage", 0.3), ("TextureScale", 7), ("TextureLength", 2), ("Softness", 0.3), ("UseThreshold", 1), ("Threshold", 0.2),
                            ("Waves", 3), ("UseAltitude", 1), ("AltitudeRange", (2, 3)), ("ThinColor", (1, 0, 0)), ("ThickColor", (0, 0, 1)), ("ColorRange", 2),
                            ("ThicknessEffect", 1), ("ThicknessWeight", 0.5), ("Relief", 0.1), ("OpticalDepth", 5), ("UseThickness", 1),
                            ("Extinction", 0.1), ("MaximumNumberOfLayers", 4), ("FirstCoordinatesName", "a"), ("SecondCoordinatesName", "b")):
            self.assertEqual(getattr(mapper, "Get" + name)(), value, name)
        self.assertEqual(actor.prop.specular, 0.5)
        self.assertIs(self.plotter.actors["clouds"], actor)
        self.assertTrue(self.plotter.renderer.GetUseDepthPeeling())

    def test_thickness_is_used_where_an_argument_needs_it(self):
        volume = pyvista.ImageData(dimensions=(3, 3, 3))
        volume["water"] = np.ones(27)
        for options, used, cover in (({}, False, 0.5), ({"thickness_effect": "threshold"}, True, 0.1), ({"thickness_effect": "opacity"}, True, 0.5),
                                     ({"extinction": 2}, True, 0.5), ({"density_volume": volume}, True, 0.5), ({"use_thickness": True}, True, 0.5),
                                     ({"thickness_effect": "threshold", "coverage": 0.7, "waves": "Paper"}, True, 0.7)):
            mapper = self.add(**options).mapper
            self.assertEqual((bool(mapper.GetUseThickness()), mapper.GetCoverage()), (used, cover), options)
            self.plotter.clear()
        with self.assertWarnsRegex(RuntimeWarning, "use_thickness is False: 'thickness_effect', 'extinction' will not be used"):
            self.assertFalse(self.add(use_thickness=False, thickness_effect="threshold", extinction=1).mapper.GetUseThickness())

    def test_density_volume(self):
        volume = pyvista.ImageData(dimensions=(3, 3, 3))
        volume["water"], volume["other"] = np.ones(27), np.zeros(27)
        mapper = self.add(use_thickness=True, density_volume=volume, density="water").mapper
        self.assertIs(mapper.GetDensityVolume(), volume)
        self.assertEqual(mapper.GetDensityArrayName(), "water")
        volume.set_active_scalars("other")
        self.assertEqual(self.add(use_thickness=True, density_volume=volume).mapper.GetDensityArrayName(), "other")
        self.assertIsNone(self.add().mapper.GetDensityVolume())
        self.plotter.clear()
        cells = volume.cast_to_unstructured_grid()
        cells.cell_data["ice"] = np.ones(8)
        for grid in (cells, volume.cast_to_rectilinear_grid(), volume.cast_to_structured_grid(), pyvista.MultiBlock([cells, None, volume])):
            mapper = self.add(use_thickness=True, density_volume=grid, density="water").mapper
            self.assertIs(mapper.GetDensityVolume(), grid)
            self.assertEqual(mapper.GetDensityArrayName(), "water")
        self.assertEqual(self.add(density_volume=cells, density="ice").mapper.GetDensityArrayName(), "ice")
        self.plotter.clear()
        with self.assertRaisesRegex(TypeError, "density_volume is a str.*grid"):
            self.add(density_volume="water")
        with self.assertRaisesRegex(ValueError, "no three-dimensional cells"):
            self.add(density_volume=pyvista.Sphere())
        with self.assertRaisesRegex(MissingDataError, "density.*'share'"):
            self.add(density_volume=volume, density="share")
        self.assertEqual(len(self.plotter.actors), 0)

    def test_defaults_are_those_of_the_mapper(self):
        mapper, fresh = nephoscope.add_cloud_texture(self.plotter, pyvista.Sphere()).mapper, nephoscope.vtkCloudTextureMapper()
        for name in ("UseThreshold", "Threshold", "Waves", "UseAltitude", "AltitudeRange", "ThinColor", "ThickColor", "ColorRange", "ThicknessEffect",
                     "ThicknessWeight", "Coverage", "CoverageArrayName", "TextureScale", "TextureLength", "Softness", "Relief", "OpticalDepth", "UseThickness", "Extinction",
                     "DensityArrayName", "DensityVolume", "MaximumNumberOfLayers", "FirstCoordinatesName", "SecondCoordinatesName"):
            self.assertEqual(getattr(mapper, "Get" + name)(), getattr(fresh, "Get" + name)(), name)

    def test_other_meshes(self):
        for mesh in (pyvista.MultiBlock([pyvista.Sphere(), pyvista.Cone()]), pyvista.Wavelet()):
            self.plotter.clear()
            self.assertGreater(self.add(mesh).mapper.dataset.n_cells, 100)

    def test_errors(self):
        with self.assertRaisesRegex(TypeError, "plotter"):
            nephoscope.add_cloud_texture(None, pyvista.Sphere())
        with self.assertRaisesRegex(TypeError, "surface"):
            self.add("clouds")
        with self.assertRaisesRegex(ValueError, "mesh is empty.*no polygons.*isosurfaces"):
            self.add(pyvista.PolyData())
        with self.assertRaisesRegex(ValueError, "has 2 points but no polygons"):
            self.add(pyvista.Line())
        for name in ("coverage", "density"):
            with self.assertRaisesRegex(MissingDataError, f"{name}.*'share'"):
                self.add(**{name: "share"})
        for name, value in (("coverage", 1.5), ("texture_scale", -1), ("threshold", np.nan), ("waves", "sine"), ("waves", [1, 2]),
                            ("waves", np.ones((17, 9))), ("altitude_range", (1,)), ("altitude_range", (0, np.inf)), ("color_range", 0),
                            ("thickness_effect", "both"), ("thickness_weight", -1), ("softness", 3), ("relief", 2), ("optical_depth", -1), ("extinction", np.nan), ("layers", 1),
                            ("texture_length", -1), ("peels", -1)):
            with self.assertRaisesRegex(ValueError, name):
                self.add(**{name: value})
        with self.assertRaisesRegex(ValueError, "coordinates"):
            self.add(coordinates="TextureCoordinates1")
        self.assertEqual(len(self.plotter.actors), 0)


if __name__ == "__main__":
    unittest.main()
