# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures whose value is known in closed form."""
import math
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer, constant

# A ray through the cube crosses up to six tetrahedra; each brings a few roundings of float (6e-8).
TOLERANCE = 2e-6
LINEAR = lambda rate0, rate1: Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, rate0), (1, rate1)])


class ClosedForms(ImageTestCase):
    def draw(self, data, transfer, position, focus, up=(0, 1, 0), scale=1.0, size=(64, 64), association="point", configure=None):
        window = Window(size)
        scene = window.add_scene()
        ours = mapper()
        scene.add_volume(ours, data, transfer, association=association)
        scene.look(position, focus, up, parallel_scale=scale, near=0.5, far=20)
        if configure:
            configure(ours)
        window.render()
        self.fail_on_messages(window)
        return float_image(ours)

    def cube(self, kind, transfer, side=-5.0):
        data = meshes.with_field(meshes.Lattice(1).mesh(kind), lambda p: p[:, 2])
        image = self.draw(data, transfer, (0.5, 0.5, side), (0.5, 0.5, 0.5))
        return image[17:47, 17:47]  # 32 pixels wide: the inner ones

    def check_all(self, image, value, label):
        error = np.abs(image - np.asarray(value)).max()
        print(f"  {label}: error {error:.3g}")
        self.assertLessEqual(error, TOLERANCE, f"{label}: got {image.reshape(-1, 4)[0]}, expected {value}")

    def test_unit_cube(self):
        for kind in ("hexahedron", "voxel", "wedge", "pyramid", "tetra"):
            self.check_all(self.cube(kind, constant()), [0.6321205588285577] * 4, f"unit cube, {kind}")

    def test_unit_cube_as_image_data(self):
        data = meshes.with_field(meshes.image((1, 1, 1)), lambda p: p[:, 2])
        image = self.draw(data, constant(), (0.5, 0.5, -5), (0.5, 0.5, 0.5))
        self.check_all(image[17:47, 17:47], [0.6321205588285577] * 4, "unit cube, image data")

    def test_ramp_from_both_sides(self):
        alpha = 1 - 0.223130160148
        for kind in ("hexahedron", "wedge", "tetra"):
            self.check_all(self.cube(kind, LINEAR(1, 2), -5), [0.338529198658] * 3 + [alpha], f"ramp, front thin, {kind}")
            self.check_all(self.cube(kind, LINEAR(1, 2), 6), [0.521731859065] * 3 + [alpha], f"ramp, front dense, {kind}")

    def test_ramp_in_many_cells(self):
        data = meshes.with_field(meshes.Lattice((1, 1, 8)).mesh("hexahedron"), lambda p: p[:, 2])
        image = self.draw(data, LINEAR(1, 2), (0.5, 0.5, -5), (0.5, 0.5, 0.5))
        self.check_all(image[17:47, 17:47], [0.338529198658] * 3 + [1 - 0.223130160148], "ramp in eight cells")

    def test_opacity_from_another_array(self):
        """Colour z, extinction o / 10: o is 10 everywhere, or 10 + 10 z."""
        transfer = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 0), (20, 2)])
        thin, ramp = [0.264241117657] * 3 + [0.632120558829], [0.338529198658] * 3 + [1 - 0.223130160148]
        for label, on_cells, values, expected in (("points", False, lambda z: 10 + 0 * z, thin), ("cells", True, None, thin),
                                                  ("points, ramp", False, lambda z: 10 + 10 * z, ramp)):
            data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron"), lambda p: p[:, 2])
            attributes = data.GetCellData() if on_cells else data.GetPointData()
            meshes.add_array(attributes, np.full(1, 10.0) if on_cells else values(meshes.points_of(data)[:, 2]), "o")
            image = self.draw(data, transfer, (0.5, 0.5, -5), (0.5, 0.5, 0.5),
                              configure=lambda ours: ours.SetOpacityArrayName("o"))
            self.check_all(image[17:47, 17:47], expected, f"opacity from another array, {label}")

    def corner(self, transfer, side, configure=None):
        """Corner tetrahedron of size 2; over (0.5, 0.5) a ray along z runs from z = 0 to z = 1."""
        data = meshes.tetrahedra([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)], [(0, 1, 2, 3)])
        meshes.with_field(data, lambda p: p[:, 2])
        # An odd number of pixels: the middle one's centre is the focal point.
        image = self.draw(data, transfer, (0.5, 0.5, side), (0.5, 0.5, 0), size=(33, 33), configure=configure)
        return image[16, 16]

    def test_weights_of_one_segment(self):
        for front, back, wf, wb in ((1, 1, .367879441171, .264241117657), (0, 2, .253175867188, .378944691641),
                                    (2, 0, .461920493087, .170200065741), (.5, 1.5, .313393512281, .318727046547),
                                    (1, 2, .438340641194, .338529198658), (2, 1, .521731859065, .255137980787),
                                    (10, 2, .888984175221, .108537072602), (2, 10, .727410862679, .270110385144),
                                    (0, .1, .016419614157, .0323509613422)):
            # Red is 1 at the front end, green 1 at the back end: red = wf, green = wb. The scalar is z = 0..1.
            for side in (-5, 6):
                ends = ((1, 0, 0), (0, 1, 0)) if side < 0 else ((0, 1, 0), (1, 0, 0))
                rates = (front, back) if side < 0 else (back, front)
                transfer = Transfer([(0, *ends[0]), (1, *ends[1])], [(0, rates[0]), (1, rates[1])])
                rgba = self.corner(transfer, side)
                self.check_all(rgba, [wf, wb, 0, -math.expm1(-(front + back) / 2)], f"weights ({front}, {back}) from {side}")

    def test_weights_of_nearly_equal_and_thin_segments(self):
        """Where 1 - exp(-x) and the erf forms lose their digits: relative error, both channels."""
        for depth in (1e-3, 1e-5, 1e-7):
            for ratio in (1.0, 1.0001, 2.0):
                front, back = depth, depth * ratio
                transfer = Transfer([(0, 1, 0, 0), (1, 0, 1, 0)], [(0, front), (1, back)])
                red, green, _, alpha = self.corner(transfer, -5)
                tf, tb = front, back
                exact = _weights(tf, tb)
                for got, want, name in ((red, exact[0], "wf"), (green, exact[1], "wb"), (alpha, -math.expm1(-(tf + tb) / 2), "alpha")):
                    self.assertLess(abs(got - want) / want, 1e-5, f"{name} of ({tf:g}, {tb:g}): got {got:.9g}, expected {want:.9g}")

    def test_average_rule(self):
        rgba = self.corner(LINEAR(1, 1), -5, lambda m: m.SetIntegrationToAverage())
        self.check_all(rgba, [0.316060279] * 3 + [0.6321205588], "average rule")
        rgba = self.corner(LINEAR(1, 1), -5)
        self.check_all(rgba, [0.264241117657] * 3 + [0.6321205588], "exact rule, same ray")

    def test_regular_tetrahedron(self):
        data = meshes.tetrahedra([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2, 3)])
        meshes.add_array(data.GetPointData(), np.arange(4.0))
        # Colour = scalar / 3: the thick vertex has 1.5 in front and behind.
        transfer = Transfer([(0, 0, 0, 0), (3, 1, 1, 1)], [(0, 1), (3, 1)])
        image = self.draw(data, transfer, (0, 0, 6), (0, 0, 0), size=(33, 33), scale=1.2)
        alpha = 0.8646647167633873
        self.check_all(image[16, 16], [0.5 * alpha] * 3 + [alpha], "regular tetrahedron along z")

    def test_corner_tetrahedron_along_its_edge(self):
        """Two vertices on one line of sight (class 4)."""
        data = meshes.tetrahedra([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)])
        meshes.with_field(data, lambda p: p[:, 2])
        image = self.draw(data, constant(), (0.0, 0.0, 6), (0, 0, 0), size=(64, 64))
        centers = (np.arange(64) + 0.5) / 32 - 1
        x, y = np.meshgrid(centers, centers)
        inside = (x > 0) & (y > 0) & (x + y < 0.99)
        error = np.abs(image[..., 3] + np.expm1(-(1 - x - y)))[inside].max()
        print(f"  corner tetrahedron: error {error:.3g} over {inside.sum()} pixels")
        self.assertLessEqual(error, TOLERANCE)
        self.assertEqual(np.abs(image[(x < 0) | (y < 0) | (x + y > 1.01)]).max(), 0, "nothing outside")

    def test_faint_layers(self):
        """Forty layers of alpha near .01 (8-bit targets lose .036), one colour."""
        data = meshes.with_field(meshes.Lattice((1, 1, 40)).mesh("hexahedron"), lambda p: p[:, 2])
        image = self.draw(data, constant(0.4, (1, 0.5, 0.25)), (0.5, 0.5, -5), (0.5, 0.5, 0.5))
        alpha = -math.expm1(-0.4)
        self.check_all(image[17:47, 17:47], [alpha, alpha / 2, alpha / 4, alpha], "forty faint layers")

    def test_perspective_length(self):
        """Cube side on, camera at distance: length inside = |ray| between two planes, off the sides."""
        data = meshes.with_field(meshes.Lattice(1).mesh("hexahedron", lambda p: (p - 0.5) * [8, 8, 1]), lambda p: p[:, 2] + 0.5)
        window = Window((64, 64))
        scene = window.add_scene()
        ours = mapper()
        scene.add_volume(ours, data, constant(0.7))
        scene.look((0, 0, 3), (0, 0, 0), angle=60, near=1, far=10)
        window.render()

        def alpha(right, up):
            x, y = (((np.arange(64) + 0.5 + shift) / 32 - 1) * math.tan(math.radians(30)) for shift in (right, up))
            return -np.expm1(-0.7 * np.sqrt(1 + y[:, None] ** 2 + x[None, :] ** 2))

        # Rays of the diagonals run in a face between two tetrahedra, from where they may be moved by 0.002 pixels (README).
        expected, diagonal = alpha(0, 0), np.eye(64, dtype=bool) | np.eye(64, dtype=bool)[::-1]
        allowed = diagonal * np.max([np.abs(alpha(*s) - expected) for s in ((0.002, 0), (-0.002, 0), (0, 0.002), (0, -0.002))], axis=0)
        error = (np.abs(float_image(ours)[..., 3] - expected) - allowed).max()
        print(f"  slab in perspective: error {error:.3g}")
        self.assertLessEqual(error, TOLERANCE)
        self.fail_on_messages(window)


def _weights(tf, tb):
    """wf and wb by all-positive quadrature in double."""
    x, w = np.polynomial.legendre.leggauss(20)
    t, w = (x + 1) / 2, w / 2
    density = w * (tf + (tb - tf) * t) * np.exp(-tf * t - (tb - tf) * t * t / 2)
    return (density * (1 - t)).sum(), (density * t).sum()


if __name__ == "__main__":
    unittest.main(verbosity=2)
