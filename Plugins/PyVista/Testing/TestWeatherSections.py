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

    def test_the_ground_below_levels_that_follow_it(self):
        """A mountain fills what is below the levels, up to the height that the file has for it; the levels begin above it."""
        ground = 2000 * np.exp(-((LAT / 20) ** 2))
        heights = 10 + ground[:, None] + HEIGHTS[:, None, None] * (1 - ground[:, None] / 14000)
        data = dataset().assign(orog=(("lat", "lon"), np.repeat(ground[:, None], len(LON), axis=1), {"units": "m", "standard_name": "surface_altitude"}),
                                height=(("level", "lat", "lon"), np.repeat(heights, len(LON), axis=2), {"units": "m", "standard_name": "altitude"}))
        for section in (data.sel(lon=10), data.mean("lon", keep_attrs=True)):
            for options in ({}, {"projection": "map"}, {"vertical_exaggeration": 7.0}):
                with self.subTest(**options):
                    plotter, sheet = self.drawn(section, **options)
                    (land,) = [actor.mapper.dataset for actor in plotter.renderer.actors.values() if getattr(getattr(actor, "mapper", None), "dataset", None) is not None
                               and isinstance(actor.mapper.dataset, pyvista.StructuredGrid) and not actor.mapper.dataset.array_names]
                    places, lowest = np.asarray(land.points)[len(LAT):], np.asarray(sheet.points)[: len(LAT)]
                    np.testing.assert_allclose(places[:, 0], LAT, atol=1e-3)
                    unit = np.ptp(lowest[:, 2]) / np.ptp(ground)
                    np.testing.assert_allclose(lowest[:, 2] - places[:, 2], np.minimum(10, ground - ground.min()) * unit, atol=0.5 * unit)
                    self.assertTrue((places[:, 1] < 0).all(), "it is hidden by the section")

    def test_from_pole_to_pole(self):
        """By latitude at any longitude: a pole has none."""
        lat = np.arange(-90.0, 91, 5)
        data = dataset().interp(lat=lat, kwargs={"fill_value": "extrapolate"})
        data = data.assign_coords(lat=("lat", lat, {"units": "degrees_north"}), lon=("lon", LON + 100, {"units": "degrees_east"}))
        for options in ({}, {"projection": "map"}):
            _, sheet = self.drawn(data.sel(lon=90), **options)
            np.testing.assert_allclose(np.unique(np.asarray(sheet.points)[:, 0].round(3)), lat, atol=1e-3)

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

    def labels(self, plotter, letter):
        source = plotter.renderer.actors[f"labels_{letter}-labels"].GetMapper().GetInputAlgorithm()
        source.Update()
        labels = source.GetInputDataObject(0, 0).GetPointData().GetAbstractArray("labels")
        return [labels.GetValue(i) for i in range(labels.GetNumberOfValues())]

    def test_the_sea_floor(self):
        """A seamount that is the same on both sides looks the same on both sides, before land that is seen, with depths in metres, also in a film."""
        latitudes, depths = np.arange(-10, 11.0), np.arange(0, 1001, 100.0)
        salinity = np.where(depths[:, None] <= 100 + np.abs(latitudes) * 90, 35 + depths[:, None] / 1000 + 0 * latitudes, np.nan)
        data = xarray.Dataset({"place": (("depth", "lat"), salinity, {"standard_name": "sea_water_salinity", "units": "1e-3"})},
                              {"depth": ("depth", depths, {"units": "m", "positive": "down"}), "lat": ("lat", latitudes, {"units": "degrees_north"}), "lon": ((), 20.0, {"units": "degrees_east"})})
        plotter, sheet = self.drawn(data)
        places = [np.round(sheet.cell_centers().points * (side, 1, 1), 6) for side in (1, -1)]
        self.assertEqual(*({tuple(place + 0.0) for place in side} for side in places))
        self.assertEqual(len(places[0]), 2 * sum((100 + 90 * side) // 100 for side in range(10)))
        self.assertEqual(self.labels(plotter, "z"), ["-1000", "-800", "-600", "-400", "-200", "0", "m"])
        _, _, films = self.film(xarray.concat([data, data], "time"))
        for picture in (plotter.screenshot(return_img=True), np.asarray(films[1]["PNGImage"])[:, :3].reshape(300, 300, 3)[::-1]):
            colours = {tuple(colour) for colour in picture.reshape(-1, 3)}
            land = tuple(round(255 * part) for part in (0.42, 0.38, 0.34))
            self.assertIn(land, colours)
            rows = [row for row in (picture == land).all(axis=2) if row.any()]
            middles = [np.flatnonzero(row).mean() for row in rows]
            self.assertLess(np.ptp(middles), 2)

    def curvilinear(self):
        """`dataset` with the latitudes turned against the longitudes, on rows y and columns x, and the winds of its rows."""
        data = dataset()
        longitude, latitude = np.meshgrid(LON, LAT)
        attrs = [{"units": "degrees_east", "standard_name": "longitude"}, {"units": "degrees_north", "standard_name": "latitude"}]
        return data.drop_vars(["lon", "lat"]).rename(lat="y", lon="x").assign_coords(lon=(("y", "x"), longitude - 0.2 * latitude, attrs[0]), lat=(("y", "x"), latitude + 0.2 * longitude, attrs[1]))

    def test_rows_and_columns_of_curvilinear_grids(self):
        """They are drawn by the distance on the sphere, from the west or the south."""
        data = self.curvilinear()
        for section, end in ((data.isel(y=12), ["8.0°S 40.0°W", "8.0°N 40.0°E"]), (data.isel(y=[12]), ["8.0°S 40.0°W", "8.0°N 40.0°E"]), (data.isel(y=12, x=slice(None, None, -1)), ["8.0°S 40.0°W", "8.0°N 40.0°E"]),
                             (data.isel(x=8), ["60.0°S 12.0°E", "60.0°N 12.0°W"])):
            for options in ({}, {"projection": "map"}):
                plotter, sheet = self.drawn(section, **options)
                longitude, latitude = (np.radians(np.ravel(section[name])) for name in ("lon", "lat"))
                places = np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)])
                steps = 6371.0 * np.arccos((places[:, 1:] * places[:, :-1]).sum(axis=0))
                self.assertAlmostEqual(np.ptp(sheet.bounds[:2]) / steps.sum(), 1, 4)
                self.assertEqual(self.labels(plotter, "x")[-1], f"km from {end[0]} to {end[1]}")
                self.assertEqual(self.labels(plotter, "z")[-1], "km")
                west = np.asarray(sheet["place"])[np.argmin(sheet.points[:, 0])]
                self.assertAlmostEqual(float(west), (-0.04 if "y" not in section.dims or section.sizes["y"] == 1 else -60), 4)

    def test_longitudes_with_times(self):
        """As WRF has them, where one of the winds is on faces of the cells that have none."""
        data = self.curvilinear().expand_dims(Time=3)
        data = data.assign_coords({name: data[name].expand_dims(Time=3) for name in ("lon", "lat")})
        data["u"] = data.place.pad(x=(0, 1), mode="edge").rename(x="x_stag").assign_attrs(units="m s-1")
        for section, options in ((data.isel(y=12), {"time": 0}), (data.isel(y=12), {"time": -1}), (data.isel(x=8), {"time": 1}), (data.isel(x=8, Time=0), {})):
            plotter, sheet = self.drawn(section, **options)
            self.assertRegex(self.labels(plotter, "x")[-1], "km from .* to ")
        _, sheet = self.drawn(data.isel(y=12), "u", time=0)
        self.assertAlmostEqual(float(np.ptp(sheet["u"])), 0.0775, 5)  # the outermost faces are half a cell away
        self.assertEqual(sheet.n_points, LON.size * HEIGHTS.size)

    def test_a_dimension_too_many(self):
        """The message proposes a dimension that the data have."""
        basins = dataset().mean("lon", keep_attrs=True).expand_dims(basins=3)
        with self.assertRaisesRegex(ValueError, r"dimensions 'basins', 'level', 'lat': .* but it has 'basins', 'lat'. .* ds.isel\(basins=0\)"):
            basins.nephoscope.plot("place")
        self.drawn(basins.isel(basins=0))

    def test_rows_of_rotated_poles(self):
        """With and without longitudes and latitudes in the file; the wind speed is the same."""
        data = dataset().drop_vars(["lon", "lat"]).rename(lat="rlat", lon="rlon").assign_coords(
            rlat=("rlat", LAT / 10, {"standard_name": "grid_latitude", "units": "degrees"}), rlon=("rlon", LON / 10, {"standard_name": "grid_longitude", "units": "degrees"}))
        data["pole"] = ((), 0, {"grid_mapping_name": "rotated_latitude_longitude", "grid_north_pole_latitude": 40.0, "grid_north_pole_longitude": -170.0})
        for name, value, standard in (("ua", 3.0, "grid_eastward_wind"), ("va", 4.0, "grid_northward_wind")):
            data[name] = data.place.copy(data=np.full(data.place.shape, value)).assign_attrs(standard_name=standard, units="m s-1")
        for name in ("place", "ua", "va"):
            data[name].attrs["grid_mapping"] = "pole"
        for section, degrees in ((data.isel(rlat=5), 8.0), (data.isel(rlon=3), 12.0)):
            _, sheet = self.drawn(section)
            self.assertAlmostEqual(np.ptp(sheet.bounds[:2]), np.radians(degrees) * 6371, delta=0.01 * np.radians(degrees) * 6371)
            _, sheet = self.drawn(section, "wind_speed")
            np.testing.assert_allclose(sheet["wind_speed"], 5, rtol=1e-5)

    def test_a_row_is_no_mesh(self):
        with self.assertRaisesRegex(ValueError, r"points of \(x\) lie along a line.*dataset.nephoscope.plot"):
            self.curvilinear().isel(y=12, x=slice(0, 3)).nephoscope.globe()

    def test_options_of_volumes_are_refused(self):
        with self.assertRaisesRegex(ValueError, "opacity_scale: an option of volumes"):
            self.drawn(dataset().sel(lon=0), opacity_scale=2)


if __name__ == "__main__":
    unittest.main()
