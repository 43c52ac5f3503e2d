# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 9: clouds that move with the wind: the smoothed surface of 15 % cloud cover through 24 hours, 96 frames of 15 minutes.

After figure 9 and the animation of Max, Crawfis and Becker (1993), without the texture. The clouds are those of the time series that
`./nephoscope forecast` makes (NEPHOSCOPE_FORECAST), interpolated between its hours. Writes a picture and a film; interrupted, it goes
on with the next frame. A larger film:
    ./nephoscope demo 09     then     ./nephoscope pvbatch Figures/09_moving_clouds.py --size 1920 1080
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import cloud_surface_scene  # noqa: E402
import frames  # noqa: E402
import globe_scene  # noqa: E402

SERIES = os.environ["NEPHOSCOPE_FORECAST"]
NAME = "09_moving_clouds"
MINUTES = 15  # from frame to frame
PICTURE_HOUR = 12
MILLISECONDS = 60  # a frame is shown


def moving_clouds():
    """(times of the series in hours, the surface at the view's time)."""
    series = pvs.NetCDFReader(FileName=[SERIES], SphericalCoordinates=0)
    series.Dimensions = "(lev, lat, lon)"
    series.UpdatePipelineInformation()
    between = pvs.TemporalInterpolator(Input=series)
    grid = pvs.GlobeGrid(Input=between, VerticalExaggeration=cloud_surface_scene.EXAGGERATION)
    return list(series.TimestepValues), cloud_surface_scene.cloud_surface(grid, iterations=1)


def save_film(view, start):
    def draw(i, file):
        view.ViewTime = start + i * MINUTES / 60.0
        pvs.SaveScreenshot(file, view, ImageResolution=wanted.size)

    frames.make_film(NAME, wanted, draw, MILLISECONDS, [os.path.getsize(SERIES), os.path.getmtime(SERIES)])


wanted = frames.options("Clouds that move with the wind", frames=96, size=(640, 360)).parse_args()
pvs._DisableFirstRenderCameraReset()
view = cloud_surface_scene.make_view("Moving clouds")
globe_scene.show_terrain(view, ambient=0.5, diffuse=1.0)
times, clouds = moving_clouds()
cloud_surface_scene.show_surface(clouds, view)
if not wanted.no_picture:
    caption = cloud_surface_scene.show_caption(view, "Clouds after %d hours in the wind of a barotropic forecast" % PICTURE_HOUR)
    view.ViewTime = times[0] + PICTURE_HOUR
    globe_scene.save(NAME, view, cloud_surface_scene.SIZE)
    pvs.Hide(caption, view)
if wanted.frames > 0:
    view.ViewSize = wanted.size
    save_film(view, times[0])
