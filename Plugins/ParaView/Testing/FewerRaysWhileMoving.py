# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Turning the view draws fewer rays, the picture at rest has all of them, and the properties in the panel limit that."""
import nephoscope  # noqa: F401  the mapper's methods
from PluginTesting import check, check_same, compose, image, load_plugin, look, new_view, passed, pvs


def mapper_of(view):
    volumes = view.GetClientSideObject().GetRenderer().GetVolumes()
    return volumes.GetItemAsObject(0).GetMapper()


def distances(view, mapper):
    """While the view moves, and at rest afterwards."""
    found = []
    for _ in range(4):
        view.SMProxy.InteractiveRender()
        found.append(mapper.GetLastImageSampleDistance())
    view.SMProxy.StillRender()
    return found, mapper.GetLastImageSampleDistance()


load_plugin()
view = new_view((300, 300))
source = pvs.Wavelet(WholeExtent=[-24, 24] * 3)
display = compose(source, view)
look(view, (120, 90, 138))
still = image(view)
mapper = mapper_of(view)
rate = view.GetClientSideObject().GetRenderWindow().GetDesiredUpdateRate()
view.SMProxy.InteractiveRender()
moving_rate = view.GetClientSideObject().GetRenderWindow().GetDesiredUpdateRate()
print(f"desired update rates: at rest {rate:g}, moving {moving_rate:g}")
check(moving_rate > 1 > rate, "ParaView no longer tells the window how fast pictures should be")

display.CellCompositingMaximumImageSampleDistance = 3
pvs.Render(view)
check(mapper.GetMaximumImageSampleDistance() == 3 and mapper.GetAutoAdjustSampleDistances(), "the mapper has other settings")
moving, rest = distances(view, mapper)
print(f"pixels from ray to ray: moving {moving}, at rest {rest}")
check(1 <= max(moving) <= 3, "beyond the greatest distance")
check(rest == 1, "coarse at rest")
check_same(still, image(view), "at rest as before")

display.CellCompositingAutoAdjustSampleDistances = 0
moving, rest = distances(view, mapper)
check(set(moving) == {1.0} and rest == 1, f"off, but {moving}")
passed()
