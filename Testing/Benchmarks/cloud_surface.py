# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the cost of smoothing, and of cloud surfaces against VTK's contour filters for structured grids.

    ./nephoscope bench

Processor time, all threads together, the least of three runs, of the forecast on the globe: 145 x 73 x 21 points, 12 arrays that
are interpolated. `boundary` counts edges of one triangle only; the ground is not hidden here, so that a surface without gaps has
them at the lowest and the highest level only.
"""
import time

import nephoscope
import numpy as np
from nephoscope_testing.weather import forecast_globe
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkFiltersCore import (vtkAppendFilter, vtkContour3DLinearGrid, vtkContourFilter, vtkContourGrid,
                                       vtkGridSynchronizedTemplates3D)

COVER = 0.15


def processor_time(algorithm):
    best = np.inf
    for _ in range(3):
        algorithm.Modified()
        start = time.process_time()
        algorithm.Update()
        best = min(best, time.process_time() - start)
    return best


def boundary_edges(surface):
    ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edges = np.sort(np.concatenate([ids[:, [0, 1]], ids[:, [1, 2]], ids[:, [2, 0]]]), axis=1)
    return int((np.unique(edges, axis=0, return_counts=True)[1] == 1).sum())


def inward_share(surface):
    """Share of the area whose triangles face against the normal at a corner."""
    points, normals = (vtk_to_numpy(a).astype(float) for a in (surface.GetPoints().GetData(), surface.GetPointData().GetNormals()))
    ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    facets = np.cross(points[ids[:, 1]] - points[ids[:, 0]], points[ids[:, 2]] - points[ids[:, 0]])
    areas = np.linalg.norm(facets, axis=1)
    return areas[np.einsum("ij,ij->i", facets, normals[ids[:, 0]]) < 0].sum() / areas.sum()


def peers(globe, normals):
    """(name, algorithm, processor time of what must come before it)."""
    append = vtkAppendFilter()
    append.SetInputData(globe)
    conversion = processor_time(append)
    made = []
    for class_, data, before in ((vtkContourFilter, globe, 0), (vtkGridSynchronizedTemplates3D, globe, 0),
                                 (vtkContourGrid, append.GetOutput(), conversion),
                                 (vtkContour3DLinearGrid, append.GetOutput(), conversion)):
        contour = class_()
        contour.SetInputData(data)
        contour.SetValue(0, COVER)
        contour.SetComputeNormals(normals)
        if class_ is vtkContour3DLinearGrid:
            contour.InterpolateAttributesOn()
        made.append((class_.__name__, contour, before))
    ours = nephoscope.vtkCloudSurface()
    ours.SetInputData(globe)
    ours.SetValue(0, COVER)
    ours.SetNumberOfSmoothingIterations(0)
    ours.SetComputeNormals(normals)
    return [("vtkCloudSurface, no smoothing", ours, 0)] + made


def main():
    vtkObject.GlobalWarningDisplayOff()  # one of them warns of every point at a pole
    globe = forecast_globe()
    for data in (globe.GetPointData(), globe.GetCellData()):
        data.RemoveArray("vtkGhostType")
    globe.GetPointData().SetActiveScalars("cloud_fraction")
    for normals in (False, True):
        print(f"contours {'with' if normals else 'without'} normals")
        for name, contour, before in peers(globe, normals):
            seconds = processor_time(contour) + before
            out = contour.GetOutput()
            print(f"  {name:32s} {seconds:6.3f} s  {out.GetNumberOfCells():7d} triangles  "
                  f"{out.GetPointData().GetNumberOfArrays():2d} arrays  boundary {boundary_edges(out)}")
            if normals and hasattr(contour, "SetNumberOfSmoothingIterations"):
                contour.SetNumberOfSmoothingIterations(3)
                contour.SetIsotropic(True)
                contour.Update()
                print(f"  smoothed three times, {inward_share(contour.GetOutput()):.2%} of the area face against the normals")
    print("smoothing, one iteration of one array")
    for settings in ({}, {"Conservative": True}, {"Isotropic": True}):
        smooth = nephoscope.vtkStructuredSmoothing()
        smooth.SetInputData(globe)
        times = []
        for iterations in (10, 20):
            smooth.SetNumberOfIterations(iterations)
            for name, value in settings.items():
                getattr(smooth, "Set" + name)(value)
            times.append(processor_time(smooth))
        print(f"  {', '.join(settings) or 'plain':14s} {(times[1] - times[0]) / 10:.4f} s, and once {max(0, 2 * times[0] - times[1]):.3f} s")


main()
