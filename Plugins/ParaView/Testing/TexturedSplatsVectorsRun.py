# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures of vectors that TexturedSplatsVectorsRanks.py compares."""
from PluginTesting import passed, pvs
from TexturedSplatsDrawing import begin, draw, draw_globe, particles_of

STREAKS = {"VectorArray": "Flow", "UseVectorColor": 1, "MoveWithTime": 0, "Phase": 0.3}

begin()
flow = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="Flow", Function="-coordsY*iHat+coordsX*jHat+3*kHat")
draw("streaks", flow, **STREAKS)
draw("segments", flow, **STREAKS, VectorStyle=1, PhaseSteps=16)
draw("cells", pvs.PointDatatoCellData(Input=flow), ("CELLS", "RTData"), **STREAKS)
draw("layers", particles_of(flow), **STREAKS, VectorPlacement=1)
draw_globe("wind", stride=4, VectorArray="DisplayVelocity", UseVectorColor=1, MoveWithTime=0)
# One rank has the fastest, by which the time scale is found.
sheared = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="Flow", Function="(20+coordsX+coordsY+coordsZ)*(iHat+0.5*jHat)")
MOVING = {"VectorArray": "Flow", "UseVectorColor": 1, "TrueSpeed": 1, "OpacityScale": 0.2, "distance": 0.5}
draw("true-speed-start", sheared, **MOVING)
draw("true-speed", sheared, time=0.4, **MOVING)
draw("true-speed-segments", sheared, time=0.4, **MOVING, VectorStyle=1, TimeScale=0.03)
passed()
