# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference pages of what ParaView has: the properties of the plugin's filters, sources, readers, writers and representations, from its XML.

The pages are those of ParaView's own help window (Plugins/ParaView/Help/make_help.py), in another form.
"""
import io
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
PLUGIN = TOP / "Plugins/ParaView"
sys.path.insert(0, str(PLUGIN / "Help"))
import make_help  # noqa: E402
from headers import escaped  # noqa: E402

STEP = re.compile(r'^(?:set\((\w+) (?:"((?:\\.|[^"\\])*)"|(\w+))\)|nephoscope_configure_text\((\S+) (\w+)\))', re.MULTILINE)


def filled(name, variables):
    """A template with its variables put in, as CMake does."""
    return re.sub(r"@(\w+)@", lambda match: variables.get(match[1], ""), (PLUGIN / name).read_text(encoding="utf-8"))


def representations():
    """Representations.xml, but for what it adds to ParaView's own: the steps of RepresentationXML.cmake, which need ParaView there."""
    variables = {}
    for name, text, word, file, made in STEP.findall((PLUGIN / "RepresentationXML.cmake").read_text(encoding="utf-8")):
        variables[name or made] = filled(file, variables) if file else word or text.replace('\\"', '"')
    return filled("Representations.xml.in", variables)


def definitions():
    """The XML of the plugin, as files."""
    shared = [filled(f"{name}.xml.in", {"shared_properties": (PLUGIN / f"{name}Properties.xml.in").read_text(encoding="utf-8")}) for name in ("FlowVolume", "Globe", "Smoothing")]
    return [*sorted(PLUGIN.glob("*.xml")), *map(io.StringIO, shared), io.StringIO(representations())]


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


def files():
    """{path on the site: text}"""
    found = sorted((title_of(group, proxy), f"{group}.{name}", proxy) for (group, name), proxy in make_help.proxies(definitions()).items())
    made = {f"api/paraview/{name}.rst": page(title, proxy) for title, name, proxy in found}
    made["api/paraview.rst"] = "\n".join([
        "ParaView", "========", "",
        "What the plugin adds, with the properties as the panel shows them; in brackets their names in Python. ParaView shows the same pages behind \"?\".",
        "", *[f":doc:`{title} <paraview/{name}>`\n   {summary(proxy)}\n" for title, name, proxy in found],
        ".. toctree::", "   :hidden:", "", *[f"   paraview/{name}" for _, name, _ in found], ""])
    return made
