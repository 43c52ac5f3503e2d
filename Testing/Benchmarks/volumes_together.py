# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames of cells and splats that overlap in space, which are drawn in slices of depth, against the sum of those of each alone.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included: the median of frames after a move of the camera. The sixth column
is the ratio while the window asks for 15 frames a second.
"""
import sys
import time

import numpy as np

import nephoscope
import pyvista

SIZE = int(sys.argv[1]) if len(sys.argv) > 1 else 512
MOVES = 3


def globe():
    data = nephoscope.read_cf(nephoscope.sample_data("gfs_2p5deg_2011101100.nc"))
    return data.nephoscope.globe(vertical_exaggeration=10)


def block(center, side, cells=40):
    data = pyvista.ImageData(dimensions=(cells + 1,) * 3, spacing=(side / cells,) * 3, origin=np.subtract(center, side / 2))
    data["density"] = 0.5 + 0.5 * np.sin(7 * data.points[:, 0] / side) * np.cos(9 * data.points[:, 1] / side)
    return data


def frame(draws, rate=0.0):
    plotter = pyvista.Plotter(off_screen=True, window_size=(SIZE, SIZE))
    for draw in draws:
        draw(plotter)
    plotter.show(auto_close=False, interactive=False)
    plotter.render_window.SetDesiredUpdateRate(rate)
    seconds = []
    for _ in range(MOVES):
        plotter.camera.Azimuth(3)
        plotter.renderer.ResetCameraClippingRange()
        start = time.process_time()
        plotter.render_window.Render()
        seconds.append(time.process_time() - start)
    plotter.close()
    return sorted(seconds)[MOVES // 2]


def cells(data):
    return lambda plotter: nephoscope.add_cells(plotter, data, show_scalar_bar=False)


def splats(data, **options):
    return lambda plotter: nephoscope.add_splats(plotter, data, show_scalar_bar=False, **options)


def main():
    clouds = globe()
    large, small, corner = block((0, 0, 0), 1.0), block((0, 0, 0), 0.3), block((0.6, 0.6, 0.6), 0.6)
    scenes = [("block, small block in it", cells(large), splats(small)), ("block, block across its corner", cells(large), splats(corner)),
              ("block, the same block", cells(large), splats(large)), ("globe, the same globe", cells(clouds), splats(clouds)),
              ("globe, its winds", cells(clouds), splats(clouds, opacity=0, vectors="DisplayVelocity"))]
    print(f"{SIZE} x {SIZE}\ncells, splats | cells (s) | splats (s) | together (s) | ratio | moving")
    for name, first, second in scenes:
        one, two, both = frame([first]), frame([second]), frame([first, second])
        moving = frame([first, second], 15) / (frame([first], 15) + frame([second], 15))
        print(f"{name} | {one:.2f} | {two:.2f} | {both:.2f} | {both / (one + two):.2f} | {moving:.2f}", flush=True)


if __name__ == "__main__":
    main()
