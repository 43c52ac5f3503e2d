# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""With nothing set, cells are drawn with their trilinear field, unless most of them are tetrahedra; and what is seen of them follows every change.

References: the same with the interpolation set, and a new mapper after each change.
"""
import unittest

import numpy as np
from nephoscope_testing import meshes
from TestDividedHexahedra import listed
from nephoscope_testing.transfer import Transfer
from TestTrilinearCells import CLEAR_BELOW, COLOURS, VIEWS, Drawn, bent, shell, smooth, steep, tapered, turned, unstructured, with_values
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LINE, VTK_QUAD, VTK_VERTEX, VTK_WEDGE, vtkDataSetAttributes
from vtkmodules.vtkFiltersCore import vtkAppendFilter

TETRAHEDRA, TRILINEAR, AUTOMATIC = range(3)


def wedges():
    """Each hexahedron in two."""
    data = unstructured(with_values(tapered(), steep))
    cells = []
    for i in range(data.GetNumberOfCells()):
        p = [data.GetCell(i).GetPointId(k) for k in range(8)]
        cells += [(VTK_WEDGE, [p[k] for k in (0, 1, 2, 4, 5, 6)]), (VTK_WEDGE, [p[k] for k in (0, 2, 3, 4, 6, 7)])]
    result = meshes.grid(meshes.points_of(data), cells)
    result.GetPointData().ShallowCopy(data.GetPointData())
    return result


def corners(points):
    """1 at every second point, the farthest apart in a field along edges."""
    return np.floor(points / (0.1, 0.3, 0.3) + 0.01).astype(int).sum(axis=1) % 2


def mixture(hexahedra, divided):
    """Hexahedra in a row, and beside them others, each of which is five tetrahedra."""
    append = vtkAppendFilter()
    for count, first in ((hexahedra, 0), (divided, hexahedra)):
        if count:
            part = meshes.image((count, 1, 1), (0.1, 0.3, 0.3), (-0.3 + 0.1 * first, -0.3, -0.3))
            part = turned(unstructured(with_values(part, corners)))
            append.AddInputData(part if first == 0 and hexahedra else listed(part))
    append.Update()
    return append.GetOutput()


def hide(data, cells):
    ghosts = np.zeros(data.GetNumberOfCells(), np.uint8)
    ghosts[cells] = vtkDataSetAttributes.HIDDENCELL
    meshes.add_array(data.GetCellData(), ghosts, vtkDataSetAttributes.GhostArrayName())
    data.Modified()


class TrilinearByDefault(unittest.TestCase):
    def assert_is(self, data, expected, other, transfer=CLEAR_BELOW):
        for view in ("far", "along_z"):
            automatic, same, different = (Drawn(data, transfer, trilinear=t).picture(VIEWS[view]) for t in (AUTOMATIC, expected, other))
            self.assertEqual(np.abs(automatic - same).max(), 0, view)
            self.assertGreater(np.abs(automatic - different).max(), 5 / 255, view)

    def test_grids_and_cells(self):
        for data in (with_values(tapered(), steep), with_values(bent(), steep), with_values(shell(), steep)):
            self.assert_is(data, TRILINEAR, TETRAHEDRA)
            self.assert_is(turned(data), TRILINEAR, TETRAHEDRA)
        self.assert_is(wedges(), TRILINEAR, TETRAHEDRA)

    def test_most_are_tetrahedra(self):
        transfer = Transfer(COLOURS, [(0, 0), (1, 1)], unit_distance=0.05)
        self.assert_is(mixture(5, 1), TRILINEAR, TETRAHEDRA, transfer)
        self.assert_is(mixture(4, 1), TETRAHEDRA, TRILINEAR, transfer)
        self.assert_is(mixture(1, 5), TETRAHEDRA, TRILINEAR, transfer)

    def test_cells_that_are_not_drawn(self):
        """A line, a point and a quadrilateral among hexahedra, as mesh generators leave them there, are told and change nothing."""
        data = turned(with_values(tapered(), steep))
        cells = [(data.GetCellType(i), [data.GetCell(i).GetPointId(k) for k in range(8)]) for i in range(data.GetNumberOfCells())]
        others = [(VTK_LINE, [0, 1]), (VTK_VERTEX, [2]), (VTK_QUAD, cells[0][1][:4])]
        mixed = meshes.grid(meshes.points_of(data), others[:2] + cells + others[2:])
        mixed.GetPointData().ShallowCopy(data.GetPointData())
        drawn = Drawn(mixed, CLEAR_BELOW, trilinear=AUTOMATIC)
        self.assertEqual(np.abs(drawn.picture() - Drawn(data, CLEAR_BELOW, trilinear=AUTOMATIC).picture()).max(), 0)
        self.assertIn("2 cells are not drawn", "".join(drawn.window.messages.all))

    def follow(self, data, changes, **settings):
        drawn = Drawn(data, CLEAR_BELOW, trilinear=AUTOMATIC, **settings)
        before = drawn.picture()
        for label, change in changes.items():
            change(drawn)
            after = drawn.picture()
            self.assertGreater(np.abs(after - before).max(), 0.02, label)
            fresh = Drawn(data, CLEAR_BELOW, trilinear=AUTOMATIC)
            fresh.volume.SetProperty(drawn.volume.GetProperty())
            fresh.mapper.SetContourValue(0, drawn.mapper.GetContourValue(0)) if drawn.mapper.GetNumberOfContourValues() else None
            fresh.mapper.SetContourArrayName(drawn.mapper.GetContourArrayName())
            fresh.mapper.SetOpacityArrayName(drawn.mapper.GetOpacityArrayName())
            self.assertEqual(np.abs(after - fresh.picture()).max(), 0, label)
            before = after

    def test_what_is_seen_follows_changes(self):
        """Cells in which nothing is seen are marked: for each opacity function, array, contour and hidden cell anew."""
        def opacity(points):
            def change(drawn):
                function = drawn.volume.GetProperty().GetScalarOpacity()
                function.RemoveAllPoints()
                for point in points:
                    function.AddPoint(*point)
            return change

        def contour(value, array=""):
            def change(drawn):
                drawn.mapper.SetContourValue(0, value)
                drawn.mapper.SetContourArrayName(array)
            return change

        for data in (with_values(tapered(), smooth), turned(with_values(tapered(), smooth))):
            points = meshes.points_of(data)
            meshes.add_array(data.GetPointData(), np.linalg.norm(points, axis=1).astype(np.float32), "t")
            meshes.add_array(data.GetPointData(), np.exp(-20 * (points**2).sum(axis=1)).astype(np.float32), "o")
            data.GetPointData().SetActiveScalars("s")

            def other_values(name, field):
                def change(_drawn, shown=data):
                    vtk_to_numpy(shown.GetPointData().GetArray(name))[:] = field(meshes.points_of(shown))
                    shown.GetPointData().GetArray(name).Modified()
                    shown.Modified()
                return change

            self.follow(data, {"higher": opacity([(0, 0), (0.6, 0), (0.61, 0.5), (1, 1)]), "a gap": opacity([(0, 0.5), (0.4, 0.5), (0.41, 0), (0.6, 0), (0.61, 1)]),
                               "nothing": opacity([(0, 0), (1, 0)]), "contour": contour(0.5), "contour of another": contour(0.3, "t"),
                               "some": opacity([(0, 0), (0.7, 0), (0.71, 0.4)]), "values": other_values("s", lambda p: 1 - smooth(p)),
                               "opacity array": lambda drawn: drawn.mapper.SetOpacityArrayName("o"), "its values": other_values("o", lambda p: p[:, 0] + 0.5),
                               "hidden": lambda drawn, shown=data: hide(shown, range(60, 160))})


if __name__ == "__main__":
    unittest.main()
