# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.add_splats: arguments reach the mapper, bad ones are named. Draws nothing."""
import unittest

import nephoscope
import numpy as np
import pyvista
from plotters import PlotterTestCase
from pyvista.core.errors import MissingDataError


def box(n=3):
    mesh = pyvista.ImageData(dimensions=(n, n, n))
    mesh.point_data["x"] = mesh.points[:, 0]
    mesh.point_data["wind"] = np.tile((1.0, 2, 2), (mesh.n_points, 1))
    mesh.cell_data["layer"] = np.arange(mesh.n_cells, dtype=float)
    mesh.cell_data["cell_wind"] = np.zeros((mesh.n_cells, 3))
    return mesh


def particles(count=50):
    cloud = pyvista.PolyData(np.random.default_rng(0).uniform(-1, 1, (count, 3)))
    cloud["mass"] = np.arange(count, dtype=float)
    return cloud


class Splats(PlotterTestCase):
    def test_streaks_stand_out(self):
        """From the background and from every colour of the medium; orange on white clouds."""
        for cmap in ("RdBu", "coolwarm", "autumn", "hot", "viridis", "Greens", "gray"):
            for background in ((0.0, 0.0, 0.0), (0.3, 0.3, 0.3), (1.0, 1.0, 1.0)):
                colours = pyvista.LookupTable(cmap).values[:, :3] / 255.0
                self.plotter.clear()
                chosen = np.array(self.colour_of_streaks(background, cmap=cmap))
                nearest = np.linalg.norm(np.vstack([background, colours]) - chosen, axis=1).min()
                self.assertGreater(nearest, 0.35, (cmap, background, chosen))
        self.plotter.clear()
        self.assertEqual(self.colour_of_streaks((0, 0, 0), color="white", scalars=None), pyvista.Color("orangered").float_rgb)

    def colour_of_streaks(self, background, **options):
        self.plotter.background_color = background
        mapper = self.add(**options, vectors="wind").mapper
        self.assertTrue(mapper.GetUseVectorColor())
        return mapper.GetVectorColor()

    def add(self, mesh=None, scalars="x", **options):
        return nephoscope.add_splats(self.plotter, box() if mesh is None else mesh, scalars, render=False, **options)


