# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the documentation's pages, to be run as it stands."""
import os
import re
import tempfile
from contextlib import contextmanager
from pathlib import Path

import pyvista

ROOT = Path(os.environ["NEPHOSCOPE_DATA"]).parent


def snippets(page):
    """{name: text} of the marked snippets of Documentation/page."""
    text = (ROOT / "Documentation" / page).read_text()
    return dict(re.findall(r"<!-- snippet: (\w+) -->\s*```python\n(.*?)```", text, re.DOTALL))


@contextmanager
def run(page, name, names=None):
    """Runs a snippet, without a window, in a folder of its own; yields that folder. `names`: what it leaves."""
    previous = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pyvista.OFF_SCREEN = True
        try:
            left = {} if names is None else names
            left["__name__"] = "snippet"
            exec(compile(snippets(page)[name], f"{page}: {name}", "exec"), left)
            yield Path(folder)
        finally:
            os.chdir(previous)
