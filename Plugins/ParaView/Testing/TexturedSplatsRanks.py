# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Splats on one and three ranks, and on a server, are the same picture."""
import sys

import numpy as np
from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "TexturedSplatsRun.py"
ONE_PICTURE = ("image", "again", "cells", "structured", "tetrahedra", "particles", "hexahedra", "own-hexahedra", "own-tetrahedra", "hidden", "stray", "turned", "globe", "numbered", "numbered-image",
               "slice", "flat", "flat-cells", "tilted", "tilted-cells", "trees", "cells-of-trees", "no-vectors")
NAMES = ONE_PICTURE + ("hierarchy", "grid")
# What a client and a server exchange: data, properties, ranges; not how points are divided among ranks.
REMOTE = ("image", "again", "hierarchy", "cells", "turned", "particles", "hidden", "globe", "slice", "trees", "no-vectors")


def check_hierarchy(one, others, number):
    """Every rank has a hierarchy of its own samples: as near to the picture of all samples as that of one process, if not the same."""
    errors = [np.abs(pictures["hierarchy"] - one["again"]) for pictures in (one, others)]
    print(f"hierarchy, error on 1 and {number} ranks: mean {errors[0].mean():.3f}, {errors[1].mean():.3f} of 255")
    if errors[0].mean() < 0.05 or errors[1].mean() > 1.5 * errors[0].mean() or errors[1].max() > 1.5 * errors[0].max():
        sys.exit(f"the hierarchy on {number} ranks is farther from the picture of all samples than that of one")


one = run_ranks(SCRIPT, NAMES, 1)
if abs(one["stray"].mean() / one["particles"].mean() - 1) > 0.3:
    sys.exit(f"a few particles far away change the picture of the others: mean {one['stray'].mean():.1f} for {one['particles'].mean():.1f}")
if np.abs(one["no-vectors"] - one["again"]).max() > 1:
    sys.exit("where the vector array is wrong, the scalars are not drawn alone")
if max(np.abs(one[name] - one["grid"]).max() for name in ("hexahedra", "own-hexahedra")) > 1:
    sys.exit("splats of unstructured hexahedra differ from those of the same structured grid")
# Each rank's picture has 8 bits when they are composited, and results are rounded again.
three = run_ranks(SCRIPT, NAMES, 3)
compare(one, three, "1 and 3 ranks", ONE_PICTURE, largest=3, mean=0.2)
check_hierarchy(one, three, 3)
compare(one, run_with_server(SCRIPT, REMOTE), "local and client-server", REMOTE, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
