# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: each rank saves its part of the example Clouds over the Globe for CloudsOverGlobeRanks.py.

Usage: CloudsOverGlobeRun.py PREFIX
"""
import sys

import numpy as np
from PluginTesting import load_plugin, pvs
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def part_of(output):
    """Every array of this rank's part, with the places."""
    on_points = output.GetPointData()
    names = [on_points.GetArrayName(i) for i in range(on_points.GetNumberOfArrays())]
    return {**{name: vtk_to_numpy(on_points.GetArray(name)) for name in names}, "place": vtk_to_numpy(output.GetPoints().GetData())}


load_plugin()
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
example = pvs.CloudsovertheGlobe()
example.UpdatePipeline()
first = part_of(example.GetClientSideObject().GetOutputDataObject(0))
example.DateandTimeUTC = "2011-10-10 02:00"  # light is computed again
sun = pvs.Sun(DateTime="2011-10-10 02:00")
example.UpdatePipeline()
sun.DateTime = "2011-10-10 14:00"
example.UpdatePipeline()
second = part_of(example.GetClientSideObject().GetOutputDataObject(0))
np.savez(f"{sys.argv[1]}-{rank}.npz", names=sorted(first), changed=second["Sunlight"], **first)
print("RANK-DONE", flush=True)
