# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vectors on the splats of one, two and four ranks are the same picture: of one greatest speed, one unit of length, one phase."""
from RankPictures import compare, run_ranks

SCRIPT = "TexturedSplatsVectorsRun.py"
NAMES = ("streaks", "segments", "cells", "layers", "wind")

# Each rank rounds to 8 bits. One splat of the wind, at the border of two regions, is drawn differently on two ranks: 22 pixels, by up to 16.
KNOWN = ("wind",)

one = run_ranks(SCRIPT, NAMES, 1)
for number in (2, 4):
    several = run_ranks(SCRIPT, NAMES, number)
    title = f"1 and {number} ranks"
    compare(one, several, title, [name for name in NAMES if name not in KNOWN], largest=3, mean=0.25)
    compare(one, several, title, KNOWN, largest=16, mean=0.25)
print("NEPHOSCOPE-PASSED")
