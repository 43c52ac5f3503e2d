# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of all snippets, scenes and figures, each made in a process and a folder of its own."""
import functools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pictures
from snippets import ROOT, is_for_paraview, series, snippets

BASELINES = ROOT / "Testing" / "Baselines"
HERE = Path(__file__).resolve().parent
FIGURES = ROOT / "Figures"
TIMEOUT = 240  # s
# Figures that let their size be chosen are drawn small, and with coarser clouds: they are compared at 200 pixels.
SMALLER = {"22_flat_and_lit_clouds": "--size 640 360", "23_hurricane_at_dawn": "--size 640 360 --step 0.2", "24_silver_lining_and_fogbow": "--size 600 400",
           "25_light_shafts": "--size 640 240", "26_everything_together": "--size 480 270"}


def scenes(*of):
    """Names of the scenes of the mappers, or of those of "representation"s in ParaView."""
    text = "\n".join((HERE / f"{one}_scenes.py").read_text(encoding="utf-8") for one in of or ("cell", "splat", "cloud", "haze"))
    return re.findall(r'^@scene\("([^"]+)"', text, re.MULTILINE)


def figures():
    """{name in the gallery: script}. Pictures have the number of their script; a script that writes several names them in its text."""
    named = {path: re.findall(rf'"({path.stem[:3]}\w+)(?:[.]png)?"', path.read_text(encoding="utf-8")) for path in sorted(FIGURES.glob("*.py"))}
    return {name: path for path, names in named.items() for name in [path.stem, *names]}


def all_names():
    return [*snippets(), *scenes(), *scenes("representation"), *figures()]


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
    return [paraview_python(), "--dr"]


def paraview_python():
    return os.environ.get("NEPHOSCOPE_PVPYTHON") or "pvpython"


def run(command, folder):
    """What it printed, and why it failed: None if it did not."""
    environment = {**os.environ, "NEPHOSCOPE_GALLERY": folder, "NEPHOSCOPE_FILMS": "no", "NEPHOSCOPE_FIGURE_SHRINK": "3", "NEPHOSCOPE_PYTHON": sys.executable, "NEPHOSCOPE_DATA": str(ROOT / "Data"),
                   "NEPHOSCOPE_FORECAST": os.path.join(folder, "forecast.nc")}
    try:
        made = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=TIMEOUT,
                              stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return "", f"it takes more than {TIMEOUT} s"
    told = f":\n{made.stdout[-1500:]}{made.stderr[-3000:]}"
    if " ERR| " in made.stderr:
        return made.stdout, "it reports errors" + told
    return made.stdout, f"it fails (exit status {made.returncode})" + told if made.returncode else None


def written(*commands, data=True):
    """({name: picture}, None) of a script that says which it wrote, or ({}, why there are none). Others may run before it."""
    with tempfile.TemporaryDirectory() as folder:
        if data:
            os.symlink(ROOT / "Data", Path(folder) / "Data")
        why = None
        for command in commands:
            printed, why = ("", why) if why else run(command, folder)
        files = [Path(folder) / file for file in re.findall(r"^wrote (.*[.]png)$", printed, re.MULTILINE)]
        return ({}, why) if why else ({file.stem: pictures.load(file) for file in files}, None)


@functools.lru_cache(maxsize=None)
def run_figure(script):
    """A figure that moves has a series of 10 degrees in place of that of `./nephoscope forecast`, which takes minutes."""
    before = []
    if "NEPHOSCOPE_FORECAST" in script.read_text(encoding="utf-8"):
        before = [[sys.executable, str(ROOT / "Data/forecast/make_forecast.py"), "forecast.nc", "--grid", "test", "--hours", "48"]]
    return written(*before, [str(Path(paraview_python()).with_name("pvbatch")), str(script), *SMALLER.get(script.stem, "").split()])


@functools.lru_cache(maxsize=None)
def run_representations():
    return written([paraview_python(), "--dr", str(HERE / "representation_scenes.py"), *scenes("representation")])


@functools.lru_cache(maxsize=None)
def run_snippets(last):
    """Those of a page that continue one another. Python's have only what `pip install` gives, and no Data."""
    return written(command(last), data=is_for_paraview(last, snippets()[last]))


def run_of(name):
    if name in figures():
        return run_figure(figures()[name])
    return run_representations() if name in scenes("representation") else run_snippets(series(name)[-1])


def problem_of_names(name, made):
    """The sentence that says that a script does not write a picture, or one that would have no baseline; None if it does neither."""
    unknown = sorted(set(made) - set(all_names()))
    if unknown:
        return f"the script writes {unknown[0]}.png as well: its text must name it in quotes, and the name begin with the number of the script"
    return None if name in made else f"the script does not write {name}.png"


def render(name):
    """(picture, None), or (None, why there is none)."""
    if name in scenes():
        return render_scene(name)
    made, why = run_of(name)
    why = why or problem_of_names(name, made)
    return (None, why) if why else (made[name], None)


def render_scene(name):
    with tempfile.TemporaryDirectory() as folder:
        _, why = run(command(name), folder)
        return (None, why) if why else (pictures.load(Path(folder) / "picture.png"), None)


def baseline(name):
    file = BASELINES / f"{name}.png"
    return pictures.load(file) if file.is_file() else None


def problem(name, picture, stored):
    """The sentence that says how a picture differs from its baseline; None if they agree."""
    why = pictures.disagreement(picture, stored)
    return why or (pictures.light_disagreement(picture, stored) if name in [*scenes(), *scenes("representation")] else None)
