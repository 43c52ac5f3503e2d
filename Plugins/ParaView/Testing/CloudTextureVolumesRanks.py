# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds of unstructured data, and of polygons with sharp edges, on one and three ranks are the same picture: no walls between ranks."""
from RankPictures import compare, run_ranks

SCRIPT = "CloudTextureVolumesRun.py"
SCENES = ("tetrahedra", "hexahedra", "appended", "distributed", "split", "group", "top", "numbered", "faces")
POLYGONS = ("cylinder",)  # a border makes edges, and a pixel there may belong to another triangle

one = run_ranks(SCRIPT, SCENES + POLYGONS, 1)
three = run_ranks(SCRIPT, SCENES + POLYGONS, 3)
# Each rank's picture has 8 bits when they are composited, and results are rounded again.
compare(one, three, "1 and 3 ranks", SCENES, largest=3, mean=0.2)
compare(one, three, "1 and 3 ranks", POLYGONS, largest=3, mean=0.2, dots=0.0001)
print("NEPHOSCOPE-PASSED")
