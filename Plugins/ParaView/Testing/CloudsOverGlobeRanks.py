# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example Clouds over the Globe has the same arrays on one rank and on two, also after another time and a Sun."""
import sys

import numpy as np
from MpiTesting import arrays_of_ranks


def by_place(parts):
    """All arrays in the order of the places, of each the first."""
    joined = {name: np.concatenate([part[name] for part in parts]) for name in [*parts[0]["names"], "changed"]}
    _, order = np.unique(joined["place"], axis=0, return_index=True)
    return {name: values[order] for name, values in joined.items()}


one, two = (arrays_of_ranks("CloudsOverGlobeRun.py", "clouds-over-globe", ranks) for ranks in (1, 2))
expected, found = by_place(one), by_place(two)
if expected.keys() != found.keys() or not all(0 < len(part["place"]) < 0.8 * len(one[0]["place"]) for part in two):
    sys.exit(f"{sorted(expected)} on one rank, {sorted(found)} on two, which have {[len(part['place']) for part in two]} points")
for name in expected:
    if not np.array_equal(expected[name], found[name], equal_nan=True):
        sys.exit(f"{name}: other values on two ranks")
if np.array_equal(expected["changed"], expected["Sunlight"]):
    sys.exit("another time has not changed the light")
print(f"{len(expected['place'])} points with {len(expected)} arrays are equal")
print("NEPHOSCOPE-PASSED")
