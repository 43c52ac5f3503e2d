# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""An input that a filter cannot use: one message, with the remedy, however often the pipeline asks, and an empty result."""
import re

from PluginTesting import check, clear, empty_view, listen, load_plugin, passed, pvs, show_twice
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

FILTERS = ("GlobeGrid", "FlowVolume", "SmokePuffs", "CloudSurface", "StructuredSmoothing", "ContourCellSplitter", "PolyhedrontoTetrahedra",
           "TextureCoordinateAdvection", "CloudOptics", "Sunlight")
GRIDS = "an image, a rectilinear or a structured grid"
# What is said of which input; where nothing is written, nothing is wrong.
LIGHT = {"CloudOptics": "water", "Sunlight": "There is no array 'Extinction'"}
TREE = "Apply HyperTreeGrid To UnstructuredGrid first"
NO_VELOCITY, NO_VOLUME, EMPTY = "no velocity", "no cells with a volume", "empty|no cells|no points"
EXPECTED = {
    "an image": {"GlobeGrid": "heights run from|no wind arrays", "FlowVolume": NO_VELOCITY, "SmokePuffs": "is an image. .*Connect a flow volume",
                 "TextureCoordinateAdvection": NO_VELOCITY, **LIGHT},
    "a surface": {"GlobeGrid": GRIDS, "FlowVolume": NO_VOLUME, "SmokePuffs": "is a surface or points", "CloudSurface": GRIDS, "StructuredSmoothing": GRIDS,
                  "ContourCellSplitter": "no point array", "TextureCoordinateAdvection": NO_VOLUME, **LIGHT},
    "tetrahedra": {**dict.fromkeys(("GlobeGrid", "CloudSurface", "StructuredSmoothing"), GRIDS + ". Apply Resample To Image first"), "FlowVolume": NO_VELOCITY, "SmokePuffs": "'Density'",
                   "TextureCoordinateAdvection": NO_VELOCITY, **LIGHT},
    "blocks": {"GlobeGrid": ".", "FlowVolume": "No block", "SmokePuffs": "flow volume", "CloudSurface": GRIDS, "StructuredSmoothing": ".",
               "TextureCoordinateAdvection": "one grid", **LIGHT},
    "a hyper tree grid": {**dict.fromkeys(("GlobeGrid", "CloudSurface", "StructuredSmoothing"), TREE + ", then Resample To Image"),
                          **dict.fromkeys(("FlowVolume", "TextureCoordinateAdvection", "ContourCellSplitter", "PolyhedrontoTetrahedra", "CloudOptics", "Sunlight"), TREE), "SmokePuffs": "Connect a flow volume"},
    "nothing": {"GlobeGrid": GRIDS, "FlowVolume": EMPTY, "CloudSurface": GRIDS, "StructuredSmoothing": GRIDS, "TextureCoordinateAdvection": EMPTY,
                **dict.fromkeys(("SmokePuffs", "ContourCellSplitter", "PolyhedrontoTetrahedra", "CloudOptics", "Sunlight"), "The input is empty")},
}
MOST = {("GlobeGrid", "an image"): 2, ("GlobeGrid", "blocks"): 4, ("SmokePuffs", "blocks"): 2, ("StructuredSmoothing", "blocks"): 2}


def kinds():
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    return {"an image": wavelet, "a surface": pvs.Sphere(), "tetrahedra": pvs.Tetrahedralize(Input=wavelet),
            "blocks": pvs.GroupDatasets(Input=[wavelet, pvs.Sphere()]),
            "a hyper tree grid": pvs.RandomHyperTreeGrid() if hasattr(pvs, "RandomHyperTreeGrid") else pvs.HyperTreeGridRandom(),
            "nothing": pvs.Threshold(Input=wavelet, Scalars=["POINTS", "RTData"], LowerThreshold=1e9, UpperThreshold=2e9)}


def ask_often(result, render):
    """The pipeline, as a session does."""
    for _ in range(2):
        render()
        result.UpdatePipeline()
        result.GetDataInformation().GetNumberOfPoints()


