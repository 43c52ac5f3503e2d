# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_snippet.py NAME: runs a snippet in the current folder and leaves its picture there, as picture.png.

In plain Python or in pvpython, by the snippet. Python's run as pasted, alone or after those that they continue; what a page takes as given in ParaView is made
before. What a snippet leaves undrawn is drawn after it (scenes_vtk.py, scenes_paraview.py).
"""
import importlib
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from snippets import before, is_for_paraview, snippets  # noqa: E402


def run(name):
    text = snippets()[name]
    host = importlib.import_module("scenes_paraview" if is_for_paraview(name, text) else "scenes_vtk")
    names = {"__name__": "snippet"}
    host.prepare(name, names)
    for part in [*before(name), name]:
        exec(compile(snippets()[part], part, "exec"), names)
    host.AFTER.get(name, host.keep_picture)(names)
    print("NEPHOSCOPE-PICTURE", flush=True)


if __name__ == "__main__":
    run(sys.argv[1])
