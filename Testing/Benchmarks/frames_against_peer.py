# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames of the GFS globe against vtkProjectedTetrahedraMapper on the same cells as tetrahedra, in one run.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included, so that other work on the machine counts little; the
ratio is what to quote. The ratio of elapsed times is better where OpenGL uses several processors and the peer's sorting one, but
holds for an idle machine only. The transfer function is zero below a cloud fraction of 0.05.
"""
import time

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper

from nephoscope_testing.weather import cloud_scene, forecast_globe

SIZE = 1024
MOVES = 4


def seconds(window):
    """Processor and elapsed time of a frame."""
    start = time.process_time(), time.perf_counter()
    window.Render()
    return time.process_time() - start[0], time.perf_counter() - start[1]


def frames(mapper):
    """(processor, elapsed) of the first frame, the median moving frame, and a frame that changes nothing."""
    renderer, window = cloud_scene(mapper, 2e5, SIZE)
    first = seconds(window)
    moving = []
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(7)
        renderer.ResetCameraClippingRange()
        moving.append(seconds(window))
    return first, sorted(moving)[MOVES // 2], seconds(window)


def main():
    grid = forecast_globe()
    grid.GetPointData().SetActiveScalars("cloud_fraction")
    results = {}
    for label, method, order in (("rays (default)", "Automatic", "Exact"), ("projection, topological order", "Projection", "Exact"),
                                 ("projection, centroid order", "Projection", "Centroid")):
        mapper = nephoscope.vtkCellCompositingMapper()
        mapper.SetInputData(grid)
        getattr(mapper, "SetMethodTo" + method)()
        getattr(mapper, "SetVisibilityOrderTo" + order)()
        results["vtkCellCompositingMapper, " + label] = frames(mapper)
        print(f"{label}: {mapper.GetNumberOfTetrahedra()} tetrahedra, {mapper.GetNumberOfDrawnTetrahedra()} drawn, "
              f"{mapper.GetNumberOfVisibilityCycles()} cycles in the order", flush=True)
    triangles = vtkDataSetTriangleFilter()
    triangles.SetInputData(grid)
    triangles.Update()
    peer = vtkProjectedTetrahedraMapper()
    peer.SetInputData(triangles.GetOutput())
    print(f"peer: {triangles.GetOutput().GetNumberOfCells()} tetrahedra")
    results["vtkProjectedTetrahedraMapper"] = frames(peer)
    reference = results["vtkProjectedTetrahedraMapper"][1]
    print(f"| mapper ({SIZE} x {SIZE}) | first s | moving s | still s | moving, times the peer's | elapsed, times the peer's |")
    print("|---|---|---|---|---|---|")
    for name, (first, moving, still) in results.items():
        print(f"| {name} | {first[0]:.2f} | {moving[0]:.2f} | {still[0]:.2f} | {moving[0] / reference[0]:.2f} | "
              f"{moving[1] / reference[1]:.2f} |")


main()
