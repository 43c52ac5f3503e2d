# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes and surfaces against closed forms, the chain of VTK's clip filters and vtkContourFilter."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.meshes import Lattice
from split_checks import Cells, split
from split_meshes import centred, wavy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet, vtkTableBasedClipDataSet
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

VALUES = [-0.5, 0.1, 0.3, 0.9]


def measure(data, name="Volume"):
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(data)
    sizes.Update()
    return vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray(name))


def clipped(make, data, values):
    """Volume of each layer by a chain of clip filters."""
    volumes = []
    for below, above in zip([None] + values, values + [None]):
        part = data
        for value, inside_out in ((below, False), (above, True)):
            if value is not None:
                clip = make()
                clip.SetInputData(part)
                clip.SetInputArrayToProcess(0, 0, 0, 0, "s")
                clip.SetValue(value)
                clip.SetInsideOut(inside_out)
                clip.Update()
                part = clip.GetOutput()
        volumes.append(np.abs(measure(part)).sum())
    return np.array(volumes)


def layer_volumes(out, count):
    solid = out.solid
    return np.bincount(out.array("Layer")[solid], np.abs(out.volumes()[solid]), minlength=count)


def contour(data, value):
    """Polygons of vtkContourFilter as triangles (n, 3, 3)."""
    made = vtkContourFilter()
    made.SetInputData(data)
    made.SetInputArrayToProcess(0, 0, 0, 0, "s")
    made.SetValue(0, value)
    made.Update()
    return meshes.triangles_of(made.GetOutput())


