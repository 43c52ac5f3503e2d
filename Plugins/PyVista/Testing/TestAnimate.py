# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.animate: what it draws is the same function of the values in all steps."""
import io
import re
import shutil
import tempfile
import unittest
import warnings
from datetime import datetime
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError


class Animation(unittest.TestCase):
    def setUp(self):
        self.plotter = self.new_plotter()

    def new_plotter(self, **options):
        plotter = pyvista.Plotter(off_screen=True, window_size=(160, 160), **options)
        self.addCleanup(plotter.close)
        return plotter

    def picture(self, plotter=None):
        plotter = plotter or self.plotter
        getattr(plotter, "widgets", plotter).clear_slider_widgets()
        plotter.render()
        return plotter.screenshot(return_img=True).astype(int)


def whirl(strength, size=9):
    """A vortex; its cells are twice as long along z, where the wind blows in a step of negative strength."""
    mesh = pyvista.ImageData(dimensions=(size,) * 3, spacing=(1, 1, 2))
    x, y, _ = (mesh.points - mesh.center).T
    mesh["U"] = np.c_[-y, x, 0 * x] * strength if strength > 0 else np.c_[0 * x, 0 * x, 0 * x - strength]
    mesh["T"] = x
    return mesh


class Vectors(Animation):
    def animate(self, meshes, **options):
        drawn = []
        series = nephoscope.animate(self.plotter, meshes, lambda plotter, mesh: drawn.append(nephoscope.add_splats(
            plotter, mesh, **{"color": "black", "opacity": 0, **options})), show_time=False)
        return series, drawn[0].mapper

    def test_one_maximum_speed(self):
        """A step looks as with the greatest speed of all steps, so that stronger winds have stronger streaks."""
        meshes = [whirl(1), whirl(10), whirl(2)]
        greatest = np.linalg.norm(meshes[1]["U"], axis=1).max()
        for options in ({}, {"true_speed": True, "speed_key": False}, {"maximum_speed": 3.0}):
            vectors = {"array": "U", "fraction": 1, **options}
            self.plotter.clear()
            series, mapper = self.animate(meshes, vectors=vectors)
            self.assertAlmostEqual(mapper.GetMaximumSpeed(), vectors.get("maximum_speed", greatest), 4)
            weak = self.picture()
            alone = self.new_plotter()
            nephoscope.add_splats(alone, meshes[0], color="black", opacity=0, vectors={"maximum_speed": greatest, **vectors})
            self.assertLess(np.abs(weak - self.picture(alone)).max(), 3)
            series.show(1)
            self.assertLess(self.picture().mean(), weak.mean() - 1)

    def test_one_wrong_vector(self):
        """Streaks keep their number and opacity if a few vectors are much too long."""
        mesh = whirl(1, 9)
        mappers = []
        for length in (0, 1e5):
            if length:
                mesh["U"][0] = (length, 0, 0)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                mappers.append(nephoscope.add_splats(self.new_plotter(), mesh, "T", vectors="U").mapper)
        self.assertAlmostEqual(mappers[1].GetVectorFraction(), mappers[0].GetVectorFraction(), delta=0.02)
        ratio = mappers[1].GetVectorOpacity() / mappers[0].GetVectorOpacity()
        self.assertTrue(1 <= ratio <= 1.26, ratio)  # full length is up to 1.25 times that of the 99th percentile

    def test_one_unit(self):
        """The unit is that of the step with the fastest vectors, whichever is shown."""
        for strengths, unit in (((-1, 10), 1), ((1, -100), 2)):
            self.plotter.clear()
            meshes = [whirl(strength) for strength in strengths]
            series, mapper = self.animate(meshes, vectors={"array": "U", "fraction": 1})
            found = mapper.GetVectorUnit()
            self.assertAlmostEqual(found, unit, delta=0.1)
            series.show(1)
            self.assertEqual(mapper.FindVectorUnit(), found)

    def test_in_a_medium(self):
        """Density and opacity of the streaks are those of the strongest wind, too."""
        _, mapper = self.animate([whirl(1), whirl(10)], color=None, scalars="T", opacity="linear", vectors="U")
        _, other = self.animate([whirl(10), whirl(1)], color=None, scalars="T", opacity="linear", vectors="U")
        self.assertEqual(mapper.GetVectorOpacity(), other.GetVectorOpacity())
        self.assertEqual(mapper.GetVectorFraction(), other.GetVectorFraction())
        self.assertAlmostEqual(mapper.GetVectorUnit(), other.GetVectorUnit(), 6)


