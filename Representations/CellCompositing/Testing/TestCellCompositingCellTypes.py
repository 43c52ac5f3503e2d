# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of VTK's less common 3-D cells. All fill one hexahedron with a linear field: rays through that tell what is right."""
import itertools
import unittest

import numpy as np
import vtkmodules.vtkCommonDataModel as data_model
from nephoscope_testing import meshes, polyhedra
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import constant, random_transfer
from vtkmodules.vtkFiltersSources import vtkCellTypeSource

HIGHER_ORDER = ("QUADRATIC_TETRA", "QUADRATIC_HEXAHEDRON", "QUADRATIC_WEDGE", "QUADRATIC_PYRAMID", "TRIQUADRATIC_PYRAMID",
                "LAGRANGE_TETRAHEDRON", "LAGRANGE_HEXAHEDRON", "LAGRANGE_WEDGE", "BEZIER_HEXAHEDRON", "BEZIER_WEDGE")


def higher_order(name, order=2):
    source = vtkCellTypeSource()
    source.SetCellType(getattr(data_model, "VTK_" + name))
    source.SetBlocksDimensions(2, 2, 2)
    source.SetCellOrder(order)
    source.Update()
    return source.GetOutput()


def curved(name):
    """One cell that fills a cube, sheared along z by a parabola: rays along z have a length of 1 in it."""
    cell = getattr(data_model, "vtk" + name)()
    middle = {20: (0, 0.5, 0.5), 21: (1, 0.5, 0.5), 22: (0.5, 0, 0.5), 23: (0.5, 1, 0.5), 24: (0.5, 0.5, 0), 25: (0.5, 0.5, 1), 26: (0.5, 0.5, 0.5)}
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)
    edges = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
    points = [*corners, *(corners[list(edge)].mean(axis=0) for edge in edges), *(np.array(middle[i]) for i in range(20, cell.GetNumberOfPoints()))]
    points = np.array([p + (0, 0, 1.2 * p[0] * (1 - p[0])) for p in points])
    return meshes.grid(points, [(cell.GetCellType(), list(range(len(points))))])


def possible_edges(data):
    """Between any two points of a cell: the edges of its tetrahedra, whichever they are, are among these."""
    points, pairs = meshes.points_of(data), set()
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        ids = sorted(cell.GetPointId(k) for k in range(cell.GetNumberOfPoints()))
        pairs |= set(itertools.combinations(ids, 2))
    return points[sorted(pairs)]


def honeycomb(rings=1):
    """Hexagonal prisms around one, each with pentagonal ones cut from the outermost: ids go round, bottom first."""
    points, cells, numbers = [], [], {}

    def number(x, y, z):
        key = (round(x, 6), round(y, 6), z)
        if key not in numbers:
            numbers[key] = len(points)
            points.append((x, y, z))
        return numbers[key]
    for a in range(-rings, rings + 1):
        for b in range(max(-rings, -a - rings), min(rings, -a + rings) + 1):
            cx, cy = 3 ** 0.5 * (a + b / 2), 1.5 * b
            corners = [(cx + np.sin(t), cy + np.cos(t)) for t in -np.pi / 3 * np.arange(6)]
            kind = data_model.VTK_HEXAGONAL_PRISM
            if a == rings:  # without the outermost corner
                corners.pop(max(range(6), key=lambda k: corners[k][0] + 0.1 * corners[k][1]))
                kind = data_model.VTK_PENTAGONAL_PRISM
            cells.append((kind, [number(x, y, z) for z in (0, 1) for x, y in corners]))
    return meshes.grid(np.array(points), cells)


