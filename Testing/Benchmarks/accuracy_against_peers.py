# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the error of each mapper against per-ray quadrature, on the same random meshes of tetrahedra.

    ./nephoscope bench [scenes]

The scenes are what every mapper claims to draw: tetrahedra, linear point scalars, the whole volume before the camera.
Numbers are in steps of the 8-bit picture (1/255); silhouette pixels are left out. "float" is the mapper's own float image.
"""
import sys

import numpy as np
from nephoscope_testing import meshes, peers, reference
from nephoscope_testing.checks import cells_of, mapper
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.offscreen import float_image
from nephoscope_testing.transfer import Transfer, random_transfer

PEAK = [(0, 0), (0.47, 0), (0.5, 1), (0.53, 0), (1, 0)]


def ramps(points, unit_distance):
    """Random colours and opacities; opacities stay below 1, which the projected-tetrahedra mapper clamps to."""
    def make(rng):
        transfer = random_transfer(rng, points)
        transfer.unit_distance = unit_distance
        return transfer
    return make


KINDS = {
    "two points, thin": ramps(2, 3.0),
    "two points, dense": ramps(2, 0.2),
    "eight points": ramps(8, 0.5),
    "narrow peak": lambda rng: Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], PEAK, unit_distance=0.05),
}
MAPPERS = {"vtkCellCompositingMapper": mapper, "vtkProjectedTetrahedraMapper": peers.projected_tetrahedra,
           "vtkUnstructuredGridVolumeRayCastMapper": peers.ray_cast}


def scene_errors(seed, kind, parallel):
    """{mapper: Difference} of one scene, and the float image's under "float"."""
    rng = np.random.default_rng([seed, parallel])
    data = meshes.delaunay(rng, 60)
    meshes.with_field(data, meshes.linear_field(rng, data))
    transfer, direction = KINDS[kind](rng), rng.normal(size=3)
    look = lambda scene: scene.look_at(data, direction, parallel=parallel)
    cells, result = cells_of(data), {}
    for name, make in MAPPERS.items():
        drawing = make()
        scene = peers.draw(drawing, data, transfer, look)
        view = scene.view()
        if not result:
            expected = reference.render(cells, view, transfer)
            mask = edge_mask(cells.drawn_edges(), view)
            result["float image of vtkCellCompositingMapper"] = Difference(float_image(drawing), expected, mask)
        result[name] = Difference(scene.rgb(), expected[..., :3], mask)
    return result


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    print(f"{count} random Delaunay meshes of 60 points, 96 x 96 pixels, seeds 0 to {count - 1}; errors in 1/255")
    print(f"| {'transfer function':17} | {'projection':11} | {'mapper':40} | {'max':>9} | {'99.5 %':>9} | {'mean':>9} |")
    print("|---|---|---|---|---|---|")
    for kind in KINDS:
        for parallel in (False, True):
            scenes = [scene_errors(seed, kind, parallel) for seed in range(count)]
            for name in scenes[0]:
                worst = [255 * max(getattr(s[name], part) for s in scenes) for part in ("maximum", "percentile")]
                mean = 255 * np.mean([s[name].mean for s in scenes])
                print(f"| {kind:17} | {'parallel' if parallel else 'perspective':11} | {name:40} | "
                      f"{worst[0]:9.4f} | {worst[1]:9.4f} | {mean:9.4f} |", flush=True)


if __name__ == "__main__":
    main()
