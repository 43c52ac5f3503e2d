# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Haze in ParaView: menu, defaults, help, settings that arrive, one switch for surfaces and cells, several views."""
import nephoscope
import numpy as np
from HazeScenes import add_haze, make_view
from PluginDefinitions import definition, nested, own_properties
from PluginTesting import check, check_same, image, load_plugin, passed, pvs

NAMES = {"VisualRange": "Visibility", "HazeColor": "Color", "HazeBackground": "Background"}  # as ParaView uses these for other things


def check_definition():
    hints = nested(definition("sources", "Haze"), "Hints")[0]
    menu = [hints.GetNestedElement(i).GetAttribute("category") for i in range(hints.GetNumberOfNestedElements())]
    check("Nephoscope" in menu, "not in the menu Nephoscope")
    properties = own_properties(definition("representations", "HazeRepresentation"))
    haze = nephoscope.vtkHaze()
    for name, element in properties.items():
        check(nested(element, "Documentation"), f"{name} has no help")
        if name in ("Input", "Visibility"):
            continue
        values = [float(v) for v in element.GetAttribute("default_values").split()]
        expected = np.ravel(getattr(haze, "Get" + NAMES.get(name, name))())
        np.testing.assert_array_equal(values, expected, name)


def check_settings(view):
    display = pvs.Show(pvs.Haze(), view)
    values = {"VisualRange": 123.0, "ScaleHeight": 4.5, "VerticalExaggeration": 7.0, "HazeColor": [0.1, 0.2, 0.3], "Projection": 1, "SunDirection": [1.0, -2.0, 3.0], "Asymmetry": 0.25,
              "PlanetRadius": 99.0, "Center": [1.0, 2.0, 3.0], "BaseLevel": -5.0, "CloudShadows": 0, "UpDirection": [0.0, 2.0, 0.0], "HazeBackground": 0}
    for name, value in values.items():
        setattr(display, name, value)
    display.UpdateVTKObjects()
    haze = nephoscope.vtkHaze.GetHaze(view.GetRenderer())
    check(haze is not None, "the renderer has no haze")
    for name, value in values.items():
        got = np.ravel(getattr(haze, "Get" + NAMES.get(name, name))())
        np.testing.assert_allclose(got, np.ravel(value), err_msg=name)


def check_pictures():
    view = make_view()
    plain = image(view)
    haze, display = add_haze(view)
    hazed = image(view)
    check(np.abs(hazed - plain).mean() > 20, "there is no haze")
    far = (hazed - plain)[45:50].mean(axis=(0, 1))
    near = (hazed - plain)[:5].mean(axis=(0, 1))
    check((far > 1.2 * near).all(), f"near {near}, far {far}")
    pvs.Hide(haze, view)
    check_same(image(view), plain, "hidden haze")
    pvs.Show(haze, view)
    check_same(image(view), hazed, "haze shown again")
    display.VisualRange = 1e9
    check_same(image(view), plain, "very thin haze", largest=1, mean=0.01)
    display.VisualRange = 1e-3
    opaque = image(view)[:30].mean(axis=(0, 1))
    np.testing.assert_allclose(opaque, 255 * np.array((0.72, 0.8, 0.9)), atol=1)
    pvs.Delete(haze)
    check_same(image(view), plain, "haze deleted")


def check_two_views():
    first, second = make_view(medium=False), make_view(medium=False)
    plain = image(second)
    add_haze(first)
    check(np.abs(image(first) - plain).mean() > 20, "there is no haze")
    check_same(image(second), plain, "the other view")


load_plugin()
check_definition()
check_settings(make_view(medium=False))
check_pictures()
check_two_views()
passed()
