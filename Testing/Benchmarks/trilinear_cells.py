# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The trilinear field of hexahedra against their tetrahedra: frames, and how much the same cells differ as a grid and as unstructured data.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included: the first frame, and the median of a moving camera; each case in a
process of its own. memory_of_cells.py measures memory.
"""
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter

from nephoscope_testing.offscreen import float_image
from nephoscope_testing.weather import cloud_scene, forecast_globe

SIZE, MOVES = 1024, 6
CASES = ("grid, tetrahedra", "grid, trilinear", "hexahedra, tetrahedra", "hexahedra, trilinear", "peer")


def seconds(window):
    start = time.process_time()
    window.Render()
    return time.process_time() - start


def converted(data, case):
    if case.startswith("grid"):
        return data
    chosen = vtkDataSetTriangleFilter() if case == "peer" else vtkAppendFilter()
    chosen.SetInputData(data) if case == "peer" else chosen.AddInputData(data)
    chosen.Update()
    return chosen.GetOutput()


def mapper_for(data, case):
    made = vtkProjectedTetrahedraMapper() if case == "peer" else nephoscope.vtkCellCompositingMapper()
    made.SetInputData(data)
    if case != "peer":
        made.SetMethodToRays()
        made.SetCellInterpolation(int(case.endswith("trilinear")))
    return made


def warm_up(case):
    """What OpenGL and the images need once."""
    small = vtkStructuredGrid()
    small.ShallowCopy(forecast_globe())
    small.Crop([0, 8, 30, 36, 2, 4])
    small.GetPointData().SetActiveScalars("cloud_fraction")
    window = cloud_scene(mapper_for(converted(small, case), case), 2e5, SIZE)[1]
    window.Render()
    window.Finalize()


def measure(case, file):
    warm_up(case)
    globe = forecast_globe()
    globe.GetPointData().SetActiveScalars("cloud_fraction")
    data = converted(globe, case)
    made = mapper_for(data, case)
    renderer, window = cloud_scene(made, 2e5, SIZE)
    first = seconds(window)
    renderer.GetActiveCamera().Elevation(35)
    moving = []
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(7)
        renderer.ResetCameraClippingRange()
        moving.append(seconds(window))
    if case != "peer":
        np.save(file, float_image(made))
    print(f"| {case} | {first:.2f} | {sorted(moving)[MOVES // 2]:.2f} |", flush=True)


def compare(folder, one, other):
    a, b = (np.load(os.path.join(folder, f"{CASES.index(case)}.npy")) for case in (one, other))
    error = np.abs(a - b).max(axis=-1)[(a[..., 3] > 0) | (b[..., 3] > 0)] * 255
    print(f"{one} / {other}: 99 % of the pixels within {np.percentile(error, 99):.2f}/255, largest difference {error.max():.1f}/255, "
          f"{int((error > 1).sum())} of {error.size} pixels beyond 1/255", flush=True)


def main():
    if len(sys.argv) > 2:
        measure(CASES[int(sys.argv[1])], sys.argv[2])
        return
    print(f"| GFS globe, {SIZE} x {SIZE} | first s | moving s |\n|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for number in range(len(CASES)):
            subprocess.run([sys.executable, __file__, str(number), os.path.join(folder, f"{number}.npy")], check=True)
        compare(folder, "grid, tetrahedra", "hexahedra, tetrahedra")
        compare(folder, "grid, trilinear", "hexahedra, trilinear")


main()
