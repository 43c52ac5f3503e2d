# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""An Apply that fails is reported by one message; after the correction the picture is the one that a first Apply makes."""
from PluginTesting import GFS, SIZE, check, image, listen, load_plugin, new_view, passed, pvs

messages = listen()


def check_failure(what, source, fault, correct, representation=None):
    """Shows a source that fails, some times, as a user does who looks at the panel; then corrects it."""
    messages.clear()
    view = new_view(SIZE)
    display = pvs.Show(source, view)
    for _ in range(2):
        pvs.Render(view)
        source.UpdatePipeline()
    check(len(messages) == 1, f"{what}: {len(messages)} messages: {messages}")
    check(fault in messages[0], f"{what}: {messages[0]}")
    messages.clear()
    correct(source)
    pvs.Render(view)
    pvs.ResetCamera(view)
    picture = image(view)
    check(not messages, f"{what}, corrected: {messages}")
    share = (abs(picture - picture[0, 0]).max(axis=2) > 8).mean()
    check(share > 0.02, f"{what}, corrected: {share:.1%} of the picture show anything")
    check(representation in (None, display.Representation), f"{what}, corrected: shown as {display.Representation}")
    pvs.Delete(view)


def set_to(**values):
    def correct(source):
        for name, value in values.items():
            setattr(source, name, value)
    return correct


def main():
    wavelet = pvs.Wavelet(WholeExtent=[-6, 6] * 3)
    wind = pvs.Calculator(Input=wavelet, ResultArrayName="v", Function="-coordsY*iHat+coordsX*jHat+3*kHat")
    wind.UpdatePipeline()
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VOI=[0, 10**6] * 3, SampleRateI=3, SampleRateJ=3)
    check_failure("Globe Grid", pvs.GlobeGrid(Input=weather, PlanetRadiusm=0), "Planet Radius must be greater than 0", set_to(PlanetRadiusm=6371000), "Cell Compositing")
    check_failure("Flow Volume", pvs.FlowVolume(Input=wind, Velocity=["POINTS", "none"]), "'none'", set_to(Velocity=["POINTS", "v"]), "Cell Compositing")
    check_failure("Flow Volume without a normal", pvs.FlowVolume(Input=wind, NormalToFlow=0, Normal=[0, 0, 0]), "Normal To Flow", set_to(Normal=[0, 0, 1]))
    choose = set_to(ContourBy=["POINTS", "RTData"], ContourValues=[150])
    check_failure("Cloud Surface", pvs.CloudSurface(Input=wind, ContourBy=["POINTS", "none"]), "'none'", choose)
    check_failure("Contour Cell Splitter", pvs.ContourCellSplitter(Input=wind, ContourBy=["POINTS", "none"]), "'none'", choose)
    check_failure("Structured Smoothing", pvs.StructuredSmoothing(Input=wind, SmoothArray=["POINTS", "none"]), "'none'",
                  set_to(SmoothArray=["POINTS", "RTData"]), "Cell Compositing")
    check_failure("Texture Coordinate Advection", pvs.TextureCoordinateAdvection(Input=wind, Velocity=["POINTS", "none"]), "'none'",
                  set_to(Velocity=["POINTS", "v"]), "Cell Compositing")


load_plugin()
pvs._DisableFirstRenderCameraReset()
main()
passed()
