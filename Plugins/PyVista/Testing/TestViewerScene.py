# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the viewer finds in files of many kinds, what it draws of them, and what it says of those that it cannot."""
import io
import os
import subprocess
import sys
import tempfile
import time
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import PIL.Image
import pyvista
import xarray as xr
from vtkmodules.vtkWebCore import vtkWebApplication, vtkWebInteractionEvent

nephoscope.read_cf  # the accessor and PyVista's part are there
from nephoscope.serving import save_time_while_moving  # noqa: E402
from nephoscope.viewer_page import camera_after, moved_away  # noqa: E402
from nephoscope.viewer_scene import Scene, camera_of, draw  # noqa: E402
from nephoscope.viewer_state import View, checked  # noqa: E402
from nephoscope.weather.accessor import WeatherAccessor  # noqa: E402

FORECAST = Path(os.environ["NEPHOSCOPE_DATA"], "forecast_10deg_6h.nc")


def image(vectors=True, first=0.0):
    mesh = pyvista.ImageData(dimensions=(8, 8, 8), origin=(first, 0, 0))
    x, y, z = mesh.points.T
    mesh["q"] = z
    if vectors:
        mesh["flow"] = np.column_stack((3.5 - y, x - 3.5, np.ones_like(x)))
    mesh.set_active_scalars("q")
    return mesh


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def scene(self, mesh, name):
        mesh.save(self.folder / name)
        return Scene(self.folder / name)

    def picture(self, scene, **items):
        view, problems = checked(replace(View(), **items), scene.choices)
        self.assertEqual(problems, [])
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90), theme=pyvista.themes.DarkTheme())
        self.addCleanup(plotter.close)
        self.assertEqual(draw(plotter, scene, view), [])
        return np.asarray(plotter.screenshot(), float)

    def test_forecast(self):
        choices = Scene(FORECAST).choices
        self.assertEqual(choices.fields[0], "cloud_fraction")
        self.assertNotIn("gh_units", choices.fields)
        self.assertEqual(choices.techniques, ("cells", "splats", "surface", "winds", "smoke"))
        self.assertEqual(len(choices.times), 7)
        self.assertEqual((choices.globe, choices.terrain), (True, True))

    def test_a_region_is_seen_from_above(self):
        """It fills the picture, above a ground with coasts."""
        import xarray
        forecast = xarray.open_dataset(FORECAST, mask_and_scale=False)
        axes = {name: name for name in forecast.dims if name.startswith(("lon", "lat"))}
        self.assertEqual(len(axes), 2)
        forecast.isel({name: slice(2, 6) for name in axes}).drop_vars(["orog", "lsm"], errors="ignore").to_netcdf(self.folder / "region.nc")
        scene = Scene(self.folder / "region.nc")
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(plotter.close)
        for technique in ("cells", "smoke"):
            view = checked(View(technique=technique), scene.choices)[0]
            draw(plotter, scene, view)
            middle = np.mean(scene.grid(view).points, axis=0)
            eye = np.array(plotter.camera.position)
            self.assertGreater(middle @ eye / np.linalg.norm(middle) / np.linalg.norm(eye), 0.97, technique)
            self.assertLess(np.linalg.norm(eye - middle), 3 * np.linalg.norm(np.ptp(scene.grid(view).points, axis=0)), technique)
        self.assertTrue(scene.choices.terrain or any(actor.GetTexture() for actor in plotter.actors.values() if isinstance(actor, pyvista.Actor)))

    def test_every_item_changes_the_picture(self):
        scene = Scene(FORECAST)
        first = self.picture(scene)
        self.assertGreater(first.std(), 20)
        others = {"field": "u", "technique": "surface", "time": 6, "exaggeration": 60.0, "opacity": 0.2, "preset": "temperature", "terrain": False,
                  "camera": (0, -3e7, 0, 0, 0, 0, 0, 0, 1)}
        for name, value in others.items():
            with self.subTest(name):
                self.assertGreater(np.abs(self.picture(scene, **{name: value}) - first).mean(), 0.3)
        np.testing.assert_array_equal(self.picture(scene), first)

    def test_techniques_follow_one_another_in_one_plotter(self):
        scene = Scene(FORECAST)
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90), theme=pyvista.themes.DarkTheme())
        self.addCleanup(plotter.close)
        for technique in (*scene.choices.techniques, "cells"):
            with self.subTest(technique):
                draw(plotter, scene, checked(View(technique=technique), scene.choices)[0])
                drawn = np.asarray(plotter.screenshot(), float)
                self.assertLess(np.abs(drawn - self.picture(scene, technique=technique)).mean(), 0.5)

    def test_title_of_the_bar_is_clear_of_its_labels(self):
        """Above the middle of the bar: the title, a gap, the label."""
        scene = Scene(FORECAST)
        for size in ((1000, 700), (500, 350)):
            plotter = pyvista.Plotter(off_screen=True, window_size=size, theme=pyvista.themes.DarkTheme())
            self.addCleanup(plotter.close)
            draw(plotter, scene, checked(View("gh", camera=(0, 0, 3e8, 0, 0, 0, 0, 1, 0)), scene.choices)[0])
            drawn = plotter.screenshot()[size[1] * 3 // 4:, int(0.825 * size[0]):int(0.865 * size[0])].max(axis=(1, 2)) > 60
            self.assertEqual(np.count_nonzero(drawn[1:] & ~drawn[:-1]), 3, size)

    def test_legends(self):
        """Every colour has a bar, with its unit and labels that stand apart, also in the part of a window of 800 x 600 pixels beside the side bar."""
        scenes = {name: Scene(FORECAST) for name in ("cells", "winds", "smoke")}
        flat = self.scene(image(), "flow.vti")
        for technique, scene, field, titles in (("cells", scenes["cells"], "gh", ["gh [m]"]), ("winds", scenes["winds"], "", ["cloud_fraction", "Streaks [m s-1]"]),
                                                ("smoke", scenes["smoke"], "", ["cloud_fraction"]), ("winds", flat, "", ["q", "Streaks: flow"]), ("smoke", flat, "", ["q"])):
            with self.subTest(technique, titles=titles):
                plotter = pyvista.Plotter(off_screen=True, window_size=(500, 600), theme=pyvista.themes.DarkTheme())
                self.addCleanup(plotter.close)
                draw(plotter, scene, checked(View(field, technique), scene.choices)[0])
                bars = list(plotter.scalar_bars.values())
                self.assertEqual([bar.GetTitle().strip() for bar in bars], titles)
                self.assertTrue(all(bar.GetPosition()[0] + bar.GetWidth() < bars[0].GetPosition()[0] - 0.1 for bar in bars[1:]))
                for bar in bars:
                    self.assertEqual(bar.GetOrientation(), 0)
                    labels = [bar.GetLabelFormat() % value for value in np.linspace(*bar.GetLookupTable().GetRange(), 3)]
                    self.assertLess(max(map(len, labels)), 7)
                    self.assertEqual(len(set(labels)), 3)
                colours = np.array([bars[-1].GetLookupTable().GetTableValue(i) for i in (0, 128, 255)])
                self.assertTrue(technique == "cells" or np.ptp(colours[:, :3], axis=1).max() > 0.2, colours)  # not grey alone

    def test_camera_is_what_it_was(self):
        scene = Scene(FORECAST)
        camera = (1e7, 2e7, 3e7, 1.0, 2.0, 3.0, 0.0, 0.0, 1.0)
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        draw(plotter, scene, checked(View(camera=camera), scene.choices)[0])
        np.testing.assert_allclose(camera_of(plotter), camera)
        for technique in ("cells", "smoke"):  # the usual one is seen again from its numbers
            draw(plotter, scene, checked(View(technique=technique), scene.choices)[0])
            usual = np.asarray(plotter.screenshot(), float)
            self.assertEqual(plotter.camera.view_angle, 30.0)
            draw(plotter, scene, checked(View(technique=technique, camera=camera_of(plotter)), scene.choices)[0])
            np.testing.assert_allclose(np.asarray(plotter.screenshot(), float), usual, atol=1)

    def test_camera_after_a_choice(self):
        camera = (8.0, 0, 0, 2, 0, 0, 0, 0, 1)
        cells, smoke = View(technique="cells"), View(technique="smoke")
        self.assertEqual(camera_after(cells, replace(cells, technique="splats", time=1, exaggeration=30.0), camera, True), camera)
        self.assertEqual(camera_after(cells, smoke, camera, True), ())  # it may be behind the Earth
        self.assertEqual(camera_after(cells, smoke, camera, False), camera)
        self.assertEqual(camera_after(smoke, cells, camera, True), camera)
        self.assertEqual(moved_away(camera, 1.5), (11.0, 0, 0, 2, 0, 0, 0, 0, 1))

    def test_other_files(self):
        for name, mesh, techniques in (
                ("image.vti", image(), ("cells", "splats", "surface", "winds", "smoke")),
                ("still.vti", image(vectors=False), ("cells", "splats", "surface")),
                ("cells.vtu", image().cast_to_unstructured_grid(), ("cells", "splats", "winds", "smoke")),
                ("blocks.vtm", pyvista.MultiBlock([image(), image(first=7.0)]), ("cells", "splats", "winds", "smoke")),
                ("cellwise.vti", image(vectors=False).point_data_to_cell_data(), ("cells", "splats", "surface")),
                ("surface.vtp", pyvista.Sphere().elevation(), ("mesh", "splats")),
                ("bare.vtp", pyvista.Sphere().copy(), ("mesh",)),
                ("bare.stl", pyvista.Sphere(), ("mesh",))):
            with self.subTest(name):
                if name.startswith("bare.vtp"):
                    mesh.clear_data()
                scene = self.scene(mesh, name)
                self.assertEqual(scene.choices.techniques, techniques)
                self.assertEqual((scene.choices.globe, scene.choices.terrain, scene.choices.times), (False, False, ()))
                for technique in techniques:
                    self.assertGreater(self.picture(scene, technique=technique).std(), 2, technique)

    def test_weather_that_vtk_does_not_read(self):
        """A file with four dimensions, none of which is a time for VTK, is read as `nephoscope.open` reads it, with or without an ending."""
        months, levels, lats, lons = [1, 7], [850.0, 500, 200], np.arange(60, -61, -20.0), np.arange(0, 360, 30.0)
        wind = np.ones((2, 3, 7, 12)) * np.cos(np.radians(lats))[:, None] * np.array([10, 20])[:, None, None, None]
        places = {"month": months, "level": ("level", levels, {"units": "millibars"}), "latitude": ("latitude", lats, {"units": "degrees_north"}), "longitude": ("longitude", lons, {"units": "degrees_east"})}
        data = xr.Dataset({name: (tuple(places), wind, {"units": "m s**-1", "standard_name": f"{way}ward_wind"}) for name, way in (("u", "east"), ("v", "north"))}, places)
        for name in ("months.nc", "months"):
            data.to_netcdf(self.folder / name)
            with mock.patch.object(WeatherAccessor, "globe", autospec=True, side_effect=WeatherAccessor.globe) as globe:
                scene = Scene(self.folder / name)
                scene.grid(View())
            self.assertEqual(globe.call_count, 1)  # the first step is read once
            self.assertEqual((scene.choices.globe, scene.choices.terrain, scene.choices.times), (True, False, ("1", "7")))
            self.assertEqual(scene.choices.techniques, ("cells", "splats", "surface", "winds", "smoke"))
            self.assertGreater(np.abs(self.picture(scene, time=1, field="u") - self.picture(scene, field="u")).max(), 5)
        self.assertGreater(scene.grid(View(exaggeration=20.0)).length, scene.grid(View()).length)

    def test_files_that_cannot_be_drawn(self):
        for name, content, message in (("nothing.nc", None, "There is no file"), ("wrong.nc", b"no NetCDF", "wrong.nc"), ("wrong.vtu", b"<", "wrong.vtu"),
                                       ("what.xyzzy", b"\x01?", "what.xyzzy is neither GRIB nor NetCDF: it begins with"),
                                       ("README.md", b"# It reads GRIB\n", "README.md is neither GRIB nor NetCDF, but a text file.*The viewer draws NetCDF, GRIB, .vdb"),
                                       ("a.grib2", b"GRIB\0\0\0\2" + bytes(99), "a.grib2 cannot be read: "),
                                       ("data", b"CDF\1" + bytes(99), "data cannot be read: ")):
            with self.subTest(name):
                if content is not None:
                    (self.folder / name).write_bytes(content)
                with self.assertRaisesRegex((ValueError, RuntimeError, FileNotFoundError), message):
                    Scene(self.folder / name)
        with self.assertRaisesRegex(ValueError, "no points"):
            self.scene(pyvista.UnstructuredGrid(), "empty.vtu")
        for binary in (True, False):
            path = self.folder / "cut.vtk"
            pyvista.Wavelet().save(path, binary=binary)
            path.write_bytes(path.read_bytes()[:-700])
            with self.assertRaisesRegex(ValueError, "cut.vtk cannot be read: Error reading"):
                Scene(path)


class Moving(unittest.TestCase):
    """Pictures as the page gets them while the mouse turns the view, each of which is drawn once, without multi-sampling."""

    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(200, 150))
        self.addCleanup(self.plotter.close)
        self.plotter.add_mesh(pyvista.Cone())
        self.plotter.view_isometric()
        self.window, self.samples = self.plotter.render_window, []
        self.plotter.screenshot()  # the driver says how many samples it has
        save_time_while_moving(self.plotter)
        self.plotter.renderer.AddObserver("StartEvent", lambda *_: self.samples.append(self.window.GetMultiSamples()))
        self.application = vtkWebApplication()
        self.application.SetImageEncoding(vtkWebApplication.ENCODING_NONE)

    def sent(self):
        """The picture that is sent, and the numbers of samples with which pictures have been drawn since the last one."""
        self.application.StillRenderToBuffer(self.window, 0, 100)
        time.sleep(0.2)  # for the thread that encodes it
        picture = PIL.Image.open(io.BytesIO(bytes(memoryview(self.application.StillRenderToBuffer(self.window, 0, 100)))))
        drawn, self.samples[:] = list(self.samples), []
        return np.asarray(picture.convert("RGB"), float), drawn

    def mouse(self, buttons, x):
        event = vtkWebInteractionEvent()
        event.SetButtons(buttons)
        event.SetX(x)
        event.SetY(0.5)
        self.application.HandleInteractionEvent(self.window, event)

    def test_one_picture_for_each_step_of_the_mouse(self):
        before, drawn = self.sent()
        samples = self.window.GetMultiSamples()
        self.assertGreater(samples, 1)
        self.assertEqual(drawn, [samples])
        self.mouse(0, 0.5)
        self.mouse(1, 0.5)
        for x in (0.52, 0.55, 0.6):
            self.mouse(1, x)
            turned, drawn = self.sent()
            self.assertEqual(drawn, [0])
            self.assertEqual(self.window.GetMultiSamples(), samples)
        self.assertGreater(np.abs(turned - before).mean(), 1)
        self.mouse(0, 0.6)
        rest, drawn = self.sent()
        self.assertEqual(drawn, [samples])
        self.assertLess(np.abs(rest - turned).mean(), 3)
        self.plotter.view_isometric()
        np.testing.assert_allclose(self.plotter.screenshot(), before, atol=40)  # JPEG

    def test_wheel_and_widgets(self):
        before, _ = self.sent()
        interactor = self.window.GetInteractor()
        interactor.SetEventPosition(100, 75)
        interactor.MouseWheelForwardEvent()
        self.assertEqual(self.samples, [])
        wheel, _ = self.sent()
        self.assertGreater(np.abs(wheel - before).mean(), 1)
        self.plotter.camera.azimuth = 60
        interactor.Render()  # as widgets do
        self.assertGreater(np.abs(self.sent()[0] - wheel).mean(), 1)


class Command(unittest.TestCase):
    def run_with(self, *arguments, code="import sys; from nephoscope.viewing import main; sys.exit(main())"):
        return subprocess.run([sys.executable, "-c", code, *map(str, arguments)], capture_output=True, text=True)

    def test_without_trame(self):
        for wheel, what in (True, "'nephoscope\\[web\\]'"), (False, r"-r \S*Plugins/PyVista/requirements-web.txt"):
            hidden = ("import sys, importlib.util as u; find = u.find_spec\n"
                      "u.find_spec = lambda name, *rest: None if name == 'trame' else find(name, *rest)\n"
                      f"from nephoscope import _modules, viewing; _modules.FROM_PYPI = {wheel}; sys.exit(viewing.main())")
            done = self.run_with(FORECAST, code=hidden)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, rf"^nephoscope-viewer: Pictures in the browser need .*trame.* Run: \S+ -m pip install {what}\n$")

    def test_help_names_every_item(self):
        told = self.run_with("--help").stdout
        for name in ("field", "technique", "time", "exaggeration", "opacity", "preset", "no-terrain", "port", "host", "no-browser"):
            self.assertIn(f"--{name}", told)


if __name__ == "__main__":
    unittest.main()
