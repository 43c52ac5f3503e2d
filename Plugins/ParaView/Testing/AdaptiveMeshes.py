# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""AMR data, hyper tree grids and explicit structured grids are drawn like the image data that fills the same space.

A constant medium has one picture, whatever cells it is divided into: nothing missing, nothing twice where levels overlap. Splats
smooth the medium over cells of different sizes: they have the same place and about the same optical depth.
"""
import numpy as np
from PluginTesting import NAME, check, check_same, color_and_alpha, load_plugin, new_view, passed, pvs, solid
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImageDataToExplicitStructuredGrid
from vtkmodules.vtkFiltersSources import vtkRandomHyperTreeGridSource

SPLATS = "Textured Splats"


def producer(data):
    made = pvs.TrivialProducer()
    made.GetClientSideObject().SetOutput(data)
    made.UpdatePipeline()
    return made


def box(bounds, cells=8):
    data = vtkImageData()
    data.SetDimensions(cells + 1, cells + 1, cells + 1)
    data.SetOrigin(bounds[::2])
    data.SetSpacing([(high - low) / cells for low, high in zip(bounds[::2], bounds[1::2])])
    return data


def explicit(bounds):
    convert = vtkImageDataToExplicitStructuredGrid()
    convert.SetInputData(box(bounds))
    convert.Update()
    return convert.GetOutput()


def hyper_tree_grid():
    source = vtkRandomHyperTreeGridSource()
    source.SetDimensions(4, 4, 4)
    source.SetMaxDepth(3)
    source.SetSplitFraction(0.4)
    if hasattr(source, "SetMaskedFraction"):  # from VTK 9.3 on
        source.SetMaskedFraction(0.0)
    source.Update()
    return source.GetOutputDataObject(0)


def picture(source, bounds, representation, eye):
    """Colour and alpha of a constant medium, seen from a fixed eye."""
    view = new_view((120, 120))
    display = pvs.Show(source, view)
    offered = display.GetProperty("Representation").GetAvailable()
    check(representation in offered, f"{representation} is not offered: {offered}")
    display.SetRepresentationType(representation)
    solid(display, [1, 0.5, 0.25])
    size = np.subtract(bounds[1::2], bounds[::2])
    prefix = representation.replace(" ", "")
    setattr(display, prefix + "AutomaticUnitDistance", 0)
    setattr(display, prefix + "UnitDistance", float(size.max()) / 4)
    centre = np.add(bounds[1::2], bounds[::2]) / 2
    view.CameraFocalPoint, view.CameraPosition = list(centre), list(centre + np.array(eye) * size.max())
    view.CameraViewUp, view.CameraViewAngle = [0, 1, 0], 30
    drawn = color_and_alpha(view)
    pvs.Delete(display)
    pvs.Delete(view)
    return drawn


def check_like_image(kind, source):
    source.UpdatePipeline()
    bounds = source.GetDataInformation().GetBounds()
    reference = producer(box(bounds))
    for eye in ((1.3, 1.1, 2.4), (0.2, -0.3, 3.1)):
        color, _ = picture(source, bounds, NAME, eye)
        expected, expected_alpha = picture(reference, bounds, NAME, eye)
        check(expected_alpha.max() > 0.5, "the reference is empty")
        check_same(color, expected, f"{kind} as cells from {eye}", largest=3, mean=0.1)
        alpha = picture(source, bounds, SPLATS, eye)[1]
        expected_alpha = picture(reference, bounds, SPLATS, eye)[1]
        print(f"{kind} as splats: mean opacity {alpha.mean():.4f}, of an image {expected_alpha.mean():.4f}", flush=True)
        # The edge of a medium is as soft as its cells are large.
        check(0.5 < alpha.mean() / expected_alpha.mean() < 1.2, f"splats of {kind}")


def framed(source, array, representation):
    """After Reset Camera: the share of the height of the picture, or of its width, that what is drawn extends over; and the greatest opacity at its border."""
    view = new_view((120, 120))
    display = pvs.Show(source, view)
    display.SetRepresentationType(representation)
    if array:
        pvs.ColorBy(display, array)
    pvs.Render(view)
    pvs.ResetCamera(view)
    alpha = color_and_alpha(view)[1]
    pvs.Delete(view)
    shown = [np.flatnonzero((alpha > 0.02).any(axis=axis)) for axis in (0, 1)]
    border = max(alpha[0].max(), alpha[-1].max(), alpha[:, 0].max(), alpha[:, -1].max())
    return max(np.ptp(each) + 1 if each.size else 0 for each in shown) / 120, border


def check_frame():
    """The camera frames splats of large cells, all that is seen of them, about as it frames the cells; and a single splat."""
    image = pvs.Wavelet(WholeExtent=[0, 2] * 3)
    sources = {
        "hyper tree grid": (producer(hyper_tree_grid()), ("CELLS", "Depth")),
        "image": (image, ("POINTS", "RTData")),
        "hexahedra": (pvs.AppendDatasets(Input=[image]), ("POINTS", "RTData")),
        "cells of an image": (pvs.PointDatatoCellData(Input=image), ("CELLS", "RTData")),
        "sheet": (pvs.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 0]), ("POINTS", "RTData")),
        "line": (pvs.Wavelet(WholeExtent=[0, 5, 0, 0, 0, 0]), ("POINTS", "RTData")),
        "one point": (pvs.PointSource(NumberOfPoints=1), None),
    }
    for what, (source, array) in sources.items():
        share, border = framed(source, array, SPLATS)
        cells = framed(source, array, "Surface")[0] if what not in ("line", "one point") else 0.5
        print(f"{what}: splats extend over {share:.2f} of the picture, a surface over {cells:.2f}; opacity at the border {border:.3f}", flush=True)
        check(share > 0.85 * cells, f"splats of {what} are small after Reset Camera: {share:.2f} of the picture, {cells:.2f} as a surface")
        check(border < 0.02, f"splats of {what} are cut at the border of the picture after Reset Camera: opacity {border:.3f}")


def check_flat():
    """Cell Compositing is not offered for 2-D meshes."""
    for dimension in (2, 3):
        view = new_view((40, 40))
        offered = pvs.Show(pvs.AMRGaussianPulseSource(Dimension=dimension), view).GetProperty("Representation").GetAvailable()
        check((NAME in offered) == (dimension == 3) and SPLATS in offered, f"AMR data in {dimension} dimensions: {offered}")
        pvs.Delete(view)


if __name__ == "__main__":
    load_plugin()
    pvs._DisableFirstRenderCameraReset()
    check_like_image("explicit structured grid", producer(explicit((0, 2, -1, 1, 3, 5))))
    check_like_image("AMR data", pvs.AMRGaussianPulseSource())
    check_like_image("hyper tree grid", producer(hyper_tree_grid()))
    check_frame()
    check_flat()
    passed()
