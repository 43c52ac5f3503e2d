# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws the pictures that HazeRanks.py compares.

Usage: HazeRun.py PREFIX [PORT]; with a port it draws on a pvserver there.
"""
import sys

import numpy as np
from HazeScenes import add_haze, make_view
from PluginTesting import image, load_plugin, passed, pvs

if len(sys.argv) > 2:
    pvs.Connect("localhost", int(sys.argv[2]))
load_plugin()
for name, medium, background in (("surfaces", False, False), ("cells", True, False), ("sky", False, True)):
    view = make_view(medium)
    np.save(f"{sys.argv[1]}-plain-{name}.npy", image(view))
    add_haze(view, background)
    np.save(f"{sys.argv[1]}-{name}.npy", image(view))
    pvs.Delete(view)
passed()
