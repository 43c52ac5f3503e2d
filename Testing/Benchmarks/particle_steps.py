# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""RK4 steps a second through grids of every kind, beside vtkStreamTracer's in the same run.

    ./nephoscope bench

The seeds fill a box (on the globe: an area of 20 by 20 degrees), the step is about a tenth of a cell. A step is four
samples of the velocity. vtkStreamTracer runs RK4 with the same mean step length, without vorticity; its steps are the
points of its lines. "1 thread" counts processor time, "2 threads" elapsed time; the ratio is that of one thread to one.
"""
import time

import numpy as np
from nephoscope_testing.fields import Field, Particles
from nephoscope_testing.weather import forecast_globe
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (vtkDataObject, vtkImageData, vtkPolyData, vtkRectilinearGrid,
                                           vtkStructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

SIZE = 65  # points along each axis of the boxes
SEEDS, STEPS = 10000, 40
TRACER_SEEDS = 250
REPEATS = 3


def swirl(points):
    x, y, z = points.T
    return np.stack([-y, x, 0.3 * np.cos(3 * x)], axis=1).astype(np.float32)


def with_velocity(data):
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    array = numpy_to_vtk(swirl(points), deep=True)
    array.SetName("velocity")
    data.GetPointData().AddArray(array)
    return data


def image():
    data = vtkImageData()
    data.SetDimensions(SIZE, SIZE, SIZE)
    data.SetOrigin(-1, -1, -1)
    data.SetSpacing(*3 * (2 / (SIZE - 1),))
    return with_velocity(data)


def rectilinear():
    data = vtkRectilinearGrid()
    data.SetDimensions(SIZE, SIZE, SIZE)
    t = np.linspace(-1, 1, SIZE)
    for put in (data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates):
        put(numpy_to_vtk(t + 0.1 * (t ** 3 - t), deep=True))
    return with_velocity(data)


def curvilinear():
    t = np.linspace(-1, 1, SIZE)
    z, y, x = np.meshgrid(t, t, t, indexing="ij")
    bend = 0.05 * np.sin(3 * (x + y + z)) * (1 - x * x) * (1 - y * y) * (1 - z * z)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x + bend, y - bend, z + bend], axis=-1).reshape(-1, 3), deep=True))
    data = vtkStructuredGrid()
    data.SetDimensions(SIZE, SIZE, SIZE)
    data.SetPoints(points)
    return with_velocity(data)


def converted(algorithm, data):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def box_seeds(count):
    return np.random.default_rng(1).uniform(-0.4, 0.4, (count, 3))


def globe_seeds(count):
    rng = np.random.default_rng(1)
    longitude, latitude = np.radians(rng.uniform(130, 150, count)), np.radians(rng.uniform(20, 40, count))
    radius = 6371000 + 45 * rng.uniform(5000, 8000, count)
    return radius[:, None] * np.stack(
        [np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], axis=1)


def our_rate(field, seeds, step, threads):
    """Steps a second, the best of some runs: processor time for one thread, elapsed time for more."""
    clock = time.process_time if threads == 1 else time.perf_counter
    best = 0
    for _ in range(REPEATS):
        particles = Particles(seeds)
        field.sample(particles)
        start = clock()
        field.advance(particles, step, STEPS, threads=threads)
        best = max(best, len(seeds) * STEPS / (clock() - start))
    return best


def tracer_rate(data, name, seeds, step):
    speed = np.linalg.norm(Field(data, name).sample(seeds), axis=1).mean()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(seeds), deep=True))
    source = vtkPolyData()
    source.SetPoints(points)
    tracer = vtkStreamTracer()
    tracer.SetInputData(data)
    tracer.SetSourceData(source)
    tracer.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetIntegrationDirectionToForward()
    tracer.SetComputeVorticity(False)
    tracer.SetIntegrationStepUnit(vtkStreamTracer.LENGTH_UNIT)
    tracer.SetInitialIntegrationStep(speed * step)
    tracer.SetMaximumPropagation(speed * step * STEPS)
    tracer.SetMaximumNumberOfSteps(10 * STEPS)
    best = 0
    for _ in range(REPEATS):
        tracer.Modified()
        start = time.process_time()
        tracer.Update()
        lines = tracer.GetOutput()
        best = max(best, (lines.GetNumberOfPoints() - lines.GetNumberOfLines()) / (time.process_time() - start))
    return best


def without_other_arrays(data):
    """vtkStreamTracer interpolates every array along its lines; ours would not, so neither has any."""
    copy = data.NewInstance()
    copy.CopyStructure(data)
    copy.GetPointData().AddArray(data.GetPointData().GetArray("DisplayVelocity"))
    return copy


def main():
    globe = without_other_arrays(forecast_globe())
    bent = curvilinear()
    box_step, globe_step = 0.1 * 2 / (SIZE - 1) / 0.35, 1000.0
    rows = [("image", image(), "velocity", box_seeds, box_step),
            ("rectilinear", rectilinear(), "velocity", box_seeds, box_step),
            ("curvilinear", bent, "velocity", box_seeds, box_step),
            ("forecast on the globe", globe, "DisplayVelocity", globe_seeds, globe_step),
            ("hexahedra", converted(vtkAppendFilter(), bent), "velocity", box_seeds, box_step),
            ("tetrahedra", converted(vtkDataSetTriangleFilter(), bent), "velocity", box_seeds, box_step)]
    print(f"Millions of RK4 steps a second, {SEEDS} particles, {STEPS} steps")
    print(f"| {'grid':21} | {'1 thread':>8} | {'2 threads':>9} | {'vtkStreamTracer':>15} | {'ratio':>5} |")
    print("|---|---|---|---|---|")
    for label, data, name, seeds, step in rows:
        field = Field(data, name)
        ours = [our_rate(field, seeds(SEEDS), step, threads) / 1e6 for threads in (1, 2)]
        theirs = tracer_rate(data, name, seeds(TRACER_SEEDS), step) / 1e6
        print(f"| {label:21} | {ours[0]:8.2f} | {ours[1]:9.2f} | {theirs:15.4f} | {ours[0] / theirs:5.0f} |", flush=True)


if __name__ == "__main__":
    main()
