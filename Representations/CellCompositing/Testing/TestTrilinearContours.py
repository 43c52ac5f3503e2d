# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contour surfaces of evenly spaced grids, with nothing set, and of trilinear hexahedra are those of the field: as dense samples of it find them."""
import itertools
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import float_image
from nephoscope_testing.transfer import Transfer
from TestTrilinearCells import (COLOURS, RAMP, STEP, VIEWS, bent, dense, probed, rectilinear, smooth, steep, tapered, trilinear_field, unstructured,
                                with_values)
from TestTrilinearVoxels import ByDefault, grid, other

CLEAR = Transfer(COLOURS, [(0, 0), (1, 0)])
SURFACES = ((0.3, 0.4, (1, 0.2, 0.1)), (0.55, 0.6, (0.1, 1, 0.2)), (0.7, 0.3, (0.2, 0.3, 1)))
FAR = ("far", "along_z", "diagonal", "in_a_plane", "inside", "on_a_point", "on_a_face")


def add_surfaces(mapper, surfaces=SURFACES, lit=False):
    for i, (value, opacity, rgb) in enumerate(surfaces):
        mapper.SetContourValue(i, value)
        mapper.SetContourOpacity(i, opacity)
        mapper.SetContourColor(i, *rgb)
    mapper.SetContourLighting(lit)


