# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What can be set in VTK can be set in ParaView and in PyVista too, but for what a table below tells, with the reason."""
import contextlib
import dataclasses
import importlib
import inspect
import os
import re
import tempfile
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from nephoscope import _surfaces, _vectors, splats
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

TOP = Path(os.environ["NEPHOSCOPE_DATA"]).parent
PARAVIEW = TOP / "Plugins/ParaView"

# Class, the definitions of its proxies, and the modules of Python that set it. A new property of a class needs no line here.
CLASSES = {
    "vtkGlobeGrid": (["Globe.xml.in", "GlobeProperties.xml.in"], ["globe"]),
    "vtkGlobeTerrain": (["Globe.xml.in", "GlobeProperties.xml.in"], ["terrain"]),
    "vtkStructuredSmoothing": (["Smoothing.xml.in", "SmoothingProperties.xml.in"], ["clouds"]),
    "vtkCloudSurface": (["Smoothing.xml.in", "SmoothingProperties.xml.in"], ["clouds"]),
    "vtkContourCellSplitter": (["Filters.xml"], ["splitting"]),
    "vtkPolyhedronToTetrahedra": (["Filters.xml"], ["polyhedra"]),
    "vtkFlowVolume": (["FlowVolume.xml.in", "FlowVolumeProperties.xml.in"], ["smoke"]),
    "vtkSmokePuffs": (["SmokePuffs.xml"], ["smoke:smoke_puffs"]),
    "vtkTextureCoordinateAdvection": (["TextureAdvection.xml"], ["advection"]),
    "vtkSparseVolumeReader": (["SparseVolume.xml"], ["sparse"]),
    "vtkSparseVolumeWriter": (["SparseVolume.xml"], ["sparse"]),
    "vtkCellCompositingMapper": (["Representations.xml.in", "MediumProperties.xml.in"], ["cells", "_layers", "_medium", "_surfaces"]),
    "vtkTexturedSplatMapper": (["TexturedSplats.xml.in", "MediumProperties.xml.in"], ["splats", "_medium", "_vectors"]),
    "vtkCloudTextureMapper": (["CloudTexture.xml.in"], ["cloud_texture"]),
    "vtkCloudOptics": (["CloudOptics.xml"], ["optics"]),
    "vtkSunlight": (["Sunlight.xml"], ["light"]),
    "vtkSunSource": (["Sun.xml"], ["light"]),
    "vtkHaze": (["Haze.xml"], ["haze"]),
}
IN_PLACE = {"vtkCellCompositingProjectedTetrahedraMapper", "vtkCellCompositingRayCastMapper"}  # set by those who set VTK's
# What the same property is called in the definition of the proxy, where that is another name.
NAMES_IN_PARAVIEW = {
    **{("vtkCellCompositingMapper", name + "Name"): name for name in ("ContourArray", "LayerArray", "OpacityArray")},
    **{("vtkTexturedSplatMapper", name + "Name"): name for name in ("CellSizeArray", "OpacityArray", "VectorArray", "VectorColorArray")},
    ("vtkCellCompositingMapper", "LayerProperty"): "LayerOpacityScale",
    ("vtkCellCompositingMapper", "PolygonColor"): "ContourColors", ("vtkCellCompositingMapper", "PolygonOpacity"): "ContourOpacity",
    ("vtkHaze", "Background"): "HazeBackground", ("vtkHaze", "Color"): "HazeColor", ("vtkHaze", "Visibility"): "VisualRange",
    ("vtkGlobeGrid", "SurfaceConnection"): "InputConnection", ("vtkTextureCoordinateAdvection", "PointsConnection"): "InputConnection",
}
NAMES_IN_PARAVIEW.update({("vtkTexturedSplatMapper", "MaximumSpeed"): "GreatestSpeed", ("vtkTexturedSplatMapper", "VectorFraction"): "VectorShare"})
DEPRECATED = {"GreatestSpeed", "VectorShare"}  # earlier names of properties that are reached by their new ones
# Where a host does not reach a property: why.
DATA = "how data come in is the host's: connections in ParaView, arguments in PyVista"
SHORTER = "a setter of several properties at once, which are there one by one"
SAMPLES = "the update rate of the window sets it; otherwise on the mapper itself"
MAPPERS_IN_TIME = ("vtkCellCompositingMapper", "vtkTexturedSplatMapper")
AXES = "one setter for three properties, which are there one by one, or the other way round"
BY_REPRESENTATION = "ParaView's representation sets it, for several ranks"
EXCEPTIONS = {
    ("ParaView", "vtkCellCompositingMapper", "InputData"): DATA,
    ("ParaView", "vtkTexturedSplatMapper", "InputData"): DATA,
    ("ParaView", "vtkTexturedSplatMapper", "FilmTime"): "the animation time of ParaView sets it",
    ("ParaView", "vtkGlobeGrid", "SurfaceData"): DATA,
    ("PyVista", "vtkGlobeGrid", "SurfaceConnection"): DATA,
    ("PyVista", "vtkFlowVolume", "PolygonConnection"): DATA,
    ("PyVista", "vtkTextureCoordinateAdvection", "PointsConnection"): DATA,
    ("ParaView", "vtkGlobeGrid", "WindArrayNames"): SHORTER,
    ("PyVista", "vtkGlobeGrid", "EastwardWindArrayName"): SHORTER,
    ("PyVista", "vtkGlobeGrid", "NorthwardWindArrayName"): SHORTER,
    ("PyVista", "vtkGlobeGrid", "VerticalWindArrayName"): SHORTER,
    ("ParaView", "vtkTextureCoordinateAdvection", "PressureArrayNames"): SHORTER,
    ("PyVista", "vtkTextureCoordinateAdvection", "OmegaArrayName"): SHORTER,
    ("ParaView", "vtkSparseVolumeReader", "OutputToImage"): "OutputType, by its values",
    ("ParaView", "vtkSparseVolumeReader", "OutputToPoints"): "OutputType, by its values",
    ("PyVista", "vtkSparseVolumeReader", "OutputToImage"): "OutputType, by its values",
    ("PyVista", "vtkSparseVolumeReader", "OutputToPoints"): "OutputType, by its values",
    **{("ParaView", name, "Periodic"): AXES for name in ("vtkCloudSurface", "vtkStructuredSmoothing")},
    **{("PyVista", name, "Periodic" + axis): AXES for name in ("vtkCloudSurface", "vtkStructuredSmoothing") for axis in "IJK"},
    ("ParaView", "vtkTexturedSplatMapper", "InterpolateScalarsBeforeMapping"): "off: on several ranks samples travel without cells",
    ("PyVista", "vtkTexturedSplatMapper", "InterpolateScalarsBeforeMapping"): "on; on request off, on the mapper itself",
    ("ParaView", "vtkTexturedSplatMapper", "OrderByLayers"): "off: on several ranks samples travel without their grid",
    ("PyVista", "vtkTexturedSplatMapper", "OrderByLayers"): "on; on request off, on the mapper itself",
    **{(host, "vtkCellCompositingMapper", "PickOpacity"): "how opaque is what is picked; on the mapper itself" for host in ("ParaView", "PyVista")},
    **{(host, "vtkCellCompositingMapper", f"{kind}IdArrayName"): "numbers for selectors; the representation sets them, or on the mapper itself"
       for host in ("ParaView", "PyVista") for kind in ("Cell", "Point", "Composite", "Process")},
    **{("PyVista", mapper, name): SAMPLES for mapper in MAPPERS_IN_TIME
       for name in ("AutoAdjustSampleDistances", "MaximumImageSampleDistance", "ImageSampleDistance")},
    **{("ParaView", mapper, "ImageSampleDistance"): "1 where Auto Adjust Sample Distances is off" for mapper in MAPPERS_IN_TIME},
    ("PyVista", "vtkCellCompositingMapper", "NumberOfContourValues"): "the length of the list of contours",
    ("ParaView", "vtkCloudTextureMapper", "DensityVolume"): "a second input, the property of that name",
    ("ParaView", "vtkCellCompositingMapper", "LayersFromContours"): "on by itself, unless there is a Layer Array",
    ("ParaView", "vtkFlowVolume", "Controller"): "the host's ranks",
    ("PyVista", "vtkFlowVolume", "Controller"): "the host's ranks, of which there is one",
    ("PyVista", "vtkSunSource", "HoursLater"): "for animations in ParaView: times are arguments in Python",
    ("ParaView", "vtkHaze", "Enabled"): "the eye in the pipeline browser is the switch",
    ("PyVista", "vtkHaze", "Enabled"): "vtkHaze.SetHaze(renderer, None) takes haze away",
    ("ParaView", "vtkHaze", "Extinction"): "the same as the visibility, by another measure",
    ("PyVista", "vtkHaze", "Extinction"): "the same as the visibility, by another measure",
    ("ParaView", "vtkHaze", "Haze"): "no property: puts haze into a renderer",
    ("PyVista", "vtkSmokePuffs", "TimeScale"): "the time is in seconds: there is no animation whose unit could be another",
    ("ParaView", "vtkTexturedSplatMapper", "CellSizeFromCells"): "splats always have the shape of their cells, unless a cell size is set",
    ("ParaView", "vtkTexturedSplatMapper", "CellSizeFromNeighbors"): "neighbours on other ranks are not known",
    **{("ParaView", "vtkTexturedSplatMapper", name): BY_REPRESENTATION for name in ("CommonFrame", "Region", "ShapeArrayName")},
    **{("PyVista", "vtkTexturedSplatMapper", name): "for several ranks, of which there is one" for name in ("CommonFrame", "Region", "ShapeArrayName")},
    ("ParaView", "vtkCloudTextureMapper", "Region"): BY_REPRESENTATION,
    ("PyVista", "vtkCloudTextureMapper", "Region"): "for several ranks, of which there is one",
    ("ParaView", "vtkTexturedSplatMapper", "InteractiveUpdateRate"): "of the host: above which frame rate a picture counts as interactive",
    ("PyVista", "vtkTexturedSplatMapper", "InteractiveUpdateRate"): "of the host: above which frame rate a picture counts as interactive",
}


