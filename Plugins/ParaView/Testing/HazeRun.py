# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that HazeRanks.py compares.

Usage: HazeRun.py PREFIX [PORT]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from HazeScenes import add_haze, make_view
from PluginTesting import image, load_plugin, passed, pvs, servermanager

if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
scenes = [("surfaces", False, False), ("cells", True, False)]
if servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() == 1:
    scenes.append(("sky", False, True))
for name, medium, background in scenes:
    view = make_view(medium)
    add_haze(view, background)
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    pvs.Delete(view)
passed()
