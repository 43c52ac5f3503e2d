# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Translucent surfaces in front of, inside and between volumes, with ParaView's default settings.

The volume is an elevation along the view, so that its contour is a plane. What lies in front of the plane and what lies
behind it are also drawn alone, and the pictures put together by hand.
"""
import numpy as np
from PluginTesting import (check, check_same, color_and_alpha, compose, image, load_plugin, look, new_view, passed, pvs,
                           save_image, solid)

RED, OPACITY = np.array([255.0, 0, 0]), 0.4
HALF = 8  # the planes are of this half size, inside the volumes' silhouette
# Two or three pictures of 8 bits are put together, and ParaView's peeling rounds to 8 bits at every step.
LARGEST, MEAN = 3, 0.6


def elevation(extent):
    """A block of the grid of points -10...10; the elevation grows from 0 behind to 1 in front."""
    block = pvs.Wavelet(WholeExtent=extent)
    return pvs.Elevation(Input=block, LowPoint=[0, 0, -10], HighPoint=[0, 0, 10])


def compose_elevation(source, view):
    display = compose(source, view, ("POINTS", "Elevation"))
    display.CellCompositingAutomaticUnitDistance = 0
    display.CellCompositingUnitDistance = 10
    colors, opacity = pvs.GetColorTransferFunction("Elevation"), pvs.GetOpacityTransferFunction("Elevation")
    colors.AutomaticRescaleRangeMode = "Never"
    colors.RescaleTransferFunction(0.0, 1.0)
    opacity.Points = [0, 0.3, 0.5, 0, 1, 1.0, 0.5, 0]
    return display


def veil(source, view):
    """Shows a surface red, unlit and translucent."""
    display = pvs.Show(source, view)
    display.Representation = "Surface"
    solid(display, [1, 0, 0])
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    display.Opacity = OPACITY
    return display


def plane(z):
    return pvs.Plane(Origin=[-HALF, -HALF, z], Point1=[HALF, -HALF, z], Point2=[-HALF, HALF, z])


def front(view):
    look(view, position=(0, 0, 110))


def alone(source):
    """Colour and alpha of a volume alone."""
    view = new_view()
    compose_elevation(source, view)
    front(view)
    result = color_and_alpha(view)
    pvs.Delete(view)
    return result


def over(layer, behind):
    color, alpha = layer
    return color + (1 - alpha[:, :, None]) * behind


def veiled(behind, view):
    """The red plane over a picture, where it is: found by drawing it opaque."""
    return np.where(red_pixels(view)[:, :, None], OPACITY * RED + (1 - OPACITY) * behind, behind)


def red_pixels(view):
    mask = image(view)[:, :, 0] > 0
    check(mask.mean() > 0.05, "the surface is not there")
    return mask


def surface_only(source):
    view = new_view()
    veil(source, view).Opacity = 1.0
    front(view)
    return view


def draw(volumes, surface):
    view = new_view()
    for volume in volumes:
        compose_elevation(volume, view)
    veil(surface, view)
    front(view)
    return image(view)


def check_contour_inside():
    """A contour of the same data inside the volume."""
    whole = elevation([-10, 10, -10, 10, -10, 10])
    contour = pvs.Contour(Input=whole, ContourBy=["POINTS", "Elevation"], Isosurfaces=[0.5])
    near, far = elevation([-10, 10, -10, 10, 0, 10]), elevation([-10, 10, -10, 10, -10, 0])
    expected = over(alone(near), veiled(alone(far)[0], surface_only(contour)))
    picture = draw([whole], contour)
    save_image(picture, "ContourInside")
    inside = red_pixels(surface_only(contour))
    check(np.abs(picture - alone(whole)[0])[inside].max() > 30, "the contour is not drawn")
    # Inside its outline: on it the contour's and the halves' silhouettes fall together.
    crop = np.s_[80:220, 80:220]
    check_same(expected[crop], picture[crop], "contour inside", LARGEST, MEAN)


def check_plane_in_front():
    whole = elevation([-10, 10, -10, 10, -10, 10])
    picture = draw([whole], plane(15.0))
    check_same(veiled(alone(whole)[0], surface_only(plane(15.0))), picture, "plane in front", LARGEST, MEAN)


def check_plane_behind():
    whole = elevation([-10, 10, -10, 10, -10, 10])
    background = np.zeros((300, 300, 3))
    expected = over(alone(whole), veiled(background, surface_only(plane(-15.0))))
    check_same(expected, draw([whole], plane(-15.0)), "plane behind", LARGEST, MEAN)


def check_two_volumes():
    """A plane between two volumes, whichever was added first."""
    near, far = elevation([-10, 10, -10, 10, 3, 10]), elevation([-10, 10, -10, 10, -10, -3])
    expected = over(alone(near), veiled(alone(far)[0], surface_only(plane(0.0))))
    for volumes in ([near, far], [far, near]):
        picture = draw(volumes, plane(0.0))
        crop = np.s_[110:190, 110:190]  # where the plane separates them
        check_same(expected[crop], picture[crop], "plane between two volumes", LARGEST, MEAN)


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_plane_in_front()
check_plane_behind()
check_contour_inside()
check_two_volumes()
passed()
