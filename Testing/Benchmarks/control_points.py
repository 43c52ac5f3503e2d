# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the error with and without cutting segments at control points, against per-ray quadrature, and how it falls with the
size of the cells.

    ./nephoscope python Testing/Benchmarks/control_points.py [scenes]

Errors are those of the float image, in steps of an 8-bit channel (1/255); pixels within 1/100 of an edge of the mesh are left out.
"""
import sys

import numpy as np
from nephoscope_testing import contours, hard_functions, meshes
from nephoscope_testing.checks import cells_of, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.offscreen import Window, float_image


def picture(data, case, split, look, size=96):
    window = Window((size, size))
    scene = window.add_scene()
    ours = mapper()
    volume = scene.add_volume(ours, data, case.prop)
    scene.look_at(volume, **look)
    ours.SetSplitAtControlPoints(split)
    window.render()
    return float_image(ours), scene.view(), window.messages.all


def random_mesh(rng, case, count=60):
    """A linear field from case.low to case.high."""
    data = meshes.delaunay(rng, count)
    field = meshes.linear_field(rng, data)
    return meshes.with_field(data, lambda p: case.low + (case.high - case.low) * field(p))


class Unit(contours.Jumps):
    """A function of the scalar counted from 0 to 1, so that the reference loses no digits to large scalars."""

    def __init__(self, case):
        f = case.pieces
        to_unit = lambda rows: np.column_stack([(rows[:, 0] - case.low) / (case.high - case.low), rows[:, 1:]])
        super().__init__(to_unit(f.colors), to_unit(f.opacities), f.unit_distance, f.opacity_scale)
        self.cuts = (f.breakpoints - case.low) / (case.high - case.low)

    @property
    def breakpoints(self):
        return self.cuts


def errors(case, seed):
    """Differences with cuts and without."""
    rng = np.random.default_rng(seed)
    data = random_mesh(rng, case)
    look = dict(direction=rng.normal(size=3), parallel=bool(seed % 2))
    result = []
    for split in (True, False):
        image, view, said = picture(data, case, split, look)
        if said:
            raise SystemExit(f"{case.name}: {said[0]}")
        if split:
            unit = data.NewInstance()
            unit.DeepCopy(data)
            values = (np.array(meshes.vtk_to_numpy(data.GetPointData().GetArray("s"))) - case.low) / (case.high - case.low)
            unit.GetPointData().RemoveArray("s")
            meshes.add_array(unit.GetPointData(), values)
            cells = cells_of(unit)
            expected, mask = contours.render(cells, view, Unit(case)), edge_mask(cells.drawn_edges(), view)
        result.append(Difference(image, expected, mask))
    return result


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


def main():
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
