# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A grid in blocks looks as the whole one does, and rain that is 0 everywhere is no rain; nothing set."""
import numpy as np
from PluginTesting import check, compose, image, listen, load_plugin, new_view, passed, pvs
from paraview.servermanager import Fetch

SIZE = [120, 90]
CELLS, PARTS = 12, 4


def wavelet():
    return pvs.Wavelet(WholeExtent=[0, CELLS] * 2 + [0, 6], Center=[CELLS / 2] * 2 + [3])


def in_blocks(whole, steps=PARTS):
    width = CELLS // steps
    return pvs.GroupDatasets(Input=[pvs.ExtractSubset(Input=whole, VOI=[i * width, (i + 1) * width, j * width, (j + 1) * width, 0, 6])
                                    for i in range(steps) for j in range(steps)])


def scalars_of(source):
    data = Fetch(pvs.MergeBlocks(Input=source))
    array = data.GetPointData().GetArray("RTData")
    return np.array([array.GetValue(i) for i in range(array.GetNumberOfTuples())])


def picture(source, representation, array):
    view = new_view(SIZE)
    display = compose(source, view, array, representation)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [20, -18, 16], [CELLS / 2, CELLS / 2, 3], [0, 0, 1]
    pvs.Render(view)
    return view, display, image(view).astype(float)


def check_contour_value():
    """One value for all blocks, that of the whole grid, made before there are data."""
    value = scalars_of(pvs.CloudSurface(Input=wavelet()))
    blocks = scalars_of(pvs.CloudSurface(Input=in_blocks(wavelet())))
    check(np.ptp(value) == 0 and np.ptp(blocks) == 0 and blocks[0] == value[0], f"values {set(value)} and {set(blocks)}")


def check_splats():
    """No bright bands where blocks abut: as the whole grid, in cells of no grid as the blocks are."""
    whole = wavelet()
    _, _, expected = picture(pvs.AppendDatasets(Input=[whole]), "Textured Splats", ("POINTS", "RTData"))
    _, _, found = picture(in_blocks(whole), "Textured Splats", ("POINTS", "RTData"))
    worst = abs(found - expected).max()
    check(worst <= 3, f"splats of blocks differ by {worst} of 255")


def check_arrays_of_some(messages):
    """Blocks without the coloured array are not drawn, and named in one sentence; the others are, as they are alone."""
    half = pvs.ExtractSubset(registrationName="with", Input=wavelet(), VOI=[0, 5, 0, CELLS, 0, 6])
    other = pvs.ExtractSubset(Input=wavelet(), VOI=[7, CELLS, 0, CELLS, 0, 6])
    other = pvs.Calculator(Input=other, ResultArrayName="X", Function="coordsX")
    other = pvs.PassArrays(registrationName="without", Input=other, PointDataArrays=["X"])
    for representation in ("Cell Compositing", "Textured Splats"):
        _, display, expected = picture(half, representation, ("POINTS", "RTData"))
        for blocks in ([half, other], [other, half]):
            messages.clear()
            view, display, found = picture(pvs.GroupDatasets(Input=blocks), representation, ("POINTS", "RTData"))
            worst = abs(found - expected).max()
            check(worst <= 3, f"{representation}: the block with the array differs by {worst} of 255 from what it is alone")
            check(len(messages) == 1 and "Block 'without' is not drawn" in messages[0] and "'RTData'" in messages[0], f"{representation}: {messages}")
            messages.clear()
            pvs.ColorBy(display, None)
            shown = (abs(image(view) - image(view)[0, 0]).max(axis=2) > 8).sum()
            alone = (abs(expected - expected[0, 0]).max(axis=2) > 8).sum()
            check(shown > 1.5 * alone and not messages, f"{representation}: Solid Color draws {shown} pixels, one block {alone}: {messages}")


STEPS = """
times = [0.0, 2.5, 4.0]
information = self.GetOutputInformation(0)
information.Set(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS(), times, 3)
information.Set(vtk.vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [times[0], times[-1]], 2)
information.Set(vtk.vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), [0, 4] * 3, 6)
"""
STEP = """
time = self.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
self.GetOutput().SetDimensions(5, 5, 5)
array = vtk.vtkFloatArray()
array.SetName("other" if time == 2.5 else "a")
for p in range(125):
    array.InsertNextValue(p)
self.GetOutput().GetPointData().AddArray(array)
self.GetOutput().GetInformation().Set(vtk.vtkDataObject.DATA_TIME_STEP(), time)
"""


def check_step_without_array(messages):
    """A step of a series that lacks the coloured array is told each time, with its time and what is drawn."""
    for representation in ("Cell Compositing", "Textured Splats"):
        series = pvs.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=STEPS, Script=STEP)
        view, _, _ = picture(series, representation, ("POINTS", "a"))
        messages.clear()
        for time in (0.0, 2.5, 4.0, 2.5):
            view.ViewTime = time
            image(view)
        told = ["no array 'a' at time 2.5: they are drawn in one colour" in one for one in messages]
        check(told == [True, True], f"{representation}: {messages}")
        messages.clear()
        pvs.Delete(view)


def check_types():
    """One block has another type: both are drawn."""
    halves = [pvs.Calculator(Input=pvs.ExtractSubset(Input=wavelet(), VOI=[0, 6, 0, CELLS, 0, 6] if i == 0 else [6, CELLS, 0, CELLS, 0, 6]),
                             ResultArrayName="p", Function="RTData", ResultArrayType=kind) for i, kind in enumerate(("Float", "Double"))]
    view, _, _ = picture(pvs.GroupDatasets(Input=halves), "Cell Compositing", ("POINTS", "p"))
    _, _, expected = picture(pvs.Calculator(Input=wavelet(), ResultArrayName="p", Function="RTData"), "Cell Compositing", ("POINTS", "p"))
    worst = abs(image(view).astype(float) - expected).max()
    check(worst <= 3, f"blocks of two types differ by {worst} of 255")


def check_no_rain():
    for name, is_drawn in (("rain", False), ("cloud_fraction", False), ("anything", True)):
        source = pvs.Calculator(Input=wavelet(), ResultArrayName=name, Function="0*coordsX")
        for representation in ("Cell Compositing", "Textured Splats"):
            view, display, _ = picture(source, representation, ("POINTS", name))
            pixels = image(view).reshape(-1, 3).astype(float)
            drawn = pixels[abs(pixels - pixels[0]).max(axis=1) > 8]
            share = len(drawn) / len(pixels)
            check((share > 0.05) == is_drawn, f"{name} of 0, by {representation}: {share:.1%} of the picture show anything")
            if is_drawn:  # in the first colour of its map, which is blue, and not in the last
                check(drawn[:, 2].mean() > drawn[:, 0].mean(), f"0 has the last colour of {display.LookupTable.RGBPoints[:4]}")


load_plugin()
pvs._DisableFirstRenderCameraReset()
check_contour_value()
check_splats()
told = listen()
check_arrays_of_some(told)
check_step_without_array(told)
check_types()
check_no_rain()
passed()