class TrilinearContours(unittest.TestCase):
    def check(self, image, expected, label, most, tolerance=2 * STEP):
        """Samples miss surfaces that the ray crosses twice between two of them: `most` pixels."""
        wrong = np.abs(image - expected).max(axis=-1) > tolerance
        print(f"  {label}: {int(wrong.sum())} of {wrong.size} pixels differ by more than {tolerance * 255:.0f}/255", flush=True)
        self.assertLessEqual(int(wrong.sum()), most, label)

    def drawn(self, data, transfer, **settings):
        drawn = ByDefault(data, transfer, **settings)
        add_surfaces(drawn.mapper)
        return drawn

    def test_without_and_with_a_medium(self):
        for field, most in ((smooth, 3), (steep, 12)):
            data = grid(field)
            for transfer in (CLEAR, RAMP):
                drawn = self.drawn(data, transfer)
                seen = 0
                for name in FAR:
                    image = drawn.picture(VIEWS[name])
                    expected = dense(data, drawn.scene.view(), transfer, trilinear_field(data), 1700, surfaces=SURFACES)
                    self.check(image, expected, f"{field.__name__}, {'clear' if transfer is CLEAR else 'medium'}, {name}", most)
                    seen += int((expected[..., 3] > 0.2).sum())
                self.assertGreater(seen, 500)
                self.assertEqual(drawn.window.messages.all, [])

    def test_hexahedra(self):
        """With *CellInterpolation* Trilinear; the same however they are stored."""
        for name, data in (("rectilinear", rectilinear()), ("tapered", tapered()), ("bent", bent())):
            with_values(data, smooth)
            field = trilinear_field(data) if name == "rectilinear" else None
            for view in ("far", "diagonal", "inside"):
                expected = None
                for stored in (data, unstructured(data)):
                    drawn = self.drawn(stored, RAMP, interpolation="Trilinear")
                    image = drawn.picture(VIEWS[view])
                    if expected is None:
                        expected = dense(data, drawn.scene.view(), RAMP, field, 1600, surfaces=SURFACES)
                    self.check(image, expected, f"{name}, {stored.GetClassName()}, {view}", 4 if name == "bent" else 3)
                    self.assertEqual(drawn.window.messages.all, [])

    def test_another_array(self):
        for association in ("point", "cell"):
            data = with_values(grid(smooth), smooth)
            meshes.add_array(data.GetPointData(), other(meshes.points_of(data)).astype(np.float32), "t")
            meshes.add_array(data.GetCellData(), np.full(data.GetNumberOfCells(), 0.5), "s")
            drawn = self.drawn(data, RAMP, association=association)
            drawn.mapper.SetContourArrayName("t")
            for name in ("far", "inside"):
                image = drawn.picture(VIEWS[name])
                field = trilinear_field(data) if association == "point" else lambda p: (np.full(len(p), 0.5), np.abs(p).max(axis=1) <= 0.5)
                expected = dense(data, drawn.scene.view(), RAMP, field, 1700, surfaces=SURFACES, contoured=trilinear_field(data, "t"))
                self.check(image, expected, f"another array, {association}, {name}", 3)

    def check_another_array(self, data, field_of, label, association, most):
        meshes.add_array(data.GetCellData(), np.full(data.GetNumberOfCells(), 0.5), "s")
        for view in ("far", "diagonal", "inside"):
            expected = None
            for stored in (data, unstructured(data)):
                drawn = self.drawn(stored, RAMP, association=association, interpolation="Trilinear")
                drawn.mapper.SetContourArrayName("t")
                image = drawn.picture(VIEWS[view])
                if expected is None:
                    colour = field_of("s") if association == "point" else lambda p: (np.full(len(p), 0.5), field_of("t")(p)[1])
                    expected = dense(data, drawn.scene.view(), RAMP, colour, 2000, surfaces=SURFACES, contoured=field_of("t"))
                self.check(image, expected, f"{label} by {association}, {stored.GetClassName()}, {view}", most)
                self.assertEqual(drawn.window.messages.all, [])

    def test_another_array_in_hexahedra(self):
        """Coloured by points and by cells. A missing value takes the surfaces of the cells around it away, and nothing else."""
        for name, data, association, most in (("even", grid(smooth), "point", 3), ("missing", grid(smooth), "point", 3), ("tapered", tapered(), "cell", 3),
                                              ("bent", bent(), "point", 4)):
            with_values(data, smooth)
            values = other(meshes.points_of(data)).astype(np.float32)
            if name == "missing":
                values[len(values) // 2] = np.nan
            meshes.add_array(data.GetPointData(), values, "t")
            self.check_another_array(data, lambda array, d=data, n=name: trilinear_field(d, array) if n in ("even", "missing")
                                     else lambda p: probed(d, p, array), name, association, most)

    def test_an_opacity_array(self):
        data = grid(smooth)
        meshes.add_array(data.GetPointData(), other(meshes.points_of(data)).astype(np.float32), "o")
        drawn = self.drawn(data, RAMP, opacity="o")
        image = drawn.picture()
        expected = dense(data, drawn.scene.view(), RAMP, trilinear_field(data), 1700, trilinear_field(data, "o"), SURFACES)
        self.check(image, expected, "opacity array", 3)

    def test_normals(self):
        """The headlight on a sphere, whose normals are known: smooth ones, and those of the trilinear field of each cell."""
        data = grid(lambda p: np.linalg.norm(p, axis=1), 24)
        for (smooth_normals, tolerance), cells in itertools.product(((True, 0.02), (False, 0.06)), (data, unstructured(data))):
            drawn = ByDefault(cells, CLEAR, interpolation="Trilinear")
            add_surfaces(drawn.mapper, ((0.35, 1.0, (1, 1, 1)),), lit=True)
            drawn.mapper.SetSmoothContourNormals(smooth_normals)
            drawn.volume.GetProperty().SetAmbient(0)
            drawn.volume.GetProperty().SetDiffuse(1)
            drawn.volume.GetProperty().SetSpecular(0)
            drawn.scene.look((0, 0, 3), (0, 0, 0), (0, 1, 0), 30, 0.4, near=1, far=8)
            drawn.window.render()
            image = float_image(drawn.mapper)
            origins = drawn.scene.view().rays()[0]
            r = np.linalg.norm(origins[:, :2], axis=1).reshape(image.shape[:2])
            inside, outside = r < 0.33, r > 0.36
            self.assertGreater(int(inside.sum()), 200)
            expected = np.sqrt(np.clip(1 - (r / 0.35) ** 2, 0, 1))
            worst = np.abs(image[..., 0] - expected)[inside].max()
            print(f"  smooth normals {smooth_normals}: {worst:.3f}", flush=True)
            self.assertLessEqual(worst, tolerance)
            self.assertEqual(image[outside].max(), 0)

    def test_tetrahedra_are_asked_for(self):
        data = grid(steep)
        pictures = []
        for interpolation in (None, "Tetrahedra"):
            drawn = self.drawn(data, CLEAR, interpolation=interpolation)
            pictures.append(drawn.picture())
        self.assertGreater(np.abs(pictures[0] - pictures[1]).max(), 50 * STEP)


if __name__ == "__main__":
    unittest.main(verbosity=2)
