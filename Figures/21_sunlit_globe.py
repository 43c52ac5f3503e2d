# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 21: the clouds of a weather forecast over the globe in low sun, with their shadows, up to the night.

Clouds are made finer than the forecast by a cloud generator (common/fine_clouds.py). vtkCloudOptics gives their extinction, vtkSunlight their light, vtkCellCompositingMapper draws
them in floating point. The ground is Blue Marble in the light that comes through the clouds; the air scatters light once (common/air.py). Heights are exaggerated
20 times. Writes the picture (1920 x 1080), and a film of a day, in which the sun goes round, with coarser clouds.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import fine_clouds  # noqa: E402
import frames  # noqa: E402
import sunlit  # noqa: E402
from globe_scene import on_globe  # noqa: E402

NAME = "21_sunlit_globe"
EXAGGERATION = 20
EXPOSURE = 2.0
EYE = on_globe(-106, 17, 3.25)
SUN = on_globe(-172, 4)


def view(size, samples):
    return sunlit.View(sunlit.camera(EYE, on_globe(-103, 12, 0.05), (0, 0, 1), 39), size, samples)


def save_picture():
    clouds = sunlit.lit_clouds(fine_clouds.fine_grid((-178, -34), (-54, 78), wanted.step), EXAGGERATION, SUN, EYE)
    light = view((1920, 1080), 1).globe(clouds, EXAGGERATION)
    sunlit.write(light, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"), EXPOSURE)


def save_film():
    fields = fine_clouds.fine_grid((-178, -34), (-54, 78), 2.0)

    def draw(i, file):
        sun = on_globe(-106 - 360 * (i + 0.5) / wanted.frames, -7)
        clouds = sunlit.lit_clouds(fields, EXAGGERATION, sun, EYE)
        sunlit.write(view(wanted.size, 1).globe(clouds, EXAGGERATION), file, EXPOSURE, announce=False)

    frames.make_film(NAME, wanted, draw, 100, [])


options = frames.options("Clouds in low sun", frames=36, size=(640, 360))
options.add_argument("--step", type=float, default=0.7, help="degrees between the points of the picture's clouds")
wanted = options.parse_args()
if not wanted.no_picture:
    save_picture()
if wanted.frames > 0:
    save_film()
