# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestDocumentationPictures.py HOST [NAME...]: runs every snippet of the documentation, or those named, and compares its picture with
Testing/Baselines.

On a failure the new picture, and old, new and difference side by side, are kept in the output folder of the tests and named.
`./nephoscope baselines` refreshes the baselines.
"""
import re
import sys

import judge
import pictures
import render
import snippets


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


def check_files():
    """Whoever has installed the wheel can run a snippet: Python reads samples by nephoscope.sample_data, in blocks, indented lines and sentences."""
    for page in snippets.pages():
        text = page.read_text(encoding="utf-8")
        for block in snippets.BLOCK.findall(text):
            text = text.replace(block, "") if snippets.is_for_paraview(snippets.name_of(page), block) else text
        assert not re.search(r'"(Data|build)/', text), f"{page}: Python that reads a file of the source tree"


def main(host, chosen):
    check_checks()
    check_files()
    names = [name for name in render.names_for(host) if not chosen or name in chosen]
    return judge.report(names, lambda name: judge.problem_of(name, *render.render(name)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
