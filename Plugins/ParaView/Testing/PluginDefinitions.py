# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin loads; its XML says what the C++ says; every property is explained; the representation is offered."""
import nephoscope
from PluginTesting import GFS, NAME, check, load_plugin, passed, pvs, servermanager

# XML property -> C++ getter, where the name differs.
MAPPER_PROPERTIES = ("OpacityScale", "Method", "Integration", "CellInterpolation", "VisibilityOrder", "SplitAtControlPoints", "AutoAdjustSampleDistances",
                     "MaximumImageSampleDistance", "ContourLighting", "SmoothContourNormals")
EXPLAINED = MAPPER_PROPERTIES + ("AutomaticUnitDistance", "UnitDistance", "ContourValues", "ContourOpacity", "ContourOpacities",
                                 "ContourColors", "ContourArray", "LayerArray", "LayerOpacityScales")


def definition(group, name):
    manager = servermanager.ProxyManager().GetProxyDefinitionManager()
    found = manager.GetProxyDefinition(group, name)
    check(found is not None, f"no {group}/{name}")
    return found


def children(element):
    return [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())]


def own_properties(element):
    """Vector properties of a definition as a dictionary by name."""
    return {e.GetAttribute("name"): e for e in children(element) if e.GetName().endswith("VectorProperty")}


def nested(element, tag):
    return [e for e in children(element) if e.GetName() == tag]


def is_information(element):
    return element.GetAttribute("information_only") == "1"


def compare_default(owner, name, element, value):
    text = element.GetAttribute("default_values")
    if value == "" and text in ("None", "Automatic"):
        return  # how menus of arrays say it
    if isinstance(value, tuple):
        xml = tuple(float(word) for word in text.split())
    else:
        xml = text if isinstance(value, str) else float(text)
    check(xml == value, f"{owner}.{name}: XML default {xml!r}, C++ default {value!r}")


def check_filter(name, class_, is_grouped=True, left_out=None):
    """`left_out`: of a class made of another one of ours, what of that one is settled by the class."""
    element = definition("filters", name)
    filter_ = class_()
    properties = own_properties(element)
    # Every getter that has a setter is a property, and the other way round.
    settable = {n[3:] for n in dir(filter_) if n.startswith("Get") and hasattr(filter_, "Set" + n[3:])}
    base = class_.__bases__[0] if left_out is None else class_.__bases__[0].__bases__[0]
    inherited = {n[3:] for n in dir(base) if n.startswith("Get")} | set(left_out or ())
    check(settable - inherited == set(properties),
          f"C++ and XML differ in {sorted((settable - inherited) ^ set(properties))}")
    for property_name, property_ in properties.items():
        compare_default(name, property_name, property_, getattr(filter_, "Get" + property_name)())
        check(nested(property_, "Documentation"), f"{name}.{property_name} has no help")
    grouped = {p.GetAttribute("name") for g in nested(element, "PropertyGroup") for p in nested(g, "Property")}
    check(not is_grouped or grouped == set(properties), f"not in a group: {sorted(set(properties) ^ grouped)}")
    menu = nested(nested(element, "Hints")[0], "ShowInMenu")[0].GetAttribute("category")
    check(menu == "Nephoscope", f"menu {menu}")


def check_fresh_proxy(name, class_, source):
    """The server manager hands the same defaults to a filter on a real input."""
    constructor = definition("filters", name).GetAttribute("label").replace(" ", "")
    proxy = getattr(pvs, constructor)(Input=source)
    filter_ = class_()
    for property_name in own_properties(definition("filters", name)):
        value = proxy.SMProxy.GetProperty(property_name).GetElement(0)
        expected = getattr(filter_, "Get" + property_name)()
        check(value == expected, f"a fresh {name} has {property_name} = {value!r}, C++ {expected!r}")
    pvs.Delete(proxy)
    pvs.Delete(source)


def check_representation():
    properties = own_properties(definition("representations", "CellCompositingRepresentation"))
    mapper = nephoscope.vtkCellCompositingMapper()
    for name in MAPPER_PROPERTIES:
        compare_default("Cell Compositing", name, properties[name], getattr(mapper, "Get" + name)())
    mapper.SetContourValue(0, 1.0)
    compare_default("Cell Compositing", "ContourOpacity", properties["ContourOpacity"], mapper.GetContourOpacity(0))
    for name in EXPLAINED:
        check(nested(properties[name], "Documentation"), f"Cell Compositing.{name} has no help")


SPLAT_MAPPER_PROPERTIES = ("OpacityScale", "Kernel", "CellSize", "CellSizeArrayHoldsVolumes", "GreatestSpeed", "StreakPeriod",
                           "VectorColor", "Phase", "PhaseCycles", "TrueSpeed", "TimeScale", "PhaseSteps", "VectorStyle", "VectorPlacement", "LayerAxis", "VectorUnit",
                           "StreakWidth", "SegmentLength", "SegmentWidth", "RadiusFactor", "ErrorTolerance", "ErrorToleranceUnit",
                           "ErrorMeasure", "LevelBlending", "InteractiveMaximumNumberOfSplats", "AutoAdjustSampleDistances",
                           "MaximumImageSampleDistance")