def show_often(result):
    view = empty_view((40, 40))
    pvs.Show(result, view)
    ask_often(result, lambda: pvs.Render(view))
    clear(view)


def check_filter(name, kind, source, messages):
    messages.clear()
    result = getattr(pvs, name)(Input=source)
    if kind in ("an image", "nothing"):
        show_often(result)
    else:  # without a display, which takes most of the time
        ask_often(result, lambda: None)
    what, expected = f"{name} of {kind}", EXPECTED[kind].get(name)
    told = [message.split("): ", 1)[-1].strip() for message in messages]
    check(len(told) <= (MOST.get((name, kind), 1) if expected else 0), f"{what}: {len(told)} messages: {messages}")
    check(not expected or any(re.search(expected, text) for text in told), f"{what}: {told}, not {expected!r}")
    for text in messages:
        check("vtkExecutive" not in text and "from null" not in text, f"{what}: {text}")
    pvs.Delete(result)


def check_representation(name, source, messages):
    messages.clear()
    view = empty_view((40, 40))
    pvs.Show(source, view).SetRepresentationType(name)
    for _ in range(3):
        pvs.Render(view)
    check(len(messages) == 1 and "Nothing is drawn. The input is empty" in messages[0], f"{name} of nothing: {messages}")
    clear(view)


def check_missing_array(name, messages):
    """A calculator that failed, or a name in a script: the medium is of one colour, and one message says why."""
    messages.clear()
    view = empty_view((40, 40))
    display = pvs.Show(pvs.Wavelet(WholeExtent=[-4, 4] * 3), view)
    display.SetRepresentationType(name)
    display.ColorArrayName = ["POINTS", "gone"]
    for _ in range(3):
        pvs.Render(view)
    check(len(messages) == 1 and "no array 'gone'" in messages[0], f"{name} of a missing array: {messages}")
    clear(view)


def check_contours_of_cells(messages):
    """A cell array has no surfaces inside cells; the panel offers contour values all the same."""
    messages.clear()
    view, cells = empty_view((40, 40)), pvs.PointDatatoCellData(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3))
    display = pvs.Show(cells, view)
    display.SetRepresentationType("Cell Compositing")
    pvs.ColorBy(display, ("CELLS", "RTData"))
    for _ in range(2):
        pvs.Render(view)
    check(not messages, f"cells without contours: {messages}")
    display.CellCompositingContourValues = [150.0]
    for _ in range(3):
        pvs.Render(view)
    check(len(messages) == 1 and "apply Cell Data to Point Data" in messages[0], f"contours of a cell array: {messages}")
    clear(view)


def check_contour_values(messages):
    """Values that belong to another array, or to none: told once, in the words of the panel, and not for values of which some are there."""
    source = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3), ResultArrayName="x", Function="coordsX")
    view = empty_view((40, 40))
    display = pvs.Show(source, view)
    display.SetRepresentationType("Cell Compositing")
    pvs.ColorBy(display, ("POINTS", "RTData"))
    display.CellCompositingContourValues = [150.0, 1000.0]
    messages.clear()
    for expected in ((), ("150, 1000 of 'x'", "-4 to 4")):
        for _ in range(3):
            pvs.Render(view)
        check(len(messages) == bool(expected) and all(words in messages[0] for words in expected), f"contour values that 'x' does not have: {messages}")
        pvs.ColorBy(display, ("POINTS", "x"))
    display.CellCompositingContourArray = "RTData"
    display.ColorArrayName = ["POINTS", ""]
    messages.clear()
    pvs.Render(view)
    check(not messages, f"an array to contour, and none to colour: {messages}")
    display.CellCompositingContourArray = "None"
    for _ in range(2):
        pvs.Render(view)
    check(len(messages) == 1 and "No array is coloured" in messages[0], f"nothing to contour: {messages}")
    clear(view)


def check_chain(made, expected, messages):
    """What comes after a filter that failed adds no reason of its own."""
    messages.clear()
    view = empty_view((40, 40))
    pvs.Show(made, view)
    for _ in range(2):
        pvs.Render(view)
    check(len(messages) == 1 and expected in messages[0], f"after a failure, not one message with {expected!r}: {messages}")
    clear(view)


