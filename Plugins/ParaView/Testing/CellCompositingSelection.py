# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Selection of cells and points on the screen, as *Select Cells On* and *Hover Cells On* do it, finds what is seen of the volume."""
from paraview.selection import SelectSurfaceCells, SelectSurfacePoints
from PluginTesting import check, compose, load_plugin, new_view, passed, pvs

SIZE = [120, 90]


def wavelet():
    return pvs.Wavelet(WholeExtent=[0, 6, 0, 6, 0, 6], Center=[3, 3, 3])


def shown(source):
    view = new_view(SIZE)
    display = compose(source, view, ("POINTS", "RTData"))
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [3, 3, 25], [3, 3, 3], [0, 1, 0]
    pvs.Render(view)
    return view, display


def selected(source, select, view, rectangle):
    """Numbers (component, or (block, process, number)) of the selection of the source."""
    pvs.ClearSelection(source)
    select(Rectangle=rectangle, View=view)
    selection = source.SMProxy.GetSelectionInput(0)
    if not selection:
        return []
    return [number for one in pvs.servermanager._getPyProxy(selection).Input for number in one.IDs]


def check_kinds():
    grids = {"image": wavelet, "unstructured": lambda: pvs.AppendDatasets(Input=[wavelet()])}
    for name, make in grids.items():
        source = make()
        view, _ = shown(source)
        ids = selected(source, SelectSurfaceCells, view, [60, 45, 60, 45])
        print(name, "cells", ids)
        check(len(ids) == 2 and 0 <= ids[1] < 216, f"{name}: cells {ids}")
        ids = selected(source, SelectSurfacePoints, view, [60, 45, 60, 45])
        print(name, "points", ids)
        check(len(ids) == 2 and 0 <= ids[1] < 343, f"{name}: points {ids}")
        wide = selected(source, SelectSurfaceCells, view, [30, 20, 90, 70])
        check(len(wide) > 20, f"{name}: cells of a rectangle {wide}")
        pvs.Hide(source, view)


def check_blocks():
    whole = wavelet()
    halves = [pvs.ExtractSubset(Input=whole, VOI=[0, 3, 0, 6, 0, 6]), pvs.ExtractSubset(Input=whole, VOI=[3, 6, 0, 6, 0, 6])]
    blocks = pvs.GroupDatasets(Input=halves)
    view, _ = shown(blocks)
    for column, index in ((45, 1), (75, 2)):
        ids = selected(blocks, SelectSurfaceCells, view, [column, 45, column, 45])
        print("block", ids)
        check(len(ids) == 3 and ids[0] == index, f"block {index}: {ids}")
    check(selected(blocks, SelectSurfacePoints, view, [45, 45, 45, 45]) == [], "points that blocks share")


load_plugin()
check_kinds()
check_blocks()
passed()
