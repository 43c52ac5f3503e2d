# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a user of Python reads when a filter fails or warns: one sentence, in the words of the function that was called."""
import os
import re
import unittest
import warnings
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from nephoscope import _pipeline, advection, clouds, globe, light, optics, smoke, sparse, splitting
from nephoscope_testing.sources import sentences


def weather(lat=(0.0, 10.0), lev=(0.0, 1000.0), **arrays):
    grid = pyvista.RectilinearGrid([0.0, 10.0, 20.0], lat, lev)
    for name, value in arrays.items():
        grid[name] = np.full(grid.n_points, value, float)
    return grid


FAILURES = {
    "latitudes": lambda: weather(lat=(0.0, 100.0), q=1).nephoscope.globe(),
    "one of two winds": lambda: weather(u=1.0).nephoscope.globe(wind=("u", "q")),
    "a flat grid": lambda: nephoscope.cloud_surface(weather(lev=[0.0], q=1.0), 0.5, "q"),
    "no mesh": lambda: nephoscope.read_cf(__file__),
}


# Folder of C++ sources, the classes whose messages they are, what their words become, and properties that Python has no argument for.
SOURCES = (("Filters/GlobeGrid", ["vtkGlobeGrid"], globe._NAMES, ()),
           ("Filters/FlowVolume", ["vtkFlowVolume", "vtkSmokePuffs"], smoke._NAMES, ("Unsteady", "StartTime", "TimeScale")),
           ("Filters/CloudSurface", ["vtkCloudSurface", "vtkStructuredSmoothing"], clouds._NAMES, ("Periodic",)),
           ("Filters/CloudOptics", ["vtkCloudOptics"], optics._NAMES, ()),
           ("Filters/Sunlight", ["vtkSunlight"], light._NAMES, ()),
           ("Filters/CellSubdivision", ["vtkContourCellSplitter"], splitting._NAMES, ()),
           ("Filters/TextureAdvection", ["vtkTextureCoordinateAdvection"], advection._NAMES, ()),
           ("Filters/SparseVolume", ["vtkSparseVolumeReader", "vtkSparseVolumeWriter"], sparse._NAMES, ()),
           ("Representations/CellCompositing", ["vtkCellCompositingMapper"], _pipeline._NAMES_OF_MAPPERS,
            ("NumberOfContourValues", "ContourValue", "MethodToCells", "ScalarOpacityUnitDistance")),
           ("Representations/TexturedSplats", ["vtkTexturedSplatMapper"], _pipeline._NAMES_OF_MAPPERS, ()),
           ("Representations/CloudTexture", ["vtkCloudTextureMapper"], _pipeline._NAMES_OF_MAPPERS, ()))


# Filters, menus and panels of ParaView in the sentences; those of VTK's classes and of what Python has too are none.
PARAVIEW = (r"Calculator|Merge Vector|Cell Data to Point Data|Extract Subset|Tetrahedralize|\(Triangulate\)|Delaunay|Cloud Surface|Textured Splats|\bApply\b|"
            r"\b[Pp]anel\b|Properties|Connect a|(Tools|Filters|Sources|Edit|View) >|Pass Arrays|Flow Volume|Smoke Puffs|Globe Grid")


