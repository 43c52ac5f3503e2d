# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first picture of a representation is sensible for any data: neither invisible nor opaque, nothing set but the choice."""
from PluginTesting import GFS, check, color_and_alpha, compose, inside_mean_alpha, new_view, pvs

# The mean alpha of the pixels that show anything.
SENSIBLE = (0.25, 0.97)


def check_first_picture(representation, name, source, array=("POINTS", "RTData")):
    view = new_view()
    compose(source, view, array, representation)
    pvs.ResetCamera(view)
    mean = inside_mean_alpha(color_and_alpha(view)[1])
    print(f"first picture of {name}: mean alpha {mean:.3f}", flush=True)
    check(SENSIBLE[0] < mean < SENSIBLE[1], f"{name}: mean alpha {mean:.3f} is outside {SENSIBLE}")
    pvs.Delete(view)


def check_constants(representation):
    """Equal values are a uniform medium; where the user has made a function that is 0 there, nothing is drawn."""
    for k, value in enumerate(("0*coordsX", "0*coordsX + 1", "0*coordsX - 101325")):
        wavelet = pvs.Wavelet(WholeExtent=[0, 5] * 3)
        name = f"{representation} constant {k}"
        constant = pvs.Calculator(Input=wavelet, Function=value, ResultArrayName=name)
        check_first_picture(representation, f"points with {value}", constant, ("POINTS", name))
        cells = pvs.PointDatatoCellData(Input=constant)
        check_first_picture(representation, f"cells with {value}", cells, ("CELLS", name))
    view = new_view()
    compose(constant, view, ("POINTS", name), representation)
    pvs.GetOpacityTransferFunction(name).Points = [-101325, 0, 0.5, 0, 0, 1, 0.5, 0]
    pvs.ResetCamera(view)
    check(color_and_alpha(view)[1].max() < 0.01, "a function that is 0 at the only value does not count")
    pvs.Delete(view)


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
                                VOI=[0, 10**6] * 3, SampleRateI=2, SampleRateJ=2)
    check_first_picture(representation, "GFS humidity, degrees and hPa", weather, ("POINTS", "r"))
    for exaggeration, array in ((1, "r"), (50, "clwmr")):
        globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=exaggeration)
        check_first_picture(representation, f"GFS {array} on the globe, exaggeration {exaggeration}", globe, ("POINTS", array))
