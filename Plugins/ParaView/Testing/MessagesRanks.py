# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks tell each sentence once; one that only the second rank has to tell names it."""
import os
import re
import subprocess
import sys

from MpiTesting import ENVIRONMENT, program

ONCE = ("There is no array of cloud water", "The input has no velocity", "It must be a grid with rows", "the input has 20 points but no polygons",
        "Cell Compositing needs 3-D cells", "No point or cell array named 'nope'", "array 'nan' or a coordinate", "array 'hole' or a coordinate",
        "Rank [01]: Nothing is drawn: [0-9]+ samples are left out because array 'nan'", "Rank [01]: Nothing is drawn: [0-9]+ cells are left out because array 'hole'",
        "'hole' or a coordinate is not finite at their points. Blank such points",
        "Opacity Scale is -3", "Block 'without' is not drawn",
        "Rank 1: [0-9]+ values of 'Extinction' negative")

script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "MessagesRanksRun.py")
for option in ([], ["--sym"]):
    done = subprocess.run([program("MPIEXEC"), "-np", "2", program("PVBATCH"), "--dr", *option, script], env=ENVIRONMENT, capture_output=True, text=True,
                          timeout=150)
    told = done.stdout + done.stderr
    if "RANK-DONE" not in told:
        sys.exit(f"{option}: did not run to its end\n{told}")
    for sentence in ONCE:
        count = len(re.findall(sentence, told))
        if count != 1:
            sys.exit(f"{option}: {sentence!r} was told {count} times\n{told}")
print("NEPHOSCOPE" + "-PASSED")
