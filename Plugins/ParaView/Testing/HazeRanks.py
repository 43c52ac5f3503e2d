# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Haze on one and two ranks, and on a server, is the same picture; but several ranks leave the background clear."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "HazeRun.py"
SCENES = ("clear sky", "hazed sky")  # the second in one process only

one = run_ranks(SCRIPT, SCENES, 1)
compare(one, run_ranks(SCRIPT, SCENES[:1], 2), "1 and 2 ranks", SCENES[:1], largest=2, mean=0.05)
compare(one, run_with_server(SCRIPT, SCENES), "local and client-server", SCENES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
