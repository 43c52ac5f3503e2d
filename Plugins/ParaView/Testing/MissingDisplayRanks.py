# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One of two ranks has no display: ParaView waits for ever, but a message tells why before."""
import os
import subprocess
import sys
import threading

from MpiTesting import ENVIRONMENT, program

SENTENCE = "Rank 1 has no display, but rank 0 has"

if not os.environ.get("DISPLAY"):
    print("skipped: no display")
    sys.exit(125)
script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "MissingDisplayRanksRun.py")
command = [program("PVBATCH"), "--dr", script]
ranks = [program("MPIEXEC"), "-np", "1", *command, ":", "-np", "1", "env", "-u", "DISPLAY", *command]
running = subprocess.Popen(ranks, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
limit = threading.Timer(100, running.terminate)
limit.start()
told = ""
try:
    for line in running.stdout:  # ends when the script does
        told += line
        if SENTENCE in line or "DRAWN" in line:
            break
finally:
    limit.cancel()
    running.terminate()  # mpiexec ends its ranks
    running.communicate(timeout=30)
if SENTENCE not in told:
    sys.exit(f"{SENTENCE!r} was not told:\n{told}")
print("NEPHOSCOPE" + "-PASSED")