def check_opacity(source, name, expected, messages):
    messages.clear()
    view = empty_view((40, 40))
    display = pvs.Show(source, view)
    display.SetRepresentationType("Cell Compositing")
    display.CellCompositingOpacityArray = name
    pvs.Render(view)
    check(len(messages) == 1 and expected in messages[0] and "Opacity Array" in messages[0] and "Coloring" not in messages[0], f"{name}: {messages}")
    clear(view)


def told_once(what, source, representation, expected, messages, **settings):
    """One message that has all the expected words; settings are those of the display."""
    messages.clear()
    show_twice(source, representation, **settings)
    check(len(messages) == 1 and all(word in messages[0] for word in expected), f"{what}: not one message with {expected}: {messages}")


def check_nothing_to_draw(messages):
    """What a representation cannot draw: one sentence, with the representation or the filter that helps."""
    surface = pvs.AppendDatasets(Input=[pvs.Sphere()])  # an unstructured grid
    told_once("a surface", surface, "Cell Compositing", ["Nothing is drawn: Cell Compositing needs 3-D cells", "Surface", "Delaunay 3D"], messages)
    flat = pvs.Transform(Input=pvs.Tetrahedralize(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3)))
    flat.Transform.Scale = [1, 1, 0]
    told_once("flat cells", flat, "Cell Compositing", ["Nothing is drawn: Cell Compositing needs 3-D cells"], messages)
    bare, grid = pvs.TrivialProducer(), vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    for i in range(20):
        grid.GetPoints().InsertNextPoint(i, 0, 0)
    bare.GetClientSideObject().SetOutput(grid)
    told_once("points without cells", bare, "Cloud Texture", ["Nothing is drawn: the input has 20 points but no polygons", "Textured Splats"],
              messages)
    told_once("points", pvs.PointSource(NumberOfPoints=20), "Cloud Texture", ["Nothing is drawn: the input has 20 points but no polygons", "Textured Splats"],
              messages)
    tree = pvs.RandomHyperTreeGrid() if hasattr(pvs, "RandomHyperTreeGrid") else pvs.HyperTreeGridRandom()
    told_once("a hyper tree grid", tree, "Cloud Texture", ["is a hyper tree grid, and its outer surface is drawn",
              "apply HyperTreeGrid To UnstructuredGrid, Cell Data to Point Data and Contour first"], messages)
    missing = pvs.Calculator(Input=pvs.Sphere(), ResultArrayName="nan", Function="sqrt(-1)", ReplacementValue=float("nan"))
    told_once("no values", missing, "Textured Splats", ["Nothing is drawn: 50 points are left out because array 'nan'"], messages,
              ColorArrayName=["POINTS", "nan"])
    told_once("no cover", missing, "Cloud Texture", ["Nothing is drawn: all values of the array \"nan\" for the cover"], messages,
              CloudTextureCoverageArrayName="nan")


def check_moved_slice(messages):
    """A slice, whose panel does not offer Cell Compositing: a script that chooses it is told once, not again in each place of the slice."""
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    for source in (pvs.Slice(Input=wavelet), pvs.ExtractSubset(Input=wavelet, VOI=[-4, 4, -4, 4, 0, 0])):
        messages.clear()
        view = empty_view((40, 40))
        pvs.Show(source, view).Representation = "Cell Compositing"
        pvs.Render(view)
        check(len(messages) == 1 and "Nothing is drawn: Cell Compositing needs 3-D cells" in messages[0], f"{source}: {messages}")
        if hasattr(source, "SliceType"):
            source.SliceType.Origin = [1, 0, 0]
        pvs.Render(view)
        check(len(messages) == 1, f"{source} in another place: {messages}")
        clear(view)


