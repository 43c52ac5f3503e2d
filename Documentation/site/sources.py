# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""sources.py FOLDER: gathers what Sphinx reads, in a folder of its own.

The pages are the Markdown files of the project, each at its place in the tree, so that a link is right on GitHub and on the site. Pages of
the gallery and of the reference are made of figures, snippets, headers, docstrings and ParaView's XML.
"""
import os
import pathlib
import re
import sys

import gallery
import headers
import proxies
import python_api

TOP = pathlib.Path(__file__).resolve().parents[2]
SITE = pathlib.Path(__file__).resolve().parent
MADE = re.compile(r"build.*|dist|Gallery|\..*")  # folders that are not the project's
LEFT_OUT = ("Plugins/PyVista/packaging/description.md",)  # the page of the Python package index
FENCE = re.compile(r"^```.*?^```", re.DOTALL | re.MULTILINE)
COMMENT = re.compile(r"^<!--.*?-->\n", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"(?<![\[`])`(\w+)`(?![\]`])")
LISTS = {"%folders%": r".+/README\.md", "%decisions%": r"Documentation/decisions/.*", "%others%": r"(?!.+/README\.md|Documentation/decisions/).*"}
LINK = re.compile(r"(?P<image>!?)\[(?P<text>[^\]]*)\]\((?P<target>[^)\s#:]+)(?P<anchor>#[^)\s]*)?\)")


def pages():
    """Path in the project: path on the site."""
    folders = [path for path in sorted(TOP.iterdir()) if path.is_dir() and not MADE.fullmatch(path.name)]
    found = [*sorted(TOP.glob("*.md")), *(path for folder in folders for path in sorted(folder.rglob("*.md")))]
    names = [path.relative_to(TOP).as_posix() for path in found if not path.is_relative_to(SITE)]
    placed = {name: name for name in names if name not in LEFT_OUT}
    return {**placed, **{path.relative_to(TOP).as_posix(): path.name for path in SITE.glob("*.md")}}


class Site:
    def __init__(self, folder):
        self.folder = folder
        self.pages = pages()
        self.pictures = gallery.pages_of_pictures()
        self.roles = {**{name: "{py:func}`%s <nephoscope.%s>`" % (name, name) for name in python_api.functions()},
                      **{path.stem: "{cpp:class}`%s`" % path.stem for path in headers.paths()}}
        self.problems = []

    def write(self, name, data):
        """`data` is text, bytes, or a file to be copied."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data.read_bytes() if isinstance(data, pathlib.Path) else data.encode() if isinstance(data, str) else data)

    def place(self, page, match):
        """A link as it is on the site: to a page, to a page of the gallery for a picture, or to a file that comes along."""
        path = pathlib.Path(os.path.normpath((TOP / page).parent / match["target"]))
        name = path.relative_to(TOP).as_posix()
        if path.is_dir():
            name += "/README.md"
            if name not in self.pages:
                return match["text"]
        if not match["image"] and name in self.pictures:
            name = self.pictures[name]
        elif name in self.pages:
            name = self.pages[name]
        elif path.is_file():
            self.write(name, path)
        else:
            self.problems.append(f"{page}: there is no {match['target']}")
        target = os.path.relpath(name, os.path.dirname(self.pages[page]) or ".")
        return f"{match['image']}[{match['text']}]({target}{match['anchor'] or ''})"

    def with_reference(self, text):
        """Names of our classes and functions are links to the reference, but for those in headings, whose anchors they are in."""
        return "\n".join(line if line.startswith("#") else CODE.sub(lambda match: self.roles.get(match[1], match[0]), line)
                         for line in text.split("\n"))

    def add_page(self, page):
        text = COMMENT.sub("", (TOP / page).read_text(encoding="utf-8"))
        fences = FENCE.findall(text)
        parts = [self.with_reference(LINK.sub(lambda match: self.place(page, match), part)) for part in FENCE.split(text)]
        text = "".join(part + fence for part, fence in zip(parts, [*fences, ""]))
        named = {*re.findall(r"[\w./-]+\.md", text), "index.md"}
        for word, pattern in LISTS.items():
            if word in text:
                names = [name for name in self.pages.values() if re.fullmatch(pattern, name) and name not in named]
                text = text.replace(word, "\n".join("/" + name for name in sorted(names)))
        self.write(self.pages[page], text)


def main(folder):
    site = Site(pathlib.Path(folder).resolve())
    for page in site.pages:
        site.add_page(page)
    for made in (gallery.files(), python_api.files(), headers.files(), proxies.files()):
        for name, data in made.items():
            site.write(name, data)
    print("\n".join(site.problems) or "All pages are gathered.")
    return 1 if site.problems else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
