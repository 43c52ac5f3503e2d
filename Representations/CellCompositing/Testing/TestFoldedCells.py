# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells that fold over themselves, because their points are in a wrong order or in a wrong place.

Reference: a uniform medium in a cube, whose optical depth along z is 1 in whichever order the points of its cells are numbered.
"""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.messages import Messages
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import constant

OPAQUE = 1 - np.exp(-1)
BLOCKS, CHANGED = 3, 13
INTERPOLATIONS = ("Automatic", "Tetrahedra", "Trilinear")


def exchanged(i, j):
    def order(ids):
        ids[i], ids[j] = ids[j], ids[i]
        return ids
    return order


# Which kind of cells, and what is wrong with the order of the points of one of them.
MISNUMBERED = [("hexahedron", exchanged(0, 6)), ("hexahedron", exchanged(0, 1)), ("hexahedron", exchanged(2, 7)), ("hexahedron", exchanged(0, 2)),
               ("hexahedron", lambda ids: [ids[k] for k in (0, 1, 3, 2, 4, 5, 7, 6)]), ("hexahedron", lambda ids: ids[:4] + ids[6:] + ids[4:6]),
               ("hexahedron", lambda ids: ids[:4] + ids[:3:-1]), ("voxel", exchanged(0, 7)), ("voxel", exchanged(1, 3)),
               ("voxel", lambda ids: [ids[k] for k in (0, 1, 3, 2, 4, 5, 7, 6)]),
               ("wedge", exchanged(0, 1)), ("wedge", exchanged(0, 4)), ("wedge", exchanged(3, 5)), ("pyramid", exchanged(0, 1))]
INSIDE_OUT = [("hexahedron", lambda ids: ids[4:] + ids[:4]), ("voxel", lambda ids: ids[4:] + ids[:4]), ("wedge", lambda ids: ids[3:] + ids[:3]),
              ("pyramid", lambda ids: ids[3::-1] + ids[4:])]


def cube(kind="hexahedron", order=lambda ids: ids, changed=(CHANGED,), moved=0.0):
    """From -0.5 to 0.5. Cells whose number is in `changed` get their points in another order, and an inner point is moved."""
    mesh = meshes.Lattice(BLOCKS).mesh(kind)
    points = meshes.points_of(mesh) - 0.5
    cells = []
    for number in range(mesh.GetNumberOfCells()):
        ids = [mesh.GetCell(number).GetPointId(k) for k in range(mesh.GetCell(number).GetNumberOfPoints())]
        cells.append((mesh.GetCellType(number), order(ids) if number in changed else ids))
    points[1 + 4 * (1 + 4)] += moved
    return meshes.with_field(meshes.grid(points, cells), lambda p: p[:, 0] + 0.5)


def draw(data, interpolation="Automatic"):
    """(largest error of the opacity of a pixel, messages) of two frames, from in front and from the side"""
    window = Window((50, 50))
    scene = window.add_scene()
    ours = mapper()
    ours.SetMethodToRays()
    getattr(ours, f"SetCellInterpolationTo{interpolation}")()
    scene.add_volume(ours, data, constant())
    scene.camera.SetParallelProjection(True)
    error = 0
    with Messages() as messages:
        for position in ((0, 0, 3), (3, 0, 0)):
            scene.look(position, (0, 0, 0), (0, 1, 0), 30, 0.4, near=1, far=5)
            window.render()
            error = max(error, np.abs(float_image(ours)[..., 3] - OPAQUE).max())
    return error, messages.all


class TestFoldedCells(unittest.TestCase):
    def test_misnumbered(self):
        for number, (kind, order) in enumerate(MISNUMBERED):
            for interpolation in INTERPOLATIONS:
                error, messages = draw(cube(kind, order), interpolation)
                self.assertLess(error, 1e-4, (number, kind, interpolation))
                self.assertEqual(len(messages), 1, messages)
                self.assertIn(f"1 cell folds over itself: cell {CHANGED} near (", messages[0])
                self.assertIn("wrong order", messages[0])

    def test_all_misnumbered(self):
        everywhere = range(BLOCKS**3)
        error, messages = draw(cube("hexahedron", MISNUMBERED[4][1], everywhere))
        self.assertLess(error, 1e-4)
        self.assertIn("27 cells fold over themselves, the first is cell 0 near (-0.33", "".join(messages))

    def test_inside_out(self):
        """One cell or all: drawn right, and no fault."""
        for kind, order in INSIDE_OUT:
            for changed in ((CHANGED,), range(1000)):
                for interpolation in INTERPOLATIONS:
                    error, messages = draw(cube(kind, order, changed), interpolation)
                    self.assertLess(error, 1e-4, (kind, interpolation))
                    self.assertEqual(messages, [])

    def test_points_in_a_wrong_place(self):
        """No order helps: trilinear cells are nearly right, without holes."""
        for moved, cells, largest in ((0.2, "1 cell folds over itself: cell 13", 0.05), (0.36, "7 cells fold over themselves, the first is cell 1 ", 0.2)):
            error, messages = draw(cube(moved=moved))
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(cells, messages[0])
            self.assertIn("scaled Jacobian below 0", messages[0])
            self.assertLess(error, largest)

    def test_both(self):
        data = cube("hexahedron", exchanged(0, 6), (26,), moved=0.2)
        message = "".join(draw(data)[1])
        self.assertIn("2 cells fold over themselves, the first is cell 13", message)
        self.assertIn("The points of 1 are numbered in a wrong order", message)

    def test_warped(self):
        """Valid cells whose faces are not plane."""
        rng = np.random.default_rng(3)
        for kind in ("hexahedron", "wedge", "pyramid"):
            for amount in (0.02, 0.05):
                data = meshes.Lattice(4).mesh(kind, meshes.wobble(rng, amount))
                meshes.with_field(data, lambda p: p[:, 0])
                self.assertEqual([m for m in draw(data)[1] if "fold" in m], [])


if __name__ == "__main__":
    unittest.main()
