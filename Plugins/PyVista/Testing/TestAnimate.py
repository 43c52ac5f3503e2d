# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""nephoscope.animate: what it draws is the same function of the values in all steps."""
import unittest
import warnings
from datetime import datetime

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
        for vectors in ({"array": "U"}, {"array": "U", "true_speed": True, "speed_key": False}, {"array": "U", "maximum_speed": 3.0}):
            self.plotter.clear()
            series, mapper = self.animate(meshes, vectors=vectors)
            self.assertAlmostEqual(mapper.GetMaximumSpeed(), vectors.get("maximum_speed", greatest), 4)
            weak = self.picture()
            alone = self.new_plotter()
            nephoscope.add_splats(alone, meshes[0], color="black", opacity=0, vectors={"maximum_speed": greatest, **vectors})
            self.assertLess(np.abs(weak - self.picture(alone)).max(), 3)
            series.show(1)
            self.assertLess(self.picture().mean(), weak.mean() - 1)

    def test_one_unit(self):
        """The unit is that of the step with the fastest vectors, whichever is shown."""
        for strengths, unit in (((-1, 10), 1), ((1, -100), 2)):
            self.plotter.clear()
            meshes = [whirl(strength) for strength in strengths]
            series, mapper = self.animate(meshes, vectors="U")
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
                (MissingDataError, r"step 1 \(time 1\) has no array 'T'. Point arrays: 'U'", [meshes[0], lacking], {}),
                (MissingDataError, r"step 1 \(time 6.5\) has no array 'T'", {0: meshes[0], 6.5: lacking}, {}),
                (TypeError, r"animate\(\) got an unexpected keyword argument 'cmapp'. Did you mean 'cmap'", meshes, {"cmapp": "hot"}),
                (TypeError, "'frame_rate'. Did you mean 'framerate'", meshes, {"frame_rate": 3}), (TypeError, "'nonsense'[.]$", meshes, {"nonsense": 3}),
                (TypeError, r"no option 'color'; of those of add_cells it takes 'opacity', .*add_cells\(plotter, mesh, ..., color=...\)", meshes, {"color": "red"}),
                (TypeError, "vertical_exaggeration: the meshes exist already", meshes, {"vertical_exaggeration": 3})):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                nephoscope.animate(self.plotter, dataset, "T", **options)

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


if __name__ == "__main__":
    unittest.main()
