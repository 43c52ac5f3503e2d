# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of the figures' films: made once, kept, made anew where settings change, and put into a GIF that loops."""
import contextlib
import io
import os
import sys
import tempfile
import unittest

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(TOP, "Figures", "common"))
import frames  # noqa: E402
import pictures  # noqa: E402
import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401
from PIL import Image  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow  # noqa: E402


class Frames(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.drawn = []

    def draw(self, i, file):
        self.drawn.append(i)
        Image.new("RGB", (8, 4), (40 * i, 0, 200)).save(file)

    def make(self, count=5, settings=("a",), draw=None):
        self.drawn.clear()
        film = frames.Frames(os.path.join(self.folder.name, "film"), count, settings)
        film.make(draw or self.draw)
        return film

    def test_frames_are_kept(self):
        film = self.make()
        self.assertEqual(self.drawn, [0, 1, 2, 3, 4])
        os.remove(film.files[2])
        self.make()
        self.assertEqual(self.drawn, [2])

    def test_an_interrupted_frame_is_no_frame(self):
        def interrupted(i, file):
            self.draw(i, file)
            if i == 3:
                raise KeyboardInterrupt
        with self.assertRaisesRegex(KeyboardInterrupt, "3 of 5 frames are kept in .*film. The same call continues from there"):
            self.make(draw=interrupted)
        film = self.make()
        self.assertEqual(self.drawn, [3, 4])
        self.assertTrue(all(os.path.exists(file) for file in film.files))

    def test_half_a_frame_is_no_frame(self):
        film = self.make()
        with open(film.files[3], "rb+") as frame:
            frame.truncate(os.path.getsize(film.files[3]) - 1)
        self.make()
        self.assertEqual(self.drawn, [3])

        def half(i, file):
            self.draw(i, file)
            os.truncate(file, 30)
        os.remove(film.files[2])
        with self.assertRaisesRegex(OSError, "unfinished.png cannot be written: the file is incomplete. Free: .*; needed: about .* bytes. 4 of 5 frames are kept"):
            self.make(draw=half)
        self.make()
        self.assertEqual(self.drawn, [2])

    def test_a_full_disk_is_told_and_survived(self):
        """With PIL, and with VTK's writer as the figures call it."""
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetSize(300, 300)
        window.AddRenderer(vtkRenderer())
        window.Render()
        for draw in (self.draw, lambda i, file: pictures.write(window, file, announce=False)):
            def full(i, file):
                if i == 2:
                    os.symlink("/dev/full", file)
                draw(i, file)
            with self.assertRaisesRegex(OSError, "unfinished.png cannot be written: .*. Free: [0-9.,]+ [kMG]B; needed: about .*. 2 of 5 frames are kept in .*film. The same call continues"):
                self.make(draw=full, settings=(repr(draw),))
            self.make(settings=(repr(draw),))
            self.assertEqual(self.drawn, [2, 3, 4])

    def test_an_error_of_what_is_drawn_stays_as_it_is(self):
        with self.assertRaisesRegex(FileNotFoundError, "nothing.nc"):
            self.make(draw=lambda i, file: open("nothing.nc", "rb"))

    def test_other_settings_start_anew(self):
        self.make()
        self.make(settings=("b",))
        self.assertEqual(self.drawn, [0, 1, 2, 3, 4])

    def test_gif_loops_through_all_frames(self):
        name = os.path.join(self.folder.name, "film.gif")
        self.assertTrue(frames.make_gif(self.make().files, name, 80))
        with Image.open(name) as film:
            self.assertEqual((film.n_frames, film.size, film.info["loop"], film.info["duration"]), (5, (8, 4), 0, 80))
            for i in range(5):
                film.seek(i)
                red = film.convert("RGB").getpixel((3, 2))[0]
                self.assertLess(abs(red - 40 * i), 8)

    def test_gif_of_a_long_film_is_small(self):
        name = os.path.join(self.folder.name, "film.gif")
        self.assertTrue(frames.make_gif(self.make().files, name, 80, width=4))
        with Image.open(name) as film:
            self.assertEqual((film.n_frames, film.size), (5, (4, 2)))

    def make_mp4(self):
        """With the programs of the test's folder alone."""
        path, os.environ["PATH"] = os.environ["PATH"], self.folder.name
        try:
            return frames.make_mp4(self.make().files, os.path.join(self.folder.name, "film.mp4"), 40)
        finally:
            os.environ["PATH"] = path

    def test_a_missing_program_is_told_and_no_error(self):
        told = io.StringIO()
        with contextlib.redirect_stdout(told):
            self.assertFalse(self.make_mp4())
        self.assertIn("no ffmpeg: film.mp4 is not made. The frames are kept: install ffmpeg (Debian: apt install ffmpeg)", told.getvalue())

    def test_ffmpeg_gets_all_frames(self):
        """A program that writes down what it is called with, in the place of ffmpeg."""
        program, written = (os.path.join(self.folder.name, name) for name in ("ffmpeg", "film.mp4"))
        with open(program, "w", encoding="utf-8") as script:
            script.write('#!/bin/sh\nfor last; do :; done\necho "$@" > "$last"\n')
        os.chmod(program, 0o755)
        self.assertTrue(self.make_mp4())
        with open(written, encoding="utf-8") as call:
            arguments = call.read()
        for part in ("-framerate 25 ", "-frames:v 15 ", os.path.join("film", "%05d.png")):
            self.assertIn(part, arguments)


if __name__ == "__main__":
    unittest.main()
