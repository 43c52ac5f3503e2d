# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows of lit clouds in haze: closed forms below a slab, whatever stores it, and shafts of light along the sun's beam."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista

LET_THROUGH = 0.1
SLAB = (1.95, 2.05)  # altitudes; the haze has a scale height of 1
COLOR = np.array((0.9, 0.6, 0.3))
DEPTH = 1.0  # of a vertical ray


def slab(points=9, half=4.0, center=(0, 0)):
    """An image whose array says that less light arrives at its lower face than at its upper one."""
    spacing = 2 * half / (points - 1)
    image = pyvista.ImageData(dimensions=(points, points, 2), spacing=(spacing, spacing, SLAB[1] - SLAB[0]),
                              origin=(center[0] - half, center[1] - half, SLAB[0]))
    image["SunTransmittance"] = np.where(image.points[:, 2] > 2, 1.0, LET_THROUGH)
    return image


def told(mesh, sun):
    mesh.field_data["SunDirection"] = np.array([sun], float)
    return mesh


class Shadows(unittest.TestCase):
    """Seen from straight above, over flat black ground. The clouds themselves are clear."""

    def picture(self, clouds, sun, camera=((0, 0, 50), (0, 0, 0), (0, 1, 0)), scale=1.0, position=None, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("black")
        plotter.add_mesh(pyvista.Plane(i_size=400, j_size=400), color="black", lighting=False)
        for mesh in clouds if isinstance(clouds, (list, tuple)) else [clouds]:
            actor = nephoscope.add_cells(plotter, mesh, "SunTransmittance", opacity=[0, 0], show_scalar_bar=False)
            if position is not None:
                actor.SetPosition(*position)
        nephoscope.add_haze(plotter, **{"visibility": 3.912 / DEPTH, "scale_height": 1, "projection": "map", "color": COLOR, "vertical_exaggeration": 1,
                                        "base_level": 1e-9, "asymmetry": 0.0, **options}, sun=sun)
        plotter.camera_position = camera
        plotter.enable_parallel_projection()
        plotter.camera.parallel_scale = scale
        return plotter.screenshot(return_img=True)[..., :3] / 255

    def shadow(self, slant, let_through=LET_THROUGH):
        """What the slab keeps from the haze below it: the beam has come a way of `slant` through the haze, and goes up again."""
        top, bottom = np.exp(-(1 + slant) * DEPTH * np.exp(-np.array((2.0, 0.0))))
        return (1 - let_through) * (top - bottom) / (1 + slant)

    def loss(self, clouds, sun, at=(30, 30), **options):
        with_shadows = self.picture(clouds, sun, **options)[at]
        without = self.picture(clouds, sun, cloud_shadows=False, **options)[at]
        return (without - with_shadows) / COLOR

    def test_below_a_slab(self):
        for sun in ((0, 0, 1), (1, 0, 1), (0, -1, 1), (np.sqrt(3), 0, 1), (-1, 2, 2)):
            slant = np.linalg.norm(sun) / sun[2]
            np.testing.assert_allclose(self.loss(slab(), sun), self.shadow(slant), atol=0.008, err_msg=str(sun))
            self.assertGreater(self.shadow(slant), 0.15)

    def test_every_storage_of_the_same_cells(self):
        image = slab()
        grids = {"rectilinear": image.cast_to_rectilinear_grid(), "structured": image.cast_to_structured_grid(), "unstructured": image.cast_to_unstructured_grid(),
                 "tetrahedra": image.to_tetrahedra(), "halves": [slab(5, 2.0, (-2.0, y)) for y in (-2.0, 2.0)] + [slab(5, 2.0, (2.0, y)) for y in (-2.0, 2.0)],
                 "blocks": pyvista.MultiBlock([image])}
        grids["tetrahedra"]["SunTransmittance"] = np.where(grids["tetrahedra"].points[:, 2] > 2, 1.0, LET_THROUGH)
        expected = self.picture(image, (1, 1, 2))
        self.assertGreater(np.abs(expected - self.picture(image, (1, 1, 2), cloud_shadows=False)).max(), 0.05)
        for name, grid in grids.items():
            np.testing.assert_allclose(self.picture(grid, (1, 1, 2)), expected, atol=2.1 / 255, err_msg=name)

    def test_the_shadow_lies_along_the_beam(self):
        """Half of the ground lies in the shadow of a slab that ends above another place; the sun is 45 degrees high."""
        loss = (self.picture(slab(), (1, 0, 1), scale=8, cloud_shadows=False) - self.picture(slab(), (1, 0, 1), scale=8))[30, :, 0] / COLOR[0]
        x = (np.arange(60) + 0.5) / 60 * 16 - 8
        # The shadow of the slab at an altitude of 2 is on the ground 2 nearer to the side away from the sun; at the altitude z of the haze, 2 - z.
        np.testing.assert_allclose(loss[(x > -3.8) & (x < 1.8)], self.shadow(np.sqrt(2)), atol=0.008)
        np.testing.assert_allclose(loss[(x < -6.3) | (x > 4.3)], 0, atol=0.006)
        self.assertGreater(loss[(x > -5.3) & (x < -4.2)].min(), 0.3 * self.shadow(np.sqrt(2)))
        self.assertLess(loss[(x > 3) & (x < 4)].max(), 0.6 * self.shadow(np.sqrt(2)))

    def test_two_clouds_are_as_dark_as_the_darker_one(self):
        darker = slab()
        darker["SunTransmittance"] = np.where(darker.points[:, 2] > 2, 1.0, 0.0)
        higher = slab()
        higher.origin = (-4, -4, 3.0)
        np.testing.assert_allclose(self.picture([darker, slab()], (0, 0, 1)), self.picture(darker, (0, 0, 1)), atol=1.1 / 255)
        self.assertGreater(self.loss(higher, (0, 0, 1))[0], self.loss(slab(), (0, 0, 1))[0] + 0.02)

    def test_a_moved_volume_takes_its_shadow_along(self):
        moved = self.picture(slab(center=(100, 0)), (0, 0, 1), position=(-100, 0, 0))
        np.testing.assert_allclose(moved, self.picture(slab(), (0, 0, 1)), atol=1.1 / 255)
        np.testing.assert_allclose(self.loss(slab(center=(100, 0)), (0, 0, 1)), 0, atol=1.1 / 255)

    def test_hidden_and_changed_clouds(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Plane(i_size=400, j_size=400), color="black", lighting=False)
        mesh = slab()
        volume = nephoscope.add_cells(plotter, mesh, "SunTransmittance", opacity=[0, 0], show_scalar_bar=False)
        nephoscope.add_haze(plotter, visibility=3.9, scale_height=1, projection="map", base_level=1e-9, sun=(0, 0, 1), asymmetry=0)
        plotter.camera_position = [(0, 0, 50), (0, 0, 0), (0, 1, 0)]

        def seen():
            plotter.render()
            return plotter.screenshot(return_img=True)[30, 30].astype(int)

        dark = seen()
        volume.SetVisibility(False)
        clear = seen()
        volume.SetVisibility(True)
        mesh["SunTransmittance"] = np.where(mesh.points[:, 2] > 2, 1.0, 0.5 * (1 + LET_THROUGH))
        mesh.Modified()
        between = seen()
        np.testing.assert_allclose(clear - between, (clear - dark) * 0.5, atol=2)
        self.assertGreater((clear - dark).min(), 20)

    def test_no_sun_no_shadows(self):
        for sun in (None, (0, 0, -1)):
            np.testing.assert_array_equal(self.picture(slab(), sun), self.picture(slab(), sun, cloud_shadows=False))

    def test_clouds_lit_by_another_sun(self):
        with self.assertWarnsRegex(RuntimeWarning, r"lit by a sun in the direction \(1, 0, 0\).*Give both the same sun"):
            found = self.picture(told(slab(), (2, 0, 0)), (0, 0, 1))
        np.testing.assert_array_equal(found, self.picture(slab(), (0, 0, 1), cloud_shadows=False))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            np.testing.assert_array_equal(self.picture(told(slab(), (0, 0, 3)), (0, 0, 1)), self.picture(slab(), (0, 0, 1)))

    def test_a_turned_volume_keeps_the_sun_it_was_given(self):
        mesh = told(slab(), (1, 0, 1))
        for turn in ("RotateZ", "SetScale"):
            plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
            self.addCleanup(plotter.close)
            plotter.add_mesh(pyvista.Plane(i_size=400, j_size=400), color="black", lighting=False)
            volume = nephoscope.add_cells(plotter, mesh, "SunTransmittance", opacity=[0, 0], show_scalar_bar=False)
            getattr(volume, turn)(*{"RotateZ": (90,), "SetScale": (1, 1, 1.5)}[turn])
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                haze = nephoscope.add_haze(plotter, visibility=3.9, scale_height=1, projection="map", base_level=1e-9, sun=(1, 0, 1), asymmetry=0)
                plotter.camera_position = [(0, 0, 50), (0, 0, 0), (0, 1, 0)]
                dark = plotter.screenshot(return_img=True)[30, 30].astype(int)
            haze.SetCloudShadows(False)
            plotter.render()
            self.assertGreater((plotter.screenshot(return_img=True)[30, 30] - dark).min(), 10, turn)

    def test_a_film_with_one_sun_after_the_other(self):
        """Between the clouds and the haze of a new step, a frame has two suns: that is no reason for a warning."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for sun in ((-1, 0, 1), (0, 0, 1), (1, 0, 1)):
                nephoscope.add_cells(plotter, told(slab(), sun), "SunTransmittance", opacity=[0, 0], show_scalar_bar=False, name="clouds")
                nephoscope.add_haze(plotter, sun=sun)
                plotter.screenshot(return_img=True)
        with self.assertWarnsRegex(RuntimeWarning, "Give both the same sun"):
            nephoscope.add_haze(plotter, sun=(0, 1, 1))
            plotter.render()
            plotter.render()

    def test_missing_values_cast_no_shadow(self):
        mesh = slab()
        mesh["SunTransmittance"][:] = np.nan
        mesh["SunTransmittance"][::7] = 1.0
        np.testing.assert_allclose(self.loss(mesh, (0, 0, 1)), 0, atol=1.1 / 255)


class Shafts(unittest.TestCase):
    def test_light_between_clouds(self):
        """A lit cloud with a hole, seen from the side: the haze below the hole is brighter than beside it, in surfaces, sky, cells and splats."""
        n = 33
        image = pyvista.ImageData(dimensions=(n, n, 9), spacing=(1, 1, 0.5), origin=(-16, -16, 16))
        radius = np.hypot(image.points[:, 0], image.points[:, 1])
        image["Extinction"] = np.where((radius > 4) & (np.abs(image.points[:, 2] - 18) < 1.6), 3.0, 0.0)
        sun = {"direction": (0, 0, 1), "extinction": "Extinction"}
        for draw in (nephoscope.add_cells, nephoscope.add_splats):
            plotter = pyvista.Plotter(off_screen=True, window_size=(90, 60))
            self.addCleanup(plotter.close)
            plotter.set_background("black")
            draw(plotter, image, "Extinction", sun=sun, show_scalar_bar=False)
            nephoscope.add_haze(plotter, sun=(0, 0, 1), visibility=150, scale_height=20, projection="map", base_level=-16.01, color="gray", asymmetry=0)
            plotter.camera_position = [(0, -60, 8), (0, 0, 8), (0, 0, 1)]
            row = plotter.screenshot(return_img=True)[25:35].mean(axis=(0, 2))
            self.assertGreater(row[45], row[[36, 54]].max() + 2.5, draw.__name__)
            self.assertGreater(row[[2, 87]].min(), row[45], draw.__name__)  # beside all clouds
            np.testing.assert_allclose(row, row[::-1], atol=2)


if __name__ == "__main__":
    unittest.main()
