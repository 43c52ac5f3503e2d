# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters for smoke: defaults, ranges and names are those of the C++ classes, everything is explained and in a group."""
import nephoscope
import numpy as np
from paraview import make_name_valid
from PluginDefinitions import children, compare_default, definition, is_information, nested, own_properties
from PluginTesting import check, load_plugin, passed, pvs
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData

PLACE = {"Center", "Radius", "Normal"}  # a fresh filter starts in the flow: FlowVolume.py
BEYOND = {"InitialDensity", "TimeScale"}  # C++ takes others too, or checks them when unsteady alone
SELECTION = "SelectInputVectors"        # an array, not a member
RENAMED = {SELECTION: "Velocity"}       # XML name -> name in Python, where it is another one
RESULTS = {"NormalUsed", "DurationUsed", "TimeStepUsed", "MaximumEdgeLengthUsed", "EmittedMass", "LostMass", "ObstacleMass"}
OWN = {"FollowData", "PreviewCenter"}                    # of ParaView's class alone
BY_POLYGON = {"NormalToFlow"}           # C++: by which polygon it is; one filter each here
INFORMATION = {"FlowVolume": RESULTS | {"PlaceCenter", "PlaceNormal", "PlaceRadius", "PreviewNormal"}, "FlowVolumeFromPolygon": RESULTS,
               "SmokePuffs": {"ActualPeriod", "TimestepValues", "TimeRange"}}
UNITS = {"FlowVolume": ("(length/s)", "(times in s)", "(length)"), "FlowVolumeFromPolygon": ("(length/s)", "(times in s)", "(length)"),
         "SmokePuffs": ("Time (s)", "(shares)")}


def settable(class_):
    """Members with a getter and a setter of the class itself."""
    filter_, inherited = class_(), set(dir(class_.__bases__[0]))
    members = {n[3:] for n in dir(filter_) if n.startswith("Get") and hasattr(filter_, "Set" + n[3:])}
    return members - {n[3:] for n in inherited} - {"Controller"}  # ParaView's own, by default


def check_members(name, class_, without=frozenset()):
    properties = own_properties(definition("filters", name))
    information = {n for n, e in properties.items() if is_information(e)}
    check(information == INFORMATION[name], f"{name}: information {sorted(information)}")
    members = set(properties) - information - {SELECTION} - OWN
    check(settable(class_) - without == members, f"{name}: C++ and XML differ in {sorted(settable(class_) - without ^ members)}")
    filter_ = class_()
    for member in members - BY_POLYGON:
        compare_default(name, member, properties[member], getattr(filter_, "Get" + member)())


def complains(filter_):
    """Whether an update in a uniform flow ends with an error."""
    errors = []
    image = vtkImageData()
    image.SetDimensions(5, 5, 5)
    velocity = vtkDoubleArray()
    velocity.SetName("velocity")
    velocity.SetNumberOfComponents(3)
    velocity.SetNumberOfTuples(125)
    for component in range(3):
        velocity.FillComponent(component, 1.0)
    image.GetPointData().AddArray(velocity)
    filter_.SetInputDataObject(image)
    filter_.SetCenter(2, 2, 2)
    filter_.AddObserver("ErrorEvent", lambda *_: errors.append(True))
    filter_.Update()
    return bool(errors)


def check_ranges(name, class_):
    """A value beyond the end of a range is one that the class does not take, or complains of."""
    for member, element in own_properties(definition("filters", name)).items():
        for domain in nested(element, "DoubleRangeDomain") + nested(element, "IntRangeDomain"):
            for end, beyond in (("min", -1), ("max", 1)):
                text = domain.GetAttribute(end)
                if text is None or member in BEYOND:
                    continue
                limit, filter_ = float(text), class_()
                cast = int if domain.GetName() == "IntRangeDomain" else float
                getattr(filter_, "Set" + member)(cast(limit))
                check(getattr(filter_, "Get" + member)() == limit, f"{name}.{member}: {end} {limit} is not taken")
                getattr(filter_, "Set" + member)(cast(limit + beyond * np.maximum(abs(limit), 1)))
                check(getattr(filter_, "Get" + member)() == limit or complains(filter_), f"{name}.{member}: more than its {end} {limit} is taken")


def check_entries(name, class_, member, prefix):
    """The entries of a list are the names of the class."""
    enumeration = nested(own_properties(definition("filters", name))[member], "EnumerationDomain")[0]
    for entry in nested(enumeration, "Entry"):
        filter_ = class_()
        getattr(filter_, prefix + entry.GetAttribute("text").replace("Runge-Kutta 4-5", "RungeKutta45").replace("Runge-Kutta 4", "RungeKutta4"))()
        check(getattr(filter_, "Get" + member)() == int(entry.GetAttribute("value")), f"{name}.{member}: {entry.GetAttribute('text')}")


