# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures held against their baselines, and what is kept and said of those that differ."""
import os
from pathlib import Path

import coverage
import pictures
import render


def problem_of(name, picture, why=None):
    """The sentence that says why a picture is wrong; None if it is right. Keeps the picture, and the difference, in the output folder."""
    if picture is None:
        return why
    stored = render.baseline(name)
    why = pictures.emptiness(picture)
    if why is None and stored is None:
        why = without_baseline(name)
    why = why or render.problem(name, picture, stored)
    if why is None:
        return None
    output = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
    pictures.save(picture, output / f"{name}.png")
    pictures.save(pictures.side_by_side(picture, stored), output / f"{name}.difference.png")
    return f"{why}. Kept: {output / name}.png; old, new, difference: {output / name}.difference.png"


def without_baseline(name):
    return "there is no baseline: make one by ./nephoscope baselines " + name


def problems_of_baselines():
    """{name: sentence}: baselines without a picture, pictures without a baseline, and what none of the pictures shows."""
    known, names = {path.stem for path in render.BASELINES.glob("*.png")}, set(render.all_names())
    return {**{name: f"Testing/Baselines/{name}.png belongs to no snippet and no scene: delete it" for name in known - names},
            **{name: without_baseline(name) for name in names - known},
            **{name: "no snippet, no scene and no figure shows it: add a scene to Testing/Pictures" for name in coverage.without_picture()}}


def report(names, problem):
    """Prints the verdict of every name and what is wrong with the baselines as a whole; the exit status."""
    problems = problems_of_baselines()
    for name in names:
        why = problem(name)
        print(f"{name}: {why or 'as stored'}", flush=True)
        if why:
            problems[name] = why
    for name, why in problems.items():
        print(f"FAILED {name}: {why}", flush=True)
    return 1 if problems or not names else 0
