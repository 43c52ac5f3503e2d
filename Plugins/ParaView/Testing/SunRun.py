# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that SunRanks.py compares.

Usage: SunRun.py PREFIX [PORT NAMES]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from PluginTesting import GFS, image, load_plugin, new_view, passed, pvs, set_background, solid, wanted


def draw_shadows():
    """Clouds of one rank cast their shadows into the parts of the others."""
    view = new_view((120, 90))
    lumps = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="Extinction", Function="if(RTData>160,0.4,0)")
    lit = pvs.Sunlight(Input=lumps, SunDirection=[2, 1, 0.5])
    pvs.Show(lit, view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [50, -60, -20], [0, 0, 0], [0, 0, 1]
    np.save(f"{sys.argv[1]}-shadows.npy", image(view))
    pvs.Delete(view)


def draw_splats():
    """Light that follows the camera, on splats, which each rank moves to those that draw them."""
    view = new_view((120, 90))
    lumps = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="Extinction", Function="max(0, RTData - 130) * 0.005")
    pvs.Show(pvs.Sunlight(Input=lumps, SunDirection=[1, 0, 0.2], FollowCamera=1, OpenSides=1), view).SetRepresentationType("Textured Splats")
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-50, 10, -20], [0, 0, 0], [0, 0, 1]
    np.save(f"{sys.argv[1]}-splats.npy", image(view))
    pvs.Delete(view)


def draw_shafts():
    """Haze below a cloud with gaps, whose parts are on several ranks: it has the shadows of the whole cloud."""
    view = new_view((120, 90))
    lumps = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 4]), ResultArrayName="Extinction", Function="if(RTData>170,0.6,0)")
    sun = pvs.Sun(SunDirection=[1, 0, 3])
    pvs.Show(pvs.Sunlight(Input=lumps, Sun=sun), view)
    solid(pvs.Show(pvs.Plane(Origin=[-40, -40, -12], Point1=[40, -40, -12], Point2=[-40, 40, -12]), view), [0.1, 0.1, 0.1])
    pvs.Show(sun, view)
    haze = pvs.Show(pvs.Haze(), view)
    haze.VisualRange, haze.ScaleHeight, haze.Asymmetry, haze.HazeBackground, haze.HazeColor = 70, 15, 0, 0, [0.8, 0.8, 0.8]
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -35, 10], [0, 0, -8], [0, 0, 1]
    set_background(view, (0, 0, 0.2))
    for name, cast in (("shafts", 1), ("shadowless haze", 0)):
        haze.CloudShadows = cast
        np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    pvs.Delete(view)
    pvs.Delete(sun)


def draw_clouds(view, sun):
    clouds = pvs.CloudsovertheGlobe()
    pvs.Show(pvs.Sunlight(Input=pvs.CloudOptics(Input=clouds), Sun=sun), view)
    pvs.Show(pvs.OutputPort(clouds, 1), view)
    pvs.Show(sun, view)
    np.save(f"{sys.argv[1]}-clouds.npy", image(view))


if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
pvs._DisableFirstRenderCameraReset()  # whichever picture is the first
if wanted("shadows"):
    draw_shadows()
if wanted("splats"):
    draw_splats()
if wanted("shafts"):
    draw_shafts()
sun = pvs.Sun(DateTime="2011-10-11 18:00")
view = new_view((120, 90))
globe = pvs.GlobeGrid(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VerticalExaggeration=30)
ground = pvs.ExtractSubset(Input=globe, VOI=[0, 10000, 0, 10000, 0, 0])
solid(pvs.Show(ground, view), [0.9, 0.7, 0.5])
pvs.Show(sun, view)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -2.6e7, 1e7], [0, 0, 0], [0, 0, 1]
set_background(view, (0, 0, 0.2))
for name, hours in (("noon", 0), ("evening", 5)):
    sun.HoursLater = hours
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
for each in pvs.GetSources().values():
    pvs.Hide(each, view)
if wanted("clouds"):
    draw_clouds(view, sun)
passed()
