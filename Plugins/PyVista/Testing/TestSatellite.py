# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.satellite_image against closed forms and energy: reflectances, places, the file; and the tone curve of pictures."""
import json
import os
import sys
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from nephoscope import tone
from nephoscope._ground_light import irradiance
from nephoscope._refined import refined

sys.path.insert(0, str(Path(__file__).parents[3] / "Filters/Sunlight/Testing"))
import monte_carlo  # noqa: E402

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
WIDE, LEVELS = 20.0, 41


def slab(depth):
    """Level cloud of thickness 1, so wide that no ray leaves it through a side."""
    grid = pyvista.ImageData(dimensions=(5, 5, LEVELS), spacing=(WIDE, WIDE, 1 / (LEVELS - 1)))
    grid.point_data["Extinction"] = np.full(grid.n_points, float(depth))
    return grid


def middle(image):
    height, width = image.reflectance.shape
    return image.reflectance[height // 2, width // 2]


def towards(cosine):
    return (np.sqrt(1 - cosine**2), 0, cosine)


def globe(extinction, columns=37, rows=19):
    grid = pyvista.RectilinearGrid(np.linspace(0, 360, columns)[:-1], np.linspace(-90, 90, rows), [0.0, 5000.0, 10000.0])
    made = grid.nephoscope.globe(level_units="m", vertical_exaggeration=10, mask_below_ground=False)
    made.point_data["Extinction"] = np.full(made.n_points, float(extinction))
    return made


class Slab(unittest.TestCase):
    def test_single_scattering(self):
        """albedo / 4 mu0 / (mu + mu0) (1 - exp(-depth (1 / mu + 1 / mu0))), with isotropic scattering."""
        for sun, view in ((1.0, 1.0), (0.6, 1.0), (0.8, 0.5), (0.3, 0.7)):
            sun_options = {"direction": towards(sun), "multiple_scattering": False, "sky_light": 0, "albedo": 0.9, "asymmetry": 0.0}
            image = nephoscope.satellite_image(slab(0.8), towards(view), sun=sun_options, size=(21, 21), ground_albedo=0)
            expected = 0.9 / 4 * sun / (sun + view) * (1 - np.exp(-0.8 * (1 / sun + 1 / view)))
            self.assertAlmostEqual(middle(image), expected, delta=2e-3 * expected)

    def test_energy(self):
        """Light that leaves in all directions is the upward irradiance of the solver."""
        sun = {"direction": towards(0.8), "sky_light": 0}
        cosines, weights = np.polynomial.legendre.leggauss(4)
        cosines, weights, azimuths = 0.5 * (cosines + 1), 0.5 * weights, np.pi * (np.arange(6) + 0.5) / 6
        images = [nephoscope.satellite_image(slab(6), view, sun=sun, size=(11, 11), ground_albedo=0)
                  for view in ((np.sqrt(1 - c**2) * np.cos(a), np.sqrt(1 - c**2) * np.sin(a), c) for c in cosines for a in azimuths)]
        upward = slab(6).nephoscope.sunlight(**sun, ground_albedo=0).point_data["UpwardIrradiance"].reshape(LEVELS, -1)[-1, 12]
        radiances = np.reshape([middle(image) for image in images], (4, 6)).mean(axis=1)
        self.assertAlmostEqual(float(2 * weights * cosines @ radiances), upward, delta=0.05 * upward)

    def test_ground(self):
        bare = nephoscope.satellite_image(slab(0), "nadir", sun={"direction": towards(0.5), "sky_light": 0}, size=(20, 20), ground_albedo=0.3)
        self.assertAlmostEqual(middle(bare), 0.15, places=5)
        self.assertAlmostEqual(bare.normalized()[10, 10], 0.3, places=5)
        black = nephoscope.satellite_image(slab(0), "nadir", sun=towards(0.5), size=(20, 20), ground_albedo=0)
        self.assertEqual(np.nanmax(black.reflectance), 0)

    def test_thick_is_bright_and_below_1(self):
        reflectances = [middle(nephoscope.satellite_image(slab(depth), sun={"direction": (0, 0, 1), "sky_light": 0}, size=(8, 8))) for depth in (0.1, 1, 5, 20)]
        self.assertEqual(reflectances, sorted(reflectances))
        self.assertGreater(reflectances[-1], 0.5)
        self.assertLess(reflectances[-1], 1)


class StepCloud(unittest.TestCase):
    """Single scattering in the step cloud of I3RC, seen from above, in grids whose points lie close together beside the steps."""

    def columns(self, case, levels=193, steps=96):
        name, zenith, azimuth, _ = monte_carlo.CASES[case]
        cloud = monte_carlo.CLOUDS[name]
        ends = np.array([-0.5, 15.5, 31.5])[:, None]  # the steps, in columns
        across = np.concatenate([np.linspace(0, 32, steps + 1), (ends + np.delete(np.arange(-2, 2.01, 0.0625), 32)).ravel(), (ends + (-1e-4, 1e-4)).ravel()])
        across = np.unique(across[(across >= 0) & (across <= 32) & (np.abs(across - ends).min(axis=0) > 1e-6)].round(6))
        grid = pyvista.RectilinearGrid(cloud.across * across, cloud.across * np.array([0, 0.5, 1]), np.linspace(0, cloud.height, levels))
        grid["Extinction"] = cloud.at(grid.points[:, 0], 0)
        sun = {"direction": monte_carlo.sun_of(zenith, azimuth), "multiple_scattering": False, "sky_light": 0, "asymmetry": monte_carlo.ASYMMETRY, "periodic": True}
        image = nephoscope.satellite_image(grid, "nadir", sun=sun, size=(512, 16), ground_albedo=0)
        columns = cloud.column(image.x[8])
        return np.array([image.reflectance[8, columns == column].mean() for column in range(32)])

    def test_single_scattering(self):
        """The radiance of each column agrees with the Monte Carlo table of one scattering to 0.5 %."""
        for case in ("step 0", "step 60"):
            table = json.loads(monte_carlo.TABLE.read_text())[case + " once"]
            error = self.columns(case) / np.array(table["reflectance"]) - 1
            print(f"{case}: worst column {100 * np.abs(error).max():.2f} %, rms {100 * np.sqrt((error**2).mean()):.2f} %; statistical error {100 * table['error']:.2f} %")
            self.assertLess(table["error"], 2e-3)
            self.assertLess(np.abs(error).max(), 5e-3)


class Ground(unittest.TestCase):
    def cloud(self):
        """A flat cloud with an optical depth of 10 over the middle of the mesh."""
        grid = pyvista.ImageData(dimensions=(33, 33, 17), spacing=(100, 100, 50))
        x, y, z = grid.points.T
        grid["Extinction"] = np.where((np.abs(x - 1600) < 450) & (np.abs(y - 1600) < 650) & (z > 380) & (z < 720), 0.03, 0.0)
        return grid

    def test_shadows_of_all_meshes(self):
        grid = self.cloud()
        meshes = {"image": grid, "rectilinear": grid.cast_to_rectilinear_grid(), "structured": grid.cast_to_structured_grid(), "unstructured": grid.cast_to_unstructured_grid()}
        for sun in ((1, 0, 1), {"direction": (1, 0, 1), "sky_light": 0}):
            images = {name: nephoscope.satellite_image(mesh, "nadir", sun=sun, size=(64, 64), ground_albedo=0.3).reflectance for name, mesh in meshes.items()}
            sky = 0 if isinstance(sun, dict) else 0.08 * (np.sqrt(0.5) + 0.1) / 1.1
            for name, image in images.items():
                with self.subTest(name):
                    shadow, clear = image[31, 15:20], image[5, 5:60]
                    self.assertLess(shadow.max(), 0.6 * 0.3 * (np.sqrt(0.5) + sky))
                    self.assertGreater(shadow.min(), 0.3 * sky + 0.01)  # clouds around it scatter light into it
                    np.testing.assert_allclose(clear, 0.3 * (np.sqrt(0.5) + sky), rtol=0.12)
                    np.testing.assert_allclose(image, images["structured"], atol=0.1)
                    self.assertLess(np.abs(image - images["structured"]).mean(), 4e-3)

    def test_shadow_beside_the_mesh(self):
        """The light of the ground is that of sun and sky where the sun's ray meets no cloud; where it does, the irradiance of the clouds where it meets them."""
        cloud = pyvista.ImageData(dimensions=(9, 9, 5), spacing=(250, 250, 100), origin=(0, 0, 1000))
        cloud["Extinction"] = np.full(cloud.n_points, 0.1)
        lit = cloud.nephoscope.sunlight((1, 0, 1))
        light = irradiance(lit, np.array([[-500.0, 1000, 0], [1000, 9000, 0], [np.nan] * 3]), 0.08)
        sky = 0.08 * (np.sqrt(0.5) + 0.1) / 1.1
        np.testing.assert_allclose(light[1:], [sky + np.sqrt(0.5), np.nan], rtol=1e-3)
        entered = lit.find_closest_point((500, 1000, 1000))
        self.assertAlmostEqual(light[0], lit["Irradiance"][entered], delta=1e-5)


class Up(unittest.TestCase):
    def test_nadir_is_down(self):
        """A mesh with another axis upwards has the image of the mesh with z up, seen from the same side."""
        grid = Ground().cloud()
        grid["Extinction"] *= np.where(grid.points[:, 0] > 1700, 1, 0.5)
        turned = grid.cast_to_structured_grid()
        turned.points = grid.points[:, [0, 2, 1]] * (1, 1, -1)  # y is up, -z north
        for view, seen in (("automatic", "automatic"), ((0.2, 0.1, 1), (0.2, 1, -0.1))):
            options = {"size": (40, 40), "ground_albedo": 0.3}
            expected = nephoscope.satellite_image(grid.cast_to_structured_grid(), view, sun=(0.6, 0.3, 1), **options)
            image = nephoscope.satellite_image(turned, seen, sun={"up": "y", "direction": (0.6, 1, -0.3)}, **options)
            np.testing.assert_allclose(image.reflectance, expected.reflectance, atol=2e-3)
            np.testing.assert_allclose(image.sun_zenith, expected.sun_zenith, atol=1e-4)
            np.testing.assert_allclose(image.y, expected.y, atol=1e-2)
        np.testing.assert_array_equal(turned.points, grid.points[:, [0, 2, 1]] * (1, 1, -1))
        lit = turned.nephoscope.sunlight((0.6, 1, -0.3), up="y", eye=(0, 1, 0), parallel=True, ground_albedo=0.3)
        lit.field_data["Up"] = [(0.0, 1.0, 0.0)]
        image = nephoscope.satellite_image(lit, **options)
        np.testing.assert_allclose(image.reflectance, nephoscope.satellite_image(grid.cast_to_structured_grid(), sun=(0.6, 0.3, 1), **options).reflectance, atol=2e-3)


class Globe(unittest.TestCase):
    def image(self, extinction=0.0, view="geostationary", **options):
        options = {"sun": {"direction": (1, 0, 0), "sky_light": 0}, "size": (81, 81), "longitude": 60.0, "ground_albedo": 0.3, **options}
        return nephoscope.satellite_image(globe(extinction), view, **options)

    def test_geostationary_places(self):
        image = self.image()
        self.assertAlmostEqual(image.longitude[40, 40], 60, places=6)
        self.assertAlmostEqual(image.latitude[40, 40], 0, places=6)
        self.assertGreater(image.latitude[20, 40], 10)
        self.assertGreater(image.longitude[40, 60], 70)
        self.assertTrue(np.isnan(image.reflectance[0, 0]))

    def test_ground_is_that_of_lambert_and_night_is_black(self):
        image = self.image()
        seen = np.isfinite(image.longitude) & (np.abs(image.latitude) < 80)
        cosine = np.cos(np.radians(image.latitude)) * np.cos(np.radians(image.longitude))
        day, night = seen & (cosine > 0.2), seen & (cosine < -0.2)
        np.testing.assert_allclose(image.reflectance[day], 0.3 * cosine[day], atol=0.01)
        self.assertGreater(night.sum(), 100)
        self.assertEqual(image.reflectance[night].max(), 0)
        np.testing.assert_allclose(np.cos(np.radians(image.sun_zenith[seen])), cosine[seen], atol=1e-6)

    def test_clouds_are_dark_at_night(self):
        image = self.image(1e-4, longitude=170.0)
        self.assertLess(np.abs(image.reflectance[30:50, 30:50]).max(), 1e-9)
        self.assertGreater(np.nanmax(image.reflectance), 0)  # at the limb is day

    def test_nadir_is_a_map(self):
        image = self.image(view="nadir", size=(72, 36))
        np.testing.assert_allclose(np.diff(image.longitude, axis=1), 5, atol=1e-3)
        np.testing.assert_allclose(np.diff(image.latitude, axis=0), -5, atol=1e-3)

    def test_nadir_of_cloud_is_that_of_a_slab(self):
        """Below the sun, and where it is lower."""
        image = self.image(2e-5, view="nadir", size=(72, 36), ground_albedo=0)
        equator = np.abs(image.latitude).min(axis=1).argmin()
        for longitude, delta in ((2.5, 0.01), (52.5, 0.01), (67.5, 0.015)):
            cosine = np.cos(np.radians(longitude)) * np.cos(np.radians(image.latitude[equator, 0]))
            data = pyvista.ImageData(dimensions=(3, 3, 3), spacing=(1e6, 1e6, 5e4))
            data["Extinction"] = np.full(27, 2e-5)
            expected = nephoscope.satellite_image(data, "nadir", sun={"direction": towards(cosine), "sky_light": 0}, size=(9, 9), ground_albedo=0)
            column = np.abs(image.longitude[equator] - longitude).argmin()
            self.assertAlmostEqual(image.reflectance[equator, column], middle(expected), delta=delta)

    def test_file(self):
        path = OUTPUT / "TestSatellite.nc"
        image = self.image()
        image.save(path)
        try:
            import netCDF4
            opened = netCDF4.Dataset(path)
            opened.set_auto_mask(False)
        except ImportError:
            from scipy.io import netcdf_file
            opened = netcdf_file(path, mmap=False)
        with opened as back:
            np.testing.assert_array_equal(back.variables["reflectance"][:], image.reflectance.astype(np.float32))
            found = (back.variables["lat"].standard_name, back.variables["reflectance"].coordinates, back.Conventions)
            self.assertEqual([text if isinstance(text, str) else text.decode() for text in found], ["latitude", "lon lat", "CF-1.8"])

    def test_wrong(self):
        mesh = globe(0)
        for error, words, options in (
                (ValueError, "mesh has no light: give sun", {}),
                (ValueError, "view is 'above'", {"view": "above", "sun": True}),
                (ValueError, "must be width and height", {"size": (3,), "sun": True}),
                (ValueError, "ground_albedo must be", {"ground_albedo": 2, "sun": True})):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                nephoscope.satellite_image(mesh, **options)
        with self.assertRaisesRegex(ValueError, "which needs data on a globe"):
            nephoscope.satellite_image(slab(1), "geostationary", sun=True)
        with self.assertRaisesRegex(TypeError, "must be a pyvista dataset"):
            nephoscope.satellite_image([1, 2])
        with self.assertRaisesRegex(ValueError, "must end in .nc"):
            self.image().save("a.tif")
        with self.assertRaisesRegex(ValueError, "'linear', 'filmic'"):
            self.image().picture(tone_mapping="log")


class CoarseGlobe(unittest.TestCase):
    """Cells of several degrees are flat, and sag by kilometres."""

    def image(self, step, pattern, view="geostationary", size=(100, 100), **options):
        longitudes, latitudes = np.linspace(-60, 60, round(120 / step) + 1), np.linspace(-60, 60, round(120 / step) + 1)
        grid = pyvista.RectilinearGrid(longitudes, latitudes, [0.0, 1000.0, 2000.0, 3000.0])
        x, y, z = grid.points.T
        nodes = np.linspace(-60, 60, 25)  # a field that is linear between points 5 degrees apart
        coarse = pattern(np.arange(25)[:, None], np.arange(25)[None, :]) * np.ones((25, 25))
        at_rows = np.array([np.interp(longitudes, nodes, row) for row in coarse])
        field = np.array([np.interp(latitudes, nodes, column) for column in at_rows.T]).T
        made = grid.nephoscope.globe(level_units="m", mask_below_ground=False)
        made.point_data["Extinction"] = (4e-3 * np.tile(field.ravel(), 4) * (np.abs(made.point_data["Height"] - 1500) < 600)).astype(np.float32)
        sun = {"direction": (1, 0.5, 0.2), "sky_light": 0, **options}
        return nephoscope.satellite_image(made, view, sun=sun, size=size, longitude=0).reflectance

    def assertAlike(self, pattern, greatest):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            coarse, fine = self.image(5.0, pattern)[25:75, 25:75], self.image(1.25, pattern)[25:75, 25:75]
        self.assertGreater(fine.mean(), 0.1)
        self.assertAlmostEqual(coarse.mean(), fine.mean(), delta=0.02 * fine.mean())
        self.assertLess(np.abs(coarse - fine).max(), greatest * fine.mean())

    def test_uniform_deck_has_no_holes(self):
        self.assertAlike(lambda j, i: 1.0, 0.05)

    def test_light_between_points(self):
        self.assertAlike(lambda j, i: 1.0 * ((i + 2 * j) % 3 == 0), 0.02)  # where shadows end

    def test_light_of_a_coarse_mesh_is_told(self):
        lit = globe(1e-4).nephoscope.sunlight((1, 0, 0))
        with self.assertWarnsRegex(UserWarning, "at points 10 degrees apart.*at most 1.25"):
            nephoscope.satellite_image(lit, size=(20, 20))

    def test_columns_follow_the_sphere(self):
        mesh = globe(1e-4)
        mesh.point_data["Weighted"] = np.where(mesh.points[:, 0] > 0, 1.0, 3.0)
        fine = refined(mesh, 4, {"Extinction": None, "Weighted": "Extinction"})
        radii = np.linalg.norm(mesh.points, axis=1).reshape(mesh.dimensions[::-1])[:, 0, 0]
        np.testing.assert_allclose(np.linalg.norm(fine.points, axis=1).reshape(fine.dimensions[::-1]), np.broadcast_to(radii[:, None, None], fine.dimensions[::-1]), rtol=1e-6)
        self.assertEqual(fine.dimensions, (4 * 36 + 1, 4 * 18 + 1, 3))
        corners = fine.point_data["Weighted"].reshape(fine.dimensions[::-1])[:, ::4, ::4]
        np.testing.assert_allclose(corners.ravel(), mesh.point_data["Weighted"], rtol=1e-6)


    def test_hidden_parts_stay_hidden(self):
        mesh = globe(1e-4)
        points, cells = np.zeros(mesh.n_points, np.uint8), np.zeros(mesh.n_cells, np.uint8)
        points.reshape(mesh.dimensions[::-1])[0, 8, 20] = 2  # vtkDataSetAttributes::HIDDENPOINT
        marks = cells.reshape(2, 18, 36)
        marks[0, 7:9, 19:21] = marks[1, 3, 5] = 32  # HIDDENCELL: those around the point, and another
        mesh.point_data["vtkGhostType"], mesh.cell_data["vtkGhostType"] = points, cells
        fine = refined(mesh, 2, {"Extinction": None})
        np.testing.assert_array_equal(np.argwhere(fine.point_data["vtkGhostType"].reshape(fine.dimensions[::-1])), [[0, 16, 40]])
        np.testing.assert_array_equal(np.argwhere(fine.cell_data["vtkGhostType"].reshape(2, 36, 72)), [[1, j, i] for j in (6, 7) for i in (10, 11)])


class Tone(unittest.TestCase):
    def test_srgb(self):
        values = np.linspace(0, 1, 101)
        np.testing.assert_allclose(tone.decoded(tone.encoded(values)), values, atol=1e-6)
        self.assertAlmostEqual(float(tone.encoded(np.array(0.214))), 0.5, places=3)  # middle grey

    def test_exposure_and_curve(self):
        light = np.linspace(0, 4, 200)
        np.testing.assert_allclose(tone.toned(light, 0.5), tone.encoded(light / 2))
        curve = tone.filmic(light)
        self.assertTrue((np.diff(curve) > 0).all() and curve[0] == 0 and curve[-1] < 1)

    def test_picture(self):
        image = nephoscope.satellite_image(slab(5), sun=(0, 0, 1), size=(8, 8))
        self.assertEqual(image.picture(1, "linear")[4, 4], round(255 * float(tone.encoded(middle(image)))))


if __name__ == "__main__":
    unittest.main()
