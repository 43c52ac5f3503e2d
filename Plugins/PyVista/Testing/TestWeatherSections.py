# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sections of a globe at one longitude or latitude, and means along these, are drawn by place and height."""
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
import xarray
from pyvista import DataSetMapper

LON, LAT, HEIGHTS = np.arange(-40.0, 45, 5), np.arange(-60.0, 65, 5), np.array([0.0, 2000, 5000, 9000, 14000])
NAMES = {"longitude": "lon", "latitude": "lat"}


def dataset():
    """A field that is its place: latitude + longitude / 1000 + height in km / 1e6."""
    heights, latitudes, longitudes = np.meshgrid(HEIGHTS, LAT, LON, indexing="ij")
    return xarray.Dataset({"place": (("level", "lat", "lon"), latitudes + longitudes / 1000, {"units": "1"}), "height": (("level", "lat", "lon"), heights, {"units": "m", "standard_name": "altitude"})},
                          {"lon": ("lon", LON, {"units": "degrees_east"}), "lat": ("lat", LAT, {"units": "degrees_north"}), "level": ("level", np.arange(5.0))})


class Sections(unittest.TestCase):
    def drawn(self, data, name="place", **options):
        """The plotter, and the mesh of the field."""
        with tempfile.TemporaryDirectory() as folder:
            plotter = data.nephoscope.plot(name, screenshot=str(Path(folder, "picture.png")), window_size=(300, 300), **options)
        self.addCleanup(plotter.close)
        mappers = [actor.mapper for actor in plotter.renderer.actors.values() if isinstance(getattr(actor, "mapper", None), DataSetMapper)]
        return plotter, next(mapper.dataset for mapper in mappers if name in mapper.dataset.array_names)

    def test_places(self):
        data = dataset()
        keep = {"keep_attrs": True}
        for along, values, cases in (("latitude", LAT, (data.sel(lon=[10]), data.sel(lon=10), data.mean("lon", **keep), data.drop_vars("lon").isel(lon=3))),
                                     ("longitude", LON, (data.sel(lat=[10]), data.sel(lat=10), data.mean("lat", **keep)))):
            for number, section in enumerate(cases):
                for options in ({}, {"projection": "map"}):
                    with self.subTest(along=along, number=number, **options):
                        _, sheet = self.drawn(section, **options)
                        points, field = np.asarray(sheet.points), np.asarray(sheet["place"])
                        np.testing.assert_allclose(np.unique(points[:, 0].round(3)), values, atol=1e-3)
                        np.testing.assert_allclose(points[:, 1], 0)
                        expected = points[:, 0] if along == "latitude" else (field - field.min()) * 1000 + LON[0]
                        np.testing.assert_allclose(expected, field.round() if along == "latitude" else points[:, 0], atol=0.1)
                        heights = np.unique((points[:, 2] / np.ptp(points[:, 2]) * 14).round(3))
                        np.testing.assert_allclose(heights, HEIGHTS / 1000, atol=2e-3)

    def test_picture(self):
        """It fills the picture; its axes have degrees and kilometres."""
        plotter, sheet = self.drawn(dataset().sel(lon=0))
        across, up = np.ptp(sheet.bounds[:2]), np.ptp(sheet.bounds[4:])
        self.assertGreater(across * up / (2 * plotter.camera.parallel_scale) ** 2, 1 / 3)
        for letter, expected in (("x", ["-60", "-40", "-20", "0", "20", "40", "60", "°N"]), ("z", ["0", "2", "4", "6", "8", "10", "12", "14", "km"])):
            source = plotter.renderer.actors[f"labels_{letter}-labels"].GetMapper().GetInputAlgorithm()
            source.Update()
            labels = source.GetInputDataObject(0, 0).GetPointData().GetAbstractArray("labels")
            self.assertEqual([labels.GetValue(i) for i in range(labels.GetNumberOfValues())], expected)
        picture = plotter.screenshot(return_img=True)
        self.assertGreater(picture.std(), 20)

    def film(self, data, plotter=None, **options):
        """The pictures of an animation, and the series."""
        plotter = plotter or pyvista.Plotter(off_screen=True, window_size=(300, 300))
        self.addCleanup(plotter.close)
        with tempfile.TemporaryDirectory() as folder:
            series = nephoscope.animate(plotter, data, "place", filename=folder, progress=False, show_time=False, **options)
            self.addCleanup(series.close)
            return plotter, series, [pyvista.read(path) for path in sorted(Path(folder).glob("*.png"))]

    def test_a_film_of_a_section(self):
        """Each step is the picture of plot with the range of all steps; the camera stays."""
        data = xarray.concat([dataset().assign(place=factor * dataset().place) for factor in (1, 0.5)], xarray.DataArray([0, 1], dims="step", attrs={"long_name": "time"}))
        for section, look in ((data.sel(lon=10), {}), (data.sel(lat=10), {"clim": (0, 12)}), (data.mean("lon", keep_attrs=True), {}), (data.sel(lon=[10]), {})):
            plotter, series, pictures = self.film(section, **look)
            self.assertEqual(len(pictures), 2)
            camera = str(plotter.camera_position)
            series.show(0)
            self.assertEqual(str(plotter.camera_position), camera)
            for step, picture in enumerate(pictures):
                with tempfile.TemporaryDirectory() as folder:
                    self.addCleanup(section.nephoscope.plot("place", time=step, **{"clim": series.range("place"), **look}, screenshot=folder + "/a.png", window_size=(300, 300)).close)
                    expected = pyvista.read(folder + "/a.png")
                got, expected = (np.asarray(one["PNGImage"], float)[:, :3] for one in (picture, expected))
                self.assertGreater(expected.std(), 20)
                self.assertLess(np.abs(got - expected).mean(), 0.5, step)

    def test_a_film_of_a_section_whose_levels_move(self):
        data = xarray.concat([dataset().assign(height=dataset().height.copy(data=factor * dataset().height.values).assign_attrs(dataset().height.attrs)) for factor in (1, 0.5)], "step")
        _, series, _ = self.film(data.sel(lon=10), heights=True)
        highest = [series[step].bounds[5] for step in range(2)]
        self.assertAlmostEqual(highest[1] / highest[0], 0.5, 4)
        series.show(1)
        self.assertAlmostEqual(series.mesh.bounds[5], highest[1], 4)

    def test_the_ground_below_a_section(self):
        """What lies below it is hidden, without a warning."""
        data = dataset().assign(orog=(("lat", "lon"), np.full((len(LAT), len(LON)), 3000.0), {"units": "m", "standard_name": "surface_altitude"}))
        for section in (data.sel(lon=10), data.sel(lat=10)):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                _, sheet = self.drawn(section)
            np.testing.assert_array_equal(np.asarray(sheet["BelowGround"]) > 0, np.asarray(sheet.points)[:, 2] / np.ptp(sheet.points[:, 2]) * 14 < 2.9)

    def test_across_the_date_line(self):
        data = dataset().assign_coords(lon=("lon", np.arange(150.0, 235, 5), {"units": "degrees_east"})).sel(lat=0)
        _, sheet = self.drawn(data)
        self.assertAlmostEqual(np.ptp(sheet.bounds[:2]), 80, 3)

    def test_an_array_and_a_whole_globe(self):
        self.drawn(dataset().place.sel(lon=0).assign_coords(level=("level", HEIGHTS[::-1] / 20 + 200, {"units": "hPa"})))
        data = dataset().isel(lon=slice(0, 16)).assign_coords(lon=("lon", np.arange(16) * 22.5, {"units": "degrees_east"})).sel(lat=0)
        _, sheet = self.drawn(data)
        self.assertGreater(np.ptp(sheet.bounds[:2]), 337)

    def test_plotters_with_contents_name_the_picture(self):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        plotter.add_text("mine")
        with self.assertRaisesRegex(ValueError, "one level or section: draw it by dataset.nephoscope.plot"):
            nephoscope.animate(plotter, dataset().sel(lon=[0]).expand_dims(time=2), "place")

    def test_options_of_volumes_are_refused(self):
        with self.assertRaisesRegex(ValueError, "opacity_scale: an option of volumes"):
            self.drawn(dataset().sel(lon=0), opacity_scale=2)


if __name__ == "__main__":
    unittest.main()