def check_panel(name):
    element = definition("filters", name)
    for property_ in children(element):
        if property_.GetName().endswith("Property") and property_.GetAttribute("panel_visibility") != "never":
            own = property_.GetAttribute("name")
            check(nested(property_, "Documentation"), f"{name}.{own} has no help")
            python = make_name_valid(property_.GetAttribute("label") or own)
            check(python == RENAMED.get(own, own), f"{name}.{own} is called {python} in Python")
    groups = nested(element, "PropertyGroup")
    grouped = {p.GetAttribute("name") for g in groups for p in nested(g, "Property")} - {"Input"}
    shown = {n for n, e in own_properties(element).items() if e.GetAttribute("panel_visibility") != "never"}
    check(grouped == shown, f"{name}: not in a group: {sorted(grouped ^ shown)}")
    labels = " ".join(g.GetAttribute("label") for g in groups)
    check(all(unit in labels for unit in UNITS[name]), f"{name}: units in {labels!r}")
    hints = nested(element, "Hints")[0]
    check(nested(hints, "ShowInMenu")[0].GetAttribute("category") == "Nephoscope", f"{name} is not in the menu")
    check(nested(hints, "RepresentationType")[0].GetAttribute("type") == "Cell Compositing", f"{name} does not come up as smoke")


def check_widget():
    widgets = [g for g in nested(definition("filters", "FlowVolume"), "PropertyGroup") if g.GetAttribute("panel_widget")]
    check(len(widgets) == 1 and widgets[0].GetAttribute("panel_widget") == "InteractiveCylinder", "no widget for the polygon")
    functions = {p.GetAttribute("function"): p.GetAttribute("name") for p in nested(widgets[0], "Property")}
    check(functions == {"Center": "Center", "Axis": "Normal", "Radius": "Radius", "Input": "Input"}, f"the widget drives {functions}")


def check_fresh(proxy, class_, without=frozenset()):
    for member in settable(class_) - without:
        value = proxy.SMProxy.GetProperty(member).GetElement(0)
        expected = getattr(class_(), "Get" + member)()
        check(value == expected, f"a fresh {proxy.SMProxy.GetXMLLabel()} has {member} = {value!r}, C++ {expected!r}")


def check_given_input():
    """The velocity is one of the input that a script gives, not of the source that is active meanwhile; a name that no data have stays."""
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    active, given = (pvs.Calculator(Input=wavelet, ResultArrayName=name, Function="iHat+jHat") for name in ("active", "given"))
    for source in (active, given):
        source.UpdatePipeline()
    for make in (pvs.FlowVolume, pvs.TextureCoordinateAdvection):
        pvs.SetActiveSource(active)
        made = make(Input=given)
        check(list(made.Velocity) == ["POINTS", "given"], f"the velocity of {made.GetXMLName()} is {made.Velocity}")
        pvs.SetActiveSource(active)
        made = make(Input=given, Velocity=["POINTS", "typo"])
        check(list(made.Velocity) == ["POINTS", "typo"], f"a name that is not there has become {made.Velocity}")


if __name__ == "__main__":
    load_plugin()
    check_given_input()
    check_members("FlowVolume", nephoscope.vtkFlowVolume)
    check_members("FlowVolumeFromPolygon", nephoscope.vtkFlowVolume, without=PLACE | {"NumberOfSides"})
    check_members("SmokePuffs", nephoscope.vtkSmokePuffs)
    for filter_name, filter_class in (("FlowVolume", nephoscope.vtkFlowVolume), ("SmokePuffs", nephoscope.vtkSmokePuffs)):
        check_ranges(filter_name, filter_class)
    check_entries("FlowVolume", nephoscope.vtkFlowVolume, "Integrator", "SetIntegratorTo")
    check_entries("SmokePuffs", nephoscope.vtkSmokePuffs, "Normalization", "SetNormalizationTo")
    check_entries("SmokePuffs", nephoscope.vtkSmokePuffs, "Association", "SetAssociationTo")
    for filter_name in UNITS:
        check_panel(filter_name)
    check_widget()
    wavelet = pvs.Wavelet()
    check_fresh(pvs.FlowVolume(Input=wavelet), nephoscope.vtkFlowVolume, PLACE | BY_POLYGON)
    check_fresh(pvs.SmokePuffs(Input=pvs.FlowVolume(Input=wavelet)), nephoscope.vtkSmokePuffs)
    passed()
