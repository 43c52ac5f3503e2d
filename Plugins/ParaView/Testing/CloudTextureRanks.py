# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds on one to three ranks, and on a server, are the same picture."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "CloudTextureRun.py"
SCENES = ("globe", "clouds", "plain")

one = run_ranks(SCRIPT, SCENES, 1)
for number in (2, 3):
    others = run_ranks(SCRIPT, SCENES, number)
    compare(one, others, f"1 and {number} ranks", ("globe", "plain"), largest=2, mean=0.01)
    # Where the surface is cut at the border of two ranks, small triangles have other normals: single pixels.
    compare(one, others, f"1 and {number} ranks", ("clouds",), largest=64, mean=0.03)
compare(one, run_with_server(SCRIPT, SCENES), "local and client-server", SCENES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
