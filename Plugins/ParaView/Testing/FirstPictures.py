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


def check_first_pictures(representation, wavelet):
    """Of points, cells, unstructured cells and weather, in degrees and on the globe."""
    check_first_picture(representation, "the wavelet", wavelet)
    check_first_picture(representation, "cell data", pvs.PointDatatoCellData(Input=wavelet), ("CELLS", "RTData"))
    check_first_picture(representation, "tetrahedra", pvs.Tetrahedralize(Input=wavelet))
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0),
                                VOI=[0, 10**6] * 3, SampleRateI=2, SampleRateJ=2)
    check_first_picture(representation, "GFS humidity, degrees and hPa", weather, ("POINTS", "r"))
    for exaggeration, array in ((1, "r"), (50, "clwmr")):
        globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=exaggeration)
        check_first_picture(representation, f"GFS {array} on the globe, exaggeration {exaggeration}", globe, ("POINTS", array))
