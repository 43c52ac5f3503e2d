# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces for the tests of Cloud Texture."""
from PluginTesting import GFS, new_view, pvs, set_background

CLOUDS = "Cloud Texture"


def sheet():
    return pvs.Plane(XResolution=40, YResolution=40)


def sheet_view():
    """The sheet, from -0.5 to 0.5, fills it."""
    view = new_view((200, 200))
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.5
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, 0, 10], [0, 0, 0], [0, 1, 0]
    set_background(view, (0, 0, 0))
    return view


def moving_clouds(rate=3):
    """The analysis as a steady wind, time in days: texture advection, and the surface of 15 % cover behind it."""
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0),
                                VOI=[0, 10**6] * 3, SampleRateI=rate, SampleRateJ=rate)
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=40)
    globe.UpdatePipeline()
    texture = pvs.TextureCoordinateAdvection(Input=globe, TimeScale=86400, TimeStep=7200)
    return texture, pvs.CloudSurface(Input=texture, ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15])
