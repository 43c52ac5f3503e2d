# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A globe in the light of a Sun with a date: on one and two ranks, and on a server, the same picture. Unstructured clouds and blocks have the same light."""
import sys

import numpy as np

from RankPictures import compare, run_ranks, run_with_server

SCRIPT = "SunRun.py"
SCENES = ("noon", "evening")
LIT = ("shadows", "clouds")  # by Sunlight
COMPUTED = ("light of mesh", "light of blocks")
HAZED = ("shafts", "shadowless haze")

one, two = (run_ranks(SCRIPT, SCENES + LIT + HAZED + COMPUTED, ranks) for ranks in (1, 2))
compare(one, two, "1 and 2 ranks", SCENES + LIT, largest=2, mean=0.1)
compare(one, two, "1 and 2 ranks", HAZED, largest=2, mean=0.15)  # with shadows and without alike
for name in COMPUTED:  # sums are in another order
    if one[name].shape != two[name].shape:
        sys.exit(f"{name}: on 1 rank {one[name].shape}, on 2 ranks {two[name].shape}")
    differences = np.abs(one[name] - two[name]).max(axis=0)
    print(f"{name}: 1 and 2 ranks differ by {differences}", flush=True)
    if not (differences[:-1] < 2e-5).all() or not differences[-1] < 3e-4:  # absorbed light is a difference of fluxes
        sys.exit(f"{name}: 1 and 2 ranks differ")
    if one[name][:, 5].min() > 0.5:
        sys.exit(f"{name}: no shadows")
if (one["shadowless haze"] - one["shafts"]).max() < 15:
    sys.exit("clouds cast no shadows in the haze")
compare(one, run_with_server(SCRIPT, SCENES), "local and client-server", SCENES, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
