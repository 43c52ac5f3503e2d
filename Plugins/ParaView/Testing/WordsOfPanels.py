# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages in ParaView have the labels of its panels, not the names of properties in C++: every sentence of every class, and some that are provoked."""
import os
import re
from pathlib import Path

import nephoscope
from nephoscope_testing.sources import sentences
from PluginTesting import GFS, check, listen, load_plugin, passed, pvs, servermanager

TOP = Path(os.environ["NEPHOSCOPE_DATA"]).parent
NAMES = {name[3:] for one in vars(nephoscope).values() if isinstance(one, type) and one.__name__.startswith("vtk")
         for name in vars(one) if name.startswith("Set") and re.search("[a-z][A-Z]", name[3:])}
# What only programs can set, and only programs do wrong.
OF_PROGRAMS = {"SetContourValue", "NumberOfContourValues", "SetNumberOfContourValues", "SetPeriodic", "SetHaze"}
messages = listen()


def names_in(text):
    words = set(re.findall(r"\w+", text))
    return {word for word in words if word in NAMES or (word.startswith("Set") and word[3:] in NAMES | {"Normal", "Origin"})} - OF_PROGRAMS


def check_sentences(folders, speaker, files=""):
    """What an object made by a proxy says of each sentence in its sources."""
    said = 0
    for folder in folders:
        for file, sentence in sentences(TOP / folder):
            if not file.startswith(files):
                continue
            messages.clear()
            speaker.InvokeEvent("WarningEvent", sentence.replace("\\n", " "))
            check(len(messages) == 1, f"{speaker.GetClassName()} says {messages} for {sentence!r}")
            left = names_in(messages[0])
            check(not left, f"{folder}/{file}: {messages[0]!r} has the names {left}")
            said += bool(names_in(sentence))
    print(f"{speaker.GetClassName()}: {said} sentences with names of properties")


# A class of ParaView, and those that have no messages.
OTHERS = {"vtkCellCompositingOverride", "vtkEarthRepresentation", "vtkFileSeriesReader", "vtkHazeSource", "vtkRankMessages"}


def check_definitions():
    """Every proxy makes an object that says labels."""
    for path in sorted((TOP / "Plugins/ParaView").glob("*.xml*")):
        for name in re.findall(r'Proxy\s[^>]*?\sclass="(\w+)"', path.read_text()):
            check(name.endswith("WithLabels") or name in OTHERS, f"{path.name}: add {name} to ClassesOfSuite.h, and call it {name}WithLabels here")


def check_provoked(what, source, *labels):
    messages.clear()
    source.UpdatePipeline()
    text = " ".join(messages)
    for label in labels:
        check(label in text, f"{what}: no {label!r} in {text!r}")
    check(not names_in(text.split("): ", 1)[-1]), f"{what}: {text!r} has the names {names_in(text)}")
    check(len(messages) == 1, f"{what}: {len(messages)} messages: {messages}")


def object_of(source):
    return source.SMProxy.GetClientSideObject()


def inside(display, exposed):
    """The object of the display inside another one that has this property."""
    return display.SMProxy.GetProperty(exposed).GetParent().GetClientSideObject()


def check_displays(wavelet):
    view = pvs.CreateRenderView(ViewSize=[60, 60])
    display = pvs.Show(wavelet, view)
    for name, folders in (("CellCompositing", ["Representations/CellCompositing", "Representations/CellCompositing/ParaView"]),
                          ("TexturedSplats", ["Representations/TexturedSplats", "Representations/TexturedSplats/ParaView"])):
        check_sentences(["Representations/Common", "Representations/Common/ParaView", *folders],
                        inside(display, name + "OpacityScale"))
    surface = pvs.Show(pvs.Sphere(), view)
    check_sentences(["Representations/CloudTexture", "Representations/CloudTexture/ParaView"], inside(surface, "CloudTextureCoverage"))
    check_sentences(["Representations/Haze", "Representations/Haze/ParaView"], object_of(pvs.Show(pvs.Haze(), view)))
    messages.clear()
    display.SetRepresentationType("Textured Splats")
    pvs.ColorBy(display, ("POINTS", "RTData"))
    display.TexturedSplatsVectorArray = "none"
    for _ in range(2):
        pvs.Render(view)
    check(len(messages) == 1 and "Choose one with Vector Array" in messages[0], f"a wrong array of vectors: {messages}")


