# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: each rank saves places and texture coordinates of its points for TextureAdvectionRanks.py.

Usage: TextureAdvectionRun.py PREFIX
"""
import os
import sys

import numpy as np
from PluginTesting import DATA, load_plugin, pvs
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

TIME = 6797.25


def part_of(proxy):
    """Rows of place, both coordinates and exponent of this rank's points; and how many of them there are of cells."""
    proxy.UpdatePipeline(TIME)
    data = proxy.GetClientSideObject().GetOutputDataObject(0)
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 10))
    arrays = [data.GetPoints().GetData()] + [data.GetPointData().GetArray(name)
                                             for name in ("TextureCoordinates1", "TextureCoordinates2", "FiniteTimeLyapunovExponent")]
    return np.column_stack([vtk_to_numpy(array).astype(float) for array in arrays if array])


load_plugin()
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
series = pvs.NetCDFReader(FileName=[os.path.join(DATA, "forecast_10deg_6h.nc")], SphericalCoordinates=0)
series.Dimensions = "(lev, lat, lon)"
globe = pvs.GlobeGrid(Input=series, VerticalExaggeration=40)
texture = pvs.TextureCoordinateAdvection(Input=globe, TimeScale=3600, ComputeLyapunovExponent=1)
clouds = pvs.CloudSurface(Input=globe, ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15])
points = pvs.TextureCoordinateAdvection(Input=globe, Points=clouds, TimeScale=3600)
np.savez(f"{sys.argv[1]}-{rank}.npz", grid=part_of(texture), points=part_of(points))
print("RANK-DONE", flush=True)
