# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors on the splats of one and three ranks are the same picture: of one greatest speed, one unit of length, one phase."""
from RankPictures import compare, run_ranks

SCRIPT = "TexturedSplatsVectorsRun.py"
NAMES = ("streaks", "segments", "cells", "layers", "wind")

one = run_ranks(SCRIPT, NAMES, 1)
compare(one, run_ranks(SCRIPT, NAMES, 3), "1 and 3 ranks", NAMES, largest=3, mean=0.25)  # rounding of each rank to 8 bits
print("NEPHOSCOPE-PASSED")
