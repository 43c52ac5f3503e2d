# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views in which much of the background is seen through haze."""
import os

from HazeScenes import show
from PluginTesting import DATA, compose, new_view, pvs, solid, wanted

FORECAST = os.path.join(DATA, "forecast_10deg_6h.nc")
SIZE = (120, 90)
AXES = {"+x": (1, 0, 0), "-x": (-1, 0, 0), "+y": (0, 1, 0), "-y": (0, -1, 0), "+z": (0, 0, 1), "-z": (0, 0, -1)}


def gradient(view):
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = [0.4, 0.1, 0.0], [0.0, 0.1, 0.5]


def picture(view):
    view.BackgroundColorMode = "Texture"
    texture = pvs.CreateTexture(os.path.join(DATA, "blue_marble_2048.jpg"))
    texture.SMProxy.MarkAllPropertiesAsModified()  # ParaView 5.13 reads the file only when all is sent once more
    texture.SMProxy.UpdateVTKObjects()
    view.BackgroundTexture = texture


def place_camera(view, position, focal_point, up=(0, 0, 1)):
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = list(position), list(focal_point), list(up)


def globe():
    """Clouds before the ground; above the limb haze lies before a gradient."""
    view = new_view(SIZE)
    clouds = pvs.GlobeGrid(Input=pvs.NetCDFReader(FileName=[FORECAST], SphericalCoordinates=0), VerticalExaggeration=30)
    compose(clouds, view, ("POINTS", "cloud_fraction"))
    ground = pvs.ExtractSubset(Input=clouds, VOI=[0, 100, 0, 100, 0, 0])
    solid(pvs.Show(ground, view), [0.2, 0.4, 0.2])
    pvs.Show(pvs.Haze(), view)
    place_camera(view, (0, -1.2e7, 7e6), (0, -3e6, 5e6))
    gradient(view)
    return view


def terrain():
    """Only opaque surfaces, composited by depth, before an image."""
    view = new_view(SIZE)
    ground = pvs.Slice(Input=pvs.Wavelet(), SliceType="Plane")
    ground.SliceType.Normal = [0, 0, 1]
    hills = pvs.WarpByScalar(Input=ground, Scalars=["POINTS", "RTData"], ScaleFactor=0.03)
    solid(pvs.Show(hills, view), [0.3, 0.5, 0.2])
    pvs.Show(pvs.Haze(), view).VisualRange = 60
    place_camera(view, (3, -20, 12), (0, 0, 7))
    picture(view)
    return view


def flat_map():
    """From above, with parallel rays, beside the data: rays end at altitude 0."""
    view = new_view(SIZE)
    compose(pvs.Wavelet(WholeExtent=[-6, 6, -4, 4, 0, 4]), view)
    solid(pvs.Show(pvs.Plane(Origin=[-5, -6, 0], Point1=[3, -6, 0], Point2=[-5, 6, 0]), view), [0.2, 0.5, 0.1])
    pvs.Show(pvs.Haze(), view).VisualRange = 20
    place_camera(view, (0, 0, 30), (0, 0, 0), (0, 1, 0))
    view.CameraParallelProjection, view.CameraParallelScale = 1, 8
    gradient(view)
    return view


def inside():
    """The eye is in the haze, amid the cells and balls. `look_along` turns the view."""
    view = new_view(SIZE)
    display = compose(pvs.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6]), view)
    display.CellCompositingAutomaticUnitDistance, display.CellCompositingUnitDistance = 0, 12
    for number, direction in enumerate(AXES.values()):
        show(pvs.Sphere(Center=[4 * d + (number - 2) / 2 for d in direction], Radius=0.7), view, [0.8, 0.3, 0.1])
    pvs.Show(pvs.Haze(), view).VisualRange = 50
    look_along(view, (1, 0, 0))
    gradient(view)
    return view


def look_along(view, direction):
    place_camera(view, (0, 0, 0), direction, (0, 1, 0) if direction[2] else (0, 0, 1))


def skies():
    """(name, view) of every picture that is wanted."""
    for build in (globe, terrain, flat_map):
        name = build.__name__.replace("_", " ")
        if wanted(name):
            yield name, build()
    directions = {f"inside {name}": axis for name, axis in AXES.items() if wanted(f"inside {name}")}
    view = inside() if directions else None
    for name, axis in directions.items():
        look_along(view, axis)
        yield name, view
