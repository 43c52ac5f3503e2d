# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds with their thickness are the same picture on one to four ranks, and on a server of three: a cloud may begin on one rank and end on another."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "CloudTextureThicknessRun.py"
BODIES = ("ball", "thin ball", "row", "row from behind", "row without thickness", "added", "rough", "turned", "clipped", "cut cells", "linear density",
          "contour", "hexahedra", "on few ranks", "sun", "moving")
VOLUMES = ("image", "structured", "unstructured", "cell density", "blocks volume", "image here")
HAZED = ("haze",)
SCENES = BODIES + VOLUMES + HAZED

one = run_ranks(SCRIPT, SCENES, 1)
for ranks in (2, 3, 4):
    # Each rank's picture has 8 bits when they are composited, and results are rounded again.
    compare(one, run_ranks(SCRIPT, SCENES, ranks), f"1 and {ranks} ranks", SCENES, largest=3, mean=0.6)
compare(one, run_with_server(SCRIPT, ("row", "image"), 3), "1 rank and a server of 3", ("row", "image"), largest=3, mean=0.6)
compare(one, run_with_server(SCRIPT, ("image here",), 3), "1 rank and the client of a server of 3", ("image here",), largest=1, mean=0.1)
print("NEPHOSCOPE-PASSED")
