# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A state file, and a Python script of the state, bring the same picture back."""
import os

from PluginTesting import OUTPUT, check, check_same, compose, image, load_plugin, look, new_view, passed, pvs
from paraview import smstate


def scene():
    view = new_view()
    display = compose(pvs.Wavelet(), view)
    display.CellCompositingOpacityScale = 0.5
    display.CellCompositingIntegration = "Average"
    display.CellCompositingVisibilityOrder = "Centroid"
    display.CellCompositingSplitAtControlPoints = 0
    display.CellCompositingAutomaticUnitDistance = 0
    display.CellCompositingUnitDistance = 1.5
    look(view)
    return image(view)


def restored():
    view = pvs.GetActiveView()
    display = view.Representations[0]
    check(display.Representation == "Cell Compositing", f"came back as {display.Representation}")
    found = (display.CellCompositingOpacityScale, display.CellCompositingIntegration,
             display.CellCompositingVisibilityOrder, display.CellCompositingSplitAtControlPoints,
             display.CellCompositingAutomaticUnitDistance, display.CellCompositingUnitDistance)
    check(found == (0.5, "Average", "Centroid", 0, 0, 1.5), f"properties came back as {found}")
    return image(view)


load_plugin()
original = scene()
check(original.mean() > 1, "nothing is drawn")
state = os.path.join(OUTPUT, "CellCompositingState.pvsm")
pvs.SaveState(state)
script = smstate.get_state()
assigned = script.replace(" ", "")  # `display.A = 1` in ParaView 5.11, `display.Set(A=1)` in 6.1
check("'CellCompositing'" in assigned and "CellCompositingUnitDistance=1.5" in assigned, "not in the Python state")

pvs.ResetSession()
load_plugin()
pvs.LoadState(state)
check_same(original, restored(), "state file")

pvs.ResetSession()
load_plugin()
exec(compile(script, "state", "exec"), {})
check_same(original, restored(), "Python state")
passed()
