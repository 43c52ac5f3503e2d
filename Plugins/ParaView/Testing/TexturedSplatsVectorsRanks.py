# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors on the splats of one and three ranks are the same picture: of one greatest speed, one unit of length, one phase, one time scale."""
import sys

import numpy as np
from RankPictures import compare, run_ranks

SCRIPT = "TexturedSplatsVectorsRun.py"
NAMES = ("streaks", "segments", "cells", "layers", "wind", "true-speed-start", "true-speed", "true-speed-segments")

one = run_ranks(SCRIPT, NAMES, 1)
compare(one, run_ranks(SCRIPT, NAMES, 3), "1 and 3 ranks", NAMES, largest=3, mean=0.25)  # rounding of each rank to 8 bits
moved = (np.abs(one["true-speed"] - one["true-speed-start"]).max(axis=2) > 10).mean()
if moved < 0.05:
    sys.exit(f"with the time {moved:.1%} of the picture change: streaks do not move")
print("NEPHOSCOPE-PASSED")
