# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture is sensible for any data, and the picture follows what the user sets."""
import math

import numpy as np
from FirstPictures import SENSIBLE, check_first_pictures, check_units, solid_picture
from PluginTesting import (NAME, check, check_same, color_and_alpha, compose, image, inside_mean_alpha, load_plugin, look,
                           new_view, passed, pvs, solid)


def check_datasets_agree():
    """An image, a structured grid, hexahedra, tetrahedra and blocks of the same field."""
    wavelet = pvs.Wavelet()
    blocks = [pvs.ExtractSubset(Input=wavelet, VOI=[low, low + 10, -10, 10, -10, 10]) for low in (-10, 0)]
    sources = {
        "image": wavelet,
        "structured": pvs.Transform(Input=wavelet),
        "hexahedra": pvs.AppendDatasets(Input=[wavelet]),
        "blocks": pvs.GroupDatasets(Input=blocks),
    }
    pictures = {}
    for name, source in sources.items():
        view = new_view()
        compose(source, view)
        look(view)
        pictures[name] = image(view)
    check(pictures["image"].mean() > 5, "nothing is drawn")
    for name in sources:
        check_same(pictures["image"], pictures[name], f"image and {name}", largest=1, mean=0.02)


def uniform_display(view, value):
    """A cube of edge 20 whose scalar is `value`, coloured by a two-point map over [0, 1]."""
    source = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="Value", Function=str(value))
    display = compose(source, view, ("POINTS", "Value"))
    color = pvs.GetColorTransferFunction("Value")
    color.RGBPoints = [0, 0, 0, 1, 1, 1, 0, 0]
    color.ColorSpace = "RGB"
    opacity = pvs.GetOpacityTransferFunction("Value")
    opacity.Points = [0, 0, 0.5, 0, 1, 1, 0.5, 0]
    display.CellCompositingAutomaticUnitDistance = 0
    return display


def check_change_of_array():
    """Colouring by another array gives the picture that it gives at once, and this one is sensible for rare values."""
    both = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="Rare", Function="exp((RTData-276)/10)")
    first, second = new_view(), new_view()
    display = compose(both, first, ("POINTS", "RTData"))
    compose(both, second, ("POINTS", "Rare"))
    for view in (first, second):
        look(view)
    image(first)
    pvs.ColorBy(display, ("POINTS", "Rare"))
    check_same(image(first), image(second), "changed to another array")
    mean = inside_mean_alpha(color_and_alpha(second)[1])
    check(SENSIBLE[0] < mean < SENSIBLE[1], f"rare values: mean alpha {mean}")


def check_alpha_formula():
    """A ray along an axis of the cube: alpha = 1 - exp(-opacity * scale * length / unit distance)."""
    view = new_view()
    display = uniform_display(view, 0.25)
    view.CameraParallelProjection = 1
    look(view, position=(0, 0, 100))
    view.CameraParallelScale = 20
    for unit, scale, opacity in ((20.0, 1.0, 1.0), (5.0, 1.0, 1.0), (20.0, 6.0, 1.0), (20.0, 6.0, 0.5)):
        display.CellCompositingUnitDistance = unit
        display.CellCompositingOpacityScale = scale
        display.Opacity = opacity
        on_black, alpha = color_and_alpha(view)
        expected = 1.0 - math.exp(-0.25 * scale * opacity * 20.0 / unit)
        found = alpha[150, 150]
        check(abs(found - expected) < 1.5 / 255, f"unit {unit}, scale {scale}: alpha {found}, expected {expected}")
        expected_color = np.array([0.25, 0.0, 0.75]) * 255 * expected
        check(np.abs(on_black[150, 150] - expected_color).max() < 1.5,
              f"colour {on_black[150, 150]}, expected {expected_color}")
    # Automatic: mean chord (volume over a quarter of the surface) * mean of the ramp (0.5 for a constant) / 2.
    display.CellCompositingAutomaticUnitDistance = 1
    display.CellCompositingOpacityScale = 1
    display.Opacity = 1
    _, alpha = color_and_alpha(view)
    expected = 1.0 - math.exp(-0.25 * 20.0 / (20.0**3 / (6 * 20.0**2 / 4) * 0.5 / 2))
    check(abs(alpha[150, 150] - expected) < 1.5 / 255, f"automatic: alpha {alpha[150, 150]}, expected {expected}")


def check_solid_color():
    on_black, alpha = solid_picture(NAME, pvs.Wavelet())
    check(np.abs(on_black[:, :, 1] / 255 - alpha).max() < 0.01, "the medium does not glow in its colour")


def check_vectors():
    """Magnitude and component of a vector, as the colour map says."""
    field = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="Vector", Function="3*RTData*iHat+4*RTData*jHat")
    pictures = {}
    for mode, component, scalar in (("Magnitude", "", "5*RTData"), ("Component", "Y", "4*RTData")):
        view = new_view()
        compose(field, view, ("POINTS", "Vector", component) if component else ("POINTS", "Vector", "Magnitude"))
        look(view)
        reference_view = new_view()
        name = f"Scalar{mode}"
        compose(pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName=name, Function=scalar), reference_view,
                ("POINTS", name))
        look(reference_view)
        pvs.GetColorTransferFunction("Vector").RescaleTransferFunctionToDataRange()
        for function in (pvs.GetColorTransferFunction, pvs.GetOpacityTransferFunction):
            low, high = pvs.GetColorTransferFunction(name).RGBPoints[0], pvs.GetColorTransferFunction(name).RGBPoints[-4]
            function("Vector").RescaleTransferFunction(low, high)
            function(name).RescaleTransferFunction(low, high)
        pictures[mode] = image(view)
        check_same(pictures[mode], image(reference_view), f"vector {mode}", largest=1, mean=0.02)


def check_methods():
    """One medium: all methods but the triangles of linear opacity, which are too transparent, give one picture."""
    view = new_view()
    coarse = pvs.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
    display = pvs.Show(coarse, view)
    display.SetRepresentationType("Cell Compositing")
    solid(display, [1, 1, 1])
    look(view, position=(8, 6, 9))
    pictures = {}
    for method in ("Cells", "Triangles, linear opacity", "Triangles, table of opacities", "Faces"):
        display.CellCompositingMethod = method
        pictures[method] = image(view)
    cells = pictures.pop("Cells").astype(float)
    linear = pictures.pop("Triangles, linear opacity")
    check((cells - linear).max() > 5, f"linear opacity is at most {(cells - linear).max()} darker")
    for method, picture in pictures.items():
        check(np.abs(picture - cells).mean() < 0.1, f"{method} differs by {np.abs(picture - cells).mean()} on the mean")


load_plugin()
wavelet = pvs.Wavelet()
check_first_pictures("Cell Compositing", wavelet)
check_units(NAME, "the wavelet", pvs.Wavelet())
check_datasets_agree()
check_change_of_array()
check_alpha_formula()
check_solid_color()
check_vectors()
check_methods()
passed()