class Motion(Animation):
    """Vectors on meshes that stay the same move from step to step."""

    def film(self, vectors, framerate=8, count=4, change=None):
        plotter = self.new_plotter()
        drawn = []
        series = nephoscope.animate(plotter, [whirl(-1)] * count, lambda p, mesh: drawn.append(nephoscope.add_splats(p, mesh, color="black", opacity=0, vectors={"array": "U", "speed_key": False, **vectors})),
                                    show_time=False, framerate=framerate)
        mapper = drawn[0].mapper
        if change:
            change(series, mapper)
        pictures = []
        for step in range(count):
            series.show(step)
            pictures.append(self.picture(plotter))
        series.show(0)
        self.assertEqual(np.abs(self.picture(plotter) - pictures[0]).max(), 0)
        return pictures, mapper

    def moves(self, pictures):
        return [int(np.abs(one - other).max()) > 30 for one, other in zip(pictures, pictures[1:])]

    def test_streaks_move(self):
        for vectors in ({}, {"style": "segments"}, {"true_speed": True}, {"true_speed": True, "time_scale": 3}):
            self.assertEqual(self.moves(self.film(vectors)[0]), [True] * 3, vectors)

    def test_way_of_a_step(self):
        """In a second of the film the streaks of the greatest speed move by their distance or a little less, at few steps a second by less."""
        for framerate, steps in ((8, 8), (100, 100), (2, 4), (0.5, 4)):
            _, mapper = self.film({}, framerate)
            mapper.SetFilmTime(0)
            self.assertTrue(mapper.GetTrueSpeed())
            nephoscope.animate(self.plotter, [whirl(-1)] * 2, lambda p, mesh: None)
            way = mapper.GetDrawnTimeScale() * mapper.GetDrawnMaximumSpeed() / (mapper.GetStreakPeriod() * mapper.GetVectorUnit())
            self.assertTrue(0.3 < way <= 1, way)
            seen = []
            mapper.AddObserver("ModifiedEvent", lambda *_: seen.append(mapper.GetFilmTime()))
            self.film({}, framerate, change=lambda series, other: series.listen(lambda step: seen.append(other.GetFilmTime() - step / steps)))
            self.assertLess(np.abs(seen[-4:]).max(), 1e-9)

    def test_phases_of_the_user_stay(self):
        for vectors in ({"phase": 0.25}, {"phase": 0}, {"true_speed": True, "film_time": 0.5}, {"true_speed": True, "film_time": 0}):
            pictures, mapper = self.film(vectors)
            self.assertEqual(self.moves(pictures), [False] * 3, vectors)
            self.assertEqual((mapper.phase, mapper.film_time), (vectors.get("phase", 0), vectors.get("film_time", 0)))
        for change in (lambda series, mapper: setattr(mapper, "phase", 0.25), lambda series, mapper: mapper.SetPhase(0.25)):
            pictures, mapper = self.film({}, change=change)
            self.assertEqual(self.moves(pictures), [False] * 3)
            self.assertFalse(mapper.GetTrueSpeed())
            self.assertLess(np.abs(pictures[0] - self.film({"phase": 0.25})[0][0]).max(), 3)

    def test_phases_that_the_user_moves(self):
        """As in the loop that the documentation has, here told by the series."""
        pictures, _ = self.film({}, change=lambda series, mapper: series.listen(lambda step: setattr(mapper, "phase", step / 8)))
        for step in (1, 3):
            self.assertLess(np.abs(pictures[step] - self.film({"phase": step / 8})[0][0]).max(), 3)