class Accepted(Splats):
    def test_streaks_among_other_media(self):
        """Without a medium of their own they stand out from the others in the view, unless the user has chosen colours; in their own medium, from all."""
        colours = {cmap: pyvista.LookupTable(cmap).values[:, :3] / 255.0 for cmap in ("viridis", "hot", "gray")}
        for cmap, options in (("viridis", {"scalars": None, "opacity": 0}), ("hot", {"scalars": None, "opacity": 0}), ("gray", {"cmap": "viridis"})):
            self.plotter.clear()
            nephoscope.add_cells(self.plotter, box(), "x", cmap=cmap, show_scalar_bar=False, render=False)
            chosen = np.array(self.colour_of_streaks((0, 0, 0), **options))
            media = np.vstack([colours[one] for one in (cmap, options.get("cmap", cmap))])
            self.assertGreater(np.linalg.norm(media - chosen, axis=1).min(), 0.35, (cmap, chosen))
            self.assertGreater(np.linalg.norm(chosen), 0.7)
            self.assertEqual(len(self.plotter.scalar_bars), 0 if "scalars" in options else 1)
        for options in ({"scalars": "x"}, {"scalars": None, "cmap": "hot"}, {"scalars": None, "color": "red"}):
            self.assertFalse(self.add(**options, opacity=0, vectors="wind").mapper.GetUseVectorColor(), options)
        self.plotter.clear()
        self.assertFalse(self.add(scalars=None, opacity=0, vectors="wind").mapper.GetUseVectorColor())

    def test_the_bar_of_vectors_alone_has_colours(self):
        """With opacity 0 the medium is not drawn, and its colours are those of the vectors."""
        grid = pyvista.ImageData(dimensions=(4, 4, 4))
        grid["height"] = np.linspace(0, 1, 64)
        grid["wind"] = np.ones((64, 3))
        for opacity, alphas in ((0, [255]), (1, [255])):
            volume = nephoscope.add_splats(pyvista.Plotter(off_screen=True), grid, "height", opacity=opacity, vectors="wind")
            self.assertEqual(np.unique(np.asarray(volume.mapper.lookup_table.values)[:, 3]).tolist(), alphas)

    def test_defaults_are_those_of_the_mapper(self):
        volume, fresh = self.add(), nephoscope.vtkTexturedSplatMapper()
        self.assertIsInstance(volume.mapper, nephoscope.vtkTexturedSplatMapper)
        for name in ("Kernel", "CellSize", "RadiusFactor", "ErrorTolerance", "ErrorToleranceUnit", "ErrorMeasure", "OpacityScale",
                     "InteractiveMaximumNumberOfSplats", "VectorArrayName", "VectorStyle", "VectorPlacement", "VectorOpacity",
                     "UseVectorColor", "VectorColorArrayName", "GreatestSpeed", "StreakPeriod", "Phase", "PhaseCycles"):
            self.assertEqual(getattr(volume.mapper, "Get" + name)(), getattr(fresh, "Get" + name)(), name)
        # mean chord of 8 unit cubes, 4/3, times the mean of the ramp, for a mean optical depth of 2
        self.assertAlmostEqual(volume.prop.opacity_unit_distance, 4 / 3 * 0.5 / 2)
        self.assertEqual(volume.mapper.scalar_range, (0, 2))

    def test_few_cells(self):
        """One cell is a faint blob: a warning names the function that draws its shape."""
        for mesh in (pyvista.examples.cells.Tetrahedron(), pyvista.ImageData(dimensions=(2, 2, 3))):
            mesh["x"] = mesh.points[:, 2]
            with self.assertWarnsRegex(RuntimeWarning, f"has {mesh.n_cells} cells?[.] .*add_cells"):
                self.add(mesh)

    def test_numbers_and_choices(self):
        mapper = self.add(kernel="gaussian", radius_factor=1.5, opacity_scale=3,
                          level_of_detail=dict(tolerance=0.1, unit="data", measure="rms", interactive_splats=7),
                          vectors=dict(array="wind", style="segments", placement="layers", opacity=1, color="red", maximum_speed=9,
                                       streak_period=2, phase=0.25, phase_cycles=3)).mapper
        for name, expected in (("Kernel", 2), ("RadiusFactor", 1.5), ("ErrorTolerance", 0.1), ("ErrorToleranceUnit", 1),
                               ("ErrorMeasure", 1), ("InteractiveMaximumNumberOfSplats", 7), ("OpacityScale", 3),
                               ("VectorArrayName", "wind"), ("VectorStyle", 1), ("VectorPlacement", 1), ("VectorOpacity", 1),
                               ("VectorColor", (1, 0, 0)), ("UseVectorColor", True), ("GreatestSpeed", 9), ("StreakPeriod", 2),
                               ("Phase", 0.25), ("PhaseCycles", 3)):
            self.assertEqual(getattr(mapper, "Get" + name)(), expected, name)
        mapper.phase = 0.5
        self.assertEqual((mapper.phase, mapper.GetPhase()), (0.5, 0.5))
        with self.assertRaisesRegex(ValueError, "phase is nan"):
            mapper.phase = np.nan

    def test_true_speed(self):
        mapper = self.add(vectors=dict(array="wind", true_speed=True, time_scale=3600, film_time=2)).mapper
        self.assertEqual((mapper.GetTrueSpeed(), mapper.GetTimeScale(), mapper.GetFilmTime(), mapper.film_time), (True, 3600, 2, 2))
        mapper.film_time = 2.5
        self.assertEqual(mapper.GetFilmTime(), 2.5)
        with self.assertRaisesRegex(ValueError, "film_time is nan"):
            mapper.film_time = np.nan
        mapper = self.add(vectors="wind").mapper
        self.assertEqual((mapper.GetTrueSpeed(), mapper.GetTimeScale(), mapper.GetFilmTime()), (False, 0, 0))

    def test_length_unit(self):
        """A mesh in kilometres has the time scale and the legend of the same in metres."""
        words = []
        for length, unit in ((1000.0, {}), (1.0, {"length_unit": 1000})):
            mesh = pyvista.ImageData(dimensions=(9, 9, 3), spacing=(length,) * 3)
            mesh["wind"] = np.tile((10.0, 0, 0), (mesh.n_points, 1))
            plotter = pyvista.Plotter(off_screen=True, window_size=(300, 300))
            self.addCleanup(plotter.close)
            vectors = {"array": "wind", "true_speed": True, "time_scale": 300, "speed_unit": "m/s", **unit}
            volume = nephoscope.add_splats(plotter, mesh, color="red", vectors=vectors, show_scalar_bar=True)
            self.assertAlmostEqual(volume.mapper.GetTimeScale(), 300 / unit.get("length_unit", 1))
            plotter.screenshot(return_img=False)
            words += [actor.GetText() for actor in plotter.actors.values() if isinstance(actor, nephoscope.vtkSplatSpeedKey)]
        self.assertEqual(words[0], words[1])
        self.assertIn("1 s of film shows 5 min", words[0])
        with self.assertRaisesRegex(ValueError, "vectors\\['length_unit'\\] is 0"):
            self.add(vectors={"array": "wind", "length_unit": 0})
        with self.assertRaisesRegex(ValueError, "'length_unit', but true_speed is not True"):
            self.add(vectors={"array": "wind", "length_unit": 1000, "speed_unit": "m/s"})
        with self.assertRaisesRegex(ValueError, "no 'speed_unit'"):
            self.add(vectors={"array": "wind", "length_unit": 1000, "true_speed": True})

    def test_splats_that_are_not_seen_have_no_bar(self):
        """A bar has colours that are in the picture: that of other data with the same title stays."""
        mesh = pyvista.ImageData(dimensions=(5, 5, 5))
        mesh["water"] = mesh.points[:, 0]
        mesh["wind"] = np.tile((10.0, 0, 0), (mesh.n_points, 1))
        plotter = pyvista.Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        nephoscope.add_cells(plotter, mesh, "water", cmap="gray")
        nephoscope.add_splats(plotter, mesh, "water", opacity=0, vectors={"array": "wind", "color": "blue"})
        colour = [0.0, 0.0, 0.0]
        plotter.scalar_bars["water"].GetLookupTable().GetColor(4.0, colour)
        self.assertEqual((list(plotter.scalar_bars.keys()), colour), (["water"], [1, 1, 1]))

    def test_radius_of_particles(self):
        for kernel in ("cubic", "quadratic", "gaussian"):
            volume = self.add(pyvista.PolyData([(1.0, 2, 3)]), None, color="white", radius=0.5, kernel=kernel)
            np.testing.assert_allclose(volume.bounds, (0.5, 1.5, 1.5, 2.5, 2.5, 3.5), rtol=1e-4)
        wider = self.add(pyvista.PolyData([(1.0, 2, 3)]), None, color="white", radius=0.5, radius_factor=2)
        np.testing.assert_allclose(wider.bounds, (0, 2, 1, 3, 2, 4), atol=1e-3)

    def test_sizes_of_particles(self):
        pair = pyvista.PolyData([(0.0, 0, 0), (10.0, 0, 0)])
        pair["edge"], pair["volume"] = [1.0, 2.0], [1.0, 8.0]
        for options in ({"sizes": "edge"}, {"volumes": "volume"}):
            bounds = self.add(pair, None, color="white", **options).bounds
            np.testing.assert_allclose((bounds[0], bounds[1] - 10), (-1.556228, 2 * 1.556228), rtol=1e-4)
        self.assertTrue(self.add(particles(), "mass", radius="neighbors").mapper.GetCellSizeFromNeighbors())

    def test_arrays(self):
        self.assertEqual(self.add(scalars="layer").mapper.GetScalarModeAsString(), "UseCellFieldData")
        self.assertEqual(self.add(scalars="layer", vectors="cell_wind").mapper.GetVectorArrayName(), "cell_wind")
        mesh = box()
        names = list(mesh.array_names)
        self.assertEqual(self.add(mesh, np.arange(27.0)).mapper.GetArrayName(), "Data")
        self.add(mesh, None, color="white")
        self.assertEqual(mesh.array_names, names, "the mesh was changed")

    def test_bar_of_vector_scalars(self):
        mesh = box()
        mesh["speed"] = np.linspace(0, 9, mesh.n_points)
        for options, titles in (({}, {"x", "speed"}), ({"opacity": 0}, {"speed"}), ({"color": "red"}, {"speed"}), ({"show_scalar_bar": False}, set()),
                                ({"scalars": "speed"}, {"speed", "speed of wind"})):
            self.plotter.clear()
            self.add(mesh, vectors=dict(array="wind", scalars="speed", cmap=["black", "white"], clim=(0, 4)),
                     **{"scalar_bar_args": {"n_labels": 3}, **options})
            self.assertEqual(set(self.plotter.scalar_bars.keys()), titles, options)
            if "speed" in titles and "scalars" not in options:
                bar = self.plotter.scalar_bars["speed"]
                self.assertEqual((*bar.GetLookupTable().GetRange(), bar.GetNumberOfLabels()), (0, 4, 3))

    def test_colours(self):
        volume = self.add(color="red")
        np.testing.assert_allclose(volume.prop.GetRGBTransferFunction().GetColor(1), (1, 0, 0))
        self.assertAlmostEqual(volume.prop.GetScalarOpacity().GetValue(1), 0.5)
        self.assertEqual(len(self.plotter.scalar_bars), 0)
        volume = self.add(vectors=dict(array="wind", scalars="x", cmap=["black", "white"], clim=(0, 4)), show_scalar_bar=True)
        self.assertEqual(volume.mapper.GetVectorColorArrayName(), "x")
        np.testing.assert_allclose(volume.mapper.GetVectorColorFunction().GetColor(2), (0.5,) * 3, atol=0.01)
        self.assertIn("x", self.plotter.scalar_bars)

    def test_meshes_of_every_kind(self):
        image = box()
        blocks = pyvista.MultiBlock([image, None, image.cast_to_unstructured_grid()])
        for mesh in (image, image.cast_to_rectilinear_grid(), image.cast_to_structured_grid(), image.cast_to_unstructured_grid(),
                     image.extract_surface(algorithm="dataset_surface"), pyvista.PolyData(image.points, verts=None), blocks):
            with self.subTest(type(mesh).__name__):
                scalars = "x" if not isinstance(mesh, pyvista.PolyData) or "x" in mesh.point_data else mesh.points[:, 0]
                self.assertGreaterEqual(self.add(mesh, scalars).mapper.dataset.n_points, 26)
        self.assertEqual(self.add(image.points, None, color="white").mapper.dataset.n_points, 27)


