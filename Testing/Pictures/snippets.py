# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the documentation: every ```python block of every page, by the name of the page and its number there."""
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
CONTINUES = "# continues the snippet above\n"  # its first line: it needs what that has made
FOLDERS = ("Data", "Documentation", "Figures", "Filters", "Plugins", "Representations", "Testing")


def pages():
    yield ROOT / "README.md"
    yield ROOT / "CONTRIBUTING.md"
    for folder in FOLDERS:
        yield from sorted((ROOT / folder).rglob("*.md"))


def name_of(page):
    """The page's name; a README has that of its folder."""
    folder = page.parent.name if page.parent != ROOT else ""
    return (folder or "README") if page.stem == "README" else page.stem


def snippets():
    """{name: text}"""
    return {f"{name_of(page)}-{number}": text for page in pages() if page.is_file()
            for number, text in enumerate(BLOCK.findall(page.read_text(encoding="utf-8")), 1)}


def before(name):
    """The snippets of its page that a snippet continues, in their order."""
    page, _, number = name.rpartition("-")
    if not snippets()[name].startswith(CONTINUES):
        return []
    above = f"{page}-{int(number) - 1}"
    return [*before(above), above]


def series(name):
    """The snippets of its page that run in one process, one after the other, and this among them."""
    page, _, number = name.rpartition("-")
    below = f"{page}-{int(number) + 1}"
    return series(below) if snippets().get(below, "").startswith(CONTINUES) else [*before(name), name]


def is_for_paraview(name, text):
    return "paraview.simple" in text or name.startswith("paraview-") or "Show(" in text
