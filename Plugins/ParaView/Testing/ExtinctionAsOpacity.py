# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""An extinction drawn as it is, by the settings that Documentation/light.md names: a length L of extinction b lets through exp(-b L)."""
import numpy as np
from PluginTesting import check, image, load_plugin, new_view, passed, pvs

LENGTH = 20


def transmittance(extinction, greatest):
    """That of black cells before a white background."""
    cells = pvs.Wavelet(WholeExtent=[0, 8, 0, 8, 0, LENGTH])
    source = pvs.Calculator(Input=cells, Function=f"{extinction} + 0*RTData", ResultArrayName="Extinction")
    view = new_view([31, 31], (1, 1, 1))
    display = pvs.Show(source, view)
    display.SetRepresentationType("Cell Compositing")
    pvs.ColorBy(display, ("POINTS", "Extinction"))
    display.SetScalarBarVisibility(view, False)
    colours, opacities = (function("Extinction") for function in (pvs.GetColorTransferFunction, pvs.GetOpacityTransferFunction))
    for function in (colours, opacities):
        function.RescaleTransferFunction(0, greatest)
    colours.RGBPoints = [0, 0, 0, 0, greatest, 0, 0, 0]
    display.CellCompositingAutomaticUnitDistance = 0
    display.CellCompositingUnitDistance = 1 / greatest
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [4.1, 4.2, 200], [4.1, 4.2, 0], [0, 1, 0]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 1
    seen = image(view)[15, 15, 0] / 255
    pvs.Delete(view)
    return seen


load_plugin()
for extinction, greatest in ((0.07, 0.1), (0.01, 0.4), (0.15, 0.15)):
    found, expected = transmittance(extinction, greatest), np.exp(-extinction * LENGTH)
    check(abs(found - expected) < 0.006, f"extinction {extinction} in 0 to {greatest}: {found:.3f} passes, not {expected:.3f}")
passed()
