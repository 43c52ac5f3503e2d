# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two volumes of a view that overlap are one medium: whichever is shown first, and whichever a state file brings back first."""
import os

from PluginTesting import OUTPUT, check, check_same, compose, image, load_plugin, look, new_view, passed, pvs, render


def medium(view, extent, scale, unit=8.0):
    display = compose(pvs.Wavelet(WholeExtent=extent), view)
    display.CellCompositingOpacityScale = scale
    display.CellCompositingAutomaticUnitDistance = 0
    display.CellCompositingUnitDistance = unit
    return display


def picture(*media):
    view = new_view((150, 150))
    for extent, scale in media:
        medium(view, extent, scale)
    pvs.GetColorTransferFunction("RTData").RescaleTransferFunction(40, 280)
    pvs.GetOpacityTransferFunction("RTData").RescaleTransferFunction(40, 280)
    render(view)  # the first one resets the camera
    look(view, (20, 14, 36), (0.5, 0.5, 0.5))
    return image(view)


def alone(*media):
    """The picture in a view that goes with it."""
    taken = picture(*media)
    pvs.Delete(pvs.GetActiveView())
    return taken


WHOLE, CORNER = [-3, 3] * 3, [0, 5, -1, 4, -2, 2]
load_plugin()
check_same(alone((WHOLE, 1.0)), alone((WHOLE, 0.4), (WHOLE, 0.6)), "a medium in two parts", 1, 0.01)
other_order = alone((CORNER, 0.7), (WHOLE, 1.0))
both = picture((WHOLE, 1.0), (CORNER, 0.7))
check(both.mean() > 1, "nothing is drawn")
check_same(both, other_order, "shown in another order", 1, 0.01)

state = os.path.join(OUTPUT, "CellCompositingMedia.pvsm")
pvs.SaveState(state)
pvs.ResetSession()
load_plugin()
pvs.LoadState(state)
check_same(both, image(pvs.GetActiveView()), "state file", 1, 0.01)
passed()
