# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Not a test by itself: draws cells, for MissingDisplayRanks.py."""
from PluginTesting import compose, load_plugin, new_view, pvs

load_plugin()
view = new_view((40, 40))
compose(pvs.Wavelet(WholeExtent=[-4, 4] * 3), view)
pvs.Render(view)
print("DRAWN", flush=True)
