# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time: one mesh whose values follow, a film, smoke and textures from the same series."""
import shutil
import subprocess
import tempfile
import unittest
import warnings
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
    return first.assign(cl=(dims, ones * np.minimum(1, 0.2 + 0.3 * np.arange(steps)).reshape(-1, 1, 1, 1), {"units": "1"}), ua=(dims, 10 * ones, {"units": "m/s"}), va=(dims, 0 * ones, {"units": "m/s"}),
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
        for background, colour in (("black", (1, 1, 1)), ("lightgray", (0, 0, 0))):
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

    def test_films_have_no_bands(self):
        """Slow changes of colour are those of the pictures, to a step of 255 in the mean over a few pixels."""
        from nephoscope.weather.filming import _gif
        from PIL import Image, ImageFilter
        shades = np.linspace(0, 1, 256)
        with tempfile.TemporaryDirectory() as folder:
            pictures = [Image.fromarray(np.stack(np.broadcast_arrays(255 * shades[None] * shades[:, None], 200 * shades[None], 90 + 100 * turn * shades[:, None]), axis=-1).astype(np.uint8))
                        for turn in (1, 0.5)]
            for i, picture in enumerate(pictures):
                picture.save(Path(folder, f"{i}.png"))
            _gif([str(Path(folder, f"{i}.png")) for i in range(2)], Path(folder, "film.gif"), 8)
            film = self.enterContext(Image.open(Path(folder, "film.gif")))
            for i, picture in enumerate(pictures):
                film.seek(i)
                shown, smooth = (np.asarray(one.filter(ImageFilter.GaussianBlur(3)), float)[8:-8, 8:-8] for one in (film.convert("RGB"), picture))
                self.assertLess(np.abs(shown - smooth).mean(), 0.8)

    def test_an_untouched_plotter_gets_the_whole_picture(self):
        for touched in (False, True):
            for level, options in ((slice(None), {}), (slice(None), {"projection": "map"}), (1, {"projection": "map"})):
                if not touched or level != 1:  # add_cells draws no surface
                    with self.subTest(touched=touched, level=level, **options):
                        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
                        self.addCleanup(plotter.close)
                        if touched:
                            plotter.add_mesh(pyvista.Sphere(radius=6371000), name="mine")
                        series = nephoscope.animate(plotter, forecast().isel(plev=level), "cl", **options)
                        self.assertEqual(plotter.background_color == pyvista.global_theme.background, touched)
                        self.assertEqual(plotter.parallel_projection, not touched and "projection" in options)
                        self.assertEqual(series.mesh.field_data["VerticalExaggeration"][0], 1 if touched else 30)
                        surfaces = [name for name, actor in plotter.renderer.actors.items() if isinstance(actor, pyvista.Actor) and not name.startswith("scale_")]
                        self.assertEqual(len(surfaces), 1 if level != 1 else 3)  # the Earth or the user's; on one level the field and coasts
        self.assertEqual(pyvista.global_theme.background, "white")

    def test_temperatures_are_those_of_the_lowest_level(self):
        """As plot draws them, with the colours of that level in all steps; with an opacity they are a volume."""
        one = isothermal(np.arange(0, 31, 5.0), np.arange(10, 41, 5.0))
        fall = xr.DataArray([0.0, 10.0, 30.0], dims="time")
        data = one.assign(
            ta=(one.ta * 0 + 250 - fall - one.plev.copy(data=20.0 * np.arange(one.sizes["plev"]))).transpose("time", *one.ta.dims).assign_attrs(one.ta.attrs))
        plotter = pyvista.Plotter(off_screen=True, window_size=(100, 100))
        self.addCleanup(plotter.close)
        with tempfile.TemporaryDirectory() as folder:
            series = nephoscope.animate(plotter, data, "ta", filename=folder, progress=False, show_time=False)
        self.addCleanup(series.close)
        self.assertEqual(series.range("ta"), (220, 250))
        self.assertEqual(series.mesh.dimensions[2], 1)
        np.testing.assert_array_equal(series.mesh["ta"], 220)
        self.assertIn("lowest level", next(iter(plotter.scalar_bars.values())).GetTitle())
        other = pyvista.Plotter(off_screen=True, window_size=(100, 100))
        self.addCleanup(other.close)
        volume = nephoscope.animate(other, data, "ta", opacity="linear")
        self.addCleanup(volume.close)
        self.assertGreater(volume.mesh.dimensions[2], 1)

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
        from nephoscope.weather.dataset_series import DatasetSeries
        with mock.patch.object(DatasetSeries, "_read", autospec=True, side_effect=lambda self, step, once=DatasetSeries._read: read.append(step) or once(self, step)):
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


class ColoursOfAllSteps(unittest.TestCase):
    """A field that is 0 in the first step, then 0.1, 0.4 and 0.2: colours and opacities are those of all steps."""

    def setUp(self):
        values = np.array([0.0, 0.1, 0.4, 0.2]).reshape(-1, 1, 1, 1)
        self.dataset = forecast(4)
        self.dataset["so2"] = self.dataset.cl * 0 + values * np.linspace(0, 1, len(LON))
        self.dataset["cl"] = self.dataset.cl * 0 + values
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(self.plotter.close)

    def volume(self):
        return next(actor for actor in self.plotter.renderer.actors.values() if isinstance(actor, pyvista.Volume))

    def test_range_of_all_steps(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)  # that nothing will be visible
            series = nephoscope.animate(self.plotter, self.dataset, "so2")
        self.assertEqual(series.range("so2"), (0.0, np.float32(0.4)))
        self.assertEqual(tuple(self.volume().mapper.scalar_range), (0.0, np.float32(0.4)))
        series.show(2)
        self.assertEqual(tuple(self.volume().mapper.scalar_range), (0.0, np.float32(0.4)))
        self.assertEqual(series.range("Wind"), (10.0, 10.0))

    def test_opacities_are_those_of_the_densest_step(self):
        nephoscope.animate(self.plotter, self.dataset, "so2", vertical_exaggeration=1)
        distance = self.volume().prop.opacity_unit_distance
        alone = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(alone.close)
        volume = nephoscope.add_cells(alone, self.dataset.nephoscope.globe(time=2), "so2", clim=(0, 0.4))
        self.assertAlmostEqual(distance / volume.prop.opacity_unit_distance, 1, places=4)

    def test_a_step_looks_the_same_wherever_the_series_begins(self):
        """The last step, drawn after three others and drawn alone with the limits of all."""
        series = nephoscope.animate(self.plotter, self.dataset, lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, "so2"), projection="map", vertical_exaggeration=50, show_time=False)
        series.show(3)
        other = self.dataset.isel(time=[2, 3]).nephoscope.series(projection="map", vertical_exaggeration=50)
        alone = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(alone.close)
        nephoscope.add_cells(alone, other.mesh, "so2")
        other.show(1)
        getattr(self.plotter, "widgets", self.plotter).clear_slider_widgets()
        first, second = self.plotter.screenshot(), alone.screenshot()
        self.assertGreater(first.std(), 5)
        self.assertLessEqual(np.abs(first.astype(int) - second).max(), 1)

    def test_presets_and_functions_of_the_user(self):
        nephoscope.animate(self.plotter, self.dataset, "cl")  # a fraction: 0 to 1, although the sky is clear at first
        self.assertEqual(tuple(self.volume().mapper.scalar_range), (0.0, 1.0))
        self.plotter.clear()
        drawn = []
        nephoscope.animate(self.plotter, self.dataset, lambda plotter, mesh: drawn.extend([nephoscope.add_cells(plotter, mesh, "so2"), plotter.add_mesh(mesh, scalars="so2", show_scalar_bar=False),
                                                                                         plotter.add_mesh(mesh.copy(), scalars="so2", clim=(0, 9), show_scalar_bar=False)]))
        self.assertEqual([tuple(actor.mapper.scalar_range) for actor in drawn], [(0.0, np.float32(0.4)), (0.0, np.float32(0.4)), (0, 9)])

    def test_winds_of_all_steps(self):
        self.dataset["ua"] = self.dataset.ua * (1 + np.arange(4)).reshape(-1, 1, 1, 1)
        series = self.dataset.nephoscope.series()
        self.assertEqual(series.range("ua"), (10.0, 40.0))
        self.assertEqual(series.range("Wind")[1], np.float32(40))

    def test_values_are_missing_at_first(self):
        self.dataset["so2"] = self.dataset.so2.where(np.arange(4).reshape(-1, 1, 1, 1) > 0)
        series = nephoscope.animate(self.plotter, self.dataset, "so2")
        self.assertEqual(series.range("so2"), (0.0, np.float32(0.4)))

    def test_long_series_are_sampled(self):
        series = xr.concat([self.dataset.isel(time=0).assign(so2=self.dataset.so2.isel(time=0) + i) for i in range(101)], "time", data_vars="minimal", coords="minimal", compat="override").assign_coords(
            time=np.datetime64("2020-01-01", "ns") + np.arange(101) * np.timedelta64(1, "h"))[["ta", "so2"]].nephoscope.series()
        self.assertEqual((len(series.samples("so2")), series.range("so2")), (50, (0, 100)))


