# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The presets are in ParaView's list, and arrays of the weather begin with the colours of theirs where Nephoscope draws or makes them; filters
after Globe Grid begin with clouds."""
from PluginTesting import GFS, check, new_view, passed, pvs


def check_short_names():
    """Names that are usual elsewhere too have their colours after Globe Grid, also if they were seen before; colours of the user's stay."""
    weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    for name, seen, chosen in (("cc", False, False), ("qc", True, False), ("cl", True, True), ("clwc", False, False), ("ciwc", True, False),
                               ("tcc", False, False)):
        named = pvs.Calculator(Input=weather, Function="cloud_fraction", ResultArrayName=name)
        only = pvs.PassArrays(Input=named, PointDataArrays=[name, "gh"])
        view = new_view((60, 40))
        if seen:
            before = pvs.Show(only, view, "StructuredGridRepresentation")
            pvs.ColorBy(before, ("POINTS", name))
        if chosen:
            pvs.GetColorTransferFunction(name).ApplyPreset("X Ray", True)
        display = pvs.Show(pvs.GlobeGrid(Input=only, VerticalExaggeration=30), view)
        check(list(display.ColorArrayName) == ["POINTS", name], f"Globe Grid is coloured by {display.ColorArrayName}")
        colours, points = list(display.LookupTable.RGBPoints), list(display.ScalarOpacityFunction.Points)
        check((min(colours[-3:]) > 0.99) != chosen, f"{name}, seen before: {seen}, has the colours {colours}")
        check((len(points) > 8) != chosen, f"{name}, seen before: {seen}, has the opacities {points}")
        pvs.Delete(view)


def check_plain_representations():
    """ParaView's own colours and opacities in its own representations; those of the preset from the choice of one of ours."""
    plain = list(pvs.GetColorTransferFunction("RTData").RGBPoints)
    for name in ("smoke", "soot", "cloud_cover", "temp"):
        for representation in ("Cell Compositing", "Textured Splats"):
            named = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3), Function="RTData", ResultArrayName=name)
            view = new_view((60, 40))
            display = pvs.Show(named, view)
            pvs.ColorBy(display, ("POINTS", name))
            display.RescaleTransferFunctionToDataRange(True)
            for own in ("Surface", "Volume"):
                display.SetRepresentationType(own)
                colours, points = list(display.LookupTable.RGBPoints), list(display.ScalarOpacityFunction.Points)
                check(colours[1::4] == plain[1::4] and len(points) == 8, f"{own} of {name} has the colours {colours} and opacities {points}")
            of_paraview = colours
            display.SetRepresentationType(representation)
            colours, points = list(display.LookupTable.RGBPoints), list(display.ScalarOpacityFunction.Points)
            check(colours[1::4] != plain[1::4], f"{representation} of {name} has ParaView's colours {colours}")
            check(len(points) > 8 or name == "smoke" or name == "soot", f"{representation} of {name} has the opacities {points}")
            check(abs(display.LookupTable.RGBPoints[-4] - named.PointData[name].GetRange()[1]) < 1e-3, f"range of {name}: {colours}")
            display.LookupTable.RGBPoints = of_paraview
            display.Opacity, display.Position = 0.9, [1, 0, 0]
            check(list(display.LookupTable.RGBPoints) == of_paraview, f"ParaView's colours of {name}, chosen for {representation}, do not stay")
            pvs.Delete(view)
            pvs.Delete(named)
            for function in (pvs.GetColorTransferFunction(name), pvs.GetOpacityTransferFunction(name)):
                pvs.Delete(function)


def main():
    from paraview import servermanager
    presets = servermanager.vtkSMTransferFunctionPresets.GetInstance() if hasattr(
        servermanager.vtkSMTransferFunctionPresets, "GetInstance") else servermanager.vtkSMTransferFunctionPresets()
    names = [presets.GetPresetName(i) for i in range(presets.GetNumberOfPresets())]
    ours = [name for name in names if name.startswith("Nephoscope ")]
    check(len(ours) == len(set(ours)) == 10, f"presets: {ours}")

    weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
    globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=30)
    globe.UpdatePipeline()
    surface = pvs.CloudSurface(Input=globe)
    check(surface.ContourBy[1] == "cloud_fraction", f"Cloud Surface begins with {surface.ContourBy}")
    view = new_view((60, 40))
    display = pvs.Show(globe, view)
    for array, white in (("cloud_fraction", True), ("clwmr", True), ("gh", False)):
        pvs.ColorBy(display, ("POINTS", array))
        colours = list(pvs.GetColorTransferFunction(array).RGBPoints)
        check((min(colours[-3:]) > 0.99) == white, f"{array} begins with {colours}")
    pvs.Delete(view)
    plain = list(pvs.GetColorTransferFunction("RTData").RGBPoints)
    for array in ("p", "t", "T", "u", "v", "w", "U", "q", "Density", "cloud_cover", "smoke"):
        colours = list(pvs.GetColorTransferFunction(array).RGBPoints)
        check(colours == plain, f"{array}, a name of many things, begins with {colours}")
    opacity = pvs.GetOpacityTransferFunction("cloud_fraction")
    opacity.ApplyPreset("Nephoscope Clouds", False)
    points = list(opacity.Points)
    check(len(points) == 12 and points[5] == 0, f"opacities of the preset: {points}")
    check_short_names()
    check_plain_representations()
    passed()


main()
