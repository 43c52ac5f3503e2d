# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opacity and colour from two arrays, each of points or of cells, or of one colour: closed forms, and the reference."""
import itertools
import math
import unittest

import numpy as np
from nephoscope_testing import meshes, smoke
from nephoscope_testing.checks import FLOAT_TOLERANCE, ImageTestCase, mapper
from nephoscope_testing.compare import edge_mask
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.reference import opaque_distance
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkFiltersSources import vtkSphereSource

ONE_COLOR = [(0, 1, 0.5, 0.25)]
TWO_COLORS = [(0, 1, 0, 0.2), (1, 0, 1, 0.4)]
METHODS = ("Automatic", "Projection", "Rays")


def slab(layers=4):
    """The unit cube in layers; point and cell arrays of colour, 0 to 1 along z, and of density."""
    data = meshes.Lattice((1, 1, layers)).mesh("tetra")
    for association, attributes in (("point", data.GetPointData()), ("cell", data.GetCellData())):
        meshes.with_field(data, lambda p: np.round(p[:, 2] * layers - (association == "cell") * 0.5) / layers, association)
        z = meshes.vtk_to_numpy(attributes.GetArray("s"))
        attributes.GetArray("s").SetName(f"{association} colour")
        # A cell has its layer's mean: centres of tetrahedra lie anywhere within it.
        meshes.add_array(attributes, 0.2 + 0.6 * z, f"{association} density")
    return data


def slab_light(layers, color, density, transfer):
    """Front to back along z, by quadrature: colour and density are linear in each layer, or constant."""
    nodes, weights = (0.5 * (v + o) for v, o in zip(np.polynomial.legendre.leggauss(24), (1.0, 0.0)))
    through, light = 1.0, np.zeros(4)
    for i in range(layers):
        low, high = i / layers, (i + 1) / layers
        at = lambda kind, u: low + (high - low) * u if kind == "point" else np.full_like(u, low)
        rate = lambda u: transfer.extinction(0.2 + 0.6 * at(density, u))
        middle = lambda u: 0.5 * (rate(np.zeros(1)) + rate(u)) * u / layers  # linear: the mean over [0, u] is exact
        colors = transfer.color(at(color, nodes) if color else np.zeros_like(nodes))
        part = weights * rate(nodes) / layers * np.exp(-middle(nodes))
        light += through * np.array([*(part @ colors), 0])
        through *= math.exp(-float(middle(np.ones(1))[0]))
    return light + [0, 0, 0, 1 - through]


class Arrays(ImageTestCase):
    def draw(self, data, transfer, color, density, method, look, size=(64, 64), opaque=None):
        window = Window(size)
        scene, ours = window.add_scene(), mapper()
        getattr(ours, "SetMethodTo" + method)()
        ours.SetOpacityArrayName(f"{density} density")
        association = color or "point"
        scene.add_volume(ours, data, transfer, f"{association} colour", association)
        look(scene)
        if opaque:
            scene.add_opaque(opaque, (0, 0, 1))
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(ours.GetOrderIndependent(), color is None)
        return float_image(ours), scene

    def test_a_slab(self):
        layers = 4
        data = slab(layers)
        for color, density, method in itertools.product(("point", "cell", None), ("point", "cell"), METHODS):
            transfer = Transfer(TWO_COLORS if color else ONE_COLOR, [(0, 0), (1, 3)])
            expected = slab_light(layers, color, density, transfer)
            look = lambda s: s.look((0.5, 0.5, -5), (0.5, 0.5, 0.5), parallel_scale=1.0, near=0.5, far=20)
            image = self.draw(data, transfer, color, density, method, look)[0][17:47, 17:47]
            error = np.abs(image - expected).max()
            print(f"  colour of {color or 'one'}, density of {density}, {method}: error {error:.3g}")
            self.assertLessEqual(error, 2e-6, f"{color}, {density}, {method}: {image[15, 15]}, expected {expected}")

    def test_random_meshes(self):
        """Against the rays of the reference, with and without a sphere in the cells."""
        rng = np.random.default_rng(5)
        data = meshes.delaunay(rng, 30)
        for association, attributes, n in (("point", data.GetPointData(), data.GetNumberOfPoints()),
                                           ("cell", data.GetCellData(), data.GetNumberOfCells())):
            for name in ("colour", "density"):
                values = rng.uniform(0, 1, n)
                values[:2] = 0, 1
                meshes.add_array(attributes, values, f"{association} {name}")
        source = vtkSphereSource()
        source.SetCenter(0.1, 0.1, 0.2)
        source.SetRadius(0.35)
        source.Update()
        sphere = source.GetOutput()
        surface = meshes.triangles_of(sphere)
        for color, density, method, opaque in itertools.product(("point", "cell", None), ("point", "cell"), METHODS, (None, sphere)):
            transfer = Transfer(TWO_COLORS if color else ONE_COLOR, [(0, 0), (1, 5)])
            image, scene = self.draw(data, transfer, color, density, method, lambda s: s.look_at(data), (80, 80), opaque)
            view, association = scene.view(), color or "point"
            edges = smoke.polyhedra.from_dataset(data, f"{association} colour", association).drawn_edges()
            distance = None
            if opaque:
                distance = opaque_distance(surface, view)
                edges = np.concatenate([edges, np.stack([surface, np.roll(surface, 1, 1)], 2).reshape(-1, 2, 3)])
            expected = smoke.render(data, view, transfer, (f"{association} colour", association), (f"{density} density", density), distance)
            self.check_float(image, expected, f"random mesh, colour of {color or 'one'}, density of {density}, {method}",
                             FLOAT_TOLERANCE, edge_mask(edges, view))

    def test_hexahedra(self):
        """Cells that become several tetrahedra, each with the value of its cell."""
        data = meshes.Lattice((2, 2, 2)).mesh("hexahedron")
        rng = np.random.default_rng(6)
        meshes.add_array(data.GetCellData(), rng.permutation(np.linspace(0, 1, 8)), "cell density")
        meshes.add_array(data.GetPointData(), meshes.points_of(data)[:, 0], "point colour")
        for colors, method in itertools.product((TWO_COLORS, ONE_COLOR), METHODS):
            transfer = Transfer(colors, [(0, 0), (1, 3)])
            image, scene = self.draw(data, transfer, "point" if colors is TWO_COLORS else None, "cell", method,
                                     lambda s: s.look_at(data, parallel=True), (80, 80))
            view = scene.view()
            expected = smoke.render(data, view, transfer, ("point colour", "point"), ("cell density", "cell"))
            edges = smoke.polyhedra.from_dataset(data, "point colour", "point", True).drawn_edges()
            self.check_float(image, expected, f"hexahedra, {method}", FLOAT_TOLERANCE, edge_mask(edges, view))


if __name__ == "__main__":
    unittest.main(verbosity=2)
