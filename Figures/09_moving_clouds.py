# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 9: textured clouds that move with the wind for 24 hours, 96 frames of 15 minutes, in a film that loops.

After figure 9 and the animation of Max, Crawfis and Becker (1993). The clouds and the winds are those of the time series that
`./nephoscope forecast` makes (NEPHOSCOPE_FORECAST); in the first hours of the film the end of the day turns into its beginning. Writes a
picture and a film; interrupted, it goes on with the next frame. A larger film:
    ./nephoscope demo 09     then     ./nephoscope pvbatch Figures/09_moving_clouds.py --no-picture --size 1920 1080
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import frames  # noqa: E402
import moving_clouds  # noqa: E402
import pictures  # noqa: E402

NAME = "09_moving_clouds"
PICTURE_HOUR = 18
MILLISECONDS = 60  # a frame is shown


def save_picture():
    window, renderer, clouds = moving_clouds.scene((1920, 1080), wanted.series)
    clouds.update(PICTURE_HOUR)
    moving_clouds.add_caption(renderer, "Hour %d of the film" % PICTURE_HOUR)
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"))


def save_film():
    window, _, clouds = moving_clouds.scene(wanted.size, wanted.series)
    drawn = []

    def draw(i, file):
        clouds.update(moving_clouds.DAY * i / wanted.frames)
        with clouds.watch.part("drawing"):
            window.Render()
        with clouds.watch.part("writing"):
            pictures.write(window, file, announce=False)
        drawn.append(i)

    frames.make_film(NAME, wanted, draw, MILLISECONDS, [wanted.series, os.path.getsize(wanted.series), os.path.getmtime(wanted.series)])
    if drawn:
        print(clouds.watch.report(len(drawn)), flush=True)


options = frames.options("Clouds that move with the wind", frames=96, size=(960, 540))
options.add_argument("--series", default=os.environ["NEPHOSCOPE_FORECAST"], help="CF file of winds and clouds, 36 hours at least")
wanted = options.parse_args()
if not wanted.no_picture:
    save_picture()
if wanted.frames > 0:
    save_film()
