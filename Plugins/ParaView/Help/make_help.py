# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Help pages for ParaView's help window, made of the plugin's server-manager XML: one page a proxy, and the project file of Qt's help.

    make_help.py FOLDER NAME FILE.xml...

writes FOLDER/<group>.<proxy>.html, FOLDER/index.html and FOLDER/NAME.qhp. ParaView's "?" looks for pages by these names in the namespace
NAME.org and the virtual folder NAME.
"""
import html
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

STYLE = ("<style>body{font-family:sans-serif} td{vertical-align:top;padding:4px 10px 4px 0} "
         "th{text-align:left;padding-right:10px}</style>")
REPRESENTATION = " (representation)"


def text_of(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def label_of(element):
    """What the panel shows: the label, or the name in words, as ParaView makes it."""
    name = element.get("name", "")
    return element.get("label") or re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


def is_shown(prop):
    return (prop.get("is_internal") != "1" and prop.get("information_only") != "1" and prop.get("panel_visibility") != "never" and
            prop.find("Documentation") is not None)


def choices(prop):
    entries = [entry.get("text") for entry in prop.findall("EnumerationDomain/Entry")]
    return "<br>Choices: " + html.escape(", ".join(entries)) + "." if entries else ""


def default_of(prop):
    value = prop.get("default_values", "")
    for entry in prop.findall("EnumerationDomain/Entry"):
        if entry.get("value") == value:
            return entry.get("text")
    if prop.find("BooleanDomain") is not None:
        return {"0": "off", "1": "on"}.get(value, value)
    return value


def rows_of(proxy):
    for prop in proxy:
        if prop.tag.endswith("Property") and is_shown(prop):
            cells = (html.escape(label_of(prop)), "<code>%s</code>" % html.escape(prop.get("name")), html.escape(default_of(prop)),
                     html.escape(text_of(prop.find("Documentation"))) + choices(prop))
            yield "<tr><td>" + "</td><td>".join(cells) + "</td></tr>"


def title_of(group, proxy):
    if group == "representations":
        return label_of(proxy).replace(" Representation", "") + REPRESENTATION
    return label_of(proxy)


def page(title, proxy):
    documentation = proxy.find("Documentation")
    rows = "\n".join(rows_of(proxy))
    table = ("<h2>Properties</h2><table><tr><th>Label</th><th>In Python</th><th>Default</th><th>Meaning</th></tr>\n%s</table>" % rows
             if rows else "")
    return "<html><head><title>%s</title>%s</head><body><h1>%s</h1><p>%s</p>%s</body></html>\n" % (
        html.escape(title), STYLE, html.escape(title), html.escape(text_of(documentation)), table)


def proxies(files):
    """Group, name and definition of every proxy; a proxy that shows a core, exposing its properties, shows them on its own page."""
    found = {}
    for file in files:
        for group in ET.parse(file).getroot().findall("ProxyGroup"):
            for proxy in group:
                if proxy.tag.endswith("Proxy") and proxy.get("name"):
                    found[group.get("name"), proxy.get("name")] = proxy
    for proxy in found.values():
        for core in proxy.findall("SubProxy/Proxy"):
            inner = found.get((core.get("proxygroup"), core.get("proxyname")))
            if inner is not None:
                shown = {p.get("name") for p in proxy.findall("SubProxy/ExposedProperties//Property")}
                proxy.extend(p for p in inner if p.get("name") in shown)
    return {key: proxy for key, proxy in found.items() if not key[0].startswith("internal_")}


def project(name, pages):
    sections = "\n".join('<section title="%s" ref="%s"/>' % (html.escape(title), file) for file, title in pages)
    files = "\n".join("<file>%s</file>" % file for file, _ in [("index.html", ""), *pages])
    keywords = "\n".join('<keyword name="%s" ref="%s"/>' % (html.escape(title), file) for file, title in pages)
    return """<?xml version="1.0" encoding="UTF-8"?>
<QtHelpProject version="1.0">
<namespace>%s.org</namespace>
<virtualFolder>%s</virtualFolder>
<filterSection>
<toc><section title="%s" ref="index.html">
%s
</section></toc>
<keywords>
%s
</keywords>
<files>
%s
</files>
</filterSection>
</QtHelpProject>
""" % (name, name, name, sections, keywords, files)


def main(folder, name, *files):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    pages = []
    for (group, proxy_name), proxy in proxies(files).items():
        file, title = "%s.%s.html" % (group, proxy_name), title_of(group, proxy)
        (folder / file).write_text(page(title, proxy), encoding="utf-8")
        pages.append((file, title))
    pages.sort(key=lambda item: item[1])
    links = "\n".join('<li><a href="%s">%s</a></li>' % (file, html.escape(title)) for file, title in pages)
    (folder / "index.html").write_text("<html><head><title>%s</title>%s</head><body><h1>%s</h1><ul>%s</ul></body></html>\n" % (
        name, STYLE, name, links), encoding="utf-8")
    (folder / (name + ".qhp")).write_text(project(name, pages), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
