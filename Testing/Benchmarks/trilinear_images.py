# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Image data of 100 x 100 x 100 points with the trilinear field of their cells, against their tetrahedra; with one array and with an opacity array.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included: the median of a moving camera.
"""
import time

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer

MOVES, SIZES = 6, (512, 1024)
TRANSFER = Transfer([(0, 0.2, 0.3, 1), (1, 1, 0.9, 0.8)], [(0, 0), (0.4, 0), (1, 1)], unit_distance=0.1)


def image(count=100):
    data = meshes.image((count - 1,) * 3, (1 / (count - 1),) * 3, (-0.5,) * 3)
    x, y, z = meshes.points_of(data).T
    field = 0.5 + 0.25 * np.sin(9 * x + 2 * np.cos(7 * y)) * np.cos(8 * z) + 0.25 * np.cos(11 * y) * np.sin(6 * x + 5 * z)
    meshes.add_array(data.GetPointData(), field.astype(np.float32))
    meshes.add_array(data.GetPointData(), field[::-1].astype(np.float32), "o")
    return data


def frame(data, size, interpolation, opacity):
    window, made = Window((size, size)), mapper()
    scene = window.add_scene()
    getattr(made, "SetCellInterpolationTo" + interpolation)()
    if opacity:
        made.SetOpacityArrayName("o")
    scene.add_volume(made, data, TRANSFER)
    seconds = []
    for move in range(MOVES + 1):
        angle = 0.3 + 0.1 * move
        scene.look((2 * np.cos(angle), 2 * np.sin(angle), 0.9), (0, 0, 0), (0, 0, 1))
        start = time.process_time()
        window.render()
        seconds.append(time.process_time() - start)
    return np.median(seconds[1:])


def main():
    data = image()
    print("| image of 100³ | pixels | tetrahedra | trilinear |\n|---|---|---|---|")
    for opacity in (False, True):
        for size in SIZES:
            times = [frame(data, size, kind, opacity) for kind in ("Tetrahedra", "Trilinear")]
            print(f"| {'opacity array' if opacity else 'one array'} | {size}² | {times[0]:.2f} | {times[1]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
