# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the camera of a first picture looks at, that the plotter it returns draws other views, and that its scalar bar can be read."""
import os
import unittest
import warnings
from pathlib import Path

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import pyvista
import xarray as xr
from nephoscope._globe_camera import look_down
from nephoscope.weather.bars import label_format
from weather_data import frames

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"], "TestWeatherViews.png")
BEHIND = [(0, 3e7, 0), (0, 0, 0), (0, 0, 1)]


def weather(name="cc", middle=(100.0, 30.0), west=0.0, east=355.0, units="1", base=0.0):
    """A blob, of 15 degrees around its middle."""
    longitudes, latitudes = np.arange(west, east + 1, 5.0), np.arange(90, -91, -5.0)
    up = frames(*np.meshgrid(longitudes, latitudes))[2]
    angle = np.degrees(np.arccos(np.clip(up @ frames(*middle)[2], -1, 1)))
    field = base + np.exp(-((angle / 15) ** 2)) * np.ones((3, 1, 1))
    return xr.Dataset({name: (("level", "latitude", "longitude"), field, {"units": units})},
                      {"level": ("level", [850.0, 500, 300], {"units": "hPa"}), "latitude": ("latitude", latitudes, {"units": "degrees_north"}), "longitude": ("longitude", longitudes, {"units": "degrees_east"})})


