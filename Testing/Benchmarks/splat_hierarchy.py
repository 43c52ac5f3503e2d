# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quality of the hierarchy of splats against the number of splats: clouds of the forecast on the globe, and a smooth cloud of 128^3
samples, 1024 x 1024 pixels.

    ./nephoscope bench
    ./nephoscope python Testing/Benchmarks/splat_hierarchy.py --plot file.png

PSNR is that of the float picture, colour over black, against the one of every sample; the whole picture counts, and apart from that the pixels
where there is cloud. The plot needs matplotlib.
"""
import sys

import numpy as np

import nephoscope
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from nephoscope_testing.weather import cloud_volume, forecast_globe

SIZE = 1024
TOLERANCES = (0.01, 0.03, 0.1, 0.2, 0.3)


def smooth_cloud(points):
    x, y, z = (2 * points - 1).T
    radius = np.sqrt(x * x + y * y + z * z)
    return np.clip(1.3 - 2 * radius + 0.35 * np.sin(5 * x + 1) * np.cos(6 * y) * np.sin(4 * z + 0.5), 0, 1)


def synthetic():
    data = meshes.with_field(meshes.image((127,) * 3, (1 / 127,) * 3), smooth_cloud)
    transfer = Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (0.05, 0), (1, 12)])
    return data, "s", transfer.volume_property()


def forecast():
    mapper = nephoscope.vtkTexturedSplatMapper()
    return forecast_globe(), "cloud_fraction", cloud_volume(mapper, 3e5).GetProperty()


def decibels(difference):
    return -10 * np.log10(np.mean(difference**2))


def measure(label, data, array, properties):
    window = Window((SIZE, SIZE))
    scene = window.add_scene()
    mapper = nephoscope.vtkTexturedSplatMapper()
    scene.add_volume(mapper, data, properties, array)
    scene.look_at(data)
    window.render()
    exact, rows = float_image(mapper)[..., :3], []
    leaves, cloudy = mapper.GetNumberOfDrawnSplats(), exact.max(axis=2) > 0.01
    for measure in ("Greatest", "RootMeanSquare"):
        getattr(mapper, "SetErrorMeasureTo" + measure)()
        for tolerance in TOLERANCES:
            mapper.SetErrorTolerance(tolerance)
            window.render()
            difference, drawn = float_image(mapper)[..., :3] - exact, mapper.GetNumberOfDrawnSplats()
            rows.append((measure, leaves / drawn, decibels(difference)))
            print(f"| {label} | {measure} | {tolerance} | {drawn} of {leaves} | 1/{leaves / drawn:.1f} | {rows[-1][2]:.1f} | "
                  f"{decibels(difference[cloudy]):.1f} |", flush=True)
    return rows


def plot(path, results):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4), dpi=120)
    for label, rows in results.items():
        for measure, style in (("Greatest", "o-"), ("RootMeanSquare", "s--")):
            line = [(1 / r[1], r[2]) for r in rows if r[0] == measure]
            axes.semilogx(*zip(*line), style, label=f"{label}, {measure}")
    axes.axhline(40, color="0.7")
    axes.axvline(0.2, color="0.7")
    axes.set(xlabel="splats drawn, of all", ylabel="PSNR in dB")
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path)


def main():
    print("| data | error measure | tolerance | splats | share | PSNR, dB | where there is cloud |\n|---|---|---|---|---|---|---|")
    results = {label: measure(label, *make()) for label, make in (("smooth cloud", synthetic), ("forecast", forecast))}
    if sys.argv[1:2] == ["--plot"]:
        plot(sys.argv[2], results)


if __name__ == "__main__":
    main()
