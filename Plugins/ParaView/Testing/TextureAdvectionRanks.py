# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One process, two and three ranks give every point the same texture coordinates: of the grid, and of points of the same source."""
import sys

import numpy as np
from MpiTesting import arrays_of_ranks


def rows(parts, name):
    """All points of all ranks, each once: neighbouring pieces share points."""
    return np.unique(np.concatenate([part[name] for part in parts]), axis=0)


one = arrays_of_ranks("TextureAdvectionRun.py", "texture-advection", 1)
for ranks in (2, 3):
    parts = arrays_of_ranks("TextureAdvectionRun.py", "texture-advection", ranks)
    for name in ("grid", "points"):
        expected, found = rows(one, name), rows(parts, name)
        sizes = [len(part[name]) for part in parts]
        print(f"{name}: {len(expected)} points on one rank; on {ranks} ranks {sizes}")
        if max(sizes) > 0.8 * len(expected) or not np.array_equal(expected, found):
            sys.exit(f"{name}: texture coordinates on one rank and on {ranks} differ")
print("NEPHOSCOPE-PASSED")
