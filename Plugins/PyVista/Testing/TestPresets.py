# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""First pictures of fields of the weather: colours, opacities, ranges and density by their names, where nothing is set."""
import json
import os
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from nephoscope import _fields

WHITE, BLUE = (1.0, 1.0, 1.0), (0.15, 0.35, 0.8)


def box(n=9, scale=1.0, **arrays):
    grid = pyvista.ImageData(dimensions=(n, n, n), spacing=(scale / (n - 1),) * 3)
    for name, values in arrays.items():
        grid.point_data[name] = np.resize(values, grid.n_points)
    return grid


def ramp(low, high, n=9):
    return np.linspace(low, high, n ** 3)


class Names(unittest.TestCase):
    def test_by_standard_and_short_names(self):
        for name, preset in (("cloud_fraction", "clouds"), ("cloud_area_fraction_in_atmosphere_layer", "clouds"), ("clouds", "clouds"),
                             ("CLDFRA", "clouds"), ("clwmr", "cloud water"), ("QCLOUD", "cloud water"), ("clwc", "cloud water"),
                             ("air_temperature", "temperature"), ("TMP", "temperature"), ("eastward_wind", "wind component"),
                             ("wind_speed", "wind speed"), ("specific_humidity", "humidity"), ("QRAIN", "rain"), ("SmokeDensity", "smoke")):
            self.assertEqual(_fields.preset_of_field(name).name, preset, name)
        for name in ("RTData", "x", "Height", "pressure", "values", "", "p", "u", "v", "w", "t", "T", "q", "U", "cc", "Density", "omega"):
            self.assertIsNone(_fields.preset_of_field(name, box(**{name or "a": [1.0]})), name)

    def test_short_names_count_in_data_of_the_weather(self):
        """Globe Grid marks its data, and the reader of NetCDF files notes the units of every array."""
        for name, preset in (("t", "temperature"), ("T", "temperature"), ("u", "wind component"), ("cc", "clouds"), ("q", "humidity")):
            for mark in ("GlobeGridProjection", f"{name}_units"):
                grid = box(**{name: [1.0]})
                grid.field_data[mark] = [0]
                self.assertEqual(_fields.preset_of_field(name, grid).name, preset, (name, mark))
        read = nephoscope.read_cf(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))
        self.assertEqual(_fields.preset_of_field("t", read).name, "temperature")

    def test_file_is_what_paraview_reads(self):
        entries = json.loads((Path(_fields.__file__).parent / "nephoscope_presets.json").read_text())
        names = [array for entry in entries for array in entry["NephoscopeArrays"]]
        self.assertEqual(len(names), len(set(names)), "an array of two presets")
        for entry in filter(lambda entry: "NephoscopeName" in entry, entries):
            for key, width in (("RGBPoints", 4), ("Points", 4)):
                points = np.reshape(entry[key], (-1, width))
                self.assertTrue((np.diff(points[:, 0]) > 0).all() and points[0, 0] == 0 and points[-1, 0] == 1, entry["Name"])
                self.assertTrue((points[:, 1:] >= 0).all() and (points[:, 1:] <= 1).all())

    def test_terrain_is_in_metres(self):
        """The one preset with a range of its own: the sea below 0, the coast a jump."""
        (low, high), colours = _fields.terrain_preset(6101)
        self.assertEqual((low, high, len(colours)), (-100, 6000, 6101))
        sea, land = (np.array(pyvista.Color(colours[100 + step]).float_rgb) for step in (-1, 1))
        self.assertGreater(sea[2], sea[1])
        self.assertGreater(land[1], land[2])


