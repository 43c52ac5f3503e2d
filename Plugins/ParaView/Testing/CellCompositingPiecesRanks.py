# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One process and three ranks draw the same pictures of few cells, and tell nothing."""
from MpiTesting import program
from RankPictures import HERE, compare, output_of, pictures, prefix_of

SCRIPT = "CellCompositingPiecesRun.py"
NAMES = ("image", "voxels", "structured", "hexahedra", "all-polygons")


def drawn_by(ranks):
    """The pictures of so many ranks, which have no message."""
    launcher = [program("MPIEXEC"), "-np", str(ranks)] if ranks > 1 else []
    prefix = prefix_of(SCRIPT, str(ranks))
    output = output_of(launcher + [program("PVBATCH"), "--dr", f"{HERE}/{SCRIPT}", prefix])
    if "not drawn" in output:
        raise SystemExit(f"{ranks} ranks told what is no fault:\n" + output.replace("-PASSED", ""))
    return pictures(prefix, output, NAMES)


# The picture of each rank has 8 bits when they are composited.
compare(drawn_by(1), drawn_by(3), "one and three ranks", NAMES, largest=3, mean=0.15)
print("NEPHOSCOPE-PASSED")
