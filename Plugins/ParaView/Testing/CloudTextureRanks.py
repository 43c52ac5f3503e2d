# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds on one and three ranks, and on a server, are the same picture, also with their thickness."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "CloudTextureRun.py"
SCENES = ("globe", "clouds", "thick", "plain")

one = run_ranks(SCRIPT, SCENES, 1)
three = run_ranks(SCRIPT, SCENES, 3)
compare(one, three, "1 and 3 ranks", ("globe", "plain"), largest=2, mean=0.01)
compare(one, three, "1 and 3 ranks", ("thick",), largest=3, mean=0.03)
# One pixel of 90,000, on the border between ranks, differs by 13.
compare(one, three, "1 and 3 ranks", ("clouds",), largest=3, mean=0.03, dots=0.0001)
compare(one, run_with_server(SCRIPT, SCENES), "local and client-server", SCENES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
