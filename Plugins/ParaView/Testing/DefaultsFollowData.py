# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Defaults that come from the bounds of the data: nothing is made up before there are data, and they follow data that change."""
import math

from PluginTesting import GFS, check, check_same, color_and_alpha, compose, load_plugin, look, new_view, passed, pvs

LENGTHS = ("UnitDistance", "Radius", "CellSize", "VerticalExaggeration", "VisualRange")


def numbers(proxy):
    """Every number of a proxy by the name of its property."""
    for name in proxy.ListProperties():
        prop = proxy.SMProxy.GetProperty(proxy.GetProperty(name).Name if hasattr(proxy.GetProperty(name), "Name") else name)
        for i in range(prop.GetNumberOfElements() if prop and prop.IsA("vtkSMDoubleVectorProperty") else 0):
            yield name, prop.GetElement(i)


def check_numbers(proxy, what, prefix=""):
    for name, value in numbers(proxy):
        if not name.startswith(prefix):
            continue  # ParaView's own
        check(math.isfinite(value), f"{what}.{name} is {value}")
        check(value >= 0 or not name.endswith(LENGTHS), f"{what}.{name} is {value}")


def check_before_there_are_data():
    """Filters of filters that have not been computed, as a script makes them, and representations of a failed Apply."""
    weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=50)
    for make in (pvs.FlowVolume, pvs.CloudSurface, pvs.ContourCellSplitter, pvs.StructuredSmoothing, pvs.TextureCoordinateAdvection):
        proxy = make(Input=globe)
        check_numbers(proxy, proxy.SMProxy.GetXMLName())
        pvs.Delete(proxy)
    failed = pvs.Threshold(Input=pvs.Wavelet(), Scalars=["POINTS", "RTData"], LowerThreshold=1e9, UpperThreshold=2e9)
    view = new_view((100, 100))
    display = pvs.Show(failed, view)
    for representation in ("Cell Compositing", "Textured Splats"):
        display.SetRepresentationType(representation)
        check_numbers(display, representation, representation.replace(" ", ""))
    failed.LowerThreshold, failed.UpperThreshold = 100, 300
    view = new_view((100, 100))
    pvs.Hide(failed)
    display = compose(failed, view)
    display.CellCompositingAutomaticUnitDistance = 0
    look(view)
    alpha = color_and_alpha(view)[1]
    check(0.05 < alpha.mean() < 0.95, f"corrected after a failure, its mean alpha is {alpha.mean():.3f}")
    pvs.Delete(view)


def check_unit_distance(representation, prefix):
    """Data that grow keep their looks, as a unit distance that nobody has touched grows with them."""
    wavelet = pvs.Transform(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3))
    view = new_view((100, 100))
    display = compose(wavelet, view, representation=representation)
    setattr(display, prefix + "AutomaticUnitDistance", 0)
    pictures = []
    for scale in (1, 50, 0.01):
        wavelet.Transform.Scale = [scale] * 3
        look(view, [scale * x for x in (40, 30, 45)])
        pvs.Render(view)
        pvs.ResetCamera(view)
        pictures.append(color_and_alpha(view)[0])
    check(pictures[0].max() > 60, "nothing is to be seen")
    check_same(pictures[1], pictures[0], f"{representation} of larger data", largest=3, mean=0.1)
    check_same(pictures[2], pictures[0], f"{representation} of smaller data", largest=3, mean=0.1)
    setattr(display, prefix + "UnitDistance", 1e-4)
    check(color_and_alpha(view)[0].mean() > pictures[2].mean(), "a unit distance that has been set has no effect")
    pvs.Delete(view)


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_before_there_are_data()
check_unit_distance("Cell Compositing", "CellCompositing")
check_unit_distance("Textured Splats", "TexturedSplats")
passed()
