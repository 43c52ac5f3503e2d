# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One process and two ranks smooth and contour alike: the same triangles with the same normals, the same values."""
import sys

import numpy as np
from MpiTesting import arrays_of_ranks


def rows(parts, name):
    """All rows of all ranks, in one order."""
    found = np.concatenate([part[name] for part in parts])
    return np.unique(found, axis=0) if name == "values" else found[np.lexsort(found.T)]


one, two = (arrays_of_ranks("CloudSurfaceRun.py", "cloud-surface", ranks) for ranks in (1, 2))
for part in two:
    if not 0.2 < len(part["triangles"]) / len(one[0]["triangles"]) < 0.8:
        sys.exit(f"a rank has {len(part['triangles'])} of {len(one[0]['triangles'])} triangles")
for name in ("triangles", "values"):
    if not np.array_equal(rows(one, name), rows(two, name)):
        sys.exit(f"{name} differ between one rank and two")
    print(f"{name}: {len(rows(one, name))} rows, the same on one rank and on two")
print("NEPHOSCOPE-PASSED")
