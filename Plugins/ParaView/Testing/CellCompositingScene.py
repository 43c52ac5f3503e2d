# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Among other things in the scene: two views, opaque and translucent neighbours, hiding and showing again."""
import numpy as np
from PluginTesting import (check, check_same, color_and_alpha, compose, image, load_plugin, look, new_view, passed, pvs,
                           save_image, solid)


def plane(view, z, opacity):
    """A red square across the picture at depth z."""
    source = pvs.Plane(Origin=[-40, -40, z], Point1=[40, -40, z], Point2=[-40, 40, z])
    display = pvs.Show(source, view)
    solid(display, [1, 0, 0])
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    display.Opacity = opacity
    return display


def move(display, translation):
    name = "Translation" if "Translation" in display.ListProperties() else "Position"  # renamed in ParaView 5.13
    display.SetPropertyWithName(name, translation)


def front(view):
    look(view, position=(0, 0, 110))


def check_two_views(source):
    """Two views of one source, one of them seen from behind: each is as it is alone."""
    first, second = new_view(), new_view()
    for view, position in ((first, (60, 45, 70)), (second, (-60, 45, -70))):
        compose(source, view)
        look(view, position)
    together = [image(first), image(second), image(first)]
    check_same(together[0], together[2], "first view before and after the second")
    check(np.abs(together[0] - together[1]).max() > 10, "two sides of the wavelet look the same")
    alone = new_view()
    compose(source, alone)
    look(alone, (-60, 45, -70))
    check_same(together[1], image(alone), "second view and alone")


def check_neighbour(source, opacity):
    """The picture with a plane behind the volume is the volume laid over the picture of the plane."""
    view = new_view()
    display = compose(source, view)
    front(view)
    color, alpha = color_and_alpha(view)
    neighbour = plane(view, -15.0, opacity)
    front(view)
    both = image(view)
    display.Visibility = 0
    behind = image(view)
    check(behind[150, 150, 0] > 100 * opacity, "the plane is not there")
    expected = color + (1.0 - alpha[:, :, None]) * behind
    # 8-bit rounding: two of the volume's pictures, one of the plane's, one of the result.
    check_same(expected, both, f"volume over a plane of opacity {opacity}", largest=3, mean=0.6)
    # An opaque plane in front hides the volume altogether.
    display.Visibility = 1
    move(neighbour, [0, 0, 40])
    hidden = image(view)
    if opacity == 1.0:
        display.Visibility = 0
        check_same(hidden, image(view), "volume behind an opaque plane")


def check_half_hidden(source):
    """An opaque plane through the middle: less of the volume in front of it than alone, more than nothing."""
    view = new_view()
    display = compose(source, view)
    front(view)
    plane(view, 0.0, 1.0)
    front(view)
    both = image(view)
    display.Visibility = 0
    red = image(view)
    save_image(both, "HalfHidden")
    difference = np.abs(both - red)[100:200, 100:200].mean()
    check(difference > 10, "nothing is drawn in front of the plane")


def check_hide_and_show(source):
    view = new_view()
    display = compose(source, view)
    look(view)
    before = image(view)
    display.SetRepresentationType("Surface")
    surface = image(view)
    check(np.abs(surface - before).max() > 10, "Surface looks like Cell Compositing")
    display.SetRepresentationType("Cell Compositing")
    check_same(before, image(view), "after Surface and back")
    display.Visibility = 0
    check(image(view).max() == 0, "a hidden volume is drawn")


def check_move(source):
    view = new_view()
    display = compose(source, view)
    front(view)
    before = image(view)
    move(display, [8, 0, 0])
    check(np.abs(image(view) - before).max() > 10, "a moved volume stays where it was")
    move(display, [0, 0, 0])
    check_same(before, image(view), "moved and back")


load_plugin()
wavelet = pvs.Wavelet()
check_two_views(wavelet)
check_neighbour(wavelet, 1.0)
check_neighbour(wavelet, 0.5)
check_half_hidden(wavelet)
check_hide_and_show(wavelet)
check_move(wavelet)
passed()