class Refused(Splats):
    def test_arrays(self):
        self.fails(MissingDataError, "scalars: no array 'cloud'. Point arrays: 'x', 'wind'; cell arrays: 'layer'", scalars="cloud")
        self.fails(MissingDataError, "vectors: no array 'winds'. Point arrays", vectors="winds")
        self.fails(ValueError, "vectors: the array 'x' has 1 components", vectors="x")
        self.fails(ValueError, r"'cell_wind' must be on points.*cell_data_to_point_data", vectors="cell_wind")
        self.fails(ValueError, r"'wind' must be on cells.*point_data_to_cell_data", scalars="layer", vectors="wind")
        self.fails(MissingDataError, r"vectors\['scalars'\]: no array 'h'", vectors=dict(array="wind", scalars="h"))
        self.fails(MissingDataError, "opacity_scalars: no array 'q'", opacity_scalars="q")
        self.fails(ValueError, "opacity_scalars: the array 'layer' must be on points", opacity_scalars="layer")
        words = pyvista.PolyData(np.eye(3))
        words["wind"] = ["up", "down", "up"]
        self.fails(MissingDataError, "no point or cell array with one component", words, None)

    def test_combinations(self):
        self.fails(ValueError, "but no 'array'", vectors=dict(color="red"))
        self.fails(ValueError, "but no 'scalars'", vectors=dict(array="wind", cmap="jet"))
        self.fails(ValueError, "one colour, or that of an array", vectors=dict(array="wind", scalars="x", color="red"))
        self.fails(ValueError, "use radius_factor", radius=1)
        self.fails(ValueError, "radius and sizes are both given", particles(), "mass", radius=1, sizes="mass")
        self.fails(MissingDataError, "volumes: no array 'v'", particles(), "mass", volumes="v")
        self.fails(ValueError, "radius is 'large'; it must be one of 'neighbors'", particles(), "mass", radius="large")

    def test_numbers_and_choices(self):
        for bad in (0, -1, np.nan, np.inf):
            self.fails(ValueError, "opacity_unit_distance is .*greater than 0", opacity_unit_distance=bad)
            self.fails(ValueError, "radius is .*greater than 0", particles(), "mass", radius=bad)
        self.fails(ValueError, "opacity_scale is -1.*at least 0", opacity_scale=-1)
        self.fails(ValueError, "kernel is 'best'; it must be one of", kernel="best")
        for group, option in (("level_of_detail", "tolerance"), ("level_of_detail", "interactive_splats"), ("vectors", "opacity")):
            self.fails(ValueError, rf"{group}\['{option}'\] is -1.*at least 0", **{group: {option: -1}})
        for group, option in (("level_of_detail", "unit"), ("level_of_detail", "measure"), ("vectors", "style"), ("vectors", "placement")):
            self.fails(ValueError, rf"{group}\['{option}'\] is 'best'; it must be one of", **{group: {option: "best"}})
        self.fails(ValueError, r"vectors\['phase'\] is nan", vectors=dict(phase=np.nan))
        self.fails(ValueError, "but true_speed is not True", vectors=dict(array="wind", time_scale=3600))
        self.fails(ValueError, r"vectors\['time_scale'\] is 0", vectors=dict(array="wind", true_speed=True, time_scale=0))
        self.fails(ValueError, r"vectors\['film_time'\] is nan", vectors=dict(array="wind", true_speed=True, film_time=np.nan))
        self.fails(ValueError, "radius_factor is 0", radius_factor=0)

    def test_meshes(self):
        self.fails(TypeError, "mesh is a str", "clouds")
        self.fails(ValueError, "no points", pyvista.PolyData(), None)
        self.fails(ValueError, "no points", pyvista.MultiBlock(), None)
        with self.assertRaisesRegex(TypeError, "plotter is a ImageData"):
            nephoscope.add_splats(box(), box(), "x")


