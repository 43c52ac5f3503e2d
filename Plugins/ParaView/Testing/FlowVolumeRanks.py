# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flow volumes of data on one, two and three ranks are the same, cell by cell.

The shares of the ranks, put together in the order of the ranks, are the cells that one rank makes, so cells are compared one
by one: corner positions (relative to the size of the data) and every array (relative to its largest value).
"""
import os
import subprocess
import sys

import numpy as np

from MpiTesting import AWAKE, program

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["NEPHOSCOPE_TEST_OUTPUT"]
SCRIPT = os.path.join(HERE, "FlowVolumeRanksRun.py")
RANKS = (1, 2, 3)
LARGEST = 1e-9
CASES = ("image", "image-border", "image-in-border", "image-cells", "curved", "curved-leaving", "chessboard", "ghosts",
         "one-rank-has-all", "blocks", "blocks-missing", "small-obstacles", "divided", "adaptive", "automatic", "polygon",
         "unsteady", "unsteady-later", "unsteady-curved", "unsteady-adaptive", "unsteady-ghosts", "unsteady-blocks", "unsteady-turning", "unsteady-obstacles", "globe", "globe-seam", "globe-pole")
ERRORS = {"outside": "is outside the data, which are within x -1 to 1, y -1 to 1, z -1 to 1",
          "no-velocity": "'Flow'"}
EMPTY = tuple(ERRORS) + ("stopped",)


def check(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def run(ranks):
    """All shares of all volumes on so many ranks, and what was printed."""
    prefix = os.path.join(OUTPUT, f"flow-volume-{ranks}")
    command = [program("MPIEXEC"), "-np", str(ranks), program("PVBATCH"), "--dr", "--symmetric", SCRIPT, prefix]
    try:
        done = subprocess.run(command, env=AWAKE, capture_output=True, text=True, timeout=300)
    except subprocess.TimeoutExpired as late:
        sys.exit(f"FAILED: {ranks} ranks hang\n{late.stdout}\n{late.stderr}")
    text = done.stdout + done.stderr
    check(text.count("NEPHOSCOPE-PASSED") == ranks, f"{ranks} ranks did not run to their end\n{text}")
    shares = {name: [dict(np.load(f"{prefix}-{name}-{rank}.npz")) for rank in range(ranks)] for name in CASES + EMPTY}
    return shares, text


def whole(shares):
    filled = [share for share in shares if share["count"] > 0]
    names = filled[0].keys() if filled else ()
    check(all(share.keys() == names for share in filled), f"arrays differ: {[sorted(s) for s in filled]}")
    return {name: np.concatenate([share[name] for share in filled]) for name in names if name not in ("count", "points")}


def compare(one, shares, title):
    """The largest difference; balanced and compact shares."""
    counts = [int(share["count"]) for share in shares]
    check(max(counts) - min(counts) <= 1, f"{title}: shares of {counts} cells")
    for share in shares:
        check(share["points"] == len(np.unique(share["position"].reshape(-1, 3), axis=0)), f"{title}: points that no cell uses")
    all_of_it = whole(shares)
    check(all_of_it.keys() == one.keys(), f"{title}: arrays {sorted(all_of_it)} and {sorted(one)}")
    check(len(all_of_it["position"]) == len(one["position"]),
          f"{title}: {len(all_of_it['position'])} cells and {len(one['position'])}")
    largest = 0.0
    for name, values in one.items():
        check(values.dtype == all_of_it[name].dtype and values.shape == all_of_it[name].shape, f"{title}: type of {name}")
        others = all_of_it[name]
        check((np.isnan(values) == np.isnan(others)).all(), f"{title}: {name} is NaN elsewhere")
        scale = max(np.abs(np.nan_to_num(values)).max(), 1e-300)
        difference = np.abs(np.nan_to_num(values.astype(float) - others.astype(float))).max() / scale
        integer = np.issubdtype(values.dtype, np.integer)
        limit = 0.0 if name == "cell EmissionStep" else 1.0 / scale if integer else 1e-6 if values.dtype == np.float32 else LARGEST
        check(difference <= limit, f"{title}: {name} differs by {difference:.3g} of its largest value")
        largest = max(largest, 0.0 if integer or values.dtype == np.float32 else difference)
    return largest


def mass(volume):
    p = volume["position"]
    return (volume["cell Density"] * np.abs(np.linalg.det(p[:, 1:] - p[:, :1])) / 6.0).sum()


results, texts = zip(*(run(ranks) for ranks in RANKS))
for name in CASES:
    check(results[0][name][0]["count"] > 50, f"{name}: only {results[0][name][0]['count']} cells")
    one = whole(results[0][name])
    differences = [compare(one, shares[name], f"{name} on {ranks} ranks") for ranks, shares in zip(RANKS[1:], results[1:])]
    masses = [mass(whole(shares[name])) for shares in results]
    check(np.ptp(masses) <= LARGEST * masses[0], f"{name}: masses {masses}")
    print(f"{name}: {len(one['position'])} cells; 2 and 3 ranks differ by", *(f"{d:.1e}" for d in differences))
for ranks, shares, text in zip(RANKS, results, texts):
    for name in EMPTY:
        check(all(share["count"] == 0 for share in shares[name]), f"{name}: a volume on {ranks} ranks")
    errors = [line for line in text.splitlines() if "ERR|" in line]
    check(len(errors) == len(ERRORS), f"{ranks} ranks print {len(errors)} errors:\n" + "\n".join(errors))
    for (name, words), line in zip(ERRORS.items(), errors):
        check(words in line, f"{name}: {line}")
print("NEPHOSCOPE-PASSED")
