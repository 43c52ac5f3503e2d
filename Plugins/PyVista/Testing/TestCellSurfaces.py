# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_cells: contour surfaces and layers reach the mapper, bad ones are named, and they are drawn."""
import unittest

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction


def cube(n=5):
    grid = pyvista.ImageData(dimensions=(n, n, n))
    grid.point_data["x"] = grid.points[:, 0]
    grid.point_data["z"] = grid.points[:, 2]
    grid.cell_data["layer"] = np.arange(grid.n_cells)
    return grid


def opaque_property(color):
    prop = pyvista.VolumeProperty()
    prop.SetColor(vtkColorTransferFunction())
    prop.GetRGBTransferFunction().AddRGBPoint(0, *pyvista.Color(color).float_rgb)
    prop.GetScalarOpacity().RemoveAllPoints()
    prop.GetScalarOpacity().AddPoint(0, 1)
    return prop


class Surfaces(unittest.TestCase):
    def setUp(self):
        self.plotter = pyvista.Plotter(off_screen=True, window_size=(64, 64))
        self.addCleanup(self.plotter.close)

    def add(self, scalars="x", **options):
        return nephoscope.add_cells(self.plotter, cube(), scalars, render=False, show_scalar_bar=False, **options).mapper

    def fails(self, error, pattern, **options):
        with self.assertRaisesRegex(error, pattern):
            self.add(**options)
        self.assertEqual(dict(self.plotter.actors), {}, "a failed call left an actor")

    def test_defaults(self):
        mapper = self.add()
        self.assertEqual(mapper.GetNumberOfContourValues(), 0)
        self.assertTrue(mapper.GetContourLighting())
        self.assertTrue(mapper.GetSmoothContourNormals())
        self.assertFalse(mapper.GetLayersFromContours())

    def test_values(self):
        mapper = self.add(contours=dict(values=[1, 3], opacity=[0.2, 0.9], color=["red", (0.0, 0.0, 1.0)]))
        self.assertEqual([mapper.GetContourValue(i) for i in range(2)], [1, 3])
        self.assertEqual([mapper.GetContourOpacity(i) for i in range(2)], [0.2, 0.9])
        rgb = [0.0] * 3
        mapper.GetContourColor(0, rgb)
        self.assertEqual(rgb, [1, 0, 0])
        mapper = self.add(contours=dict(values=3, scalars="z", lighting=False, smooth=False, color="w"))
        self.assertEqual([mapper.GetContourValue(i) for i in range(3)], [1, 2, 3])
        self.assertEqual(mapper.GetContourArrayName(), "z")
        self.assertFalse(mapper.GetContourLighting() or mapper.GetSmoothContourNormals())
        self.assertEqual(mapper.GetContourOpacity(2), 0.3)

    def test_layers(self):
        prop = pyvista.VolumeProperty()
        mapper = self.add(contours=[1.5], layers={1: prop})
        self.assertIs(mapper.GetLayerProperty(1), prop)
        self.assertTrue(mapper.GetLayersFromContours())
        mapper = self.add(layers={7: prop}, layer_scalars="layer")
        self.assertEqual((mapper.GetLayerArrayName(), mapper.GetLayersFromContours()), ("layer", False))

    def test_colours_of_layers(self):
        """A sequence or a dict of colours, colour maps and properties; the opacities are the volume's, also when its range changes."""
        prop = pyvista.VolumeProperty()
        for layers in (["red", None, "Blues", prop], {0: (1.0, 0.0, 0.0), 2: "Blues", np.int64(3): prop}):
            mapper = self.add(contours=[1, 2, 3], layers=layers)
            self.assertEqual([mapper.GetLayerWithProperty(i) for i in range(mapper.GetNumberOfLayerProperties())], [0, 2, 3])
            red, blues = (mapper.GetLayerProperty(i).GetRGBTransferFunction() for i in (0, 2))
            self.assertEqual([red.GetColor(s) for s in (0, 4)], [(1, 0, 0)] * 2)
            np.testing.assert_allclose([blues.GetColor(s) for s in (0, 4)], pyvista.LookupTable("Blues").values[[0, -1], :3] / 255, atol=0.01)
            self.assertIs(mapper.GetLayerProperty(3), prop)
            mapper.scalar_range = 0, 8
            self.assertAlmostEqual(mapper.GetLayerProperty(0).GetScalarOpacity().GetValue(4), 0.5)

    def test_layers_of_any_size(self):
        """Colours of layers do not hide that the unit distance follows the size of the data: the same picture at any scale."""
        pictures = {}
        for scale in (1e-6, 1.0, 1e5):
            for layers in (["blue", "gold", "red"], {0: opaque_property("blue"), 1: opaque_property("gold"), 2: opaque_property("red")}):
                self.plotter.clear()
                grid = cube()
                grid.origin, grid.spacing = (0.0, 0.0, 0.0), (scale,) * 3
                nephoscope.add_cells(self.plotter, grid, "x", contours=dict(values=[1.3, 2.7], opacity=0), layers=layers, clim=(0, 4), opacity=1.0,
                                     show_scalar_bar=False)
                self.plotter.set_background("black")
                self.plotter.view_xz()
                pictures[scale, isinstance(layers, dict)] = self.plotter.screenshot(return_img=True).astype(int)
        first = pictures[1.0, False]
        self.assertGreater(first[32, 32].sum(), 100)
        for key, picture in pictures.items():
            np.testing.assert_allclose(picture, first, atol=1, err_msg=str(key))

    def test_the_medium_is_thinner_where_contours_are_asked_for(self):
        """10 times, unless something says how opaque it is; a surface in the middle then changes the picture by more than the medium does."""
        table = pyvista.LookupTable("viridis", scalar_range=(0, 4))
        for contours, options, factor in (([1, 3], {}, 10), (dict(values=[1], scalars="z"), {}, 10), (None, {}, 1), ([1], {"opacity": "linear"}, 1), ([1], {"opacity_scale": 0.5}, 1),
                                          ([1], {"opacity_scalars": "z"}, 1), ([1], {"layers": ["red", "blue"]}, 1), ([1], {"cmap": table}, 1), ([1], {"opacity_unit_distance": 2.0}, 1)):
            with self.subTest(contours=contours, **options):
                alone = {k: v for k, v in options.items() if k != "layers"}
                distances = [nephoscope.add_cells(self.plotter, cube(), "x", contours=values, **more).prop.opacity_unit_distance for values, more in ((contours, options), (None, alone))]
                self.assertAlmostEqual(distances[0] / distances[1], factor)

    def bar_of(self, scalars="x", **options):
        """The only scalar bar, and its colours from 0 to 255."""
        self.plotter.clear()
        nephoscope.add_cells(self.plotter, cube(), scalars, **options)
        if not self.plotter.scalar_bars:
            return None, None
        (title, bar), = self.plotter.scalar_bars.items()
        return title, bar

    def test_the_scalar_bar_of_layers(self):
        """It has the colours of the layers at their values, over the range of the volume, or of the array that divides it."""
        title, bar = self.bar_of(contours=[1, 3], layers=["red", None, "lime"])
        table = bar.GetLookupTable()
        self.assertEqual((title, table.GetRange()), ("x", (0, 4)))
        for value, colour in ((0.5, (1, 0, 0)), (3.5, (0, 1, 0)), (2.0, pyvista.LookupTable("viridis", scalar_range=(0, 4)).map_value(2.0)[:3])):
            np.testing.assert_allclose(table.map_value(value)[:3], colour, atol=0.01, err_msg=str(value))
        self.assertAlmostEqual(table.map_value(0.5)[3], 0.125, delta=0.01)  # as opaque as the volume there
        title, bar = self.bar_of(contours=dict(values=[1, 3], scalars="z"), layers=["red", "blue", "lime"])
        self.assertEqual((title, bar.GetLookupTable().GetRange()), ("z", (0, 4)))
        np.testing.assert_allclose(bar.GetLookupTable().map_value(2.0), (0, 0, 1, 1))
        self.assertEqual(self.bar_of(contours=dict(values=[1, 3], scalars="z"), layers=["red", "viridis", "lime"])[0], None)
        self.assertEqual(self.bar_of(contours=dict(values=[1, 3], scalars="z"), layers=["red", None, "lime"])[0], None)
        title, bar = self.bar_of(layers={0: "red", 63: "lime"}, layer_scalars="layer")
        self.assertEqual(title, None)  # 62 layers have the colours of the volume
        title, bar = self.bar_of(layers=["red"] * 63 + ["lime"], layer_scalars="layer")
        self.assertEqual((title, bar.GetLookupTable().GetNumberOfAnnotatedValues()), ("layer", 11))
        np.testing.assert_allclose([bar.GetLookupTable().map_value(value) for value in (62, 63)], [(1, 0, 0, 1), (0, 1, 0, 1)])

    def test_text_of_scalar_bars_can_be_read(self):
        for background, theme, expected in (("black", "document", "white"), ("white", "document", "black"), ("white", "dark", "black"), ("#404040", "document", "white"), ("black", "dark", "white")):
            plotter = pyvista.Plotter(off_screen=True, theme=pyvista.plotting.themes._NATIVE_THEMES[theme].value())
            self.addCleanup(plotter.close)
            plotter.set_background(background)
            nephoscope.add_cells(plotter, cube(), "x", render=False)
            (bar,) = plotter.scalar_bars.values()
            self.assertEqual(bar.GetTitleTextProperty().GetColor(), pyvista.Color(expected).float_rgb, (background, theme))

    def test_polygons(self):
        mapper = self.add()
        self.assertEqual((mapper.GetPolygons(), mapper.GetPolygonOpacity(0)), (mapper.CONTOUR_POLYGONS, 0.3))
        mapper = self.add(polygons=dict(which="all", opacity=[0.2, 0.9], color="red"))
        self.assertEqual([mapper.GetPolygonOpacity(i) for i in range(3)], [0.2, 0.9, 0.3])
        rgb = [0.0] * 3
        mapper.GetPolygonColor(1, rgb)
        self.assertEqual((mapper.GetPolygons(), rgb), (mapper.ALL_POLYGONS, [1, 0, 0]))
        mapper = self.add(polygons=dict(which="none", opacity=0.7, color=["red", None]))
        self.assertEqual([mapper.GetPolygonOpacity(i) for i in range(2)], [0.7, 0.7])
        self.plotter.clear()
        self.fails(ValueError, "polygons", polygons="some")
        self.fails(ValueError, r"polygons\['opacity'\] is 2", polygons=dict(opacity=2))

    def test_errors(self):
        self.fails(ValueError, r"contours\['opacity'\] is 1.5", contours=dict(values=[1], opacity=1.5))
        self.fails(ValueError, r"contours\['opacity'\] has 2 values for 1", contours=dict(values=[1], opacity=[0.1, 0.2]))
        self.fails(ValueError, r"contours\['color'\] has 2 colours for 1", contours=dict(values=[1], color=["red", "blue"]))
        self.fails(ValueError, "1 or more", contours=0)
        self.fails(ValueError, "finite", contours=[np.nan])
        self.fails(ValueError, "but no 'values'", contours=dict(scalars="z"))
        self.fails(MissingDataError, "no point array 'layer'", contours=dict(values=[1], scalars="layer"))
        self.fails(ValueError, "cell array", scalars="layer", contours=[1])
        self.fails(ValueError, "give one of the two", layers={0: pyvista.VolumeProperty()})
        self.fails(ValueError, "without layers", layer_scalars="layer")
        self.fails(MissingDataError, "no cell array 'x'", layers={0: pyvista.VolumeProperty()}, layer_scalars="x")
        self.fails(TypeError, r"layers\[0\] is 'no colour'; it must be a colour", contours=[1], layers={0: "no colour"})
        self.fails(TypeError, r"layers\[1\] is 7; it must be a colour", contours=[1], layers=["red", 7])
        self.fails(TypeError, "layers is 'red'; it must be a sequence", contours=[1], layers="red")
        self.fails(TypeError, "layers is 3; it must be a sequence", contours=[1], layers=3)
        self.fails(TypeError, "key 'low'; keys are the numbers", contours=[1], layers={"low": "red"})
        self.fails(ValueError, "no layer 2; contours at 1 value divide the volume into the layers 0 to 1", contours=[1], layers=["r", "g", "b"])
        self.fails(ValueError, "no layer -1", contours=[1], layers={-1: "red"})

    def test_picture(self):
        self.plotter.set_background("black")
        self.add(contours=dict(values=[1.3, 2.7], scalars="z", opacity=0.5, color=["red", "lime"], lighting=False),
                 opacity=0.0)
        self.plotter.view_xy()
        picture = self.plotter.screenshot(return_img=True)
        np.testing.assert_allclose(picture[32, 32], [64, 128, 0], atol=1)


if __name__ == "__main__":
    unittest.main()
