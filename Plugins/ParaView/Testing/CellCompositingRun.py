# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that CellCompositingRanks.py compares.

Usage: CellCompositingRun.py PREFIX [PORT NAMES]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from PluginTesting import clear, compose, empty_view, image, load_plugin, look, passed, pvs, solid, wanted


def draw(name, source, array=("POINTS", "RTData"), opacity_scale=1, surfaces=(), balls=None, beside=None, **properties):
    if not wanted(name):
        return
    view = empty_view()
    display = compose(source, view, array)
    display.CellCompositingOpacityScale = opacity_scale
    for property_name, value in properties.items():
        setattr(display, property_name, value)
    if beside:
        compose(beside, view, ("POINTS", "other"))
    for surface in surfaces:
        shown = pvs.Show(surface, view)
        solid(shown, [1, 0, 0])
        shown.Opacity = 0.4
    if balls:
        solid(pvs.Show(pvs.Sphere(Center=balls, Radius=4), view), [0, 0, 1])
    look(view)
    picture = image(view)
    clear(view)
    np.save(f"{sys.argv[1]}-{name}.npy", picture)


if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
wavelet = pvs.Wavelet()
draw("image", wavelet)
draw("tetrahedra", pvs.Tetrahedralize(Input=wavelet))
rotated = pvs.Transform(Input=wavelet)
rotated.Transform.Rotate = [10, 20, 30]
draw("structured", rotated)
draw("cells", pvs.PointDatatoCellData(Input=wavelet), ("CELLS", "RTData"))
# Large, nearly opaque cells askew to any border between ranks: wrong order or whole cells across the border show.
coarse = pvs.Transform(Input=pvs.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]))
coarse.Transform.Rotate = [10, 20, 30]
coarse.Transform.Scale = [3, 3, 3]
draw("coarse", coarse, opacity_scale=5)
draw("coarse-cells", pvs.PointDatatoCellData(Input=coarse), ("CELLS", "RTData"), opacity_scale=20)
# Ranks are ordered by where the display places their data.
draw("moved", wavelet, Position=[5, 3, 0], balls=[5, 3, 0])
draw("turned", pvs.Tetrahedralize(Input=wavelet), Position=[5, 0, 0], Orientation=[0, 10, 30], Scale=[1.5, 1.5, 1.5])
# Whole cells of all kinds are spread over ranks, and keep the field that one rank draws.
draw("hexahedra", pvs.AppendDatasets(Input=coarse), opacity_scale=5)
draw("as-tetrahedra", coarse, opacity_scale=5, CellCompositingCellInterpolation="Tetrahedra")
draw("hexahedra-as-tetrahedra", pvs.AppendDatasets(Input=coarse), opacity_scale=5, CellCompositingCellInterpolation="Tetrahedra")
draw("turned-image", pvs.Wavelet(WholeExtent=[-4, 4] * 3), Orientation=[10, 20, 30], Scale=[2, 2, 2])
halves = [pvs.Wavelet(WholeExtent=[first, first + 6, -6, 6, -6, 6]) for first in (-6, 0)]
mixed = pvs.AppendDatasets(Input=[pvs.Tetrahedralize(Input=halves[0]), halves[1]])
draw("mixed", mixed)
draw("mixed-trilinear", mixed, CellCompositingCellInterpolation="Trilinear")
draw("contours", rotated, CellCompositingContourValues=[130, 200], CellCompositingSmoothContourNormals=0)
# Normals and surfaces as one rank has them: in an image, in cells of all kinds, trilinear ones, and where another array is contoured.
lit = {"CellCompositingContourValues": [130, 200], "CellCompositingContourOpacity": 1.0, "CellCompositingOpacityScale": 1e-6, "Specular": 0.5, "SpecularPower": 20}
other = pvs.Calculator(Input=wavelet, ResultArrayName="other", Function="coordsX+coordsY*coordsZ/8")
both = {**lit, "CellCompositingContourArray": "other", "CellCompositingContourValues": [-3, 3], "CellCompositingCellInterpolation": "Trilinear"}
draw("lit-image", wavelet, **lit)
draw("lit-structured", rotated, **lit)
draw("lit-tetrahedra", pvs.Tetrahedralize(Input=wavelet), **lit)
draw("lit-hexahedra", pvs.AppendDatasets(Input=rotated), **lit)
draw("other-image", other, **both)
draw("other-structured", pvs.Transform(Input=other), **both)
# Two media in the same place, composited as one on every rank: a grid in an image, and an image in hexahedra.
inner = pvs.Transform(Input=other)
inner.Transform.Rotate, inner.Transform.Scale = [10, 20, 30], [0.6, 0.6, 0.9]
draw("media", wavelet, beside=inner)
draw("media-hexahedra", pvs.AppendDatasets(Input=coarse), opacity_scale=5, beside=other)
# A volume that is empty has no bounds, which would be the region of every rank.
nothing = pvs.Threshold(Input=wavelet, Scalars=["POINTS", "RTData"], LowerThreshold=9998, UpperThreshold=9999)
draw("beside-nothing", pvs.Tetrahedralize(Input=wavelet), beside=nothing)
vectors = pvs.Calculator(Input=rotated, ResultArrayName="v", Function="coordsX*iHat+coordsY*jHat+0.5*coordsZ*kHat")
draw("magnitude", vectors, **{**lit, "CellCompositingContourArray": "v", "CellCompositingContourValues": [6]})
# Cells so warped, some of them, that their tetrahedra overlap: all ranks draw their trilinear field.
shifts = ("sin(12.9*coordsX+78.2*coordsY+37.7*coordsZ)*iHat", "sin(39.3*coordsX+11.1*coordsY+83.1*coordsZ)*jHat", "sin(73.1*coordsX+52.2*coordsY+9.2*coordsZ)*kHat")
warped = pvs.Calculator(Input=pvs.AppendDatasets(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3)), CoordinateResults=1, Function=f"2*coords+0.44*({'+'.join(shifts)})")
draw("warped", warped)
# The eight corners are far away: lengths that follow the data must not.
stray = pvs.Calculator(Input=pvs.Tetrahedralize(Input=wavelet), CoordinateResults=1, Function="if(mag(coords)>17.3, 100*coords, coords)")
draw("stray", stray)
# Where cells are cut between ranks, VTK drops arrays of ids.
draw("ids", pvs.GenerateGlobalIds(Input=pvs.Tetrahedralize(Input=pvs.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))), ("POINTS", "GlobalPointIds"))
# Translucent surfaces inside: a contour of the same data, and a plane across all ranks, as triangles: where a border between ranks cuts
# quadrilaterals, ParaView 5.13 by itself loses parts of them.
contour = pvs.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[130, 200])
plane = pvs.Triangulate(Input=pvs.Plane(Origin=[-12, -12, 2], Point1=[12, -12, -2], Point2=[-12, 12, 6]))
draw("surfaces", wavelet, surfaces=[contour, plane])
draw("surfaces-tetrahedra", pvs.Tetrahedralize(Input=wavelet), surfaces=[contour, plane])
# Polygons between the pieces of cells; where a border cuts them, it cuts the faces that they lie in.
pieces = pvs.ContourCellSplitter(Input=rotated, ContourBy=["POINTS", "RTData"], ContourValues=[130, 200])
draw("polygons", pieces, CellCompositingContourOpacities=[0.4, 0.8], CellCompositingSmoothContourNormals=0)
# The middle of the range of all ranks, where the pieces of the ranks have other ranges.
draw("default-value", pvs.ContourCellSplitter(Input=pvs.Wavelet(WholeExtent=[-4, 10] * 3)))
passed()
