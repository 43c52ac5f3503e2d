# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A globe in the light of a Sun with a date: on one and two ranks, and on a server, the same picture."""
import sys

from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "SunRun.py"
SCENES = ("noon", "evening")
LIT = ("shadows", "clouds")
SPLATS = ("splats",)  # by Sunlight
HAZED = ("shafts", "shadowless haze")

one, two = (run_ranks(SCRIPT, SCENES + LIT + SPLATS + HAZED, ranks) for ranks in (1, 2))
compare(one, two, "1 and 2 ranks", SCENES + LIT, largest=2, mean=0.1)
compare(one, two, "1 and 2 ranks", SPLATS, largest=2, mean=0.25)  # of which many pixels have parts on both ranks
compare(one, two, "1 and 2 ranks", HAZED, largest=2, mean=0.15)  # with shadows and without alike
if (one["shadowless haze"] - one["shafts"]).max() < 15:
    sys.exit("clouds cast no shadows in the haze")
compare(one, run_with_server(SCRIPT, SCENES), "local and client-server", SCENES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
