# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that TexturedSplatsRanks.py compares.

Usage: TexturedSplatsRun.py PREFIX [PORT]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from PluginTesting import GFS, compose, image, load_plugin, look, new_view, passed, pvs


def draw(name, source, array=("POINTS", "RTData"), distance=1):
    view = new_view()
    compose(source, view, array, "Textured Splats")
    look(view, position=[distance * c for c in (60, 45, 70)])
    picture = image(view)
    pvs.Delete(view)
    np.save(f"{sys.argv[1]}-{name}.npy", picture)


if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
wavelet = pvs.Wavelet()
draw("image", wavelet)
draw("cells", pvs.PointDatatoCellData(Input=wavelet), ("CELLS", "RTData"))
rotated = pvs.Transform(Input=wavelet)
rotated.Transform.Rotate = [10, 20, 30]
draw("structured", rotated)
tetrahedra = pvs.Tetrahedralize(Input=rotated)
draw("tetrahedra", tetrahedra)
particles = pvs.MaskPoints(Input=tetrahedra, OnRatio=1, MaximumNumberofPoints=10**6, GenerateVertices=1, SingleVertexPerCell=1)
draw("particles", particles)
weather = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0),
                            VOI=[0, 10**6] * 3, SampleRateI=2, SampleRateJ=2)
globe = pvs.GlobeGrid(Input=weather, VerticalExaggeration=50)
globe.UpdatePipeline()
draw("globe", globe, ("POINTS", "r"), distance=max(abs(b) for b in globe.GetDataInformation().GetBounds()) / 20)
passed()
