# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a representation is sensible for any data: neither invisible nor opaque, nothing set but the choice."""
from PluginTesting import (GFS, check, check_same, clear, color_and_alpha, compose, empty_view, image, inside_mean_alpha, look, new_view, pvs,
                           solid)

# The mean alpha of the pixels that show anything.
SENSIBLE = (0.25, 0.97)


def first_alpha(representation, source, array, opacities=None):
    view = empty_view((150, 150))
    compose(source, view, array, representation)
    if opacities:
        pvs.GetOpacityTransferFunction(array[1]).Points = opacities
    pvs.ResetCamera(view)
    alpha = color_and_alpha(view)[1]
    clear(view)
    return alpha


def check_first_picture(representation, name, source, array=("POINTS", "RTData")):
    mean = inside_mean_alpha(first_alpha(representation, source, array))
    print(f"first picture of {name}: mean alpha {mean:.3f}", flush=True)
    check(SENSIBLE[0] < mean < SENSIBLE[1], f"{name}: mean alpha {mean:.3f} is outside {SENSIBLE}")


def solid_picture(representation, source):
    """Without an array: a uniform medium of the solid colour. Its colour on black, and its alpha."""
    view = new_view()
    display = pvs.Show(source, view)
    display.SetRepresentationType(representation)
    solid(display, [0, 1, 0])
    look(view)
    on_black, alpha = color_and_alpha(view)
    mean = inside_mean_alpha(alpha)
    check(SENSIBLE[0] < mean < SENSIBLE[1], f"solid colour: mean alpha {mean}")
    check(on_black[:, :, [0, 2]].max() < 1 < on_black[:, :, 1].max(), "solid colour is not green")
    return on_black, alpha


def check_units(representation, name, data, array=("POINTS", "RTData")):
    """The same data in other units of length gives the same picture."""
    pictures = []
    for scale in (1.0, 1000.0):
        source = pvs.Transform(Input=data)
        source.Transform.Scale = [scale] * 3
        view = new_view()
        compose(source, view, array, representation)
        look(view, position=[scale * c for c in (60, 45, 70)])
        pictures.append(image(view))
    check(pictures[0].mean() > 5, "nothing is drawn")
    check_same(*pictures, f"units of {name}", largest=1, mean=0.05)


def check_constants(representation):
    """Equal values are a uniform medium; where the user has made a function that is 0 there, nothing is drawn."""
    wavelet = pvs.Wavelet(WholeExtent=[0, 5] * 3)
    for k, (value, association) in enumerate((("0*coordsX", "POINTS"), ("0*coordsX + 1", "CELLS"), ("0*coordsX - 101325", "POINTS"))):
        name = f"{representation} constant {k}"
        constant = pvs.Calculator(Input=wavelet, Function=value, ResultArrayName=name)
        source = constant if association == "POINTS" else pvs.PointDatatoCellData(Input=constant)
        check_first_picture(representation, f"{association} with {value}", source, (association, name))
    alpha = first_alpha(representation, constant, ("POINTS", name), [-101325, 0, 0.5, 0, 0, 1, 0.5, 0])
    check(alpha.max() < 0.01, "a function that is 0 at the only value does not count")


def check_thin(representation):
    """A layer is as opaque as a cube."""
    for depth in (1, 3):
        thin = pvs.Wavelet(WholeExtent=[-30, 30, -30, 30, 0, depth])
        check_first_picture(representation, f"a layer {depth} thick", pvs.PointDatatoCellData(Input=thin), ("CELLS", "RTData"))


def check_first_pictures(representation, wavelet):
    """First pictures of points, cells, unstructured cells, layers, constants and weather, in degrees and on the globe."""
    check_constants(representation)
    check_thin(representation)
    check_first_picture(representation, "the wavelet", wavelet)
    check_first_picture(representation, "cell data", pvs.PointDatatoCellData(Input=wavelet), ("CELLS", "RTData"))
    check_first_picture(representation, "tetrahedra", pvs.Tetrahedralize(Input=wavelet))
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0),
                                VOI=[0, 10**6] * 3, SampleRateI=3, SampleRateJ=3)
    check_first_picture(representation, "GFS humidity, degrees and hPa", weather, ("POINTS", "r"))
    for exaggeration, array in ((1, "r"), (50, "clwmr")):
        globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=exaggeration)
        check_first_picture(representation, f"GFS {array} on the globe, exaggeration {exaggeration}", globe, ("POINTS", array))