class Camera(Animation):
    """The camera sees all steps of meshes that move or grow."""

    @staticmethod
    def block(place, size=1.0):
        mesh = pyvista.ImageData(dimensions=(5,) * 3, spacing=(size / 4,) * 3, origin=(place, 0, 0)).cast_to_unstructured_grid()
        mesh["T"] = np.linspace(0.5, 1, mesh.n_points)
        return mesh

    def seen(self, meshes, draw, before=lambda plotter: None, **options):
        """For each step, the share of the picture that is not background, and whether the outermost pixels are not; and the plotter."""
        plotter = self.new_plotter()
        plotter.set_background("white")
        before(plotter)
        series = nephoscope.animate(plotter, meshes, draw, show_time=False, **options)
        found = []
        for step in range(len(series)):
            series.show(step)
            ink = np.abs(self.picture(plotter) - 255).max(axis=2) > 10
            edge = ink.copy()
            edge[1:-1, 1:-1] = False
            found.append((float(ink.mean()), bool(edge.sum() > 3)))  # a corner may touch, as in pictures of PyVista
        return found, plotter

    DRAW = {"cells": lambda p, mesh: nephoscope.add_cells(p, mesh, "T", show_scalar_bar=False), "splats": lambda p, mesh: nephoscope.add_splats(p, mesh, "T", show_scalar_bar=False),
            "surface": lambda p, mesh: p.add_mesh(mesh, scalars="T", show_scalar_bar=False)}

    def test_all_steps_are_seen(self):
        for name, draw in self.DRAW.items():
            for meshes, options in (([self.block(x) for x in (0, 2, 5)], {}), ([self.block(0, size) for size in (1, 4, 2)], {}), (self.block, {"times": [0, 2, 5]})):
                found, plotter = self.seen(meshes, draw, **options)
                for share, at_edge in found:
                    self.assertGreater(share, 0.005, name)
                    self.assertFalse(at_edge, name)
                self.assertGreater(max(share for share, _ in found), 0.02, name)  # no farther than needed

    def test_moved_actors(self):
        shift = np.eye(4)
        shift[:3, 3] = 3, 20, 0
        found, _ = self.seen([self.block(x) for x in (0, 4)], lambda p, mesh: nephoscope.add_cells(p, mesh, "T", show_scalar_bar=False, user_matrix=shift))
        self.assertEqual([(share > 0.0005, at_edge) for share, at_edge in found], [(True, False)] * 2)

    def test_other_contents_are_seen(self):
        """What was there before, and what a second series draws."""
        far = pyvista.Sphere(radius=0.5, center=(-12, 0, 0))
        found, plotter = self.seen([self.block(x) for x in (0, 4)], self.DRAW["cells"], before=lambda p: p.add_mesh(far))
        self.assertEqual([at_edge for _, at_edge in found], [False, False])
        self.assertTrue(self.is_in_view(plotter, (-12, 0, 0)) and self.is_in_view(plotter, (4.5, 0, 0)))
        nephoscope.animate(plotter, [self.block(x) for x in (20, 20)], self.DRAW["cells"])
        self.assertTrue(all(self.is_in_view(plotter, (x, 0, 0)) for x in (-12, 4.5, 20.5)))

    def is_in_view(self, plotter, place):
        plotter.renderer.SetWorldPoint(*place, 1)
        plotter.renderer.WorldToDisplay()
        return bool(np.all(np.array(plotter.renderer.GetDisplayPoint()[:2]) > 0) and np.all(np.array(plotter.renderer.GetDisplayPoint()[:2]) < 160))

    def test_a_camera_of_the_user_stays(self):
        place = [(0.5, 0.5, 6.0), (0.5, 0.5, 0.5), (0, 1, 0)]
        given = lambda p: setattr(p, "camera_position", place)  # noqa: E731
        found, plotter = self.seen([self.block(x) for x in (0, 1, 2)], self.DRAW["cells"], before=given)
        np.testing.assert_allclose(plotter.camera.position, place[0])
        self.assertTrue(found[0][0] > found[2][0])
        # ... and what moves towards it is not cut off at the planes of the first step
        toward = [self.block(0), self.block(0).translate((0, 0, 3)), self.block(0).translate((0, 0, -30))]
        def close_planes(plotter):
            plotter.add_mesh(pyvista.Sphere(radius=0.1, center=(0.5, 0.5, 0.5)))
            given(plotter)
        large = [self.block(0, 4000.0)] * 2  # whose camera is set before anything is in the view
        found, _ = self.seen(large, self.DRAW["cells"], before=lambda p: setattr(p, "camera_position", [(2000, 2000, 20000), (2000, 2000, 2000), (0, 1, 0)]))
        self.assertGreater(found[0][0], 0.1)
        found, _ = self.seen(toward, self.DRAW["surface"], before=close_planes)
        self.assertTrue(found[1][0] > found[0][0] > found[2][0] > 0)

    def test_meshes_that_stay(self):
        """The camera is PyVista's own."""
        _, plotter = self.seen([self.block(0)] * 2, self.DRAW["cells"])
        alone = self.new_plotter()
        self.DRAW["cells"](alone, self.block(0))
        alone.render()
        alone.screenshot(return_img=True)
        np.testing.assert_allclose(plotter.camera.position, alone.camera.position)


