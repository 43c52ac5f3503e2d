# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests that start several ranks share."""
import os
import signal
import subprocess
import sys

import numpy as np


def joined(*paths):
    return ":".join(filter(None, paths))


# More ranks than cores, which sleep while they wait, and the superuser of a container, are allowed; by Open MPI 4 and 5.
ENVIRONMENT = dict(os.environ, OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
                   PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",
                   OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   PRTE_ALLOW_RUN_AS_ROOT="1", PRTE_ALLOW_RUN_AS_ROOT_CONFIRM="1", PYTHONFAULTHANDLER="1",
                   LD_PRELOAD=joined(os.environ.get("LD_PRELOAD"), "libnephoscope_sleeping_yield.so"),
                   LD_LIBRARY_PATH=joined(os.path.join(os.environ["NEPHOSCOPE_TEST_LIBRARIES"], "preload"), os.environ.get("LD_LIBRARY_PATH")))
# For tests that run alone, whose ranks exchange something so often that sleep would be most of their time.
AWAKE = {**ENVIRONMENT, "LD_PRELOAD": os.environ.get("LD_PRELOAD", "")}


def program(name):
    """The path of PVBATCH, MPIEXEC and so on, as CMake has found it; the test is skipped without it."""
    path = os.environ.get(f"NEPHOSCOPE_{name}", "")
    if not path or path.endswith("NOTFOUND"):
        print(f"skipped: no {name.lower()}")
        sys.exit(125)
    return path


def output_of(command, limit=150):
    """What a command has printed. One that takes more than `limit` s is ended, and shows where it was."""
    running = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        return running.communicate(timeout=limit)[0]
    except subprocess.TimeoutExpired:
        running.send_signal(signal.SIGABRT)  # Python prints its stack
        try:
            output = running.communicate(timeout=10)[0]
        finally:
            running.kill()
        sys.exit(f"{' '.join(command)}: not done after {limit} s\n{output}")


def arrays_of_ranks(script, name, ranks):
    """[what each rank has saved with `numpy.savez(f"{prefix}-{rank}.npz")`]. The script, of this folder, gets the prefix, and prints RANK-DONE on each."""
    prefix = os.path.join(os.environ["NEPHOSCOPE_TEST_OUTPUT"], f"{name}-{ranks}")
    launcher = [program("MPIEXEC"), "-np", str(ranks)] if ranks > 1 else []
    command = launcher + [program("PVBATCH"), "--dr", "--sym", os.path.join(os.path.dirname(os.path.abspath(__file__)), script), prefix]
    output = output_of(command)
    if output.count("RANK-DONE") != ranks:
        sys.exit(f"{prefix}: did not run to its end\n{output}")
    return [np.load(f"{prefix}-{rank}.npz") for rank in range(ranks)]
