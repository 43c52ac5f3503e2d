# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Contour Cell Splitter in ParaView: menu, defaults, values, layers, surfaces, state, several blocks."""
import os

import nephoscope
import numpy as np
from PluginTesting import OUTPUT, check, load_plugin, passed, pvs, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

GETTERS = {"GenerateSurfaces": "GetGenerateSurfaces", "PolyhedralTransitions": "GetPolyhedralTransitions",
           "OutputPointsPrecision": "GetOutputPointsPrecision"}


def check_definition(proxy):
    definition = servermanager.ProxyManager().GetProxyDefinitionManager().GetProxyDefinition("filters", "ContourCellSplitter")
    children = [definition.GetNestedElement(i) for i in range(definition.GetNumberOfNestedElements())]
    hints = [c for c in children if c.GetName() == "Hints"]
    check(hints and hints[0].GetNestedElement(0).GetAttribute("category") == "Nephoscope", "not in the menu Nephoscope")
    filter_ = nephoscope.vtkContourCellSplitter()
    for element in children:
        if element.GetName().endswith("Property"):
            inside = [element.GetNestedElement(i).GetName() for i in range(element.GetNumberOfNestedElements())]
            check("Documentation" in inside, f"{element.GetAttribute('name')} has no help")
    for name, getter in GETTERS.items():
        value, expected = proxy.SMProxy.GetProperty(name).GetElement(0), int(getattr(filter_, getter)())
        check(value == expected, f"a fresh proxy has {name} = {value}, C++ {expected}")


def output_of(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def check_split(source):
    source.UpdatePipeline()
    proxy = pvs.ContourCellSplitter(Input=source)
    check(list(proxy.ContourBy) == ["POINTS", "RTData"], f"the array is {list(proxy.ContourBy)}")
    check(len(proxy.ContourValues) == 1 and 37 < proxy.ContourValues[0] < 277, f"the first value is {list(proxy.ContourValues)}")
    check_definition(proxy)
    proxy.ContourValues = [100, 200, 157]
    data = output_of(proxy)
    layers, contours = cell_array(data, "Layer"), cell_array(data, "ContourIndex")
    check(set(layers) == {0, 1, 2, 3} and set(contours) == {-1, 0, 1, 2}, f"layers {set(layers)}, contours {set(contours)}")
    proxy.GenerateSurfaces = 0
    solid = output_of(proxy)
    check(solid.GetNumberOfCells() == np.sum(contours < 0), "surfaces cannot be left out")
    volume = pvs.IntegrateVariables(Input=proxy)
    total = cell_array(output_of(volume), "Volume")[0]
    check(abs(total / 20 ** 3 - 1) < 1e-12, f"volume {total}")
    pvs.Delete(volume)
    proxy.GenerateSurfaces = 1
    return proxy, data


def check_layer_can_be_shown(proxy):
    """A layer alone, as a user would: Threshold by Layer."""
    layer = pvs.Threshold(Input=proxy, Scalars=["CELLS", "Layer"], LowerThreshold=1, UpperThreshold=1)
    s = vtk_to_numpy(output_of(layer).GetPointData().GetArray("RTData"))
    check(s.min() == 100 and s.max() == 157, f"scalars {s.min()} to {s.max()}")
    pvs.Delete(layer)


def check_blocks():
    wavelets = [pvs.Wavelet(WholeExtent=extent) for extent in ([-5, 0, -5, 5, -5, 5], [0, 5, -5, 5, -5, 5])]
    blocks = pvs.GroupDatasets(Input=wavelets)
    blocks.UpdatePipeline()
    data = output_of(pvs.ContourCellSplitter(Input=blocks, ContourValues=[157]))
    check(data.IsA("vtkCompositeDataSet") and data.GetNumberOfCells() > 2000, "blocks are not divided one by one")


def check_state(expected):
    state = os.path.join(OUTPUT, "ContourCellSplitter.pvsm")
    pvs.SaveState(state)
    pvs.ResetSession()
    load_plugin()
    pvs.LoadState(state)
    found = [p for p in pvs.GetSources().values() if p.GetXMLName() == "ContourCellSplitter"]
    check(len(found) == 1 and list(found[0].ContourValues) == [100, 200, 157], "the values are not in the state")
    data = output_of(found[0])
    check(data.GetNumberOfCells() == expected.GetNumberOfCells(), "the state gives something else")


load_plugin()
splitter, split = check_split(pvs.Wavelet())
check_layer_can_be_shown(splitter)
check_state(split)
check_blocks()
passed()
