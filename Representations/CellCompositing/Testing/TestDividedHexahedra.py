# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unstructured hexahedra that are divided without a list of tetrahedra look as the list does.

Reference: the same tetrahedra as a mesh of their own, from an independent colouring of the points (polyhedra.chessboard).
"""
import unittest

import numpy as np
from nephoscope_testing import meshes, polyhedra
from nephoscope_testing.checks import mapper
from TestTrilinearCells import CLEAR_BELOW, RAMP, STEP, VIEWS, Drawn, clip, even, smooth, steep, tapered, turned, unstructured, with_values
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_TETRA, vtkDataSetAttributes
from vtkmodules.vtkFiltersCore import vtkAppendFilter

FEW = ("far", "along_z", "diagonal", "inside", "on_a_point")
RING = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def listed(data):
    """The tetrahedra of the hexahedra, with the values of these, but for hexahedra with a value that is not finite."""
    color, values = polyhedra.chessboard(data), data.GetPointData().GetArray("s")
    cells, of_cell = [], []
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        assert cell.GetCellType() == VTK_HEXAHEDRON
        ids = [cell.GetPointId(k) for k in range(8)]
        if values and not np.isfinite([values.GetTuple1(k) for k in ids]).all():
            continue
        for part in polyhedra.by_colors([color[k] for k in ids], RING):
            cells.append((VTK_TETRA, [ids[k] for k in part]))
            of_cell.append(i)
    result = meshes.grid(meshes.points_of(data), cells)
    result.GetPointData().ShallowCopy(data.GetPointData())
    attributes = data.GetCellData()
    for k in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(k)
        meshes.add_array(result.GetCellData(), vtk_to_numpy(array)[of_cell], array.GetName())
    return result


def halves(values_of):
    """Two blocks with points of their own, whose values at their common face are those of values_of(points, block)."""
    append = vtkAppendFilter()
    for block, low in enumerate((0, 3)):
        half = meshes.image((3, 6, 6), (1 / 6,) * 3, (-0.5 + low / 6, -0.5, -0.5))
        meshes.add_array(half.GetPointData(), np.asarray(values_of(meshes.points_of(half), block), np.float32))
        append.AddInputData(half)
    append.Update()
    return turned(append.GetOutput())


def cells_of(field=steep, shape=tapered):
    return turned(unstructured(with_values(shape(), field)))


class DividedHexahedra(unittest.TestCase):
    def compare(self, data, label, transfer=CLEAR_BELOW, settings=None, association="point", views=FEW, other=None, warns=False):
        """other: the reference, or the tetrahedra."""
        pair = [Drawn(d, transfer, settings, association, trilinear=False) for d in (data, other or listed(data))]
        covered = 0
        for name in views:
            one, expected = (drawn.picture(VIEWS[name]) for drawn in pair)
            covered += int((expected[..., 3] > 0.05).sum())
            error = np.abs(one - expected).max(axis=-1)
            wrong = np.argwhere(error > STEP)
            print(f"  {label} {name}: largest difference {error.max() * 255:.3f}/255, {len(wrong)} pixels beyond 1/255", flush=True)
            self.assertEqual(len(wrong), 0, f"{label} {name}: {wrong[:5].tolist()}")
        self.assertGreater(covered, 100, label)
        self.assertEqual(pair[0].window.messages.all != [], warns)
        self.assertEqual(*(drawn.mapper.GetNumberOfTetrahedra() for drawn in pair))
        self.assertEqual(*(drawn.mapper.GetNumberOfDrawnTetrahedra() for drawn in pair))

    def test_fields(self):
        for field, transfer in ((smooth, RAMP), (steep, CLEAR_BELOW)):
            self.compare(cells_of(field), field.__name__, transfer, views=VIEWS)

    def test_values_that_jump_between_blocks(self):
        """Also where only some of the points of the common face have two values."""
        whole = {"everywhere": lambda p, block: steep(p) * (0.4 if block else 1),
                 "in half of the face": lambda p, block: np.where(p[:, 1] > 0.1, 0.3 + 0.5 * block, smooth(p)),
                 "nowhere": lambda p, block: smooth(p)}
        for label, values in whole.items():
            self.compare(halves(values), f"jump {label}", views=VIEWS)

    def test_values_of_cells(self):
        data = turned(unstructured(tapered()))
        with_values(data, steep, "cell")
        self.compare(data, "cells", association="cell")

    def test_opacity_of_another_array(self):
        for kind in ("point", "cell"):
            data = cells_of(smooth)
            attributes = data.GetPointData() if kind == "point" else data.GetCellData()
            count = data.GetNumberOfPoints() if kind == "point" else data.GetNumberOfCells()
            meshes.add_array(attributes, np.random.default_rng(9).uniform(0, 1, count).astype(np.float32), "o")
            self.compare(data, f"opacity of {kind}s", settings=lambda _, made: made.SetOpacityArrayName("o"))

    def test_contours(self):
        def surfaces(_, made):
            for i, value in enumerate((0.3, 0.6)):
                made.SetContourValue(i, value)
                made.SetContourOpacity(i, 0.5)
                made.SetContourColor(i, 1 - i, 0.3, i)
            made.SetContourLighting(False)

        self.compare(cells_of(smooth), "contours", RAMP, surfaces)

    def test_contours_of_an_array_that_jumps(self):
        data = halves(lambda p, _: smooth(p))
        places = meshes.points_of(data)
        second = np.arange(len(places)) >= len(places) // 2  # points of the second block
        meshes.add_array(data.GetPointData(), (smooth(places[:, [1, 2, 0]]) + 0.2 * second).astype(np.float32), "c")

        def surface(_, made):
            made.SetContourArrayName("c")
            made.SetContourValue(0, 0.6)
            made.SetContourLighting(False)

        self.compare(data, "another array", RAMP, surface)

    def test_smooth_normals_are_those_of_a_grid(self):
        def surface(_, made):
            made.SetContourValue(0, 0.5)
            made.SetContourLighting(True)

        self.compare(cells_of(smooth), "lit", RAMP, surface, other=with_values(tapered(), smooth))

    def test_hidden_cells_and_missing_values(self):
        data = cells_of()
        hidden = np.where(np.arange(data.GetNumberOfCells()) % 5 == 0, vtkDataSetAttributes.HIDDENCELL, 0).astype(np.uint8)
        meshes.add_array(data.GetCellData(), hidden, vtkDataSetAttributes.GhostArrayName())
        self.compare(data, "hidden")
        data = cells_of(lambda p: np.where(np.arange(len(p)) % 40 == 7, np.nan, steep(p)))
        self.compare(data, "missing", warns=True)

    def test_clipped(self):
        self.compare(cells_of(), "clipped", settings=clip)

    def test_beside_another_medium(self):
        def second(scene, _made):
            scene.add_volume(mapper(), with_values(even(4), smooth), RAMP)

        data = cells_of()
        pictures = []
        for stored in (data, listed(data)):
            drawn = Drawn(stored, CLEAR_BELOW, second, trilinear=False)
            drawn.look(VIEWS["far"])
            drawn.window.render()
            pictures.append(drawn.window.rgba())
        self.assertLessEqual(np.abs(pictures[0] - pictures[1]).max(), 2 * STEP)

    def test_another_medium_costs_no_mesh(self):
        """Hexahedra stay hexahedra, and are not built again, when another volume comes."""
        for interpolation in ("Automatic", "Tetrahedra"):
            drawn = Drawn(cells_of(), CLEAR_BELOW, trilinear=False)
            getattr(drawn.mapper, f"SetCellInterpolationTo{interpolation}")()
            drawn.picture()
            built = []
            drawn.mapper.AddObserver("ProgressEvent", lambda *_: built.append(1))
            drawn.scene.add_volume(mapper(), with_values(even(4), smooth), RAMP)
            drawn.window.render()
            self.assertEqual(built, [], interpolation)

    def test_changes_of_what_is_drawn(self):
        """Contours and layers come and go, values change: the picture is that of a new mapper."""
        data = cells_of()
        drawn = Drawn(data, CLEAR_BELOW, trilinear=False)
        plain = drawn.picture()
        for change, undo in ((lambda made: made.SetMethodToFaces(), lambda made: made.SetMethodToRays()),
                             (lambda made: made.SetContourValue(0, 0.5), lambda made: made.SetNumberOfContourValues(0)),
                             (lambda made: made.SetCellInterpolationToTrilinear(), lambda made: made.SetCellInterpolation(0))):
            change(drawn.mapper)
            self.assertGreater(np.abs(drawn.picture() - plain).max(), 0)
            undo(drawn.mapper)
            self.assertEqual(np.abs(drawn.picture() - plain).max(), 0)


if __name__ == "__main__":
    unittest.main()
