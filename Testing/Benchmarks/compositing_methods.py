# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error and processor time of every method of vtkCellCompositingMapper, on the same scenes in one run.

    ./nephoscope bench

Errors are those of the float image against quadrature along the ray of each pixel, over the pixels that show anything and all four
channels; pixels whose centre is within 1/100 pixel of an edge of a tetrahedron are left out. Seconds are processor time of the
whole process, software OpenGL included; the ratio to Cells is what to quote.
"""
import time

import numpy as np
from nephoscope_testing import meshes, reference
from nephoscope_testing.checks import cells_of, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from nephoscope_testing.weather import forecast_globe

METHODS = {"Cells": ("Cells", "Exact"), "Rays": ("Rays", "Exact"), "TrianglesLinear": ("TrianglesLinear", "Exact"),
           "TrianglesTable": ("TrianglesTable", "Exact"), "Faces": ("Faces", "Exact"),
           "Faces, Average": ("Faces", "Average")}
COLORS = [(0, 0.1, 0.3, 1.0), (1, 1.0, 0.3, 0.05)]
SCENES = {
    "one medium, thin": constant(1.0, (1, 0.5, 0.2)),
    "one medium, dense": constant(20.0, (1, 0.5, 0.2)),
    "linear, thin": Transfer(COLORS, [(0, 0.1), (1, 2)]),
    "linear, dense": Transfer(COLORS, [(0, 1), (1, 30)]),
    "control points": Transfer([COLORS[0], (0.5, 1, 0.9, 0.8), COLORS[1]], [(0, 0), (0.1, 0), (1, 9)]),
}
SEEDS = range(3)
FRAMES = 4


def cloud(seed, count=160):
    """Random tetrahedra in a ball with a density that is curved from cell to cell."""
    rng = np.random.default_rng(seed)
    data = meshes.delaunay(rng, count)
    places = rng.uniform(-0.6, 0.6, (3, 3))
    density = lambda p: sum(np.exp(-((p - c) ** 2).sum(axis=1) / 0.2) for c in places)
    return meshes.with_field(data, lambda p: density(p) / density(meshes.points_of(data)).max())


def choose(ours, name):
    method, integration = METHODS[name]
    getattr(ours, "SetMethodTo" + method)()
    getattr(ours, "SetIntegrationTo" + integration)()


def scene_errors(data, transfer, parallel):
    """{method: errors at the pixels that count}."""
    window = Window((128, 128))
    scene = window.add_scene()
    ours = mapper()
    scene.look_at(scene.add_volume(ours, data, transfer), parallel=parallel)
    cells, view = cells_of(data), scene.view()
    exact = reference.render(cells, view, transfer)
    counts = (exact[..., 3] > 0) & ~edge_mask(cells.drawn_edges(), view)
    errors = {}
    for name in METHODS:
        choose(ours, name)
        window.render()
        errors[name] = np.abs(float_image(ours) - exact).max(axis=2)[counts]
    return errors


def print_errors():
    print(f"Random meshes of 160 points, 128 x 128 pixels, seeds {SEEDS.start} to {SEEDS.stop - 1}: largest error / root mean square")
    print(f"| {'medium':17} | {'projection':11} | " + " | ".join(f"{m:17}" for m in METHODS) + " |")
    print("|---|---|" + "---|" * len(METHODS))
    for label, transfer in SCENES.items():
        for parallel in (False, True):
            runs = [scene_errors(cloud(seed), transfer, parallel) for seed in SEEDS]
            cells = []
            for name in METHODS:
                errors = np.concatenate([r[name] for r in runs])
                cells.append(f"{errors.max():.1e} / {np.sqrt((errors ** 2).mean()):.1e}")
            print(f"| {label:17} | {'parallel' if parallel else 'perspective':11} | " + " | ".join(f"{c:17}" for c in cells) + " |",
                  flush=True)


def lattice(n):
    """Six tetrahedra in each of n^3 blocks."""
    data = meshes.structured((n, n, n), lambda p: p - 0.5)
    return meshes.with_field(data, lambda p: 0.5 + 0.5 * np.sin(9 * p[:, 0]) * np.cos(8 * p[:, 1]) * np.sin(7 * p[:, 2] + 1))


def seconds(window):
    start = time.process_time()
    window.window.Render()
    return time.process_time() - start


def moving_frame(scene):
    """The upper median of several, after one that builds what is kept."""
    seconds(scene.window)
    times = []
    for _ in range(FRAMES):
        scene.camera.Azimuth(7)
        times.append(seconds(scene.window))
    return sorted(times)[FRAMES // 2]


def print_speed(label, data, transfer, size, array="s"):
    window = Window((size, size))
    scene = window.add_scene()
    ours = mapper()
    scene.look_at(scene.add_volume(ours, data, transfer, array))
    times = {}
    for name in METHODS:
        choose(ours, name)
        times[name] = moving_frame(scene)
    choose(ours, "Cells")
    ours.SetVisibilityOrderToNone()
    times["Cells, without an order"] = moving_frame(scene)
    print(f"{label}: {ours.GetNumberOfTetrahedra()} tetrahedra, {ours.GetNumberOfDrawnTetrahedra()} of them drawn, {size} x {size} "
          "pixels: processor seconds of a moving frame")
    print("| method | s | times Cells |\n|---|---|---|")
    for name, value in times.items():
        print(f"| {name} | {value:.2f} | {value / times['Cells']:.2f} |", flush=True)


if __name__ == "__main__":
    print_errors()
    for blocks in (12, 32):
        print_speed("lattice", lattice(blocks), SCENES["linear, thin"], 512)
    CLOUDS = Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (0.05, 0), (1, 1)], unit_distance=2e5)
    print_speed("forecast globe", forecast_globe(), CLOUDS, 1024, "cloud_fraction")
