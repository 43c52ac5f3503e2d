# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""check.py FOLDER: what holds for every page of the site: links inside it lead somewhere, and nothing is loaded from the network."""
import html.parser
import pathlib
import sys
import urllib.parse

LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}


class Page(html.parser.HTMLParser):
    """Names of anchors, targets of links, and what is loaded."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loaded = {""}, [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors |= {found.get("id"), found.get("name")}
        if tag == "a" and "href" in found:
            self.links.append(found["href"])
        if LOADED.get(tag) in found and found.get("rel") not in ("search", "index", "next", "prev", "canonical"):
            self.loaded.append(found[LOADED[tag]])


def is_outside(url):
    return bool(urllib.parse.urlsplit(url).netloc)


def problem_of(path, link, pages):
    url = urllib.parse.urlsplit(link)
    if url.scheme or url.netloc:
        return None
    target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
    if not target.is_file():
        return f"there is no {link}"
    if target in pages and urllib.parse.unquote(url.fragment) not in pages[target].anchors:
        return f"there is no place {link}"
    return None


def problems(folder):
    pages = {path: Page(path) for path in sorted(pathlib.Path(folder).resolve().rglob("*.html"))}
    for path, page in pages.items():
        found = [f"it loads {url}" for url in page.loaded if is_outside(url)]
        found += [problem_of(path, link, pages) for link in [*page.links, *page.loaded] if not is_outside(link)]
        yield from sorted({f"{path.name}: {why}" for why in found if why})


def main(folder):
    found = list(problems(folder))
    print("\n".join(found) or "All links inside the site are right.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
