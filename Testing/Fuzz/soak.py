# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""soak.py [--rounds N] [CLASS...]: the same cases again and again; memory must not grow. Exits with 1 if that of a class does."""
import argparse
import fnmatch
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import subjects  # noqa: E402
import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401
from vtkmodules.vtkCommonCore import vtkObject, vtkOutputWindow  # noqa: E402

CASES = 8
MOST = 20  # kB in a round: less than the results of a case


def resident():
    """kB of memory that the process has to itself."""
    return sum(int(line.split()[1]) for line in open("/proc/self/smaps_rollup") if line.startswith("Private_Dirty"))


def growth(name, rounds):
    """kB in a round: of the second half, since caches fill up in the first."""
    used = []
    for _ in range(rounds):
        for seed in range(CASES):
            try:
                subjects.run(name, seed, [])
            except subjects.Finding:
                pass  # the fuzzer's
        used.append(resident())
    half = used[rounds // 2:]
    return (half[-1] - half[0]) / (len(half) - 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("classes", nargs="*", default=["*"], metavar="CLASS", help="names or patterns (default: all)")
    parser.add_argument("--rounds", type=int, default=60, help="how often each class runs its %d cases (default: 60)" % CASES)
    options = parser.parse_args()
    vtkOutputWindow.GetInstance().SetDisplayModeToNever()
    vtkObject.GlobalWarningDisplayOff()
    leaking = 0
    for name in subjects.NAMES:
        if any(fnmatch.fnmatch(name, pattern) for pattern in options.classes):
            grown = growth(name, max(options.rounds, 4))
            leaking += grown > MOST
            print(f"{name}: {grown:.1f} kB in a round{', too much' if grown > MOST else ''}", flush=True)
    return 1 if leaking else 0


if __name__ == "__main__":
    sys.exit(main())
