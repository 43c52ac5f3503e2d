# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_smoke: the transparency is that of the closed form, the colour that of the argument, and it is seen."""
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError

def beam(density=1.0):
    """A round beam of smoke along x, of radius 1."""
    mesh = pyvista.ImageData(dimensions=(9, 5, 5), spacing=(2.5, 2, 2), origin=(-10, -4, -4))
    mesh.point_data["wind"] = np.tile((1.0, 0, 0), (mesh.n_points, 1))
    return mesh.nephoscope.flow_volume(center=(-8, 0, 0), radius=1, n_sides=60, duration=16, time_step=0.25, initial_density=density)


class InMedia(unittest.TestCase):
    def volumes(self, cmap, background="black", **options):
        """Smoke in a medium, and the change of the picture by it."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(100, 80))
        self.addCleanup(plotter.close)
        plotter.set_background(background)
        air = pyvista.ImageData(dimensions=(9, 9, 9), spacing=(2.5, 1, 1), origin=(-10, -4, -4))
        air["T"] = np.random.default_rng(1).random(air.n_points)
        nephoscope.add_cells(plotter, air, "T", cmap=cmap, show_scalar_bar=False)
        plotter.view_xy()
        before = plotter.screenshot(return_img=True).astype(int)
        smoke = nephoscope.add_smoke(plotter, beam(), **options)
        return plotter, smoke, np.abs(plotter.screenshot(return_img=True).astype(int) - before).max(axis=2)

    def test_smoke_is_seen_by_default(self):
        for cmap, background in (("viridis", "black"), ("gray", "black"), ("gray", "white"), ("coolwarm", "white"), (["white", "white"], "black")):
            _, _, change = self.volumes(cmap, background)
            print(f"  {cmap} on {background}: {(change > 25).mean():.3f}")
            self.assertGreater((change > 25).mean(), 0.01, (cmap, background))

    def test_smoke_stays_transparent(self):
        """Its width has an optical depth of 2 at most, however dense the medium."""
        _, smoke, _ = self.volumes("viridis")
        alone = nephoscope.add_smoke(pyvista.Plotter(off_screen=True), beam())
        self.assertAlmostEqual(alone.prop.opacity_unit_distance / smoke.prop.opacity_unit_distance, 2, 6)

    def test_smoke_among_streaks(self):
        """It has a colour of its own, not that of the streaks."""
        for background in ("black", "white", "#3a5f96"):
            plotter = pyvista.Plotter(off_screen=True, window_size=(100, 80))
            self.addCleanup(plotter.close)
            plotter.set_background(background)
            air = pyvista.ImageData(dimensions=(9, 9, 9), spacing=(2.5, 1, 1), origin=(-10, -4, -4))
            air["T"], air["wind"] = np.random.default_rng(1).random(air.n_points), np.tile((1.0, 0.2, 0.0), (air.n_points, 1))
            nephoscope.add_cells(plotter, air, "T", cmap=["white", "white"], show_scalar_bar=False)
            streaks = nephoscope.add_splats(plotter, air, opacity=0, vectors="wind", show_scalar_bar=False)
            smoke = nephoscope.add_smoke(plotter, beam())
            colour = smoke.mapper.lookup_table.values[0, :3] / 255
            self.assertGreater(np.linalg.norm(colour - streaks.mapper.GetVectorColor()), 0.25, background)

    def test_what_the_user_sets_stays_and_smoke_is_alike(self):
        plotter, smoke, _ = self.volumes("gray", color="white", optical_depth=1)
        alone = nephoscope.add_smoke(pyvista.Plotter(off_screen=True), beam())
        self.assertEqual(smoke.prop.opacity_unit_distance, alone.prop.opacity_unit_distance)
        self.assertEqual(tuple(smoke.mapper.lookup_table.values[0, :3]), (255, 255, 255))
        far = nephoscope.add_smoke(plotter, beam().translate((100, 0, 0)))
        self.assertAlmostEqual(far.prop.opacity_unit_distance, alone.prop.opacity_unit_distance, 9)
        second = pyvista.Plotter(off_screen=True)
        second.set_background("black")
        looks = [(one.prop.opacity_unit_distance, tuple(one.mapper.lookup_table.values[0, :3])) for one in (nephoscope.add_smoke(second, beam()) for _ in range(2))]
        self.assertEqual(looks[0], looks[1])


class Drawing(unittest.TestCase):
    def picture(self, volume, *args, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("black")
        nephoscope.add_smoke(plotter, volume, *args, **options)
        plotter.view_xy()
        plotter.enable_parallel_projection()
        plotter.camera.parallel_scale = 4
        return plotter.screenshot(return_img=True)[..., :3] / 255.0

    def test_transparency(self):
        """Through the middle the optical depth is what was asked for, however dense the smoke was made."""
        for density in (1.0, 5.0):  # only relative
            picture = self.picture(beam(density))
            np.testing.assert_allclose(picture[30, 30], 1 - np.exp(-1), atol=0.01)
            np.testing.assert_allclose(picture[2, 30], 0)
        picture = self.picture(beam(), optical_depth=0.5, color="red")
        np.testing.assert_allclose(picture[30, 30], (1 - np.exp(-0.5), 0, 0), atol=0.01)

    def test_reference_density(self):
        """The optical depth of a path through smoke of that density; also with values that a film raises in place."""
        for density in (1.0, 2.0):
            picture = self.picture(beam(density), optical_depth=0.4, reference_density=1)
            np.testing.assert_allclose(picture[30, 30], 1 - np.exp(-0.4 * density), atol=0.01)
        volume = beam()
        for options in ({}, {"show_scalar_bar": True}, {"scalars": "Age", "cmap": ["white", "white"]}, {"opacity_unit_distance": 4.0}):
            drawn = beam()
            plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
            self.addCleanup(plotter.close)
            plotter.set_background("black")
            nephoscope.add_smoke(plotter, drawn, color=None if "scalars" in options else "white", optical_depth=0.5, **options)
            if plotter.scalar_bars:
                np.testing.assert_allclose(plotter.mapper.scalar_range, (0, 1) if "scalars" not in options else (0, 16), atol=0.2)
                plotter.remove_scalar_bar()
            plotter.view_xy()
            plotter.enable_parallel_projection()
            plotter.camera.parallel_scale = 4
            plotter.show(auto_close=False)
            for factor in (1, 3):
                drawn.cell_data["Density"][:] = factor * volume.cell_data["Density"]
                plotter.render()
                np.testing.assert_allclose(plotter.screenshot(return_img=True)[30, 30, 0] / 255, 1 - np.exp(-0.5 * factor), atol=0.02, err_msg=str(options))

    def test_frames_of_an_unsteady_flow(self):
        """Smoke that has just left the polygon looks the same in every frame, although all smoke together becomes denser."""
        mesh = pyvista.ImageData(dimensions=(9, 9, 41), spacing=(0.1, 0.1, 0.05), origin=(-0.4, -0.4, 0))
        x, y = mesh.points[:, 0], mesh.points[:, 1]
        mesh["wind"] = np.c_[-0.8 * x, -0.8 * y, np.full(mesh.n_points, 0.6)]
        for density, options, opacity in ((1.0, {}, 0.65), (3.0, {}, 0.65), (1.0, {"reference_density": 2.0}, 0.41)):
            seen, lit = [], []
            for time in (0.5, 2, 3):
                smoke = nephoscope.flow_volume([mesh, mesh], times=[0, 4], time=time, center=(0, 0, 0.02), radius=0.3, normal=(0, 0, 1), initial_density=density)
                for volume in (smoke, smoke.nephoscope.smoke_puffs(0, floor=1)):
                    plotter = pyvista.Plotter(off_screen=True, window_size=(200, 200))
                    self.addCleanup(plotter.close)
                    plotter.set_background("black")
                    nephoscope.add_smoke(plotter, volume, color="white", **options)
                    plotter.enable_parallel_projection()
                    plotter.camera_position = [(0, -9, 1), (0, 0, 1), (0, 0, 1)]
                    plotter.camera.parallel_scale = 1
                    seen.append(plotter.screenshot(return_img=True)[-6, 100, 0] / 255)  # 0.03 above the polygon, at an age of 0.05 s
                lit.append(nephoscope.add_smoke(plotter, smoke, sun=(0, 0, 1), **options).mapper.dataset["SmokeExtinction"][np.argmin(smoke.cell_data["Age"])])
            np.testing.assert_allclose(seen, opacity, atol=0.03, err_msg=str((density, options)))
            np.testing.assert_allclose(lit, lit[0], rtol=0.01)
        steady = mesh.nephoscope.flow_volume(center=(0, 0, 0.02), radius=0.3)
        self.assertNotIn("InitialDensity", steady.field_data)

    def test_colour_by_array(self):
        picture = self.picture(beam(), "Age", cmap=["blue", "red"], show_scalar_bar=False)
        left, right = picture[30, 2], picture[30, 57]
        self.assertGreater(left[2] - left[0], 0.15)
        self.assertGreater(right[0] - right[2], 0.15)
        self.assertAlmostEqual(left.sum(), right.sum(), delta=0.05)

    def test_puffs(self):
        volume = beam().nephoscope.smoke_puffs(2, period=4, floor=0)
        row = self.picture(volume)[30, :, 0]
        x = (np.arange(60) - 29.5) / 60 * 8
        age = x + 8
        at_crest, between = np.abs((age - 2 + 2) % 4 - 2) < 0.3, np.abs((age - 2) % 4 - 2) < 0.3
        self.assertGreater(row[at_crest].mean(), 0.5)
        self.assertLess(row[between].mean(), 0.1)

    def test_errors(self):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        for error, pattern, options in ((MissingDataError, "density: no array 'rho'", {"density": "rho"}),
                                        (MissingDataError, "scalars: no array 'q'", {"scalars": "q"}),
                                        (ValueError, "optical_depth is 0", {"optical_depth": 0}),
                                        (ValueError, "reference_density is -1", {"reference_density": -1}),
                                        (ValueError, "clim is given without scalars.*reference_density", {"clim": (0, 10)}),
                                        (ValueError, "cmap is given without scalars", {"cmap": "viridis"}),
                                        (ValueError, "opacity_clim is given.*reference_density", {"opacity_clim": (0, 10), "scalars": "Age"}),
                                        (ValueError, "opacity_scalars is 'Age'.* density", {"opacity_scalars": "Age"})):
            with self.assertRaisesRegex(error, pattern):
                nephoscope.add_smoke(plotter, beam(), **options)
        with self.assertRaisesRegex(TypeError, "volume is a ImageData"):
            nephoscope.add_smoke(plotter, pyvista.ImageData(dimensions=(2, 2, 2)))
        self.assertEqual(dict(plotter.actors), {})


class Colours(unittest.TestCase):
    """Smoke is seen before any background, or it is said that it is not."""

    def added(self, background, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.set_background(background)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            nephoscope.add_smoke(plotter, beam(), **options)
        plotter.view_xy()
        picture = plotter.screenshot(return_img=True)[..., :3].astype(float)
        return np.ptp(picture, axis=(0, 1)).max(), [str(w.message) for w in told if w.category is UserWarning]

    def test_default(self):
        for background in ("white", "black", "lightgray", "#303060", (0.5, 0.5, 0.5)):
            with self.subTest(background):
                contrast, told = self.added(background)
                self.assertGreater(contrast, 25)
                self.assertEqual(told, [])

    def test_camouflage_is_told(self):
        for background in ("white", "black", "#808080"):
            contrast, told = self.added(background, color=background)
            self.assertLess(contrast, 3)
            self.assertTrue(len(told) == 1 and "colour of the background" in told[0] and "set_background" in told[0], told)

    def test_lines_are_no_backdrop(self):
        """An outline around white smoke leaves it invisible on a white background."""
        plotter = pyvista.Plotter(off_screen=True, theme=pyvista.themes.DocumentTheme())
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Cube(), style="wireframe")
        plotter.add_mesh(pyvista.ImageData(dimensions=(3, 3, 3)).outline())
        with self.assertWarnsRegex(UserWarning, "colour of the background"):
            nephoscope.add_smoke(plotter, beam(), color="white")

    def test_white_before_something_else_is_not(self):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Sphere())
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            nephoscope.add_smoke(plotter, beam(), color="white")


if __name__ == "__main__":
    unittest.main()
