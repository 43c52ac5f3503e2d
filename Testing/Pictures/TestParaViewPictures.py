# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestParaViewPictures.py representation|FIGURE...: draws the scenes of representation_scenes.py, or figures as the gallery does, and
compares their pictures with Testing/Baselines."""
import sys

import judge
import render


def names_of(chosen):
    if chosen == "representation":
        return render.scenes(chosen)
    return [name for name, script in render.figures().items() if script.stem == chosen]


if __name__ == "__main__":
    sys.exit(judge.report([name for chosen in sys.argv[1:] for name in names_of(chosen)],
                          lambda name: judge.problem_of(name, *render.render(name))))
