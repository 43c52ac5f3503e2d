# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the error with and without cutting segments at control points, against per-ray quadrature, and how it falls with the
size of the cells.

    ./nephoscope bench [scenes]

Errors are those of the float image, in steps of an 8-bit channel (1/255); pixels within 1/100 of an edge of the mesh are left out.
"""
import sys

import numpy as np
from nephoscope_testing import hard_functions, meshes
from nephoscope_testing.checks import cells_of
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.control_points import errors, picture, random_mesh


def refinement():
    """One function with many points over a cube in ever more cells: how far off without cuts."""
    case = hard_functions.many_points(np.random.default_rng(52), 9)
    look, rows = dict(direction=(0.3, 0.2, 1), parallel=True), []
    for blocks in (1, 2, 4, 8, 16, 32):
        data = meshes.with_field(meshes.image((blocks,) * 3, (1 / blocks,) * 3), lambda p: p @ [0.2, 0.3, 0.5])
        images = [picture(data, case, split, look, 64) for split in (True, False)]
        if blocks == 1:
            exact = images[0][0]  # the same for all of them, and held to the reference in the other table
            mask = edge_mask(cells_of(data).boundary_edges(), images[0][1], 1.5)
        rows.append([blocks] + [255 * part for i in images for part in (Difference(i[0], exact, mask).maximum, Difference(i[0], exact, mask).mean)])
    return rows


def write_comparison(path):
    """Ten thin layers in random tetrahedra, cut and not cut, side by side."""
    from nephoscope_testing.pictures import write_png
    case = hard_functions.comb(0.02, 10)
    case.prop.SetScalarOpacityUnitDistance(0.25 * case.prop.GetScalarOpacityUnitDistance())
    data = random_mesh(np.random.default_rng(53), case, 60)
    images = [picture(data, case, split, {}, 400)[0] for split in (True, False)]
    write_png(path, np.hstack([np.clip(i[60:-60, 40:-40, :3], 0, 1) for i in images]))


def main():
    if sys.argv[1:2] == ["--picture"]:
        return write_comparison(sys.argv[2])
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 4
    chosen = sys.argv[2] if len(sys.argv) > 2 else ""
    print(f"{count} random Delaunay meshes of 60 points, 96 x 96 pixels, seeds 0 to {count - 1}; largest error in 1/255\n")
    print("| transfer function | cut at control points | not cut |\n|---|---|---|")
    for case in hard_functions.cases():
        if chosen in case.name:
            pairs = [errors(case, seed) for seed in range(count)]
            print(f"| {case.name} | {255 * max(p[0].maximum for p in pairs):.3f} | {255 * max(p[1].maximum for p in pairs):.1f} |", flush=True)
    if chosen:
        return
    print("\nNine points over a cube of n x n x n cells, 64 x 64 pixels; difference to one cell cut at the points, in 1/255\n")
    print("| n | cut: largest | mean | not cut: largest | mean |\n|---|---|---|---|---|")
    for blocks, *values in refinement():
        print(f"| {blocks} | " + " | ".join(f"{v:.3f}" for v in values) + " |", flush=True)


if __name__ == "__main__":
    main()