def properties(name):
    """Own ones of a class: SetX, without those of SetXToY, of the pipeline and of another class in the list."""
    own = [method[3:] for one in getattr(nephoscope, name).__mro__ if one.__name__ in dir(nephoscope) and (one.__name__ == name or one.__name__ not in CLASSES)
           for method in vars(one) if method.startswith("Set") and method[3:] not in DEPRECATED]
    return sorted({one for one in own if not any(one != other and one.startswith(other + "To") for other in own)})


def commands(name, files):
    """What the definitions of a class set; a file without a proxy of its own is put into another one."""
    found = set()
    for text in ((PARAVIEW / file).read_text() for file in files):
        proxies = re.finditer(rf'(?s)<(\w+Proxy)\s[^>]*?class="vtk(?:PV)?{name[3:]}(?:WithLabels)?".*?</\1>', text)
        for block in [match[0] for match in proxies] or [text]:
            found |= set(re.findall(r'command="(?:Set|Add)(\w+)"', block))
    return found


def calls(places):
    """Names that modules use, or, after a colon, one function of them."""
    found = set()
    for place in places:
        module, _, function = place.partition(":")
        module = importlib.import_module("nephoscope." + module)
        found |= set(re.findall(r"\.(?:Set|Add)?(\w+)", inspect.getsource(getattr(module, function) if function else module)))
    return found


