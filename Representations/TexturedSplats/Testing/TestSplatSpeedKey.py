# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkSplatSpeedKey: words, length of the arrow, colours, and when nothing is drawn."""
import unittest

import nephoscope
import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkTextRenderer

HIDDEN = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (1, 0)])


def moving(settings):
    """A mapper whose vectors travel at their true speed."""
    mapper = nephoscope.vtkTexturedSplatMapper()
    mapper.SetVectorArrayName("v")
    mapper.SetVectorOpacity(0)
    mapper.SetTrueSpeed(True)
    for name, value in settings.items():
        getattr(mapper, "Set" + name)(value)
    return mapper


def sheet(speed, height):
    """12 by 12 kilometres."""
    data = meshes.image((12, 12, 0), spacing=(1000,) * 3, origin=(-6000, -6000, height))
    meshes.with_field(data, lambda p: 0 * p[:, 0])
    meshes.add_array(data.GetPointData(), np.tile([speed, 0.0, 0.0], (len(meshes.points_of(data)), 1)), "v")
    return data


class Key(unittest.TestCase):
    def scene(self, speed=20.0, background=(0, 0, 0), look=None, matrix=None, size=(400, 400), **settings):
        """A sheet; 20 pixels are a kilometre."""
        data = sheet(speed, 0)
        self.window = Window(size)
        scene = self.window.add_scene(background=background)
        mapper = moving(settings)
        self.volume = scene.add_volume(mapper, data, HIDDEN, matrix=matrix)
        scene.look(**{"position": (0, 0, 40000), "parallel_scale": 10000, "near": 5000, "far": 90000, **(look or {})})
        self.renderer = scene.renderer
        key = nephoscope.vtkSplatSpeedKey()
        key.SetVolume(self.volume)
        scene.renderer.AddViewProp(key)
        return key

    def text(self, key):
        self.window.render()
        self.assertEqual(self.window.messages.all, [])
        return key.GetText()

    def arrow(self):
        """Pixels from end to end of the longest row of ink in the lower left, above the words."""
        ink = np.abs(self.window.rgba(alpha=False) - self.window.rgba(alpha=False)[-1, -1]).max(axis=2) > 0.5
        runs = [np.flatnonzero(row) for row in ink[:120, :150]]
        rows = [run for run in runs if len(run) > 20 and len(run) == run[-1] - run[0] + 1]
        return max((len(run) for run in rows), default=0)

    def test_words_with_units(self):
        key = self.scene(TimeScale=300.0)
        self.assertEqual(self.text(key), "speed 10 moves this far (3000) in 1 s of film\n1 s of film shows 300 of the data's time\nfastest streaks: speed 20")
        key.SetSpeedUnit("m/s")
        self.assertEqual(self.text(key), "10 m/s moves this far (3 km) in 1 s of film\n1 s of film shows 5 min\nfastest streaks: 20 m/s")
        self.volume.GetMapper().SetVectorStyleToSegments()
        self.volume.GetMapper().SetMaximumSpeed(12)
        self.assertEqual(self.text(key).splitlines()[2], "longest segments: 12 m/s")
        self.volume.GetMapper().TrueSpeedOff()
        self.assertEqual(self.text(key), "longest segments: 12 m/s")

    def test_data_in_another_unit(self):
        """The same with a hundred times the length, in units of 100 m."""
        key = self.scene(TimeScale=3.0)
        key.SetSpeedUnit("m/s")
        key.SetLengthUnit(100.0)
        self.assertEqual(self.text(key), "10 m/s moves this far (300 km) in 100 s of film\n1 s of film shows 5 min\nfastest streaks: 20 m/s")
        key.SetSpeedUnit("")
        self.assertIn("(3000)", self.text(key))

    def test_film_in_another_unit(self):
        key = self.scene(TimeScale=300.0)
        key.SetSpeedUnit("m/s")
        key.SetFilmUnit("frame")
        key.SetFilmUnitSeconds(0.1)
        self.assertEqual(self.text(key).splitlines()[:2], ["10 m/s moves this far (3 km) in 10 frame", "1 frame shows 30 s"])

    def test_slow_film_has_an_arrow_of_several_seconds(self):
        key = self.scene(TimeScale=10.0)
        key.SetSpeedUnit("m/s")
        self.assertEqual(self.text(key).splitlines()[0], "20 m/s moves this far (4 km) in 20 s of film")

    def test_arrow_is_as_long_as_the_way(self):
        perspective = {"parallel_scale": None, "angle": 2 * np.degrees(np.arctan(0.25))}
        for what, pixels, options in (("parallel", 60, {}), ("perspective", 60, {"look": perspective}),
                                      ("larger volume", 60, {"matrix": np.diag([2.0, 2.0, 2.0, 1.0])}), ("white", 60, {"background": (1, 1, 1)})):
            key = self.scene(TimeScale=150.0 if "matrix" in options else 300.0, **options)
            key.SetSpeedUnit("m/s")
            self.assertEqual(self.text(key).splitlines()[0].split(" moves")[0], "10 m/s", what)
            self.assertAlmostEqual(self.arrow(), pixels, delta=3, msg=what)

    def lines(self):
        """Bottom and top, in pixels from below, of the lines of ink at the left, where keys stand."""
        ink = (np.abs(self.window.rgba(alpha=False) - self.window.rgba(alpha=False)[-1, -1]).max(axis=2) > 0.5)[:250, :20].any(axis=1)
        edges = np.flatnonzero(np.diff(np.r_[False, ink, False].astype(int)))
        return edges.reshape(-1, 2)

    def second(self, speed, visible=True, **settings):
        """Another volume in the scene, with its key."""
        data = sheet(speed, 9000)
        mapper = moving(settings)
        mapper.SelectScalarArray("s")
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SetInputDataObject(data)
        volume = self.volume.NewInstance()
        volume.SetMapper(mapper)
        volume.SetProperty(self.volume.GetProperty())
        volume.SetVisibility(visible)
        self.renderer.AddVolume(volume)
        key = nephoscope.vtkSplatSpeedKey()
        key.SetVolume(volume)
        self.renderer.AddViewProp(key)
        return key

    def test_narrow_views(self):
        """All words are seen, in smaller letters and on more lines; wider views have the same words on three lines."""
        for size, lines, at in ((600, 4, 0.03), (300, 6, 0.2), (200, 7, 0.2)):
            key = self.scene(TimeScale=300.0, size=(size, size), VectorOpacity=0)
            key.SetPosition(at, 0.03)
            self.text(key)
            ink = np.abs(self.window.rgba(alpha=False) - self.window.rgba(alpha=False)[-1, -1]).max(axis=2) > 0.5
            columns, rows = np.flatnonzero(ink.any(axis=0)), np.r_[False, ink.any(axis=1), False].astype(int)
            self.assertLess(columns.max(), size - 3, size)
            self.assertLess(np.flatnonzero(ink.any(axis=1)).max(), 0.6 * size, size)
            self.assertEqual(np.count_nonzero(np.diff(rows) > 0), lines, size)
            self.assertEqual(key.GetText().count("\n"), 2, size)

    def test_it_keeps_to_a_corner_of_small_views(self):
        """The box is not wider than 0.6 of the view, and its letters have 11 pixels in views of 300 x 200 and 400 x 300."""
        for size, share in (((300, 200), 0.45), ((400, 300), 0.25), ((800, 600), 0.2), ((1600, 900), 0.15)):
            key = self.scene(TimeScale=300.0, size=size, VectorOpacity=0)
            key.SetSpeedUnit("m/s")
            self.text(key)
            ink = np.abs(self.window.rgba(alpha=False) - self.window.rgba(alpha=False)[-1, -1]).max(axis=2) > 0.5
            columns, rows = np.flatnonzero(ink.any(axis=0)), np.flatnonzero(ink.any(axis=1))
            print(f"  {size}: {np.ptp(columns)} x {np.ptp(rows)}")
            self.assertLess(np.ptp(columns), 0.6 * size[0], size)
            self.assertLess(np.ptp(rows), share * size[1], size)

    def test_numbers_stay_with_their_units(self):
        """However narrow the view is, the last line has "20 m/s", not the unit alone."""
        least = [0] * 4
        style = nephoscope.vtkSplatSpeedKey().GetTextProperty()
        style.SetFontSize(11)  # the smallest letters
        vtkTextRenderer.GetInstance().GetBoundingBox(style, "20 m/s", least, 72)
        for size in range(110, 230, 5):
            key = self.scene(TimeScale=300.0, size=(size, size))
            key.SetSpeedUnit("m/s")
            self.text(key)
            ink = np.abs(self.window.rgba(alpha=False) - self.window.rgba(alpha=False)[-1, -1]).max(axis=2) > 0.5
            rows = np.flatnonzero(ink.any(axis=1))
            last = ink[rows[0]:rows[0] + 9].any(axis=0)
            self.assertGreaterEqual(np.ptp(np.flatnonzero(last)), least[1] - least[0] - 6, size)

    def test_keys_are_stacked(self):
        key = self.scene(TimeScale=300.0)
        self.text(key)
        one = self.lines()
        second = self.second(10.0, TimeScale=300.0)
        self.assertNotEqual(self.text(second), key.GetText())
        both = self.lines()
        self.assertEqual((len(one), len(both)), (4, 8))
        np.testing.assert_array_equal(both[:4], one)
        self.assertAlmostEqual(both[4][0] - both[3][1], 14, delta=11)  # next to the first key
        second.GetVolume().GetMapper().SetMaximumSpeed(20)  # of which the first key tells
        self.assertEqual(self.text(second), "")
        np.testing.assert_array_equal(self.lines(), one)

    def test_scalar_bars_are_left_free(self):
        key = self.scene(TimeScale=300.0)
        self.text(key)
        alone = self.lines()
        bar = vtkScalarBarActor()
        bar.SetLookupTable(vtkLookupTable())
        bar.SetOrientationToHorizontal()
        bar.SetTitle("T")
        bar.SetWidth(0.6)
        bar.SetHeight(0.2)
        self.renderer.AddViewProp(bar)
        for place, moved in (((0.2, 0.05), True), ((0.38, 0.8), False)):
            bar.SetPosition(*place)
            self.text(key)
            low = self.lines()[0][0]
            self.assertGreaterEqual(low, 0.25 * 400 if moved else 0)
            self.assertEqual(low == alone[0][0], not moved)
        bar.VisibilityOff()
        self.text(key)
        np.testing.assert_array_equal(self.lines(), alone)

    def test_one_time_scale_for_all(self):
        """The smallest of those of visible mappers with vectors, unless they have their own."""
        key = self.scene(20.0)
        self.text(key)
        alone = self.volume.GetMapper().GetDrawnTimeScale()
        second = self.second(200.0)
        mappers = [one.GetVolume().GetMapper() for one in (key, second)]
        self.text(key)
        shared = mappers[1].GetDrawnTimeScale()
        self.assertLess(shared, 0.2 * alone)
        self.assertEqual(mappers[0].GetDrawnTimeScale(), shared)
        for hide, show in ((lambda: second.GetVolume().VisibilityOff(), lambda: second.GetVolume().VisibilityOn()),
                           (lambda: mappers[1].SetTimeScale(2 * alone), lambda: mappers[1].SetTimeScale(0)), (lambda: mappers[1].TrueSpeedOff(), lambda: mappers[1].TrueSpeedOn())):
            hide()
            self.text(key)
            self.assertEqual(mappers[0].GetDrawnTimeScale(), alone)
            show()
            self.text(key)
            self.assertEqual(mappers[0].GetDrawnTimeScale(), shared)
        key = self.scene(20.0, FilmTime=3.0, VectorOpacity=5)
        self.second(200.0, FilmTime=3.0, VectorOpacity=5)
        self.text(key)
        first = self.window.rgba(alpha=False)
        self.text(key)
        self.assertLess(np.abs(self.window.rgba(alpha=False) - first).max(), 0.01)  # the time scale is known in the first frame
        self.assertGreater(first.max(), 0.9)
        key = self.scene(20.0)
        second = self.second(200.0)
        mappers = [one.GetVolume().GetMapper() for one in (key, second)]
        mappers[0].SetTimeScale(7)
        self.assertEqual(mappers[0].GetDrawnTimeScale(), 7)
        self.renderer.RemoveVolume(second.GetVolume())
        mappers[0].SetTimeScale(0)
        self.text(key)
        self.assertEqual(mappers[0].GetDrawnTimeScale(), alone)

    def test_nothing_without_vectors_or_volume(self):
        key = self.scene()
        self.assertNotEqual(self.text(key), "")
        full = self.arrow()
        self.volume.VisibilityOff()
        self.assertEqual(self.text(key), "")
        self.assertEqual((self.arrow(), full > 0), (0, True))
        self.volume.VisibilityOn()
        self.assertNotEqual(self.text(key), "")
        self.renderer.RemoveVolume(self.volume)
        self.assertEqual(self.text(key), "")
        key_of_none = self.scene(speed=float("nan"))
        self.window.render()
        self.assertEqual(key_of_none.GetText(), "")
        self.assertEqual(len(self.window.messages.all), 1)  # that vectors are not finite
        self.assertEqual(self.text(self.scene(speed=0.0)), "")
        key.SetVolume(None)
        self.assertEqual(self.text(key), "")


if __name__ == "__main__":
    unittest.main()
