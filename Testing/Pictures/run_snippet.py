# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_snippet.py NAME: runs a snippet in the current folder, before it those that it continues and after it those that continue it, and leaves their
pictures in pictures/NAME.png.

In plain Python or in pvpython, by the snippet. Python's run as pasted; what a page takes as given in ParaView is made
before. What a snippet leaves undrawn is drawn after it (scenes_vtk.py, scenes_paraview.py).
"""
import importlib
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from snippets import is_for_paraview, series, snippets  # noqa: E402


def run(name):
    text = snippets()[name]
    host = importlib.import_module("scenes_paraview" if is_for_paraview(name, text) else "scenes_vtk")
    names = {"__name__": "snippet"}
    host.prepare(name, names)
    os.mkdir("pictures")
    for part in series(name):
        exec(compile(snippets()[part], part, "exec"), names)
        host.AFTER.get(part, host.keep_picture)(names)
        os.replace("picture.png", f"pictures/{part}.png")
        print(f"wrote {os.getcwd()}/pictures/{part}.png", flush=True)


if __name__ == "__main__":
    run(sys.argv[1])
