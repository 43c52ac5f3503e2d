# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Visibility order: rays are exact, also where the order of centroids is not and cells hide one another in a cycle; one colour needs none.
Projection in the topological order is exact where there are neither gaps nor cycles.

The meshes with a measured share of misplaced faces are those of a longitude-latitude shell, a warped lattice and a
Delaunay mesh. Every tetrahedron has a colour of its own, so that a wrong order shows.
"""
import itertools
import unittest
from collections import defaultdict

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, cells_of
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.offscreen import float_image
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource


def colours(rng, extinction):
    """Sixteen unrelated colours over [0, 1], one extinction."""
    at = np.linspace(0, 1, 16)
    return Transfer(np.column_stack([at, rng.uniform(0, 1, (16, 3))]), [(0, extinction), (1, extinction)])


def random_cells(data, rng):
    meshes.add_array(data.GetCellData(), rng.uniform(0, 1, data.GetNumberOfCells()))
    return data


def cyclic_ring(count=4, tilt=0.2):
    """Wedges in a ring, each interface tilted like a propeller blade: along z every wedge is in front of the next.
    Three tetrahedra each; 4 wedges, tilt 0.2: no two overlap, every face between two of them is one triangle."""
    points, cells = [], []
    for i in range(count):
        angle = 2 * np.pi * i / count
        points += [(0.3 * np.cos(angle), 0.3 * np.sin(angle), 0), (np.cos(angle + tilt), np.sin(angle + tilt), 1),
                   (np.cos(angle - tilt), np.sin(angle - tilt), -1)]
    for i in range(count):
        a = [3 * i + k for k in (0, 2, 1)]
        b = [3 * ((i + 1) % count) + k for k in (0, 2, 1)]
        cells += [(a[0], a[1], a[2], b[2]), (a[0], a[1], b[1], b[2]), (a[0], b[0], b[1], b[2])]
    return meshes.tetrahedra(points, cells)


def never_free(data, eye=None, direction=None):
    """Tetrahedra that no far-to-near list can reach, by removing what has nothing behind it (face neighbours only)."""
    points, tets, owners = meshes.points_of(data), [], defaultdict(list)
    for i in range(data.GetNumberOfCells()):
        ids = [data.GetCell(i).GetPointId(k) for k in range(4)]
        tets.append(ids)
        for face in itertools.combinations(sorted(ids), 3):
            owners[face].append(i)
    nearer, waiting = defaultdict(list), [0] * len(tets)
    for face, pair in owners.items():
        if len(pair) != 2:
            continue
        a, b, c = points[list(face)]
        normal = np.cross(b - a, c - a)
        other = points[[k for k in tets[pair[0]] if k not in face][0]]
        towards_eye = normal @ (eye - a) if direction is None else -normal @ direction
        if towards_eye == 0:
            continue
        near, far = pair if (normal @ (other - a)) * towards_eye > 0 else pair[::-1]
        nearer[far].append(near)
        waiting[near] += 1
    free, left = [i for i, n in enumerate(waiting) if n == 0], len(tets)
    while free:
        left -= 1
        for near in nearer[free.pop()]:
            waiting[near] -= 1
            if waiting[near] == 0:
                free.append(near)
    return left


class ExactOrder(ImageTestCase):
    def exact_against_centroid(self, data, transfer, label, look, opaque=None, least=0.01, size=(96, 96)):
        """Rays and the topological order: within tolerance. Centroid: visibly wrong, so the scene can tell them apart."""
        ours, window, scene, expected = self.check(data, transfer, label, "cell", look=look, opaque=opaque, size=size)
        self.assertEqual(ours.GetNumberOfTetrahedra(), data.GetNumberOfCells())
        rays = float_image(ours)
        cells, view = cells_of(data, "cell"), scene.view()
        mask = edge_mask(cells.drawn_edges(), view)
        if opaque:
            triangles = meshes.triangles_of(opaque[0])
            mask |= edge_mask(np.stack([triangles, np.roll(triangles, 1, 1)], 2).reshape(-1, 2, 3), view)
        ours.SetMethodToProjection()
        for order in ("Exact", "Centroid", "None"):
            getattr(ours, f"SetVisibilityOrderTo{order}")()
            window.render()
            error = Difference(float_image(ours), expected, mask)
            print(f"  {label}, projection, order {order}: {error}")
            self.assertEqual(ours.GetNumberOfRayLayers(), 0)
            self.assertEqual((ours.GetNumberOfVisibilityCycles(), ours.GetNumberOfBrokenRelations()), (0, 0))
            if order == "Exact":  # there are neither cycles nor gaps
                self.verify(scene, ours, cells, transfer, f"{label}, projection", opaque and (triangles, opaque[1]))
            else:
                self.assertGreater(error.maximum, least, f"{label}: order {order} must show its mistakes here")
        ours.SetMethodToAutomatic()
        ours.SetVisibilityOrderToExact()
        window.render()
        np.testing.assert_array_equal(float_image(ours), rays, label + ", rays again")

    def test_shell_around_a_planet(self):
        planet = vtkSphereSource()
        planet.SetRadius(1.02)
        planet.SetThetaResolution(32)
        planet.SetPhiResolution(24)
        planet.Update()
        for label, shape, extinction in (("shell 24x12x3", dict(), 5.0),
                                         ("thin shell", dict(longitudes=18, latitudes=9, layers=6, radii=(1, 1.1)), 20.0)):
            rng = np.random.default_rng(1)
            data = random_cells(meshes.shell(**shape), rng)
            self.exact_against_centroid(data, colours(rng, extinction), label,
                                        lambda s: s.look((3.2, 0.9, 1.1), up=(0, 0, 1), angle=42, near=1.5, far=6),
                                        (planet.GetOutput(), (0, 0, 1)))

    def test_warped_lattice(self):
        for amount in (0.03, 0.045):  # more would fold cells over
            rng = np.random.default_rng(2)
            lattice = meshes.Lattice(6)
            hull = np.abs(lattice.points - 0.5).max(axis=1) > 0.49
            moved = lambda p: p - 0.5 + np.where(hull[:, None], 0, rng.uniform(-amount, amount, p.shape))
            data = random_cells(lattice.mesh("tetra", moved), rng)
            self.exact_against_centroid(data, colours(rng, 4.0), f"warped lattice {amount}", dict(direction=(3.2, 0.9, 1.1)))

    def test_delaunay(self):
        for seed in (3, 4):
            rng = np.random.default_rng(seed)
            data = random_cells(meshes.delaunay(rng, 150), rng)
            for position in ((3.2, 0.9, 1.1), (0.3, 0.1, 0.0)):
                look = lambda s: s.look(position, (0, 0, -0.2), angle=40, near=0.05, far=8)
                self.exact_against_centroid(data, colours(rng, 3.0), f"delaunay seed {seed} from {position}", look)

    def test_anisotropic_delaunay_in_parallel(self):
        rng = np.random.default_rng(5)
        data = meshes.delaunay(rng, 120)
        data.SetPoints(meshes.vtk_points(meshes.points_of(data) * [1, 1, 0.1]))
        random_cells(data, rng)
        self.exact_against_centroid(data, colours(rng, 5.0), "flattened delaunay",
                                    dict(direction=(1, 0.5, 0.15), parallel=True))

    def test_order_follows_the_camera(self):
        """The cached order is renewed by camera, prop matrix and projection."""
        rng = np.random.default_rng(6)
        data, transfer = random_cells(meshes.delaunay(rng, 80), rng), colours(rng, 3.0)
        ours, window, scene, _ = self.check(data, transfer, "first view", "cell", configure=lambda m: m.SetMethodToProjection())
        volume = scene.renderer.GetVolumes().GetLastProp()
        for step in range(4):
            scene.camera.Azimuth(80)
            window.render()
            self.verify(scene, ours, cells_of(data, "cell"), transfer, f"after azimuth {80 * (step + 1)}")
        scene.camera.ParallelProjectionOn()
        window.render()
        self.verify(scene, ours, cells_of(data, "cell"), transfer, "switched to parallel")
        volume.RotateY(120)
        window.render()
        m = volume.GetMatrix()
        matrix = [[m.GetElement(i, j) for j in range(4)] for i in range(4)]
        self.verify(scene, ours, cells_of(data, "cell", matrix=matrix), transfer, "prop turned")


class Cycles(ImageTestCase):
    LOOKS = {"from above": dict(direction=(0, 0, 1), parallel=True, zoom=1.2),
             "from below": dict(direction=(0, 0, -1), parallel=True, zoom=1.2),
             "perspective": dict(direction=(0, 0, 1), angle=5, zoom=1.2)}

    def test_a_cycle_is_drawn_right(self):
        """By rays. Projection counts the members, and draws them in a wrong order."""
        rng = np.random.default_rng(7)
        data, transfer = random_cells(cyclic_ring(), rng), colours(rng, 3.0)
        for label, look in self.LOOKS.items():
            ours, window, scene, expected = self.check(data, transfer, f"ring {label}", "cell", look=look)
            self.assertEqual(ours.GetNumberOfVisibilityCycles(), 0, "rays have no order")
            view = scene.view()
            left = never_free(data, direction=view.forward) if view.parallel else never_free(data, eye=view.eye)
            self.assertEqual(left, data.GetNumberOfCells(), "the ring must be a cycle from here")
            mask = edge_mask(cells_of(data, "cell").drawn_edges(), view)
            ours.SetMethodToProjection()
            for order in ("Exact", "Centroid", "None"):
                getattr(ours, f"SetVisibilityOrderTo{order}")()
                window.render()
                counts = (ours.GetNumberOfVisibilityCycles(), ours.GetNumberOfCyclicTetrahedra())
                self.assertEqual(counts, (1, left) if order == "Exact" else (0, 0), label)
                self.assertEqual(ours.GetNumberOfBrokenRelations() > 0, order == "Exact")
                self.assertEqual(ours.GetNumberOfDrawnTetrahedra(), left)
                error = Difference(float_image(ours), expected, mask)
                print(f"  ring {label}, order {order}: {error}")
                self.assertGreater(error.maximum, 0.01, f"{label}: without cutting, it must be wrong here")

    def test_from_the_side_there_is_none(self):
        data = meshes.with_field(cyclic_ring(), lambda p: p[:, 0] * 0 + 0.5)
        drawn = self.check(data, constant(1.0), "ring from the side", look=dict(direction=(1, 0.3, 0.05)),
                           configure=lambda m: m.SetMethodToProjection())
        self.assertEqual(never_free(data, eye=drawn[2].view().eye), 0)
        self.assertEqual(drawn[0].GetNumberOfVisibilityCycles(), 0)

    def test_one_colour_needs_no_order(self):
        """Varying extinction, one colour: all orders give the reference, cycle or not."""
        transfer = Transfer([(0, 0.8, 0.5, 0.2), (1, 0.8, 0.5, 0.2)], [(0, 0.2), (0.5, 3), (1, 0.5)])
        rng = np.random.default_rng(8)
        for label, data, look in (("ring", cyclic_ring(), self.LOOKS["from above"]), ("delaunay", meshes.delaunay(rng, 80), {})):
            random_cells(data, rng)
            ours, window, scene, expected = self.check(data, transfer, label + ", one colour", "cell", look=look,
                                                       configure=lambda m: m.SetMethodToProjection())
            pictures = {"Exact": float_image(ours)}
            self.assertEqual(ours.GetNumberOfVisibilityCycles(), 0, "nothing is sorted")
            for order in ("Centroid", "None"):
                getattr(ours, f"SetVisibilityOrderTo{order}")()
                window.render()
                pictures[order] = float_image(ours)
                self.verify(scene, ours, cells_of(data, "cell"), transfer, f"{label}, one colour, {order}")
            self.check_float(pictures["None"], pictures["Centroid"], f"{label}, one colour, None against Centroid", 1e-6)
            np.testing.assert_array_equal(pictures["None"], pictures["Exact"], label)


class Counts(ImageTestCase):
    def test_transparent_cells_are_not_drawn(self):
        """Cells whose extinction is 0 everywhere are skipped; the picture is the reference's."""
        rng = np.random.default_rng(9)
        data = random_cells(meshes.delaunay(rng, 60), rng)
        transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 0), (0.5, 0), (1, 2)])
        drawn = self.check(data, transfer, "half transparent", "cell")
        opaque = int((vtk_to_numpy(data.GetCellData().GetArray("s")) > 0.5).sum())
        self.assertEqual(drawn[0].GetNumberOfTetrahedra(), data.GetNumberOfCells())
        self.assertLess(drawn[0].GetNumberOfDrawnTetrahedra(), data.GetNumberOfCells())
        self.assertGreaterEqual(drawn[0].GetNumberOfDrawnTetrahedra(), opaque)

    def test_a_peak_inside_a_cell_is_drawn(self):
        """Zero at every vertex, not zero between them: must not be skipped."""
        data = meshes.with_field(meshes.Lattice(1).mesh("tetra"), lambda p: p[:, 2])
        peak = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 0), (0.4, 0), (0.5, 8), (0.6, 0), (1, 0)])
        drawn = self.check(data, peak, "peak between the vertices")
        self.assertGreater(drawn[3].max(), 0.3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