PARAVIEW_PROPERTIES = ("Visibility", "ForceUseCache", "ForcedCacheKey", "ColorArrayName", "Opacity", "DiffuseColor", "Position", "Scale",
                       "Orientation", "Origin", "Pickable")


def check_splats():
    properties = own_properties(definition("representations", "TexturedSplatsRepresentation"))
    mapper = nephoscope.vtkTexturedSplatMapper()
    for name in SPLAT_MAPPER_PROPERTIES:
        compare_default("Textured Splats", name, properties[name], getattr(mapper, "Get" + name)())
    for name in set(properties) - set(PARAVIEW_PROPERTIES):
        check(nested(properties[name], "Documentation"), f"Textured Splats.{name} has no help")


def check_offered(view):
    wavelet = pvs.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    sources = {
        "image": wavelet,
        "rectilinear": pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0),
        "structured": pvs.Transform(Input=wavelet),
        "unstructured": pvs.Tetrahedralize(Input=wavelet),
        "particles": pvs.PointSource(NumberOfPoints=100),
        "multiblock": pvs.GroupDatasets(Input=[wavelet, pvs.Tetrahedralize(Input=wavelet)]),
        "surface beside cells": pvs.GroupDatasets(Input=[pvs.Sphere(), wavelet]),
        "AMR": pvs.AMRGaussianPulseSource(),
        "hyper tree grid": pvs.HyperTreeGridRandom(),
    }
    for kind, source in sources.items():
        display = pvs.Show(source, view)
        offered = display.GetProperty("Representation").GetAvailable()
        for name in (NAME, "Textured Splats"):
            if kind == "particles" and name == NAME:
                continue
            check(name in offered, f"{name} is not offered for {kind} data: {offered}")
            display.SetRepresentationType(name)


def check_surfaces(view):
    """Cloud Texture is offered for surfaces of any kind."""
    for source in (pvs.Sphere(), pvs.AppendDatasets(Input=[pvs.Sphere()]), pvs.GroupDatasets(Input=[pvs.Sphere(), pvs.Cone()]), pvs.HyperTreeGridRandom()):
        offered = pvs.Show(source, view).GetProperty("Representation").GetAvailable()
        check("Cloud Texture" in offered, f"Cloud Texture is not offered: {offered}")


def check_not_offered(view):
    """Cell Compositing draws 3-D cells only: it is not offered for data without any, and comes and goes with them."""
    sheet = pvs.Wavelet(WholeExtent=[-3, 3, -3, 3, 0, 0])
    for kind, source in (("a surface", pvs.Sphere()), ("particles", pvs.PointSource()), ("a sheet", sheet),
                         ("blocks of surfaces", pvs.GroupDatasets(Input=[pvs.Sphere(), pvs.Cone()]))):
        offered = pvs.Show(source, view).GetProperty("Representation").GetAvailable()
        check(NAME not in offered, f"{NAME} is offered for {kind}")
    display = pvs.Show(sheet, view)
    sheet.WholeExtent = [-3, 3, -3, 3, -3, 3]
    sheet.UpdatePipeline()
    pvs.Render(view)
    check(NAME in display.GetProperty("Representation").GetAvailable(), f"{NAME} is not offered when cells have come")
    display.SetRepresentationType(NAME)
    sheet.WholeExtent = [-3, 3, -3, 3, 0, 0]
    pvs.Render(view)
    check(NAME in display.GetProperty("Representation").GetAvailable(), f"{NAME} was taken away while it was chosen")


def check_start():
    """OpenVDB, whose symbols take a second to look up, is loaded where a .vdb file is."""
    with open("/proc/self/maps") as maps:
        libraries = maps.read()
    check("vtkNephoscopeFiltersSparseVolume" in libraries, "the plugin is not loaded")
    check("libopenvdb" not in libraries, "ParaView starts with OpenVDB")


if __name__ == "__main__":
    load_plugin()
    check_start()
    check_filter("GlobeGrid", nephoscope.vtkGlobeGrid)
    check_fresh_proxy("GlobeGrid", nephoscope.vtkGlobeGrid, pvs.Wavelet())
    check_filter("GlobeTerrain", nephoscope.vtkGlobeTerrain, left_out=(
        "EastwardWindArrayName", "NorthwardWindArrayName", "VerticalWindArrayName", "VerticalWindIsOmega", "WindComponents",
        "TemperatureArrayName", "LevelUnits", "MaskBelowGround", "SurfacePressureArrayName", "TerrainHeightArrayName"))
    check_fresh_proxy("GlobeTerrain", nephoscope.vtkGlobeTerrain, pvs.Wavelet())
    check_filter("PolyhedronToTetrahedra", nephoscope.vtkPolyhedronToTetrahedra, is_grouped=False)
    check_fresh_proxy("PolyhedronToTetrahedra", nephoscope.vtkPolyhedronToTetrahedra, pvs.Tetrahedralize(Input=pvs.Wavelet()))
    check_representation()
    check_splats()
    check_offered(pvs.CreateRenderView())
    check_surfaces(pvs.CreateRenderView())
    check_not_offered(pvs.CreateRenderView())
    passed()