class Sources(unittest.TestCase):
    def test_no_words_of_paraview(self):
        top = Path(os.environ["NEPHOSCOPE_DATA"]).parent
        for folder, _, names, _ in (*SOURCES, ("Filters/VelocityField", [], smoke._NAMES, ())):
            for file, sentence in sentences(top / folder):
                self.assertNotRegex(_pipeline._renamed(sentence, names), PARAVIEW, f"{folder}/{file}")
        for path in Path(nephoscope.__file__).parent.glob("*.py"):
            told = re.findall(r"(?:Error|warn)\(.*(?:\n +f?\".*)*", path.read_text())
            self.assertNotRegex("\n".join(told), PARAVIEW, path.name)

    def test_no_properties_of_vtk(self):
        """No sentence of a class names one of its properties, once the words of Python are in it."""
        top = Path(os.environ["NEPHOSCOPE_DATA"]).parent
        for folder, classes, names, without in SOURCES:
            properties = {name[3:] for one in classes for name in vars(getattr(nephoscope, one)) if name.startswith("Set")}
            properties = {name for name in properties - set(without) if re.search("[a-z][A-Z]", name)}
            found = 0
            for file, sentence in sentences(top / folder):
                found += 1
                left = set(re.findall(r"\w+", _pipeline._renamed(sentence, names))) & (properties | {"Set" + name for name in properties})
                self.assertFalse(left, f"{folder}/{file}: {sentence!r} names {left}, which Python does not have")
            self.assertGreater(found, 0 if (top / folder).is_dir() else -1, folder)


