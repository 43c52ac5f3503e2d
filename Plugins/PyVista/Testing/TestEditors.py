# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What editors complete is what the functions accept: choices, options given as a dict, earlier names, results of the accessors."""
import ast
import inspect
import re
import typing
import unittest
from dataclasses import fields

import nephoscope
import numpy as np
import pyvista
from nephoscope import _surfaces, _typing, _vectors, splats
from nephoscope.accessor import NephoscopeAccessor
from nephoscope.weather.accessor import WeatherAccessor


def grid():
    data = pyvista.ImageData(dimensions=(3, 3, 3))
    data["a"] = range(27)
    data["v"] = [(1, 0, 0)] * 27
    data.set_active_scalars("a")
    return data


class Editors(unittest.TestCase):
    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        return plotter

    def draw(self, function, **options):
        plotter = self.plotter()
        function(plotter, grid(), "a", **options)
        plotter.screenshot()

    def refused(self, function, **options):
        plotter = self.plotter()
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
            with self.assertRaises(ValueError) as caught:
                nephoscope.add_splats(self.plotter(), grid(), "a", vectors={"array": "v", option: "wrong"})
            self.assertLessEqual({"wrong", *choices}, set(re.findall("'([^']+)'", str(caught.exception))))

    def test_options_of_advection(self):
        parameters = inspect.signature(nephoscope.advect_texture).parameters
        self.assertEqual(_typing.AdvectionOptions.__annotations__.keys(), parameters.keys() - {"mesh", "time"})

    def test_dict_calls(self):
        """Type checkers take dict(array="v"), as in the pages, for a mapping and not for VectorOptions."""
        for function in (nephoscope.add_cells, nephoscope.add_splats):
            for parameter in inspect.signature(function).parameters.values():
                if re.search(r"Options\b", parameter.annotation) and parameter.kind != parameter.VAR_KEYWORD:
                    self.assertIn("Mapping[str, Any]", parameter.annotation, parameter.name)

    def test_arrays(self):
        """Numbers may be in an array wherever they may be in a list."""
        for name in dir(nephoscope):
            if name in nephoscope.PYVISTA_FUNCTIONS:
                for parameter in inspect.signature(getattr(nephoscope, name)).parameters.values():
                    self.assertNotIn("Sequence[float]", str(parameter.annotation), f"{name}: {parameter.name}")
        self.draw(nephoscope.add_cells, clim=np.array([0.0, 20.0]), opacity=np.array([0.0, 1.0]), opacity_scalars="a", opacity_clim=np.array([0.0, 26.0]),
                  contours=dict(values=np.array([5.0, 9.0]), opacity=np.array([0.2, 0.4])), polygons=dict(which="all", opacity=np.array([0.2, 0.4])))
        self.draw(nephoscope.add_splats, vectors=dict(array="v", scalars="a", clim=np.array([0.0, 20.0])))
        nephoscope.add_haze(self.plotter(), color=np.array([0.5, 0.5, 0.5]), center=np.zeros(3), up=np.array([0.0, 0.0, 1.0]), radius=1.0, visibility=2.0,
                            scale_height=0.1, projection="globe")
        mesh = grid()
        smoke = nephoscope.flow_volume([mesh, mesh], vectors="v", center=np.ones(3), radius=0.3, normal=np.array([1.0, 0.0, 0.0]), times=np.array([0.0, 5.0]), time=0.5)
        self.assertGreater(smoke.n_cells, 0)
        self.assertEqual(len(list(nephoscope.advect_texture([mesh, mesh], np.array([0.0, 1.0]), vectors="v", times=np.array([0.0, 5.0])))), 2)
        for function in (nephoscope.split_cells, nephoscope.cloud_surface):
            self.assertGreater(function(mesh, np.array([5.0, 9.0]), "a").n_cells, 0)
            self.assertGreater(function(mesh, 2, "a", rng=np.array([5.0, 9.0])).n_cells, 0)
        mesh["Extinction"] = np.ones(27)
        nephoscope.sunlight(mesh, np.array([0.0, 0.0, 1.0]), eye=np.array([0.0, 0.0, 1.0]), albedo=0.9, asymmetry=0.8)

    def test_earlier_names(self):
        self.assertEqual(set(_typing.OldSplatNames.__annotations__), {"unit_distance", *_vectors.OLD_NAMES, *splats.DETAIL_NAMES})
        self.assertEqual(set(_typing.OldCellNames.__annotations__), {"unit_distance", *_surfaces.CONTOUR_NAMES, *_surfaces.POLYGON_NAMES})

    def test_accessors(self):
        """Type checkers know `.nephoscope` of what these functions return, and follow its methods to the functions."""
        declared = {node.name: [line.annotation.id for line in node.body if isinstance(line, ast.AnnAssign) and line.target.id == "nephoscope"]
                    for node in ast.walk(ast.parse(inspect.getsource(_typing))) if isinstance(node, ast.ClassDef)}
        for accessor, names in (("NephoscopeAccessor", ("read_cf", "to_globe", "smooth", "cloud_optics", "sunlight")), ("WeatherAccessor", ("open",))):
            for name in names:
                self.assertEqual(declared[inspect.signature(getattr(nephoscope, name)).return_annotation], [accessor], name)
        # They know a TypeVar only if it is assigned to one name.
        assigned = [node for node in ast.walk(ast.parse(inspect.getsource(inspect.getmodule(NephoscopeAccessor)))) if isinstance(node, ast.Assign)]
        self.assertEqual({node.value.func.id: type(node.targets[0]) for node in assigned
                          if isinstance(node.value, ast.Call) and getattr(node.value.func, "id", "") in ("ParamSpec", "TypeVar")}, {"ParamSpec": ast.Name, "TypeVar": ast.Name})

    def test_results(self):
        for accessor in (NephoscopeAccessor, WeatherAccessor):
            for name, method in vars(accessor).items():
                if not name.startswith("_"):
                    with self.subTest(accessor=accessor.__name__, method=name):
                        self.assertIn("return", method.__annotations__)
                        self.assertNotIn(method.__annotations__["return"], ("Any", typing.Any))


if __name__ == "__main__":
    unittest.main()
