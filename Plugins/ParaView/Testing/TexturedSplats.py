# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured Splats: the first picture is sensible for any data, follows what the user sets and the time, and survives a state."""
import math
import os

import nephoscope  # noqa: F401: so that the mapper has its own methods in Python
import numpy as np
from FirstPictures import check_first_picture, check_first_pictures, check_units, solid_picture
from nephoscope_testing.messages import Messages
from PluginTesting import (OUTPUT, check, check_same, color_and_alpha, compose, image, load_plugin, look,
                           new_view, passed, pvs)

SPLATS = "Textured Splats"


def particles():
    points = pvs.PointSource(NumberOfPoints=2000, Radius=10)
    return pvs.Elevation(Input=points, LowPoint=[0, -10, 0], HighPoint=[0, 10, 0])


def check_alpha_formula():
    """Constant data on a lattice: alpha = 1 - exp(-opacity * scale * length / unit distance), to the flatness of the kernel."""
    view = new_view()
    source = pvs.Calculator(Input=pvs.Wavelet(), ResultArrayName="Value", Function="0.25")
    display = compose(source, view, ("POINTS", "Value"), SPLATS)
    pvs.GetColorTransferFunction("Value").RGBPoints = [0, 0, 0, 1, 1, 1, 0, 0]
    pvs.GetOpacityTransferFunction("Value").Points = [0, 0, 0.5, 0, 1, 1, 0.5, 0]
    display.TexturedSplatsAutomaticUnitDistance = 0
    view.CameraParallelProjection = 1
    look(view, position=(0, 0, 100))
    view.CameraParallelScale = 20
    for unit, scale, opacity in ((20.0, 1.0, 1.0), (5.0, 1.0, 1.0), (20.0, 6.0, 0.5)):
        display.TexturedSplatsUnitDistance = unit
        display.TexturedSplatsOpacityScale = scale
        display.Opacity = opacity
        found = color_and_alpha(view)[1][150, 150]
        expected = 1.0 - math.exp(-0.25 * scale * opacity * 20.0 / unit)  # 20 cells of edge 1
        check(abs(found - expected) < 2.5 / 255, f"unit {unit}, scale {scale}: alpha {found}, expected {expected}")


def check_bounds_hold_splats():
    """Few, large splats: reset to them, the camera sees all that is drawn."""
    view = new_view()
    compose(pvs.Wavelet(WholeExtent=[-1, 1, -1, 1, -1, 1]), view, representation=SPLATS)
    pvs.ResetCamera(view)
    alpha = color_and_alpha(view)[1]
    border = np.concatenate([alpha[0], alpha[-1], alpha[:, 0], alpha[:, -1]])
    check(alpha.max() > 0.2 and border.max() < 1.5 / 255, f"splats reach the border of the picture: {border.max()}")


def flow(half=6):
    return pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-half, half] * 3), ResultArrayName="Flow", Function="-coordsY*iHat+coordsX*jHat")


def check_vectors_and_time(source):
    view = new_view((200, 200))
    display = compose(source, view, representation=SPLATS)
    look(view, position=(0, 0, 60))
    plain = image(view)
    check("Flow" in display.GetProperty("TexturedSplatsVectorArray").GetAvailable(), "Flow is not among the vectors")
    check("RTData" not in display.GetProperty("TexturedSplatsVectorArray").GetAvailable(), "a scalar is among the vectors")
    display.TexturedSplatsVectorArray = "Flow"
    display.TexturedSplatsUseVectorColor = 1
    display.TexturedSplatsVectorColor = [0, 0, 0]
    for style in ("Segments", "Streaks"):
        display.TexturedSplatsVectorStyle = style
        start = image(view)
        check(np.abs(start - plain).max() > 20, f"no {style}")
        view.ViewTime = 0.25
        moved = image(view)
        check(np.abs(start - moved).max() > 20, f"{style} do not move with the time")
        view.ViewTime = 1.0
        check_same(start, image(view), f"a whole loop of {style}")
        view.ViewTime = 0.0
    pvs.GetAnimationScene().AnimationTime = 0.25
    check_same(moved, image(view), "the time of the animation")
    pvs.GetAnimationScene().AnimationTime = 0.0
    display.TexturedSplatsMoveWithTime = 0
    display.TexturedSplatsPhase = 0.25
    check_same(moved, image(view), "phase instead of time")
    check_true_speed(view, display)
    return view, display


