# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of all snippets and scenes, each made in a process and a folder of its own."""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pictures
from snippets import ROOT, is_for_paraview, snippets

BASELINES = ROOT / "Testing" / "Baselines"
HERE = Path(__file__).resolve().parent
TIMEOUT = 240  # s


def scenes():
    """Names of the scenes of the mappers."""
    return re.findall(r'^@scene\("([^"]+)"', (HERE / "mapper_scenes.py").read_text(encoding="utf-8"), re.MULTILINE)


def all_names():
    return [*snippets(), *scenes()]


def names_for(host):
    """Names of the snippets for "paraview", or for "python"."""
    return [name for name, text in snippets().items() if is_for_paraview(name, text) == (host == "paraview")]


def command(name):
    if name in scenes():
        return [sys.executable, str(HERE / "mapper_scenes.py"), name]
    return [*interpreter(name), str(HERE / "run_snippet.py"), name]


def interpreter(name):
    if not is_for_paraview(name, snippets()[name]):
        return [sys.executable]
    return [os.environ.get("NEPHOSCOPE_PVPYTHON") or "pvpython", "--dr"]


def render(name):
    """(picture, None), or (None, why there is none)."""
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(ROOT / "Data", Path(folder) / "Data")
        try:
            made = subprocess.run(command(name), cwd=folder, capture_output=True, text=True,
                                  timeout=TIMEOUT, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return None, f"it takes more than {TIMEOUT} s"
        file = Path(folder) / "picture.png"
        if made.returncode or "NEPHOSCOPE-PICTURE" not in made.stdout or not file.is_file():
            return None, f"it fails (exit status {made.returncode}):\n{made.stdout[-1500:]}{made.stderr[-3000:]}"
        return pictures.load(file), None


def baseline(name):
    file = BASELINES / f"{name}.png"
    return pictures.load(file) if file.is_file() else None


def problem(name, picture, stored):
    """The sentence that says how a picture differs from its baseline; None if they agree."""
    why = pictures.disagreement(picture, stored)
    return why or (pictures.light_disagreement(picture, stored) if name in scenes() else None)