class Views(unittest.TestCase):
    def plotted(self, dataset, *names, **options):
        plotter = dataset.nephoscope.plot(*names, screenshot=str(OUTPUT), window_size=(120, 120), **options)
        self.addCleanup(plotter.close)
        return plotter

    def place(self, plotter):
        """Longitude and latitude below the camera."""
        x, y, z = np.array(plotter.camera.position) / np.linalg.norm(plotter.camera.position)
        return np.degrees([np.arctan2(y, x), np.arcsin(z)])

    def test_where_the_field_is(self):
        for middle in ((100.0, 30.0), (-170.0, -60.0)):
            for options in ({}, {"units": "K", "name": "t", "base": 250.0}):  # it has values everywhere
                np.testing.assert_allclose(self.place(self.plotted(weather(middle=middle, **options))), middle, atol=3)
        wind = weather("v", units="m/s")
        wind = wind.assign(v=-wind["v"].assign_attrs(units="m/s", standard_name="northward_wind"))
        np.testing.assert_allclose(self.place(self.plotted(wind, "v")), (100, 30), atol=3)  # of either sign

    def test_a_notebook_has_one_picture(self):
        """That of `show`; elsewhere a plotter at the end of a cell is its picture, if PyVista has that."""
        plotter = self.plotted(weather())
        for notebook in (False, True):
            plotter.notebook = notebook
            self.assertEqual(plotter._repr_png_() is not None, not notebook and hasattr(pyvista.Plotter, "_repr_png_"))

    def test_all_round_the_globe(self):
        calm = weather()
        everywhere = calm.assign(cc=calm["cc"] * 0 + np.cos(np.radians(6 * calm.longitude)) ** 2)
        np.testing.assert_allclose(self.place(self.plotted(everywhere)), np.degrees([np.arctan2(-1, 0.3), np.arctan2(0.35, np.hypot(0.3, 1))]), atol=0.1)

    def test_in_the_sun(self):
        """The sun is that of the time step. What the camera looks at is that without sun; of clouds all round the globe it is the side of the sun, and the evening."""
        times = np.array(["2020-06-21T06", "2020-06-21T18"], "M8[ns]")
        blob = weather().expand_dims(time=2).assign_coords(time=times)
        everywhere = blob.assign(cc=blob["cc"] * 0 + np.cos(np.radians(6 * blob.longitude)) ** 2)
        part = blob.sel(longitude=slice(80, 120), latitude=slice(50, 10))
        part_at_night = "it is night in the middle of the data at their time, 2020-06-21 18:00 UTC"
        for dataset, step, sun, camera, told in ((blob, 0, (90, 23.4), (100, 30), None), (blob, 1, None, (100, 30), part_at_night), (part, 0, (90, 23.4), (100, 30), None), (part, 1, None, (100, 30), part_at_night),
                                                 (everywhere, 0, (90, 23.4), (130, 23.4), None), (everywhere, 1, (-90, 23.4), (-50, 23.4), None),
                                                 (everywhere.drop_vars("time"), 0, None, None, "the data have no date"), (blob.isel(time=0), None, (90, 23.4), (100, 30), None)):
            with self.subTest(sizes=dataset.sizes, step=step), warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                plotter = self.plotted(dataset, "cc", time=step, sun=True)
                self.assertEqual([told in str(one.message) for one in caught if "sun=True" in str(one.message)], [True] * (told is not None))
                light = next(actor for actor in plotter.renderer.actors.values() if isinstance(actor, pyvista.Volume)).mapper.dataset.field_data["SunDirection"][0]
                if sun is not None:
                    np.testing.assert_allclose(light, frames(*sun)[2], atol=0.02)
                elif camera is not None:
                    self.assertAlmostEqual(light @ frames(*camera)[2], np.sqrt(0.5), delta=0.05)
                if camera is not None:
                    np.testing.assert_allclose(self.place(plotter), camera, atol=3)
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            warnings.filterwarnings("ignore", "There is no cloud water")
            plotter = self.plotted(part.isel(time=0), "cc", sun=True, projection="map")
        with self.assertWarnsRegex(UserWarning, part_at_night):
            self.plotted(part.isel(time=1), "cc", sun=True, projection="map")

    def test_added_in_the_sun(self):
        """For a dataset, add_cells and add_splats use the sun, camera and shadows of `plot`. A region fills the picture."""
        blob = weather().expand_dims(time=1).assign_coords(time=np.array(["2020-06-21T06"], "M8[ns]"))
        everywhere = blob.assign(cc=blob["cc"] * 0 + np.cos(np.radians(6 * blob.longitude)) ** 2)
        part = blob.sel(longitude=slice(80, 120), latitude=slice(50, 10))
        for dataset, camera in ((blob, (100, 30)), (everywhere, (130, 23.4)), (part, (100, 30))):
            for add in (nephoscope.add_cells, nephoscope.add_splats):
                with self.subTest(sizes=dataset.sizes, add=add.__name__), warnings.catch_warnings():
                    warnings.filterwarnings("ignore", "There is no cloud water")
                    plotter = pyvista.Plotter(off_screen=True, window_size=(120, 120))
                    self.addCleanup(plotter.close)
                    volume = add(plotter, dataset, sun=True)
                    np.testing.assert_allclose(volume.mapper.dataset.field_data["SunDirection"][0], frames(90, 23.4)[2], atol=0.02)
                    np.testing.assert_allclose(self.place(plotter), camera, atol=5)
                    self.assertEqual(np.linalg.norm(plotter.camera.position) < 2.5e7, dataset is part)
                    self.assertEqual(len(plotter.scalar_bars), 0)
                    earth = next(actor for actor in plotter.renderer.actors.values() if getattr(actor, "texture", None) is not None)
                    self.assertIn("Shade", earth.mapper.dataset.array_names)

    def test_films_of_rain_that_begins_later(self):
        """The camera looks at where it will rain, not at the empty first step."""
        blob = weather("tp", units="m").isel(level=0, drop=True)
        times = np.array(["2020-06-21T06", "2020-06-21T12", "2020-06-21T18"], "M8[ns]")
        data = xr.concat([blob * amount for amount in (0, 0.5, 1)], "time").assign_coords(time=times)
        data["tp"].attrs["units"] = "m"
        plotter = pyvista.Plotter(off_screen=True, window_size=(120, 120))
        self.addCleanup(plotter.close)
        nephoscope.animate(plotter, data, "tp").close()
        np.testing.assert_allclose(self.place(plotter), (100, 30), atol=3)

    def test_points_that_repeat_at_regular_distances(self):
        """The middle is that of all of them: every eighth of these is in the north."""
        rng = np.random.default_rng(0)
        points = rng.normal(size=(40000, 3))
        points *= 6.4e6 / np.linalg.norm(points, axis=1)[:, None]
        points[::8, 2] = np.abs(points[::8, 2])
        points[4::8, 2] = -np.abs(points[4::8, 2])
        grid = pyvista.PolyData(points)
        grid["q"] = np.exp(-np.linalg.norm(points / 6.4e6 - frames(100, 30)[2], axis=1) ** 2 / 0.05)
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        look_down(plotter, grid, points, "q", None)
        np.testing.assert_allclose(self.place(plotter), (100, 30), atol=3)

    def test_backgrounds_of_subplots(self):
        """All are dark in an empty plotter; beside other contents only that of the sub-plot of the data is."""
        for before, expected in ((False, [0.0, 0.0]), (True, [1.0, 0.0])):
            plotter = pyvista.Plotter(off_screen=True, shape=(1, 2))
            self.addCleanup(plotter.close)
            if before:
                plotter.add_mesh(pyvista.Sphere())
            plotter.subplot(0, 1)
            nephoscope.add_cells(plotter, weather(), "cc")
            self.assertEqual([renderer.background_color.float_rgb[0] for renderer in plotter.renderers], expected)
            self.assertEqual([bar.GetLabelTextProperty().GetColor()[0] for bar in plotter.scalar_bars.values()], [1.0])

    def test_a_place(self):
        for view in ((-90, 45), np.array([10.0, -20.0]), [0, 90]):
            plotter = self.plotted(weather(), view=view)
            self.assertLess(np.abs(self.place(plotter) - view)[1 if view[1] == 90 else 0:].max(), 0.1)
            np.testing.assert_allclose(plotter.camera.focal_point, 0)
        part = self.plotted(weather(west=80, east=120).sel(latitude=slice(50, 10)), view=(95, 25))
        np.testing.assert_allclose(self.place(part), (95, 25), atol=0.1)
        self.assertGreater(np.linalg.norm(part.camera.focal_point), 6e6)  # near, above it

    def test_a_camera_position(self):
        self.assertEqual(self.plotted(weather(), view=BEHIND).camera.position, BEHIND[0])
        for options in ({"projection": "map"}, {}):
            direction = np.array(self.plotted(weather(), view="xz", **options).camera.direction)
            np.testing.assert_allclose(direction, (0, 1, 0), atol=1e-6)
        metres = {"units": "m"}
        flat = xr.Dataset({"a": (("z", "y", "x"), np.random.default_rng(0).random((4, 5, 6)))}, {axis: (axis, 100.0 * np.arange(count), metres) for axis, count in zip("zyx", (4, 5, 6))})
        np.testing.assert_allclose(self.plotted(flat, view="yz").camera.direction, (-1, 0, 0), atol=1e-6)
        for data in (flat, weather()):
            self.assertEqual(self.plotted(data, view=BEHIND).camera.view_angle, 30)

    def test_wrong(self):
        for view, words in (("above", "longitude and latitude, for a globe, or a camera position"), ((0, 95), "a latitude, is 95"), (("a", 0), "a longitude, is 'a'"), ([1, [2, 3], 4], "camera position")):
            with self.subTest(view), self.assertRaisesRegex(ValueError, words):
                self.plotted(weather(), view=view)
        with self.assertRaisesRegex(ValueError, "which are for a globe"):
            self.plotted(weather(), view=(0, 0), projection="map")

    def test_another_camera(self):
        plotter = self.plotted(weather())
        first = plotter.screenshot(return_img=True)
        np.testing.assert_array_equal(first.ravel(), np.asarray(pyvista.read(OUTPUT)["PNGImage"]).reshape(120, 120, -1)[::-1, :, :3].ravel())
        plotter.camera_position = BEHIND
        second = plotter.screenshot(return_img=True)
        self.assertGreater(np.abs(first.astype(int) - second).mean(), 3)
        np.testing.assert_array_equal(second, plotter.screenshot(return_img=True))
        plotter.camera.azimuth = 40
        self.assertGreater(np.abs(second.astype(int) - plotter.screenshot(return_img=True)).mean(), 3)