class ShownTime(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(120, 90))
        self.addCleanup(self.plotter.close)

    def text(self):
        return self.plotter.renderer.actors["nephoscope_time"].GetText(2)  # upper left

    def test_text_and_slider_follow(self):
        series = nephoscope.animate(self.plotter, forecast(), "cl")
        slider = getattr(self.plotter, "widgets", self.plotter).slider_widgets[0]
        shown = slider.GetRepresentation()
        self.assertEqual((self.text(), shown.GetLabelFormat()), ("2020-01-01 00:00",) * 2)
        series.show(2)
        self.assertEqual((self.text(), shown.GetLabelFormat(), shown.GetValue()), ("2020-01-01 12:00", "2020-01-01 12:00", 2.0))
        shown.SetValue(1.2)  # still held by the mouse
        slider.InvokeEvent("InteractionEvent")
        self.assertEqual((shown.GetLabelFormat(), series.step), ("2020-01-01 06:00", 2))

    def test_a_series_is_closed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "forecast.nc")
            forecast().to_netcdf(path)
            with nephoscope.animate(self.plotter, str(path), "cl") as series:
                self.assertEqual(len(series), 3)
            with self.assertRaisesRegex(ValueError, "series has been closed"):
                series.show(2)
            self.assertFalse(any(thread.is_alive() for thread in series._worker._threads))
        dataset = forecast()
        with dataset.nephoscope.series() as series:
            nephoscope.animate(self.plotter, series, "cl")
            with self.assertRaisesRegex(TypeError, "projection: the series exists already"):
                nephoscope.animate(self.plotter, series, "cl", projection="map")
        self.assertEqual(float(dataset.cl.max()), 0.8)  # a dataset of the user's stays open


if __name__ == "__main__":
    unittest.main()
