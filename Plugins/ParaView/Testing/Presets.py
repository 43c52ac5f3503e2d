# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The presets are in ParaView's list, and arrays of the weather begin with the colours of theirs; filters after Globe Grid begin with
clouds."""
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
    for array, white in (("cloud_fraction", True), ("clwmr", True), ("t", False), ("cc", False), ("RTData", False)):
        colours = list(pvs.GetColorTransferFunction(array).RGBPoints)
        check((min(colours[-3:]) > 0.99) == white, f"{array} begins with {colours}")
    plain = list(pvs.GetColorTransferFunction("RTData").RGBPoints)
    for array in ("p", "t", "T", "u", "v", "w", "U", "q", "Density"):
        colours = list(pvs.GetColorTransferFunction(array).RGBPoints)
        check(colours == plain, f"{array}, a name of many things, begins with {colours}")
    opacity = pvs.GetOpacityTransferFunction("cloud_fraction")
    opacity.ApplyPreset("Nephoscope Clouds", False)
    points = list(opacity.Points)
    check(len(points) == 12 and points[5] == 0, f"opacities of the preset: {points}")
    check_short_names()
    passed()


main()
