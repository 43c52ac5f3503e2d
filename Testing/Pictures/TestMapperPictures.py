# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestMapperPictures.py GROUP|SCENE...: draws scenes of mapper_scenes.py and compares them with Testing/Baselines.

`./nephoscope baselines NAME` refreshes one.
"""
import sys

import judge
import mapper_scenes
import numpy as np
import pictures


def check_checks():
    """Two per cent less light is noticed, also where every pixel is within the other limits."""
    shade = np.full((150, 200, 3), 60.0)
    y, x = np.mgrid[:150, :200]
    shade += 80 * np.exp(-((x - 100) ** 2 + (y - 75) ** 2) / 1500.0)[:, :, None]
    dimmer = 60 + 0.98 * (shade - 60)
    assert pictures.disagreement(dimmer, shade) is None
    assert pictures.light_disagreement(dimmer, shade) and pictures.light_disagreement(shade, shade) is None


def main(chosen):
    check_checks()
    names = [name for name in mapper_scenes.SCENES if {name, name.split("-")[0]} & set(chosen)]
    return judge.report(names, problem_of)


def problem_of(name):
    try:
        picture, why = mapper_scenes.draw(name), None
    except RuntimeError as error:
        picture, why = None, str(error)
    return judge.problem_of(name, picture, why)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
