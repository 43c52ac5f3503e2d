# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds with their thickness are the same picture on one to four ranks, and on a server of three, or a client that draws its data: a cloud may begin on one rank and end on another."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "CloudTextureThicknessRun.py"
BODIES = ("ball", "thin ball", "row", "row from behind", "added", "rough", "turned", "clipped", "cut cells", "linear density",
          "contour", "hexahedra", "on few ranks", "sun", "moving", "in motion")
VOLUMES = ("image", "structured", "unstructured", "cell density", "blocks volume")
HAZED = ("haze",)
MANY_LAYERS = ("row without thickness",)
DRAWN_HERE = ("row", "clipped", "cut cells", "hexahedra", "on few ranks", *VOLUMES)
EXACT = BODIES + VOLUMES + HAZED
SCENES = EXACT + MANY_LAYERS

one = run_ranks(SCRIPT, SCENES, 1, limit=600)
for ranks in (2, 3, 4):
    several = run_ranks(SCRIPT, SCENES, ranks, limit=600)
    # Each rank's picture has 8 bits when they are composited, and results are rounded again: 3 times on 4 ranks, of as many translucent layers, to 4 in a pixel of 14,400.
    compare(one, several, f"1 and {ranks} ranks", MANY_LAYERS, largest=3, mean=0.15, dots=0.0001 if ranks == 4 else 0)
    compare(one, several, f"1 and {ranks} ranks", EXACT, largest=3, mean=0.15)
compare(one, run_with_server(SCRIPT, ("row", "image"), 3), "1 rank and a server of 3", ("row", "image"), largest=3, mean=0.15)
for number in (2, 3):
    here = run_with_server(SCRIPT, DRAWN_HERE, number, ["1000"])
    compare(one, here, f"1 rank and the client of a server of {number}", DRAWN_HERE, largest=3, mean=0.15)
print("NEPHOSCOPE-PASSED")
