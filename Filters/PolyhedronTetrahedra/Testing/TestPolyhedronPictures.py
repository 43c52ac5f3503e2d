# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of divided cells against rays through another division of the same shape, made without the filter."""
import itertools
import unittest

import numpy as np
from division import HAS_TETGEN, divide
from nephoscope_testing import dual_meshes, meshes, nonconvex, polyhedra
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import random_transfer

GRADIENT = np.array([0.7, -0.4, 0.55])


def field(low, high):
    """A linear function with values 0 to 1 between two corners of a box."""
    ends = np.array(list(itertools.product(*zip(low, high)))) @ GRADIENT
    return lambda p: (p @ GRADIENT - ends.min()) / np.ptp(ends)


def blocks(corners):
    """Unit cubes, as hexahedra, by their lower corners."""
    offsets = np.array(meshes.HEXAHEDRON)
    points = np.vstack([np.array(c, float) + offsets for c in corners])
    return meshes.grid(points, [(12, range(8 * i, 8 * i + 8)) for i in range(len(corners))])


class Pictures(ImageTestCase):
    def compare(self, label, data, expected, function, look=None, seed=1, size=(96, 96)):
        """Draws `data`; the rays go through the cells of `expected`. Both get the field."""
        for d in (data, expected):
            meshes.with_field(d, function)
        transfer = random_transfer(np.random.default_rng(seed), 5, max_extinction=1.5)
        window = Window(size)
        scene = window.add_scene()
        ours = mapper()
        volume = scene.add_volume(ours, data, transfer)
        scene.look_at(volume, **(look or {}))
        window.render()
        cells = polyhedra.from_dataset(expected)
        edges = np.concatenate([cells.drawn_edges(), polyhedra.from_dataset(data, decompose=True).drawn_edges()])
        cells.drawn_edges = lambda: edges
        return self.verify(scene, ours, cells, transfer, label)

    def shape(self, label, shape, parts, **options):
        points, faces, _ = shape
        function = field(points.min(axis=0), points.max(axis=0))
        divider, messages = divide(nonconvex.grid_of(points, [faces]))
        self.assertEqual(messages.all, [])
        self.compare(label, divider.GetOutput(), parts, function, **options)

    def test_l(self):
        self.shape("L", nonconvex.prism(nonconvex.L_POLYGON), blocks([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))

    def test_plus(self):
        arms = [(1, 1, 0), (0, 1, 0), (2, 1, 0), (1, 0, 0), (1, 2, 0)]
        self.shape("plus", nonconvex.prism(nonconvex.PLUS_POLYGON), blocks(arms), look=dict(direction=(0.1, 0.2, 1)))

    def test_schonhardt(self):
        """By hand: a cone from the middle."""
        points, faces, _ = nonconvex.schonhardt()
        points = np.vstack([points, points.mean(axis=0)])
        self.shape("Schonhardt", nonconvex.schonhardt(), meshes.tetrahedra(points, [(6, *f) for f in faces]))

    @unittest.skipUnless(HAS_TETGEN, "this build has no TetGen")
    def test_u_frame_and_cavity(self):
        """Along rays that leave these shapes no more than once, or see both parts in the order of their distance."""
        u = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (2, 1, 0)]
        self.shape("U", nonconvex.prism(nonconvex.U_POLYGON), blocks(u), look=dict(direction=(0.15, 0.1, 1)))
        ring = [(x, y, 0) for x in (-1.5, -0.5, 0.5) for y in (-1.5, -0.5, 0.5) if (x, y) != (-0.5, -0.5)]
        self.shape("frame", nonconvex.frame(), blocks(ring), look=dict(direction=(0.1, -0.12, 1)))
        self.shape("frame with bridges", nonconvex.frame(keyhole=True), blocks(ring), look=dict(direction=(0.1, -0.12, 1)))
        around = [c for c in itertools.product((-1.5, -0.5, 0.5), repeat=3) if c != (-0.5,) * 3]
        self.shape("cavity", nonconvex.hollow(), blocks(around), look=dict(direction=(1, 0.3, 0.2)))

    def test_without_the_filter_the_mapper_warns(self):
        points, faces, _ = nonconvex.prism(nonconvex.U_POLYGON)
        data = meshes.with_field(nonconvex.grid_of(points, [faces]), lambda p: p[:, 0])
        window = Window((32, 32))
        scene = window.add_scene()
        volume = scene.add_volume(mapper(), data, random_transfer(np.random.default_rng(1)))
        scene.look_at(volume)
        window.render()
        window.render()
        self.assertEqual(len(window.messages.warnings), 1, "once, and not once a frame")
        self.assertIn("vtkPolyhedronToTetrahedra", window.messages.warnings[0])

    def test_openfoam_like(self):
        """A linear field over the dual of a mesh is that over the mesh."""
        for seed in (1, 2):
            mesh, primal = dual_meshes.openfoam_like(np.random.default_rng(seed), 0.6, 0.2)
            divider, messages = divide(mesh.grid())
            self.assertEqual(messages.all, [])
            self.assertGreater(divider.GetNumberOfDividedCells(), 0)
            self.compare(f"OpenFOAM-like, seed {seed}", divider.GetOutput(), primal, field((-1,) * 3, (1,) * 3), seed=seed)

    def test_mpas_like(self):
        """A cap of the sphere, seen from above; any field, since the cells are drawn as the tetrahedra of the reference."""
        mesh = dual_meshes.mpas_like(2, 3, 0.12, keep=lambda c: c[2] > 0.75)
        rng = np.random.default_rng(3)
        divider, messages = divide(mesh.grid())
        self.assertEqual(messages.all, [])
        data = meshes.with_field(divider.GetOutput(), lambda p: rng.uniform(0, 1, len(p)))
        self.check(data, random_transfer(rng, 5, max_extinction=8), "MPAS-like", decompose=True,
                   look=dict(direction=(0.05, 0.1, 1), up=(1, 0, 0)))

    def test_mpas_like_with_a_linear_field(self):
        """Against the walls and layers as half-spaces of tetrahedra of the undivided mesh: the columns need no filter."""
        mesh = dual_meshes.mpas_like(2, 2, 0.12, keep=lambda c: c[2] > 0.75)
        data = meshes.with_field(mesh.grid(), field((-1,) * 3, (1, 1, 1.3)))
        self.check(data, random_transfer(np.random.default_rng(4), 5, max_extinction=8), "MPAS-like, undivided",
                   decompose=True, look=dict(direction=(0.05, 0.1, 1), up=(1, 0, 0)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
