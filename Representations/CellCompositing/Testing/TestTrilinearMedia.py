# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trilinear cells among several media keep the field that they have alone: against dense samples, and a medium in two parts against the whole."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from TestTrilinearCells import BENT, CLEAR_BELOW, COLOURS, RAMP, STEP, VIEWS, bent, smooth, steep, trilinear_field, unstructured, with_values
from TestTrilinearVoxels import FETCHED, other
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPlane

FUNCTIONS = dict(ramp=RAMP, clear_below=CLEAR_BELOW, fetched=FETCHED)


def grid(field, low=-0.5, high=0.5, blocks=6):
    return with_values(meshes.rectilinear([np.linspace(low, high, blocks + 1)] * 3), field)


def with_opacity(data, field=other):
    meshes.add_array(data.GetPointData(), field(meshes.points_of(data)).astype(np.float32), "o")
    return data


def part_of(transfer, share):
    return Transfer(transfer.colors, transfer.opacities * (1, share), transfer.unit_distance)


def each(method):
    return lambda _, mappers: [getattr(ours, method)() for ours in mappers]


class Media:
    def __init__(self, volumes, configure=None, association="point"):
        self.window = Window((40, 40))
        self.scene = self.window.add_scene()
        self.mappers = [mapper() for _ in volumes]
        for ours, (data, transfer) in zip(self.mappers, volumes):
            self.scene.add_volume(ours, data, transfer, association=association)
        if configure:
            configure(self.scene, self.mappers)

    def picture(self, view):
        position, focus, scale = VIEWS[view]
        away = np.subtract(position, focus)
        up = (0, 1, 0) if abs(away[1]) < 0.9 * np.linalg.norm(away) else (0, 0, 1)
        self.scene.camera.SetParallelProjection(scale is not None)
        self.scene.look(position, focus, up, 30, scale, near=1e-3, far=8)
        self.window.render()
        return float_image(self.mappers[0])


def dense(volumes, view, samples=1500):
    """Samples of all fields in the middles of as many parts of each ray: extinctions add, and so do emissions."""
    origins, directions, _, far = view.rays()
    step = np.minimum(far, 5) / samples
    t = step[:, None] * (np.arange(samples) + 0.5)
    places = (origins[:, None] + t[..., None] * directions[:, None]).reshape(-1, 3)
    depth, emission = np.zeros(len(places)), np.zeros((len(places), 3))
    for data, transfer in volumes:
        values, inside = trilinear_field(data)(places)
        extinction = np.where(inside, transfer.extinction(values), 0)
        depth += extinction
        emission += extinction[:, None] * transfer.color(values)
    color = np.divide(emission, depth[:, None], out=np.zeros_like(emission), where=depth[:, None] > 0).reshape(*t.shape, 3)
    depth = depth.reshape(t.shape) * step[:, None]
    before = np.cumsum(depth, axis=1) - depth
    weight = np.exp(-before) * -np.expm1(-depth)
    rgba = np.concatenate([np.einsum("ij,ijk->ik", weight, color), weight.sum(axis=1)[:, None]], axis=1)
    return rgba.reshape(view.height, view.width, 4)


