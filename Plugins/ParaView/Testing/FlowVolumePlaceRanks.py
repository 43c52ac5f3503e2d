# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fresh Flow Volume starts at the same place on one rank and on two, and draws, whether its input was updated before or not."""
import os
import subprocess
import sys

import numpy as np

from MpiTesting import AWAKE, program

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "FlowVolumePlaceRanksRun.py")
PREFIX = os.path.join(os.environ["NEPHOSCOPE_TEST_OUTPUT"], "flow-volume-place")
# Two ranks that give way to all others in each of many exchanges would be slow beside other programs.
WITHOUT_YIELDING = {name: value for name, value in AWAKE.items() if name != "OMPI_MCA_mpi_yield_when_idle"}
SECONDS = 180  # for what takes ten: a rank that waits for another one for ever is a failure


def places(ranks):
    """{name of the case: centre, radius, normal, number of cells} as rank 0, which the script runs on, has found them."""
    path = f"{PREFIX}-{ranks}.npz"
    try:
        done = subprocess.run([program("MPIEXEC"), "-np", str(ranks), program("PVBATCH"), "--dr", SCRIPT, path], env=WITHOUT_YIELDING,
                              capture_output=True, text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired as late:
        sys.exit(f"FAILED: {ranks} ranks hang\n{late.stdout}\n{late.stderr}")
    if "RANK-DONE" not in done.stdout:
        sys.exit(f"FAILED: {ranks} ranks did not run to their end\n{done.stdout}{done.stderr}")
    return dict(np.load(path))


one = places(1)
failed = []
for name, place in one.items():
    print(f"{name}: centre {place[:3]}, radius {place[3]}, {place[7]:.0f} cells")
    if place[3] == 0 or place[7] < 50:
        failed.append(f"{name}: no smoke on one rank")
for name, place in places(2).items():
    if not np.allclose(place, one[name], rtol=1e-9, atol=1e-9 * np.abs(one[name][:4]).max()):
        failed.append(f"{name}: {place} on two ranks, {one[name]} on one")
if failed:
    sys.exit("FAILED: " + "\n".join(failed))
print("NEPHOSCOPE-PASSED")