def check_few_steps():
    """A series of so few steps that a whole number of periods would fit between two of them: streaks move from each to the next."""
    for number in (2, 3, 5):
        steps = f"times = [{', '.join(str(10.0 * i) for i in range(number))}]\ninformation = self.GetOutputInformation(0)\n"
        series = pvs.ProgrammableFilter(Input=flow(), CopyArrays=1, Script="", RequestInformationScript=steps + "for key, values in "
                                        "((self.GetExecutive().TIME_STEPS(), times), (self.GetExecutive().TIME_RANGE(), [times[0], times[-1]])):\n    information.Set(key, values, len(values))")
        view = new_view((200, 200))
        display = compose(series, view, representation=SPLATS)
        look(view, position=(0, 0, 60))
        display.TexturedSplatsVectorArray = "Flow"
        pictures = []
        for step in range(number):
            view.ViewTime = 10.0 * step
            pictures.append(image(view))
        for step, (before, after) in enumerate(zip(pictures, pictures[1:])):
            moved = (np.abs(after - before).max(axis=2) > 10).mean()
            check(moved > 0.05, f"{number} steps: from step {step} on {moved:.1%} of the picture change")
        pvs.Delete(view)


def check_true_speed(view, display):
    """The way depends on the time and its scale; a whole loop is not the start; the key has words of its own."""
    display.TexturedSplatsPhase = 0
    start = image(view)
    display.TexturedSplatsTrueSpeed = 1
    check_same(start, image(view), "true speed without motion")
    display.TexturedSplatsMoveWithTime = 1
    for scale in (0, 0.1):
        display.TexturedSplatsTimeScale = scale
        view.ViewTime = 0.5
        moved = image(view)
        check(np.abs(start - moved).max() > 20, f"no motion with the time scale {scale}")
    display.TexturedSplatsTimeScale = 0.2
    view.ViewTime = 0.25
    check_same(moved, image(view), "twice the time scale for half the time")
    display.TexturedSplatsShowSpeedKey = 1
    display.TexturedSplatsSpeedUnit = "m/s"
    changed = np.abs(image(view) - moved).max(axis=2) > 20
    check(changed.any(), "no speed key")
    rows, columns = np.nonzero(changed)
    check(0.1 < columns.min() / changed.shape[1] < 0.4, "the speed key is not beside the axes")
    metres = image(view)
    display.TexturedSplatsLengthUnit = 1000
    check(np.abs(image(view) - metres).max() > 20, "the speed key of kilometres is that of metres")
    display.TexturedSplatsLengthUnit = 1
    check_same(metres, image(view), "speed key of metres again")
    display.TexturedSplatsShowSpeedKey = 0
    check_same(moved, image(view), "speed key off again")
    display.TexturedSplatsLengthUnit, display.TexturedSplatsTimeScale = 1000, 200
    check_same(moved, image(view), "the time scale of data in kilometres")
    display.TexturedSplatsLengthUnit, display.TexturedSplatsTimeScale = 1, 0.2
    display.TexturedSplatsTrueSpeed = 0
    view.ViewTime = 0.0


