# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texture Coordinate Advection in ParaView: menu, defaults, help, settings that arrive, a steady wind animated, points."""
import os

import nephoscope
import numpy as np
from PluginDefinitions import compare_default, definition, nested, own_properties
from PluginTesting import DATA, GFS, check, load_plugin, passed, pvs, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

NAME = "TextureCoordinateAdvection"
INFORMATION = {"TimestepValues", "TimeRange"}
RESULTS = {"PeriodUsed", "TimeStepUsed"}  # in the panel, not to be set
UNITS = ("(times in s)", "(velocity in length/s, times in s, pressure in Pa)", "(lengths)", "(1/s)")  # of the groups


def check_definition():
    element = definition("filters", NAME)
    check(nested(element, "Hints")[0].GetNestedElement(0).GetAttribute("category") == "Nephoscope", "not in the menu Nephoscope")
    properties = own_properties(element)
    filter_ = nephoscope.vtkTextureCoordinateAdvection()
    settable = {n[3:] for n in dir(filter_) if n.startswith("Get") and hasattr(filter_, "Set" + n[3:])}
    inherited = {n[3:] for n in dir(nephoscope.vtkTextureCoordinateAdvection.__bases__[0]) if n.startswith("Get")}
    expected = (settable - inherited) | {"SelectInputVectors"}
    own = set(properties) - INFORMATION - RESULTS
    check(expected == own, f"C++ and XML differ in {sorted(expected ^ own)}")
    for name in settable - inherited:
        compare_default(NAME, name, properties[name], getattr(filter_, "Get" + name)())
    for name, property_ in properties.items():
        check(nested(property_, "Documentation"), f"{name} has no help")
    labels = [g.GetAttribute("label") for g in nested(element, "PropertyGroup")]
    check(all(label.endswith(unit) for label, unit in zip(labels, UNITS)), f"groups without units: {labels}")
    grouped = {p.GetAttribute("name") for g in nested(element, "PropertyGroup") for p in nested(g, "Property")}
    check(grouped == set(properties) - INFORMATION, f"not in a group: {sorted(grouped ^ (set(properties) - INFORMATION))}")


def fetched(proxy, time):
    pvs.UpdatePipeline(time=time, proxy=proxy)
    data = servermanager.Fetch(proxy)
    values = data.GetPointData().GetArray("TextureCoordinates1")
    check(values is not None, "no coordinates")
    return vtk_to_numpy(values), vtk_to_numpy(data.GetFieldData().GetArray("TextureWeights"))


def check_points(series):
    """Clouds of the Globe Grid that gives the winds too, also after the last time of the file."""
    weather = pvs.NetCDFReader(FileName=[series], SphericalCoordinates=0)
    weather.Dimensions = "(lev, lat, lon)"
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=40)
    globe.UpdatePipeline()
    clouds = pvs.CloudSurface(Input=globe, ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15])
    texture = pvs.TextureCoordinateAdvection(Input=globe, Points=clouds, TimeScale=3600)
    alone = pvs.CloudSurface(Input=pvs.TextureCoordinateAdvection(Input=globe, TimeScale=3600), ContourBy=["POINTS", "cloud_fraction"],
                             ContourValues=[0.15])
    for time in (6792, 6795, 6793, 6798, 6799):
        surface, weights = fetched(texture, time)
        interpolated, _ = fetched(alone, time)
        check(len(surface) == len(interpolated) > 1000, f"{len(surface)} points at {time}, {len(interpolated)} without the points input")
        # Latitudes: two ways to the same place, but for the contour's interpolation of coordinates between points 10 degrees apart.
        difference = np.abs(surface[:, 1] - interpolated[:, 1])
        check(np.median(difference) < 1e-4, f"coordinates differ by {np.median(difference)} at {time}")


def check_period():
    """From the size and the speed of the data, where they are not of Globe Grid; a steady wind is animated for as long."""
    wind = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="v", Function="3*iHat+4*jHat")
    wind.UpdatePipeline()
    texture = pvs.TextureCoordinateAdvection(Input=wind)
    texture.UpdatePipeline()
    texture.SMProxy.UpdatePropertyInformation()
    expected = 0.25 * 12 * 3**0.5 / 5
    for name, value in (("PeriodUsed", expected), ("TimeStepUsed", expected / 24)):
        found = texture.SMProxy.GetProperty(name).GetElement(0)
        check(abs(found - value) < 1e-9, f"{name} is {found}, not {value}")
    first, last = (texture.SMProxy.GetProperty("TimeRange").GetElement(i) for i in (0, 1))
    check(abs(last - first - expected) < 1e-9, f"a steady wind has the range {first} to {last}, not {expected}")


def main():
    load_plugin()
    check_definition()
    check_period()
    weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    weather.Dimensions = "(lev, lat, lon)"
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=40)
    globe.UpdatePipeline()
    texture = pvs.TextureCoordinateAdvection(Input=globe, TimeScale=86400)
    texture.UpdatePipelineInformation()
    texture.SMProxy.UpdatePropertyInformation()
    first, last = (texture.SMProxy.GetProperty("TimeRange").GetElement(i) for i in (0, 1))
    check(abs(last - first - 1) < 1e-9, f"a steady wind has the range {first} to {last}")
    check(list(texture.Velocity) == ["POINTS", "DisplayVelocity"], f"the velocity is {list(texture.Velocity)}")
    start, weights = fetched(texture, first)
    check(list(weights) == [0, 1], f"weights {weights} at the start")
    moved, weights = fetched(texture, first + 0.25)
    check(np.allclose(weights, 0.5) and not np.array_equal(start, moved), "the texture does not move")
    texture.PressureArrayName = texture.OmegaArrayName = "None"  # as the menu says it
    check(np.array_equal(moved, fetched(texture, first + 0.25)[0]), "None is taken for an array")
    texture.Integrator = "Euler"
    euler, _ = fetched(texture, first + 0.25)
    check(not np.array_equal(euler, moved), "Integrator does not arrive")
    clouds = pvs.CloudSurface(Input=texture, ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15])
    surface, _ = fetched(clouds, first + 0.25)
    check(len(surface) > 1000, "the surface does not carry the coordinates")
    check_points(os.path.join(DATA, "forecast_10deg_6h.nc"))
    passed()


if __name__ == "__main__":
    main()
