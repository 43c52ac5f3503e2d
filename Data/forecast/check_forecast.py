#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Print how a series of make_forecast.py keeps what it should keep.

    check_forecast.py SERIES.nc

For some hours: kinetic energy at three levels, the area with more than 15 % cloud and the mean cloud of each level (its largest change) against
those of the first hour, and extreme values. Fails where a value is not finite or a cloud fraction leaves 0 to 1. Needs numpy and VTK.
"""
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

SHOWN = (850, 500, 250)  # hPa


class Series:
    def __init__(self, file):
        self.reader = vtkNetCDFCFReader()
        self.reader.SetFileName(file)
        self.reader.SphericalCoordinatesOff()
        self.reader.UpdateMetaData()
        self.reader.SetDimensions("(lev, lat, lon)")
        self.reader.Update()
        grid = self.reader.GetOutput()
        self.times = self.reader.GetOutputInformation(0).Get(Pipeline.TIME_STEPS())
        self.shape = grid.GetDimensions()[::-1]
        self.levels = np.abs(vtk_to_numpy(grid.GetZCoordinates()))
        self.weights = np.cos(np.radians(vtk_to_numpy(grid.GetYCoordinates())))
        self.weights /= self.weights.sum()

    def field(self, time, name):
        self.reader.UpdateTimeStep(time)
        values = np.array(vtk_to_numpy(self.reader.GetOutput().GetPointData().GetArray(name)), dtype=float).reshape(self.shape)
        if not np.isfinite(values).all():
            raise SystemExit("%s is not finite everywhere at time %g" % (name, time))
        return values

    def mean(self, values):
        """The mean of each level over the sphere."""
        return (values.mean(axis=2) * self.weights).sum(axis=1)

    def look(self, time):
        u, v, clouds = (self.field(time, name) for name in ("u", "v", "cloud_fraction"))
        if clouds.min() < 0 or clouds.max() > 1:
            raise SystemExit("the cloud fraction is not within 0 to 1 at time %g" % time)
        return {"energy": self.mean(u * u + v * v) / 2, "area": self.mean((clouds > 0.15).astype(float)), "cloud": self.mean(clouds),
                "fastest": np.hypot(u, v).max()}


def main(file):
    series = Series(file)
    print("%d x %d x %d, %d times" % (*series.shape[::-1], len(series.times)))
    shown = [int(np.argmin(np.abs(series.levels - level))) for level in SHOWN]
    first = series.look(series.times[0])
    for hour in sorted({len(series.times) - 1, *(h for h in (1, 6, 24) if h < len(series.times))}):
        now = series.look(series.times[hour])
        energy = ["%+.1f" % (100 * x) for x in (now["energy"] / first["energy"] - 1)[shown]]
        print("hour %d: energy at %s hPa %s %%; area with cloud within %.1e, mean cloud within %.1e; fastest wind %.0f m/s" % (
            hour, ", ".join("%.0f" % series.levels[k] for k in shown), ", ".join(energy),
            np.abs(now["area"] - first["area"]).max(), np.abs(now["cloud"] - first["cloud"]).max(), now["fastest"]))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    main(sys.argv[1])
