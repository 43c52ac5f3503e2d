# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Haze on one and two ranks, and on a server of one rank and of two, is the same picture, also where it lies before the background."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "HazeRun.py"
SKIES = ("clear sky", "hazed sky", "globe", "terrain", "flat map")
INSIDE = tuple(f"inside {axis}" for axis in ("+x", "-x", "+y", "-y", "+z", "-z"))
OF_SERVER = ("hazed sky", "terrain", "inside +x", "inside -x")

one = run_ranks(SCRIPT, SKIES + INSIDE, 1)
two = run_ranks(SCRIPT, SKIES + INSIDE, 2)
compare(one, two, "1 and 2 ranks", SKIES, largest=2, mean=0.05)
compare(one, two, "1 and 2 ranks", INSIDE, largest=2, mean=0.6)  # everywhere a medium in two pictures of 8 bits
compare(one, run_with_server(SCRIPT, SKIES[:2]), "local and client-server", SKIES[:2], largest=1, mean=0.01)
compare(two, run_with_server(SCRIPT, OF_SERVER, 2), "2 ranks and a server of 2", OF_SERVER, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
