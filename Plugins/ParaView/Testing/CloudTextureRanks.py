# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds on one and three ranks, and on a server, are the same picture."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "CloudTextureRun.py"
SCENES = ("globe", "clouds", "plain")

one = run_ranks(SCRIPT, SCENES, 1)
three = run_ranks(SCRIPT, SCENES, 3)
compare(one, three, "1 and 3 ranks", ("globe", "plain"), largest=2, mean=0.01)
# Where the surface is cut at the border of two ranks, small triangles have other normals: single pixels.
compare(one, three, "1 and 3 ranks", ("clouds",), largest=64, mean=0.03)
compare(one, run_with_server(SCRIPT, SCENES), "local and client-server", SCENES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
