# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Globe Grid of several blocks in ParaView: each becomes a grid; nothing is updated while blocks go by."""
from PluginTesting import check, load_plugin, passed, pvs, servermanager


def main():
    load_plugin()
    east = pvs.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 3])
    west = pvs.Wavelet(WholeExtent=[-40, -20, -10, 10, 0, 3])
    globe = pvs.GlobeGrid(Input=pvs.GroupDatasets(Input=[east, west]))
    globe.UpdatePipeline()
    blocks = servermanager.Fetch(globe)
    check(blocks.IsA("vtkCompositeDataSet"), f"the output is a {blocks.GetClassName()}")
    sizes = [[0, 0, 0], [0, 0, 0]]
    for k in range(2):
        blocks.GetBlock(k).GetDimensions(sizes[k])
    check(sizes == [[21, 21, 4]] * 2, f"the blocks have {sizes} points")
    passed()


main()
