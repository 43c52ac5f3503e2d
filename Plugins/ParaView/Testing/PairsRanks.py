# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two things in one view, one before, behind and within the other: one process and two ranks draw the same picture.

Usage: PairsRanks.py [few]; few: one picture or two of each thing.
"""
import sys

import numpy as np
from MpiTesting import program
from Pairs import LARGEST, LARGEST_OF_DOTS, dots, few, names
from RankPictures import launcher, run

SCRIPT = "PairsRun.py"
chosen = few() if sys.argv[1:] == ["few"] else names()


def drawn_by(ranks):
    return run(launcher(ranks) + [program("PVBATCH"), "--dr"], SCRIPT, "-".join([*sys.argv[1:], str(ranks)]), chosen, ["0", ",".join(chosen)], limit=900)


def compare(name, first, second):
    """What is wrong, or nothing."""
    difference = np.abs(first - second).max(axis=2)
    largest, more = difference.max(), (difference > LARGEST).mean()
    print(f"{name}: max {largest:.0f}, mean {difference.mean():.4f} of 255" + (f"; more than {LARGEST} in {more:.3%} of the pixels" if more else ""))
    if (np.abs(first - first[0, 0]).max(axis=2) > 10).mean() < 0.01:
        return f"{name}: nothing is drawn"
    return f"{name}: max {largest:.0f}" if more > dots(name) or largest > LARGEST_OF_DOTS else None


one, two = drawn_by(1), drawn_by(2)
wrong = list(filter(None, (compare(name, one[name], two[name]) for name in chosen)))
if wrong:
    sys.exit("\n".join(wrong))
print("NEPHOSCOPE-PASSED")