class Applied(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(40, 40))
        self.plotter.set_background("black")
        self.addCleanup(self.plotter.close)

    def add(self, grid, *args, add=nephoscope.add_cells, **options):
        return add(self.plotter, grid, *args, show_scalar_bar=False, **options)

    def test_clouds_are_white_and_seen(self):
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            volume = self.add(box(cloud_fraction=ramp(0, 0.7)), "cloud_fraction", add=add)
            self.assertEqual(volume.mapper.scalar_range, (0.0, 1.0))
            np.testing.assert_allclose(volume.prop.GetRGBTransferFunction().GetColor(1.0), WHITE, atol=0.01)
            self.assertEqual(volume.prop.GetScalarOpacity().GetValue(0.04), 0)
            self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(1.0), 1)

    def test_ranges(self):
        for name, low, high, expected in (("cloud_cover", 0, 0.4, (0, 1)), ("cloud_cover", 0, 87.0, (0, 100)), ("clwmr", 0, 3e-4, (0, 3e-4)),
                                          ("x_wind", -20.0, 50.0, (-50, 50)), ("temp", 200.0, 310.0, (200, 310)), ("wind_speed", 2.0, 60, (0, 60)),
                                          ("cloud_cover", 0, 0, (0, 1)), ("values", 3, 5, (3, 5))):
            volume = self.add(box(**{name: ramp(low, high)}), name)
            np.testing.assert_allclose(volume.mapper.scalar_range, expected, err_msg=name)

    def test_what_thins_fades(self):
        """In limits of the user's the unit distance does not follow the values; without, it does."""
        values = np.exp(-4 * np.linalg.norm(box(9).points - 0.5, axis=1))
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            distances = [self.add(box(9, s=factor * values), "s", add=add, clim=(0, 1)).prop.opacity_unit_distance for factor in (1, 0.1, 0.01)]
            np.testing.assert_allclose(distances, distances[0], rtol=1e-9)
            alone = [self.add(box(9, s=factor * values), "s", add=add).prop.opacity_unit_distance for factor in (1, 0.1)]
            np.testing.assert_allclose(alone, alone[0], rtol=1e-9)  # limits and values are scaled alike
            np.testing.assert_allclose(distances[0], alone[0], rtol=1e-9)

    def test_spikes_do_not_pale_the_rest(self):
        """Symmetric ranges: a peak of any width keeps its height, and 3 of 4096 values a hundred times the rest do not set the range."""
        away = np.linalg.norm(box(17).points - 0.5, axis=1)
        for width in (0.1, 0.2, 0.4):
            peak = 7 * np.exp(-(away / width) ** 2)
            np.testing.assert_allclose(self.add(box(17, vorticity=peak), "vorticity").mapper.scalar_range, (-7, 7), rtol=1e-6)
        waves = np.sin(20 * box(17).points[:, 0])
        waves[[100, 2000, 4000]] = 100, -100, 100
        low, high = self.add(box(17, vorticity=waves), "vorticity").mapper.scalar_range
        self.assertEqual(low, -high)
        self.assertTrue(1 < high < 40, high)

    def test_mean_optical_depth_whatever_the_scale(self):
        """A cube of any size, with clouds in a part of it, which is paler where it is small: rays through the cloud then have a mean of 4."""
        away = np.linalg.norm(box(17).points - 0.45, axis=1)
        for scale in (1e-3, 1.0, 1e7):
            for width in (0.2, 0.5, 10.0):
                values = 0.8 * np.exp(-(away / width) ** 2)
                grid = box(17, scale, cloud=values)
                for data in (grid, grid.cast_to_unstructured_grid(), grid.cast_to_structured_grid()):
                    distance = self.add(data, "cloud").prop.opacity_unit_distance
                    cells = grid.point_data_to_cell_data()["cloud"]  # opacity is linear from 0.05, and 0 below: by points, not means
                    opacity = box(17, scale, o=np.clip((values - 0.05) / 0.95, 0, 1)).point_data_to_cell_data()["o"]
                    self.assertEqual(len(cells), 4096)
                    columns = np.reshape(opacity, (16, 16, 16)).mean(axis=0)
                    expected = min(2.0, 4.0 * columns.mean() ** 2 / (columns ** 2).mean())
                    depth = opacity.mean() * scale ** 3 / (1.5 * scale ** 2) / distance  # Cauchy: a quarter of the cube's surface
                    self.assertAlmostEqual(depth, expected, delta=0.02, msg=(scale, width, type(data)))

    def test_a_clear_sky_is_clear(self):
        """No cloud anywhere is not a cloud everywhere."""
        with self.assertWarnsRegex(UserWarning, "[Nn]othing"):
            volume = self.add(box(cloud=np.zeros(9 ** 3)), "cloud")
        self.assertEqual(volume.mapper.scalar_range, (0, 1))
        self.assertEqual(volume.prop.GetScalarOpacity().GetValue(0.0), 0)

    def test_hidden_cells_do_not_count(self):
        grid = box(cloud=np.ones(9 ** 3)).cast_to_structured_grid()
        whole = self.add(grid, "cloud").prop.opacity_unit_distance
        ghosts = np.zeros((8, 8, 8), np.uint8)
        ghosts[2:6] = 32  # inside: the bounds stay
        grid.cell_data["vtkGhostType"] = ghosts.ravel()
        self.assertAlmostEqual(self.add(grid, "cloud").prop.opacity_unit_distance, whole / 2)

    def test_on_bright_backgrounds_clouds_are_grey(self):
        self.plotter.set_background("white")
        self.assertLess(max(self.add(box(cloud=ramp(0, 1)), "cloud").prop.GetRGBTransferFunction().GetColor(1.0)), 0.6)

    def test_what_the_user_sets_stays(self):
        grid = box(cloud=ramp(0, 0.7))
        usual = 2 / 3 * 0.5 / 2  # mean chord of the cube and mean of the ramp for a mean optical depth of 2
        volume = self.add(grid, "cloud", cmap=["red", "red"])
        self.assertEqual(volume.prop.GetRGBTransferFunction().GetColor(0.3), (1, 0, 0))
        np.testing.assert_allclose((*volume.mapper.scalar_range, volume.prop.opacity_unit_distance), (0, 0.7, usual), rtol=1e-6)
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(0.35), 0.5, 3)
        volume = self.add(grid, "cloud", opacity="linear")
        np.testing.assert_allclose(volume.prop.GetRGBTransferFunction().GetColor(1.0), WHITE, atol=0.01)
        self.assertAlmostEqual(volume.prop.opacity_unit_distance, 0.7 * usual)  # the range is 0 to 1
        self.assertEqual(self.add(grid, "cloud", clim=(0.2, 0.5)).mapper.scalar_range, (0.2, 0.5))
        self.assertEqual(self.add(grid, "cloud", opacity_unit_distance=3.0).prop.opacity_unit_distance, 3.0)
        self.assertAlmostEqual(self.add(grid, "cloud", preset=False).prop.opacity_unit_distance, usual)
        self.assertGreater(self.add(grid, "cloud", log_scale=True).prop.opacity_unit_distance, usual)  # more of it is opaque
        volume = self.add(grid, "cloud", preset="wind component", cmap=["red", "red"])
        np.testing.assert_allclose(volume.mapper.scalar_range, (-0.7, 0.7))
        self.assertEqual(volume.prop.GetRGBTransferFunction().GetColor(0.3), (1, 0, 0))

    def test_a_changed_theme_counts(self):
        self.plotter.theme.cmap = "plasma"
        volume = self.add(box(cloud=ramp(0, 0.7)), "cloud")
        self.assertGreater(abs(volume.prop.GetRGBTransferFunction().GetColor(0.7)[2] - 1), 0.5)

    def test_by_name(self):
        volume = self.add(box(values=ramp(0, 0.7)), "values", cmap="wind component")
        np.testing.assert_allclose(volume.prop.GetRGBTransferFunction().GetColor(0.0), BLUE, atol=0.01)
        self.assertEqual(volume.mapper.scalar_range, (0.0, 0.7))
        volume = self.add(box(values=ramp(0, 0.7)), "values", preset="clouds")
        self.assertEqual(volume.mapper.scalar_range, (0.0, 1.0))
        with self.assertRaisesRegex(ValueError, "preset is 'cloudz'; .*'clouds', 'cloud water'"):
            self.add(box(values=ramp(0, 1)), "values", preset="cloudz")

    def test_values_that_are_not_numbers(self):
        values = ramp(0, 0.7)
        values[::5] = np.nan
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertTrue(np.isfinite(self.add(box(cloud=values), "cloud").prop.opacity_unit_distance))


