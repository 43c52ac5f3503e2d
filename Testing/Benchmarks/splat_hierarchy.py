# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quality of the hierarchy of splats against the number of splats: clouds of the forecast on the globe, a smooth cloud of 128^3 samples, and a
cube of 32^3 equal ones, in pictures of 512 x 512 and 1024 x 1024 pixels; and the processor time of frames while the camera turns.

    ./nephoscope bench
    ./nephoscope python Testing/Benchmarks/splat_hierarchy.py --plot file.png

PSNR is that of the float picture, colour over black, against the one of every sample; the whole picture counts, and apart from that the pixels
where there is cloud. Only samples that can be seen, of non-zero opacity, count as splats. The plot needs matplotlib.
"""
import sys
import time

import numpy as np

import nephoscope
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from nephoscope_testing.weather import cloud_volume, forecast_globe

SIZES = (512, 1024)
MEASURES = {"Picture": (0.1, 0.3, 1, 3), "RootMeanSquare": (0.01, 0.03, 0.1), "Greatest": (0.03, 0.1, 0.3)}
TARGET = 40.0


def smooth_cloud(points):
    x, y, z = (2 * points - 1).T
    radius = np.sqrt(x * x + y * y + z * z)
    return np.clip(1.3 - 2 * radius + 0.35 * np.sin(5 * x + 1) * np.cos(6 * y) * np.sin(4 * z + 0.5), 0, 1)


def synthetic():
    data = meshes.with_field(meshes.image((127,) * 3, (1 / 127,) * 3), smooth_cloud)
    transfer = Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (0.05, 0), (1, 12)])
    return data, "s", transfer.volume_property()


def equal():
    data = meshes.with_field(meshes.image((31,) * 3, (1 / 31,) * 3), lambda p: 0.5 + 0 * p[:, 0])
    return data, "s", Transfer([(0, 0.6, 0.7, 1), (1, 1, 1, 1)], [(0, 0), (1, 12)]).volume_property()


def forecast():
    mapper = nephoscope.vtkTexturedSplatMapper()
    return forecast_globe(), "cloud_fraction", cloud_volume(mapper, 3e5).GetProperty()


def decibels(difference):
    return -10 * np.log10(max(np.mean(difference**2), 1e-20))


class Quality:
    """One data set in pictures of one size: fraction of the splats that a tolerance draws, PSNR of picture and of cloud."""

    def __init__(self, label, size, data, array, properties):
        self.label, self.size = label, size
        self.window = Window((size, size))
        scene = self.window.add_scene()
        self.mapper = nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(self.mapper, data, properties, array)
        scene.look_at(data)
        self.exact = self.draw()
        self.cloudy = self.exact.max(axis=2) > 0.01
        self.leaves = self.mapper.GetNumberOfDrawnSplats()

    def draw(self):
        self.window.render()
        return float_image(self.mapper)[..., :3]

    def measure(self, name, tolerance):
        getattr(self.mapper, "SetErrorMeasureTo" + name)()
        self.mapper.SetErrorTolerance(tolerance)
        difference = self.draw() - self.exact
        return self.leaves / self.mapper.GetNumberOfDrawnSplats(), decibels(difference), decibels(difference[self.cloudy])

    def report(self, name, tolerance):
        share, picture, cloud = self.measure(name, tolerance)
        print(f"| {self.label} | {self.size} | {name} | {tolerance:.3g} | 1/{share:.1f} | {picture:.1f} | {cloud:.1f} |", flush=True)
        return share, picture

    def report_target(self, name, channel):
        """The largest tolerance with so many decibels, of the picture (1) or of the cloud (2)."""
        low, high = 1e-3, 100.0
        for _ in range(12):
            middle = np.sqrt(low * high)
            low, high = (middle, high) if self.measure(name, middle)[channel] >= TARGET else (low, middle)
        self.report(name, low)

    def report_time(self, tolerance):
        self.mapper.SetErrorMeasureToPicture()
        self.mapper.SetErrorTolerance(tolerance)
        self.window.render()
        seconds = []
        for _ in range(3):
            self.window.window.GetRenderers().GetFirstRenderer().GetActiveCamera().Azimuth(1)
            start = time.process_time()
            self.window.render()
            seconds.append(time.process_time() - start)
        print(f"{self.label}, {self.size} pixels, tolerance {tolerance}: {min(seconds):.2f} s of processor time a frame", flush=True)


def plot(path, curves):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4), dpi=120)
    for (label, measure), line in curves.items():
        axes.semilogx(*zip(*[(1 / share, value) for share, value in line]),
                      {"Picture": "o-", "RootMeanSquare": "s--", "Greatest": "^:"}[measure], label=f"{label}, {measure}")
    axes.axhline(TARGET, color="0.7")
    axes.axvline(0.2, color="0.7")
    axes.set(xlabel="splats drawn, of all", ylabel="PSNR in dB")
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path)


def main():
    print("| data | pixels | error measure | tolerance | share | PSNR, dB | where there is cloud |\n|---|---|---|---|---|---|---|")
    curves = {}
    for label, make in (("smooth cloud", synthetic), ("equal samples", equal), ("forecast", forecast)):
        for size in SIZES:
            quality = Quality(label, size, *make())
            for channel in (1, 2):
                quality.report_target("Picture", channel)
        if make is equal:
            continue
        for measure, tolerances in MEASURES.items():
            curves[label, measure] = [quality.report(measure, tolerance) for tolerance in tolerances]
        for tolerance in (0, 0.3, 3):
            quality.report_time(tolerance)
    if sys.argv[1:2] == ["--plot"]:
        plot(sys.argv[2], curves)


if __name__ == "__main__":
    main()
