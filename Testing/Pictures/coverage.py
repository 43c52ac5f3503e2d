# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes, filters and sources in ParaView, and representations that no snippet, no scene and no figure shows: each of those has a stored picture."""
import re

from snippets import ROOT, is_for_paraview, snippets

PARAVIEW = ROOT / "Plugins" / "ParaView"


def text_of(*files):
    return "\n".join(file.read_text(encoding="utf-8") for file in files)


def shown_in_paraview():
    own = [text for name, text in snippets().items() if is_for_paraview(name, text)]
    return "\n".join([*own, text_of(*(ROOT / "Testing/Pictures").glob("*_scenes.py"), *(ROOT / "Figures").rglob("*.py"))])


def proxies():
    """What the menus Filters and Sources have, as Python calls it: the label without spaces."""
    groups = re.findall(r'<ProxyGroup name="(?:filters|sources)">.*?</ProxyGroup>', text_of(*sorted(PARAVIEW.glob("*.xml*"))), re.DOTALL)
    return [label.replace(" ", "") for group in groups for label in re.findall(r'<SourceProxy [^>]*?label="([^"]+)"', group)]


def representations():
    return sorted(set(re.findall(r'nephoscope_extend_representation\(\S+ \w+ "([^"]+)"', text_of(PARAVIEW / "RepresentationXML.cmake"))))


def classes():
    """Those of the techniques that can be made. A representation shows its mapper, and so does a filter in ParaView its class."""
    return [file.stem for folder in ("Filters", "Representations") for file in sorted((ROOT / folder).glob("*/vtk*.h"))
            if f"{file.stem}* New()" in file.read_text(encoding="utf-8")]


def without_picture():
    host = shown_in_paraview()
    everywhere = "\n".join([host, *snippets().values(), text_of(ROOT / "Testing/Pictures/scenes_vtk.py")])
    return [*(name for name in proxies() if f"{name}(" not in host), *(name for name in representations() if f'"{name}"' not in host),
            *(name for name in classes() if not re.search(rf"\b(vtk)?{name[3:]}\b", everywhere))]