class Bars(unittest.TestCase):
    def test_as_many_digits_as_the_range_needs(self):
        for low, high, labels in ((289.1, 289.4, ["289.1", "289.2", "289.3", "289.4"]), (0, 1, ["0.00", "0.33", "0.67", "1.00"]), (190, 310, ["190", "230", "270", "310"]),
                                  (99990, 100020, ["99990", "100000", "100010", "100020"]), (0, 3e-5, ["0.0e+00", "1.0e-05", "2.0e-05", "3.0e-05"]), (-15, 15, ["-15", "-5", "5", "15"]),
                                  (0, 4e-3, ["0.0000", "0.0013", "0.0027", "0.0040"])):
            text = label_format(low, high, 4)
            self.assertEqual([text % value for value in np.linspace(low, high, 4)], labels)
        self.assertEqual((label_format(1, 1, 4) % 1).strip(), "1.00")

    def test_nothing_is_cut_off(self):
        """The outermost pixels have no text, and titles and labels are there as a whole, in windows of several sizes."""
        for size in ((160, 200), (300, 300), (400, 300), (800, 800)):
            for field, name in ((weather("t", units="K", base=289.0), "t"), (weather("reflectivity_of_everything", units="µg m-3 s-1"), None)):
                plotter = field.nephoscope.plot(name, screenshot=str(OUTPUT), window_size=size)
                self.addCleanup(plotter.close)
                bar, = plotter.scalar_bars.values()
                picture = plotter.screenshot(return_img=True).astype(int)
                self.assertLess(picture[:, -3:].max(), 40)
                self.assertGreater(picture[:, int(size[0] * bar.GetPosition()[0]):].max(), 200)
                bar.SetVisibility(False)
                plotter.render()
                earth = np.flatnonzero((plotter.screenshot(return_img=True).max(axis=2) > 40).any(axis=0))
                self.assertGreater(earth[0], 0)
                self.assertLess(earth[-1], size[0] * (bar.GetPosition()[0] + 0.02))  # the globe is beside the bar

    def test_labels_of_a_map_stand_side_by_side(self):
        for width, count in ((160, 2), (800, 4)):
            plotter = weather("t", units="K", base=289.0).nephoscope.plot(screenshot=str(OUTPUT), window_size=(width, 200), projection="map", clim=(123456.0, 123456.3))
            self.addCleanup(plotter.close)
            self.assertEqual([bar.GetNumberOfLabels() for bar in plotter.scalar_bars.values()], [count])


if __name__ == "__main__":
    unittest.main()