def check_first_picture(messages):
    """A new view draws its first picture twice, at first without peeling, which it is set to do: no warning."""
    view = pvs.CreateRenderView(ViewSize=[40, 40])
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    splats = pvs.Show(pvs.Gradient(Input=wavelet, ScalarArray=["POINTS", "RTData"]), view)
    splats.SetRepresentationType("Textured Splats")
    pvs.ColorBy(splats, ("POINTS", "RTData"))
    surface = pvs.Show(pvs.CloudSurface(Input=wavelet), view)
    surface.SetRepresentationType("Cloud Texture")
    splats.TexturedSplatsVectorArray, splats.Position, surface.Position = "Gradient", [10, 0, 0], [-10, 0, 0]
    messages.clear()
    pvs.Render(view)
    check(messages == [], f"first picture: {messages}")
    pvs.Delete(view)


def check_opacity_of_other_range(messages):
    """The function of the coloured array, 37 to 277, reads an array from 5 to 8."""
    source = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-4, 4] * 3), ResultArrayName="V", Function="5+0.1*(coordsX+4)+0.2*(coordsY+4)")
    for name in ("Cell Compositing", "Textured Splats"):
        messages.clear()
        view = empty_view((40, 40))
        display = pvs.Show(source, view)
        pvs.ColorBy(display, ("POINTS", "RTData"))
        display.SetRepresentationType(name)
        pvs.Render(view)
        check(messages == [], f"{name} before: {messages}")
        setattr(display, name.replace(" ", "") + "OpacityArray", "V")
        for _ in range(2):
            pvs.Render(view)
        check(len(messages) == 1 and "values of the opacity array 'V' (5 to 7.4)" in messages[0] and "GetOpacityTransferFunction('V')" in messages[0], f"{name}: {messages}")
        display.ScalarOpacityFunction = pvs.GetOpacityTransferFunction("V")
        messages.clear()
        pvs.Render(view)
        check(messages == [], f"{name} with a function: {messages}")
        clear(view)


def check_light(messages):
    """All that is missing at once; a block without extinction beside clouds is clear air, and named."""
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    told_once("no water", pvs.CloudOptics(Input=wavelet), None,
              ["no array of cloud water", "There is no temperature", "There is no pressure", "Point arrays: 'RTData'"], messages)
    water = pvs.Calculator(Input=wavelet, ResultArrayName="clwmr", Function="1e-4")
    told_once("water alone", pvs.CloudOptics(Input=water), None, ["There is no temperature", "There is no pressure", "'clwmr'"], messages)
    cloud = pvs.Calculator(Input=wavelet, ResultArrayName="Extinction", Function="0.03")
    pvs.RenameSource("air", air := pvs.Wavelet(WholeExtent=[6, 10, -4, 4, -4, 4]))
    lit = pvs.Sunlight(Input=pvs.GroupDatasets(Input=[cloud, air]))
    told_once("a clear block", lit, None, ["Block '", "no array 'Extinction'", "clear air"], messages)
    check(lit.PointData["Sunlight"].GetRange()[1] > 0, "there is no light")


def main():
    messages = listen()
    check_first_picture(messages)
    check_nothing_to_draw(messages)
    check_moved_slice(messages)
    check_contours_of_cells(messages)
    check_contour_values(messages)
    check_opacity_of_other_range(messages)
    check_light(messages)
    wavelet = pvs.Wavelet(WholeExtent=[-4, 4] * 3)
    check_chain(pvs.Sunlight(Input=pvs.CloudOptics(Input=wavelet)), "water", messages)
    lit = pvs.Sunlight(Input=pvs.Calculator(Input=wavelet, ResultArrayName="Extinction", Function="0.01"))
    lit.Sun = pvs.Sun(DateTime="2011-13-45")
    check_chain(lit, "2011-13-45", messages)
    check_opacity(wavelet, "nope", "No point or cell array named 'nope' for the opacity", messages)
    for name in ("Cell Compositing", "Textured Splats"):
        check_missing_array(name, messages)
    for kind, source in kinds().items():
        source.UpdatePipeline()
        for name in FILTERS:
            check_filter(name, kind, source, messages)
        if kind == "nothing":
            for name in ("Cell Compositing", "Textured Splats", "Cloud Texture"):
                check_representation(name, source, messages)


load_plugin()
pvs._DisableFirstRenderCameraReset()
main()
passed()