def area(triangles):
    a, b, c = np.moveaxis(np.asarray(triangles), 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def surface(out, index=None):
    """Triangles of the polygons of one value, quadrilaterals halved."""
    chosen = np.flatnonzero(~out.solid & ((out.array("ContourIndex") == index) if index is not None else True))
    return np.array([out.points[[out.ids[i][0], out.ids[i][k], out.ids[i][k + 1]]]
                     for i in chosen for k in range(1, len(out.ids[i]) - 1)])


def ball(blocks, value=0.64, kind="hexahedron"):
    return meshes.with_field(Lattice(blocks).mesh(kind, centred), lambda p: (p ** 2).sum(axis=1)), value


class Volumes(unittest.TestCase):
    def test_layers_of_tetrahedra_are_those_of_the_clip_filters(self):
        """In a tetrahedron the cut is a plane, whoever makes it."""
        for data in (meshes.delaunay(np.random.default_rng(3), 80), Lattice(3).mesh("tetra", centred)):
            meshes.with_field(data, wavy)
            ours = layer_volumes(Cells(split(data, VALUES)), len(VALUES) + 1)
            for make in (vtkClipDataSet, vtkTableBasedClipDataSet):
                theirs = clipped(make, data, VALUES)
                print(f"  {make.__name__}: largest difference of a layer {np.abs(ours - theirs).max() / theirs.sum():.1e}")
                np.testing.assert_allclose(ours, theirs, rtol=0, atol=3e-8 * theirs.sum())  # the peers' points are float

    def test_linear_field_in_hexahedra(self):
        """Planes in a cube: the volumes in closed form."""
        for kind in ("hexahedron", "wedge", "pyramid"):
            data = meshes.with_field(Lattice(3).mesh(kind), lambda p: p[:, 0] + 2 * p[:, 1])
            ours = layer_volumes(Cells(split(data, [0.3, 1.0, 2.2])), 4)
            to = [v * v / 4 if v <= 1 else (v - 0.5) / 2 if v <= 2 else 1 - (3 - v) ** 2 / 4 for v in (0.3, 1.0, 2.2)]
            np.testing.assert_allclose(ours, np.diff([0, *to, 1]), atol=1e-14)

    def test_ball_converges_quadratically(self):
        errors = []
        for blocks in (8, 16, 32):
            data, value = ball(blocks)
            out = split(data, [value])
            volume = measure(out)[vtk_to_numpy(out.GetCellData().GetArray("Layer")) == 0].sum()
            errors.append((abs(volume / (4 / 3 * np.pi * value ** 1.5) - 1), abs(measure(out, "Area").sum() / (4 * np.pi * value) - 1)))
        print("  relative errors of volume and area:", errors)
        for fine, coarse in zip(errors[1:], errors):
            self.assertGreater(np.log2(coarse[0] / fine[0]), 1.8)
            self.assertGreater(np.log2(coarse[1] / fine[1]), 1.8)


class Surfaces(unittest.TestCase):
    def test_tetrahedra_have_the_surfaces_of_the_contour_filter(self):
        data = meshes.with_field(meshes.delaunay(np.random.default_rng(4), 80), wavy)
        out = Cells(split(data, VALUES))
        for index, value in enumerate(VALUES):
            ours, theirs = surface(out, index), contour(data, value)
            self.assertLess(abs(area(ours) / area(theirs) - 1), 1e-6)
            found, expected = (np.unique(np.round(t.reshape(-1, 3), 5), axis=0) for t in (ours, theirs))
            self.assertLess(abs(len(found) - len(expected)), 4)  # rounding may part neighbours
            far = np.linalg.norm(expected[:, None] - found[None], axis=2).min(axis=1).max()
            self.assertLess(far, 3e-5)

    def test_surface_of_a_ball_is_closed_and_faces_outward(self):
        data, value = ball(8)
        out = Cells(split(data, [value]))
        triangles = surface(out)
        volume = np.einsum("ni,ni->n", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum() / 6
        self.assertAlmostEqual(volume, layer_volumes(out, 2)[0], places=13)
        edges = {}
        for i in np.flatnonzero(~out.solid):
            for a, b in zip(out.ids[i], out.ids[i][1:] + out.ids[i][:1]):
                edges[a, b] = edges.get((a, b), 0) + 1
        self.assertTrue(all(n == 1 and edges.get((b, a)) == 1 for (a, b), n in edges.items()), "the surface has an edge or turns")

    def test_a_value_on_a_layer_of_vertices(self):
        """No cell is crossed; the surface consists of faces, once each, as the contour filter has them."""
        for kind in ("tetra", "hexahedron", "wedge", "pyramid", "voxel"):
            data = meshes.with_field(Lattice(4).mesh(kind), lambda p: p[:, 2])
            out = Cells(split(data, [0.5]))
            self.assertEqual(len(out.points), data.GetNumberOfPoints() if kind != "pyramid" else len(out.points))
            self.assertAlmostEqual(area(surface(out)), 1, places=12)
            self.assertAlmostEqual(area(contour(data, 0.5)), 1, places=6)
            a, b, c = np.moveaxis(surface(out), 1, 0)
            self.assertTrue((np.cross(b - a, c - a)[:, 2] > 0).all())

    def test_clear_air_has_a_surface(self):
        """Zero in one half, rising in the other; the value 0 parts them."""
        data = meshes.with_field(Lattice(4).mesh("hexahedron"), lambda p: np.maximum(p[:, 0] - 0.5, 0))
        out = Cells(split(data, [0.0]))
        self.assertAlmostEqual(area(surface(out)), 1, places=12)
        middle = np.array([out.points[i][:, 0].mean() for i in out.ids])
        np.testing.assert_array_equal(out.array("Layer")[out.solid], middle[out.solid] > 0.5)

    def test_a_sheet_of_least_scalars_is_there_once(self):
        for kind in ("tetra", "hexahedron"):
            data = meshes.with_field(Lattice(4).mesh(kind), lambda p: np.abs(p[:, 0] - 0.5))
            self.assertAlmostEqual(area(surface(Cells(split(data, [0.0])))), 1, places=12)
            self.assertEqual(len(surface(Cells(split(data, [0.5])))), 0)


if __name__ == "__main__":
    unittest.main()