class EmptySteps(Animation):
    TIMES = [0, 0.25, 0.5, 1.0]

    def film(self, times, draw):
        winds = [whirl(-1, 11) for _ in self.TIMES]
        plotter = self.new_plotter()
        plotter.set_background("black")
        series = nephoscope.animate(plotter, lambda time: nephoscope.flow_volume(winds, times=self.TIMES, time=time, center=(5, 5, 5), radius=2, normal=(0, 0, 1)), draw,
                                    times=times, show_time=False)
        pictures = []
        for step in range(len(series)):
            series.show(step)
            pictures.append(self.picture(plotter))
        series.show(0)
        self.assertEqual(np.abs(self.picture(plotter) - pictures[0]).max(), 0)
        return pictures

    def test_smoke_from_its_release(self):
        """The first step is empty, the others are those of a film without it, whatever draws them."""
        for draw in (lambda plotter, mesh: nephoscope.add_smoke(plotter, mesh), lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, "Age", show_scalar_bar=False),
                     lambda plotter, mesh: nephoscope.add_splats(plotter, mesh, "Age", show_scalar_bar=False),
                     lambda plotter, mesh: plotter.add_mesh(mesh, scalars="Age", show_scalar_bar=False)):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                all_of_them, others = (self.film(times, draw) for times in (self.TIMES, self.TIMES[1:]))
            self.assertEqual(all_of_them[0].max(), 0)
            for one, other in zip(all_of_them[1:], others):
                self.assertGreater(one.max(), 10)
                self.assertLess(np.abs(one - other).max(), 3)


