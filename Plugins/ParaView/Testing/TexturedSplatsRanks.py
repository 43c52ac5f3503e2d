# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats on one to four ranks, and on a server, are the same picture."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "TexturedSplatsRun.py"
PICTURES = ("image", "cells", "structured", "tetrahedra", "particles", "globe")

one = run_ranks(SCRIPT, PICTURES, 1)
# Each rank's picture has 8 bits when they are composited, and every result is rounded again.
for number in (2, 3, 4):
    compare(one, run_ranks(SCRIPT, PICTURES, number), f"1 and {number} ranks", PICTURES, largest=number, mean=0.15)
compare(one, run_with_server(SCRIPT, PICTURES), "local and client-server", PICTURES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
