# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two volumes of a view that overlap are one medium: whichever is shown first, and whichever a state file brings back first."""
import os

from PluginTesting import OUTPUT, check, check_same, compose, image, load_plugin, look, new_view, passed, pvs


def medium(view, extent, scale, unit=8.0):
    display = compose(pvs.Wavelet(WholeExtent=extent), view)
    display.CellCompositingOpacityScale = scale
    display.CellCompositingAutomaticUnitDistance = 0
    display.CellCompositingUnitDistance = unit
    return display


def picture(*media):
    view = new_view()
    for extent, scale in media:
        medium(view, extent, scale)
    pvs.GetColorTransferFunction("RTData").RescaleTransferFunction(40, 280)
    pvs.GetOpacityTransferFunction("RTData").RescaleTransferFunction(40, 280)
    pvs.Render(view)  # the first one resets the camera
    look(view, (25, 18, 45), (1, 1, 1))
    return image(view)


WHOLE, CORNER = [-6, 6] * 3, [0, 9, -2, 8, -4, 4]
load_plugin()
first = picture((WHOLE, 1.0), (CORNER, 0.7))
check(first.mean() > 1, "nothing is drawn")
check_same(first, picture((CORNER, 0.7), (WHOLE, 1.0)), "shown in another order", 1, 0.01)
check_same(picture((WHOLE, 1.0)), picture((WHOLE, 0.4), (WHOLE, 0.6)), "a medium in two parts", 1, 0.01)

state = os.path.join(OUTPUT, "CellCompositingMedia.pvsm")
pvs.ResetSession()
load_plugin()
before = picture((WHOLE, 1.0), (CORNER, 0.7))
pvs.SaveState(state)
pvs.ResetSession()
load_plugin()
pvs.LoadState(state)
check_same(before, image(pvs.GetActiveView()), "state file", 1, 0.01)
passed()
