# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every name that ListProperties gives for a source, filter or display of the suite can be read. ParaView's own displays list names that nothing reads."""
from PluginTesting import check, load_plugin, new_view, passed, pvs, servermanager

MENU = "Nephoscope"


def in_menu():
    """Proxies in the menu of the suite, as pairs of a group and a name."""
    manager = servermanager.ProxyManager().GetProxyDefinitionManager()
    found = []
    for group in ("sources", "filters"):
        definitions = manager.NewSingleGroupIterator(group)
        definitions.InitTraversal()
        while not definitions.IsDoneWithTraversal():
            name = definitions.GetProxyName()
            hints = manager.GetProxyDefinition(group, name).FindNestedElementByName("Hints")
            menu = hints and hints.FindNestedElementByName("ShowInMenu")
            if menu and menu.GetAttribute("category") == MENU:
                found.append((group, name))
            definitions.GoToNextItem()
    return found


def unreadable(proxy):
    return {name for name in proxy.ListProperties() if not hasattr(proxy, name)}


def check_displays():
    view = new_view((40, 40))
    wavelet = pvs.Wavelet(WholeExtent=[-3, 3] * 3)
    of_paraview = unreadable(servermanager._getPyProxy(servermanager.CreateProxy("representations", "GeometryRepresentation", None)))
    of_paraview |= {"ForceUseCache", "ForcedCacheKey", "RepresentationTypesInfo", "DummyInput"}
    for source in (wavelet, pvs.Contour(Input=wavelet, Isosurfaces=[100]), pvs.Sun(), pvs.Haze()):
        missing = unreadable(pvs.Show(source, view)) - of_paraview
        check(not missing, f"the display of {source.GetXMLName()} cannot read {sorted(missing)}")
    pvs.Delete(view)


load_plugin()
proxies = in_menu()
check(len(proxies) > 14, f"proxies in the menu: {proxies}")
for group, name in proxies:
    missing = unreadable(servermanager._getPyProxy(servermanager.CreateProxy(group, name, None)))
    check(not missing, f"{name} cannot read {sorted(missing)}")
check_displays()
passed()