def is_reached(name, found):
    return any(one == name or re.fullmatch(name + r"(To\w+|On|Off|s)", one) for one in found)


class Reach(unittest.TestCase):
    def missing(self):
        for name, (files, modules) in CLASSES.items():
            in_paraview, in_python = commands(name, files), calls(modules)
            for prop in properties(name):
                if not is_reached(NAMES_IN_PARAVIEW.get((name, prop), prop), in_paraview):
                    yield "ParaView", name, prop
                if not is_reached(prop, in_python):
                    yield "PyVista", name, prop

    def test_hosts(self):
        missing = set(self.missing())
        self.assertEqual(sorted(missing - set(EXCEPTIONS)), [])
        self.assertEqual(sorted(set(EXCEPTIONS) - missing), [], "reached, so no longer exceptions")

    def test_all_classes(self):
        algorithms = {name for name, one in vars(nephoscope).items() if isinstance(one, type) and issubclass(one, vtkAlgorithm) and name.startswith("vtk")}
        bases = {base.__name__ for name in CLASSES for base in getattr(nephoscope, name).__mro__[1:]}  # properties() has theirs
        self.assertEqual(algorithms - set(CLASSES) - bases, IN_PLACE)

    def test_reasons(self):
        for exception, reason in EXCEPTIONS.items():
            self.assertGreater(len(reason.split()), 2, exception)

    def test_arguments_are_documented(self):
        """Every argument of every function is in its docstring, with a default where it has one."""
        for name in (*nephoscope.VTK_FUNCTIONS, *nephoscope.PYVISTA_FUNCTIONS):
            function = getattr(nephoscope, name)
            for argument in inspect.signature(function).parameters.values():
                listed = rf"(?m)^(?:\*\*|[\w, ]*\b){argument.name}\b[\w, ]*(?: : .*)?$"
                self.assertRegex(inspect.getdoc(function), listed, f"{name}: {argument.name}")


