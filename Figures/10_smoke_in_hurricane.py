# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 10: smoke in hurricane Jova, over the globe and the clouds of the same forecast, and puffs that move with the wind.

After the figure of flow volumes in Max, Crawfis and Becker (1993). Smoke is released from small polygons that face the wind: orange
around the storm, near the sea, where the air flows in and spirals up; blue inside the storm, at 7 km, where it rises on and leaves
in two streams. Heights are exaggerated 45 times. Every volume has one colour, so its cells need no order; the smoke is drawn
over the clouds, whichever is nearer.

Writes the picture (1920 x 1080), the ParaView state that shows it again, and a short film that loops. A longer and larger one:
    ./nephoscope pvbatch Figures/10_smoke_in_hurricane.py --frames 240 --size 1920 1080
Interrupted, it goes on with the next frame.
"""
import math
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
POLYGON_RADIUS = 3.2e4  # metres of the display
# Name, colour, degrees from the centre, metres above the sea, directions from the centre (degrees from east), hours, and the metres
# of the display over which smoke as dense as at the polygon has optical depth 1.
RELEASES = (
    ("Inflow", [1.0, 0.40, 0.05], 5.0, 1100, range(140, 280, 20), 30, 4.5e4),
    ("Outflow", [0.50, 0.92, 1.0], 2.2, 7000, range(0, 360, 40), 28, 6.0e4),
)
LONGEST_EDGE, SHORTEST_EDGE = 2.6e5, 8.0e4  # metres of the display: longer ones are divided, shorter ones merged
MAXIMUM_DENSITY = 3.0  # of that at the polygon: where the flow converges, smoke would become opaque
PERIOD = 6 * HOUR  # from puff to puff
PICTURE_FLOOR, FILM_FLOOR = 0.4, 0.1  # what stays between puffs
CLOUD_COLOURS = [0.0, 0.72, 0.75, 0.80, 1.0, 0.95, 0.96, 0.97]
# Cloud fraction: value, opacity, midpoint, sharpness.
CLOUD_OPACITY = [0.0, 0.0, 0.5, 0.0, 0.4, 0.0, 0.5, 0.0, 0.7, 0.3, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]
CLOUD_UNIT_DISTANCE = 6.0e5  # metres over which opacity 1 gives optical depth 1
MILLISECONDS = 80  # a frame is shown


def in_air(longitude, latitude, height):
    """Cartesian metres of the display: degrees, metres above the sea."""
    return globe_scene.on_globe(longitude, latitude, height=EXAGGERATION * height)


def release(forecast, degrees, height, directions, hours):
    """Smoke from polygons on a circle around the storm, as one volume."""
    volumes = []
    for direction in directions:
        east, north = math.cos(math.radians(direction)), math.sin(math.radians(direction))
        place = (CENTRE[0] + degrees * east / math.cos(math.radians(CENTRE[1])), CENTRE[1] + degrees * north, height)
        volumes.append(pvs.FlowVolume(Input=forecast, Center=in_air(*place), Radius=POLYGON_RADIUS, Duration=hours * HOUR,
                                      TimeStep=HOUR, PolygonEdgeLength=POLYGON_RADIUS, MaximumEdgeLength=LONGEST_EDGE,
                                      MinimumEdgeLength=SHORTEST_EDGE, MaximumNumberOfTetrahedra=1_000_000))
    return pvs.AppendDatasets(Input=volumes)


def show_smoke(forecast, view):
    """Returns the filters that make the puffs."""
    puffs = []
    for name, colour, *where, unit_distance in RELEASES:
        smoke = pvs.SmokePuffs(Input=release(forecast, *where), Period=PERIOD, TimeScale=DAY, Floor=PICTURE_FLOOR,
                               MaximumDensity=MAXIMUM_DENSITY, Association="Points")
        pvs.RenameSource(name, smoke)
        shown = pvs.Show(smoke, view)
        shown.SetRepresentationType("Cell Compositing")
        shown.ColorArrayName = ["POINTS", ""]
        shown.DiffuseColor = shown.AmbientColor = colour
        shown.CellCompositingAutomaticUnitDistance = 0
        shown.CellCompositingUnitDistance = unit_distance
        puffs.append(smoke)
    return puffs


def show_caption(view):
    caption = pvs.Text(Text="GFS forecast for 2011-10-11 00 UTC: hurricane Jova\n"
                            "Puffs of smoke every %.0f hours, from low around the storm (orange)\n"
                            "and high inside it (blue). Heights exaggerated %d times" % (PERIOD / HOUR, EXAGGERATION))
    shown = pvs.Show(caption, view)
    shown.WindowLocation, shown.FontSize, shown.Justification = "Lower Left Corner", 18, "Left"
    shown.Color = [0.75, 0.80, 0.88]
    return caption


def save_film(view, puffs):
    """Over one period: the frame after the last is the first."""
    for smoke in puffs:
        smoke.Floor = FILM_FLOOR
    start = view.ViewTime
    view.ViewSize = wanted.size
    view.CameraViewAngle = 15  # closer: frames are small

    def draw(i, file):
        view.ViewTime = start + i / wanted.frames * PERIOD / DAY
        pvs.SaveScreenshot(file, view, ImageResolution=wanted.size)

    frames.make_film(NAME, wanted, draw, MILLISECONDS)


wanted = frames.options("Smoke in a hurricane", frames=24, size=(480, 270)).parse_args()
pvs._DisableFirstRenderCameraReset()
view = globe_scene.make_view(
    "Smoke in a hurricane", position=globe_scene.on_globe(-112, -2, 2.1), focus=globe_scene.on_globe(-104.0, 19, 1.03),
    up=globe_scene.on_globe(*CENTRE), angle=20, sun=globe_scene.on_globe(-125, 25, 10))
globe_scene.show_terrain(view, ambient=0.2, diffuse=0.6, specular=0.1)
forecast = globe_scene.read_forecast(EXAGGERATION)
globe_scene.show_clouds(forecast, view, CLOUD_OPACITY, CLOUD_UNIT_DISTANCE, "cloud_fraction", CLOUD_COLOURS)
puffs = show_smoke(forecast, view)
caption = show_caption(view)
if not wanted.no_picture:
    globe_scene.save(NAME, view)
if wanted.frames > 0:
    pvs.Hide(caption, view)
    save_film(view, puffs)
