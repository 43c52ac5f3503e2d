# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What editors complete is what the functions accept: choices, options given as a dict, earlier names, results of the accessors."""
import inspect
import re
import typing
import unittest
from dataclasses import fields

import nephoscope
import pyvista
from nephoscope import _surfaces, _typing, _vectors, splats
from nephoscope.accessor import NephoscopeAccessor
from nephoscope.weather.accessor import WeatherAccessor


def grid():
    data = pyvista.ImageData(dimensions=(3, 3, 3))
    data["a"] = range(27)
    return data


class Editors(unittest.TestCase):
    def refused(self, function, **options):
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        with self.assertRaises(ValueError) as caught:
            function(plotter, grid(), **options)
        return str(caught.exception)

    def test_choices(self):
        for function, names in ((nephoscope.add_cells, ("integration", "order", "method", "tone_mapping")), (nephoscope.add_splats, ("kernel", "tone_mapping"))):
            parameters = inspect.signature(function).parameters
            for name in (*names, "preference"):
                with self.subTest(function=function.__name__, name=name):
                    choices = typing.get_args(getattr(_typing, parameters[name].annotation))
                    self.assertIn(parameters[name].default, choices)
                    self.assertEqual(set(re.findall("'([^']+)'", self.refused(function, **{name: "wrong"}))) - {"wrong"}, set(choices))

    def test_options(self):
        for options, taken in ((_typing.VectorOptions, _vectors.Vectors), (_typing.LevelOfDetailOptions, splats.LevelOfDetail),
                               (_typing.ContourOptions, _surfaces.Contours), (_typing.PolygonOptions, _surfaces.Polygons)):
            self.assertEqual(list(options.__annotations__), [field.name for field in fields(taken)])
        for option in ("style", "placement"):
            choices = typing.get_args(typing.get_type_hints(_typing.VectorOptions)[option])
            mesh = grid()
            mesh["v"] = [(1, 0, 0)] * 27
            plotter = pyvista.Plotter(off_screen=True)
            self.addCleanup(plotter.close)
            with self.assertRaises(ValueError) as caught:
                nephoscope.add_splats(plotter, mesh, "a", vectors={"array": "v", option: "wrong"})
            self.assertLessEqual({"wrong", *choices}, set(re.findall("'([^']+)'", str(caught.exception))))

    def test_earlier_names(self):
        self.assertEqual(set(_typing.OldSplatNames.__annotations__), {"unit_distance", *_vectors.OLD_NAMES, *splats.DETAIL_NAMES})
        self.assertEqual(set(_typing.OldCellNames.__annotations__), {"unit_distance", *_surfaces.CONTOUR_NAMES, *_surfaces.POLYGON_NAMES})

    def test_results(self):
        for accessor in (NephoscopeAccessor, WeatherAccessor):
            for name, method in vars(accessor).items():
                if not name.startswith("_"):
                    with self.subTest(accessor=accessor.__name__, method=name):
                        self.assertIn("return", method.__annotations__)
                        self.assertNotIn(method.__annotations__["return"], ("Any", typing.Any))


if __name__ == "__main__":
    unittest.main()