class Messages(Animation):
    def test_what_cannot_be_drawn_is_told(self):
        meshes, lacking = [whirl(1), whirl(2)], whirl(3)
        lacking.point_data.remove("T")
        for error, words, dataset, options in (
                (ValueError, "dataset is empty; it must be a list of PyVista datasets", [], {}), (ValueError, "dataset is empty", {}, {}),
                (TypeError, r"a generator.*pass list\(dataset\)", (mesh for mesh in meshes), {}),
                (MissingDataError, r"scalars: no array 'T'. Point arrays: 'U'.*that of time step 0 \(2.5\)[.]", {2.5: lacking, 3: lacking}, {}),
                (TypeError, r"animate\(\) got an unexpected keyword argument 'cmapp'. Did you mean 'cmap'", meshes, {"cmapp": "hot"}),
                (TypeError, "'frame_rate'. Did you mean 'framerate'", meshes, {"frame_rate": 3}), (TypeError, "'nonsense'[.]$", meshes, {"nonsense": 3}),
                (TypeError, r"no option 'color'; of those of add_cells it takes 'opacity', .*add_cells\(plotter, mesh, ..., color=...\)", meshes, {"color": "red"}),
                (TypeError, r"no option 'vectors', which belongs to add_splats. Pass a function as draw: .*add_splats\(plotter, mesh, ..., vectors=...\)", meshes, {"vectors": "U"}),
                (TypeError, "vertical_exaggeration: the meshes exist already", meshes, {"vertical_exaggeration": 3})):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                nephoscope.animate(self.plotter, dataset, "T", **options)

    def test_steps_without_the_array(self):
        """They are told with time and file, and the step before is shown in their place; before the first with the array, that one."""
        meshes, lacking = [whirl(1), whirl(2)], whirl(3)
        meshes[1]["T"] *= 2
        lacking.point_data.remove("T")
        by_function = lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, "T", show_scalar_bar=False)
        with tempfile.TemporaryDirectory() as folder:
            file, film = Path(folder, "lacking.vti"), Path(folder, "film")
            lacking.save(file)
            for dataset, draw, words, lacks, same in (
                    ({0: meshes[0], 6.5: lacking, 7: meshes[1]}, "T", r"Time step 1 \(6.5\) has no array 'T'. Point arrays: 'U'", 1, (0, 1)),
                    ([meshes[0], str(file), meshes[1]], by_function, r"Time step 1 \(1\) of .*lacking.vti has no array 'T'", 1, (0, 1)),
                    ([meshes[0], meshes[1].point_data_to_cell_data(), meshes[1]], "T", r"Time step 1 \(1\) has the array 'T' on its cells, others have it on their points. Convert", 1, (0, 1)),
                    ([str(file), *meshes], "T", r"Time step 0 \(0\) of .*lacking.vti has no array 'T'", 0, (0, 1))):
                with self.subTest(words), warnings.catch_warnings(record=True) as told:
                    warnings.simplefilter("always")
                    series = nephoscope.animate(self.new_plotter(), dataset, draw, filename=film, progress=False, show_time=False)
                    self.assertEqual(len([one for one in told if re.search(words + ".* Another step is shown", str(one.message))]), 1, [str(one.message) for one in told])
                    pictures = [np.asarray(pyvista.read(frame).active_scalars) for frame in sorted(film.glob("*.png"))]
                    self.assertEqual([(i, k) for k in range(3) for i in range(k) if np.array_equal(pictures[i], pictures[k])], [same])
                    with self.assertRaisesRegex(OSError, words):
                        series.show(lacks)
                shutil.rmtree(film)

    def test_contours_of_a_later_step(self):
        """There is no warning if a later step has them, and there is one if no step has."""
        def grown(value):
            mesh = whirl(1)
            mesh["T"] = value * np.abs(mesh["T"])
            return mesh
        meshes = [grown(0.0), grown(1.0)]
        for contours, told in (([2.0], 0), ([50.0], 1), (3, 0)):
            with warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                drawn = []
                nephoscope.animate(self.plotter, meshes, lambda plotter, mesh: drawn.append(nephoscope.add_cells(plotter, mesh, "T", contours=contours)))
            self.assertEqual(sum("no value is within the range" in str(one.message) for one in found), told)
        self.assertEqual([drawn[0].mapper.GetContourValue(i) for i in range(3)], [1, 2, 3])

    def test_progress(self):
        """A line for each step in a log, one line that changes on a terminal."""
        for terminal, expected in ((False, "1 of 2: 0\n2 of 2: 1\n"), (True, "\r1 of 2: 0\r2 of 2: 1\n")):
            with tempfile.TemporaryDirectory() as folder, mock.patch("sys.stderr", io.StringIO()) as log:
                log.isatty = lambda answer=terminal: answer
                series = nephoscope.animate(self.new_plotter(), [whirl(1), whirl(2)], "T", filename=Path(folder, "film.gif"))
            self.assertEqual(log.getvalue(), expected)
            self.assertEqual(repr(series), "<Series of 2 steps, 0 to 1; at step 1>")

    def test_program_of_imageio(self):
        """A film is made by the program of imageio-ffmpeg where there is none on the path."""
        with tempfile.TemporaryDirectory() as folder:
            program, film = Path(folder, "program of imageio"), Path(folder, "a.mp4")
            program.write_text('#!/bin/sh\nfor last in "$@"; do :; done; echo "$@" > "$last"\n')
            program.chmod(0o755)
            package = mock.Mock(get_ffmpeg_exe=lambda: str(program))
            with mock.patch("shutil.which", return_value=None), mock.patch.dict("sys.modules", imageio_ffmpeg=package):
                nephoscope.animate(self.plotter, [whirl(1), whirl(2)], "T", filename=film, progress=False)
            self.assertIn("-framerate 8", film.read_text())
            for missing in (None, mock.Mock(get_ffmpeg_exe=mock.Mock(side_effect=RuntimeError))):
                with mock.patch("shutil.which", return_value=None), mock.patch.dict("sys.modules", imageio_ffmpeg=missing), self.assertRaisesRegex(RuntimeError, "Install it, or the Python package imageio-ffmpeg"):
                    nephoscope.animate(self.new_plotter(), [whirl(1), whirl(2)], "T", filename=film, progress=False)

    def test_times_are_sorted(self):
        """Numbers and dates, with their meshes; words stay as they are."""
        def values(dataset, **options):
            series = nephoscope.animate(self.plotter, dataset, lambda plotter, mesh: None, **options)
            return [mesh["U"].max() / size for mesh in series], list(series.seconds), series.times
        size = whirl(1)["U"].max()
        self.assertEqual(values({3: whirl(3), 0: whirl(1), 1: whirl(2)}), ([1, 2, 3], [0, 1, 3], ["0", "1", "3"]))
        self.assertEqual(values([whirl(2), whirl(1)], times=[4.0, 1.5])[:2], ([1, 2], [0, 2.5]))
        self.assertEqual(values(whirl, times=np.array([3, 1, 2]))[0], [1, 2, 3])
        self.assertEqual(values([whirl(2), whirl(1)], times=np.array(["2020-01-02", "2020-01-01"], "M8[D]"))[:2], ([1, 2], [0, 86400]))
        self.assertEqual(values({datetime(2020, 1, 2): whirl(2), datetime(2020, 1, 1): whirl(1)})[:2], ([1, 2], [0, 86400]))
        self.assertEqual(values({"z": whirl(2), "a": whirl(1)}), ([2, 1], [0, 1], ["z", "a"]))


