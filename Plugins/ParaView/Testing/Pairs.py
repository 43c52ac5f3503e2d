# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of the pictures of PairsRun.py, FIRST-SECOND-PLACE, and how far those of two ranks may be from those of one."""
import itertools

SURFACES, MEDIA = ("terrain", "sheet", "tops"), ("cells", "tetrahedra", "smoke", "splats", "winds")
THINGS = SURFACES + MEDIA
LARGEST, LARGEST_OF_DOTS = 3, 20  # of 255


def names():
    pairs = [f"{a}-{b}-{place}" for a, b in itertools.combinations(THINGS, 2) for place in ("before", "behind", "within")]
    same = [f"{a}-{a}-{place}" for a in THINGS[1:] for place in ("before", "within")]
    return pairs + same + [f"{a}-haze-within" for a in THINGS]


def few():
    """Each thing once or twice."""
    return ("cells-cells-before", "terrain-cells-within", "terrain-splats-behind", "sheet-smoke-within", "tops-winds-before", "sheet-tops-within", "tetrahedra-splats-within",
            "smoke-haze-within")


def dots(name):
    """The share of the pixels that may differ by more. A rank does not know what lies in the regions of others and cuts kernels of splats near the border; and
    single rays that meet the border at an edge of a tetrahedron miss it."""
    *pair, place = name.split("-")
    if place == "within" and {"splats", "winds"} & set(pair):
        return 2e-3
    return 1e-4 if "tetrahedra" in pair else 0
