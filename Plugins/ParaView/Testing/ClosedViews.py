# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views and sessions that close and come again, one source in several views, closed in any order: the same pictures, no errors."""
import gc

from PluginTesting import check, check_same, compose, image, load_plugin, new_view, passed, pvs

KINDS = ("Cell Compositing", "Textured Splats", "Cloud Texture")


def show(kind, view):
    wavelet = pvs.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    source = pvs.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150.0]) if kind == "Cloud Texture" else wavelet
    compose(source, view, representation=kind)
    pvs.Show(pvs.Sphere(Center=[3, 3, 3]), view)
    pvs.Show(pvs.Haze(), view).VisualRange = 1e9
    pvs.ResetCamera(view)
    return image(view)


def small_view():
    return new_view((80, 60))


def check_sessions(kind):
    first = show(kind, small_view())
    check(first.max() > 20, f"{kind}: nothing is drawn")
    for views in (2, 1):
        pvs.ResetSession()
        for i in range(views):
            check_same(show(kind, small_view()), first, f"{kind}, view {i} of {views}")
    pvs.ResetSession()


def check_closed_views(kind):
    views = [small_view() for _ in range(3)]
    pictures = [show(kind, view) for view in views]
    for closed in (1, 0):
        pvs.Delete(views.pop(closed))
        del pictures[closed]
        gc.collect()
        for view, picture in zip(views, pictures):
            check_same(image(view), picture, f"{kind} beside a closed view")
    again = small_view()
    check_same(show(kind, again), pictures[0], f"{kind} in a new view")
    pvs.ResetSession()


load_plugin()
for name in KINDS:
    check_sessions(name)
    check_closed_views(name)
passed()
