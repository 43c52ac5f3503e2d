# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that CellCompositingPiecesRanks.py compares. Usage: CellCompositingPiecesRun.py PREFIX"""
import sys

import numpy as np
from PluginTesting import compose, image, load_plugin, look, new_view, passed, pvs


def draw(name, source, **properties):
    view = new_view()
    display = compose(source, view)
    for property_name, value in properties.items():
        setattr(display, property_name, value)
    look(view, position=(4, 3, 5))
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    pvs.Delete(view)


load_plugin()
# Two layers of cells for three ranks: one rank has a layer of points.
few = pvs.Wavelet(WholeExtent=[-1, 1] * 3)
turned = pvs.Transform(Input=few)
turned.Transform.Rotate = [10, 20, 30]
draw("image", few)
draw("voxels", pvs.AppendDatasets(Input=few))
draw("structured", turned)
draw("hexahedra", pvs.AppendDatasets(Input=turned))
draw("all-polygons", pvs.AppendDatasets(Input=turned), CellCompositingPolygons="All")
passed()
