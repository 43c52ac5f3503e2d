# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 22: the same clouds flat and lit, side by side: hurricanes Irwin and Jova from above.

On the left every cloud sends the same light and the ground is fully lit, as volumes are usually drawn: emission and absorption, white on white. On the right vtkSunlight has computed
the light of a morning sun: shadows on clouds and sea, dark bases, multiple scattering; the air in front is that of common/air.py. Extinction, camera and opacities are the same. The clouds are
those of the forecast for 2011-10-11 00 UTC, moved by its wind for 14 hours and made finer (common/storm_clouds.py). Heights are exaggerated 6 times. Writes the
picture (1920 x 1080).
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import numpy  # noqa: E402
import storm_clouds  # noqa: E402
import sunlit  # noqa: E402
from globe_scene import on_globe  # noqa: E402

NAME = "22_flat_and_lit_clouds"
EXAGGERATION = 6
HOURS, MORNING = 14, "2011-10-11 14:15"  # UTC
EYE, FOCUS = on_globe(-113, 1, 1.42), on_globe(-109.5, 15.5)
ANGLE = 31  # of view, degrees
WHITE = 0.9  # light of flat clouds
EXPOSURE, POWER = 1.9, 0.75  # as in figure 23
GAP = 4  # pixels between the halves

options = argparse.ArgumentParser(description="Clouds flat and lit: a picture.")
options.add_argument("--step", type=float, default=0.15, help="degrees between the points of the clouds")
options.add_argument("--size", type=int, nargs=2, default=[1920, 1080], help="width and height, pixels")
wanted = options.parse_args()
fields = storm_clouds.moved_grid((-128, -90), (3, 32), wanted.step, HOURS, seed=4)
clouds = sunlit.lit_clouds(fields, EXAGGERATION, MORNING, EYE)
width = (wanted.size[0] - GAP) // 2
view = sunlit.View(sunlit.camera(EYE, FOCUS, (0, 0, 1), ANGLE), (width, wanted.size[1]), 1)
flat = view.globe(clouds, EXAGGERATION, flat=WHITE)
lit = view.globe(clouds, EXAGGERATION, wind=7, colours=True)
pictures = sunlit.shown(flat, 1.0, "linear"), sunlit.shown(lit**POWER, EXPOSURE, "contrast")
gap = numpy.zeros((wanted.size[1], wanted.size[0] - 2 * width, 3), numpy.uint8)
sunlit.save(numpy.hstack([pictures[0], gap, pictures[1]]), os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"))
