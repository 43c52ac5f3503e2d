# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: each rank saves the light of its part of unstructured clouds, of blocks, of the ground below these, and of smoke, for SunlightRanks.py.

Usage: SunlightRun.py PREFIX
"""
import sys

import numpy as np
from PluginTesting import load_plugin, pvs
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

NAMES = ("Sunlight", "ScaledExtinction", "SunTransmittance", "Irradiance", "UpwardIrradiance", "AbsorbedLight")


def leaves(data):
    blocks = (data.GetBlock(i) for i in range(data.GetNumberOfBlocks())) if hasattr(data, "GetNumberOfBlocks") else [data]
    for block in blocks:
        if block is not None:
            yield from leaves(block) if hasattr(block, "GetNumberOfBlocks") else [block]


def rows(proxy):
    """x, y, z and the light at the points of this rank, the pipeline brought up to date on all."""
    proxy.UpdatePipeline()
    parts = [np.empty((0, 3 + len(NAMES)))]
    for leaf in leaves(proxy.GetClientSideObject().GetOutputDataObject(0)):
        places = np.array([leaf.GetPoint(p) for p in range(leaf.GetNumberOfPoints())]).reshape(-1, 3)
        if len(places):
            parts.append(np.column_stack([places] + [vtk_to_numpy(leaf.GetPointData().GetArray(name)) for name in NAMES]))
    return np.concatenate(parts)


load_plugin()
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
lumps = [pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[first, first + 8, -8, 8, -4, 4]), ResultArrayName="Extinction", Function="max(0, RTData - 160) * 0.02") for first in (-8, 0)]
cells = [pvs.AppendDatasets(Input=[one]) for one in lumps]
SUN = [2, 1, 0.5]
mesh = pvs.Sunlight(Input=pvs.AppendDatasets(Input=cells), SunDirection=SUN)
blocks = pvs.Sunlight(Input=pvs.GroupDatasets(Input=[lumps[0], cells[1]]), SunDirection=SUN)
ground = pvs.Plane(Origin=[-16, -16, -6], Point1=[16, -16, -6], Point2=[-16, 16, -6], XResolution=32, YResolution=32)
shaded = pvs.Sunlight(Input=ground, Clouds=mesh, SunDirection=SUN)
half = pvs.Clip(Input=cells[0], ClipType="Plane")  # on two ranks, the first one has the ground alone
half.ClipType.Origin, half.ClipType.Normal, half.Invert = [0, 1, 0], [0, 1, 0], 0
upright = pvs.Sunlight(Input=half, Up=[0, 1, 0], SunDirection=[0.5, 2, 0.3])
wall = pvs.Plane(Origin=[-16, -12, -16], Point1=[16, -12, -16], Point2=[-16, -12, 16], XResolution=32, YResolution=32)
below = pvs.Sunlight(Input=wall, Clouds=upright, SunDirection=[0.5, 2, 0.3])
wind = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="V", Function="iHat*(5-coordsY*0.5)+jHat*coordsX*0.5+kHat*1")
smoke = pvs.Sunlight(Input=pvs.FlowVolume(Input=wind), SunDirection=[0, -1, 0.3])
np.savez(f"{sys.argv[1]}-{rank}.npz", mesh=rows(mesh), blocks=rows(blocks), ground=rows(shaded), below=rows(below), smoke=rows(smoke))
print("RANK-DONE", flush=True)