def whirl(time=0.0):
    """A flow that turns and rises, faster with time."""
    mesh = pyvista.ImageData(dimensions=(16, 16, 16), origin=(-7.5, -7.5, 0))
    x, y, _ = mesh.points.T
    mesh["q"], mesh["v"] = mesh.points[:, 2], np.column_stack((-y, x, np.full(len(x), 1 + time)))
    return mesh


def filled(mesh, on_points):
    """With scalars "q" and vectors "v" on points or cells, and nothing else."""
    mesh = mesh.copy()
    mesh.clear_data()
    places = np.asarray(mesh.points if on_points else mesh.cell_centers().points, float)
    data = mesh.point_data if on_points else mesh.cell_data
    data["q"], data["v"] = places @ (0.1, 0.0, 1.0), np.tile((1.0, 0.0, 0.5), (len(places), 1))
    data.active_scalars_name = "q"
    return mesh


def meshes(on_points):
    image = pyvista.ImageData(dimensions=(6, 6, 6))
    steps = np.arange(6.0)
    kinds = {"images": [image], "structured": [pyvista.RectilinearGrid(steps, steps, steps), image.cast_to_structured_grid()],
             "unstructured": [image.cast_to_unstructured_grid(), image.cast_to_structured_grid().cast_to_explicit_structured_grid()],
             "surface": [pyvista.Sphere(theta_resolution=8, phi_resolution=8)], "particles": [pyvista.PolyData(np.random.default_rng(1).random((50, 3)))]}
    kinds = {kind: [filled(mesh, on_points) for mesh in of_kind] for kind, of_kind in kinds.items()}
    return {**kinds, "MultiBlock": [pyvista.MultiBlock([filled(image, on_points), filled(image.translate((5, 0, 0)), on_points)])]}


class Kinds(unittest.TestCase):
    """The table of Documentation/pyvista.md."""

    def drawn(self, add):
        plotter = pyvista.Plotter(off_screen=True, window_size=(20, 20))
        self.addCleanup(plotter.close)
        add(plotter)
        plotter.screenshot()

    def calls(self):
        with_arguments = {"cloud_surface": (2.2,), "split_cells": ([2.2],)}
        file = os.path.join(self.folder, "kinds.vdb")
        yield from ((name, lambda mesh, name=name: getattr(nephoscope, name)(mesh, *with_arguments.get(name, ())))
                    for name in ("smooth", "cloud_surface", "split_cells", "divide_polyhedra", "flow_volume", "advect_texture"))
        yield "globe", nephoscope.to_globe
        yield "write_vdb", lambda mesh: nephoscope.write_vdb(mesh, file, "q")
        for name, options in (("add_cells", {}), ("add_splats", {}), ("add_cloud_texture", {"coverage": "q"})):
            yield name, lambda mesh, name=name, options=options: self.drawn(lambda plotter: getattr(nephoscope, name)(plotter, mesh, **options))
        yield "add_haze", lambda mesh: self.drawn(lambda plotter: (plotter.add_mesh(mesh), nephoscope.add_haze(plotter)))

    def test_table(self):
        lines = (TOP / "Documentation/pyvista.md").read_text().split("| function | ", 1)[1].split("\n\n")[0].splitlines()
        columns = [column.strip() for column in ("function | " + lines[0]).strip("| ").split("|")]
        rows = {row[0].strip("`"): dict(zip(columns, row)) for row in ([cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:])}
        self.folder = self.enterContext(tempfile.TemporaryDirectory())
        calls = dict(self.calls())
        if not nephoscope.vtkSparseVolumeReader.HasOpenVDB():
            del calls["write_vdb"], rows["write_vdb"]
        self.assertEqual(set(rows), set(calls))
        for on_points in (True, False):
            for kind, of_kind in meshes(on_points).items():
                for name, call in calls.items():
                    told = rows[name]["structured" if kind == "images" else kind]
                    takes = told == "yes" or told == kind
                    takes = takes and (on_points or rows[name]["array on"] != "points")
                    for mesh in of_kind:
                        with self.subTest(f"{name} of {mesh.__class__.__name__} ({kind}), {'points' if on_points else 'cells'}"), warnings.catch_warnings():
                            warnings.simplefilter("ignore")
                            with contextlib.nullcontext() if takes else self.assertRaises((TypeError, ValueError, RuntimeError)):
                                call(mesh)


