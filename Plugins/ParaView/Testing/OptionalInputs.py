# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""An optional input that is taken away again leaves the output that was there without it."""
import numpy as np
from PluginTesting import GFS, check, load_plugin, passed, pvs, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy


def weather(levels):
    """A coarse forecast of some levels."""
    return pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VOI=[0, 10**6, 0, 10**6, 0, levels - 1], SampleRateI=12, SampleRateJ=12)


def globe():
    return pvs.GlobeGrid(Input=weather(5), VerticalExaggeration=30)


def clouds():
    return pvs.Calculator(Input=globe(), Function="clwmr", ResultArrayName="Extinction")


def terrain():
    return pvs.Calculator(Input=weather(1), Function="5000", ResultArrayName="orog")


def values(proxy):
    """The numbers of the first output: its points, and all arrays of these."""
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    arrays = data.GetPointData()
    numbers = [vtk_to_numpy(arrays.GetArray(i)).astype(float).ravel() for i in range(arrays.GetNumberOfArrays())]
    return np.nan_to_num(np.concatenate([np.asarray(data.GetBounds()), *numbers]))


def same(first, second):
    return first.shape == second.shape and np.array_equal(first, second)


load_plugin()
lit = pvs.Sunlight(Input=clouds(), ExtinctionScale=100)
for name, filter, port, make in (
        ("Surface of Globe Grid", pvs.GlobeGrid(Input=weather(5)), "Surface", terrain),
        ("Points of Texture Coordinate Advection", pvs.TextureCoordinateAdvection(Input=globe()), "Points", lambda: pvs.CloudSurface(Input=globe(), ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.1])),
        ("Clouds of Sunlight", pvs.Sunlight(Input=clouds(), ExtinctionScale=0.01), "Clouds", lambda: lit),
        ("Sun of Sunlight", pvs.Sunlight(Input=clouds()), "Sun", lambda: pvs.Sun(SunDirection=[0, 1, 0])),
        ("Sun of Clouds over the Globe", pvs.CloudsovertheGlobe(), "Sun", lambda: pvs.Sun(SunDirection=[0, 1, 0]))):
    setattr(filter, port, None)
    before = values(filter)
    other = make()
    setattr(filter, port, other)
    check(not same(values(filter), before), f"{name}: changes nothing")
    setattr(filter, port, None)
    check(same(values(filter), before), f"{name}: still there after it has been taken away")
    print(name, flush=True)
passed()
