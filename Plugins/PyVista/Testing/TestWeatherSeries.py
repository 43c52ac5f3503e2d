# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time: one mesh whose values follow, a film, smoke and textures from the same series."""
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import pyvista
import xarray as xr
from weather_data import isothermal

LON, LAT = np.arange(0, 40, 5.0), np.arange(20, 60, 5.0)


def forecast(steps=3):
    """Cloud fraction is 0.2, 0.5, ... everywhere; the wind is 10 m/s eastward; six hours between the steps."""
    first = isothermal(LON, LAT)
    times = np.datetime64("2020-01-01T00", "ns") + np.arange(steps) * np.timedelta64(6, "h")
    dims, shape = ("time", *first.ta.dims), (steps, *first.ta.shape)
    ones = np.ones(shape)
    return first.assign(cl=(dims, ones * (0.2 + 0.3 * np.arange(steps).reshape(-1, 1, 1, 1)), {"units": "1"}), ua=(dims, 10 * ones, {"units": "m/s"}), va=(dims, 0 * ones, {"units": "m/s"}),
                        time=("time", times))


class Animation(unittest.TestCase):
    def test_values_follow_and_the_mesh_stays(self):
        series = forecast().nephoscope.series()
        mesh, points = series.mesh, np.array(series.mesh.points)
        self.assertEqual((len(series), series.times[1], list(series.seconds)), (3, "2020-01-01 06:00", [0, 21600, 43200]))
        for step in (2, 0, 1):
            before = mesh.GetMTime()
            series.show(step)
            self.assertIs(series.mesh, mesh)
            self.assertGreater(mesh.GetMTime(), before)
            np.testing.assert_allclose(mesh["cl"], 0.2 + 0.3 * step, rtol=1e-6)
            np.testing.assert_array_equal(mesh.points, points)
        np.testing.assert_allclose(series[-1]["cl"], 0.8, rtol=1e-6)

    def test_seconds_in_other_calendars(self):
        import cftime
        times = [cftime.DatetimeNoLeap(2004, 2, 28), cftime.DatetimeNoLeap(2004, 3, 1), cftime.DatetimeNoLeap(2004, 3, 2, 6)]
        np.testing.assert_allclose(forecast().assign_coords(time=times).nephoscope.series().seconds, [0, 86400, 2 * 86400 + 21600])
        np.testing.assert_allclose(forecast().drop_vars("time").nephoscope.series().seconds, [0, 1, 2])

    def test_the_time_can_be_read(self):
        for background, colour in (("black", (1, 1, 1)), ("white", (0, 0, 0))):
            plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
            self.addCleanup(plotter.close)
            plotter.set_background(background)
            nephoscope.animate(plotter, forecast(), "cl")
            text = plotter.renderer.actors["nephoscope_time"]
            self.assertEqual(text.GetTextProperty().GetColor(), colour)
            self.assertEqual(plotter.slider_widgets[0].GetRepresentation().GetTitleProperty().GetColor(), colour)

    def test_film_and_slider(self):
        with tempfile.TemporaryDirectory() as folder:
            plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
            nephoscope.animate(plotter, forecast(), "cl", filename=Path(folder, "frames"), show_time=False, progress=False, projection="map", vertical_exaggeration=50)
            pictures = [pyvista.read(name)["PNGImage"].astype(float).mean() for name in sorted(Path(folder, "frames").glob("*.png"))]
            plotter.close()
            self.assertEqual(len(pictures), 3)
            self.assertGreater(min(abs(np.diff(pictures))), 1.0)
            with self.assertRaisesRegex(ValueError, "ending must be .gif or .mp4"):
                nephoscope.animate(pyvista.Plotter(off_screen=True), forecast(), "cl", filename="film.avi")

    def test_films_have_every_step(self):
        """GIF and MP4 as a reader of each finds them; the heights of each step, and the slider."""
        from PIL import Image
        with tempfile.TemporaryDirectory() as folder:
            for name in ("film.gif", "film.mp4")[:2 if shutil.which("ffmpeg") else 1]:
                plotter = pyvista.Plotter(off_screen=True, window_size=(121, 90))
                nephoscope.animate(plotter, forecast(4), "cl", filename=Path(folder, name), framerate=4, progress=False, projection="map", vertical_exaggeration=50)
                plotter.close()
            film = self.enterContext(Image.open(Path(folder, "film.gif")))
            frames = []
            for i in range(film.n_frames):
                film.seek(i)
                frames.append(np.asarray(film.convert("RGB"), float))
            self.assertEqual((len(frames), film.info["duration"], frames[0].shape), (4, 250, (90, 121, 3)))
            self.assertGreater(min(np.abs(a - b).max() for a, b in zip(frames, frames[1:])), 20)
            if shutil.which("ffmpeg") and shutil.which("ffprobe"):
                told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames,width,height,pix_fmt", "-of", "csv=p=0", Path(folder, "film.mp4")],
                                      capture_output=True, text=True, check=True).stdout
                self.assertEqual(told.strip(), "122,90,yuv420p,4")

    def test_the_slider_shows_a_step(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        series = nephoscope.animate(plotter, forecast(), "cl", projection="map")
        slider = getattr(plotter, "widgets", plotter).slider_widgets[0]
        slider.GetRepresentation().SetValue(2)
        slider.InvokeEvent("EndInteractionEvent")
        self.assertEqual(series.step, 2)
        np.testing.assert_allclose(series.mesh["cl"], 0.8, rtol=1e-6)
        plotter.close()

    def test_the_next_step_is_read_while_one_is_shown(self):
        read = []
        from nephoscope.weather import series as module
        with mock.patch.object(module.Series, "_read", autospec=True, side_effect=lambda self, step, once=module.Series._read: read.append(step) or once(self, step)):
            series = forecast().nephoscope.series()
            series.show(1)
            series._coming[2].result()
            self.assertEqual(read, [0, 1, 2])
            series.show(2)
            self.assertEqual(read, [0, 1, 2])

    def test_textures_and_smoke_take_the_series(self):
        series = forecast().nephoscope.series(projection="map")
        moved = nephoscope.advect_texture(series.at, 3600.0, times=series.seconds)
        self.assertEqual(moved.n_points, series.mesh.n_points)
        smoke = nephoscope.flow_volume(series.at, times=series.seconds, time=3600.0)
        self.assertGreater(smoke.n_cells, 0)


if __name__ == "__main__":
    unittest.main()
