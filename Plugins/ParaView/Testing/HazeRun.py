# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that HazeRanks.py compares.

Usage: HazeRun.py PREFIX [PORT NAMES]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from HazeScenes import add_haze, make_view
from PluginTesting import image, load_plugin, passed, pvs, servermanager

if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
for name in ("clear sky", "hazed sky")[:2 if ranks == 1 else 1]:
    view = make_view(medium=name == "clear sky")
    add_haze(view, background=name == "hazed sky")
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    pvs.Delete(view)
passed()
