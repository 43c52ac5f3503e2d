# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: makes the flow volumes that FlowVolumeRanks.py compares; every rank keeps its share in a file.

Usage: pvbatch --symmetric FlowVolumeRanksRun.py PREFIX
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import FlowVolumeRanksData as data
import nephoscope

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()


def volume(source, **settings):
    made = nephoscope.vtkFlowVolume()
    made.SetInputConnection(source.GetOutputPort())
    for name, value in dict(dict(Radius=0.15, Duration=1.2, TimeStep=0.05), **settings).items():
        getattr(made, "Set" + name)(*value) if isinstance(value, tuple) else getattr(made, "Set" + name)(value)
    return made


def run(name, made, time=None):
    """Updates this rank's piece, at a time of a series, and keeps the tetrahedra in their order."""
    print(f"rank {RANK}: {name}", flush=True)
    if time is None:
        made.UpdatePiece(RANK, RANKS, 0)
    else:
        made.UpdateTimeStep(time, RANK, RANKS, 0)
    keep(name, made.GetOutput())


def keep(name, grid):
    count = grid.GetNumberOfCells()
    kept = {"count": count, "points": grid.GetNumberOfPoints()}
    if count:
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        kept["position"] = vtk_to_numpy(grid.GetPoints().GetData())[cells]
        for prefix, attributes in (("point", grid.GetPointData()), ("cell", grid.GetCellData())):
            for i in range(attributes.GetNumberOfArrays()):
                values = vtk_to_numpy(attributes.GetArray(i))
                kept[f"{prefix} {attributes.GetArrayName(i)}"] = values[cells] if prefix == "point" else values
    np.savez(f"{sys.argv[1]}-{name}-{RANK}.npz", **kept)


def globe():
    reader = vtkNetCDFCFReader()
    reader.SetFileName(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))
    reader.UpdateMetaData()
    reader.SetSphericalCoordinates(0)
    reader.SetDimensions("(lev, lat, lon)")
    made = nephoscope.vtkGlobeGrid()
    made.SetInputConnection(reader.GetOutputPort())
    made.SetVerticalExaggeration(50.0)
    made.SetMaskBelowGround(False)
    return made


def at(longitude, latitude, height):
    lon, lat = np.radians([longitude, latitude])
    radius = 6371229.0 + height
    return tuple(radius * np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)]))


image = data.Structured("vtkImageData", data.abc)
curved = data.Structured("vtkStructuredGrid", data.helix)
run("image", volume(image, Center=(0.1, 0.05, -0.02), Duration=0.6))
run("image-border", volume(image))  # centre and normal plane on a border of 2 and of 4 ranks
run("image-in-border", volume(data.Structured("vtkImageData", lambda p: 0 * p + [1.0, 0.0, 0.0]), Center=(-0.9, 0.0, 0.0)))
run("image-cells", volume(data.Structured("vtkImageData", data.abc, on_cells=True), Center=(0.1, 0.05, -0.02), Duration=0.6))
run("curved", volume(curved, Center=(0.3, 0.2, -0.5), Duration=0.8))
run("curved-leaving", volume(curved, Center=(0.6, 0.2, 0.3), Radius=0.3, Duration=2.0))
run("chessboard", volume(data.Unstructured(data.abc, data.chessboard), Center=(0.1, 0.05, -0.02), Duration=0.6))
run("ghosts", volume(data.Unstructured(data.abc, data.slabs, ghosts=True), Center=(0.1, 0.05, -0.02), Duration=0.6))
run("one-rank-has-all", volume(data.Unstructured(data.helix, data.last_alone), Center=(0.3, 0.2, -0.5)))
run("blocks", volume(data.Blocks(data.abc), Center=(0.1, 0.05, -0.02), Duration=0.6))
run("blocks-missing", volume(data.Blocks(data.abc, missing=(3, 7)), Center=(-0.5, -0.4, -0.5), Radius=0.4, Duration=2.0))
run("small-obstacles", volume(data.Blocks(data.abc, missing=(3, 7)), Center=(-0.5, -0.4, -0.5), Radius=0.4, Duration=2.0, ObstacleSize=0.1))
run("divided", volume(image, Center=(0.1, 0.05, -0.02), MaximumEdgeLength=0.1, Duration=1.0))
run("adaptive", volume(image, Center=(0.1, 0.05, -0.02), Integrator=1, Tolerance=1e-5))
run("automatic", volume(curved, Radius=0.0, Duration=0.0, TimeStep=0.0))
square = vtkPlaneSource()  # of no more than the first rank
square.SetOrigin(-0.2, -0.2, 0.01)
square.SetPoint1(0.2, -0.2, 0.01)
square.SetPoint2(-0.2, 0.2, 0.01)
polygon = volume(image, Duration=0.6)
polygon.SetPolygonConnection(square.GetOutputPort())
run("polygon", polygon)
unsteady = volume(data.changing(data.Structured("vtkImageData", data.abc)), Duration=0.0, Unsteady=True)
run("unsteady", unsteady, 0.5)
run("unsteady-later", unsteady, 1.2)  # goes on; much of the smoke has left the data
settings = dict(Center=(0.1, 0.05, -0.02), Unsteady=True, StartTime=0.1, Duration=0.4, MaximumEdgeLength=0.1)
run("unsteady-curved", volume(data.changing(data.Structured("vtkStructuredGrid", data.abc)), **settings), 0.7)
run("unsteady-adaptive", volume(data.changing(data.Unstructured(data.abc, data.chessboard)), Integrator=1, Tolerance=1e-5, **settings), 0.7)
run("unsteady-ghosts", volume(data.changing(data.Unstructured(data.abc, data.slabs, ghosts=True)), **settings), 0.7)
run("unsteady-blocks", volume(data.changing(data.Blocks(data.abc)), **settings), 0.7)
run("unsteady-turning", volume(data.changing(data.Structured("vtkImageData", data.abc)), MaximumTurnAngle=5.0, **dict(settings, TimeStep=0.2)), 0.75)
run("unsteady-obstacles", volume(data.changing(data.Blocks(data.abc, missing=(3, 7))), ObstacleSize=0.1, **dict(settings, Center=(-0.5, -0.4, -0.5), Radius=0.4)), 0.7)
earth = globe()
run("globe", volume(earth, Center=at(-100.0, 14.0, 50 * 3000.0), Radius=3e5, Duration=4e4, TimeStep=4e3, MaximumTurnAngle=90.0, MaximumEdgeLength=2e6))
run("globe-seam", volume(earth, Center=at(0.0, 45.0, 50 * 9000.0), Radius=4e5, Duration=4e4, TimeStep=4e3, MaximumTurnAngle=90.0, MaximumEdgeLength=2e6))
run("globe-pole", volume(earth, Center=at(180.0, 89.0, 50 * 9000.0), Radius=4e5, Duration=4e4, TimeStep=4e3, MaximumTurnAngle=90.0, MaximumEdgeLength=2e6))

print(f"rank {RANK}: errors", flush=True)
CONTROLLER.Barrier()
run("outside", volume(image, Center=(3.0, 0.0, 0.0)))
run("no-velocity", volume(data.Structured("vtkImageData", data.abc, last_has_none=True), InputArrayToProcess=(0, 0, 0, 0, "Flow")))
stopped = volume(image)
stopped.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(int(RANK == RANKS - 1)))
run("stopped", stopped)
print(f"rank {RANK}: NEPHOSCOPE" + "-PASSED", flush=True)
