# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Single cells that are not convex: their volume in closed form, positive tetrahedra, nothing outside, faces as they were."""
import unittest

import numpy as np
from division import HAS_TETGEN, DivisionTestCase, divide
from nephoscope_testing import meshes, nonconvex
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

STAR_SHAPED = {
    "L": nonconvex.prism(nonconvex.L_POLYGON),
    "plus": nonconvex.prism(nonconvex.PLUS_POLYGON),
    "star": nonconvex.prism(nonconvex.STAR_POLYGON, 0.3),
    "Schonhardt": nonconvex.schonhardt(),
}
OTHERS = {
    "U": nonconvex.prism(nonconvex.U_POLYGON),
    "C": nonconvex.prism(nonconvex.C_POLYGON, 4.0),
    "spiral": nonconvex.prism(nonconvex.SPIRAL_POLYGON),
    "two Schonhardts": nonconvex.tower(2),
    "five Schonhardts": nonconvex.tower(5),
    "frame": nonconvex.frame(),
    "frame with bridges": nonconvex.frame(keyhole=True),
    "cube with a cavity": nonconvex.hollow(),
}


def outward(points, faces, volume):
    """The faces wound outward: hollow() gives its cavity like a solid."""
    if np.isclose(nonconvex.volume_of(points, faces), volume):
        return faces
    half = len(faces) // 2
    return faces[:half] + [f[::-1] for f in faces[half:]]


class Shapes(DivisionTestCase):
    def check(self, name, shape, transform=lambda p: p, factor=1.0, **settings):
        points, faces, volume = shape
        rng = np.random.default_rng(7)
        divider, messages = divide(nonconvex.grid_of(transform(points), [faces]), **settings)
        self.no_messages(messages)
        placed, ids = self.filled(divider, volume * factor, label=name)
        self.inside(placed, ids, transform(points), outward(points, faces, volume), name, rng)
        open_faces = self.conforming(ids, lambda f: max(f) < len(points), name)
        edges = {frozenset(e) for f in open_faces for e in ((f[0], f[1]), (f[1], f[2]), (f[0], f[2]))}
        for face in faces:
            for edge in zip(face, face[1:] + face[:1]):
                self.assertIn(frozenset(edge), edges, f"{name}: an edge of the cell was lost")
        self.assertEqual(divider.GetNumberOfNewPoints(), len(placed) - len(points))
        np.testing.assert_array_equal(placed[:len(points)], transform(points))
        return divider

    def test_star_shaped_cells_need_no_tetgen(self):
        for name, shape in STAR_SHAPED.items():
            self.check(name, shape, UseTetGen=False)

    @unittest.skipUnless(HAS_TETGEN, "this build has no TetGen")
    def test_all_others_by_tetgen(self):
        for name, shape in OTHERS.items():
            self.check(name, shape)

    def test_cells_that_need_a_new_point_get_it_inside(self):
        self.assertEqual(self.check("Schonhardt", STAR_SHAPED["Schonhardt"]).GetNumberOfNewPoints(), 1)
        self.assertEqual(self.check("L", STAR_SHAPED["L"]).GetNumberOfNewPoints(), 0)
        if HAS_TETGEN:
            self.assertGreaterEqual(self.check("tower", OTHERS["five Schonhardts"]).GetNumberOfNewPoints(), 5)

    def test_any_place_size_and_numbering(self):
        rng = np.random.default_rng(8)
        for trial in range(12):
            name = rng.choice(list(STAR_SHAPED) + (list(OTHERS) if HAS_TETGEN else []))
            points, faces, volume = {**STAR_SHAPED, **OTHERS}[name]
            turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
            turn *= np.sign(np.linalg.det(turn))
            scale = 10.0 ** rng.integers(-6, 7)
            shift = scale * rng.normal(size=3) * rng.choice([0, 1, 100])
            order = rng.permutation(len(points))
            place = np.argsort(order)
            shape = points[order], [[int(place[v]) for v in face] for face in outward(points, faces, volume)], volume
            self.check(f"{name}, trial {trial}", shape, lambda p: scale * p @ turn.T + shift, scale ** 3)

    def test_faces_wound_anyhow(self):
        rng = np.random.default_rng(9)
        for name, (points, faces, volume) in STAR_SHAPED.items():
            wound = [list(np.roll(f[::rng.choice([-1, 1])], rng.integers(5))) for f in faces]
            divider, messages = divide(nonconvex.grid_of(points, [wound]))
            self.no_messages(messages)
            self.filled(divider, volume, label=name)

    def test_convex_cells_pass_unless_all_are_asked_for(self):
        square, hexagon = ((0, 0), (1, 0), (1, 1), (0, 1)), [(np.cos(a), np.sin(a)) for a in np.pi / 3 * np.arange(6)]
        for polygon in (square, hexagon, (*square[:2], (1, 0.5), *square[2:])):
            points, faces, volume = nonconvex.prism(polygon)
            data = nonconvex.grid_of(points, [faces])
            divider, messages = divide(data)
            self.no_messages(messages)
            self.assertEqual(divider.GetNumberOfDividedCells(), 0)
            self.assertEqual(divider.GetOutput().GetCellType(0), VTK_POLYHEDRON)
            divider, messages = divide(data, DivideConvexPolyhedra=True)
            self.no_messages(messages)
            _, ids = self.filled(divider, volume)
            self.conforming(ids, lambda f: max(f) < len(points), "convex")

    def test_float_points(self):
        """New points are rounded to float as well, and nothing is inverted by that."""
        rng = np.random.default_rng(10)
        for name, (points, faces, volume) in {**STAR_SHAPED, **(OTHERS if HAS_TETGEN else {})}.items():
            placed = (points @ np.linalg.qr(rng.normal(size=(3, 3)))[0] + rng.normal(size=3)).astype(np.float32)
            data = nonconvex.grid_of(placed, [faces])
            data.GetPoints().SetData(numpy_to_vtk(placed, deep=True))
            divider, messages = divide(data)
            self.no_messages(messages)
            output = divider.GetOutput()
            self.assertEqual(output.GetPoints().GetDataType(), VTK_FLOAT)
            parts = nonconvex.volumes(meshes.points_of(output), nonconvex.tetrahedra_of(output)[1])
            self.assertGreater(parts.min(), -1e-12, name)
            self.assertAlmostEqual(parts.sum() / volume, 1, delta=1e-5, msg=name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
