# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: each rank saves its triangles and its values for CloudSurfaceRanks.py.

Usage: CloudSurfaceRun.py PREFIX
"""
import sys

import numpy as np
from PluginTesting import GFS, load_plugin, pvs
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def part_of(proxy):
    """What this rank has, the pipeline brought up to date on all."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def array_of(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float)


def triangles(data):
    """Corner by corner position and normal, the corners of each triangle in one order."""
    ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    corners = np.concatenate([vtk_to_numpy(data.GetPoints().GetData()).astype(float), array_of(data, "Normals")], axis=1)[ids]
    order = np.lexsort(corners.transpose(2, 0, 1)[:3], axis=1)
    return np.take_along_axis(corners, order[..., None], axis=1).reshape(len(ids), -1)


load_plugin()
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
weather = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
weather.Dimensions = "(lev, lat, lon)"
globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=40)
surface = pvs.CloudSurface(Input=globe, ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15], NumberOfSmoothingIterations=2)
smooth = pvs.StructuredSmoothing(Input=globe, SmoothArray=["POINTS", "cloud_fraction"], NumberOfIterations=2, Conservative=1)
whole, field = part_of(surface), part_of(smooth)
places = vtk_to_numpy(field.GetPoints().GetData()).astype(float)
np.savez(f"{sys.argv[1]}-{rank}.npz", triangles=triangles(whole),
         values=np.concatenate([places, array_of(field, "cloud_fraction")[:, None]], axis=1))
print("RANK-DONE", flush=True)
