# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the documentation: every ```python block of every page, by the name of the page and its number there."""
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
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


def is_for_paraview(name, text):
    return "paraview.simple" in text or name.startswith("paraview-") or "Show(" in text
