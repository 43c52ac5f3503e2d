# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters Structured Smoothing and Cloud Surface in ParaView: menu, defaults, help, settings that arrive, state."""
import os

import nephoscope
import numpy as np
from PluginTesting import GFS, OUTPUT, check, load_plugin, passed, pvs, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

SHARED = ("Conservative", "MassArrayName", "Isotropic", "Coordinates", "FindSeam", "PeriodicI", "PeriodicJ", "PeriodicK")
FILTERS = {"StructuredSmoothing": (nephoscope.vtkStructuredSmoothing, SHARED + ("AllFloatArrays", "NumberOfIterations", "GenerateMassArray")),
           "CloudSurface": (nephoscope.vtkCloudSurface, SHARED + ("NumberOfSmoothingIterations", "ComputeNormals", "JoinSeams"))}


def children(element):
    return [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())]


def check_definition(name, proxy):
    definition = servermanager.ProxyManager().GetProxyDefinitionManager().GetProxyDefinition("filters", name)
    elements = children(definition)
    hints = [c for c in elements if c.GetName() == "Hints"]
    check(hints and hints[0].GetNestedElement(0).GetAttribute("category") == "Nephoscope", f"{name} is not in the menu Nephoscope")
    properties = {e.GetAttribute("name"): e for e in elements if e.GetName().endswith("VectorProperty")}
    grouped = {p.GetAttribute("name") for g in elements if g.GetName() == "PropertyGroup" for p in children(g)}
    check(grouped == set(properties), f"{name}: not in a group {sorted(grouped ^ set(properties))}")
    for key, element in properties.items():
        check("Documentation" in [c.GetName() for c in children(element)], f"{name}.{key} has no help")
    class_, names = FILTERS[name]
    for key in names:
        value, expected = proxy.SMProxy.GetProperty(key).GetElement(0), getattr(class_(), "Get" + key)()
        check(value == expected, f"a fresh {name} has {key} = {value!r}, C++ {expected!r}")


def data_of(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def array_of(data, name, cells=False):
    return vtk_to_numpy((data.GetCellData() if cells else data.GetPointData()).GetArray(name))


def globe():
    weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    weather.Dimensions = "(lev, lat, lon)"
    return pvs.GlobeGrid(Input=weather, VerticalExaggeration=40)


def check_smoothing():
    wavelet = pvs.Wavelet()
    wavelet.UpdatePipeline()
    proxy = pvs.StructuredSmoothing(Input=wavelet)
    check_definition("StructuredSmoothing", proxy)
    check(list(proxy.SmoothArray) == ["POINTS", "RTData"], f"the array is {list(proxy.SmoothArray)}")
    before, after = array_of(data_of(wavelet), "RTData"), array_of(data_of(proxy), "RTData")
    check(after.std() < before.std() and after.max() < before.max(), "nothing is smoothed")
    for name, value in (("NumberOfIterations", 3), ("PeriodicAlongJ", 1), ("Conservative", 1), ("ArrayNames", ["RTData"])):
        last = array_of(data_of(proxy), "RTData").copy()
        setattr(proxy, name, value)
        now = array_of(data_of(proxy), "RTData")
        check(np.array_equal(last, now) == (name == "ArrayNames"), f"{name} does not arrive")
    proxy.SMProxy.GetProperty("MassArrayName").SetElement(0, "None")  # as the menu says it
    proxy.GenerateMassArray = 1
    check(abs(array_of(data_of(proxy), "Mass").sum() - 20 * 21 * 20) < 1e-6, "the masses are not the volume")
    proxy.ArrayNames = []
    proxy.AllFloatArrays = 1
    check(np.array_equal(array_of(data_of(proxy), "RTData"), now), "All Float Arrays does not arrive")


def check_surface(source):
    proxy = pvs.CloudSurface(Input=source, ContourBy=["POINTS", "cloud_fraction"])
    check_definition("CloudSurface", proxy)
    proxy.ContourValues = [0.15, 0.5]
    data = data_of(proxy)
    index = array_of(data, "ContourIndex", cells=True)
    check(set(index) == {0, 1} and data.GetNumberOfCells() > 50000, f"{data.GetNumberOfCells()} triangles, contours {set(index)}")
    names = {data.GetPointData().GetArrayName(i) for i in range(data.GetPointData().GetNumberOfArrays())}
    check({"cloud_fraction", "t", "Wind", "Height", "Normals"} <= names, f"arrays {sorted(names)}")
    rough = pvs.CloudSurface(Input=source, ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15, 0.5],
                             NumberOfSmoothingIterations=0, ComputeNormals=0, JoinSeams=0)
    check(data_of(rough).GetNumberOfCells() > data.GetNumberOfCells(), "the rough surface is not larger")
    check(data_of(rough).GetPointData().GetNormals() is None, "Compute Normals does not arrive")
    pvs.Delete(rough)
    return data


def check_state(expected):
    state = os.path.join(OUTPUT, "CloudSurface.pvsm")
    pvs.SaveState(state)
    pvs.ResetSession()
    load_plugin()
    pvs.LoadState(state)
    found = [p for p in pvs.GetSources().values() if p.GetXMLName() == "CloudSurface"]
    check(len(found) == 1 and list(found[0].ContourValues) == [0.15, 0.5], "the values are not in the state")
    check(data_of(found[0]).GetNumberOfCells() == expected.GetNumberOfCells(), "the state gives something else")


load_plugin()
check_smoothing()
check_state(check_surface(globe()))
passed()
