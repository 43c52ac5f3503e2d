# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: makes the flow volumes whose places FlowVolumePlaceRanks.py compares.

Usage: pvbatch FlowVolumePlaceRanksRun.py FILE.npz
"""
import sys

import numpy as np
from PluginTesting import load_plugin, pvs

WHIRL = "iHat*(10+coordsY)-jHat*coordsX+kHat*5"  # as fast, as far and as near to the middle in several places
SADDLE = "iHat*coordsX-jHat*coordsY+0.5*kHat"
found = {}


def flow(function, source=None):
    source = source or pvs.Wavelet(WholeExtent=[-10, 10] * 3)
    return pvs.Calculator(Input=source, Function=function, ResultArrayName="V")


def keep(name, data):
    """With few steps: ranks wait for one another in each."""
    smoke = pvs.FlowVolume(Input=data, Duration=0.05, TimeStep=0.025)
    smoke.UpdatePipeline()
    found[name] = [*smoke.Center, smoke.Radius, *smoke.Normal, smoke.GetDataInformation().GetNumberOfCells()]
    print(name, found[name], flush=True)
    return smoke


def updated(data):
    data.UpdatePipeline()
    return data


load_plugin()
pvs.Show(keep("whirl", flow(WHIRL)))
pvs.Render()
keep("whirl, updated before", updated(flow(WHIRL)))
keep("saddle", flow(SADDLE))
keep("whirl of cells", pvs.PointDatatoCellData(Input=flow(WHIRL)))
keep("unstructured", pvs.AppendDatasets(Input=[flow(WHIRL)]))
keep("unstructured, updated before", updated(pvs.AppendDatasets(Input=[flow(SADDLE)])))
keep("blocks", pvs.GroupDatasets(Input=[flow(WHIRL), flow(SADDLE, pvs.Wavelet(WholeExtent=[10, 20, -10, 10, -10, 10]))]))
keep("little on each", flow(WHIRL, pvs.Wavelet(WholeExtent=[0, 3, 0, 3, 0, 1])))
keep("globe", pvs.CloudsovertheGlobe())
np.savez(sys.argv[1], **found)
print("RANK-DONE", flush=True)
