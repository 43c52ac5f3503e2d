# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One process, two ranks, and a server with its client draw the same pictures."""
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "CellCompositingRun.py"
PICTURES = ("image", "tetrahedra", "structured", "cells", "coarse", "coarse-cells", "stray", "ids", "moved", "turned", "hexahedra", "as-tetrahedra",
            "hexahedra-as-tetrahedra", "turned-image", "mixed-trilinear", "contours", "warped", "lit-image", "lit-structured", "lit-tetrahedra", "lit-hexahedra", "other-image", "other-structured", "magnitude",
            "media", "media-hexahedra", "beside-nothing")
PEELED = ("surfaces", "surfaces-tetrahedra")  # every rank peels on its own, and rounds to 8 bits at every peel
POLYGONS = ("polygons", "default-value", "mixed")  # a pixel at an edge may miss one, and a border makes edges
ALL = PICTURES + POLYGONS + PEELED
# What a client and a server exchange: data, properties, ranges; not how cells are divided among ranks.
REMOTE = ("image", "tetrahedra", "structured", "cells", "moved", "turned", "mixed-trilinear", "contours", "lit-structured", "other-image", "magnitude", "media", "surfaces", "polygons",
          "default-value")

one = run_ranks(SCRIPT, ALL, 1)
two = run_ranks(SCRIPT, ALL, 2)
# Each rank's picture has 8 bits when the two are composited, and the result is rounded again.
compare(one, two, "one and two ranks", PICTURES, largest=2, mean=0.15)
compare(one, two, "one and two ranks", POLYGONS, largest=2, mean=0.15, dots=0.002)
compare(one, two, "one and two ranks", PEELED, largest=5, mean=0.15)
compare(one, run_with_server(SCRIPT, REMOTE), "local and client-server", REMOTE, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
