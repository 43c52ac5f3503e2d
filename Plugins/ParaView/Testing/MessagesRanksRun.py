# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: what is wrong on one rank or two, for MessagesRanks.py."""
from PluginTesting import load_plugin, pvs
from PluginTesting import show_twice as show

load_plugin()
wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
show(pvs.CloudOptics(Input=wavelet))
show(pvs.TextureCoordinateAdvection(Input=wavelet))
show(pvs.CloudSurface(Input=pvs.Tetrahedralize(Input=wavelet)))  # which the filter before it must survive too
show(pvs.PointSource(NumberOfPoints=20), "Cloud Texture")
show(pvs.AppendDatasets(Input=[pvs.Sphere()]), "Cell Compositing")
show(wavelet, "Cell Compositing", CellCompositingOpacityArray="nope")
missing = pvs.Calculator(Input=wavelet, ResultArrayName="nan", Function="sqrt(-1)", ReplacementValue=float("nan"))
show(missing, "Textured Splats", ColorArrayName=["POINTS", "nan"])
hole = pvs.Calculator(Input=wavelet, ResultArrayName="hole", Function="sqrt(-1)", ReplacementValue=float("nan"))
show(hole, "Cell Compositing", ColorArrayName=["POINTS", "hole"])
show(wavelet, "Cell Compositing", CellCompositingOpacityScale=-3)
without = pvs.PassArrays(registrationName="without", Input=pvs.Calculator(Input=wavelet, ResultArrayName="x", Function="coordsX"), PointDataArrays=["x"])
show(pvs.GroupDatasets(Input=[wavelet, without], BlockNames=["with", "without"]), "Textured Splats", ColorArrayName=["POINTS", "RTData"])
negative = pvs.Calculator(Input=pvs.Tetrahedralize(Input=wavelet), ResultArrayName="Extinction", Function="if(coordsZ>1,-1,0.1)")
show(pvs.Sunlight(Input=negative, MultipleScattering=0))
print("RANK-DONE", flush=True)