class Messages(unittest.TestCase):
    def test_values_that_are_not_numbers(self):
        """The warning names remedies of Python, and one of them works."""
        mesh = pyvista.ImageData(dimensions=(5, 5, 5))
        mesh["a"] = mesh.points[:, 0].astype(float)
        mesh["a"][62] = np.nan
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for data, told in ((mesh, 1), (mesh.threshold(scalars="a", all_scalars=True), 0)):
                plotter = pyvista.Plotter(off_screen=True, window_size=(40, 40))
                self.addCleanup(plotter.close)
                with warnings.catch_warnings(record=True) as caught:
                    warnings.simplefilter("always")
                    add(plotter, data, "a")
                    plotter.screenshot(return_img=True)
                found = [str(one.message) for one in caught if "not finite" in str(one.message) or "not a number" in str(one.message)]
                self.assertEqual(len(found), told, add.__name__)
                self.assertTrue(all(re.search(r"nan_to_num.*hide_cells.*mesh.threshold\(scalars=name, all_scalars=True\)", one) for one in found), found)
                self.assertFalse(any("Blank" in one for one in found))

    def test_no_dumps(self):
        for what, call in FAILURES.items():
            with self.subTest(what), self.assertRaises((RuntimeError, ValueError)) as caught:
                call()
            text = str(caught.exception).replace(__file__, "a file")  # whose folder may have a long name
            self.assertLess(len(text), 400, text)
            self.assertNotRegex(text, r"0x[0-9a-f]{6}|Debug:|Modified Time|returned failure|vtkInformation")
            self.assertEqual(len(set(text.splitlines())), len(text.splitlines()), text)

    def drawn(self, grid, name, add=nephoscope.add_cells, category=RuntimeWarning, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(30, 30))
        self.addCleanup(plotter.close)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            add(plotter, grid, name, show_scalar_bar=False, **options)
            plotter.screenshot()
        return [str(w.message) for w in caught if issubclass(w.category, category)]

    def test_polygons_of_split_cells_are_no_mistake(self):
        grid = pyvista.ImageData(dimensions=(4, 4, 4))
        grid["x"] = grid.points[:, 0] + 0.1 * grid.points[:, 1]
        pieces = grid.nephoscope.split_cells([1.3, 2.1], "x")
        self.assertEqual(self.drawn(pieces, "x"), [])
        pieces.cell_data.remove("ContourIndex")
        self.assertRegex(" ".join(self.drawn(pieces, "x")), r"\d+ polygons are not drawn: pass polygons='all'")
        self.assertEqual(self.drawn(pieces, "x", polygons="all"), [])

    def test_one_cell(self):
        grid = pyvista.ImageData(dimensions=(3, 2, 2)).cast_to_unstructured_grid()
        grid["x"] = [0.0, 1.0, np.nan] * 4
        self.assertRegex(" ".join(self.drawn(grid, "x")), "1 cell is not drawn because array 'x' or a coordinate is not finite at its points. Replace the values .*hide their cells")
        grid.cell_data["y"] = [1.0, np.nan]
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            self.assertRegex(" ".join(self.drawn(grid, "y", add)), "1 cell is not drawn because array 'y' or a coordinate is not finite there. Replace the values .*hide the cells .*threshold")

    def test_words_of_mappers(self):
        grid = pyvista.ImageData(dimensions=(3, 3, 3))
        grid["x"], grid["v"] = grid.points[:, 0], grid.points
        text = " ".join(self.drawn(grid, "x", nephoscope.add_splats, vectors=dict(array="v", placement="layers"), level_of_detail=0.1))
        self.assertIn("level_of_detail is ignored", text)
        self.assertIn("Pass 'middle' as vectors['placement']", text)

    def test_layers_without_a_grid(self):
        """One warning, of all meshes without layers; none where vectors are in the middle, or the grid has layers."""
        grid = pyvista.ImageData(dimensions=(3, 3, 3))
        grid["x"], grid["v"] = grid.points[:, 0], grid.points
        cells = grid.cast_to_unstructured_grid()
        splats = lambda mesh, **options: self.drawn(mesh, "x", nephoscope.add_splats, (UserWarning, RuntimeWarning), vectors=dict(array="v", **options))
        for mesh in (cells, pyvista.MultiBlock([grid, cells])):
            for options, ignored in (({}, False), ({"layer_axis": 1}, True)):
                told = splats(mesh, placement="layers", **options)
                self.assertEqual(len(told), 1, told)
                self.assertIn("only a structured grid", told[0])
                self.assertEqual("layer_axis is ignored" in told[0], ignored)
        self.assertEqual(splats(cells), [])
        self.assertEqual(splats(grid, placement="layers", layer_axis=1), [])

    def test_wrong_arguments_are_named(self):
        """Values of a wrong kind: one sentence that names the argument, the value and what it must be."""
        mesh = pyvista.ImageData(dimensions=(5, 5, 5))
        mesh["a"] = np.linspace(0, 1, mesh.n_points)
        wrong = {"clim is [1]": {"clim": [1]}, "clim is ['0', '1']": {"clim": ["0", "1"]}, "opacity_unit_distance is 'far'": {"opacity_unit_distance": "far"},
                 "opacity_scale is '2'": {"opacity_scale": "2"}, "contours is '3'": {"contours": "3"}, "contours is [[1], [1, 2]]": {"contours": [[1], [1, 2]]},
                 "sun is 'noon'": {"sun": "noon"}, "Divide values from 0 to 255": {"opacity": [0, 50, 255]},
                 "sun['temperature'] is 280": {"sun": {"direction": (0, 0, 1), "water": "a", "temperature": 280}}}
        for text, options in wrong.items():
            with self.subTest(text):
                plotter = pyvista.Plotter(off_screen=True)
                self.addCleanup(plotter.close)
                with self.assertRaises((TypeError, ValueError, RuntimeError)) as caught:
                    nephoscope.add_cells(plotter, mesh, "a", **options)
                self.assertIn(text, str(caught.exception))

    def test_opacities_of_points_are_no_function(self):
        """An array of the mesh, or its name, is not taken for a function of the scalars."""
        mesh = pyvista.ImageData(dimensions=(10, 10, 10))
        mesh["T"], mesh["opa"] = mesh.points[:, 0].copy(), (mesh.points[:, 2] > 4.5) * 1.0
        small = pyvista.ImageData(dimensions=(4, 4, 3))  # 48 points, 18 cells
        small["T"] = small.points[:, 0].copy()
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for opacity in ("opa", mesh["opa"], mesh["opa"].tolist(), 0.5 * mesh["opa"], np.linspace(0, 1, mesh.n_cells)):
                with self.subTest(add=add, opacity=type(opacity)), self.assertRaisesRegex(ValueError, "opacity_scalars="):
                    self.drawn(mesh, "T", add, opacity=opacity)
            with self.assertRaisesRegex(ValueError, "pass opacity_scalars='opa'"):
                self.drawn(mesh, "T", add, opacity=mesh["opa"])
            for count, told in ((48, "opacities of points"), (18, "opacities of cells"), (17, None)):
                messages = self.drawn(small, "T", add, UserWarning, opacity=np.linspace(0, 1, count))
                self.assertEqual([told in message for message in messages], [True] if told else [], messages)

    def test_logarithmic_scale_from_zero(self):
        mesh = pyvista.ImageData(dimensions=(5, 5, 5))
        mesh["a"] = np.linspace(0, 1, mesh.n_points)
        for add in (nephoscope.add_cells, nephoscope.add_splats):
            for clim, count in (((0, 1), 1), (1.0, 1), ((0.1, 1), 0), (None, 0)):
                told = self.drawn(mesh, "a", add, UserWarning, log_scale=True, clim=clim)
                self.assertEqual(sum("0.00806452 is taken, the smallest positive value of 'a'" in text for text in told), count, told)
                self.assertEqual(len(told), count)

    def test_contours_outside_the_data(self):
        mesh = pyvista.ImageData(dimensions=(5, 5, 5))
        mesh["a"] = np.linspace(0, 1, mesh.n_points)
        for value, count in ((5.0, 1), (0.5, 0)):
            plotter = pyvista.Plotter(off_screen=True)
            self.addCleanup(plotter.close)
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                nephoscope.add_cells(plotter, mesh, "a", contours=[value])
            self.assertEqual(sum("no value is within the range of 'a', 0 to 1" in str(one.message) for one in told), count)

    def test_own_words(self):
        """Names of properties that Python does not have are not in what it says."""
        z = weather(lev=np.array([100000.0, 50000.0, 10000.0]))
        z["z"] = np.repeat([1000.0, 55000.0, 160000.0], 6)
        indices = weather(lev=np.arange(1.0, 9), q=1.0)
        for call, words in ((lambda: z.nephoscope.globe(height="z"), ["height_units"]),
                            (lambda: indices.nephoscope.globe(), ["level_units", "height"]),
                            (lambda: weather(u=1.0, v=1.0).nephoscope.globe(wind=("u", "v"), height=False), [])):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                call()
            text = " ".join(str(w.message) for w in caught)
            for word in words:
                self.assertIn(word, text)
            self.assertIsNone(re.search(r"HeightUnits|LevelUnits|ArrayName|WindComponents|VerticalWindIsOmega", text), text)
            self.assertTrue(all(w.filename == __file__ for w in caught), [w.filename for w in caught])



