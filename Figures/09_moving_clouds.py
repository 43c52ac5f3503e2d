# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 9: textured clouds that move with the wind for 24 hours, 96 frames of 15 minutes, in a film that loops; or for some days, without a loop.

After figure 9 and the animation of Max, Crawfis and Becker (1993). The clouds and the winds are those of the time series that
`./nephoscope forecast` makes (NEPHOSCOPE_FORECAST); in the first hours of the loop the end of the day turns into its beginning. Writes a
picture and a film; interrupted, it goes on with the next frame. Larger, and the film of ten days:
    ./nephoscope demo 09     then     ./nephoscope pvbatch Figures/09_moving_clouds.py --no-picture --size 1920 1080
    ./nephoscope film
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import frames  # noqa: E402
import moving_clouds  # noqa: E402
import pictures  # noqa: E402

NAME = "09_moving_clouds"
PICTURE_HOUR = 18
DAY = moving_clouds.DAY
FRAMES_A_DAY = 96  # one every 15 minutes; coordinates are computed every hour
MILLISECONDS, VIDEO_MILLISECONDS = 60, 40  # a frame is shown: in the loop, and in the film of days


def save_picture():
    window, renderer, clouds = moving_clouds.scene((1920, 1080), wanted.series)
    clouds.update(PICTURE_HOUR)
    moving_clouds.add_caption(renderer, "Hour %d of the film" % PICTURE_HOUR)
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"))


def film_of_days():
    window, _, clouds = moving_clouds.scene(wanted.size, wanted.series, wanted.life, loop=wanted.days is None)
    if wanted.days and clouds.hours() < DAY * wanted.days:
        raise SystemExit("%s has %g hours, %d days need %g; ./nephoscope film --days %d makes a longer series" % (
            wanted.series, clouds.hours(), wanted.days, DAY * wanted.days, wanted.days))
    return window, clouds


def save_film():
    window, clouds = film_of_days()
    hours, drawn = DAY * (wanted.days or 1), []

    def draw(i, file):
        clouds.update(hours * i / wanted.frames)
        with clouds.watch.part("drawing"):
            window.Render()
        with clouds.watch.part("writing"):
            pictures.write(window, file, announce=False)
        drawn.append(i)

    name = NAME if wanted.days is None else "%s_%d_days" % (NAME, wanted.days)
    settings = [wanted.series, os.path.getsize(wanted.series), os.path.getmtime(wanted.series), wanted.life, wanted.days]
    frames.make_film(name, wanted, draw, MILLISECONDS if wanted.days is None else VIDEO_MILLISECONDS, settings, 3 if wanted.days is None else 1)
    if drawn:
        print(clouds.watch.report(len(drawn)), flush=True)


options = frames.options("Clouds that move with the wind", frames=None, size=(960, 540))
options.add_argument("--series", default=os.environ["NEPHOSCOPE_FORECAST"], help="CF file of winds and clouds, 36 hours at least")
options.add_argument("--life", type=float, default=moving_clouds.PERIOD, help="hours that a set of texture coordinates lives; in a loop 24 must be a multiple")
options.add_argument("--days", type=int, help="that many days of the series, without a loop")
wanted = options.parse_args()
if wanted.life <= 0 or (wanted.days is None and DAY % wanted.life):
    options.error("--life must be above 0, and go into the 24 hours of a loop a whole number of times")
if not os.path.exists(wanted.series):
    options.error("there is no series %s; ./nephoscope forecast makes one" % wanted.series)
if wanted.frames is None:
    wanted.frames = FRAMES_A_DAY * (wanted.days or 1)
if not wanted.no_picture:
    save_picture()
if wanted.frames > 0:
    save_film()
