# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks together read no more of a .vdb file than one does, as points and as an image."""
import os
import subprocess
import sys

import nephoscope
from MpiTesting import ENVIRONMENT, program

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "SparseVolume.py")
FILE = os.path.join(os.environ["NEPHOSCOPE_TEST_OUTPUT"], "SparseVolumeRanks.vdb")


def run(ranks):
    command = [program("PVBATCH"), "--dr", SCRIPT, FILE]
    done = subprocess.run(command if ranks == 1 else [program("MPIEXEC"), "-np", str(ranks), *command], env=ENVIRONMENT,
                          capture_output=True, text=True, timeout=80)
    if "NEPHOSCOPE-PASSED" not in done.stdout:
        sys.exit(f"{ranks} ranks: did not run to the end\n{done.stdout}{done.stderr}")
    return [line for line in done.stdout.splitlines() if line.startswith("COUNT")]


if not nephoscope.vtkSparseVolumeReader.HasOpenVDB():
    sys.exit(print("skipped: this build has no OpenVDB") or 125)
if os.path.exists(FILE):
    os.remove(FILE)
run(1)  # writes it
one, two = run(1), run(2)
print("one rank:", *one, "two ranks:", *two)
if one != two or len(one) != 2:
    sys.exit("they differ")
print("NEPHOSCOPE-PASSED")
