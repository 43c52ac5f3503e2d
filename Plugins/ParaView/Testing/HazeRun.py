# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that HazeRanks.py compares.

Usage: HazeRun.py PREFIX [PORT NAMES]; with a port it draws on a pvserver there, and all there, however small the data are.
"""
import sys

import numpy as np
from HazeScenes import add_haze, make_view
from HazeSkies import skies
from PluginTesting import image, load_plugin, passed, pvs, wanted


if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
    pvs.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0
load_plugin()
pvs._DisableFirstRenderCameraReset()  # whichever picture is the first


def views():
    for name in filter(wanted, ("clear sky", "hazed sky")):
        view = make_view(medium=name == "clear sky")
        add_haze(view, background=name == "hazed sky")
        yield name, view
    yield from skies()


for name, view in views():
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
passed()
