# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 2: winds of a weather forecast at three levels around the globe, as line segments coloured by altitude, and a film that loops.

After figure 2 of Max, Crawfis and Becker (1993). The segments are drawn on textured splats, each somewhere in its cell, longer and more
opaque where the wind is faster, and so long that they interleave. Winds on the far side of the planet are left out. A second picture has
streaks instead, whose bright heads are in front.

Writes the pictures (1920 x 1080) and a film, over which every segment moves on by a whole number of its lengths. A larger one:
    ./nephoscope pvbatch Figures/02_winds_over_globe.py --frames 120 --size 1920 1080
Interrupted, it goes on with the next frame.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import frames  # noqa: E402
import globe_scene  # noqa: E402
import pictures  # noqa: E402
import splat_scene  # noqa: E402
import vtk_globe  # noqa: E402

GALLERY = os.environ["NEPHOSCOPE_GALLERY"]
NAME = "02_winds_over_globe"
EXAGGERATION = 25  # more of it would fill the limb with streaks
PRESSURES = (850, 500, 250)  # hPa: trade winds and storms, steering flow, jet streams
HORIZON = 0.12  # least cosine between the vertical and the direction of the eye
GREATEST_SPEED = 32  # metres per second, at which segments and streaks are longest
UNIT = 2.2e5  # metres of the display, in which their lengths count
SEGMENTS = {"opacity": 4, "length": 4.5, "unit": UNIT}
SEGMENT_WIDTH = 1 / 600  # of the height of the picture
STREAKS = {"opacity": 6, "width": 0.07, "period": 5, "unit": UNIT}
CYCLES = 3  # lengths that the fastest segments move on in the film
MILLISECONDS = 80  # a frame is shown
EYE = globe_scene.on_globe(-105, 22, 3.6)  # over the eastern Pacific, where two hurricanes are


def scene(size):
    """Window, renderer and the mapper of the winds."""
    forecast, pressures = splat_scene.read_forecast(EXAGGERATION)
    splat_scene.choose_winds(forecast, splat_scene.level_numbers(pressures, PRESSURES), EYE, HORIZON)
    window, renderer = splat_scene.make_window(size, EYE, [0, 0, 0], [0, 0, 1], 34, globe_scene.on_globe(-92, 32, 10))
    renderer.AddActor(vtk_globe.terrain(ambient=0.55, diffuse=0.5))
    winds = splat_scene.splats(forecast, ((0, 0), (1, 0)), 1e5)  # no clouds
    splat_scene.show_segments(winds.GetMapper(), GREATEST_SPEED, pixels=SEGMENT_WIDTH * size[1], **SEGMENTS)
    renderer.AddVolume(winds)
    renderer.ResetCameraClippingRange()
    splat_scene.add_altitude_bar(renderer, font_size=round(24 * size[1] / 1080))
    return window, renderer, winds.GetMapper()


def save_pictures():
    window, renderer, mapper = scene((1920, 1080))
    caption = splat_scene.add_caption(renderer, "")
    words = ("Winds at 850, 500 and 250 hPa\n%%slonger where\nfaster, longest from %d m/s\nHeights exaggerated %d times\n"
             "GFS forecast for 2011-10-11 00 UTC" % (GREATEST_SPEED, EXAGGERATION))

    def save(name, how):
        caption.SetInput(words % how)
        window.Render()
        pictures.write(window, os.path.join(GALLERY, name + ".png"))

    save(NAME, "Line segments, ")
    mapper.SetVectorStyleToStreaks()
    splat_scene.show_winds(mapper, GREATEST_SPEED, **STREAKS)
    save("02_winds_as_streaks", "Bright end in front, ")


def save_film():
    """The frame after the last is the first."""
    window, _, mapper = scene(wanted.size)
    mapper.SetPhaseCycles(CYCLES)

    def draw(i, file):
        mapper.SetPhase(i / wanted.frames)
        window.Render()
        pictures.write(window, file, announce=False)

    frames.make_film(NAME, wanted, draw, MILLISECONDS)


wanted = frames.options("Winds over the globe", frames=36, size=(960, 540)).parse_args()
if not wanted.no_picture:
    save_pictures()
if wanted.frames > 0:
    save_film()
