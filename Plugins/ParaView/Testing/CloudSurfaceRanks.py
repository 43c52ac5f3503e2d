# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One process and two ranks smooth and contour alike: the same triangles with the same normals, the same values."""
import os
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["NEPHOSCOPE_TEST_OUTPUT"]
SCRIPT = os.path.join(HERE, "CloudSurfaceRun.py")
ENVIRONMENT = dict(os.environ, OMPI_MCA_rmaps_base_oversubscribe="1", PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",
                   OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   PRTE_ALLOW_RUN_AS_ROOT="1", PRTE_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def program(name):
    path = os.environ.get(f"NEPHOSCOPE_{name}", "")
    if not path or path.endswith("NOTFOUND"):
        print(f"skipped: no {name.lower()}")
        sys.exit(125)
    return path


def run(command, ranks):
    """[(triangles, values of the smoothed field at their places) of each rank]."""
    prefix = os.path.join(OUTPUT, f"cloud-surface-{ranks}")
    done = subprocess.run(command + [SCRIPT, prefix], env=ENVIRONMENT, capture_output=True, text=True, timeout=150)
    if (done.stdout + done.stderr).count("RANK-DONE") != ranks:
        sys.exit(f"{prefix}: did not run to its end\n{done.stdout}{done.stderr}")
    return [np.load(f"{prefix}-{rank}.npz") for rank in range(ranks)]


def rows(parts, name):
    """All rows of all ranks, in one order."""
    found = np.concatenate([part[name] for part in parts])
    return np.unique(found, axis=0) if name == "values" else found[np.lexsort(found.T)]


one = run([program("PVBATCH"), "--dr", "--sym"], 1)
two = run([program("MPIEXEC"), "-np", "2", program("PVBATCH"), "--dr", "--sym"], 2)
for part in two:
    if not 0.2 < len(part["triangles"]) / len(one[0]["triangles"]) < 0.8:
        sys.exit(f"a rank has {len(part['triangles'])} of {len(one[0]['triangles'])} triangles")
for name in ("triangles", "values"):
    if not np.array_equal(rows(one, name), rows(two, name)):
        sys.exit(f"{name} differ between one rank and two")
    print(f"{name}: {len(rows(one, name))} rows, the same on one rank and on two")
print("NEPHOSCOPE-PASSED")
