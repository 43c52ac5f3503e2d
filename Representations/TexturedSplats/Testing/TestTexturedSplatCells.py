# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sizes of splats without a grid: from cells, arrays and neighbours; how flat constant data are then."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON, vtkBiQuadraticQuadraticHexahedron, vtkBiQuadraticQuadraticWedge, vtkPiecewiseFunction,
                                           vtkQuadraticHexahedron,
                                           vtkQuadraticLinearWedge, vtkStructuredGrid, vtkTriQuadraticHexahedron)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

COLORS = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.4), (1, 1.6)])
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))  # of a hexahedron, in the order of their middles
N = 14  # samples along an edge of the unit cube, less one


def wave(points):
    return (np.sin(5 * points[:, 0]) * np.cos(4 * points[:, 1] + points[:, 2]) + 1) / 2


def graded(points):
    """Cells from half to twice the mean length."""
    return points**np.array([1.6, 1, 1]) + 0.04 * np.sin(6 * points[:, [1, 2, 0]]) * points * (1 - points)


def quadratic(mesh):
    """Constant data on hexahedra with a point in the middle of every edge."""
    points, middles, cells = list(meshes.points_of(mesh)), {}, []
    for c in range(mesh.GetNumberOfCells()):
        corners = [mesh.GetCell(c).GetPointId(k) for k in range(8)]
        for edge in [tuple(sorted((corners[a], corners[b]))) for a, b in EDGES]:
            if edge not in middles:
                middles[edge] = len(points)
                points.append((points[edge[0]] + points[edge[1]]) / 2)
            corners.append(middles[edge])
        cells.append((VTK_QUADRATIC_HEXAHEDRON, corners))
    return meshes.with_field(meshes.grid(np.array(points), cells), lambda p: 0 * p[:, 0])


def around(p):
    """Once around the axis z through the middle, in cells thirty times as long as wide."""
    radius, angle = 0.35 + 0.1 * p[:, 0], 2 * np.pi * p[:, 1]
    return np.stack([0.5 + radius * np.cos(angle), 0.5 + radius * np.sin(angle), p[:, 2]], axis=1)


def twisted(p):
    angle, q = 1.5 * p[:, 2], p[:, :2] - 0.5
    return np.stack([0.5 + q[:, 0] * np.cos(angle) - q[:, 1] * np.sin(angle), 0.5 + q[:, 0] * np.sin(angle) + q[:, 1] * np.cos(angle), p[:, 2]], axis=1)


BENT = {
    **{f"long along {'xyz'[axis]}": lambda p, axis=axis: 0.5 + (p - 0.5) * np.where(np.arange(3) == axis, 1, 0.1) for axis in range(3)},
    "sheared": lambda p: p @ np.array([[1, 0.6, 0.1], [0, 0.3, 0.2], [0.1, 0, 0.1]]),
    "around an axis": around,
    "twisted": twisted,
}


def permuted(mesh):
    """The same hexahedra with their points and cells in another order, and each turned by a half around its third direction."""
    rng = np.random.default_rng(3)
    points = meshes.points_of(mesh)
    order = rng.permutation(len(points))
    number = np.argsort(order)
    cells = [[number[mesh.GetCell(c).GetPointId(k)] for k in (2, 3, 0, 1, 6, 7, 4, 5)] for c in rng.permutation(mesh.GetNumberOfCells())]
    return meshes.grid(points[order], [(VTK_HEXAHEDRON, ids) for ids in cells])


def structured_copy(image):
    grid = vtkStructuredGrid()
    grid.SetDimensions(image.GetDimensions())
    grid.SetPoints(meshes.vtk_points(meshes.points_of(image)))
    return grid