class EarlierNames(Splats):
    def test_they_set_the_same(self):
        earlier = dict(vectors="wind", vector_style="segments", vector_opacity=1, vector_color="red", greatest_speed=9, vector_share=0.5, vector_unit=0.2,
                       streak_period=2, phase=0.25, error_tolerance=0.1, error_unit="data", interactive_splats=7, unit_distance=0.3)
        with self.assertWarns(DeprecationWarning) as told:
            old = self.add(**earlier)
        self.assertEqual(told.filename, __file__)
        self.assertEqual(len(told.warnings), len(earlier) - 1)
        new = self.add(vectors=dict(array="wind", style="segments", opacity=1, color="red", maximum_speed=9, fraction=0.5, unit=0.2, streak_period=2, phase=0.25),
                       level_of_detail=dict(tolerance=0.1, unit="data", interactive_splats=7), opacity_unit_distance=0.3)
        for name in ("VectorArrayName", "VectorStyle", "VectorOpacity", "VectorColor", "MaximumSpeed", "VectorFraction", "VectorUnit", "StreakPeriod", "Phase",
                     "ErrorTolerance", "ErrorToleranceUnit", "InteractiveMaximumNumberOfSplats"):
            self.assertEqual(getattr(old.mapper, "Get" + name)(), getattr(new.mapper, "Get" + name)(), name)
        self.assertEqual(old.prop.opacity_unit_distance, new.prop.opacity_unit_distance)

    def test_a_number_is_the_tolerance(self):
        self.assertEqual(self.add(level_of_detail=0.3).mapper.GetErrorTolerance(), 0.3)

    def test_what_there_is_not(self):
        self.fails(TypeError, r"vectors has no option 'stile'; the options are 'array', 'style'", vectors=dict(stile="segments"))
        self.fails(TypeError, r"add_splats\(\) got an unexpected keyword argument 'vector_stile'", vector_stile="segments")
        self.fails(ValueError, r"vector_style and vectors\['style'\] are both given", vectors=dict(style="streaks"), vector_style="segments")


if __name__ == "__main__":
    unittest.main()
