# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 23: hurricane Jova at dawn, seen from 20 degrees above the horizon of its centre.

The clouds of the forecast for 2011-10-11 00 UTC have moved with its wind for 13 hours, until the sun rises over the storm, and a cloud generator has made them finer
(common/storm_clouds.py): bands and gaps of less than 2.5 degrees are made up. vtkSunlight computes the light, with shadows and the night in the west; the colours of the low sun,
the air and the sun's reflection in the sea are those of common/air.py and common/sunlit.py. Heights are exaggerated 6 times. Writes the picture (1920 x 1080).
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import numpy  # noqa: E402
import storm_clouds  # noqa: E402
import sunlit  # noqa: E402
from globe_scene import on_globe  # noqa: E402

NAME = "23_hurricane_at_dawn"
EXAGGERATION = 6
CENTRE = (-105.0, 17.0)  # of the storm, degrees
HOURS, DAWN = 13, "2011-10-11 13:17"  # UTC; the sun is 5 degrees above the horizon
ELEVATION, AZIMUTH, DISTANCE = 20, 42, 2.3e6  # of the eye above the horizon of the storm, degrees; of the view, degrees east of north; metres
ANGLE = 21  # of view, degrees
FOCUS = 0.7e5  # metres of the display above the storm
WIND = 12  # m/s, over the sea
# The light to this power is displayed with the curve "contrast", which squares it: between the contrast of nature and that of the curve.
EXPOSURE, POWER = 1.7, 0.75


def eye():
    """The position of the eye, and the vertical of the storm."""
    up, east = numpy.array(on_globe(*CENTRE)), numpy.array(on_globe(CENTRE[0] + 90, 0))
    up, east = up / numpy.linalg.norm(up), east / numpy.linalg.norm(east)
    azimuth, elevation = numpy.radians([AZIMUTH, ELEVATION])
    ahead = numpy.sin(azimuth) * east + numpy.cos(azimuth) * numpy.cross(up, east)
    return on_globe(*CENTRE) + DISTANCE * (numpy.sin(elevation) * up - numpy.cos(elevation) * ahead), up


options = argparse.ArgumentParser(description="A hurricane at dawn: a picture.")
options.add_argument("--step", type=float, default=0.1, help="degrees between the points of the clouds")
options.add_argument("--size", type=int, nargs=2, default=[1920, 1080], help="width and height, pixels")
wanted = options.parse_args()
position, up = eye()
fields = storm_clouds.moved_grid((-121, -89), (5, 31), wanted.step, HOURS, seed=4)
clouds = sunlit.lit_clouds(fields, EXAGGERATION, DAWN, position)
view = sunlit.View(sunlit.camera(position, on_globe(*CENTRE, height=FOCUS), up, ANGLE), wanted.size, 1)
light = view.globe(clouds, EXAGGERATION, wind=WIND, colours=True)
sunlit.write(light**POWER, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], NAME + ".png"), EXPOSURE, "contrast")
