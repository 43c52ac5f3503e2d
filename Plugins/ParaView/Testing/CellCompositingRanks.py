# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One process, two ranks, and a server with its client draw the same pictures."""
import os
import subprocess
import sys

import numpy as np

from MpiTesting import ENVIRONMENT, program

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["NEPHOSCOPE_TEST_OUTPUT"]
SCRIPT = os.path.join(HERE, "CellCompositingRun.py")
PICTURES = ("image", "tetrahedra", "structured", "cells", "coarse", "coarse-cells")
PEELED = ("surfaces", "surfaces-tetrahedra")  # every rank peels on its own, and rounds to 8 bits at every peel


def run(command, name):
    """Runs the script and returns its pictures."""
    prefix = os.path.join(OUTPUT, f"ranks-{name}")
    done = subprocess.run(command + [SCRIPT, prefix], env=ENVIRONMENT, capture_output=True, text=True, timeout=150)
    return pictures(prefix, done.stdout + done.stderr)


def pictures(prefix, output):
    if "NEPHOSCOPE-PASSED" not in output:
        print(output)
        sys.exit(f"{prefix}: did not run to its end")
    return {name: np.load(f"{prefix}-{name}.npy") for name in PICTURES + PEELED}


def run_with_server():
    """pvserver waits on a free port that it announces; the client draws there."""
    server = subprocess.Popen([program("PVSERVER"), "--server-port=0"], env=ENVIRONMENT, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        port = None
        for line in server.stdout:
            if "Accepting connection" in line:
                port = line.rsplit(":", 1)[1].strip()
                break
        if port is None:
            sys.exit("pvserver did not start")
        prefix = os.path.join(OUTPUT, "ranks-server")
        done = subprocess.run([program("PVPYTHON"), "--dr", SCRIPT, prefix, port], env=ENVIRONMENT, capture_output=True,
                              text=True, timeout=150)
        return pictures(prefix, done.stdout + done.stderr)
    finally:
        server.terminate()
        server.wait()


def compare(first, second, title, names, largest, mean):
    for name in names:
        difference = np.abs(first[name] - second[name])
        print(f"{title}, {name}: max {difference.max():.0f}, mean {difference.mean():.4f} of 255")
        if first[name].mean() < 1:
            sys.exit(f"{name}: nothing is drawn")
        if difference.max() > largest or difference.mean() > mean:
            sys.exit(f"{title}, {name}: more than max {largest}, mean {mean}")


one = run([program("PVBATCH"), "--dr"], "one")
two = run([program("MPIEXEC"), "-np", "2", program("PVBATCH"), "--dr"], "two")
# Each rank's picture has 8 bits when the two are composited, and the result is rounded again.
compare(one, two, "one and two ranks", PICTURES, largest=2, mean=0.15)
compare(one, two, "one and two ranks", PEELED, largest=5, mean=0.15)
compare(one, run_with_server(), "local and client-server", PICTURES + PEELED, largest=1, mean=0.01)
print("NEPHOSCOPE-PASSED")
