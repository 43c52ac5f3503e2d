# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Films of `animate` that are interrupted, by the user, a signal or a full disk, go on where they stopped; steps that cannot be read are survived."""
import io
import os
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path
from unittest import mock

import nephoscope
import numpy as np
import pyvista
from nephoscope.weather.series import UnreadableStep
from PIL import Image

COUNT = 5
HERE = os.path.dirname(os.path.abspath(__file__))


def block(value):
    mesh = pyvista.ImageData(dimensions=(6,) * 3)
    mesh["T"] = np.linspace(0, 1, mesh.n_points) * (value + 1)
    return mesh


class Films(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.film, self.kept = self.folder / "film.gif", self.folder / "film.gif.frames"

    def animate(self, dataset=None, stop=None, view=None, **options):
        """Makes the film in a new plotter, and returns how often it drew and what was told. `stop(count)` is called at each drawing."""
        plotter = pyvista.Plotter(off_screen=True, window_size=(80, 60))
        self.addCleanup(plotter.close)
        plotter.set_background("white")
        if view:
            plotter.camera_position = view
        draw, drawn = plotter.screenshot, []

        def screenshot(file):
            drawn.append(file)
            if stop:
                stop(len(drawn))
            return draw(file)
        plotter.screenshot = screenshot
        self.log = io.StringIO()
        self.drawn = drawn
        with mock.patch("sys.stderr", self.log):
            self.series = nephoscope.animate(plotter, dataset or [block(k) for k in range(COUNT)], options.pop("draw", "T"), filename=options.pop("filename", self.film), **options)
        return len(drawn)

    def stopped(self, after, error=KeyboardInterrupt, **options):
        def stop(count):
            if count > after:
                raise error
        with self.assertRaises(error) as caught:
            self.animate(stop=stop, **options)
        return str(caught.exception)

    def frames(self, film=None):
        with Image.open(film or self.film) as film:
            found = []
            for i in range(film.n_frames):
                film.seek(i)
                found += [np.asarray(film.convert("RGB"), int)] * round(film.info["duration"] / 125)  # frames that are alike are one, shown longer
        return found


class Resumed(Films):
    def test_after_control_c(self):
        self.assertEqual(self.animate(filename=self.folder / "whole.gif"), COUNT)
        self.assertEqual(sorted(os.listdir(self.folder)), ["whole.gif"])
        self.assertIn(f"3 of {COUNT} frames are kept in {self.kept}. The same call continues from there.", self.stopped(3))
        self.assertFalse(self.film.exists())
        self.assertEqual(self.animate(), 1 + COUNT - 3)  # the newest once more
        self.assertIn(f"3 of {COUNT} frames are in {self.kept} already.\n4 of {COUNT}: 3\n", self.log.getvalue())
        self.assertEqual(sorted(os.listdir(self.folder)), ["film.gif", "whole.gif"])
        for one, other in zip(self.frames(), self.frames(self.folder / "whole.gif")):
            self.assertLess(np.abs(one - other).max(), 3)

    def test_after_sigkill(self):
        """Whatever the process does when it ends."""
        script = f"import sys; sys.path.insert(0, {HERE!r})\nfrom TestFilms import *\nfrom nephoscope._film_frames import os as system\n" + """
count, replace = [0], os.replace
def killing(*files):
    count[0] += 1
    if count[0] == 4:
        os.kill(os.getpid(), signal.SIGKILL)
    replace(*files)
system.replace = killing
plotter = pyvista.Plotter(off_screen=True, window_size=(80, 60))
plotter.set_background("white")
nephoscope.animate(plotter, [block(k) for k in range(COUNT)], "T", filename=sys.argv[1])
"""
        ended = subprocess.run([sys.executable, "-c", script, self.film], stderr=subprocess.PIPE)
        self.assertEqual(ended.returncode, -signal.SIGKILL, ended.stderr)
        self.assertTrue((self.kept / "unfinished.png").exists())
        self.assertEqual(self.animate(), 1 + COUNT - 3)
        self.assertEqual(len(self.frames()), COUNT)
        self.assertFalse(self.kept.exists())

    def test_frames_that_were_cut_off(self):
        self.stopped(3)
        frame = self.kept / "00001.png"
        frame.write_bytes(frame.read_bytes()[:-5])
        self.assertEqual(self.animate(), 1 + COUNT - 2)

    def test_another_call_begins_anew(self):
        """Other settings, other data, another camera."""
        path = self.folder / "a.vti"
        block(2).save(path)
        files = [path] * COUNT
        self.stopped(3)
        for change in ({"framerate": 9}, {"cmap": "hot"}, {"times": range(1, COUNT + 1)}, {"dataset": [block(k) for k in (0, 1, 2, 3, 9)]}, {"view": "xz"}, {"dataset": files}):
            with self.subTest(change=list(change)):
                self.assertEqual(self.animate(stop=lambda count: None, **change), COUNT + ("view" in change))
                self.stopped(3)
        self.stopped(3, dataset=files)
        self.assertEqual(self.animate(dataset=files), 1 + COUNT - 3)
        self.stopped(3, dataset=files)
        block(3).save(path)
        os.utime(path, (1, 1))
        self.assertEqual(self.animate(dataset=files), COUNT)

    def test_other_pictures_are_told(self):
        self.stopped(3)
        self.animate(view="xz")
        self.assertIn(f"3 of {COUNT} frames are in {self.kept} already, but differ from what this call draws: all are drawn again.", self.log.getvalue())

    def test_a_folder_of_pictures(self):
        folder = self.folder / "pictures"
        folder.mkdir()
        (folder / "mine.txt").write_text("stays")
        self.stopped(2, filename=folder)
        self.assertEqual(self.animate(filename=folder), 1 + COUNT - 2)
        names = [f"{i:05d}.png" for i in range(COUNT)]
        self.assertEqual(sorted(os.listdir(folder)), [*names, "mine.txt"])
        self.assertEqual(self.animate(filename=folder), COUNT)
        (folder / f"{COUNT:05d}.png").write_bytes(b"of a longer film")
        with self.assertWarnsRegex(UserWarning, f"pictures that do not belong to this film of {COUNT} frames, such as {COUNT:05d}.png"):
            self.animate(filename=folder)

    def test_a_film_that_cannot_be_made(self):
        """All frames stay, and none is drawn again but the one that is compared."""
        with mock.patch("nephoscope.weather.filming._gif", side_effect=OSError(28, "No space left on device")), self.assertRaisesRegex(OSError, f"{self.film} cannot be written: No space.*5 of 5 frames are kept"):
            self.animate()
        self.film.write_text("an earlier film")
        self.assertEqual(self.animate(), 1)
        self.assertEqual(len(self.frames()), COUNT)


class FullDisk(Films):
    def test_what_is_told(self):
        """The limit for the size of a file stands for the full disk."""
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)

        def fill(count):
            resource.setrlimit(resource.RLIMIT_FSIZE, (100 if count > 3 else limits[0], limits[1]))
        try:
            with self.assertRaises(OSError) as caught:
                self.animate(stop=fill)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        self.assertRegex(str(caught.exception), f"{self.kept}/unfinished.png cannot be written: File too large. Free: [0-9.,]+ [kMG]B; needed: about [0-9.]+ kB. 3 of {COUNT} frames are kept in {self.kept}. The same call continues")
        self.assertFalse((self.kept / "unfinished.png").exists())
        self.assertEqual(self.animate(), 1 + COUNT - 3)
        self.assertEqual(len(self.frames()), COUNT)


