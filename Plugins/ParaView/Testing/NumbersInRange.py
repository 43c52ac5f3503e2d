# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that a property cannot have become ones that it can have, with one warning that has its label and range; nothing crashes, hangs or goes blank unsaid."""
import math
import time

from PluginTesting import check, image, listen, load_plugin, new_view, passed, pvs

VALUES = (math.nan, math.inf, -math.inf, -1.0, -0.2, 0.0, 1e30)
LONGEST = 20.0  # seconds that any of them may take
messages = listen()


def is_range(domain):
    """Those of other classes follow the data: they are proposals."""
    return domain is not None and domain.GetClassName() in ("vtkSMDoubleRangeDomain", "vtkSMIntRangeDomain")


def numeric(proxy, prefix=""):
    """Names, properties and whether they are of whole numbers."""
    for name in proxy.ListProperties():
        if not name.startswith(prefix):
            continue
        prop = proxy.GetProperty(name)
        smprop = prop.SMProperty
        whole, real = (smprop.IsA(f"vtkSM{kind}VectorProperty") for kind in ("Int", "Double"))
        has_range = any(is_range(smprop.FindDomain(f"vtkSM{kind}RangeDomain")) for kind in ("Int", "Double"))
        if (whole or real) and not smprop.GetInformationOnly() and has_range and len(prop):
            yield name, smprop, whole


def limits(smprop):
    domain = smprop.FindDomain("vtkSMDoubleRangeDomain") or smprop.FindDomain("vtkSMIntRangeDomain")
    return (domain.GetMinimum(0) if domain.GetMinimumExists(0) else -math.inf), (domain.GetMaximum(0) if domain.GetMaximumExists(0) else math.inf)


def sweep(what, proxy, update, prefix=""):
    count = 0
    for name, smprop, whole in numeric(proxy, prefix):
        low, high = limits(smprop)
        default = [smprop.GetElement(i) for i in range(smprop.GetNumberOfElements())]
        for value in (-1, 0, 2**30) if whole else VALUES:
            messages.clear()
            begin = time.monotonic()
            smprop.SetElement(0, value)
            kept = smprop.GetElement(0)
            where = f"{what}.{name} = {value}"
            check(math.isfinite(kept) and low <= kept <= high, f"{where} stays {kept}")
            is_changed = not math.isfinite(value) or not low <= value <= high
            label = smprop.GetXMLLabel()
            check(len(messages) == is_changed and (not is_changed or label in messages[0]), f"{where}: {messages}")
            proxy.SMProxy.UpdateVTKObjects()
            update(where, value if not is_changed else kept)
            took = time.monotonic() - begin
            check(took < LONGEST, f"{where} took {took:.0f} s")
            count += 1
            for i, number in enumerate(default):
                smprop.SetElement(i, number)
        proxy.SMProxy.UpdateVTKObjects()
    print(f"{what}: {count} numbers", flush=True)
    check(count > 0, f"{what} has no numbers")


def check_filters(wind, smoke, weather):
    for name, source in (("GlobeGrid", weather), ("GlobeTerrain", weather), ("FlowVolume", wind), ("SmokePuffs", smoke), ("StructuredSmoothing", wind),
                         ("CloudSurface", wind), ("PolyhedrontoTetrahedra", wind), ("TextureCoordinateAdvection", wind)):
        proxy = getattr(pvs, name)(Input=source)
        proxy.UpdatePipeline()
        sweep(name, proxy, lambda where, value, proxy=proxy: proxy.UpdatePipeline())


def check_display(source, representation, **settings):
    view = new_view((60, 60))
    display = pvs.Show(source, view)
    if representation:
        pvs.ColorBy(display, ("POINTS", "RTData"))
        display.SetRepresentationType(representation)
    for name, value in settings.items():
        setattr(display, name, value)
    pvs.ResetCamera(view)

    def update(where, value):
        picture = image(view)
        blank = (abs(picture - picture[0, 0]).max(axis=2) <= 2).all()
        check(not blank or value == 0 or messages or representation is None, f"{where}: nothing is drawn, and nothing said")

    sweep(representation or display.SMProxy.GetXMLName(), display, update, representation.replace(" ", "") if representation else "")
    pvs.Delete(view)


def main():
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    wind = pvs.Calculator(Input=wavelet, ResultArrayName="v", Function="-coordsY*iHat+coordsX*jHat+3*kHat")
    smoke = pvs.FlowVolume(Input=wind)
    weather = pvs.Calculator(Input=pvs.Transform(Input=pvs.ResampleToImage(Input=wavelet, SamplingDimensions=[9, 9, 3])), ResultArrayName="orog", Function="100+coordsX")
    check_filters(wind, smoke, weather)
    check_display(wind, "Cell Compositing", CellCompositingAutomaticUnitDistance=0, CellCompositingContourValues=[150])
    check_display(wind, "Textured Splats", TexturedSplatsAutomaticUnitDistance=0, TexturedSplatsVectorArray="v")
    check_display(pvs.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150]), "Cloud Texture")
    check_display(pvs.Haze(), None)


load_plugin()
pvs._DisableFirstRenderCameraReset()
main()
passed()
