# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far the pictures of splats and of cell compositing of one field agree: a smooth one, sampled ever more closely, and the clouds of
the forecast on the globe, which change from sample to sample.

    ./nephoscope python Testing/Benchmarks/splats_against_cells.py

The figures are those of float pictures of 512 x 512 pixels, where either has an opacity above 0.01. The last column is the mean opacity of the splats over
that of the cells.
"""
import numpy as np

import nephoscope
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from nephoscope_testing.weather import cloud_volume, forecast_globe

SIZE = 512


def bump(points):
    x, y, z = (2 * points - 1).T
    return (np.cos(np.pi * x / 2) * np.cos(np.pi * y / 2) * np.cos(np.pi * z / 2))**4 * (1 + 0.5 * np.sin(3 * x + 2 * y - z))


def draw(mapper, data, array, properties):
    window = Window((SIZE, SIZE))
    scene = window.add_scene()
    scene.add_volume(mapper, data, properties, array)
    scene.look_at(data)
    window.render()
    return float_image(mapper)


def compare(label, data, array, properties):
    splats = draw(nephoscope.vtkTexturedSplatMapper(), data, array, properties)
    cells = draw(nephoscope.vtkCellCompositingMapper(), data, array, properties)
    seen = np.maximum(splats[..., 3], cells[..., 3]) > 0.01
    difference = np.abs(splats - cells)[seen]
    print(f"| {label} | {np.sqrt((difference[:, 3]**2).mean()):.4f} | {np.percentile(difference[:, 3], 99):.4f} | "
          f"{np.sqrt((difference[:, :3]**2).mean()):.4f} | {splats[..., 3][seen].mean() / cells[..., 3][seen].mean():.3f} |", flush=True)


def main():
    print("| field | opacity, root mean square | 99 % below | colour, root mean square | opacity, mean |\n|---|---|---|---|---|")
    transfer = Transfer([(0, 1, 0.2, 0.1), (1.5, 0.1, 0.4, 1)], [(0, 0), (1.5, 4.5)])
    for blocks in (8, 16, 32, 64):
        compare(f"smooth, {blocks}³ cells", meshes.with_field(meshes.image((blocks,) * 3, (1 / blocks,) * 3), bump), "s", transfer)
    for unit in (3e6, 3e5):
        volume = cloud_volume(nephoscope.vtkTexturedSplatMapper(), unit)
        compare(f"forecast, full cloud of 1/{unit / 1e3:.0f} km", forecast_globe(), "cloud_fraction", volume.GetProperty())


main()
