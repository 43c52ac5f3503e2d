# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats on one to four ranks, and on a server, are the same picture."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "TexturedSplatsRun.py"
SMOOTH = ("image", "cells", "structured", "tetrahedra", "particles")
STEEP = ("globe",)

one = run_ranks(SCRIPT, SMOOTH + STEEP, 1)
# Each rank's picture has 8 bits when they are composited, and every result is rounded again: up to one unit a rank. Splats on both sides
# of a border that overlap are laid over each other in the order of the regions, not of their centres: neighbours in a smooth field have
# nearly one colour, those of the forecast's humidity do not.
for number in (2, 3, 4):
    others = run_ranks(SCRIPT, SMOOTH + STEEP, number)
    compare(one, others, f"1 and {number} ranks", SMOOTH, largest=number + 2, mean=0.2)
    compare(one, others, f"1 and {number} ranks", STEEP, largest=20, mean=0.25)
compare(one, run_with_server(SCRIPT, SMOOTH + STEEP), "local and client-server", SMOOTH + STEEP, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
