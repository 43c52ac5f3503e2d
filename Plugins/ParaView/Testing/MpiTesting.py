# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests that start several ranks share."""
import os
import sys

# More ranks than cores, which wait without keeping a core busy, and the superuser of a container, are allowed; by Open MPI 4 and 5.
ENVIRONMENT = dict(os.environ, OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
                   PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe",
                   OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   PRTE_ALLOW_RUN_AS_ROOT="1", PRTE_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def program(name):
    """The path of PVBATCH, MPIEXEC and so on, as CMake has found it; the test is skipped without it."""
    path = os.environ.get(f"NEPHOSCOPE_{name}", "")
    if not path or path.endswith("NOTFOUND"):
        print(f"skipped: no {name.lower()}")
        sys.exit(125)
    return path
