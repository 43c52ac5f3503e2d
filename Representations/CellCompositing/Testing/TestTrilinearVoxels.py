# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""With nothing set, evenly spaced grids are drawn with their trilinear field: as dense samples of it, with one array and with an opacity array."""
import itertools
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from TestTrilinearCells import CLEAR_BELOW, COLOURS, RAMP, STEP, VIEWS, Drawn, dense, even, smooth, steep, trilinear_field, unstructured, with_values

MANY = np.linspace(0, 1, 80)  # more nodes than are kept as uniforms, and too curved to be joined to few
FETCHED = Transfer(np.column_stack([MANY, MANY, 1 - MANY, 0.5 + 0.5 * np.sin(9 * MANY)]), np.column_stack([MANY, 0.5 + 0.5 * np.cos(7 * MANY)]), unit_distance=0.4)
FUNCTIONS = dict(ramp=RAMP, clear_below=CLEAR_BELOW, fetched=FETCHED,
                 spike=Transfer(COLOURS, [(0, 0), (0.4, 0), (0.42, 1), (0.44, 0), (1, 0)], unit_distance=0.02))


def grid(field, blocks=6):
    return with_values(meshes.rectilinear([np.linspace(-0.5, 0.5, blocks + 1)] * 3), field)


def other(p):
    return 0.5 + 0.25 * np.cos(4 * p[:, 0] - 2 * p[:, 2]) + 0.25 * np.sin(3 * p[:, 1] + 0.5)


class ByDefault(Drawn):
    def __init__(self, data, transfer=RAMP, opacity=None, association="point", interpolation=None):
        self.window = Window((24, 24))
        self.scene = self.window.add_scene()
        self.mapper = mapper()
        if interpolation:
            getattr(self.mapper, "SetCellInterpolationTo" + interpolation)()
        if opacity:
            self.mapper.SetOpacityArrayName(opacity)
        self.volume = self.scene.add_volume(self.mapper, data, transfer, association=association)


class TrilinearVoxels(unittest.TestCase):
    def check(self, image, expected, label, tolerance):
        self.assertGreater(expected[..., 3].max(), 0.05, label)
        error = np.abs(image - expected).max(axis=-1)
        print(f"  {label}: largest difference {error.max() * 255:.3f}/255", flush=True)
        self.assertLessEqual(error.max(), tolerance, label)

    def check_samples(self, drawn, transfer, opacity, name, view):
        """Pieces are linear to within 1/512 of the scalar's range, a tenth of the flanks of the spike: rays that graze it are inexact."""
        data, image = drawn.mapper.GetInputDataObject(0, 0), drawn.picture(VIEWS[view])
        field = trilinear_field(data, "o") if opacity else None
        expected = dense(data, drawn.scene.view(), transfer, trilinear_field(data), 700, field)
        self.check(image, expected, f"{name} {view}", (1 if name == "spike" else 2 * STEP))
        if name == "spike":
            error = np.percentile(np.abs(image - expected).max(axis=-1), 98)
            print(f"    98 %: {error * 255:.2f}/255", flush=True)
            self.assertLessEqual(error, 8 * STEP)
        return expected

    def test_one_array(self):
        for name, transfer in FUNCTIONS.items():
            drawn = ByDefault(grid(smooth), transfer)
            for view in ("far",) if name == "spike" else ("far", "along_z", "inside", "on_a_point"):
                self.check_samples(drawn, transfer, False, name, view)

    def test_an_opacity_array(self):
        for field, (name, transfer) in itertools.product((other, steep), FUNCTIONS.items()):
            data = grid(smooth)
            meshes.add_array(data.GetPointData(), field(meshes.points_of(data)).astype(np.float32), "o")
            drawn = ByDefault(data, transfer, "o")
            for view in ("far",) if name == "spike" else ("far", "inside"):
                self.check_samples(drawn, transfer, True, name, view)
            self.assertEqual(drawn.window.messages.all, [])

    def test_tetrahedra_are_further_from_the_field(self):
        data = grid(smooth)
        meshes.add_array(data.GetPointData(), steep(meshes.points_of(data)).astype(np.float32), "o")
        drawn = ByDefault(data, RAMP, "o", interpolation="Tetrahedra")
        image = drawn.picture()
        expected = dense(data, drawn.scene.view(), RAMP, trilinear_field(data), 700, trilinear_field(data, "o"))
        self.assertGreater(np.abs(image - expected).max(), 5 * STEP)

    def test_the_same_array_twice(self):
        data = grid(steep)
        meshes.add_array(data.GetPointData(), steep(meshes.points_of(data)).astype(np.float32), "o")
        for name, transfer in FUNCTIONS.items():
            pair = ByDefault(data, transfer), ByDefault(data, transfer, "o")
            joined = name == "fetched"  # colours of many nodes are joined, which may change them by half a step
            for view, place in VIEWS.items():
                self.check(pair[1].picture(place), pair[0].picture(place), f"{name} {view}", (0.6 if joined else 0.1) * STEP)

    def test_nodes_of_two_arrays_in_one_place(self):
        """Colour and opacity come to nodes at once, all along a ray, in cells of all forms."""
        data, some = grid(steep), np.linspace(0, 1, 24)
        meshes.add_array(data.GetPointData(), steep(meshes.points_of(data)).astype(np.float32), "o")
        transfer = Transfer(np.column_stack([some, some, 1 - some, 0.5 + 0.5 * np.sin(9 * some)]), np.column_stack([some, 0.5 + 0.5 * np.cos(7 * some)]), unit_distance=0.4)
        for label, cells, kind in (("voxels", data, None), ("hexahedra", unstructured(data), None), ("tetrahedra", unstructured(data), "Tetrahedra")):
            one, two = (ByDefault(cells, transfer, opacity, interpolation=kind).picture() for opacity in (None, "o"))
            self.check(two, one, label, 0.6 * STEP)

    def test_cell_arrays(self):
        data = with_values(grid(smooth), steep, "cell")
        meshes.add_array(data.GetCellData(), np.random.default_rng(8).uniform(0, 1, data.GetNumberOfCells()), "o")
        data.GetPointData().Initialize()
        for name in ("ramp", "clear_below", "fetched"):
            pair = [ByDefault(data, FUNCTIONS[name], "o", "cell", kind) for kind in (None, "Tetrahedra")]
            for view, place in VIEWS.items():
                self.check(pair[0].picture(place), pair[1].picture(place), f"cells {name} {view}", STEP)

    def test_values_that_change(self):
        data = grid(smooth)
        meshes.add_array(data.GetPointData(), other(meshes.points_of(data)).astype(np.float32), "o")
        drawn = ByDefault(data, RAMP, "o")
        before = drawn.picture()
        meshes.vtk_to_numpy(data.GetPointData().GetArray("o"))[:] = 1 - other(meshes.points_of(data))
        data.GetPointData().GetArray("o").Modified()
        data.Modified()
        after = drawn.picture()
        self.assertGreater(np.abs(after - before).max(), 10 * STEP)
        self.check(after, dense(data, drawn.scene.view(), RAMP, trilinear_field(data), 700, trilinear_field(data, "o")), "changed", 2 * STEP)

    def test_not_as_tetrahedra(self):
        one, cut = (ByDefault(with_values(even(), steep), CLEAR_BELOW, interpolation=kind).picture() for kind in (None, "Tetrahedra"))
        self.assertGreater(np.abs(one - cut).max(), 5 * STEP)


if __name__ == "__main__":
    unittest.main()
