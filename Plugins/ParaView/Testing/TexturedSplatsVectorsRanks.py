# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors on the splats of one, two and four ranks are the same picture: of one greatest speed, one unit of length, one phase."""
from RankPictures import compare, run_ranks

SCRIPT = "TexturedSplatsVectorsRun.py"
NAMES = ("streaks", "segments", "cells", "layers", "wind")

one = run_ranks(SCRIPT, NAMES, 1)
for number in (2, 4):
    compare(one, run_ranks(SCRIPT, NAMES, number), f"1 and {number} ranks", NAMES, largest=3, mean=0.25)  # rounding of each rank to 8 bits
print("NEPHOSCOPE-PASSED")
