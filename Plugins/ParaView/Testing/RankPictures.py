# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures that one process, several ranks, and a server with its client draw of the same scenes, and how far they differ."""
import os
import re
import subprocess
import sys
import time

import numpy as np

from MpiTesting import ENVIRONMENT, output_of, program

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["NEPHOSCOPE_TEST_OUTPUT"]


def run(command, script, name, names, arguments=(), limit=300):
    """Runs a script of this folder, which saves pictures under the prefix that it is given, and returns those of the names."""
    prefix = prefix_of(script, name)
    return pictures(prefix, output_of(command + [os.path.join(HERE, script), prefix, *arguments], limit), names)


def prefix_of(script, name):
    return os.path.join(OUTPUT, f"{script}-{name}")


def pictures(prefix, output, names):
    if "NEPHOSCOPE-PASSED" not in output:
        print(output)
        sys.exit(f"{prefix}: did not run to its end")
    return {name: np.load(f"{prefix}-{name}.npy") for name in names}


def run_with_server(script, names, ranks=1, arguments=()):
    """Draws only the pictures of these names, on a pvserver with this number of ranks. The server waits on a free port that it announces; the client draws there, or, if an argument says so, itself."""
    log = os.path.join(OUTPUT, f"{script}-server.log")
    with open(log, "w") as file:
        server = subprocess.Popen(launcher(ranks) + [program("PVSERVER"), "--server-port=0"], env=ENVIRONMENT, stdout=file, stderr=subprocess.STDOUT)
    try:
        prefix = prefix_of(script, "server")
        command = [program("PVPYTHON"), "--dr", os.path.join(HERE, script), prefix, announced_port(log), ",".join(names), *arguments]
        return pictures(prefix, output_of(command, limit=300), names)
    finally:
        server.terminate()  # mpiexec takes its ranks with it
        server.wait()
        print(open(log).read())


def announced_port(log, limit=60):
    end = time.monotonic() + limit
    while time.monotonic() < end:
        found = re.search(r"Accepting connection.*:(\d+)\n", open(log).read())
        if found:
            return found[1]
        time.sleep(0.1)
    sys.exit(f"pvserver did not start within {limit} s")


def compare(first, second, title, names, largest, mean, dots=0.0):
    """dots: share of the pixels that may differ by more than `largest`."""
    for name in names:
        difference = np.abs(first[name] - second[name])
        print(f"{title}, {name}: max {difference.max():.0f}, mean {difference.mean():.4f} of 255")
        if first[name].mean() < 1:
            sys.exit(f"{name}: nothing is drawn")
        more = (difference.max(axis=-1) > largest).mean()
        if more > dots or difference.mean() > mean:
            sys.exit(f"{title}, {name}: more than max {largest}, in {more:.3%} of the pixels, mean {mean}")


def run_ranks(script, names, number, limit=300):
    """The pictures that so many processes draw, in at most `limit` s."""
    return run(launcher(number) + [program("PVBATCH"), "--dr"], script, str(number), names, limit=limit)


def launcher(number):
    return [program("MPIEXEC"), "-np", str(number)] if number > 1 else []
