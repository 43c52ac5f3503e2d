# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of nephoscope.add_splats against closed forms, streaks that move with the phase, and the snippet of the page."""
import os
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import pages
import pyvista
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
FOOTPRINT_PEAK = 0.69989  # of the cubic kernel: its integral along a line through the centre, by quadrature
SIZE = 120


def slab(layers=9, n=24):
    """Constant data of so many layers of points."""
    mesh = pyvista.ImageData(dimensions=(n, n, layers), origin=(-(n - 1) / 2, -(n - 1) / 2, -(layers - 1) / 2))
    mesh.point_data["one"] = np.ones(mesh.n_points)
    mesh.point_data["east"] = np.tile((1.0, 0, 0), (mesh.n_points, 1))
    mesh.point_data["rest"] = np.zeros((mesh.n_points, 3))
    return mesh


class Picture(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
        self.plotter.background_color = "black"
        self.addCleanup(self.plotter.close)

    def add(self, mesh, *args, **options):
        return nephoscope.add_splats(self.plotter, mesh, *args, **{"color": "white", "opacity_unit_distance": 8, **options})

    def picture(self, half_height=6):
        """Along z in parallel projection, 0 to 1, row 0 at the top."""
        self.plotter.enable_parallel_projection()
        self.plotter.view_xy()
        self.plotter.camera.parallel_scale = half_height
        self.plotter.render()  # of the second picture of a plotter on; a screenshot draws only the first
        image = self.plotter.screenshot(str(OUTPUT / f"{self.id().split('.', 1)[1]}.png"))
        return image.astype(float)[..., :3] / 255

    def expect_flat(self, value):
        np.testing.assert_allclose(self.picture(), np.broadcast_to(value, (SIZE, SIZE, 3)), atol=2.5 / 255)


class Messages(Picture):
    def draw(self):
        self.plotter.render()
        self.plotter.screenshot()  # which draws the first picture

    def test_hidden_cells_are_not_drawn(self):
        for scalars in ("point", "cell"):
            self.plotter.clear()
            mesh = slab(9, 6).cast_to_structured_grid()
            mesh.cell_data["c"] = np.ones(mesh.n_cells)
            with self.assertWarnsRegex(RuntimeWarning, "no visible points to draw"):
                self.add(mesh.hide_cells(np.arange(mesh.n_cells)), "one" if scalars == "point" else "c")
                self.draw()

    def test_what_mappers_report_when_they_draw(self):
        """Python warns at the line that draws."""
        mesh = slab(4, 6)
        mesh.point_data["holes"] = np.where(mesh.points[:, 0] > 1, np.nan, 1.0)
        nephoscope.add_cells(self.plotter, mesh, "holes", clim=(0, 2))
        with self.assertWarnsRegex(RuntimeWarning, "vtkCellCompositingMapper: .* cells are not drawn because array 'holes'") as caught:
            self.draw()
        self.assertEqual(os.path.realpath(caught.filename), os.path.realpath(__file__))
        splats = self.add(mesh, "one")
        splats.mapper.SetVectorArrayName("nowhere")
        with self.assertWarnsRegex(RuntimeWarning, "vtkTexturedSplatMapper: .*'nowhere'"):
            self.draw()

    def test_clip_plane_of_the_plotter(self):
        """add_volume_clip_plane leaves half of the slab: half of its optical depth along the normal."""
        volume = self.add(slab())
        self.plotter.enable_parallel_projection()
        widget = self.plotter.add_volume_clip_plane(volume, normal="z", origin=(0, 0, 0), interaction_event="always")
        widget.Off()
        # The footprint has no ripple along z where all layers overlap in the middle.
        self.expect_flat(1 - np.exp(-0.5))


class Media(Picture):
    def test_uniform_slab(self):
        self.add(slab())
        self.expect_flat(1 - np.exp(-1))

    def test_opacity_and_scale(self):
        self.add(slab(), "one", color="red", opacity=0.5, opacity_scale=3)
        self.expect_flat((1 - np.exp(-1.5), 0, 0))

    def test_cells(self):
        mesh = slab()
        mesh.cell_data["cell"] = np.ones(mesh.n_cells)
        self.add(mesh, "cell", opacity=1.0)
        self.expect_flat(1 - np.exp(-1))

    def test_values_changed_in_place_are_drawn(self):
        mesh = slab()
        self.add(mesh, "one", clim=(0, 1))
        self.expect_flat(1 - np.exp(-1))
        mesh.point_data["one"][:] = 0.5
        self.expect_flat(1 - np.exp(-0.5))

    def test_one_particle_hides_another(self):
        pair = pyvista.PolyData([(0.0, 0, 0), (0.0, 0, 9)])
        pair["side"] = [0.0, 1.0]
        self.add(pair, "side", color=None, cmap=["red", "blue"], opacity=1.0, radius=3.0, opacity_unit_distance=1, show_scalar_bar=False)
        picture = self.picture()
        alpha = 1 - np.exp(-FOOTPRINT_PEAK * 3.0 / 1.556228)
        middle = picture[SIZE // 2 - 1:SIZE // 2 + 1, SIZE // 2 - 1:SIZE // 2 + 1].mean(axis=(0, 1))
        np.testing.assert_allclose(middle, (alpha * (1 - alpha), 0, alpha), atol=2.5 / 255)
        x, y = np.meshgrid(*[(np.arange(SIZE) + 0.5) / SIZE * 12 - 6] * 2)
        seen = picture.max(axis=2) > 0
        self.assertFalse(seen[np.hypot(x, y) > 3.1].any(), "a splat is wider than its radius")
        self.assertTrue(seen[np.hypot(x, y) < 2.2].all(), "a splat is narrower than its radius")

    def test_tolerance_draws_fewer(self):
        mesh = slab(24)
        mesh.point_data["hill"] = np.exp(-np.sum(mesh.points ** 2, axis=1) / 25)
        volume = self.add(mesh, "hill", opacity_unit_distance=4)
        exact = self.picture(12)
        samples = volume.mapper.GetNumberOfDrawnSplats()
        volume.mapper.SetErrorTolerance(0.05)
        coarse = self.picture(12)
        print(f"  {volume.mapper.GetNumberOfDrawnSplats()} splats of {samples}, mean difference {np.abs(coarse - exact).mean():.4f}")
        self.assertLess(volume.mapper.GetNumberOfDrawnSplats(), samples / 3)
        self.assertLess(np.abs(coarse - exact).mean(), 0.02)


class Balls(Picture):
    """Cells that meet at the axis and in the centre of a ball are needles; no splat of them makes a spike."""

    def depth(self, add, mesh, direction):
        self.plotter.clear()
        add(self.plotter, mesh, "one", color="white", opacity=1.0, opacity_unit_distance=1)
        self.plotter.enable_parallel_projection()
        self.plotter.camera.focal_point = mesh.center
        self.plotter.camera.position = np.array(mesh.center) + 5 * np.array(direction)
        self.plotter.camera.up = (0.1, 1, 0.2)
        self.plotter.camera.parallel_scale = 0.8
        self.plotter.camera.clipping_range = (1, 20)
        self.plotter.render()
        return -np.log1p(-self.plotter.screenshot().astype(float)[..., 0] / 255)

    def test_solid_spheres(self):
        for label, ball in (("solid", pyvista.SolidSphere()), ("fine", pyvista.SolidSphere(theta_resolution=60, phi_resolution=30, radius_resolution=8)),
                            ("hollow", pyvista.SolidSphere(inner_radius=0.2, theta_resolution=40, phi_resolution=20))):
            for attributes, count in ((ball.point_data, ball.n_points), (ball.cell_data, ball.n_cells)):
                ball.clear_data()
                attributes["one"] = np.ones(count)
                for direction in ((0, 0, 1), (1, 0, 0), (0.4, 0.5, 0.77)):
                    splats, cells = (self.depth(add, ball, direction) for add in (nephoscope.add_splats, nephoscope.add_cells))
                    print(f"  {label}, {'cells' if count == ball.n_cells else 'points'}, along {direction}: mean {splats.mean() / cells.mean():.3f}, "
                          f"greatest {splats.max() / cells.max():.2f} of that of cells, difference {np.sqrt(((splats - cells)**2).mean()) / cells.max():.3f}")
                    self.assertAlmostEqual(splats.mean() / cells.mean(), 1, delta=0.01)
                    self.assertLess(splats.max(), 1.45 * cells.max())


class Wind(Picture):
    def streaks(self, **options):
        return self.add(slab(1, 40), "one", opacity=0.0, vectors=dict(array="east", phase_cycles=1, **options))

    def test_streaks_move_with_the_wind(self):
        """A quarter of a loop is a quarter of the period of 4 cells: the picture moves one cell to the right."""
        volume = self.streaks()
        start = self.picture()[..., 0]
        self.assertGreater(start.std(), 0.05, "no streaks")
        volume.mapper.phase = 0.25
        moved = self.picture()[..., 0]
        pixels = SIZE // 12  # in a cell
        match = [np.corrcoef(moved[:, 40:80].ravel(), start[:, 40 - d:80 - d].ravel())[0, 1] for d in range(-40, 41)]
        print(f"  moved by {np.argmax(match) - 40} pixels of {pixels} in a cell, correlation {max(match):.3f}")
        self.assertLessEqual(abs(np.argmax(match) - 40 - pixels), 1)
        self.assertGreater(max(match), 0.7)
        volume.mapper.phase = 1.0
        np.testing.assert_array_equal(self.picture()[..., 0], start)

    def test_streaks_lie_along_the_wind(self):
        self.streaks()
        picture = self.picture()[..., 0]
        self.assertGreater(np.abs(np.diff(picture, axis=0)).mean(), 2 * np.abs(np.diff(picture, axis=1)).mean())

    def test_colour_of_vectors(self):
        self.streaks(color="lime")
        picture = self.picture()
        self.assertGreater(picture[..., 1].max(), 0.3)
        self.assertEqual(picture[..., 0].max(), 0)

    def test_colour_by_an_array(self):
        mesh = slab(1, 40)
        mesh["north"] = mesh.points[:, 1]
        self.add(mesh, "one", opacity=0.0, vectors=dict(array="east", scalars="north", cmap=["red", "blue"], clim=(-0.01, 0.01)), show_scalar_bar=False)
        picture = self.picture()
        self.assertGreater(picture[:50, :, 2].mean(), 20 * picture[:50, :, 0].mean())
        self.assertGreater(picture[70:, :, 0].mean(), 20 * picture[70:, :, 2].mean())

    def test_segments_and_layers(self):
        self.streaks(style="segments", placement="layers")
        self.assertGreater(self.picture().max(), 0.3)

    def test_no_wind_no_streaks(self):
        self.add(slab(1, 40), "one", opacity=0.0, vectors="rest")
        self.assertEqual(self.picture().max(), 0)


class FirstPictures(Picture):
    """Nothing set: neither invisible nor opaque, on any kind of data."""

    def test_every_kind(self):
        image = pyvista.Wavelet()
        particles = pyvista.PolyData(np.random.default_rng(1).normal(size=(3000, 3)))
        particles["height"] = particles.points[:, 2]
        rectilinear = image.cast_to_rectilinear_grid()
        rectilinear.x = np.sign(rectilinear.x) * np.abs(rectilinear.x) ** 1.5
        for kind, mesh in (("image", image), ("rectilinear", rectilinear), ("structured", image.cast_to_structured_grid().rotate_x(30)),
                           ("tetrahedra", image.triangulate()), ("cells", image.point_data_to_cell_data()), ("particles", particles)):
            with self.subTest(kind):
                self.plotter.clear()
                nephoscope.add_splats(self.plotter, mesh, cmap=["white", "white"], show_scalar_bar=False)
                self.plotter.view_isometric()
                alpha = self.plotter.screenshot(str(OUTPUT / f"TestSplatsImage-{kind}.png")).astype(float)[..., 0] / 255
                mean = alpha[alpha > 0.02].mean()
                print(f"  {kind}: mean alpha {mean:.3f} over {np.mean(alpha > 0.02):.0%}")
                self.assertGreater(np.mean(alpha > 0.02), 0.1)
                self.assertTrue(0.25 < mean < 0.97, mean)


class Snippets(unittest.TestCase):
    def test_vtk(self):
        names = {}
        with pages.run("textured-splats.md", "vtk", names):
            window, mapper = names["window"], names["mapper"]
            pictures = []
            for phase in (0.25, 0.5):
                mapper.SetPhase(phase)
                window.Render()
                grab = vtkWindowToImageFilter()
                grab.SetInput(window)
                grab.Update()
                pictures.append(np.asarray(pyvista.wrap(grab.GetOutput()).active_scalars, float))
        self.assertGreater(np.mean(pictures[0].max(axis=1) > 60), 0.1, "nothing is to be seen")
        self.assertGreater(np.abs(pictures[1] - pictures[0]).max(), 50, "the winds stand still")


if __name__ == "__main__":
    unittest.main()
