# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Globe Grid of several blocks in ParaView: each becomes a grid; nothing is updated while blocks go by."""
from PluginTesting import check, listen, load_plugin, passed, pvs, servermanager


def main():
    load_plugin()
    messages = listen()
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
    for block in ("Wavelet1", "Wavelet2"):
        named = [text for text in messages if f"Block '{block}': There are no wind arrays" in text and "Load them in the reader" in text]
        check(len(named) == 1, f"not one message names {block}: {messages}")
    passed()


main()
