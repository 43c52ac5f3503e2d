# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestDocumentationPictures.py HOST: runs every snippet of the documentation and compares its picture with Testing/Baselines.

On a failure the new picture, and old, new and difference side by side, are kept in the output folder of the tests and named.
`./nephoscope baselines` refreshes the baselines.
"""
import os
import sys
from pathlib import Path

import pictures
import render

OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])


def problem_of(name):
    picture, why = render.render(name)
    if picture is None:
        return why
    stored = render.baseline(name)
    why = pictures.emptiness(picture)
    if why is None and stored is None:
        why = "there is no baseline: make one by ./nephoscope baselines " + name
    why = why or pictures.disagreement(picture, stored)
    if why is None:
        return None
    pictures.save(picture, OUTPUT / f"{name}.png")
    pictures.save(pictures.side_by_side(picture, stored), OUTPUT / f"{name}.difference.png")
    return f"{why}. Kept: {OUTPUT / name}.png; old, new, difference: {OUTPUT / name}.difference.png"


def check_checks():
    """What is blank, or of one colour, is never a picture; what is moved, or of another colour, does not agree."""
    import numpy as np
    blank = np.full((300, 400, 3), 255.0)
    assert pictures.emptiness(blank) and pictures.emptiness(blank + [0, 0, -200])
    disc = blank.copy()
    y, x = np.mgrid[:300, :400]
    disc[(x - 150) ** 2 + (y - 150) ** 2 < 60 ** 2] = (40, 80, 120)
    assert pictures.emptiness(disc) is None and pictures.disagreement(disc, disc) is None
    assert pictures.disagreement(np.roll(disc, 1, axis=1), disc) is None, "an edge may move by a pixel"
    for other in (disc[:, ::-1], blank, 0.8 * disc, np.roll(disc, 20, axis=0), disc[:200]):
        assert pictures.disagreement(other, disc), "a wrong picture agrees"


def main(host, chosen):
    check_checks()
    names = [name for name in render.names_for(host) if not chosen or name in chosen]
    known = {path.stem for path in render.BASELINES.glob("*.png")}
    problems = {name: f"Testing/Baselines/{name}.png belongs to no snippet: delete it" for name in known - set(render.snippets())}
    for name in names:
        why = problem_of(name)
        print(f"{name}: {why or 'as stored'}", flush=True)
        if why:
            problems[name] = why
    for name, why in problems.items():
        print(f"FAILED {name}: {why}", flush=True)
    return 1 if problems or not names else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
