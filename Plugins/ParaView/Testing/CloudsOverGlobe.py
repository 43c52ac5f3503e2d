# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example Clouds over the Globe: nothing set, it shows clouds before the Earth, from the build tree as from an installed one; and filters
that are made before there are data find the default array when there are."""
import os

import numpy as np
from PluginTesting import GFS, check, check_same, image, load_plugin, new_view, passed, pvs, save_image, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy


def check_example():
    os.environ.pop("NEPHOSCOPE_DATA", None)  # as where the plugin is loaded by hand
    example = pvs.CloudsovertheGlobe()
    view = new_view()
    clouds = pvs.Show(example, view)
    check(clouds.Representation == "Cell Compositing", f"the clouds are shown as {clouds.Representation}")
    check(clouds.ColorArrayName[1] == "Sunlight", f"coloured by {clouds.ColorArrayName}")
    pvs.Hide(example, view)
    ground = pvs.Show(pvs.OutputPort(example, 1), view)
    check(not ground.ColorArrayName[1], f"the window shows a scalar bar of {ground.ColorArrayName[1]}")
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, -3e7, 0], [0, 0, 0], [0, 0, 1]  # the Americas
    pvs.ResetCamera(view)
    earth = image(view)
    brown = (earth[:, :, 0] > earth[:, :, 2] + 10).mean()
    check(brown > 0.005, f"{brown:.1%} of the picture are brown: not the colours of the Earth")
    blue = (earth[:, :, 2] > earth[:, :, 0] + 10).mean()
    check(blue > 0.1, f"{blue:.1%} of the picture are blue: no Earth")
    ground.ColorArrayName = ["POINTS", "Earth"]
    check_same(image(view), earth, "coloured by the array Earth")
    ground.ColorArrayName = ["POINTS", ""]
    pvs.Show(example, view)
    both = image(view)
    save_image(both, "CloudsOverGlobe")
    whiter = ((both - earth).min(axis=2) > 30).mean()
    check(0.1 < whiter < 0.6, f"{whiter:.1%} of the picture are clouds")
    check_daylight(example, view)
    example.UpdatePipeline()
    size = np.array(example.GetDataInformation().GetBounds())
    check(6.6e6 < size.max() < 7.2e6, f"bounds {size}")
    example.VerticalExaggeration = 100
    example.UpdatePipeline()
    check(max(example.GetDataInformation().GetBounds()) > 7.5e6, "the vertical exaggeration does not arrive")


def check_daylight(example, view):
    """On a day of equinox, without clouds, the irradiance of the ground follows the height of the sun: by it the Earth is lit, and its other half is dark."""
    def earth(time):
        example.DateandTimeUTC = time
        return image(view)

    pvs.Hide(example, view)
    noon, midnight = earth("2011-03-20 18:00"), earth("2011-03-20 06:00")  # at 90 degrees west
    seen = abs(noon - midnight).max(axis=2) > 20
    check(seen.mean() > 0.1, f"{seen.mean():.1%} of the picture are brighter at noon than at midnight")
    dark = midnight[seen].mean() / noon[seen].mean()
    check(dark < 0.2, f"at midnight the Earth has {dark:.2f} of its brightness at noon")
    morning = earth("2011-03-20 12:00")
    east, west = (morning[:, half][seen[:, half]].mean() for half in (slice(morning.shape[1] // 2, None), slice(0, morning.shape[1] // 2)))
    check(east > 1.5 * west, f"in the morning the east has {east:.0f}, the west {west:.0f}")
    sun = pvs.Sun(DateTime="2011-03-20 06:00")  # takes the place of the example's own
    check_same(image(view), midnight, "a Sun beside the example")
    example.Sun = None
    pvs.Delete(sun)
    check_same(image(view), morning, "without the Sun")
    pvs.Show(example, view)


def check_nothing_chosen():
    """In a script a filter is made before its input has been computed: its menus of arrays are empty then."""
    def globe():
        every_third = pvs.ExtractSubset(Input=pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0), VOI=[0, 10**6] * 3, SampleRateI=3, SampleRateJ=3)
        return pvs.GlobeGrid(Input=every_third, VerticalExaggeration=30)

    def cells(proxy):
        proxy.UpdatePipeline()
        return proxy.GetDataInformation().GetNumberOfCells()

    for make in (pvs.CloudSurface, pvs.ContourCellSplitter):
        unknown = make(Input=globe())
        check(unknown.ContourBy[1] == "" and len(unknown.ContourValues) == 0, "there was something to choose")
        chosen = make(Input=globe(), ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.5])
        found, expected = cells(unknown), cells(chosen)
        check(found == expected > 0, f"{unknown.GetXMLName()}: {found} cells, with cloud_fraction at 0.5 {expected}")
        value = make(Input=globe(), ContourValues=[0.15])
        low = cells(make(Input=globe(), ContourBy=["POINTS", "cloud_fraction"], ContourValues=[0.15]))
        check(cells(value) == low != expected, "a contour value without an array")
    smoothed, before = pvs.StructuredSmoothing(Input=globe()), globe()
    for proxy in (smoothed, before):
        proxy.UpdatePipeline()
    after, first = (servermanager.Fetch(p).GetPointData() for p in (smoothed, before))
    for name, same in (("cloud_fraction", False), ("clwmr", True)):
        check(np.array_equal(*(vtk_to_numpy(data.GetArray(name)) for data in (after, first))) == same, f"{name}: smoothed? {same}")


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_nothing_chosen()
check_example()
passed()