class TrilinearMedia(unittest.TestCase):
    def check(self, image, expected, label, tolerance=STEP, most=0):
        """At most so many pixels differ by more."""
        self.assertGreater(expected[..., 3].max(), 0.05, label)
        error = np.abs(image - expected).max(axis=-1)
        beyond = int((error > tolerance).sum())
        print(f"  {label}: largest difference {error.max() * 255:.3f}/255, {beyond} pixels beyond", flush=True)
        self.assertLessEqual(beyond, most, f"{label}: {error.max()}")

    def check_parts(self, data, transfer, label, views=VIEWS, configure=None, association="point", tolerance=0.1 * STEP, most=0):
        """Each piece is integrated exactly, so that the same field in two parts differs by rounding alone."""
        whole = Media([(data, transfer)], configure, association)
        parts = Media([(data, part_of(transfer, share)) for share in (0.3, 0.7)], configure, association)
        for view in views:
            self.check(parts.picture(view), whole.picture(view), f"{label} {view}", tolerance, most)
        for drawn in (whole, parts):
            self.assertEqual(drawn.window.messages.all, [], label)
            self.assertEqual(drawn.window.gl_errors(), [], label)

    def test_two_images_against_dense_samples(self):
        second = grid(other, -0.2, 0.7, 5)
        for (name, transfer), field in zip(FUNCTIONS.items(), (smooth, steep, smooth)):
            pair = [(grid(field), transfer), (second, Transfer([(0, 0, 0, 1), (1, 0, 1, 1)], [(0, 0.2), (1, 1.3)], 0.5))]
            drawn = Media(pair)
            for view in ("far", "along_z", "inside", "on_a_point"):
                self.check(drawn.picture(view), dense(pair, drawn.scene.view()), f"two images {name} {view}", 2 * STEP)

    def test_parts_of_a_medium(self):
        for name, transfer in FUNCTIONS.items():
            for field in (smooth, steep):
                self.check_parts(grid(field), transfer, f"{name} {field.__name__}")

    def test_a_narrow_peak(self):
        spike = Transfer(COLOURS, [(0, 0), (0.4, 0), (0.42, 1), (0.44, 0), (1, 0)], unit_distance=0.02)
        self.check_parts(grid(steep), spike, "spike")

    def test_parts_with_an_opacity_array(self):
        for name, transfer in FUNCTIONS.items():
            self.check_parts(with_opacity(grid(steep)), transfer, f"opacity array {name}", ("far", "along_x", "in_a_plane", "inside"),
                             lambda _, mappers: [ours.SetOpacityArrayName("o") for ours in mappers])

    def test_parts_of_tetrahedra(self):
        self.check_parts(grid(steep), CLEAR_BELOW, "tetrahedra", configure=each("SetCellInterpolationToTetrahedra"))

    def test_parts_of_cell_arrays(self):
        data = with_values(grid(smooth), steep, "cell")
        data.GetPointData().Initialize()
        self.check_parts(data, CLEAR_BELOW, "cells", association="cell")

    def test_parts_with_blanked_cells(self):
        data = meshes.image((6,) * 3, (1 / 6,) * 3, (-0.5,) * 3)
        with_values(data, smooth)
        ghosts = np.where(np.random.default_rng(2).uniform(size=216) < 0.4, vtkDataSetAttributes.HIDDENCELL, 0).astype(np.uint8)
        meshes.add_array(data.GetCellData(), ghosts, vtkDataSetAttributes.GhostArrayName())
        self.check_parts(data, RAMP, "blanked")

    def test_parts_behind_clipping_planes(self):
        def clip(_, mappers):
            for ours in mappers:
                plane = vtkPlane()
                plane.SetOrigin(0.1, 0, 0.05)
                plane.SetNormal(0.3, -1, 0.4)
                ours.AddClippingPlane(plane)
        self.check_parts(grid(steep), RAMP, "clipped", [view for view in VIEWS if view != "on_a_face"], clip)  # from there nothing is left

    def test_parts_in_haze(self):
        def haze(scene, _):
            air = nephoscope.vtkHaze()
            air.SetProjectionToMap()
            air.SetBaseLevel(-1)
            air.SetScaleHeight(1)
            air.SetExtinction(0.3)
            nephoscope.vtkHaze.SetHaze(scene.renderer, air)
        self.check_parts(grid(steep), RAMP, "haze", ("far", "along_z", "inside"), haze, tolerance=0.5 * STEP)

    def check_trilinear(self, data, label, views=VIEWS, **options):
        self.check_parts(data, CLEAR_BELOW, label, views, each("SetCellInterpolationToTrilinear"), **options)

    def test_parts_of_trilinear_hexahedra(self):
        stretched = with_values(meshes.rectilinear([np.linspace(0, 1, 7)**1.3 - 0.5] * 3), steep)
        self.check_trilinear(stretched, "stretched grid")
        self.check_trilinear(unstructured(stretched), "unstructured hexahedra")
        # A ray that leaves through a boundary face that is not plane, and enters again, does so at the triangles of the face, not at its surface.
        self.check_trilinear(with_values(bent(), steep), "bent grid", [view for view in VIEWS if view not in ("along_x", "along_z")], tolerance=STEP, most=BENT)
        self.check_trilinear(meshes.with_field(meshes.Lattice(4).mesh("wedge"), lambda p: np.sin(5 * p).prod(axis=1)), "wedges", ("far", "along_x", "in_a_plane"))

    def test_trilinear_hexahedra_against_dense_samples(self):
        pair = [(with_values(meshes.rectilinear([np.linspace(0, 1, 7)**1.3 - 0.5] * 3), smooth), RAMP), (grid(other, -0.2, 0.7, 5), CLEAR_BELOW)]
        drawn = Media(pair, each("SetCellInterpolationToTrilinear"))
        for view in ("far", "along_z", "inside", "on_a_point"):
            self.check(drawn.picture(view), dense(pair, drawn.scene.view()), f"stretched grid and image {view}", 2 * STEP)

    def test_beside_another_medium(self):
        """The field among media of other kinds, of which hardly anything is seen, is that of the image alone."""
        faint = part_of(RAMP, 1e-6)
        others = [(meshes.with_field(meshes.Lattice(2).mesh(kind), lambda p: p[:, 0]), faint) for kind in ("tetra", "hexahedron")]
        for name, transfer in FUNCTIONS.items():
            alone, among = Media([(grid(steep), transfer)]), Media([(grid(steep), transfer), *others])
            for view in VIEWS:
                self.check(among.picture(view), alone.picture(view), f"among others {name} {view}", 0.1 * STEP)


if __name__ == "__main__":
    unittest.main()