def check_sizes():
    """An array of sizes, or of volumes, gives the picture of the size itself; a larger one reaches further."""
    source = pvs.Calculator(Input=particles(), ResultArrayName="Edge", Function="0.5")
    source = pvs.Calculator(Input=source, ResultArrayName="Volume", Function="0.125")
    view = new_view()
    display = compose(source, view, ("POINTS", "Elevation"), SPLATS)
    look(view)
    display.TexturedSplatsAutomaticUnitDistance = 0
    display.TexturedSplatsUnitDistance = 0.1
    mean_spacing = image(view)
    display.TexturedSplatsCellSize = 0.5
    expected = image(view)
    check(np.abs(expected - mean_spacing).max() > 20, "Cell Size does not arrive")
    display.TexturedSplatsCellSize = 0
    display.TexturedSplatsCellSizeArray = "Edge"
    check_same(expected, image(view), "array of edges")
    display.TexturedSplatsCellSizeArray = "Volume"
    display.TexturedSplatsCellSizeArrayHoldsVolumes = 1
    check_same(expected, image(view), "array of volumes", largest=1, mean=0.01)
    display.TexturedSplatsCellSizeArray = "None"
    check_same(mean_spacing, image(view), "without the array again")


def check_vector_colors(source):
    """An array alone colours the vectors, from blue to red; a colour map takes its place, and can be taken away again."""
    view = new_view()
    display = compose(source, view, representation=SPLATS)
    pvs.GetOpacityTransferFunction("RTData").Points = [0, 0, 0.5, 0, 300, 0, 0.5, 0]  # vectors alone
    look(view, position=(0, 0, 100))
    display.TexturedSplatsVectorArray = "Flow"
    display.TexturedSplatsVectorColorArray = "Flow"  # slow in the middle, fast around
    by_speed = image(view)
    middle, left = by_speed[140:160, 140:160].mean(axis=(0, 1)), by_speed[120:180, 95:110].mean(axis=(0, 1))
    check(middle[2] > 1.5 * middle[0] and left[0] > 1.2 * left[2], f"slow {middle}, fast {left}: not from blue to red")
    display.TexturedSplatsVectorLookupTable = pvs.GetColorTransferFunction("Green", RGBPoints=[0, 0, 1, 0, 1, 0, 1, 0])
    green = image(view)
    check(green[:, :, 1].max() > 50 > 1 > green[:, :, [0, 2]].max(), "the colour map does not arrive")
    display.TexturedSplatsVectorLookupTable = None
    check_same(by_speed, image(view), "without the colour map again")


def mapper_of(view):
    """The mapper of the only splats of a view; other representations have volumes there too."""
    volumes = view.SMProxy.GetRenderer().GetVolumes()
    mappers = [volumes.GetItemAsObject(i).GetMapper() for i in range(volumes.GetNumberOfItems())]
    return next(m for m in mappers if m and m.IsA("vtkTexturedSplatMapper"))


def check_hierarchy_and_radius():
    view = new_view()
    display = compose(pvs.Wavelet(), view, representation=SPLATS)
    look(view)
    exact, mapper = image(view), mapper_of(view)
    samples = mapper.GetNumberOfSamples()
    check(mapper.GetNumberOfDrawnSplats() == samples, f"{mapper.GetNumberOfDrawnSplats()} splats of {samples} samples")
    drawn = []
    for tolerance, unit, measure in ((0.1, "Of the Image", "Greatest"), (0.1, "Of the Image", "Root Mean Square"),
                                     (0.1, "Of the Data", "Greatest")):
        display.TexturedSplatsErrorTolerance = tolerance
        display.TexturedSplatsErrorToleranceUnit = unit
        display.TexturedSplatsErrorMeasure = measure
        difference = np.abs(image(view) - exact)
        drawn.append(mapper.GetNumberOfDrawnSplats())
        print(f"tolerance {tolerance} {unit}, {measure}: {drawn[-1]} splats, mean difference {difference.mean():.2f} of 255", flush=True)
        check(0 < difference.mean() < 6, "the tolerance changes nothing, or too much")
    check(len(set(drawn)) == 3 and drawn[1] < drawn[0] < samples, f"unit or measure does not arrive: {drawn}")
    display.TexturedSplatsErrorTolerance = 0
    display.TexturedSplatsInteractiveMaximumNumberOfSplats = 1000
    view.SMProxy.InteractiveRender()
    moving = mapper.GetNumberOfDrawnSplats()
    check(0 < moving <= 1000, f"{moving} splats while the camera moves")
    check_same(exact, image(view), "still again")
    alpha = color_and_alpha(view)[1]
    display.TexturedSplatsRadiusFactor = 1.5
    wider = color_and_alpha(view)[1]
    check(abs(wider[150, 150] - alpha[150, 150]) < 0.03 and (wider > 0.02).sum() > 1.02 * (alpha > 0.02).sum(),
          "a wider splat must blur the outline and leave the middle as opaque")
    display.TexturedSplatsRadiusFactor = 1
    check_same(exact, image(view), "radius factor back at 1")