class Several(Animation):
    def animate(self, plotter, count, **options):
        return nephoscope.animate(plotter, [whirl(k) for k in range(1, count + 1)], lambda plotter, mesh: plotter.add_mesh(mesh.outline()), **options)

    def labels(self, renderer):
        return [actor.GetText(2) for name, actor in renderer.actors.items() if name.startswith("nephoscope_time")]

    def sliders(self, plotter):
        return getattr(plotter, "widgets", plotter).slider_widgets

    def test_sub_plots(self):
        """Each has its own time and its own slider, whichever sub-plot is active."""
        plotter = self.new_plotter(shape=(1, 2))
        plotter.subplot(0, 0)
        left = self.animate(plotter, 4)
        plotter.subplot(0, 1)
        right = self.animate(plotter, 3)
        left.show(3)
        right.show(1)
        self.assertEqual([self.labels(renderer) for renderer in plotter.renderers], [["3"], ["1"]])
        sliders = self.sliders(plotter)
        self.assertTrue(all(slider.GetCurrentRenderer() is renderer for slider, renderer in zip(sliders, plotter.renderers)))
        self.assertEqual({slider.GetRepresentation().GetPoint1Coordinate().GetValue()[1] for slider in sliders}, {0.9})
        self.assertEqual([slider.GetRepresentation().GetValue() for slider in sliders], [3, 1])

    def test_one_renderer(self):
        """Times and sliders are one below the other; those of the first do not change with the second."""
        first, second = self.animate(self.plotter, 4), self.animate(self.plotter, 3)
        first.show(2)
        second.show(1)
        self.assertEqual(self.labels(self.plotter.renderer), ["2", "\n1"])
        heights = [slider.GetRepresentation().GetPoint1Coordinate().GetValue()[1] for slider in self.sliders(self.plotter)]
        self.assertGreater(heights[0] - heights[1], 0.1)
        self.plotter.clear()
        getattr(self.plotter, "widgets", self.plotter).clear_slider_widgets()
        self.animate(self.plotter, 2)
        self.assertEqual(self.labels(self.plotter.renderer), ["0"])


class Derived(Animation):
    """What `draw` derives from the mesh of one step stays as it is, and a warning says so."""

    def warnings_of(self, draw):
        meshes = [whirl(strength) for strength in (1, 2)]
        for mesh in meshes:
            mesh["Extinction"] = np.full(mesh.n_points, 0.1)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            nephoscope.animate(self.new_plotter(), meshes, draw, show_time=False)
        return [str(one.message) for one in caught if "stays the same in all steps" in str(one.message)]

    def test_derived(self):
        for draw, words in ((lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, sun=(1, 0, 1)), "draw them with sun=True"),
                            (lambda plotter, mesh: nephoscope.add_splats(plotter, mesh, sun=(1, 0, 1)), "draw them with sun=True"),
                            (lambda plotter, mesh: plotter.add_mesh(mesh.slice("z"), scalars="T"), "Derive it from each mesh first")):
            told = self.warnings_of(draw)
            self.assertEqual(len(told), 1)
            self.assertIn(words, told[0])

    def test_mesh_itself_and_other_data(self):
        for draw in (lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, "T"), lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, color="red"),
                     lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, color="red", opacity="extinction"),
                     lambda plotter, mesh: nephoscope.add_splats(plotter, mesh, "T", vectors="U"), lambda plotter, mesh: plotter.add_mesh(mesh, scalars="T"),
                     lambda plotter, mesh: (nephoscope.add_cells(plotter, mesh, "T"), plotter.add_mesh(pyvista.Sphere()))):
            self.assertEqual(self.warnings_of(draw), [])

    def test_wrong_arguments(self):
        draw = lambda plotter, mesh: nephoscope.add_cells(plotter, mesh, "T")  # noqa: E731
        with self.assertRaisesRegex(ValueError, "framerate is 0"):
            nephoscope.animate(self.plotter, [whirl(1)], draw, framerate=0)
        with self.assertRaisesRegex(ValueError, "time of mesh 1 is nan"):
            nephoscope.animate(self.plotter, [whirl(1), whirl(2)], draw, times=[0.0, np.nan])
        closed = self.new_plotter()
        closed.close()
        with self.assertRaisesRegex(ValueError, "plotter has been closed"):
            nephoscope.animate(closed, [whirl(1)], draw)


if __name__ == "__main__":
    unittest.main()