class Cells(ImageTestCase):
    def draw(self, data, transfer=COLORS, association="point", configure=None, scale=0.8, direction=(0.4, 0.5, 0.77), warnings=()):
        window = Window((64, 64))
        scene = window.add_scene()
        mapper = nephoscope.vtkTexturedSplatMapper()
        if configure:
            configure(mapper)
        scene.add_volume(mapper, data, transfer, association=association)
        scene.look(np.array((0.5,) * 3) + 10 * np.array(direction), (0.5,) * 3, parallel_scale=scale)
        window.render()
        self.assertEqual([text.split("): ", 1)[-1].strip() for text in window.messages.all], list(warnings))
        return float_image(mapper)

    def ripple(self, data, configure=None, association="point", exact=1.0):
        """Root of the mean square of what the optical depth of constant data is off by, through the middle; and its mean, over `exact`."""
        image = self.draw(data, constant(1.0), association, configure, scale=0.25, direction=(0, 0, 1))
        depth = -np.log1p(-image[..., 3])
        return np.sqrt(((depth / exact - 1)**2).mean()), depth.mean() / exact

    def check_flat(self, label, data, rms, mean, **options):
        found, middle = self.ripple(data, **options)
        print(f"  {label}: deviation {100 * found:.1f} %, mean {middle:.3f}", flush=True)
        self.assertLess(found, rms, label)
        self.assertLess(abs(middle - 1), mean, label)
        return found

    def scattered(self, count=3000, clustered=False):
        rng = np.random.default_rng(6)
        points = rng.uniform(-0.2, 1.2, (count, 3))
        if clustered:
            points[:, 0] = 1.4 * rng.uniform(0, 1, count)**2 - 0.2
        data = meshes.particles(points)
        meshes.add_array(data.GetPointData(), np.full(count, 0.5))
        return data

    def test_wedges_in_both_orders(self):
        wedges = meshes.with_field(meshes.Lattice(5).mesh("wedge"), wave)  # with plane faces, whose diagonals do not matter
        np.testing.assert_allclose(self.draw(meshes.turned_wedges(wedges)), self.draw(wedges), atol=1e-6)

    def test_hexahedra_are_the_structured_grid(self):
        blocks = (6, 5, 4)
        for warp in (lambda p: p * (1, 0.7, 0.4), lambda p: p @ np.array([[1, 0.3, 0], [0, 0.8, 0.1], [0.2, 0, 0.5]])):
            for association in ("point", "cell"):
                for kind in ("hexahedron", "voxel"):
                    grid = meshes.with_field(meshes.structured(blocks, warp), wave, association)
                    mesh = meshes.with_field(meshes.Lattice(blocks).mesh(kind, warp), wave, association)
                    expected = self.draw(grid, association=association)
                    self.assertGreater(expected[..., 3].max(), 0.2)
                    np.testing.assert_allclose(self.draw(mesh, association=association), expected, atol=2e-5)

    def test_points_of_long_and_bent_hexahedra_are_the_structured_grid(self):
        """Ten times as long as wide along each axis, sheared, around an axis with a seam, twisted; in any order of points, cells and corners."""
        bounds = {"around an axis": 0.5 / 255, "twisted": 1.5 / 255}
        blocks = (9, 7, 5)
        for name, warp in BENT.items():
            grid = meshes.with_field(meshes.structured(blocks, warp), wave)
            expected = self.draw(grid)
            self.assertGreater(expected[..., 3].max(), 0.1, name)
            mesh = meshes.Lattice(blocks).mesh("hexahedron", warp)
            for label, data in (("mesh", mesh), ("permuted", permuted(mesh))):
                found = np.abs(self.draw(meshes.with_field(data, wave)) - expected)
                print(f"  {name}, {label}: largest difference {found.max():.1e}, mean {found.mean():.1e}", flush=True)
                self.assertLess(found.max(), bounds.get(name, 2e-5), name)

    def test_points_of_long_tetrahedra_are_nearly_the_structured_grid(self):
        """Splats are smooth: six tetrahedra in each cell give the picture of the grid to a few per cent of its light, balls do not."""
        for axis in range(3):
            warp = lambda p: 0.5 + (p - 0.5) * np.where(np.arange(3) == axis, 1, 0.1)  # noqa: E731
            grid = meshes.with_field(meshes.structured((9, 7, 5), warp), wave)
            mesh = meshes.with_field(meshes.Lattice((9, 7, 5)).mesh("tetra", warp), wave)
            expected = self.draw(grid)
            found, balls = (np.abs(self.draw(mesh, configure=c) - expected).sum() / expected.sum()
                            for c in (None, lambda m: m.CellSizeFromCellsOff()))
            print(f"  along {'xyz'[axis]}: difference {found:.3f}, of balls {balls:.3f}", flush=True)
            self.assertLess(found, 0.08)
            self.assertGreater(balls, 4 * found)

    def test_constant_data_on_cells_of_every_kind(self):
        rng = np.random.default_rng(2)
        for kind, rms, mean in (("hexahedron", 0.01, 0.005), ("wedge", 0.01, 0.005), ("tetra", 0.01, 0.005), ("mixed", 0.015, 0.005),
                                ("pyramid", 0.03, 0.005)):
            mesh = meshes.with_field(meshes.Lattice(N).mesh(kind, graded), lambda p: 0 * p[:, 0])
            self.check_flat(kind, mesh, rms, mean)
        image = meshes.image((N,) * 3, (1 / N,) * 3)
        cutter = vtkDataSetTriangleFilter()  # five tetrahedra in every cube, by turns
        cutter.SetInputData(image)
        cutter.Update()
        self.check_flat("five tetrahedra", meshes.with_field(cutter.GetOutput(), lambda p: 0 * p[:, 0]), 0.05, 0.02)
        cloud = meshes.with_field(meshes.delaunay(rng, 0, rng.uniform(-0.2, 1.2, (2500, 3))), lambda p: 0 * p[:, 0])
        one, _ = self.ripple(cloud, lambda m: m.SetCellSize(1.4 / 2500**(1 / 3)), exact=1.4)
        local, mean = self.ripple(cloud, exact=1.4)
        print(f"  Delaunay: deviation {100 * local:.1f} %, mean {mean:.3f}, with one size {100 * one:.1f} %")
        self.assertLess(local, 0.6 * one)

    def test_constant_data_on_quadratic_cells(self):
        """Points in the middle of edges, none in faces and cells: no weave."""
        self.check_flat("quadratic hexahedra", quadratic(meshes.Lattice(N).mesh("hexahedron", graded)), 0.01, 0.005)
        self.assertAlmostEqual(self.mass(quadratic(meshes.Lattice(5).mesh("hexahedron", graded)), 1.4, "point"), 1, delta=0.01)

    def test_unit_distance_of_coarse_cells(self):
        """A cube of few cells is as opaque by default as one of many, of whatever kind its cells are."""
        found = {}
        for kind, of in (("hexahedron", {}), ("wedge", {}), ("tetra", {}), ("pyramid", {}), ("hexahedron", {"as_quadratic": True})):
            for blocks in (2, 3, 6):
                mesh = meshes.Lattice(blocks).mesh(kind)
                mesh = meshes.with_field(quadratic(mesh) if of else mesh, lambda p: 0 * p[:, 0], "cell")
                mapper = nephoscope.vtkTexturedSplatMapper()
                mapper.SetInputDataObject(mesh)
                mapper.SelectScalarArray("s")
                mapper.SetScalarModeToUseCellFieldData()
                prop = vtkVolumeProperty()
                prop.SetScalarOpacity(vtkPiecewiseFunction())
                prop.GetScalarOpacity().AddPoint(0, 0.5)
                found[kind, bool(of), blocks] = mapper.FindUnitDistance(prop)
        print("  unit distances:", {key: round(value, 3) for key, value in found.items()}, flush=True)
        expected = found["hexahedron", False, 6]
        for key, value in found.items():
            self.assertAlmostEqual(value / expected, 1, delta=0.35, msg=str(key))

    def test_cells_keep_their_volume(self):
        """The mass of the splats of cells is that of the cells, of whatever kind."""
        for kind in ("hexahedron", "wedge", "tetra", "pyramid"):
            mesh = meshes.with_field(meshes.Lattice(5).mesh(kind, graded), lambda p: 0 * p[:, 0], "cell")
            scale = 1.4
            self.assertAlmostEqual(self.mass(mesh, scale), 1, delta=0.01, msg=kind)

    def test_seams_and_poles(self):
        """Points in one place are one sample: cells with points of their own are drawn as those that share them, a shell has no blobs."""
        shared = meshes.with_field(meshes.Lattice(5).mesh("hexahedron", graded), wave)
        points = meshes.points_of(shared)
        ids = np.array([[shared.GetCell(c).GetPointId(k) for k in range(8)] for c in range(shared.GetNumberOfCells())])
        apart = meshes.grid(points[ids.ravel()], [(VTK_HEXAHEDRON, range(8 * c, 8 * c + 8)) for c in range(len(ids))])
        np.testing.assert_allclose(self.draw(meshes.with_field(apart, wave)), self.draw(shared), atol=2e-5)
        shell = meshes.shell(24, 12, 3, top=90)
        cutter = vtkAppendFilter()
        cutter.SetInputData(shell)
        cutter.Update()
        mesh = meshes.with_field(cutter.GetOutput(), lambda p: 0 * p[:, 0])
        volume = 4 / 3 * np.pi * (1.3**3 - 1)
        image = self.draw(mesh, constant(0.1), scale=2.5, direction=(0, 0, 1))
        depth = -np.log1p(-image[..., 3]) / 0.1
        self.assertAlmostEqual(depth.sum() * (5 / 64)**2, volume, delta=0.05 * volume)
        self.assertLess(depth.max(), 1.05 * 2 * np.sqrt(1.3**2 - 1), "as long as the longest chord through the shell")

    def test_one_cell_keeps_its_volume(self):
        """Kinds that VTK 9.2 does not divide into tetrahedra too."""
        for cell, volume in ((vtkQuadraticHexahedron(), 1), (vtkTriQuadraticHexahedron(), 1), (vtkBiQuadraticQuadraticHexahedron(), 1),
                             (vtkQuadraticLinearWedge(), 0.5), (vtkBiQuadraticQuadraticWedge(), 0.5)):
            kind = cell.GetCellType()
            points = np.reshape(cell.GetParametricCoords(), (-1, 3))
            mesh = meshes.grid(points, [(kind, range(len(points)))])
            meshes.add_array(mesh.GetCellData(), np.zeros(1))
            self.assertAlmostEqual(self.mass(mesh, scale=3), volume, delta=0.01 * volume, msg=str(kind))

    def test_grids_one_cell_thick_keep_their_volume(self):
        """Cells have the thickness that the grid says, images of one layer that of the other edges."""
        for blocks, spacing in (((6, 5, 1), (0.16, 0.2, 0.3)), ((6, 1, 1), (0.16, 0.2, 0.3)), ((1, 1, 1), (0.5, 0.6, 0.7))):
            grid = meshes.image(blocks, spacing)
            volume = np.prod(blocks) * np.prod(spacing)
            for data in (grid, structured_copy(grid)):
                meshes.add_array(data.GetCellData(), np.zeros(data.GetNumberOfCells()))
                self.assertAlmostEqual(self.mass(data, scale=2), volume, delta=0.01 * volume, msg=str(blocks))

    def test_grids_one_sample_thick_have_the_thickness_of_their_other_edges(self):
        for blocks, spacing, volume in (((6, 5, 0), (0.1, 0.2, 7), 6 * 5 * (0.1 * 0.2)**1.5), ((0, 5, 0), (1, 0.2, 3), 5 * 0.2**3),
                                        ((0, 0, 0), (1, 1, 1), 1.0)):
            grid = meshes.image(blocks, spacing)
            for data in (grid, structured_copy(grid)):
                meshes.add_array(data.GetPointData(), np.zeros(data.GetNumberOfPoints()))
                self.assertAlmostEqual(self.mass(data, scale=3, association="point"), volume, delta=0.01 * volume, msg=str(blocks))

    def mass(self, data, scale, association="cell"):
        """Extinction times volume of all splats, over the extinction."""
        image = self.draw(data, constant(1e-3), association, scale=scale)
        return -np.log1p(-image[..., 3]).sum() * (2 * scale / 64)**2 / 1e-3

    def test_cells_are_drawn_in_their_middle(self):
        """The light of a tetrahedron's splat is centred at the mean of its corners, not in the middle of its bounds."""
        mesh = meshes.tetrahedra(np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0)]), [(0, 1, 2, 3)])
        meshes.add_array(mesh.GetCellData(), np.zeros(1))
        alpha = self.draw(mesh, constant(1e-2), "cell", scale=1.2, direction=(0, 0, 1))[..., 3]
        at = 2.4 * (np.arange(64) + 0.5) / 64 - 1.2 + 0.5
        self.assertAlmostEqual((alpha.sum(axis=0) * at).sum() / alpha.sum(), 0.25, delta=1e-3)
        self.assertAlmostEqual((alpha.sum(axis=1) * at).sum() / alpha.sum(), 0.25, delta=1e-3)

    def test_sizes_by_an_array(self):
        points = np.array([(0.2, 0.5, 0.5), (0.7, 0.5, 0.5)])
        data = meshes.particles(points)
        meshes.add_array(data.GetPointData(), np.zeros(2))
        meshes.add_array(data.GetPointData(), np.array([0.1, 0.2]), "length")
        meshes.add_array(data.GetPointData(), np.array([0.001, 0.008]), "volume")
        meshes.add_array(data.GetPointData(), np.concatenate([np.diag([h] * 3).reshape(1, 9) for h in (0.1, 0.2)]), "shape")
        lengths = self.draw(data, configure=lambda m: m.SetCellSizeArrayName("length"))
        shapes = self.draw(data, configure=lambda m: m.SetShapeArrayName("shape"))
        volumes = self.draw(data, configure=lambda m: (m.SetCellSizeArrayName("volume"), m.CellSizeArrayHoldsVolumesOn()))
        self.assertGreater(lengths[..., 3].max(), 0.04)
        np.testing.assert_allclose(lengths, shapes, atol=1e-7)
        np.testing.assert_allclose(volumes, lengths, atol=1e-6)

    def test_samples_without_a_size_are_left_out(self):
        data = meshes.particles(np.array([(0.2, 0.5, 0.5), (0.7, 0.5, 0.5), (0.4, 0.4, 0.4), (0.3, 0.3, 0.3)]))
        meshes.add_array(data.GetPointData(), np.zeros(4))
        meshes.add_array(data.GetPointData(), np.array([0.1, -1, np.nan, 0]), "length")
        alone = meshes.particles(np.array([(0.2, 0.5, 0.5)]))
        meshes.add_array(alone.GetPointData(), np.zeros(1))
        warning = "3 points are not drawn because array 'length' is not positive or not finite there. Sizes must be positive."
        np.testing.assert_allclose(self.draw(data, configure=lambda m: m.SetCellSizeArrayName("length"), warnings=[warning]),
                                   self.draw(alone, configure=lambda m: m.SetCellSize(0.1)), atol=1e-6)

    def test_sizes_by_neighbours(self):
        even, _ = self.ripple(self.scattered(), lambda m: m.CellSizeFromNeighborsOn(), exact=1.4)
        one, _ = self.ripple(self.scattered(), exact=1.4)
        clustered, _ = self.ripple(self.scattered(clustered=True), lambda m: m.CellSizeFromNeighborsOn(), exact=1.4)
        one_clustered, _ = self.ripple(self.scattered(clustered=True), exact=1.4)
        print(f"  random points: deviation {100 * even:.1f} %, with one size {100 * one:.1f} %; "
              f"clustered {100 * clustered:.1f} and {100 * one_clustered:.1f} %")
        self.assertLess(even, one)
        self.assertLess(clustered, 0.5 * one_clustered)
        lattice = meshes.particles(meshes.Lattice(N).points)
        meshes.add_array(lattice.GetPointData(), np.zeros(lattice.GetNumberOfPoints()))
        self.check_flat("points of a lattice", lattice, 0.03, 0.02, configure=lambda m: m.CellSizeFromNeighborsOn(), exact=(N + 1) / N)

    def test_hidden_cells_do_not_count(self):
        """A longer cell beside it would lengthen the splats on the face between them."""
        lattice = meshes.Lattice((2, 1, 1))
        mesh = lattice.mesh("hexahedron", lambda p: p * np.where(p[:, :1] > 0.5, (4, 1, 1), (2, 1, 1)))
        meshes.add_array(mesh.GetPointData(), np.zeros(12))
        self.assertGreater(np.abs(self.draw(mesh) - self.draw(self.cube())).max(), 0.05)
        meshes.add_array(mesh.GetCellData(), np.array([0, 32], np.uint8), "vtkGhostType")
        meshes.add_array(mesh.GetPointData(), np.where(lattice.points[:, 0] > 0.5, 2, 0).astype(np.uint8), "vtkGhostType")
        np.testing.assert_allclose(self.draw(mesh), self.draw(self.cube()), atol=1e-6)

    def cube(self):
        return meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: 0 * p[:, 0])

    def test_cells_without_extent_are_nothing(self):
        """Filters that cut a mesh in its corners leave triangles whose corners are in one place or on one line, to rounding."""
        plane = meshes.Lattice((4, 4, 1)).points
        corners = plane[plane[:, 2] == 0]
        squares = [(i + 5 * j, i + 5 * j + 1, i + 5 * j + 6, i + 5 * j + 5) for i in range(4) for j in range(4)]
        tiny = [(7, 7, 8), (6, 7, 8), (25, 26, 27)]
        points = np.concatenate([corners, 0.4 + 1e-17 * np.eye(3)])
        for association in ("cell", "point"):
            pictures = []
            for polygons in (squares, squares + tiny):
                data = meshes.surface(points[:25] if polygons is squares else points, polygons)
                pictures.append(self.draw(meshes.with_field(data, lambda p: p[:, 0], association), association=association))
            self.assertGreater(pictures[0][..., 3].max(), 0.05)
            np.testing.assert_allclose(pictures[1], pictures[0], atol=1e-5, err_msg=association)


if __name__ == "__main__":
    unittest.main()