class CellTypes(ImageTestCase):
    def fills_a_cube(self, label, data, seed):
        warp = meshes.projective(np.random.default_rng(seed), 0.2)
        points = meshes.points_of(data)
        data.SetPoints(meshes.vtk_points(warp((points - points.min(axis=0)) / np.ptp(points, axis=0).max())))
        cube = meshes.Lattice(1).mesh("hexahedron", warp)
        function = meshes.linear_field(np.random.default_rng(seed + 1), cube)
        for d in (data, cube):
            meshes.with_field(d, function)
        transfer = random_transfer(np.random.default_rng(seed + 2), 5, max_extinction=8)
        window = Window()
        scene = window.add_scene()
        ours = mapper()
        scene.look_at(scene.add_volume(ours, data, transfer), zoom=1.3)
        window.render()
        cells = polyhedra.from_dataset(cube)
        edges = possible_edges(data)
        cells.drawn_edges = lambda: edges
        self.verify(scene, ours, cells, transfer, label)
        self.assertEqual(ours.GetNumberOfVisibilityCycles(), 0, label)

    def test_higher_order_cells(self):
        for seed, name in enumerate(HIGHER_ORDER):
            self.fills_a_cube(name, higher_order(name), 10 * seed)

    def test_cubic_cells(self):
        for seed, name in enumerate(("LAGRANGE_HEXAHEDRON", "LAGRANGE_WEDGE")):
            self.fills_a_cube(name + " of order 3", higher_order(name, 3), 200 + seed)

    def test_curved_hexahedra(self):
        """A medium of one value is everywhere as opaque as the cell is high: its parts neither overlap nor leave gaps."""
        for name in ("QuadraticHexahedron", "BiQuadraticQuadraticHexahedron", "TriQuadraticHexahedron"):
            data = meshes.with_field(curved(name), lambda p: 0 * p[:, 0])
            window = Window()
            scene = window.add_scene()
            scene.add_volume(mapper(), data, constant(1.5))
            scene.look(position=(0.5, 0.5, 9), focus=(0.5, 0.5, 0), parallel_scale=0.4)
            window.render()
            opacity = window.rgba()[..., 3]
            np.testing.assert_allclose(opacity, 1 - np.exp(-1.5), atol=0.01, err_msg=name)

    def test_wedges_in_both_orders(self):
        """That of VTK before 9.7 and the one from then on."""
        wedges = meshes.Lattice(2).mesh("wedge", meshes.projective(np.random.default_rng(400), 0.2))
        meshes.with_field(wedges, meshes.linear_field(np.random.default_rng(401), wedges))
        for label, data in (("wedges", wedges), ("turned wedges", meshes.turned_wedges(wedges))):
            self.check(data, random_transfer(np.random.default_rng(402), 5, max_extinction=3), label)

    def test_convex_point_sets(self):
        """Cells whose points are not the first of the mesh: VTK 9.2 numbers the tetrahedra within the cell."""
        lattice = meshes.Lattice(3)
        cells = [(data_model.VTK_CONVEX_POINT_SET, lattice.ids(b)) for b in lattice.all_blocks()]
        self.fills_a_cube("convex point sets", meshes.grid(lattice.points, cells), 300)

    def test_pentagonal_and_hexagonal_prisms(self):
        for seed in (1, 2):
            data = honeycomb()
            meshes.with_field(data, meshes.linear_field(np.random.default_rng(seed), data))
            kinds = {data.GetCellType(i) for i in range(data.GetNumberOfCells())}
            self.assertEqual(kinds, {data_model.VTK_PENTAGONAL_PRISM, data_model.VTK_HEXAGONAL_PRISM})
            self.check(data, random_transfer(np.random.default_rng(seed), 5, max_extinction=2), f"honeycomb, seed {seed}")

    def test_trilinear_among_others(self):
        """Trilinear cells that were asked for, and are not drawn, are named."""
        def warnings(*kinds, trilinear=True):
            cells, points = [], []
            for at, kind in enumerate(kinds):
                source = vtkCellTypeSource()
                source.SetCellType(kind)
                source.SetBlocksDimensions(1, 1, 1)
                source.Update()
                one = source.GetOutput()
                first = len(points)
                points.extend(meshes.points_of(one) + (2 * at, 0, 0))
                for i in range(one.GetNumberOfCells()):
                    ids = one.GetCell(i).GetPointIds()
                    cells.append((kind, [first + ids.GetId(k) for k in range(ids.GetNumberOfIds())]))
            data = meshes.with_field(meshes.grid(np.array(points), cells), lambda p: p[:, 0])
            window = Window((8, 8))
            scene = window.add_scene()
            ours = mapper()
            if trilinear:
                ours.SetCellInterpolationToTrilinear()
            scene.add_volume(ours, data, constant(1.0, (1, 1, 1)))
            scene.look_at(data)
            window.render()
            return window.messages.all
        self.assertRegex(warnings(data_model.VTK_HEXAHEDRON, data_model.VTK_HEXAGONAL_PRISM)[0],
                         r"divided into tetrahedra, because there are others among them \(vtkHexagonalPrism\)")
        self.assertEqual(warnings(data_model.VTK_HEXAHEDRON, data_model.VTK_HEXAGONAL_PRISM, trilinear=False), [])
        self.assertEqual(warnings(data_model.VTK_HEXAHEDRON, data_model.VTK_TETRA), [])
        self.assertEqual(warnings(data_model.VTK_HEXAGONAL_PRISM), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