class Arguments(unittest.TestCase):
    """What the later arguments set, and what they refuse."""

    def plotter(self):
        plotter = pyvista.Plotter(off_screen=True, window_size=(30, 30))
        self.addCleanup(plotter.close)
        return plotter

    def test_cells(self):
        for number, method in enumerate(("cells", "rays", "triangles-linear", "triangles-table", "faces", "automatic")):
            mapper = nephoscope.add_cells(self.plotter(), whirl(), "q", method=method, split_at_control_points=False).mapper
            self.assertEqual((mapper.GetMethod(), mapper.GetSplitAtControlPoints()), (number, False))
        with self.assertRaisesRegex(ValueError, "method is 'fast'"):
            nephoscope.add_cells(self.plotter(), whirl(), "q", method="fast")

    def test_splats(self):
        values = {"streak_width": 0.2, "segment_length": 3.0, "segment_width": 2.5, "unit": 0.5, "layer_axis": 1, "phase_steps": 16}
        mapper = nephoscope.add_splats(self.plotter(), whirl(), "q", vectors=dict(array="v", **values), level_of_detail=dict(blending=0.3)).mapper
        found = [getattr(mapper, "Get" + "".join(word.capitalize() for word in name.split("_")))() for name in values if name != "unit"]
        self.assertEqual(found, [value for name, value in values.items() if name != "unit"])
        self.assertEqual((mapper.GetVectorUnit(), mapper.GetLevelBlending()), (0.5, 0.3))
        for name in values:
            for wrong in (float("nan"), float("inf"), -1):
                with self.subTest(f"{name}={wrong}"), self.assertRaisesRegex(ValueError, name):
                    nephoscope.add_splats(self.plotter(), whirl(), "q", vectors={"array": "v", name: wrong})

    def test_unsteady_smoke(self):
        times = [0.0, 1.0, 2.0]
        smoke = nephoscope.flow_volume(whirl, times=times, vectors="v", center=(0, 0, 3), radius=1.0, normal=(0, 0, 1), time_step=0.25)
        listed = nephoscope.flow_volume([whirl(t) for t in times], times=times, time=2.0, vectors="v", center=(0, 0, 3), radius=1.0, normal=(0, 0, 1),
                                        time_step=0.25)
        self.assertEqual(smoke.n_cells, listed.n_cells)
        self.assertAlmostEqual(smoke.points[:, 2].max(), 3 + 2 + 2 ** 2 / 2, 3)  # the integral of 1 + t from 0 to 2
        late = nephoscope.flow_volume(whirl, times=times, start_time=1.0, vectors="v", center=(0, 0, 3), radius=1.0, normal=(0, 0, 1), time_step=0.25)
        self.assertAlmostEqual(late.points[:, 2].max(), 3 + 1 + (2 ** 2 - 1) / 2, 3)
        for wrong in ({"times": [0.0]}, {"times": [1.0, 0.0]}, {"time": 1.0}, {"times": times, "time_scale": 0}, {"times": times, "time": float("nan")}):
            with self.subTest(wrong), self.assertRaisesRegex(ValueError, "time"):
                nephoscope.flow_volume(whirl if "times" in wrong else whirl(), vectors="v", **wrong)

    def test_others(self):
        self.assertEqual(whirl().nephoscope.split_cells(3, "q", precision="single").points.dtype, np.float32)
        self.assertEqual(whirl().nephoscope.split_cells(3, "q").points.dtype, np.float64)
        self.assertEqual(whirl().nephoscope.divide_polyhedra().n_cells, whirl().n_cells)
        with self.assertRaisesRegex(ValueError, "warp_tolerance"):
            nephoscope.divide_polyhedra(whirl(), warp_tolerance=2)
        weather = pyvista.RectilinearGrid([0.0, 10.0, 20.0], [0.0, 10.0], [100000.0, 50000.0])
        for name, value in (("u", 1.0), ("v", 1.0), ("w", -1.0), ("heat", 300.0), ("t", 200.0), ("pressure", 70000.0)):
            weather[name] = np.full(weather.n_points, value)
        warm, cold = weather.nephoscope.globe(temperature="heat"), weather.nephoscope.globe()
        self.assertGreater(np.linalg.norm(warm["Wind"], axis=1).max(), np.linalg.norm(cold["Wind"], axis=1).max())
        self.assertEqual(weather.nephoscope.globe(surface_pressure="pressure")["BelowGround"].sum(), 6)