class UnreadableSteps(Films):
    def files(self, ending, damaged, binary=True):
        files = []
        for k in range(COUNT):
            files.append(self.folder / f"step{k}{ending}")
            (block(k) if ending in (".vti", ".vtk") else block(k).cast_to_unstructured_grid()).save(files[-1], binary=binary)
            if k in damaged:
                files[-1].write_bytes(files[-1].read_bytes()[:-700])
        return files

    def watched(self, dataset, damaged, **options):
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            self.animate(dataset, show_time=False, **options)
        told = [str(one.message) for one in found if "cannot be read" in str(one.message)]
        self.assertEqual([one.filename for one in found if "cannot be read" in str(one.message)], [__file__] * len(damaged))
        self.assertEqual(len(told), len(damaged), told)
        self.assertEqual(len(found), len(damaged), [str(one.message) for one in found])
        return told

    def alike(self, frames):
        return [bool(np.abs(one - other).max() < 8) for one, other in zip(frames, frames[1:])]

    def test_files_of_meshes(self):
        for ending, binary in ((".vti", True), (".vtu", True), (".vtk", True), (".vtk", False)):
            with self.subTest(ending, binary=binary):
                told = self.watched(self.files(ending, {2}, binary), [2])
                self.assertIn(f"Time step 2 (2) of {self.folder}/step2{ending} cannot be read: Error", told[0])
                self.assertEqual(self.alike(self.frames()), [False, True, False, False])

    def test_first_steps(self):
        """They show the first step that can be read."""
        self.watched(self.files(".vti", {0, 1}), [0, 1])
        self.assertEqual(self.alike(self.frames()), [True, True, False, False])

    def test_a_file_that_is_gone(self):
        files = self.files(".vti", set())
        def vanish(count):
            if count == 1:
                files[3].unlink()
        with self.assertWarnsRegex(RuntimeWarning, r"Time step 3 \(3\).*cannot be read"):
            self.animate(files, stop=vanish, show_time=False)
        self.assertEqual(self.alike(self.frames()), [False, False, True, False])

    def test_a_function_that_fails(self):
        def read(time):
            if time == 1:
                raise OSError("the tape is torn")
            return block(time)
        told = self.watched(read, [1], times=range(COUNT))
        self.assertEqual(told, ["Time step 1 (1) cannot be read: the tape is torn. Another step is shown in its place."])

    def test_resumed_after_one(self):
        """The picture that is repeated is that of the step before, also if that was drawn by another process."""
        files = self.files(".vti", {3})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.stopped(3, dataset=files, show_time=False)
            self.animate(files, show_time=False)
        self.assertEqual(self.alike(self.frames()), [False, False, True, False])

    def test_no_step_can_be_read(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with self.assertRaisesRegex(UnreadableStep, rf"None of the {COUNT} time steps can be read. Time step 0 \(0\) of .*step0.vti cannot be read"):
                self.animate(self.files(".vti", set(range(COUNT))))

    def test_other_errors_end_the_film(self):
        def wrong(time):
            return block(time) if time < 2 else 1 / 0
        with self.assertRaises(ZeroDivisionError):
            self.animate(wrong, times=range(COUNT))
        with self.assertRaises(UnreadableStep):
            nephoscope.animate(pyvista.Plotter(off_screen=True), self.files(".vti", {1}), lambda plotter, mesh: None).show(1)

    def test_a_damaged_netcdf_file(self):
        from TestWeatherSeries import forecast
        for damaged in (2, 0):
            with self.subTest(damaged):
                path = self.folder / f"forecast{damaged}.nc"
                data = forecast(4)
                data.to_netcdf(path, encoding={"cl": {"fletcher32": True, "chunksizes": (1, *data.cl.shape[1:])}})
                values = struct.pack("<d", float(data.cl[damaged].values.flat[0])) * 20
                content = path.read_bytes()
                self.assertEqual(content.count(values[:8] * data.cl[0].size), 1)
                path.write_bytes(content.replace(values, b"?" * len(values), 1))
                dataset = nephoscope.open(path)
                told = self.watched(dataset, [damaged], draw="cl", projection="map", vertical_exaggeration=50)
                self.assertRegex(told[0], rf"Time step {damaged} \(2020-01-01 {6 * damaged:02d}:00\) of {path} cannot be read: .*HDF error")
                alike = [False] * 3
                alike[max(0, damaged - 1)] = True
                self.assertEqual(self.alike(self.frames()), alike)
                dataset.close()


if __name__ == "__main__":
    unittest.main()