def main():
    check_definitions()
    wavelet = pvs.Wavelet(WholeExtent=[-6, 6] * 3)
    wind = pvs.Calculator(Input=wavelet, ResultArrayName="v", Function="-coordsY*iHat+coordsX*jHat+3*kHat")
    wind.UpdatePipeline()
    weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VOI=[0, 10**6] * 3, SampleRateI=9, SampleRateJ=9)
    smoke = pvs.FlowVolume(Input=wind)
    velocity = ["Filters/VelocityField"]
    for folders, source in ((["Filters/GlobeGrid", "Filters/Common"], pvs.GlobeGrid(Input=weather)),
                            (["Filters/FlowVolume", *velocity], smoke),
                            (["Filters/CloudOptics"], pvs.CloudOptics(Input=wavelet)),
                            (["Filters/CloudSurface"], pvs.CloudSurface(Input=wavelet)),
                            (["Filters/CloudSurface"], pvs.StructuredSmoothing(Input=wavelet)),
                            (["Filters/CellSubdivision"], pvs.ContourCellSplitter(Input=wavelet)),
                            (["Filters/PolyhedronTetrahedra"], pvs.PolyhedrontoTetrahedra(Input=wavelet)),
                            (["Filters/TextureAdvection", *velocity], pvs.TextureCoordinateAdvection(Input=wind)),
                            (["Plugins/ParaView/Filters"], pvs.CloudsovertheGlobe())):
        check_sentences(folders, object_of(source))
    check_sentences(["Filters/GlobeGrid"], object_of(pvs.GlobeTerrain(Input=weather)), ("vtkGlobeTerrain", "TerrainSurface"))
    check_sentences(["Filters/Sunlight"], object_of(pvs.Sunlight(Input=wavelet)), "vtkSunlight")
    check_sentences(["Filters/Sunlight"], object_of(pvs.Sun()), "vtkSunSource")
    check_sentences(["Filters/FlowVolume"], object_of(pvs.SmokePuffs(Input=smoke)), "vtkSmokePuffs")
    manager = servermanager.ProxyManager()
    for group, name, files in (("internal_sources", "SparseVolumeReaderCore", ("VdbR", "VdbG", "VdbPo", "VdbI", "vtkSparseVolumeR")),
                               ("writers", "SparseVolumeWriter", ("VdbW", "VdbPa", "vtkSparseVolumeW"))):
        if manager.GetProxyDefinitionManager().HasDefinition(group, name):
            proxy = manager.NewProxy(group, name)
            proxy.UpdateVTKObjects()
            check_sentences(["Filters/SparseVolume"], proxy.GetClientSideObject(), files)
    check_displays(wavelet)
    check_provoked("a short duration", pvs.FlowVolume(Input=wind, Duration=1e-3, TimeStep=1e-10), "longer Time Step")
    check_provoked("few tetrahedra", pvs.FlowVolume(Input=wind, MaximumNumberOfTetrahedra=50), "Maximum Number Of Tetrahedra")
    check_provoked("levels that are heights", pvs.GlobeGrid(Input=weather, HeightArray="no"), "Height Array")
    check_provoked("one of two arrays", pvs.TextureCoordinateAdvection(Input=wind, PressureArrayName="RTData"), "Pressure Array Name", "Omega Array Name")
    check_provoked("a mass that is none", pvs.StructuredSmoothing(Input=wavelet, MassArray="no", Conservative=1), "Mass Array")
    check_provoked("contours of nothing", pvs.ContourCellSplitter(Input=wind, ContourBy=["POINTS", "no"]), "Contour By")


load_plugin()
main()
passed()