class Numbers(unittest.TestCase):
    """Numbers that an argument cannot be are a ValueError with its name; with others nothing crashes or hangs."""

    VALUES = (float("nan"), float("inf"), -1, 0, 1e30)
    MANY = ("clim", "opacity_clim", "contours", "opacity", "render", "n_colors", "isosurfaces", "coverage", "peels")  # also of other kinds

    def functions(self):
        wind = whirl()
        clouds = filled(pyvista.ImageData(dimensions=(6, 6, 6)), True)
        surface = clouds.contour([2.5], scalars="q")
        for name, mesh, options in (("to_globe", clouds, {}), ("smooth", clouds, {}), ("divide_polyhedra", clouds, {}),
                                    ("flow_volume", wind, {"vectors": "v", "max_tetrahedra": 2000}), ("advect_texture", wind, {"vectors": "v"})):
            yield name, lambda name=name, mesh=mesh, options=options, **one: getattr(nephoscope, name)(mesh, **{**options, **one})
        smoke = nephoscope.flow_volume(wind, vectors="v", max_tetrahedra=2000)
        yield "smoke_puffs", lambda **one: nephoscope.smoke_puffs(smoke, **one)
        for name, mesh, options in (("add_cells", wind, {"scalars": "q"}), ("add_splats", wind, {"scalars": "q", "vectors": "v"}),
                                    ("add_smoke", smoke, {}), ("add_cloud_texture", surface, {}), ("add_haze", wind, {})):
            yield name, lambda name=name, mesh=mesh, options=options, **one: self.drawn(name, mesh, {**options, **one})

    def drawn(self, name, mesh, options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(20, 20))
        try:
            plotter.add_mesh(pyvista.Sphere())
            getattr(nephoscope, name)(plotter, mesh, **options)
            plotter.screenshot()
        finally:
            plotter.close()

    def arguments(self, name):
        """Those of numbers: by their default, or by the annotation where there is none."""
        for argument in inspect.signature(getattr(nephoscope, name)).parameters.values():
            number = isinstance(argument.default, (int, float)) and not isinstance(argument.default, bool)
            if argument.name not in self.MANY and (number or re.match(r"float \| None$", str(argument.annotation))):
                yield argument.name, lambda value, name=argument.name: {name: value}

    GROUPS = {"add_splats": (("vectors", _vectors.Vectors, {"array": "v"}), ("level_of_detail", splats.LevelOfDetail, {})),
              "add_cells": (("contours", _surfaces.Contours, {"values": 2}),)}

    def options(self, name):
        """The same of the options of grouped arguments."""
        for group, options, others in self.GROUPS.get(name, ()):
            for option in dataclasses.fields(options):
                if isinstance(option.default, (int, float)) and not isinstance(option.default, bool):
                    yield option.name, lambda value, group=group, others=others, option=option.name: {group: {**others, option: value}}

    def test_all(self):
        swept = 0
        for name, call in self.functions():
            for argument, given in (*self.arguments(name), *self.options(name)):
                for value in self.VALUES:
                    with self.subTest(f"{name}({argument}={value})"), warnings.catch_warnings():
                        warnings.simplefilter("ignore")
                        swept += 1
                        try:
                            call(**given(value))
                        except (ValueError, RuntimeError) as error:
                            self.assertIn(argument.replace("unit_distance", ""), str(error))
                        else:
                            self.assertTrue(np.isfinite(value), "is taken")
        self.assertGreater(swept, 200)


if __name__ == "__main__":
    unittest.main()