class ValuesChangedInPlace(unittest.TestCase):
    """numpy changes values without a word to VTK, which keeps the ranges of arrays."""

    def test_checks_see_the_new_values(self):
        grid = pyvista.ImageData(dimensions=(6, 6, 6), spacing=(100, 100, 100))
        height = grid.points[:, 2].copy()
        grid["ql"], grid["T"], grid["H"] = np.full(grid.n_points, 1e-3), 290 - 0.0065 * height, height
        for data in (grid, pyvista.MultiBlock([grid])):
            if isinstance(data, pyvista.DataSet):
                data.nephoscope.cloud_optics(height="H")
            grid["T"] -= 273.15
            with self.assertRaisesRegex(RuntimeError, "Celsius|273.15"):
                grid.nephoscope.cloud_optics(height="H")
            grid["T"] += 273.15
        grid["ql"] *= 1e3
        with self.assertRaisesRegex(RuntimeError, "g/kg"):
            grid.nephoscope.cloud_optics(height="H")

    def test_contours_of_blocks(self):
        blocks = pyvista.MultiBlock([pyvista.ImageData(dimensions=(4, 4, 4))])
        blocks[0]["s"] = blocks[0].points[:, 0].copy()
        blocks.nephoscope.split_cells([1.5], scalars="s")
        blocks[0]["s"] *= 10
        self.assertGreater(blocks.nephoscope.split_cells([15], scalars="s")[0].n_cells, 0)


if __name__ == "__main__":
    unittest.main()
