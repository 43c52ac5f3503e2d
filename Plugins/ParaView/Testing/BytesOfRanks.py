# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each rank gathers as many bytes for hexahedra as for an image, whatever their number: points go to the ranks that have them too, not to all."""
import os
import pathlib
import shutil
import sys
import tempfile

from MpiTesting import ENVIRONMENT, program

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "Testing/Benchmarks"))
import ranks  # noqa: E402

program("MPIEXEC"), program("PVBATCH")
if not shutil.which("mpicc"):
    print("skipped: no mpicc")
    sys.exit(125)
os.environ.update(ENVIRONMENT)
with tempfile.TemporaryDirectory() as folder:
    of_ranks = ranks.start(8000, 4, f"{folder}/run", ranks.counter(folder), ("image", "hexahedra"))
for number, used in enumerate(of_ranks):
    image, cells = (used[name]["first"][4] for name in ("image", "hexahedra"))
    print(f"rank {number} gathers {image / 1e3:.0f} kB for the image and {cells / 1e3:.0f} kB for the hexahedra")
    if image == 0 or cells > 1.1 * image:
        sys.exit("a rank gathers what belongs to others")
    moved = used["hexahedra"]["first"][2] - used["hexahedra"]["frame"][2]
    if moved < 0.5 * 8000 * 8 * 8:  # ids of points of half of its cells, which other ranks draw
        sys.exit("the data are not redistributed, or bytes are not counted")
print("NEPHOSCOPE-PASSED")
