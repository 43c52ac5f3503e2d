# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Unstructured hexahedra that are valid, but so warped that the tetrahedra into which they can be divided overlap.

Reference: a uniform medium in a cube, whose optical depth along z is 1 whatever the cells inside are.
"""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import mapper
from nephoscope_testing.messages import Messages
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

UNIFORM = Transfer([(0, 1, 1, 1), (1, 1, 1, 1)], [(0, 1), (1, 1)], unit_distance=1)
OPAQUE = 1 - np.exp(-1)


def cube(noise, blocks=6, alone=False):
    """From -0.5 to 0.5, with inner points moved at random; not `alone`: and a tetrahedron out of sight, so that hexahedra are not divided
    as those of a grid, which are less often inside out."""
    rng = np.random.default_rng(1)

    def moved(points):
        at = points - 0.5
        inner = np.all(np.abs(at) < 0.49, axis=1)
        at[inner] += rng.normal(0, noise, (inner.sum(), 3))
        return at

    append = vtkAppendFilter()
    append.AddInputData(meshes.structured((blocks,) * 3, moved))
    if not alone:
        append.AddInputData(meshes.grid(np.array([(9, 0, 0), (10, 0, 0), (9, 1, 0), (9, 0, 1)], float), [(10, [0, 1, 2, 3])]))
    append.Update()
    data = append.GetOutput()
    for name in ("s", "t"):
        meshes.add_array(data.GetPointData(), np.linspace(0, 1, data.GetNumberOfPoints()).astype(np.float32), name)
    return data


class Drawn:
    def __init__(self, data):
        self.window = Window((60, 60))
        self.scene = self.window.add_scene()
        self.mapper = mapper()
        self.mapper.SetMethodToRays()
        self.scene.add_volume(self.mapper, data, UNIFORM)
        self.scene.camera.SetParallelProjection(True)
        self.scene.look((0, 0, 3), (0, 0, 0), (0, 1, 0), 30, 0.4, near=1, far=5)

    def errors(self):
        """How far the opacity of each pixel is from that of the cube."""
        self.window.render()
        return np.abs(float_image(self.mapper)[..., 3] - OPAQUE)


def with_contour(ours, array=""):
    ours.SetNumberOfContourValues(1)
    ours.SetContourValue(0, 2.0)  # nowhere, and not told since it could not be seen anywhere
    ours.SetContourOpacity(0, 0.0)
    ours.SetContourArrayName(array)


def with_contour_of_another_array(ours):
    with_contour(ours, "t")


def with_layers(ours):
    with_contour(ours)
    ours.SetLayersFromContours(True)
    ours.SetLayerProperty(1, vtkVolumeProperty())  # of a layer that no cell is in


class TestWarpedCells(unittest.TestCase):
    def test_nothing_set(self):
        for noise in (0, 0.02, 0.025):
            with Messages() as messages:
                errors = Drawn(cube(noise)).errors()
            self.assertEqual(messages.all, [])
            self.assertLess(errors.max(), 1e-4, noise)

    def test_contours(self):
        """Contours are drawn in whole cells, too."""
        for add in (with_contour, with_contour_of_another_array):
            drawn = Drawn(cube(0.025))
            add(drawn.mapper)
            with Messages() as messages:
                errors = drawn.errors()
            self.assertEqual(messages.all, [])
            self.assertLess(errors.max(), 1e-4)

    def test_tetrahedra_say_so(self):
        """Where tetrahedra are needed, the picture is wrong, and a warning names the remedy."""
        for choose in (lambda ours: ours.SetCellInterpolationToTetrahedra(), with_layers):
            drawn = Drawn(cube(0.025))
            choose(drawn.mapper)
            with Messages() as messages:
                errors = drawn.errors()
            self.assertIn("overlap", "".join(messages.warnings))
            self.assertIn("CellInterpolation to Trilinear", "".join(messages.warnings))
            self.assertGreater(errors.max(), 0.01)

    def test_divided_as_a_grid(self):
        """The five tetrahedra of these hexahedra are not inside out where the six of a division by coordinates are."""
        for choose in (lambda ours: ours.SetCellInterpolationToTetrahedra(), with_contour):
            drawn = Drawn(cube(0.025, alone=True))
            choose(drawn.mapper)
            with Messages() as messages:
                errors = drawn.errors()
            self.assertEqual(messages.all, [])
            self.assertLess(errors.max(), 1e-4)

    def test_less_warped_cells(self):
        """Their faces are not plane, but no tetrahedron is inside out."""
        drawn = Drawn(cube(0.02))
        drawn.mapper.SetCellInterpolationToTetrahedra()
        with Messages() as messages:
            errors = drawn.errors()
        self.assertEqual(messages.all, [])
        self.assertLess(errors.max(), 1e-4)


if __name__ == "__main__":
    unittest.main()
