# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference pages of what ParaView has: the properties of the plugin's filters, sources, readers, writers and representations, from its XML.

The pages are those of ParaView's own help window (Plugins/ParaView/Help/make_help.py), in another form.
"""
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
PLUGIN = TOP / "Plugins/ParaView"
sys.path.insert(0, str(PLUGIN / "Help"))
import make_help  # noqa: E402
from headers import escaped  # noqa: E402

WITHOUT_A_BUILD = """ParaView
========

The properties of filters, sources and representations are not on this copy of the site: it was made without a configured build, which writes a
part of them. For all of it: ``./nephoscope build``, then ``./nephoscope docs``.
"""


def definitions(build):
    """The XML files of the plugin; None where those that CMake writes are missing."""
    made = [build / "Plugins/ParaView" / name for name in ("FlowVolume.xml", "Representations.xml")]
    return [*sorted(PLUGIN.glob("*.xml")), *made] if all(path.is_file() for path in made) else None


def row(prop):
    name, label = prop.get("name"), make_help.label_of(prop)
    choices = ", ".join(entry.get("text") for entry in prop.findall("EnumerationDomain/Entry"))
    default = make_help.default_of(prop)
    heading = f"**{escaped(label)}** (``{name}``)" + (f", default: {escaped(default)}" if default else "")
    text = escaped(make_help.text_of(prop.find("Documentation"))) + (f" Choices: {escaped(choices)}." if choices else "")
    return f"{heading}\n   {text}\n"


def page(title, proxy):
    properties = [row(prop) for prop in proxy if prop.tag.endswith("Property") and make_help.is_shown(prop)]
    listed = ["Properties", "----------", "", *properties] if properties else []
    return "\n".join([title, "=" * len(title), "", escaped(make_help.text_of(proxy.find("Documentation"))), "", *listed])


def title_of(group, proxy):
    kind = {"filters": " (filter)", "sources": " (source)", "writers": " (writer)"}.get(group, "")
    return make_help.title_of(group, proxy) + kind


def summary(proxy):
    return escaped(re.split(r"(?<=[.]) ", make_help.text_of(proxy.find("Documentation")))[0])


def files(build):
    """{path on the site: text}"""
    paths = definitions(build)
    if paths is None:
        return {"api/paraview.rst": WITHOUT_A_BUILD}
    found = sorted((title_of(group, proxy), f"{group}.{name}", proxy) for (group, name), proxy in make_help.proxies(paths).items())
    made = {f"api/paraview/{name}.rst": page(title, proxy) for title, name, proxy in found}
    made["api/paraview.rst"] = "\n".join([
        "ParaView", "========", "",
        "What the plugin adds, with the properties as the panel shows them; in brackets their names in Python. ParaView shows the same pages behind \"?\".",
        "", *[f":doc:`{title} <paraview/{name}>`\n   {summary(proxy)}\n" for title, name, proxy in found],
        ".. toctree::", "   :hidden:", "", *[f"   paraview/{name}" for _, name, _ in found], ""])
    return made
