# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the panels of ParaView show of the plugin: a label and a help text for every property, and a help page for every proxy.

    TestPanels.py HELP FILE.xml...     HELP: the packed help pages, empty where they are not built
"""
import pathlib
import re
import sqlite3
import sys
import tempfile
import xml.etree.ElementTree as ET
import zlib

TOP = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(TOP / "Plugins/ParaView/Help"))
import make_help  # noqa: E402


def all_proxies(files):
    for file in files:
        for group in ET.parse(file).getroot().findall("ProxyGroup"):
            for proxy in group:
                if proxy.tag.endswith("Proxy") or proxy.tag == "Extension":
                    yield group.get("name"), proxy


def properties_of(proxy):
    return [e for e in proxy if e.tag.endswith("Property")]


def unexplained(group, proxy):
    where = "%s.%s" % (group, proxy.get("name"))
    if proxy.tag != "Extension" and not make_help.text_of(proxy.find("Documentation")):
        yield f"{where}: no help text"
    for prop in properties_of(proxy):
        if prop.tag == "InputProperty" and prop.get("name") == "Input":
            if prop.find("Documentation") is None:
                yield f"{where}.Input: no help text"
            continue  # ParaView shows it under its own name, where it does
        if not prop.get("label"):
            yield f"{where}.{prop.get('name')}: no label"
        if len(make_help.text_of(prop.find("Documentation"))) < 10:
            yield f"{where}.{prop.get('name')}: no help text"


# ParaView shows lists (of numbers, or of names) without a label: each is to be the last of a group, which then names it.
def unlabelled_lists(group, proxy, lists):
    for grouping in proxy.iter("PropertyGroup"):
        names = [p.get("name") for p in grouping.findall("Property")]
        found = [name for name in names if name in lists]
        if len(found) > 1 or (found and names[-1] != found[0]):
            yield f"{group}.{proxy.get('name')}: {', '.join(found)} in the group '{grouping.get('label')}' can not be told apart"
        words = set(re.findall(r"[a-z]{3,}", (grouping.get("label") or "").lower()))
        for name in found:
            own = set(re.findall(r"[a-z]{3,}", make_help.label_of(lists[name]).lower()))
            if not own & words:
                yield f"{group}.{proxy.get('name')}.{name}: its group is called '{grouping.get('label')}'"
    if proxy.tag != "Extension":
        grouped = {p.get("name") for g in proxy.iter("PropertyGroup") for p in g.findall("Property")}
        for prop in properties_of(proxy):
            shown = prop.get("panel_visibility") != "never" and group != "representations" and not group.startswith("internal")
            if prop.get("name") in lists and shown and prop.get("information_only") != "1" and prop.get("name") not in grouped:
                yield f"{group}.{proxy.get('name')}.{prop.get('name')}: a list in no group, so without a label"


def packed_pages(file):
    """Names and texts of the pages in a file of Qt's help, which is an SQLite database of compressed files."""
    database = sqlite3.connect("file:%s?mode=ro" % file, uri=True)
    rows = database.execute("SELECT n.Name, d.Data FROM FileNameTable n JOIN FileDataTable d ON n.FileId = d.Id").fetchall()
    return {name: zlib.decompress(data[4:]).decode("utf-8") for name, data in rows if data}


def missing_pages(pages, files):
    for (group, name), proxy in make_help.proxies(files).items():
        page = pages.get("%s.%s.html" % (group, name))
        if page is None:
            yield f"{group}.{name}: no help page"
            continue
        for prop in properties_of(proxy):
            if make_help.is_shown(prop) and make_help.html.escape(make_help.label_of(prop)) not in page:
                yield f"{group}.{name}: {prop.get('name')} is not on its help page"


def made_pages(files):
    with tempfile.TemporaryDirectory() as folder:
        make_help.main(folder, "Nephoscope", *files)
        return {f.name: f.read_text(encoding="utf-8") for f in pathlib.Path(folder).glob("*.html")}


def main(packed, *files):
    problems, of_representations = [], {}
    for group, proxy in all_proxies(files):
        lists = {p.get("name"): p for p in properties_of(proxy) if p.get("repeat_command") == "1"}
        if group == "representations":
            of_representations.update(lists)
        problems += unexplained(group, proxy)
        problems += unlabelled_lists(group, proxy, of_representations if proxy.tag == "Extension" else lists)
    problems += missing_pages(packed_pages(packed) if packed else made_pages(files), files)
    print("\n".join(problems) or "%d proxies: every property is labelled and explained" % len(list(all_proxies(files))))
    return 1 if problems else 0


sys.exit(main(*sys.argv[1:]))
