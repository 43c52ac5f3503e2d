# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a dataset: on a globe, on a map, of one level; options that the dataset itself answers."""
import contextlib
import tempfile
import unittest
import warnings
from pathlib import Path
from unittest import mock

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import pyvista
import xarray as xr
from nephoscope.weather import ground
from nephoscope.weather.bars import set_title
from nephoscope.weather.look import suited
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from weather_data import isothermal

LON, LAT = np.arange(0, 40, 5.0), np.arange(20, 60, 5.0)


def forecast():
    first = isothermal(LON, LAT)
    return first.assign(cl=(first.ta.dims, 0.5 + 0 * first.ta.values, {"units": "1"}))


class Plots(unittest.TestCase):
    def plotted(self, dataset, name, size=200, **options):
        """The plotter and its picture, which is small unless a test looks for places in it or for the layout of text, which has the size of a real one."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "picture.png")
            plotter = dataset.nephoscope.plot(name, screenshot=str(path), **{"window_size": (size, size), **options})
            self.addCleanup(plotter.close)
            picture = pyvista.read(path)["PNGImage"].reshape(size, size, -1)[..., :3].astype(float)
        return plotter, picture

    def sizes(self, plotter):
        return sorted(actor.GetLength() for actor in plotter.renderer.actors.values() if hasattr(actor, "GetLength") and actor.GetLength())

    def shown(self, plotter, points):
        """Pixels from the lower left of points of the scene, or of a map before degrees of longitude are shortened."""
        points = points * np.array(next(iter(plotter.renderer.actors.values())).GetScale())
        matrix = pyvista.array_from_vtkmatrix(plotter.camera.GetCompositeProjectionTransformMatrix(1, -1, 1))
        seen = np.column_stack([points, np.ones(len(points))]) @ matrix.T
        return 400 + 400 * seen[:, :2] / seen[:, 3:]

    def test_backgrounds_and_themes(self):
        """Text can be read on every background; a theme that is not white is that of the picture."""
        data = forecast()
        for background, text in (("white", "black"), ("#303030", "white"), (None, "white")):
            for dataset in (data, data.isel(plev=0), data.isel(lon=0)):
                plotter, _ = self.plotted(dataset, "ta", background=background)
                (bar,) = plotter.scalar_bars.values()
                self.assertEqual(bar.GetTitleTextProperty().GetColor(), pyvista.Color(text).float_rgb)
                self.assertEqual(plotter.background_color, pyvista.Color(background or "black"))
        old = pyvista.themes.Theme()
        old.load_theme(pyvista.global_theme)
        self.addCleanup(pyvista.global_theme.load_theme, old)
        pyvista.set_plot_theme("paraview")
        plotter, _ = self.plotted(data, "ta")
        self.assertEqual(plotter.background_color, pyvista.themes.ParaViewTheme().background)
        plotter, _ = self.plotted(data, "ta", background="white")
        self.assertEqual(next(iter(plotter.scalar_bars.values())).GetTitleTextProperty().GetColor(), (0, 0, 0))

    def test_contours(self):
        plotter, _ = self.plotted(forecast(), "ta", contours=[250, 260])
        mapper = next(actor.mapper for actor in plotter.renderer.actors.values() if hasattr(getattr(actor, "mapper", None), "GetNumberOfContourValues"))
        self.assertEqual(mapper.GetNumberOfContourValues(), 2)
        with self.assertRaisesRegex(ValueError, "contours: an option of volumes"):
            forecast().isel(plev=0).nephoscope.plot("ta", contours=3, screenshot="never.png")

    def test_a_map_has_the_earth_below(self):
        """Land and sea where they are, seen from above with north up, and the scalar bar below the map."""
        for longitudes in (np.arange(0, 360, 10.0), np.arange(-180, 180, 10.0), LON):
            latitudes = np.arange(-80, 81, 10.0) if len(longitudes) > 10 else LAT
            first = isothermal(longitudes, latitudes)
            dataset = first.assign(cl=(first.ta.dims, 0 * first.ta.values, {"units": "1"}))  # clear
            plotter, picture = self.plotted(dataset, "cl", 800, projection="map")
            for longitude, latitude, is_land in ((20, 25, True), (17.5, 34.5, False), (10, 50, True), (25, 45, True), (32, 43, False)):
                with self.subTest(first=longitudes[0], longitude=longitude, latitude=latitude):
                    (x, y), = self.shown(plotter, np.radians([[longitude, latitude, 0]]) * 6371000)
                    red, _, blue = picture[int(y), int(x)]
                    self.assertEqual(red > blue, is_land)
            bar, = plotter.scalar_bars.values()
            top = 800 * (bar.GetPosition()[1] + bar.GetPosition2()[1])
            corners = self.shown(plotter, plotter.renderer.actors[next(iter(plotter.renderer.actors))].GetMapper().GetInput().points)
            self.assertGreater(corners[:, 1].min(), top)
            self.assertTrue((corners > 0).all() and (corners < 800).all())
            across, up = np.ptp(corners[:, :2], axis=0) / 800
            self.assertAlmostEqual(max(across / (1 - 0.16), up / (1 - 0.26)), 1, 2)  # it fills the picture beside its labels
            degrees = [size / np.ptp(values) for size, values in zip((across, up), ([0, 360], [-90, 90]) if len(longitudes) > 10 else (longitudes, latitudes))]
            self.assertAlmostEqual(degrees[0] / degrees[1], np.cos(np.radians(0.5 * (latitudes[0] + latitudes[-1]))), 2)
            for letter, expected in (("x", {"20°E"} if len(longitudes) < 10 else {"0°", "90°W"}), ("y", {"40°N"} if len(longitudes) < 10 else {"0°", "30°S"})):
                source = plotter.renderer.actors[f"labels_{letter}-labels"].GetMapper().GetInputAlgorithm()
                source.Update()
                labels = source.GetInputDataObject(0, 0).GetPointData().GetAbstractArray("labels")
                self.assertLessEqual(expected, {labels.GetValue(i) for i in range(labels.GetNumberOfValues())})

    def test_in_a_plotter(self):
        """Into a sub-plot as in a plotter of its own, with its labels and its bar; the plotter is not shown, and keeps what is in the other one."""
        data = forecast()
        plotter = pyvista.Plotter(shape=(1, 2), off_screen=True, window_size=(1600, 800), theme=pyvista.themes.DarkTheme(), border=False)
        self.addCleanup(plotter.close)
        kinds = [("cl", {}), ("ta", {"projection": "map"})]
        for index, (name, options) in enumerate(kinds):
            plotter.subplot(0, index)
            self.assertIs(data.nephoscope.plot(name, plotter=plotter, **options), plotter)
        self.assertEqual(plotter.render_window.GetNeverRendered(), 1)
        picture = plotter.screenshot(return_img=True)[::-1].astype(float)
        for index, (name, options) in enumerate(kinds):
            _, alone = self.plotted(data, name, 800, **options)
            self.assertLess(np.abs(picture[:, 800 * index:800 * index + 800] - alone).mean(), 1)
        plotter.subplot(0, 0)
        data.isel(lon=3).nephoscope.plot("ta", plotter=plotter)
        self.assertIn("labels_x-labels", plotter.renderers[0].actors)
        self.assertIn("labels_x_1-labels", plotter.renderers[1].actors)
        for option in ({"window_size": (10, 10)}, {"background": "white"}):
            with self.assertRaisesRegex(TypeError, f"^{next(iter(option))}: .*plotter is given"):
                data.nephoscope.plot("cl", plotter=plotter, **option)

    def test_text_is_readable_in_the_plotter_of_a_user(self):
        """On any background, also where the theme has black text; before a dark globe, dark text has the bright background behind it."""
        data = forecast()
        for background, bright in (("white", True), ("black", False), ("#202030", False)):
            for name, options in (("ta", {}), ("cl", {}), ("ta", {"projection": "map"})):
                plotter = pyvista.Plotter(shape=(1, 2), off_screen=True, window_size=(200, 100))
                self.addCleanup(plotter.close)
                plotter.subplot(0, 1)
                plotter.set_background(background, all_renderers=False)
                data.nephoscope.plot(name, plotter=plotter, **options)
                (bar,) = plotter.scalar_bars.values()
                for prop in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
                    self.assertEqual(prop.GetColor(), (0, 0, 0) if bright else (1, 1, 1))
                    self.assertEqual(prop.GetBackgroundOpacity() > 0.7 and prop.GetBackgroundColor() == (1, 1, 1), bright)
                if options:
                    labels = plotter.renderers[1].actors["labels_x_1-labels"].GetMapper().GetInputAlgorithm().GetTextProperty()
                    self.assertEqual(labels.GetColor(), (0, 0, 0) if bright else (1, 1, 1))

    def test_no_window_if_pyvista_draws_off_screen(self):
        """Without a file for the picture, as with PYVISTA_OFF_SCREEN=true in the environment."""
        level = isothermal(np.arange(0, 360, 30.0), np.arange(-90, 91, 30.0)).isel(plev=1)
        with mock.patch.object(pyvista, "OFF_SCREEN", True):
            plotter = level.nephoscope.plot("ta", window_size=(60, 60))
        self.addCleanup(plotter.close)
        self.assertTrue(plotter.off_screen)

    def test_a_wide_map_has_a_low_window(self):
        level = isothermal(np.arange(0, 360, 10.0), np.arange(-90, 91, 10.0)).isel(plev=1)
        plotter = level.nephoscope.plot("ta", projection="map", screenshot=str(Path(self.enterContext(tempfile.TemporaryDirectory()), "a.png")))
        self.addCleanup(plotter.close)
        across, high = plotter.window_size
        self.assertEqual((across, high), (800, int(800 * 0.5 * 0.84 / 0.74)))
        plotter, _ = self.plotted(level, "ta", 800, projection="map")
        self.assertEqual(tuple(plotter.window_size), (800, 800))

    def test_a_field_on_a_map_has_coasts(self):
        first = isothermal(np.arange(0, 360, 10.0), np.arange(-80, 81, 10.0))
        plotter, picture = self.plotted(first.isel(plev=1), "ta", 800, projection="map")
        coasts = np.asarray(plotter.renderer.actors["coasts"].GetMapper().GetInput().points)
        degrees = np.degrees(coasts / 6371000)
        self.assertLess(np.hypot(*(degrees[:, :2] - (77.5, 8.1)).T).min(), 0.6)  # Cape Comorin
        self.assertGreater(np.hypot(*(degrees[:, :2] - (220, 0)).T).min(), 8)  # the Pacific
        x, y = self.shown(plotter, coasts[::50]).T.astype(int)
        self.assertLess(np.median(picture[y, x].max(axis=1)), 60)  # they are drawn over the field

    @contextlib.contextmanager
    def no_picture_of_the_earth(self):
        cached = (ground.blue_marble, ground.coasts)
        for function in cached:
            function.cache_clear()
        with mock.patch.object(ground, "sample_data", side_effect=FileNotFoundError):
            yield
        for function in cached:
            function.cache_clear()

    def test_without_the_picture_of_the_earth(self):
        with self.no_picture_of_the_earth():
            plotter, _ = self.plotted(forecast().isel(plev=1), "ta", projection="map")
        self.assertEqual(sum(isinstance(actor, pyvista.Actor) and not name.startswith(("scale_", "labels_")) for name, actor in plotter.renderer.actors.items()), 2)  # ground and field

    def test_one_level_is_a_coloured_surface(self):
        level = forecast().isel({forecast().ta.dims[0]: 1})
        plotter, picture = self.plotted(level, "ta")
        self.assertEqual(sum(isinstance(actor, pyvista.Actor) for actor in plotter.renderer.actors.values()), 3)  # the Earth, the field, coasts
        self.assertGreater(np.std(picture), 10)

    def test_one_level_with_nothing_set_and_large_cells(self):
        """It is coloured by its field, and the globe under it is nowhere in front of it: 20 degrees a cell."""
        level = isothermal(np.arange(0, 360, 20.0), np.arange(-80, 81, 20.0)).isel(plev=0)
        level = level[["ta"]].assign(ta=level.ta + 40 * np.sin(np.radians(level.lat)))
        with self.no_picture_of_the_earth():  # it has one colour
            plotter, picture = self.plotted(level, None, 800)
        inside = picture[300:500, 300:500].reshape(-1, 3)
        ground = np.array([0x3d, 0x5a, 0x73]) * 1.0
        self.assertGreater(np.ptp(inside, axis=0).max(), 60)  # colours of a field
        self.assertGreater(np.abs(inside / np.maximum(inside.max(1, keepdims=True), 1) - ground / ground.max()).max(1).min(), 0.02)
        self.assertEqual([bar.GetOrientation() for bar in plotter.scalar_bars.values()], [1])  # upright, beside the globe
        self.assertEqual([plotter.scalar_bars[name].GetPosition()[0] > 0.88 for name in plotter.scalar_bars.keys()], [True])
        self.assertEqual([bar.GetPosition()[0] * 800 + 20 + 9 * 6.5 < 800 for bar in plotter.scalar_bars.values()], [True])  # room for a label such as -1.66e+04

    def test_one_level_without_a_value(self):
        level = forecast().isel({forecast().ta.dims[0]: 1})[["ta"]]
        with self.assertRaisesRegex(ValueError, "the array 'ta' has no finite value"):
            self.plotted(level * np.nan, None)

    def test_the_scalar_bar_tells_the_field_and_its_units(self):
        dataset = forecast()
        dataset["ta"].attrs["long_name"] = "Temperature of the air"
        dataset["cl"].attrs["long_name"] = "derived by a formula that is described here at length"
        for name, options, text in (("ta", {}, "Temperature of\nthe air\n[K]\nlowest level"), ("ta", {"projection": "map"}, "Temperature of the air [K], lowest level\n "), ("cl", {}, "cl"), ("potential_temperature", {}, "Potential\ntemperature\n[K]\nlowest level")):
            with self.subTest(name, **options):
                plotter, _ = self.plotted(dataset, name, 800, clim=(200, 300), **options)
                (key, bar), = plotter.scalar_bars.items()
                self.assertEqual((key, bar.GetTitle()), (name, text))
                self.assertEqual(bar.GetLookupTable().GetTableRange(), (200, 300))

    def test_titles_end_lines_after_words(self):
        bar = vtkScalarBarActor()
        bar.SetOrientationToVertical()
        for text, lines in (("relative_humidity [1]", ["relative_", "humidity", "[1]"]), ("Convective available potential energy [J]", ["Convective", "available", "potential", "energy", "[J]"]),
                            ("Evapotranspiration", ["Evapotranspiration"]), ("a_b_c", ["a_b_c"]), ("x" * 28, ["x" * 14] * 2), ("tas\nlowest level", ["tas", "lowest level"])):
            set_title(bar, text)
            self.assertEqual(bar.GetTitle().split("\n"), lines)

    def test_a_surface_has_the_colours_of_its_quantity(self):
        """By standard name, long name, role or units: signed quantities are symmetric about 0, clouds let the Earth through, and cmap wins."""
        lon, lat = np.meshgrid(np.arange(0, 360, 20.0), np.arange(-80, 81, 20.0))
        wave = np.cos(np.radians(2 * lon)) * np.cos(np.radians(lat))
        names = {"air2": (280 + 20 * wave, {"units": "K"}, "temperature"), "vor": (1e-5 * (wave + 0.5), {"long_name": "Vorticity (relative)", "units": "s**-1"}, "wind component"),
                 "east": (10 * wave, {"standard_name": "eastward_wind", "units": "m s-1"}, "wind component"), "speed": (10 * wave ** 2 + 2, {"long_name": "10 metre wind speed"}, "wind speed"),
                 "total": (np.clip(wave, 0, 1), {"long_name": "Total cloud cover", "units": "(0 - 1)"}, "clouds"), "rainfall": (np.clip(wave, 0, 1), {"description": "ACCUMULATED PRECIPITATION"}, "rain"),
                 "msl": (101325 + 1000 * wave, {"long_name": "Mean sea level pressure", "units": "Pa"}, None)}
        dataset = xr.Dataset({name: (("lat", "lon"), values, attrs) for name, (values, attrs, _) in names.items()}, {"lat": lat[:, 0], "lon": lon[0]})
        for name, (values, _, preset) in names.items():
            with self.subTest(name):
                self.assertEqual(suited(dataset, name), preset)
                table = self.table(dataset, name)
                low, high = table.scalar_range
                if preset in ("wind component", "wind speed"):
                    self.assertAlmostEqual(low, -high if preset == "wind component" else 0)
                colours = np.asarray(table.values)
                self.assertEqual((colours[0, 3], colours[-1, 3]), (0 if preset in ("clouds", "rain") else 255, 255))
                if preset == "clouds":
                    self.assertTrue((colours[:, :3] == 255).all())
                viridis = pyvista.LookupTable("viridis").values[:, :3]
                self.assertEqual(np.abs(colours[[0, -1], :3].astype(int) - viridis[[0, -1]]).max() < 3, preset is None)
        for name in ("air2", "total"):
            colours = np.asarray(self.table(dataset, name, cmap="plasma").values)
            np.testing.assert_allclose(colours, pyvista.LookupTable("plasma").values, atol=1)

    def table(self, dataset, name, **options):
        plotter, _ = self.plotted(dataset, name, **options)
        return next(bar.GetLookupTable() for bar in plotter.scalar_bars.values())

    def test_a_volume_of_an_unusual_name(self):
        dataset = forecast().assign(east=forecast().ta.assign_attrs(standard_name="eastward_wind", units="m s-1") - 240)
        dataset["east"].attrs = {"standard_name": "eastward_wind", "units": "m s-1"}
        plotter, _ = self.plotted(dataset, "east")
        (bar,) = plotter.scalar_bars.values()
        self.assertEqual(bar.GetLookupTable().GetTableRange(), (-10, 10))

    def test_clouds_in_the_sun(self):
        """On a globe, the side towards the sun is bright: the camera sees +x on the right. The water is found by its standard name."""
        cloudy = isothermal(np.arange(0, 360, 20.0), np.arange(-80, 81, 20.0))
        cloudy["wet"] = cloudy.ta.dims, np.full(cloudy.ta.shape, 1e-4), {"units": "kg kg-1", "standard_name": "mass_fraction_of_cloud_liquid_water_in_air"}
        for direction, brighter in (((1, 0, 0), 1), ((-1, 0, 0), -1)):
            _, picture = self.plotted(cloudy, None, sun=direction, view=(-73, 18))
            left, right = (1 + half.mean() for half in np.split(picture[38:162], 2, axis=1))
            self.assertGreater((right / left) ** brighter, 2)
        for options in ({"sun": True}, {"sun": True, "projection": "map"}, {"sun": "2020-06-21 12:00", "projection": "map"}):
            with self.subTest(options):
                plotter, picture = self.plotted(cloudy.sel(lon=slice(0, 60)), None, **options)
                self.assertGreater(picture.max(), 120)
                self.assertEqual(len(plotter.scalar_bars), 0)
        with self.assertRaisesRegex(ValueError, "sun: an option of volumes, but this grid is one level"):
            self.plotted(cloudy.isel(plev=1), None, sun=True)
        with self.assertRaisesRegex(RuntimeError, "Cloud|water"):
            self.plotted(forecast().drop_vars("cl"), None, sun=True)

    def test_missing_values_are_hidden_without_a_warning(self):
        """The 4 points of each level, of a volume; the 9 cells around them, of a level, which are left out."""
        dataset = forecast()
        dataset["cl"].values[:, 2:4, 2:4] = np.nan
        for data, name in ((dataset, "cl"), (dataset.isel(plev=1), "cl")):
            with warnings.catch_warnings():
                warnings.filterwarnings("error", ".*not finite there")
                plotter, _ = self.plotted(data, name, opacity=1.0)
            grids = [pyvista.wrap(actor.GetMapper().GetInputDataObject(0, 0)) for actor in plotter.renderer.actors.values() if hasattr(actor, "GetMapper") and actor.GetMapper()]
            (drawn,) = [grid for grid in grids if grid is not None and name in grid.point_data]
            if data is dataset:
                self.assertEqual(int((np.asarray(drawn.point_data["vtkGhostType"]) & 2 != 0).sum()), 16)
            else:
                self.assertTrue(np.isfinite(drawn.point_data[name]).all())
                self.assertEqual(drawn.n_cells, (len(LON) - 1) * (len(LAT) - 1) - 9)

    def test_unknown_options(self):
        for options, words in (({"vert_exag": 3}, r"plot\(\) has no option 'vert_exag'. Did you mean 'vertical_exaggeration'"), ({"polygons": "all"}, r"'polygons'. It is an option of add_cells: .*polygons=\.\.\."),
                               ({"zzz": 1}, "'zzz'. It takes 'time', .* the options of nephoscope.to_globe")):
            with self.subTest(options), self.assertRaisesRegex(TypeError, words):
                forecast().nephoscope.plot(screenshot="none.png", **options)
        with self.assertRaisesRegex(TypeError, r"^globe\(\) has no option 'exaggeration'. Did you mean 'vertical_exaggeration'"):
            forecast().nephoscope.globe(exaggeration=3)

    def test_vectors_need_a_name(self):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        wind = forecast().cl.assign_attrs(units="m/s")
        grid = forecast().assign(u=wind, v=wind).nephoscope.globe()
        with self.assertRaisesRegex(TypeError, "vectors is True; it must be the name of an array.*Arrays of vectors: 'Wind', 'DisplayVelocity'"):
            nephoscope.add_splats(plotter, grid, "cl", vectors=True)

    def test_a_field_of_one_level_beside_others_with_levels(self):
        """It is drawn as where it is alone."""
        both = forecast()
        level = both.ta.isel(plev=0, drop=True) + np.arange(len(LON)) * xr.ones_like(both.ta.isel(plev=0, drop=True))
        both = both.assign(tas=level.assign_attrs(units="K"))
        _, beside = self.plotted(both, "tas")
        _, alone = self.plotted(both[["tas"]], "tas")
        self.assertGreater(beside.std(), 10)
        np.testing.assert_array_equal(beside, alone)
        _, with_levels = self.plotted(both, "ta")
        self.assertGreater(abs(with_levels - beside).max(), 50)

    def test_a_field_of_one_level_beside_two_axes(self):
        """Variables on levels of either axis, half levels or other pressures, are left out; cells and other fields of one level stay."""
        both = forecast()
        level = (both.ta.isel(plev=0, drop=True) + np.arange(len(LON)) * xr.ones_like(both.ta.isel(plev=0, drop=True))).assign_attrs(units="K")
        more = both.ta.isel(plev=slice(2)).rename(plev="lev2").rename("shum")
        both = both.expand_dims(time=3).assign(tas=level.expand_dims(time=3), shum=more, w=both.ta.pad(plev=(0, 1), mode="edge").rename(plev="plev_stag").drop_vars("plev_stag"))
        _, beside = self.plotted(both, "tas", time=-1)
        _, alone = self.plotted(both[["tas"]], "tas", time=-1)
        self.assertGreater(beside.std(), 10)
        np.testing.assert_array_equal(beside, alone)

    def test_names_that_are_computed_or_no_fields(self):
        """WRF's T becomes theta; longitudes place the fields."""
        from TestWeatherHeights import Models
        data = Models().wrf()[0]
        with self.assertWarnsRegex(UserWarning, r"'T' is drawn as 'theta', which is T \+ 300 of the file"):
            plotter, _ = self.plotted(data, "T")
        self.assertEqual(list(plotter.scalar_bars.keys()), ["theta"])
        with self.assertRaisesRegex(ValueError, r"variables: 'P' not on the grid. 'P' of the file has become 'air_pressure', P \+ PB"):
            data.nephoscope.globe(variables=["P"])
        for dataset, name in ((data, "XLONG"), (data[["XLONG", "XLAT", "HGT"]].reset_coords(), "XLAT")):
            with self.assertRaisesRegex(ValueError, rf"'{name}' tells where the points or cells are; it is not a field. To draw it, copy its values: ds.assign\(copy=.*\['{name}'\].data"):
                dataset.nephoscope.plot(name)

    def test_temperature_is_drawn_at_the_ground(self):
        """In the lowest point of each column that is above it; as a volume where one is asked for, and other fields always."""
        lon, lat, pressures = np.linspace(0, 30, 7), np.linspace(10, 40, 6), np.array([100000.0, 85000, 50000])
        data = isothermal(lon, lat, pressures)
        mountain = np.broadcast_to(np.where(lon > 12, 2000.0, 0.0), (6, 7))
        data = data.assign(ta=data.ta.copy(data=np.broadcast_to(250 + np.arange(3.0)[:, None, None], data.ta.shape)).assign_attrs(data.ta.attrs), ps=data.ps.copy(data=np.where(mountain > 0, 80000.0, 102000.0)).assign_attrs(data.ps.attrs))
        for options in ({}, {"projection": "map"}):
            plotter, _ = self.plotted(data, "ta", **options)
            sheet = next(actor.mapper.dataset for actor in plotter.renderer.actors.values() if "ta" in getattr(getattr(actor.mapper, "dataset", None), "array_names", ()))
            np.testing.assert_array_equal(np.asarray(sheet["ta"]).reshape(6, 7), np.where(mountain > 0, 252, 250))
            heights = sheet.points[:, 2] if options else np.linalg.norm(sheet.points, axis=1) - 6371000
            np.testing.assert_allclose(heights, 0, atol=1)
            (bar,) = plotter.scalar_bars.values()
            self.assertIn("lowest level", bar.GetTitle())
        for name, options in (("ta", {"opacity": "linear"}), ("ta", {"contours": [251]}), ("ps3", {})):
            plotter, _ = self.plotted(data.assign(ps3=data.ta.assign_attrs(standard_name="air_pressure_anomaly", units="1")), name, **options)
            self.assertEqual(plotter.renderer.GetVolumes().GetNumberOfItems(), 1)

    def test_warnings_name_the_line_of_the_user(self):
        times = xr.concat([forecast(), forecast()], "time").assign_coords(time=np.array(["2020-01-01", "2020-01-02"], "M8[ns]"))
        for dataset in (times, times.isel(plev=0)):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                self.plotted(dataset, "ta")
            (told,) = [one for one in told if "the first was taken" in str(one.message)]
            self.assertEqual(Path(told.filename).name, Path(__file__).name)

    def test_a_description_of_what_is_not_recognized(self):
        for renamed, words in (({"lat": "y", "lon": "x"}, "length along x"), ({"plev": "k"}, "k")):
            dataset = forecast().rename(renamed)
            for name in renamed.values():
                dataset[name].attrs.clear()
            dataset = dataset.drop_vars("k") if "k" in dataset.coords else dataset
            with self.subTest(renamed):
                text = dataset.nephoscope.describe()
                self.assertRegex(text.splitlines()[0], f"not recognized: .*{words}")
                self.assertIn("variable 'ta': ", text)
                self.assertIn("units 'K'", text)

    def test_names_that_are_no_strings(self):
        """xarray allows tuples and numbers as names."""
        data = forecast()
        data = data.rename({"ta": ("t", 850), "cl": 5})
        for name, shown in ((("t", 850), "t_850"), ("t_850", "t_850"), (5, "5")):
            plotter, _ = self.plotted(data, name)
            self.assertEqual(list(plotter.scalar_bars.keys()), [shown])
        self.assertIn("temperature: 't_850'", data.nephoscope.describe())
        self.assertIn("t_850", data.nephoscope.globe(variables=[("t", 850)]).point_data)
        self.assertIn("t_850", data[("t", 850)].nephoscope.globe().point_data)
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        with nephoscope.animate(plotter, data, ("t", 850)) as series:
            self.assertIn("t_850", series.mesh.array_names)

    def test_rain_that_is_nowhere(self):
        """It is transparent, with a warning; `opacity` makes it visible. Precipitation is recognised by its short names."""
        lon, lat = np.arange(0, 360, 20.0), np.arange(-80, 81, 20.0)
        for name, attrs, high in (("pop", {"units": "%", "long_name": "Probability of precipitation"}, 1), ("tp", {"units": "m"}, 1), ("tcc", {"units": "1"}, 1)):
            level = xr.Dataset({name: (("lat", "lon"), np.zeros((len(lat), len(lon))), attrs)}, {"lat": ("lat", lat, {"units": "degrees_north"}), "lon": ("lon", lon, {"units": "degrees_east"})})
            with self.assertWarnsRegex(UserWarning, f"Nothing will be visible: the array '{name}' is 0 everywhere, where its colours are transparent"):
                self.assertEqual(self.table(level, name).scalar_range, (0, high))
            with warnings.catch_warnings():
                warnings.simplefilter("error", UserWarning)
                self.table(level, name, opacity=1.0)
                self.table(level + 0.5, name)
        level = level.rename(tcc="cape")
        self.assertEqual(self.table(level + 20, "cape").scalar_range, (19.5, 20.5))

    def test_what_the_dataset_answers(self):
        for option in ({"height": "z"}, {"height_units": "m"}, {"level_units": "hPa"}):
            with self.subTest(option), self.assertRaisesRegex(TypeError, f"globe.. takes {next(iter(option))} from the variables"):
                forecast().nephoscope.globe(**option)


if __name__ == "__main__":
    unittest.main()
