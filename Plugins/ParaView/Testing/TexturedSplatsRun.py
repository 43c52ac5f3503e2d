# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures of scalars that TexturedSplatsRanks.py compares."""
from PluginTesting import passed, pvs
from TexturedSplatsDrawing import begin, draw, draw_globe, particles_of

begin()
wavelet = pvs.Wavelet()
draw("image", wavelet)
draw("again", wavelet)  # by now the transfer functions have their range
draw("hierarchy", wavelet, ErrorTolerance=3)
draw("cells", pvs.PointDatatoCellData(Input=wavelet), ("CELLS", "RTData"))
rotated = pvs.Transform(Input=wavelet)
rotated.Transform.Rotate = [10, 20, 30]
draw("structured", rotated)
# Ranks are ordered by where the display places their data.
draw("turned", wavelet, place={"Position": [5, 0, 0], "Orientation": [0, 20, 30], "Scale": [1.5, 1.5, 1.5]})
# Unstructured hexahedra are divided by the order of their points, those of a grid by turns from the first of each rank on.
tetrahedra = pvs.Tetrahedralize(Input=pvs.AppendDatasets(Input=rotated))
draw("tetrahedra", tetrahedra)
draw("particles", particles_of(tetrahedra))
# Long, thin and bent cells around an axis, whose seam is between ranks; ranks have the cells of their neighbours, or only their own.
bent = pvs.Calculator(Input=pvs.Transform(Input=wavelet), CoordinateResults=1, Function="(9+coordsX/4)*(cos(coordsY*acos(-1)/10)*iHat+sin(coordsY*acos(-1)/10)*jHat)+coordsZ*kHat")
mesh = pvs.AppendDatasets(Input=bent)
draw("hexahedra", mesh)
HIDDEN = """
import numpy
a = inputs[0].PointData['RTData']
mask = numpy.asarray(a) < 200
output.PointData.append(numpy.where(mask, 0.0, a), 'RTData')
output.PointData.append(numpy.where(mask, 2, 0).astype(numpy.uint8), 'vtkGhostType')
"""
OWN = "output.ShallowCopy(self.GetInputDataObject(0, 0)); output.VTKObject.RemoveGhostCells()"
draw("own-hexahedra", pvs.ProgrammableFilter(Input=mesh, Script=OWN))
draw("own-tetrahedra", pvs.ProgrammableFilter(Input=pvs.Tetrahedralize(Input=mesh), Script=OWN))
draw("grid", bent)
# Hidden points keep the values that decide how opaque the others are, as those of *Resample To Image* outside its input.
draw("hidden", pvs.ProgrammableFilter(Input=wavelet, Script=HIDDEN))
# The eight corners are a thousand times as far away: lengths that follow the data must not.
stray = pvs.Calculator(Input=pvs.Tetrahedralize(Input=wavelet), CoordinateResults=1, Function="if(mag(coords)>17.3, 1000*coords, coords)")
draw("stray", particles_of(stray))
draw_globe("globe")
# Which gives points of the layer of other ranks to the rank that has the layer.
draw("numbered", pvs.GenerateGlobalIds(Input=tetrahedra))
draw("numbered-image", pvs.GenerateGlobalIds(Input=wavelet))
# In a plane at right angles to the first axis, which borders between ranks are at right angles to as well, and to the last.
draw("slice", pvs.Slice(Input=wavelet, SliceType="Plane"))
draw("flat", pvs.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0]))
draw("flat-cells", pvs.PointDatatoCellData(Input=pvs.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0])), ("CELLS", "RTData"))
# Through corners of cells, where it has cells without an area and several points in one place, not the same ones on any number of ranks.
for name, data, array in (("tilted", wavelet, "POINTS"), ("tilted-cells", pvs.PointDatatoCellData(Input=wavelet), "CELLS")):
    tilted = pvs.Slice(Input=data, SliceType="Plane")
    tilted.SliceType.Normal = [1, 1, 1]
    draw(name, tilted, (array, "RTData"))
# Whose source gives each rank trees of its neighbours, without marks.
trees = pvs.RandomHyperTreeGrid() if hasattr(pvs, "RandomHyperTreeGrid") else pvs.HyperTreeGridRandom()
draw("trees", trees, ("CELLS", "Depth"))
draw("cells-of-trees", pvs.HyperTreeGridToUnstructuredGrid(Input=trees), ("CELLS", "Depth"))
draw("no-vectors", wavelet, VectorArray="RTData")  # which has one component
passed()
