# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texture coordinates of a grid of 320 x 160 x 19 points, 24 hours back through hourly winds in steps of an hour.

    ./nephoscope bench

The grid is that of the paper, the rows end before the poles. "paths" is an update whose time steps are in memory, but for one;
its number of steps is 972,800 points times the hours back to the older birth. vtkStreamTracer runs RK4 through one of the fields,
without vorticity, with the same mean length of a step; its steps are the points of its lines. The ratio is that of
processor time to processor time.
"""
import time

import numpy as np
from nephoscope_testing.texture import DAY, RADIUS, Globe, advection
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer

HOUR = 3600.0
TRACER_SEEDS, TRACER_STEPS = 400, 20


def wind(unit, height, when):
    """Up to some 60 m/s, turning and rising."""
    phase = 2 * np.pi * when / (3 * DAY)
    axis = 6e-6 * np.array([np.cos(phase), np.sin(phase), 1.5])
    return np.cross(axis, unit) * (0.4 + height[:, None] / 2e4) * (1 + 0.3 * np.sin(4 * unit[:, :1])), 0.01 * np.sin(3 * unit[:, 1])


def tracer_rate(data):
    rng = np.random.default_rng(1)
    seeds = rng.normal(size=(TRACER_SEEDS, 3))
    seeds *= (RADIUS + 9000) / np.linalg.norm(seeds, axis=1)[:, None]
    points = vtkPoints()
    points.SetData(numpy_to_vtk(seeds[np.abs(seeds[:, 2]) < 0.9 * RADIUS], deep=True))
    source = vtkPolyData()
    source.SetPoints(points)
    copy = vtkStructuredGrid()
    copy.CopyStructure(data)
    copy.GetPointData().AddArray(data.GetPointData().GetArray("DisplayVelocity"))
    tracer = vtkStreamTracer()
    tracer.SetInputData(copy)
    tracer.SetSourceData(source)
    tracer.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "DisplayVelocity")
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetIntegrationDirectionToBackward()
    tracer.SetComputeVorticity(False)
    tracer.SetIntegrationStepUnit(vtkStreamTracer.LENGTH_UNIT)
    step = 30 * HOUR
    tracer.SetInitialIntegrationStep(step)
    tracer.SetMaximumPropagation(step * TRACER_STEPS)
    tracer.SetMaximumNumberOfSteps(10 * TRACER_STEPS)
    start = time.process_time()
    tracer.Update()
    seconds = time.process_time() - start
    lines = tracer.GetOutput()
    return (lines.GetNumberOfPoints() - lines.GetNumberOfLines()) / seconds


def main():
    source = Globe(wind, times=np.arange(0, 49) * HOUR, columns=320, rows=160, levels=np.linspace(0, 18000, 19), poles=False, closed=False)
    made = advection(source)
    made.UpdateTimeStep(35 * HOUR)
    cached = {}
    read = source.grid

    def grid(when):
        start = time.process_time()
        result = read(when)
        cached["seconds"] = time.process_time() - start
        return result
    source.grid = grid
    print("| frame at | steps | elapsed (s) | processor (s) | of it, the wind's source (s) | million steps a processor second |")
    print("|---|---|---|---|---|---|")
    rate = 0
    for hour in (36, 40, 44, 47, 47.75):
        cached["seconds"] = 0.0
        start, processor = time.perf_counter(), time.process_time()
        made.UpdateTimeStep(hour * HOUR)
        elapsed, processor = time.perf_counter() - start, time.process_time() - processor
        own = processor - cached["seconds"]
        rate = max(rate, made.GetNumberOfSteps() / own)
        print(f"| {hour} h | {made.GetNumberOfSteps()} | {elapsed:.2f} | {own:.2f} | {cached['seconds']:.2f} "
              f"| {made.GetNumberOfSteps() / own / 1e6:.2f} |", flush=True)
    theirs = tracer_rate(read(36 * HOUR))
    print(f"\nvtkStreamTracer: {theirs / 1e6:.4f} million steps a processor second; ratio {rate / theirs:.0f}")
    print(f"24 hours of all points: {972800 * 24 / rate:.2f} processor seconds")
    print(f"time steps held: {made.GetNumberOfTimeStepsHeld()}")


if __name__ == "__main__":
    main()
