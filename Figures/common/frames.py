# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of an animation as PNG files, made once and kept, and films of them.

    wanted = options("Winds over the globe", frames=36, size=(960, 540)).parse_args()
    make_film("02_winds", wanted, draw, 80, settings)   draw(i, file) draws frame i of wanted.frames into a file

or step by step

    frames = Frames(folder, count, settings)
    frames.make(draw)
    make_gif(frames.files, "a.gif")   with Pillow or ImageMagick
    make_mp4(frames.files, "a.mp4")   with ffmpeg

A GIF of more than 100 frames would be too large: it has fewer frames, 480 pixels wide.

Frames that are there are kept, so that an interrupted animation goes on where it stopped; frames made with other settings, or by
other scripts, are made anew. A film that no program of this machine can make is left out, with a message.
"""
import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import time

import film_frames

LARGEST_GIF = 100  # frames
SMALL = 480  # pixels
PACKAGES = {"ffmpeg": "ffmpeg", "convert": "imagemagick"}  # of Debian
COMMON = os.path.dirname(os.path.abspath(__file__))


def options(description, frames, size):
    """The arguments of a figure with a film, for parse_args."""
    parser = argparse.ArgumentParser(description=description + ": a picture and a film.")
    if os.environ.get("NEPHOSCOPE_FILMS") == "no":  # ./nephoscope demo
        frames = 0
    parser.add_argument("--frames", type=int, default=frames, help="frames of the film; 0: the picture only")
    parser.add_argument("--size", type=int, nargs=2, default=list(size), help="width and height of the film, pixels")
    parser.add_argument("--no-picture", action="store_true", help="the film only")
    return parser


def scripts():
    """A hash of the script that runs and of all that it has taken from this folder."""
    files = {os.path.abspath(sys.modules["__main__"].__file__)}
    for module in list(sys.modules.values()):
        file = getattr(module, "__file__", None)
        if file and os.path.dirname(os.path.abspath(file)) == COMMON:
            files.add(os.path.abspath(file))
    total = hashlib.sha256()
    for file in sorted(files):
        with open(file, "rb") as script:
            total.update(script.read())
    return total.hexdigest()


def make_film(name, wanted, draw, milliseconds, settings=(), loops=3):
    """Into the gallery; `wanted` has been parsed by options(), `settings` are all that frames depend on besides scripts and size. The MP4 has
    the frames `loops` times over."""
    path = os.path.join(os.environ["NEPHOSCOPE_GALLERY"], name)
    folder = "%s_%dx%d_%d_frames" % (path, *wanted.size, wanted.frames)
    film = Frames(folder, wanted.frames, [scripts(), wanted.frames, wanted.size, *settings])
    film.make(draw)
    some = film.files[:: 1 + (len(film.files) - 1) // LARGEST_GIF]
    if make_gif(some, path + ".gif", milliseconds * len(film.files) // len(some), SMALL if len(film.files) > LARGEST_GIF else None):
        print("wrote %s.gif" % path, flush=True)
    if make_mp4(film.files, path + ".mp4", milliseconds, loops):
        print("wrote %s.mp4" % path, flush=True)


class Frames(film_frames.Frames):
    """With the progress on standard output."""

    def make(self, draw):
        found, start, drawn = len(self.found()), time.monotonic(), []
        if found:
            print("%d of %d frames are there already" % (found, len(self.files)), flush=True)

        def tell(i):
            drawn.append(i)
            left = (time.monotonic() - start) / len(drawn) * (len(self.files) - found - len(drawn))
            print("frame %d of %d, %.0f s left" % (i + 1, len(self.files), left), flush=True)

        super().make(draw, tell)


def make_gif(files, name, milliseconds=80, width=None):
    """A GIF that loops for ever; True if it could be made. `width`: in pixels, that of the files without it."""
    try:
        from PIL import Image
    except ImportError:
        resize = ["-resize", "%dx" % width] if width else []
        return run("convert", ["-delay", str(milliseconds // 10), "-loop", "0", *files, *resize, "-layers", "optimize", name])
    pictures = [of_width(Image.open(file).convert("RGB"), width) for file in files]
    # One palette for all frames, taken from some of them side by side, or still parts would flicker.
    some = pictures[:: max(1, len(pictures) // 6)]
    sheet = Image.new("RGB", (some[0].width, some[0].height * len(some)))
    for row, picture in enumerate(some):
        sheet.paste(picture, (0, row * picture.height))
    # An octree keeps the colours of small things too, as streaks and colour bars; the median cut merges them.
    palette = sheet.quantize(256, method=Image.Quantize.FASTOCTREE)
    first, *others = [picture.quantize(palette=palette) for picture in pictures]
    first.save(name, save_all=True, append_images=others, duration=milliseconds, loop=0, optimize=False)
    return True


def of_width(picture, width):
    return picture.resize((width, round(picture.height * width / picture.width))) if width else picture


def make_mp4(files, name, milliseconds=80, loops=3):
    """The frames several times over, for players that do not loop; True if ffmpeg is there."""
    pattern = os.path.join(os.path.dirname(files[0]), "%05d.png")
    # Players want an even number of pixels, and the index before the pictures.
    return run("ffmpeg", ["-y", "-loglevel", "error", "-stream_loop", str(loops - 1), "-framerate", "%g" % (1000 / milliseconds),
                          "-i", pattern, "-frames:v", str(loops * len(files)), "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2",
                          "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", name])


def run(program, arguments):
    if not shutil.which(program):
        print("no %s: %s is not made. The frames are kept: install %s (Debian: apt install %s) and run the same command again" % (
            program, os.path.basename(arguments[-1]), program, PACKAGES[program]), flush=True)
        return False
    return subprocess.run([program, *arguments], check=False).returncode == 0