class OldName(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(40, 40))
        self.addCleanup(self.plotter.close)

    def test_unit_distance(self):
        grid = box(values=ramp(0, 1))
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            with self.assertWarnsRegex(DeprecationWarning, "unit_distance is now called opacity_unit_distance") as caught:
                volume = add(self.plotter, grid, "values", unit_distance=0.25)
            self.assertEqual(Path(caught.filename).name, Path(__file__).name)
            self.assertEqual(volume.prop.opacity_unit_distance, 0.25)
            with self.assertRaisesRegex(ValueError, "both given"):
                add(self.plotter, grid, "values", unit_distance=1.0, opacity_unit_distance=1.0)


class Frames(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(40, 40))
        self.addCleanup(self.plotter.close)

    def weather(self, west=0.0, cell=1.0, **options):
        flat = pyvista.RectilinearGrid(west + np.arange(0, 360, cell), np.linspace(-90, 90, 1 + int(180 / cell)), [0.0, 9000.0])
        flat["q"] = np.linspace(0, 1, flat.n_points)
        return flat.nephoscope.globe(level_units="m", **options)

    def told(self, surface, data):
        self.plotter.clear()
        self.plotter.add_mesh(surface)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            nephoscope.add_cells(self.plotter, data, "q", show_scalar_bar=False)
        return [str(w.message) for w in caught if w.category is RuntimeWarning]

    def test_what_fits_says_nothing(self):
        for options in ({}, {"projection": "map", "central_meridian": 180.0}):
            self.assertEqual(self.told(nephoscope.globe_surface(**options), self.weather(**options)), [])
        self.assertEqual(self.told(nephoscope.globe_surface(projection="map"), self.weather(-180.0, projection="map")), [])
        self.assertEqual(self.told(pyvista.Sphere(), self.weather()), [])
        coarse = self.weather(cell=5.0)
        self.assertEqual(self.told(nephoscope.globe_surface(below=coarse), coarse), [])
        self.assertEqual(self.told(nephoscope.globe_surface(), self.weather(cell=5.0, vertical_exaggeration=20.0)), [])

    def test_what_does_not_fit(self):
        for surface, data, text in (({"projection": "map"}, {"projection": "map"}, "longitudes 0 to 360, the other -180 to 180"),
                                    ({"projection": "map"}, {}, "same projection"), ({"radius": 1.0}, {}, "same radius")):
            messages = self.told(nephoscope.globe_surface(**surface), self.weather(**data))
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(text, messages[0])
        messages = self.told(nephoscope.globe_surface(), self.weather(cell=5.0))
        self.assertRegex(" ".join(messages), r"flat: their middles lie up to 12 km below .* 9 km high\. .*globe_surface\(below=")
        messages = self.told(self.weather(vertical_exaggeration=20.0), self.weather(vertical_exaggeration=50.0))
        self.assertIn("same vertical_exaggeration", " ".join(messages))


if __name__ == "__main__":
    unittest.main()