def check_beside_translucent_surface():
    """A translucent surface elsewhere in the view leaves the splats as they are."""
    view = new_view()
    compose(pvs.Wavelet(), view, ("POINTS", "RTData"), SPLATS)
    look(view, position=(0, 0, 100))
    alone = image(view)
    sheet = pvs.Plane(Origin=[14, -4, 0], Point1=[24, -4, 0], Point2=[14, 4, 0])
    display = pvs.Show(sheet, view)
    display.Opacity = 0.5
    beside = image(view)
    same = np.abs(beside.astype(int) - alone).max(axis=2) <= 3
    middle = same[:, 90:210]
    check(middle.mean() > 0.99 and same.mean() < 0.995, f"beside a surface: {middle.mean():.3f} of the splats as they were")


def check_reports():
    """What mappers report reaches the output window, which ParaView shows: once, not with every picture."""
    source = pvs.ProgrammableFilter(Input=pvs.Wavelet())
    source.Script = ("values = inputs[0].PointData['RTData'].astype(float)\nvalues[:50] = float('nan')\n"
                     "output.PointData.append(values, 'holes')")
    for representation, samples in ((SPLATS, "50 points"), ("Cell Compositing", "48 cells")):
        view = new_view()
        with Messages() as messages:
            compose(source, view, ("POINTS", "holes"), representation)
            look(view)
            check(image(view).mean() > 5, "nothing is drawn")
            image(view)
        check(not messages.errors and len(messages.warnings) == 1 and f"{samples} are not drawn because array 'holes'" in messages.warnings[0],
              f"{representation} reports {messages.all}")


def check_state():
    check_vectors_and_time(flow())
    before = image(pvs.GetActiveView())
    state = os.path.join(OUTPUT, "TexturedSplats.pvsm")
    pvs.SaveState(state)
    pvs.ResetSession()
    load_plugin()
    pvs.LoadState(state)
    for view in pvs.GetViews():
        found = [r for r in view.Representations if getattr(r, "TexturedSplatsVectorArray", "None") == "Flow"]
        if found:
            check(found[0].Representation == SPLATS, f"came back as {found[0].Representation}")
            check_same(before, image(view), "state file")
            return
    check(False, "the display did not come back")


load_plugin()
check_state()  # first: data with times of their own would set the range of the animation
wavelet = pvs.Wavelet()
check_first_pictures(SPLATS, wavelet)
check_first_picture(SPLATS, "blocks", pvs.GroupDatasets(Input=[wavelet, pvs.Tetrahedralize(Input=wavelet)]))
check_first_picture(SPLATS, "particles", particles(), ("POINTS", "Elevation"))
check_units(SPLATS, "image", pvs.Wavelet())
check_units(SPLATS, "particles", particles(), ("POINTS", "Elevation"))
check_alpha_formula()
solid_picture(SPLATS, particles())
check_bounds_hold_splats()
check_hierarchy_and_radius()
check_vector_colors(flow(10))
check_sizes()
check_beside_translucent_surface()
check_few_steps()
check_reports()
passed()
