# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 10: smoke in hurricane Jova, in and behind the clouds of the same forecast and over its mountains, and puffs that move with the wind.

After the figure of flow volumes in Max, Crawfis and Becker (1993). Smoke is released from one polygon that faces the wind, south-west of the
storm and 1.5 km above the sea: part of it is drawn round the storm and up, part goes on to the east. Clouds and smoke are two volumes, drawn
as one medium where they overlap; the paper drew the cells of both in the order of their centroids. The mountains are opaque. Heights are
exaggerated 45 times.

Writes the picture (1920 x 1080), the ParaView state that shows it again, and a short film that loops. A longer and larger one:
    ./nephoscope pvbatch Figures/10_smoke_in_hurricane.py --frames 240 --size 1920 1080
Interrupted, it goes on with the next frame.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import frames  # noqa: E402
import globe_scene  # noqa: E402

NAME = "10_smoke_in_hurricane"
EXAGGERATION = 45
HOUR = 3600.0  # seconds
DAY = 86400.0  # the unit of the forecast's time, in seconds
CENTRE = (-105.0, 17.0)  # of the storm, degrees
SMOKE_FROM = (-106.4, 12.2, 1800)  # degrees, metres above the sea
POLYGON_RADIUS = 7e4  # metres of the display
DURATION = 40 * HOUR
LONGEST_EDGE, SHORTEST_EDGE = 2.0e5, 4.0e4  # metres of the display: longer ones are divided, shorter ones merged
MAXIMUM_DENSITY = 3.0  # of that at the polygon: where the flow converges, smoke would become opaque
PERIOD = 6 * HOUR  # from puff to puff
PICTURE_FLOOR, FILM_FLOOR = 0.4, 0.1  # what stays between puffs
CLOUD_DISTANCE = 2.0e4  # metres of the display over which opacity 1 gives optical depth 1
SMOKE_DISTANCE = 4.0e4  # the same of the density at the polygon
THIN_CLOUD, CLOUD_OPACITY = 0.4, 0.05  # least fraction that is seen; opacity of full cloud
CLOUD_COLOURS = [0.0, 0.72, 0.75, 0.80, 1.0, 0.95, 0.96, 0.97]
ORANGE = [1.0, 0.40, 0.05]
# Value, opacity, midpoint, sharpness.
IN_CLOUD = [0.0, 0.0, 0.5, 0.0, THIN_CLOUD, 0.0, 0.5, 0.0, 0.7, 0.3 * CLOUD_OPACITY, 0.5, 0.0, 1.0, CLOUD_OPACITY, 0.5, 0.0]
IN_SIGHT = [76, 128, 12, 72, 0, 20]  # longitudes 170 to 40 degrees west, latitudes from 60 south, all levels
MILLISECONDS = 80  # a frame is shown


def in_air(longitude, latitude, height):
    """Cartesian metres of the display: degrees, metres above the sea."""
    return globe_scene.on_globe(longitude, latitude, height=EXAGGERATION * height)


def smoke_puffs(forecast):
    smoke = pvs.FlowVolume(Input=forecast, Center=in_air(*SMOKE_FROM), Radius=POLYGON_RADIUS, Duration=DURATION, TimeStep=HOUR,
                           PolygonEdgeLength=POLYGON_RADIUS / 4, MaximumEdgeLength=LONGEST_EDGE, MinimumEdgeLength=SHORTEST_EDGE,
                           MaximumNumberOfTetrahedra=1_000_000)
    return pvs.SmokePuffs(Input=smoke, Period=PERIOD, TimeScale=DAY, Floor=PICTURE_FLOOR, MaximumDensity=MAXIMUM_DENSITY,
                          Association="Points")


def show_clouds(forecast, view):
    near = pvs.ExtractSubset(Input=forecast, VOI=IN_SIGHT)
    globe_scene.show_volume(near, view, "cloud_fraction", CLOUD_COLOURS, IN_CLOUD, CLOUD_DISTANCE)


def show_smoke(puffs, view):
    """One colour, as opaque as it is dense."""
    shown = pvs.Show(puffs, view)
    pvs.ColorBy(shown, None)
    shown.SetRepresentationType("Cell Compositing")
    shown.DiffuseColor = shown.AmbientColor = ORANGE
    shown.CellCompositingAutomaticUnitDistance, shown.CellCompositingUnitDistance = 0, SMOKE_DISTANCE


def show_caption(view):
    caption = pvs.Text(Text="GFS forecast for 2011-10-11 00 UTC: hurricane Jova\n"
                            "Smoke from one polygon, in puffs every %.0f hours\n"
                            "Heights exaggerated %d times" % (PERIOD / HOUR, EXAGGERATION))
    shown = pvs.Show(caption, view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Lower Left Corner", 18, "Left"
    shown.Color = [0.75, 0.80, 0.88]
    return caption


def save_film(view, puffs):
    """Over one period: the frame after the last is the first."""
    puffs.Floor = FILM_FLOOR
    start = view.ViewTime
    view.ViewSize = wanted.size

    def draw(i, file):
        view.ViewTime = start + i / wanted.frames * PERIOD / DAY
        pvs.SaveScreenshot(file, view, ImageResolution=wanted.size)

    frames.make_film(NAME, wanted, draw, MILLISECONDS)


wanted = frames.options("Smoke in a hurricane", frames=24, size=(480, 270)).parse_args()
pvs._DisableFirstRenderCameraReset()
view = globe_scene.make_view(
    "Smoke in a hurricane", position=globe_scene.on_globe(-112, -2, 2.1), focus=globe_scene.on_globe(-103, 18.5, 1.04),
    up=globe_scene.on_globe(*CENTRE), angle=17, sun=globe_scene.on_globe(-125, 25, 10))
globe_scene.drape_picture(globe_scene.show_ground(view, EXAGGERATION, ambient=0.3, diffuse=1.0))
forecast = globe_scene.read_forecast(EXAGGERATION)
puffs = smoke_puffs(forecast)
show_clouds(forecast, view)
show_smoke(puffs, view)
caption = show_caption(view)
if not wanted.no_picture:
    globe_scene.save(NAME, view)
if wanted.frames > 0:
    pvs.Hide(caption, view)
    save_film(view, puffs)
