# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unstructured clouds, blocks, and the ground below them have the same light on one rank and on two: clouds of all ranks cast their shadows. Smoke has the same extinction on one to three."""
import sys

import numpy as np
from MpiTesting import arrays_of_ranks

EXTINCTION = 1  # number of the column of SunlightRun.py
ROUNDING, ABSORBED = 2e-5, 3e-4  # of sums in another order; the last column is a difference of fluxes


def light_by_place(parts, name):
    return {tuple(row[:3]): row[3:] for part in parts for row in part[name]}


one, two = (arrays_of_ranks("SunlightRun.py", "sunlight", ranks) for ranks in (1, 2))
for name in ("mesh", "blocks", "ground", "below"):
    expected, found = light_by_place(one, name), light_by_place(two, name)
    if expected.keys() != found.keys() or not all(0 < len(part[name]) < 0.8 * len(expected) for part in two if name in ("mesh", "blocks")):
        sys.exit(f"{name}: {len(expected)} points on one rank, {[len(part[name]) for part in two]} on two")
    differences = np.max([np.abs(row[3:] - expected[tuple(row[:3])]) for part in two for row in part[name]], axis=0)
    darkest = min(row[2] for row in expected.values())
    print(f"{name}: {len(expected)} points, at least {darkest:.3f} of the beam; one rank and two differ by {differences}")
    if (differences[:-1] > ROUNDING).any() or differences[-1] > ABSORBED or darkest > 0.5:
        sys.exit(f"{name}: the light on two ranks is not that on one")
for ranks, parts in ((1, one), (2, two), (3, arrays_of_ranks("SunlightRun.py", "sunlight", 3))):
    extinction = np.concatenate([part["smoke"][:, 3 + EXTINCTION] for part in parts])
    print(f"smoke on {ranks} ranks: extinction {extinction.min():.5f} to {extinction.max():.5f}")
    if ranks == 1:
        expected = extinction.max()
    if np.abs(extinction / expected - 1).max() > 1e-4:  # the same everywhere in this smoke
        sys.exit("smoke: its extinction on several ranks is not that on one")
print("NEPHOSCOPE-PASSED")
