# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Six defects of VTK's projected-tetrahedra mapper: in the same scene ours holds to the reference and it does not.

Each test asserts both, so that it documents the defect as well; a VTK that mends one will fail here and tell.
"""
import subprocess
import sys
import unittest

import numpy as np
from nephoscope_testing import meshes, peers, reference
from nephoscope_testing.checks import ImageTestCase, cells_of
from nephoscope_testing.compare import Difference, edge_mask
from nephoscope_testing.transfer import Transfer, constant

TETRAHEDRON = ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
WHITE = [(0, 1, 1, 1), (1, 1, 1, 1)]


def one_tetrahedron(values=(0.5,) * 4, points=TETRAHEDRON):
    data = meshes.tetrahedra(points, [(0, 1, 2, 3)])
    meshes.add_array(data.GetPointData(), np.array(values, float))
    return data


class Defects(ImageTestCase):
    def compare(self, data, transfer, label, look, least, matrix=None, **options):
        """Ours within tolerance, the peer off by more than least. Returns the peer's picture and the reference's."""
        self.check(data, transfer, label, look=look, matrix=matrix, **options)
        scene = peers.draw(peers.projected_tetrahedra(), data, transfer, look, matrix=matrix, **options)
        cells, view = cells_of(data, matrix=matrix), scene.view()
        expected = reference.render(cells, view, transfer)[..., :3]
        picture = scene.rgb()
        difference = Difference(picture, expected, edge_mask(cells.boundary_edges(), view))
        print(f"  {label}: projected tetrahedra {difference}", flush=True)
        self.assertGreater(difference.maximum, least, f"{label}: the defect is gone from VTK")
        return picture, expected

    def test_1_opacity_at_the_thick_vertex(self):
        """Edges that cross in projection: opacity taken at the wrong parameter. Constant colour, linear extinction."""
        ramp = Transfer(WHITE, [(0, 0), (1, 1)])
        points = ((-1, 0, -0.5), (1, 0, -0.5), (0, -1.2, 0.5), (-0.1, 0.4, 0.5))
        look = lambda s: s.look((0, 0, 6), (0, 0, 0), parallel_scale=1.3, near=1, far=12)
        for values in ((0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 1, 0)):
            self.compare(one_tetrahedron(values, points), ramp, f"crossing edges, scalars {values}", look, 0.05)

    def test_2_scale_of_the_prop_in_perspective(self):
        """The peer reads beyond a table here and may crash, so it has a process of its own."""
        for scale in (3, 300):
            data, transfer, look, matrix = scaled_scene(scale)
            self.check(data, transfer, f"prop scale {scale}", look=look, matrix=matrix)
            run = subprocess.run([sys.executable, __file__, "--peer-at-scale", str(scale)], capture_output=True, text=True,
                                 timeout=60)
            print(f"  prop scale {scale}: projected tetrahedra ended with code {run.returncode} (negative: crashed) "
                  f"{run.stdout.strip()}")
            self.assertNotEqual(run.returncode, 0, "the defect is gone from VTK")

    def test_3_viewport_away_from_the_origin(self):
        look = lambda s: s.look((0, 0, 6), (0, 0, 0), angle=30, near=1, far=12)
        picture, expected = self.compare(one_tetrahedron(), constant(1.0), "viewport (0.5, 0, 1, 1)", look, 0.5,
                                         size=(192, 96), viewport=(0.5, 0, 1, 1))
        print(f"  viewport: projected tetrahedra drew {(picture > 0).any(axis=2).sum()} pixels of "
              f"{(expected > 0).any(axis=2).sum()}")

    def test_4_thin_media(self):
        """0.0035 per unit over 1000 units: alpha 0.97, lost in eight bits per vertex."""
        data = meshes.with_field(meshes.Lattice(1).mesh("tetra", lambda p: (p - 0.5) * 1000), lambda p: p[:, 2] * 0 + 0.5)
        look = lambda s: s.look((10, 20, 2500), (0, 0, 0), parallel_scale=700, near=1000, far=5000)
        picture, expected = self.compare(data, constant(0.0035), "thin medium", look, 0.5)
        print(f"  thin medium: projected tetrahedra {picture.max():.4f}, reference {expected.max():.4f}")

    def test_5_order_in_perspective(self):
        rng = np.random.default_rng(5)
        data = meshes.delaunay(rng, 60)
        meshes.with_field(data, lambda p: rng.uniform(0, 1, len(p)))
        transfer = Transfer([(0, 1, 0, 0), (1, 0, 0, 1)], [(0, 1), (1, 1)], unit_distance=0.25)
        look = lambda s: s.look((0.6, 0.5, 1.6), (0, 0, 0), angle=80, near=0.2, far=6)
        self.compare(data, transfer, "wide perspective", look, 0.05)

    def test_5_cells_behind_the_near_plane(self):
        look = lambda s: s.look((0.1, 0.1, 0.2), (0, 0.1, -1), angle=60, near=0.05, far=20)
        picture, expected = self.compare(one_tetrahedron(points=3 * np.array(TETRAHEDRON)), constant(0.5), "camera inside",
                                         look, 0.2)
        print(f"  camera inside: projected tetrahedra drew {(picture > 0).any(axis=2).sum()} pixels of "
              f"{(expected > 0).any(axis=2).sum()}")

    def test_6_transfer_function_between_the_vertices(self):
        tent = Transfer(WHITE, [(0, 0), (0.5, 1), (1, 0)], unit_distance=0.5)
        look = lambda s: s.look((1, 0.7, 6), (0, 0, 0), angle=30, near=1, far=12)
        self.compare(one_tetrahedron((0, 0, 1, 1)), tent, "tent between the vertices", look, 0.3)

    def test_6_cells_other_than_tetrahedra(self):
        for kind in ("hexahedron", "wedge", "voxel"):
            data = meshes.with_field(meshes.Lattice(1).mesh(kind, None if kind == "voxel" else meshes.projective(
                np.random.default_rng(6), 0.2)), lambda p: p[:, 2])
            look = lambda s: s.look_at(data)
            self.compare(data, constant(1.0), f"one block of kind {kind}", look, 0.3)


def scaled_scene(scale):
    """The same picture at every scale: camera, prop and extinction scaled together."""
    look = lambda s: s.look((0, 0, 10 * scale), (0, 0, 0), angle=30, near=2 * scale, far=20 * scale)
    return one_tetrahedron(), constant(0.3 / scale), look, np.diag([scale, scale, scale, 1.0])


def peer_at_scale(scale):
    """0 if the peer draws the scene right, 1 if wrong."""
    data, transfer, look, matrix = scaled_scene(scale)
    scene = peers.draw(peers.projected_tetrahedra(), data, transfer, look, matrix=matrix)
    expected = reference.render(cells_of(data, matrix=matrix), scene.view(), transfer)[..., :3]
    difference = Difference(scene.rgb(), expected)
    print(difference)
    return int(difference.maximum > 0.1)


if __name__ == "__main__":
    if "--peer-at-scale" in sys.argv:
        sys.exit(peer_at_scale(float(sys.argv[-1])))
    unittest.main(verbosity=2)
