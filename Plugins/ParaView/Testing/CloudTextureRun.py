# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that CloudTextureRanks.py compares.

Usage: CloudTextureRun.py PREFIX [PORT NAMES]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from CloudTextureScenes import CLOUDS, moving_clouds
from PluginTesting import image, load_plugin, new_view, passed, pvs, solid


def draw(name, source, time=0.0, representation=CLOUDS, thickness=False):
    view = new_view()
    view.ViewTime = time
    display = pvs.Show(source, view)
    display.SetRepresentationType(representation)
    display.CloudTextureUseThickness = int(thickness)
    solid(display, [1, 1, 1])
    view.CameraViewUp = [1, 0, 0]  # as somebody has turned it: it stays above the pole
    pvs.ResetCamera(view)
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    pvs.Delete(view)


if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
globe = pvs.Sphere(Radius=6.4e6, ThetaResolution=120, PhiResolution=120)
draw("globe", globe)
texture, clouds = moving_clouds()
draw("clouds", clouds, 0.2)
draw("thick", clouds, 0.2, thickness=True)
draw("plain", clouds, 0.2, "Surface")  # that the clouds are on
passed()
